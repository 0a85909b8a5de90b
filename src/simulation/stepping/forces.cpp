// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/forces.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::simulation
{

namespace
{

/// Central difference along one direction: one-sided at the edges of an open grid, wrapped around a period.
double slope(std::span<const double> field, std::size_t index, int stride, int position, int count, double spacing,
             bool wraps = false)
{
  const auto step = static_cast<std::size_t>(stride);
  const std::size_t round = step * static_cast<std::size_t>(count - 1);
  if (wraps && (position == 0 || position == count - 1))
  {
    const double before = field[position > 0 ? index - step : index + round];
    const double after = field[position < count - 1 ? index + step : index - round];
    return (after - before) / (2.0 * spacing);
  }
  const std::size_t low = position > 0 ? index - step : index;
  const std::size_t high = position < count - 1 ? index + step : index;
  if (low == high)
    return 0.0;
  const double cells = static_cast<double>(high - low) / stride;
  return (field[high] - field[low]) / (cells * spacing);
}

} // namespace

Forces project_forces(const SurfaceGrid& grid, const halfspace::SurfaceLoad& load, double theta,
                      const ResidualSurface& lower, const ResidualSurface& upper)
{
  Forces f;
  double along = 0.0; // shear along the plane of contact
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
    {
      const std::size_t n = grid.index(i, j);
      const double p = load.pressure[n] * grid.cell_area();
      if (p == 0.0)
        continue;
      const double lower_x = slope(lower.displacement, n, 1, i, grid.nx, grid.dx);
      const double upper_x = slope(upper.displacement, n, 1, i, grid.nx, grid.dx);
      const double lower_y = slope(lower.displacement, n, grid.nx, j, grid.ny, grid.dy);
      const double upper_y = slope(upper.displacement, n, grid.nx, j, grid.ny, grid.dy);
      // Displacements of the upper body point in the opposite direction, so that its slope enters the common plane with a minus
      // sign.
      const double tilt_x = std::atan(lower.share * lower_x - upper.share * upper_x);
      const double tilt_y = std::atan(lower.share * lower_y - upper.share * upper_y);
      f.F_n += p;
      f.F_X -= p * std::sin(theta + tilt_x);
      f.F_Y -= p * std::sin(tilt_y);
      f.F_Z += p * std::cos(theta + tilt_x) * std::cos(tilt_y);
      f.F_X_lower -= p * std::sin(theta + std::atan(lower_x));
      f.F_X_upper -= p * std::sin(theta - std::atan(upper_x));
      if (load.shear_x.empty())
        continue;
      const double q = load.shear_x[n] * grid.cell_area();
      along += q;
      f.F_X_friction += q * std::cos(theta + tilt_x);
      f.F_Z_friction += q * std::sin(theta + tilt_x);
      f.F_X_lower += q * std::cos(theta + std::atan(lower_x));
      f.F_X_upper += q * std::cos(theta - std::atan(upper_x));
    }
  f.F_X_macro = -f.F_n * std::sin(theta);
  f.F_Z_macro = f.F_n * std::cos(theta);
  if (along != 0.0) // leaves the signs of zeros unchanged without friction
  {
    f.F_X += f.F_X_friction;
    f.F_Z += f.F_Z_friction;
    f.F_X_macro += along * std::cos(theta);
    f.F_Z_macro += along * std::sin(theta);
  }
  return f;
}

double rolling_resistance(const SurfaceGrid& grid, std::span<const double> pressure,
                          std::span<const double> lower_depth, std::span<const double> upper_depth, double upper_share)
{
  double force = 0.0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
    {
      const std::size_t n = grid.index(i, j);
      const double p = pressure[n] * grid.cell_area();
      if (p != 0.0)
        force -= p * (slope(lower_depth, n, 1, i, grid.nx, grid.dx, grid.is_periodic_x()) +
                      upper_share * slope(upper_depth, n, 1, i, grid.nx, grid.dx, grid.is_periodic_x()));
    }
  return force;
}

} // namespace brinell::simulation
