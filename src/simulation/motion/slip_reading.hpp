// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/partial_slip.hpp"

#include <algorithm>

namespace brinell::simulation
{

/// Fills the columns of surfaces that stick in places, and adds the work of the force along them.
/// @param work  of that force up to the last step, then up to this one [J]
template <typename Record>
void read_slip(const elastoplastic::PartialSlip& slip, double& work, Record& r)
{
  r.work += slip.work() - work;
  work = slip.work();
  r.dissipation_friction = slip.heat();
  r.stick_share = slip.pressed_cells() > 0 ? static_cast<double>(slip.sticking_cells()) / slip.pressed_cells() : 0.0;
  r.stick_area = r.stick_share * r.contact_area;
  r.slip_path = *std::max_element(slip.path().begin(), slip.path().end());
}

} // namespace brinell::simulation
