// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/surface_temperature.hpp"

#include "coarser_surface.hpp"
#include "foundation/require_size.hpp"
#include "heat_memory.hpp"
#include "require_thermal.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::halfspace
{

namespace
{

/// Heat has spread so many times sqrt(4 kappa t) where nothing of it is felt any more: e^{-9}, and further away besides.
constexpr double reach = 3.0;

/// What the images of one lattice give, less those that a lattice with twice the period has, too: on cells as coarse as
/// that far away suffices.
struct FartherImages
{
  CoarserSurface cells;
  HeatMemory twice, once;
};

} // namespace

/// The memory of a periodic surface, and what takes off its images: with T_P of a period P,
///     T = T_P + (T_2P - T_P) + (T_4P - T_2P) + ...
struct SurfaceTemperature::State
{
  HeatTimes times;
  double time = 0.0;
  HeatMemory near;
  std::vector<FartherImages> farther{};
};

SurfaceTemperature::SurfaceTemperature(const SurfaceGrid& grid, const Thermal& thermal, const HeatTimes& times)
{
  require_thermal("SurfaceTemperature", thermal);
  if (!(times.shortest_step > 0.0) || !(times.duration >= times.shortest_step) || std::isinf(times.duration))
    throw InputError(
        fmt::format("SurfaceTemperature: steps of {} s and more in {} s; allowed: finite times above 0, the "
                    "duration not below the step",
                    times.shortest_step, times.duration));
  const double diffusivity = thermal.diffusivity();
  const std::vector<DepthWave> waves = depth_waves(diffusivity, times.shortest_step, times.duration);
  const int px = grid.is_periodic_x() ? grid.nx : memory_length(grid.nx);
  const int py = grid.is_periodic_y() ? grid.ny : memory_length(grid.ny);
  state_ = make_hidden<State>(times, 0.0, HeatMemory(grid, px, py, grid, thermal, waves));
  if (grid.is_periodic())
    return;

  // The shortest way from the grid to an image of it.
  double clear = std::numeric_limits<double>::infinity();
  if (!grid.is_periodic_x())
    clear = std::min(clear, (px - grid.nx) * grid.dx);
  if (!grid.is_periodic_y())
    clear = std::min(clear, (py - grid.ny) * grid.dy);
  const double spread = reach * std::sqrt(4.0 * diffusivity * times.duration);
  SurfaceGrid finer = grid;
  for (double distance = clear; distance < spread; distance *= 2.0)
  {
    CoarserSurface cells(finer, state_->farther.empty() ? 0 : CoarserSurface::margin);
    const SurfaceGrid& coarse = cells.grid();
    // What decays before heat comes from the images tells nothing of them.
    std::vector<DepthWave> slow;
    for (const DepthWave& wave : waves)
      if (wave.number * distance < 2.0 * reach * reach)
        slow.push_back(wave);
    const int once_x = grid.is_periodic_x() ? px : px / 2, once_y = grid.is_periodic_y() ? py : py / 2;
    HeatMemory twice(coarse, px, py, grid, thermal, slow), once(coarse, once_x, once_y, grid, thermal, slow);
    finer = coarse;
    state_->farther.push_back({cells, std::move(twice), std::move(once)});
  }
}

const SurfaceGrid& SurfaceTemperature::grid() const
{
  return state_->near.grid();
}

double SurfaceTemperature::time() const
{
  return state_->time;
}

void SurfaceTemperature::require_step(const char* function_name, double duration) const
{
  const HeatTimes& times = state_->times;
  constexpr double rounding = 1e-9;
  if (!(duration >= (1.0 - rounding) * times.shortest_step) ||
      !(state_->time + duration <= (1.0 + rounding) * times.duration))
    throw InputError(fmt::format("{}: a step of {} s after {} s; allowed: from {} s on, and {} s in all", function_name,
                                 duration, state_->time, times.shortest_step, times.duration));
}

void SurfaceTemperature::remaining(double duration, std::span<double> temperature) const
{
  require_size("SurfaceTemperature::remaining: the temperature", temperature, grid().size());
  require_step("SurfaceTemperature::remaining", duration);
  // From the coarsest cells to the finest.
  std::vector<double> sum;
  for (std::size_t n = state_->farther.size(); n-- > 0;)
  {
    const FartherImages& images = state_->farther[n];
    sum.resize(images.cells.grid().size());
    images.twice.add_remaining(duration, 1.0, sum);
    images.once.add_remaining(duration, -1.0, sum);
    sum = images.cells.to_finer(sum);
  }
  if (sum.empty())
    std::fill(temperature.begin(), temperature.end(), 0.0);
  else
    std::copy(sum.begin(), sum.end(), temperature.begin());
  state_->near.add_remaining(duration, 1.0, temperature);
}

void SurfaceTemperature::take_up(std::span<const double> flux, const HeatMotion& motion)
{
  require_size("SurfaceTemperature::take_up: the flux", flux, grid().size());
  require_step("SurfaceTemperature::take_up", motion.duration);
  state_->near.take_up(flux, motion);
  std::vector<double> coarse(flux.begin(), flux.end());
  for (FartherImages& images : state_->farther)
  {
    coarse = images.cells.from_finer(coarse);
    images.twice.take_up(coarse, motion);
    images.once.take_up(coarse, motion);
  }
  state_->time += motion.duration;
}

} // namespace brinell::halfspace
