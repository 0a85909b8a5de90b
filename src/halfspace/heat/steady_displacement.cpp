// SPDX-License-Identifier: BSD-3-Clause
#include "steady_displacement.hpp"

#include "require_thermal.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace brinell::halfspace
{

namespace
{

/// Offsets along one axis, as cells of a grid of their own.
struct OffsetCells
{
  int count, middle;

  OffsetCells(int cells, bool is_periodic)
      : count(is_periodic ? cells : 2 * cells - 1), middle(is_periodic ? 0 : cells - 1)
  {
  }
  /// Index of the offset number n in a transform of this length.
  [[nodiscard]] int wrapped(int n, int length) const { return n >= middle ? n - middle : n - middle + length; }
};

} // namespace

void require_steady(const char* function_name, const SurfaceGrid& grid, const Thermal& thermal,
                    const SteadyMotion& motion)
{
  require_thermal(function_name, thermal);
  if (!std::isfinite(motion.velocity))
    throw InputError(fmt::format("{}: a velocity of {} m/s; allowed: a finite number", function_name, motion.velocity));
  if (motion.reference && !(*motion.reference > 0.0 && std::isfinite(*motion.reference)))
    throw InputError(
        fmt::format("{}: a reference of {} m; allowed: a distance above 0, or none", function_name, *motion.reference));
  if (grid.is_periodic_x() || (grid.is_periodic_y() && motion.velocity == 0.0))
    throw InputError(fmt::format("{}: there is no steady state of a body that is heated all along a periodic axis by a "
                                 "flux that never leaves; allowed: a velocity across the period, or open axes",
                                 function_name));
}

std::vector<double> steady_displacement(const SteadyLattices& lattices, const Thermal& thermal, const Elastic& elastic,
                                        const SteadyMotion& motion)
{
  const double factor = -2.0 * (1.0 + elastic.poisson_ratio) * thermal.expansion;
  const auto waves = [&](const SurfaceWave&, double, const ThermalWave& heat, std::span<Complex> out)
  { out[0] = factor * heat.potential_at_surface; };
  const std::vector<double> at_surface{0.0};
  std::vector<double> table = std::move(lattices.tables(at_surface, {waves, {false}}).front());
  if (motion.velocity != 0.0)
    return table;
  if (!motion.reference)
    throw InputError("the steady displacement under a flux at rest has no limit: it grows with the logarithm of the "
                     "distance; allowed: a reference, the distance at which the displacement is zero, or a velocity");
  // The constant part of the displacement on the lattices is arbitrary. Far from the cell the displacement is
  // (1 + nu) alpha Q/(2 pi K) ln(r/reference) (Barber 1971), which fixes it.
  const SurfaceGrid& g = lattices.offsets();
  // The constant is evaluated in the corner, where the interpolation of single cells causes no oscillations.
  const double distance = std::hypot(0.5 * (g.nx - 1) * g.dx, 0.5 * (g.ny - 1) * g.dy);
  const double unit = (1.0 + elastic.poisson_ratio) * thermal.expansion * g.cell_area() /
                      (2.0 * std::numbers::pi * thermal.conductivity);
  const double shift = (distance > 0.0 ? unit * std::log(distance / *motion.reference) : 0.0) - table.front();
  for (double& value : table)
    value += shift;
  return table;
}

AlignedVector<Complex> spectrum_of_offsets(const PaddedFft& fft, std::span<const double> table)
{
  const SurfaceGrid& grid = fft.grid();
  const OffsetCells x(grid.nx, grid.is_periodic_x()), y(grid.ny, grid.is_periodic_y());
  AlignedVector<double> response(static_cast<std::size_t>(fft.px()) * static_cast<std::size_t>(fft.py()));
  for (int j = 0; j < y.count; ++j)
    for (int i = 0; i < x.count; ++i)
      response[static_cast<std::size_t>(y.wrapped(j, fft.py())) * static_cast<std::size_t>(fft.px()) +
               static_cast<std::size_t>(x.wrapped(i, fft.px()))] =
          table[static_cast<std::size_t>(j) * static_cast<std::size_t>(x.count) + static_cast<std::size_t>(i)];
  return fft.forward_padded(response);
}

} // namespace brinell::halfspace
