// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/inclusion_shape.hpp"

#include "brinell/foundation/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <numbers>
#include <random>
#include <utility>

namespace brinell::simulation
{

namespace
{

/// Balls by cubes of an edge, beyond whose neighbours no two balls come near each other.
class BallsByCubes
{
public:
  explicit BallsByCubes(double edge) : edge_(edge) {}

  void add(const InclusionShape& ball) { balls_[cube_of(ball)].push_back(ball); }

  /// Whether a ball keeps a gap to all others.
  [[nodiscard]] bool has_room(const InclusionShape& ball, double gap) const;

private:
  using Cube = std::array<double, 3>; ///< whole numbers, also large ones

  [[nodiscard]] Cube cube_of(const InclusionShape& ball) const
  {
    return {std::floor(ball.centre[0] / edge_), std::floor(ball.centre[1] / edge_), std::floor(ball.centre[2] / edge_)};
  }

  double edge_;
  std::map<Cube, std::vector<InclusionShape>> balls_;
};

double square(double x)
{
  return x * x;
}

bool BallsByCubes::has_room(const InclusionShape& ball, double gap) const
{
  const auto is_apart = [&](const InclusionShape& other)
  {
    const double distance =
        std::sqrt(square(ball.centre[0] - other.centre[0]) + square(ball.centre[1] - other.centre[1]) +
                  square(ball.centre[2] - other.centre[2]));
    return distance >= ball.semi_axes[0] + other.semi_axes[0] + gap;
  };
  const Cube middle = cube_of(ball);
  for (int n = 0; n < 27; ++n)
  {
    const int i = n % 3 - 1, j = n / 3 % 3 - 1, k = n / 9 - 1;
    const auto found = balls_.find({middle[0] + i, middle[1] + j, middle[2] + k});
    if (found != balls_.end() && !std::ranges::all_of(found->second, is_apart))
      return false;
  }
  return true;
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

/// Columns (rows) of a grid that may be in a region from `from` to `to`, with their coordinates: along a period those of the image
/// that is nearest to the region's middle.
std::vector<std::pair<int, double>> places_in(double from, double to, double first, double step, int count,
                                              bool is_periodic)
{
  constexpr double rounding = 1e-10; // an image at either end of the period counts as the one at its beginning
  std::vector<std::pair<int, double>> places;
  const double middle = 0.5 * (from + to), period = step * count;
  places.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
  {
    double at = first + i * step;
    if (is_periodic && count == 1) // nothing varies along the axis
      at = middle;
    else if (is_periodic)
      at -= period * std::floor((at - middle) / period + 0.5 + rounding);
    if (at > from - step && at < to + step)
      places.emplace_back(i, at);
  }
  return places;
}

/// Cells whose centre is in a region: the region is asked for the centres in a box only.
template <typename Contains>
std::vector<std::size_t> cells_in(const VolumeGrid& grid, double x0, double y0, const std::array<double, 3>& from,
                                  const std::array<double, 3>& to, const Contains& contains)
{
  const SurfaceGrid& s = grid.surface;
  const auto columns = places_in(from[0], to[0], x0, s.dx, s.nx, s.is_periodic_x()),
             rows = places_in(from[1], to[1], y0, s.dy, s.ny, s.is_periodic_y()),
             layers = places_in(from[2], to[2], 0.5 * grid.dz, grid.dz, grid.nz, false);
  std::vector<std::size_t> cells;
  for (const auto& [k, z] : layers)
    for (const auto& [j, y] : rows)
      for (const auto& [i, x] : columns)
        if (contains(x, y, z))
          cells.push_back(grid.index(i, j, k));
  return cells;
}

/// Whether a place in units of the semi-axis is between two faces. Cells whose centre is on a face belong to the region that begins
/// there, so that regions that touch share none and leave none.
bool is_between_faces(double part)
{
  constexpr double rounding = 1e-9;
  return part >= -1.0 - rounding && part < 1.0 - rounding;
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
  const std::array<double, 3> scaled{(x - centre[0]) / semi_axes[0], (y - centre[1]) / semi_axes[1],
                                     (z - centre[2]) / semi_axes[2]};
  const double squares = square(scaled[0]) + square(scaled[1]) + square(scaled[2]);
  switch (kind)
  {
  case Kind::cuboid:
    return std::ranges::all_of(scaled, is_between_faces);
  case Kind::cylinder:
  {
    const double along = scaled[static_cast<std::size_t>(axis)];
    return is_between_faces(along) && squares - square(along) < 1.0;
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
  constexpr double rounding = 1e-9; // a cell on the face between two voxels belongs to the one that begins there
  const auto contains = [&](double x, double y, double z)
  {
    std::size_t place = 0, next = 1;
    const std::array<double, 3> at{x, y, z};
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double number = std::floor((at[i] - voxels.corner[i]) / voxels.size + rounding);
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
  BallsByCubes placed(2.0 * cluster.largest_radius + cluster.gap);
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
    if (!fits || !placed.has_room(ball, cluster.gap))
      continue;
    placed.add(ball);
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
