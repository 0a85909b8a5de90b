// SPDX-License-Identifier: BSD-3-Clause
#include "lattice.hpp"

#include <cmath>

namespace brinell::simulation
{

namespace
{

using elastoplastic::Place;

/// Splits a column position into an integer and a fraction; a position that is an integer up to rounding gets the fraction 0.
Place place_at(double column)
{
  constexpr double rounding = 1e-7;
  const double nearest = std::round(column);
  if (std::abs(column - nearest) < rounding)
    return {static_cast<int>(nearest), 0.0};
  const double below = std::floor(column);
  return {static_cast<int>(below), column - below};
}

} // namespace

Lattice::Lattice(const Plan& plan, const Centre& start)
    : dx_(plan.contact.dx), half_((plan.contact.nx - 1) / 2),
      // Position of the contact's column 0 on the upper body, chosen to coincide with one of its columns.
      upper_start_(static_cast<double>(centre_column(start.lower) - half_) * dx_ - start.lower + start.upper),
      lower_columns_((plan.lower.surface.nx - 1) / 2),
      upper_columns_(static_cast<int>(std::lround(upper_start_ / dx_ + 0.5 * (plan.upper.surface.nx - 1))))
{
}

long Lattice::centre_column(double arc_lower) const
{
  return std::lround(arc_lower / dx_);
}

Frame Lattice::frame(const Centre& centre) const
{
  Frame f;
  const double left = static_cast<double>(centre_column(centre.lower) - half_) * dx_; // on the lower body
  f.x0 = left - centre.lower;
  f.placement.lower = place_at((left - lower_origin()) / dx_);
  f.placement.upper = place_at((f.x0 + centre.upper - upper_origin()) / dx_);
  return f;
}

void Lattice::grow(int contact, int lower, int upper)
{
  half_ += contact;
  lower_columns_ += lower;
  upper_columns_ += upper;
}

} // namespace brinell::simulation
