// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/increment.hpp"

namespace brinell::simulation
{

/// A contact that begins to slide, when friction has been raised at rest.
struct Onset
{
  double load = 0.0;     ///< [N]
  double approach = 0.0; ///< [m]
  double shear = 0.0;    ///< force of the shear along x [N]
  double work = 0.0;     ///< of the load since the end of the last step [J], by the trapezoidal rule
};

/// @param load_before, approach_before  at the end of the last step
[[nodiscard]] inline Onset onset(const elastoplastic::CoupledContact& pair, double load_before, double approach_before)
{
  const double load = pair.load(), approach = pair.approach();
  return {load, approach, pair.sliding()->force(), 0.5 * (load + load_before) * (approach - approach_before)};
}

} // namespace brinell::simulation
