// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/inclusion_shape.hpp"

#include "brinell/foundation/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <random>
#include <utility>

namespace brinell::simulation
{

namespace
{

double square(double x)
{
  return x * x;
}

void require_sizes(const InclusionShape& shape)
{
  constexpr std::array names{"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i)
    if (!(shape.semi_axes[i] > 0.0))
      throw InputError(fmt::format("an inclusion has the semi-axis {:g} m along {}; allowed: above 0",
                                   shape.semi_axes[i], names[i]));
  if (shape.axis < 0 || shape.axis > 2)
    throw InputError(fmt::format("an inclusion has the axis {}; allowed: 0, 1, 2 for x, y, z", shape.axis));
}

/// Cells whose centre is in a region: the region is asked for the centres in a box only.
template <typename Contains>
std::vector<std::size_t> cells_in(const VolumeGrid& grid, double x0, double y0, const std::array<double, 3>& from,
                                  const std::array<double, 3>& to, const Contains& contains)
{
  const SurfaceGrid& s = grid.surface;
  const auto range = [](double low, double high, double first, double step, int count)
  {
    const double begin = std::clamp(std::floor((low - first) / step), 0.0, static_cast<double>(count));
    const double end = std::clamp(std::ceil((high - first) / step) + 1.0, begin, static_cast<double>(count));
    return std::array{static_cast<int>(begin), static_cast<int>(end)};
  };
  const auto [i0, i1] = range(from[0], to[0], x0, s.dx, s.nx);
  const auto [j0, j1] = range(from[1], to[1], y0, s.dy, s.ny);
  const auto [k0, k1] = range(from[2], to[2], 0.5 * grid.dz, grid.dz, grid.nz);
  std::vector<std::size_t> cells;
  for (int k = k0; k < k1; ++k)
    for (int j = j0; j < j1; ++j)
      for (int i = i0; i < i1; ++i)
        if (contains(x0 + i * s.dx, y0 + j * s.dy, (k + 0.5) * grid.dz))
          cells.push_back(grid.index(i, j, k));
  return cells;
}

} // namespace

double InclusionShape::volume() const
{
  const double box = 8.0 * semi_axes[0] * semi_axes[1] * semi_axes[2];
  return kind == Kind::cuboid     ? box
         : kind == Kind::cylinder ? box * std::numbers::pi / 4.0
                                  : box * std::numbers::pi / 6.0;
}

bool InclusionShape::contains(double x, double y, double z) const
{
  const std::array<double, 3> scaled{std::abs(x - centre[0]) / semi_axes[0], std::abs(y - centre[1]) / semi_axes[1],
                                     std::abs(z - centre[2]) / semi_axes[2]};
  const double squares = square(scaled[0]) + square(scaled[1]) + square(scaled[2]);
  switch (kind)
  {
  case Kind::cuboid:
    return std::ranges::all_of(scaled, [](double part) { return part < 1.0; });
  case Kind::cylinder:
  {
    const double along = scaled[static_cast<std::size_t>(axis)];
    return along < 1.0 && squares - square(along) < 1.0;
  }
  case Kind::ellipsoid:
    break;
  }
  return squares < 1.0;
}

std::vector<std::size_t> cells_of(const InclusionShape& shape, const VolumeGrid& grid, double x0, double y0)
{
  require_sizes(shape);
  std::array<double, 3> from{}, to{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    from[i] = shape.centre[i] - shape.semi_axes[i];
    to[i] = shape.centre[i] + shape.semi_axes[i];
  }
  return cells_in(grid, x0, y0, from, to, [&](double x, double y, double z) { return shape.contains(x, y, z); });
}

std::vector<std::size_t> cells_of(const InclusionVoxels& voxels, const VolumeGrid& grid, double x0, double y0)
{
  std::size_t count = 1;
  for (const int n : voxels.count)
    count *= static_cast<std::size_t>(std::max(0, n));
  if (count == 0 || voxels.is_filled.size() != count)
    throw InputError(
        fmt::format("{} voxels of an inclusion for {} x {} x {}; allowed: as many as their numbers along x, y "
                    "and z say, at least one",
                    voxels.is_filled.size(), voxels.count[0], voxels.count[1], voxels.count[2]));
  if (!(voxels.size > 0.0))
    throw InputError(fmt::format("voxels of an inclusion have the size {:g} m; allowed: above 0", voxels.size));
  std::array<double, 3> to{};
  for (std::size_t i = 0; i < 3; ++i)
    to[i] = voxels.corner[i] + voxels.count[i] * voxels.size;
  const auto contains = [&](double x, double y, double z)
  {
    std::size_t place = 0, next = 1;
    const std::array<double, 3> at{x, y, z};
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double number = std::floor((at[i] - voxels.corner[i]) / voxels.size);
      if (number < 0.0 || number >= voxels.count[i])
        return false;
      place += next * static_cast<std::size_t>(number);
      next *= static_cast<std::size_t>(voxels.count[i]);
    }
    return voxels.is_filled[place] != 0;
  };
  return cells_in(grid, x0, y0, voxels.corner, to, contains);
}

std::vector<InclusionShape> shapes_of(const InclusionCluster& cluster)
{
  if (!(cluster.smallest_radius > 0.0 && cluster.largest_radius >= cluster.smallest_radius))
    throw InputError(
        fmt::format("a cluster of inclusions has radii from {:g} m to {:g} m; allowed: above 0, in ascending order",
                    cluster.smallest_radius, cluster.largest_radius));
  if (cluster.count < 0 || !(cluster.gap >= 0.0))
    throw InputError(
        fmt::format("a cluster of {} inclusions with a gap of {:g} m; allowed: 0 or more", cluster.count, cluster.gap));
  std::mt19937_64 engine(cluster.seed);
  // std::uniform_real_distribution is not the same in every library, the engine is.
  const auto uniform = [&](double low, double high)
  { return low + (high - low) * (static_cast<double>(engine() >> 11U) * 0x1p-53); };
  constexpr int most_attempts = 10000; // of one ball
  std::vector<InclusionShape> balls;
  balls.reserve(static_cast<std::size_t>(cluster.count));
  for (int attempt = 0; balls.size() < static_cast<std::size_t>(cluster.count); ++attempt)
  {
    if (attempt == most_attempts)
      throw InputError(
          fmt::format("{} of {} inclusions of a cluster found room in its box; allowed: fewer, smaller or closer "
                      "ones, or a larger box",
                      balls.size(), cluster.count));
    const double radius = uniform(cluster.smallest_radius, cluster.largest_radius);
    InclusionShape ball{InclusionShape::Kind::ellipsoid, {}, {radius, radius, radius}};
    bool fits = true;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double room = cluster.half_sides[i] - radius;
      fits = fits && room >= 0.0;
      ball.centre[i] = cluster.centre[i] + uniform(-1.0, 1.0) * std::max(0.0, room);
    }
    const auto is_apart = [&](const InclusionShape& other)
    {
      const double distance =
          std::sqrt(square(ball.centre[0] - other.centre[0]) + square(ball.centre[1] - other.centre[1]) +
                    square(ball.centre[2] - other.centre[2]));
      return distance >= radius + other.semi_axes[0] + cluster.gap;
    };
    if (!fits || !std::ranges::all_of(balls, is_apart))
      continue;
    balls.push_back(ball);
    attempt = -1;
  }
  return balls;
}

