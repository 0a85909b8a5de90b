// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/device.hpp"
#include "brinell/simulation/scenario.hpp"

#include <memory>
#include <string>

namespace brinell::simulation
{

/// Reason why a device cannot compute a pair of bodies; empty if it can.
[[nodiscard]] std::string reason_against_device(const constitutive::Material& lower,
                                                const constitutive::Material& upper, bool have_inclusions);
/// @throws PlanError if a device is demanded that cannot compute the case
void check_device(const PairCase& c);

/// The device of a pair of bodies; nullptr: the processor.
/// @param is_shared  by ranks
/// @throws DeviceError, InputError
[[nodiscard]] std::shared_ptr<const elastoplastic::Device> device_of(elastoplastic::DeviceChoice choice,
                                                                     const constitutive::Material& lower,
                                                                     const constitutive::Material& upper,
                                                                     bool have_inclusions, bool is_shared);

} // namespace brinell::simulation
