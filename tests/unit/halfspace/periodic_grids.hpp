// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/halfspace/surface_compliance.hpp"

#include <vector>

/// Grids with periodic axes, and the displacement on them.
namespace brinell::halfspace
{

inline SurfaceGrid periodic(int nx, int ny, double dx, double dy)
{
  return {nx, ny, dx, dy, Boundary::periodic, Boundary::periodic};
}

inline SurfaceGrid periodic_in_y(int nx, int ny, double dx, double dy)
{
  return {nx, ny, dx, dy, Boundary::open, Boundary::periodic};
}

inline std::vector<double> displacement(const SurfaceCompliance& compliance, const std::vector<double>& pressure)
{
  std::vector<double> u(pressure.size());
  SurfaceCompliance::Scratch scratch = compliance.make_scratch();
  compliance.apply({.pressure = pressure}, {.z = u}, scratch);
  return u;
}

} // namespace brinell::halfspace
