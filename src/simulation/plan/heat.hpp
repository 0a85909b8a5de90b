// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

#include <optional>
#include <string>

namespace brinell::simulation
{

/// Whether heat is computed: there is friction or a heat source, and at least one body has thermal constants.
[[nodiscard]] bool is_heated(const PairCase& c);

/// Checks that the bulk temperature of a body is below its melting temperature.
/// @param name  of the body
/// @throws PlanError
void require_solid(const char* name, const constitutive::Material& material);

/// Motion of heated bodies.
struct HeatedMotion
{
  std::optional<double> speed; ///< speed or frequency, see `unit`
  std::string speed_name;      ///< as messages give it: "`RollingCase::speed`"
  bool upper_rests =
      false;           ///< the upper body does not move relative to the contact: its heat always enters at one place
  bool sticks = false; ///< the surfaces may stick in places
  const char* name = "speed";
  const char* unit = "m/s";
};

/// Checks the input of heat: it needs a speed or a frequency, and thermal constants of every body that deforms.
/// @throws PlanError
void require_heat(const PairCase& c, const HeatedMotion& motion);

/// Checks that a heat source on one body fits on the contact grid of a plan, and into its periods.
/// @throws PlanError
void require_source_fits(const Numerics& numerics, const SurfaceGrid& contact);

/// Checks that both surfaces have stayed below the melting temperatures of their softening.
/// @param where  the step, for the message
/// @throws InputError
void require_below_melting(const std::string& where, const HeatedRecord& step, const constitutive::Material& lower,
                           const constitutive::Material& upper);

/// Whether equal bodies get equal shares of the heat.
[[nodiscard]] bool shares_alike(const Numerics& numerics);

} // namespace brinell::simulation
