// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "foundation/nan.hpp"
#include "simulation/stepping/stepper.hpp"

#include <algorithm>
#include <numeric>

/// Common parts of scenarios in which one body is pressed on the other.
namespace brinell::simulation
{

inline constexpr double finest_press = 1.0 / 64; ///< shortest piece of a step that does not slide

/// Value of a drive at a share of its way from one value to another. For loads, load^(2/3) changes linearly, so that the approach
/// changes about linearly; with equal steps of load the first step would be by far the longest.
[[nodiscard]] double pressed_between(contact::Drive::Kind kind, double from, double to, double share);

/// Value of a drive at which the surfaces, with dents and bumps, just do not press: load 0; the approach of first touch, if this
/// is negative, else 0; or the mean gap at first touch.
[[nodiscard]] double without_contact(contact::Drive::Kind kind, const Stepper::Distances& touch);

/// Fills the columns for bodies that are periodic along both axes; NaN for others.
template <typename Record>
void read_period(const elastoplastic::CoupledContact& pair, Record& r)
{
  const SurfaceGrid& grid = pair.grid();
  r.nominal_pressure = r.contact_fraction = r.mean_gap = nan;
  if (!grid.is_periodic())
    return;
  const auto cells = static_cast<double>(grid.size());
  const double area = cells * grid.cell_area();
  r.nominal_pressure = r.F_n / area;
  r.contact_fraction = r.contact_area / area;
  r.mean_gap = std::max(0.0, std::accumulate(pair.gap().begin(), pair.gap().end(), 0.0) / cells);
}

} // namespace brinell::simulation
