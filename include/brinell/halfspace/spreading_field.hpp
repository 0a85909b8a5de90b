// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "brinell/foundation/hidden.hpp"

#include <span>
#include <vector>

namespace brinell::halfspace
{

/// Flux into the surface of a half space -> potential within it, for a resistivity (or 1/conductivity) of 1: harmonic, and
/// without flux through the rest of the surface. Along open axes it is 0 far away, images removed to about 1e-5 of the largest
/// value; over a period in both directions the mean of the flux, whose potential grows with the depth, is left out.
class SpreadingField
{
public:
  /// @param depths  of the layers [m], >= 0
  /// @throws InputError if one axis only is periodic: no such potential has a limit
  SpreadingField(const SurfaceGrid& grid, const std::vector<double>& depths);

  /// @param flux  per cell, the coefficients of its trigonometric interpolant [X/m^2]
  /// @param out   at each depth one value per cell [X/m]; overwritten
  void potential(std::span<const double> flux, std::span<double> out) const;

private:
  struct State;
  Hidden<State> state_;
};

} // namespace brinell::halfspace
