// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

#include <optional>

/// What can be told of a run before it is computed.
namespace brinell::simulation
{

/// How most of the work of a run is spread.
struct Work
{
  double evaluations = 6.0;           ///< in a step, roughly
  bool yields_along_the_track = true; ///< else, for the most part, only under the contact
};

/// Seconds on one core, from measured runs: time per cell of the bodies that yield, per evaluation, growing as N log N. Bodies that are
/// heated count for some evaluations more, and where none yields only the contact is solved. Good to a factor of three.
[[nodiscard]] double rough_seconds(const Plan& plan, const constitutive::Material& lower,
                                   const constitutive::Material& upper, const Work& work);

/// Bytes of the fields of one state: pressure and gap; of each body that deforms the tensors of stress and plastic strain, their
/// equivalents, and the surface.
[[nodiscard]] double state_bytes(const Plan& plan, const constitutive::Material& lower,
                                 const constitutive::Material& upper);

/// Load whose elastic contact has that peak pressure [N], of an ellipse or of a line of finite length (Hertz; Johnson 1985, sections
/// 4.2 and 4.3); empty for other contacts.
/// @param contact_modulus, peak_pressure  [Pa]
[[nodiscard]] std::optional<double> load_of_peak_pressure(const Shape& lower, const Shape& upper, const Domain& domain,
                                                          double contact_modulus, double peak_pressure);

} // namespace brinell::simulation
