// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/increment.hpp"
#include "brinell/simulation/kinematics.hpp"
#include "brinell/simulation/tugging.hpp"

namespace brinell::simulation
{

/// The contact grid at one position.
struct Frame
{
  Position position;
  elastoplastic::Placement placement; ///< on the material grids
  double x0 = 0.0;                    ///< local x' of contact column 0 [m]
  double lower_origin = 0.0;          ///< surface coordinate of column 0 of the lower material grid [m]
  double upper_origin = 0.0;          ///< the same for the upper one [m]
};

/// All fields of the present state.
[[nodiscard]] Snapshot snapshot(const elastoplastic::CoupledContact& pair, const Frame& frame,
                                const StepRecord& record);

} // namespace brinell::simulation
