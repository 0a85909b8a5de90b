// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/device.hpp"
#include "brinell/elastoplastic/settings.hpp"

#include <functional>
#include <memory>
#include <string_view>

/// Devices that bodies can be put on. This library has none but the processor itself; a program that is linked with CUDA offers one.
namespace brinell::device
{

using Opening = std::function<std::shared_ptr<const elastoplastic::Device>()>;

/// To be called once, before anything is computed. @param open  throws DeviceError where there is no GPU, or one that does not suit
void offer_cuda(Opening open);
[[nodiscard]] bool has_cuda();

/// "cpu", "cuda", "auto" or "host".
[[nodiscard]] std::string_view name_of(elastoplastic::DeviceChoice choice);

/// Opens the device that is chosen; nullptr: the processor, which is what `automatic` finds without a GPU.
/// @throws InputError if this program has no CUDA, DeviceError
[[nodiscard]] std::shared_ptr<const elastoplastic::Device> opened(elastoplastic::DeviceChoice choice);

} // namespace brinell::device
