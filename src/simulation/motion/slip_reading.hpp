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
  const elastoplastic::SlipState& state = slip.state();
  r.work += state.work - work;
  work = state.work;
  r.dissipation_friction = state.total_heat;
  r.stick_share = state.pressed > 0 ? static_cast<double>(state.sticking) / state.pressed : 0.0;
  r.stick_area = r.stick_share * r.contact_area;
  r.slip_path = *std::max_element(state.path.begin(), state.path.end());
}

} // namespace brinell::simulation
