// SPDX-License-Identifier: BSD-3-Clause
#include "roughness.hpp"

#include "footprint.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace brinell::simulation
{

namespace
{

/// Along x and y [m].
struct ShortestWaves
{
  using Lengths = std::array<double, 2>;
  Lengths operator()(const Dent& dent) const { return {dent.wavelength(), dent.wavelength()}; }
  Lengths operator()(const HeightMap& map) const { return shortest_waves(map); }
  Lengths operator()(const Sinusoid& waves) const { return {waves.wavelength_x, waves.wavelength_y}; }
  Lengths operator()(const RandomSurface& surface) const
  {
    return {surface.parameters().cutoff, surface.parameters().cutoff};
  }
};

} // namespace

double Roughness::wavelength() const
{
  return slope > 0.0 ? 2.0 * std::numbers::pi * height / slope : 0.0;
}

Roughness roughness_of(std::span<const double> heights, const SurfaceGrid& grid)
{
  double mean = 0.0;
  for (const double h : heights)
    mean += h / static_cast<double>(heights.size());
  // Only points that have a next neighbour, which wraps around a period.
  const int last_x = grid.is_periodic_x() ? grid.nx : grid.nx - 1;
  const int last_y = grid.is_periodic_y() ? grid.ny : grid.ny - 1;
  double squares = 0.0;
  double slopes_x = 0.0;
  double slopes_y = 0.0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
    {
      const double here = heights[grid.index(i, j)];
      squares += std::pow(here - mean, 2);
      slopes_x += i < last_x ? std::pow((heights[grid.index((i + 1) % grid.nx, j)] - here) / grid.dx, 2) : 0.0;
      slopes_y += j < last_y ? std::pow((heights[grid.index(i, (j + 1) % grid.ny)] - here) / grid.dy, 2) : 0.0;
    }
  const double count_x = std::max(1.0, static_cast<double>(last_x) * grid.ny);
  const double count_y = std::max(1.0, static_cast<double>(last_y) * grid.nx);
  return {std::sqrt(squares / static_cast<double>(heights.size())), std::sqrt(slopes_x / count_x + slopes_y / count_y)};
}

std::optional<double> cells_per_wave(const ShapedBody& lower, const ShapedBody& upper, const Domain& domain, double dx,
                                     double dy)
{
  return domain.is_periodic() && are_flat(lower, upper) ? cells_per_shortest_wave(lower, upper, dx, dy) : std::nullopt;
}

std::optional<double> cells_per_shortest_wave(const ShapedBody& lower, const ShapedBody& upper, double dx, double dy)
{
  if (are_smooth(lower, upper))
    return std::nullopt;
  double fewest = std::numeric_limits<double>::infinity();
  for (const Texture* texture : {&lower.texture, &upper.texture})
    for (const TexturePart& part : texture->parts)
    {
      const auto [along_x, along_y] = std::visit(ShortestWaves{}, part);
      fewest = std::min({fewest, along_x / dx, along_y / dy});
    }
  return fewest;
}

} // namespace brinell::simulation
