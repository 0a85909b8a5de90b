// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

#include <functional>
#include <string>

/// Parts of a plan that all scenarios have once their grids are laid out.
namespace brinell::simulation
{

/// Checks the grids of a plan against bodies and heat source, and sets the reference of its displacements.
/// @throws PlanError
void check_grids(const PairCase& c, Plan& plan);

/// Ends a plan whose grids, steps, twin and symmetry are known: times of heat, textures, inclusions, memory.
/// @param sticks  whether the surfaces may stick in places, so that the shear has two components
/// @param heat_times  of the motion; called where there is heat
/// @param beside  y of the contact's centre on each body, where these pass beside each other [m]
void end_plan(const PairCase& c, bool sticks, Plan& plan, const std::function<halfspace::HeatTimes()>& heat_times,
              const std::array<double, 2>& beside = {});

/// Grids that have grown deeper may contain interfaces of layers that are not boundaries of their layers of cells.
/// @param where  in the run, as at the beginning of a message
/// @throws GridError
void require_interfaces_at_cells(const Plan& larger, const constitutive::Material& lower,
                                 const constitutive::Material& upper, const std::string& where);

} // namespace brinell::simulation
