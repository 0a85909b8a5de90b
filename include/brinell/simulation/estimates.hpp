// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

#include <optional>

/// Estimates for a run before it is computed.
namespace brinell::simulation
{

/// Properties of a scenario on which the run time depends most.
struct Work
{
  double evaluations = 6.0;           ///< evaluations per step, roughly
  bool yields_along_the_track = true; ///< false: material yields mostly under the present contact only
  double states_within = 0.0;         ///< number of states whose stress within the bodies is computed for the output
  double stored_bytes = 0.0;          ///< of all stored fields before compression
};

/// Run time on one core [s], from measured runs: time per cell of the yielding bodies and per evaluation, growing as N log N.
/// Heated bodies count as some further evaluations; if no body yields only the contact is solved. The time to compute and write
/// the stored fields is included. Accurate to a factor of three.
[[nodiscard]] double rough_seconds(const Plan& plan, const constitutive::Material& lower,
                                   const constitutive::Material& upper, const Work& work);

/// Load at which an elastic contact has a given peak pressure [N], for an elliptical contact or a line of finite length (Hertz;
/// Johnson 1985, sections 4.2 and 4.3); empty for other contacts.
/// @param contact_modulus, peak_pressure  [Pa]
[[nodiscard]] std::optional<double> load_of_peak_pressure(const Shape& lower, const Shape& upper, const Domain& domain,
                                                          double contact_modulus, double peak_pressure);

} // namespace brinell::simulation
