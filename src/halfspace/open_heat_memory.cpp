// SPDX-License-Identifier: BSD-3-Clause
#include "open_heat_memory.hpp"

#include "foundation/require_size.hpp"
#include "require_thermal.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brinell::halfspace
{

namespace
{

/// Heat has spread so many times sqrt(4 kappa t) where nothing of it is felt any more: e^{-9}, and further away besides.
constexpr double reach = 3.0;

/// Cells of one axis of the memory, with the padding of an open one.
int period(int cells, bool is_periodic)
{
  return is_periodic ? cells : memory_length(cells);
}

/// Whether images lie along one axis only, and their fields fall off as the second power of the distance.
bool is_strip(const SurfaceGrid& grid)
{
  return grid.is_periodic_x() != grid.is_periodic_y();
}

DepthWaves planned_waves(const char* owner, const SurfaceGrid& grid, const Thermal& thermal, const HeatTimes& times,
                         double deepest)
{
  require_thermal(owner, thermal);
  if (!(times.shortest_step > 0.0) || !(times.duration >= times.shortest_step) || std::isinf(times.duration))
    throw InputError(fmt::format("{}: steps of {} s and more in {} s; allowed: finite times above 0, the "
                                 "duration not below the step",
                                 owner, times.shortest_step, times.duration));
  const double finest = std::numbers::pi * std::hypot(1.0 / grid.dx, 1.0 / grid.dy);
  return depth_waves(thermal.diffusivity(), {times.shortest_step, times.duration, deepest}, finest);
}

} // namespace

OpenHeatMemory::OpenHeatMemory(const char* owner, const SurfaceGrid& grid, const Thermal& thermal,
                               const HeatTimes& times, double deepest)
    : times_(times), waves_(planned_waves(owner, grid, thermal, times, deepest)),
      near_(grid, period(grid.nx, grid.is_periodic_x()), period(grid.ny, grid.is_periodic_y()), thermal, waves_)
{
  if (!grid.is_periodic())
    plan_images(thermal, period(grid.nx, grid.is_periodic_x()), period(grid.ny, grid.is_periodic_y()));
}

void OpenHeatMemory::plan_images(const Thermal& thermal, int px, int py)
{
  const SurfaceGrid& grid = near_.grid();
  // The shortest way from the grid to an image of it.
  double clear = std::numeric_limits<double>::infinity();
  if (!grid.is_periodic_x())
    clear = std::min(clear, (px - grid.nx) * grid.dx);
  if (!grid.is_periodic_y())
    clear = std::min(clear, (py - grid.ny) * grid.dy);
  // Temperature ends where heat has come to. Displacement and stress go on beyond, as a power of the distance; from twice as far on
  // what the next lattices would add is a series: see `fields`.
  const double spread = reach * std::sqrt(4.0 * thermal.diffusivity() * times_.duration);
  const double farther = is_strip(grid) ? 4.0 : 2.0;
  const double end = waves_.has_fields ? farther * std::max(spread, 1.5 * clear) : spread;
  // What decays before heat comes from the images tells nothing of them; of stress it tells little, as it stays at the surface.
  const double decayed = waves_.has_fields ? 600.0 : 2.0 * reach * reach;
  SurfaceGrid finer = grid;
  for (double distance = clear; distance < end; distance *= 2.0)
  {
    CoarserSurface cells(finer, farther_.empty() ? 0 : CoarserSurface::margin);
    const SurfaceGrid& coarse = cells.grid();
    const DepthWaves slow = waves_.slower_than(decayed / distance);
    const int once_x = grid.is_periodic_x() ? px : px / 2, once_y = grid.is_periodic_y() ? py : py / 2;
    HeatMemory twice(coarse, px, py, thermal, slow), once(coarse, once_x, once_y, thermal, slow);
    finer = coarse;
    farther_.push_back({cells, std::move(twice), std::move(once)});
  }
}

void OpenHeatMemory::require_step(const char* function_name, double duration) const
{
  constexpr double rounding = 1e-9;
  if (!(duration >= (1.0 - rounding) * times_.shortest_step) ||
      !(time_ + duration <= (1.0 + rounding) * times_.duration))
    throw InputError(fmt::format("{}: a step of {} s after {} s; allowed: from {} s on, and {} s in all", function_name,
                                 duration, time_, times_.shortest_step, times_.duration));
}

OpenHeatMemory::Fields OpenHeatMemory::sum(std::size_t count, double factor_of_farthest, const Add& add) const
{
  // From the coarsest cells to the finest.
  Fields sums(count);
  for (std::size_t n = farther_.size(); n-- > 0;)
  {
    const FartherImages& images = farther_[n];
    const double factor = n + 1 == farther_.size() ? factor_of_farthest : 1.0;
    for (std::vector<double>& field : sums)
      field.resize(images.cells.grid().size());
    add(images.twice, factor, sums);
    add(images.once, -factor, sums);
    for (std::vector<double>& field : sums)
      field = images.cells.to_finer(field);
  }
  for (std::vector<double>& field : sums)
    field.resize(grid().size());
  add(near_, 1.0, sums);
  return sums;
}

void OpenHeatMemory::remaining(const char* function_name, double duration, std::span<double> temperature) const
{
  require_size(fmt::format("{}: the temperature", function_name).c_str(), temperature, grid().size());
  require_step(function_name, duration);
  const Fields result = sum(1, 1.0,
                            [&](const HeatMemory& memory, double factor, Fields& sums)
                            { memory.add_remaining(duration, factor, grid(), sums.front()); });
  std::copy(result.front().begin(), result.front().end(), temperature.begin());
}

void OpenHeatMemory::fields(const char* function_name, double duration, const DepthFactors& factors,
                            const HeatMemory::FieldsOfHeat& fields_of_heat,
                            const std::vector<std::span<double>>& out) const
{
  if (duration != 0.0)
    require_step(function_name, duration);
  // Displacements and stresses fall off with the third power of the distance, and in plane strain with the second: from
  // lattice to lattice by 8 and 4, and all that follow are a seventh and a third of the last one.
  const double farthest = is_strip(grid()) ? 4.0 / 3.0 : 8.0 / 7.0;
  const Fields result = sum(out.size(), farthest,
                            [&](const HeatMemory& memory, double factor, Fields& sums)
                            { memory.add_fields(duration, factor, factors, fields_of_heat, sums); });
  for (std::size_t f = 0; f < out.size(); ++f)
    std::copy(result[f].begin(), result[f].end(), out[f].begin());
}

void OpenHeatMemory::take_up(const char* function_name, std::span<const double> flux, const HeatMotion& motion)
{
  require_size(fmt::format("{}: the flux", function_name).c_str(), flux, grid().size());
  require_step(function_name, motion.duration);
  near_.take_up(flux, motion);
  std::vector<double> coarse(flux.begin(), flux.end());
  for (FartherImages& images : farther_)
  {
    coarse = images.cells.from_finer(coarse);
    images.twice.take_up(coarse, motion);
    images.once.take_up(coarse, motion);
  }
  time_ += motion.duration;
}

} // namespace brinell::halfspace