namespace
{

void require_above(const VolumeGrid& grid, double deepest, std::size_t number)
{
  if (deepest > grid.nz * grid.dz)
    throw InputError(
        fmt::format("inclusion {} reaches down to {:g} m, the grid to {:g} m; allowed: inclusions within the "
                    "grid, or more layers",
                    number + 1, deepest, grid.nz * grid.dz));
}

} // namespace

std::vector<elastoplastic::Inclusion> in_cells(const std::vector<BodyInclusion>& inclusions, const VolumeGrid& grid,
                                               double x0, double y0)
{
  constexpr double unyielding = 1e9; // of rigid cells, whose stress has no accuracy in single ones
  std::vector<elastoplastic::Inclusion> result;
  result.reserve(inclusions.size());
  for (std::size_t number = 0; number < inclusions.size(); ++number)
  {
    const BodyInclusion& inclusion = inclusions[number];
    std::vector<InclusionShape> shapes;
    std::vector<std::size_t> cells;
    if (const auto* shape = std::get_if<InclusionShape>(&inclusion.region))
      shapes.push_back(*shape);
    else if (const auto* cluster = std::get_if<InclusionCluster>(&inclusion.region))
      shapes = shapes_of(*cluster);
    else if (const auto* voxels = std::get_if<InclusionVoxels>(&inclusion.region))
    {
      require_above(grid, voxels->corner[2] + voxels->count[2] * voxels->size, number);
      cells = cells_of(*voxels, grid, x0, y0);
    }
    for (const InclusionShape& shape : shapes)
    {
      require_above(grid, shape.centre[2] + shape.semi_axes[2], number);
      const std::vector<std::size_t> of_shape = cells_of(shape, grid, x0, y0);
      cells.insert(cells.end(), of_shape.begin(), of_shape.end());
    }
    if (!cells.empty())
      result.push_back({{inclusion.elastic, std::move(cells), inclusion.own},
                        inclusion.elastic.is_rigid() ? unyielding : inclusion.yield_factor,
                        static_cast<int>(number) + 1});
  }
  return result;
}

double cells_per_axis(const InclusionShape& shape, const VolumeGrid& grid)
{
  return std::min(
      {shape.semi_axes[0] / grid.surface.dx, shape.semi_axes[1] / grid.surface.dy, shape.semi_axes[2] / grid.dz});
}

} // namespace brinell::simulation
