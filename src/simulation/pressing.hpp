// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "stepper.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

/// What scenarios share in which one body is pressed on the other.
namespace brinell::simulation
{

/// A drive that presses nothing, dents and bumps included: no load, the approach of the first touch, if that is below zero, or the mean
/// gap where the surfaces first touch.
[[nodiscard]] double without_contact(contact::Drive::Kind kind, const Stepper::Distances& touch);

/// What a row tells of bodies that are periodic along both axes; NaN of others.
template <typename Record>
void read_period(const elastoplastic::CoupledContact& pair, Record& r)
{
  const SurfaceGrid& grid = pair.grid();
  r.nominal_pressure = r.contact_fraction = r.mean_gap = std::numeric_limits<double>::quiet_NaN();
  if (!grid.is_periodic())
    return;
  const auto cells = static_cast<double>(grid.size());
  const double area = cells * grid.cell_area();
  r.nominal_pressure = r.F_n / area;
  r.contact_fraction = r.contact_area / area;
  r.mean_gap = std::max(0.0, std::accumulate(pair.gap().begin(), pair.gap().end(), 0.0) / cells);
}

} // namespace brinell::simulation
