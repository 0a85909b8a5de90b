// SPDX-License-Identifier: BSD-3-Clause
#include "images_of_heat.hpp"

#include "foundation/lanes.hpp"
#include "halfspace/transform/coarser_surface.hpp"
#include "layered_conduction.hpp"
#include "require_thermal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

namespace brinell::halfspace
{

namespace
{

/// Whether already the nearest images along an axis are removed on cells four times as long.
bool begins_coarser(int cells, bool is_periodic, HeatImages images)
{
  return images == HeatImages::coarse && !is_periodic && is_long(cells);
}

/// Period of the memory along one axis in cells, with the padding of an open axis.
int period(int cells, bool is_periodic, HeatImages images)
{
  return is_periodic ? cells : memory_length(cells, begins_coarser(cells, is_periodic, images));
}

} // namespace

bool is_strip(const SurfaceGrid& grid)
{
  return grid.is_periodic_x() != grid.is_periodic_y();
}

ImagesOfHeat::ImagesOfHeat(const SurfaceGrid& grid, const Thermal& thermal, const Thermal& slowest, double duration,
                           HeatImages images, bool has_fields)
    : period_x(period(grid.nx, grid.is_periodic_x(), images)), period_y(period(grid.ny, grid.is_periodic_y(), images)),
      x_is_coarser(begins_coarser(grid.nx, grid.is_periodic_x(), images)),
      y_is_coarser(begins_coarser(grid.ny, grid.is_periodic_y(), images)),
      twice_x(x_is_coarser ? period_x / 2 : period_x), twice_y(y_is_coarser ? period_y / 2 : period_y),
      once_x(grid.is_periodic_x() ? period_x : twice_x / 2), once_y(grid.is_periodic_y() ? period_y : twice_y / 2)
{
  if (grid.is_periodic())
    return;
  // The shortest distance from the grid to one of its images.
  nearest = std::numeric_limits<double>::infinity();
  if (!grid.is_periodic_x())
    nearest = std::min(nearest, (period_x - grid.nx) * grid.dx);
  if (!grid.is_periodic_y())
    nearest = std::min(nearest, (period_y - grid.ny) * grid.dy);
  // The temperature is negligible beyond the reach of the heat. Displacement and stress decrease only with a power of the
  // distance; from twice that distance on, the contributions of further lattices are a geometric series: see `add_images`.
  const double spread = reach_of_heat * std::sqrt(4.0 * thermal.diffusivity() * duration);
  const double farther = is_strip(grid) ? 4.0 : 2.0;
  end = has_fields ? farther * std::max(spread, 1.5 * nearest) : spread;
  // Waves in depth that decay before heat arrives from the images do not contribute to the temperature by the images, and little
  // to the stress, because that heat remains near the surface.
  // Heat arrives by the fastest material, waves decay by the slowest.
  decayed = (has_fields ? 600.0 : 2.0 * reach_of_heat * reach_of_heat) *
            std::sqrt(thermal.diffusivity() / slowest.diffusivity());
}

DepthWaves waves_of_heat(const char* owner, const SurfaceGrid& grid, const Thermal& thermal, const HeatTimes& times,
                         const WantedOfHeat& wanted)
{
  require_thermal(owner, thermal);
  if (wanted.coat)
    require_thermal(owner, wanted.coat->thermal);
  if (!(times.shortest_step > 0.0) || !(times.duration >= times.shortest_step) || std::isinf(times.duration))
    throw InputError(fmt::format("{}: a shortest step of {} s in a duration of {} s; allowed: finite times above 0, "
                                 "the duration not below the step",
                                 owner, times.shortest_step, times.duration));
  // In a stack the fastest waves are those of the layer in which heat spreads fastest.
  const double contrast =
      wanted.coat ? std::sqrt(wanted.coat->thermal.fastest().diffusivity() / thermal.diffusivity()) : 1.0;
  const double finest = contrast * std::numbers::pi * std::hypot(1.0 / grid.dx, 1.0 / grid.dy);
  const double deepest = wanted.coat ? std::max(0.0, wanted.deepest) : wanted.deepest;
  return depth_waves(thermal.diffusivity(), {times.shortest_step, times.duration, deepest}, finest);
}

/// Images are at least as far away as the grid is wide. For layers down to that depth, seven points have an error of 1e-4 of the
/// fields of the images; five points, about 1e-3.
std::vector<double> nodes_of_images(const WantedOfHeat& wanted)
{
  const int points = wanted.images == HeatImages::coarse ? 5 : 7;
  constexpr int points_of_thin = 3;
  constexpr double thin = 0.1; // of the depth
  std::vector<double> nodes;
  const auto add = [&](double top, double bottom)
  {
    const int count = bottom - top < thin * wanted.deepest ? points_of_thin : points;
    for (int n = 0; n < count; ++n)
      nodes.push_back(top + 0.5 * (bottom - top) * (1.0 - std::cos(std::numbers::pi * (n + 0.5) / count)));
  };
  double top = 0.0;
  for (std::size_t n = 0; wanted.coat && n < wanted.coat->thermal.layers.size() && top < wanted.deepest; ++n)
  {
    const double bottom = std::min(wanted.deepest, top + wanted.coat->thermal.layers[n].thickness);
    add(top, bottom);
    top = bottom;
  }
  if (top < wanted.deepest)
    add(top, wanted.deepest);
  return nodes;
}

std::shared_ptr<const HeatCoat> planned_coat(const SurfaceGrid& grid, const WantedOfHeat& wanted,
                                             const DepthWaves& waves, const ImagesOfHeat& images)
{
  if (!wanted.coat)
    return nullptr;
  const CoatOfBody& body = *wanted.coat;
  std::vector<double> depths;
  if (images.nearest < images.end && wanted.deepest > 0.0)
    depths = nodes_of_images(wanted);
  depths.insert(depths.end(), body.depths.begin(), body.depths.end());
  double longest = std::max(images.period_x * grid.dx, images.period_y * grid.dy);
  for (double distance = images.nearest; distance < images.end; distance *= 2.0)
    longest *= 2.0;
  return std::make_shared<const HeatCoat>(body.thermal, body.elastic, waves,
                                          HeatCoat::Wanted{2.0 * longest,
                                                           2.0 / std::hypot(1.0 / grid.dx, 1.0 / grid.dy),
                                                           grid.is_periodic(), body.surface, std::move(depths)});
}

namespace
{

/// Number of layers in which heat is generated or spreads, with `together` of them as one.
double layers_of_heat(const HeatedLayers& heated, double deepest, int together)
{
  if (heated.count == 0)
    return 0.0;
  const int count = (heated.count + together - 1) / together;
  const double thickness = together * heated.thickness;
  return static_cast<double>(count_of_layers(count, thickness, std::max(deepest, (count + 1) * thickness)));
}

} // namespace

double memory_of_heat(const SurfaceGrid& grid, const Thermal& thermal, const HeatTimes& times,
                      const WantedOfHeat& wanted, bool goes_back)
{
  const double copies = goes_back ? 2.0 : 1.0;
  constexpr double of_layers = 3.0;    // temperature, and amplitudes now and before the step
  constexpr double along_surface = 14; // wavenumbers, the planned step, its response, and sums over depth
  const DepthWaves waves = waves_of_heat("the heat of a body", grid, thermal, times, wanted);
  const auto lattice = [&](int px, int py, const DepthWaves& kept, double layers)
  {
    const double rows = grid.is_mirrored_y ? py / 2 + 1 : py;
    const int columns = px / 2 + 1;
    const double blocks = std::ceil(static_cast<double>(columns) / lane_count);
    return rows * blocks * sizeof(ComplexLanes) *
           (copies * static_cast<double>(kept.waves.size()) + along_surface + of_layers * layers);
  };
  const Thermal& farthest = wanted.coat ? wanted.coat->thermal.fastest() : thermal;
  const double spread = reach_of_heat * std::sqrt(4.0 * farthest.diffusivity() * times.duration);
  const double deepest = (wanted.heated.count + 1) * wanted.heated.thickness + spread;
  const ImagesOfHeat images(grid, farthest, thermal, times.duration, wanted.images, waves.has_fields);
  double bytes = lattice(images.period_x, images.period_y, waves, layers_of_heat(wanted.heated, deepest, 1));
  for (double distance = images.nearest; distance < images.end; distance *= 2.0)
  {
    const DepthWaves slow = waves.slower_than(images.decayed / distance);
    const int together = wanted.images == HeatImages::coarse && wanted.heated.count > 0
                             ? layers_together(wanted.heated.thickness, distance)
                             : 1;
    const double layers = layers_of_heat(wanted.heated, deepest, together);
    bytes +=
        lattice(images.twice_x, images.twice_y, slow, layers) + lattice(images.once_x, images.once_y, slow, layers);
  }
  return bytes;
}

} // namespace brinell::halfspace
