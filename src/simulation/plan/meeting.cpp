// SPDX-License-Identifier: BSD-3-Clause
#include "meeting.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

namespace brinell::simulation
{

namespace
{

using contact::Drive;

/// Depths of the lower surface in all columns that come under the contact: one period, or the whole track.
struct Track
{
  SurfaceGrid grid;
  std::vector<double> depth;

  Track(const ShapedBody& lower, const SurfaceGrid& contact, double x0, int columns_on, ReadTexture* read)
      : grid(contact)
  {
    if (!grid.is_periodic_x())
      grid.nx += columns_on;
    depth = read(lower.texture, grid, x0, grid.y(0));
  }
  [[nodiscard]] double at(int i, int j) const { return depth[grid.index(i % grid.nx, j)]; }
};

/// Evaluates the overlap at one place on the way.
/// @param upper    depths of the upper surface and of the shapes together
/// @param shift    columns by which the contact has moved over the track
/// @param deepest  deepest overlap so far [m]
void add_place(const Track& track, const SurfaceGrid& grid, const CellPlaces& at, const std::vector<double>& upper,
               int shift, double approach, double& deepest, Meeting& met)
{
  double smallest = std::numeric_limits<double>::infinity();
  int overlapping = 0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
    {
      const double distance = upper[grid.index(i, j)] + track.at(i + shift, j);
      smallest = std::min(smallest, distance);
      if (distance >= approach)
        continue;
      ++overlapping;
      met.reach_x = std::max(met.reach_x, std::abs(at.x + i * grid.dx) + 0.5 * grid.dx);
      met.reach_y = std::max(met.reach_y, std::abs(at.y + j * grid.dy) + 0.5 * grid.dy);
    }
  met.touch = std::min(met.touch, smallest);
  if (approach - smallest > deepest)
  {
    deepest = approach - smallest;
    met.area = overlapping * grid.cell_area();
  }
}

} // namespace

Meeting meeting(const ShapedBody& lower, const ShapedBody& upper, const SurfaceGrid& grid, const Way& way,
                double approach, ReadTexture* read)
{
  constexpr double max_evaluations = 1e8; // of cells: with more, places are skipped
  const int columns = static_cast<int>(std::ceil((way.to - way.from) / grid.dx - 1e-9));
  const int on_way = grid.is_periodic_x() ? std::min(columns, grid.nx - 1) : columns;
  const CellPlaces at = places_in_run(grid, way.from);
  const Track track(lower, grid, at.lower + at.x, on_way, read);
  const ShapedBody smooth{lower.shape, lower.material, {}};
  const std::vector<double> upper_depth = surface_distance(smooth, upper, grid, at, read);
  Meeting met;
  met.touch = std::numeric_limits<double>::infinity();
  double deepest = -met.touch;
  const int stride = std::max(1, static_cast<int>(static_cast<double>(grid.size()) * (on_way + 1) / max_evaluations));
  for (int shift = 0; shift <= on_way; shift += stride)
    add_place(track, grid, at, upper_depth, shift, approach, deepest, met);
  double sum = std::accumulate(upper_depth.begin(), upper_depth.end(), 0.0);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      sum += track.at(i, j);
  met.mean = sum / static_cast<double>(grid.size());
  return met;
}

namespace
{

/// Distance from the middle, along x or y, up to which a shape is lower than a height [m].
double half_below(const Shape& shape, double limit, bool along_y)
{
  constexpr double shortest = 1e-12, longest = 1e6, ratio = 1.05; // [m]: no body is smaller, or larger
  double half = shortest;
  while (half < longest && height(shape, along_y ? 0.0 : half, along_y ? half : 0.0) < limit)
    half *= ratio;
  return half;
}

/// Cells along one axis of a grid for estimates.
struct EstimateAxis
{
  int cells = 0;
  double size = 0.0; ///< of a cell [m]
  Boundary boundary = Boundary::open;
};

EstimateAxis periodic_axis(const Domain::Axis& axis, double spacing)
{
  constexpr int usual = 128;
  const double wanted = spacing > 0.0 ? axis.size / spacing : usual;
  const int cells = axis.cells > 0 ? axis.cells : std::max(1, static_cast<int>(std::lround(wanted)));
  return {cells, axis.size / cells, Boundary::periodic};
}

/// @param half   half-length of the axis [m]
/// @param track  length of the contact's track along the axis [m]
EstimateAxis open_axis(double half, double track, double spacing)
{
  constexpr double coarsest = 128.0, finest = 512.0, longest_track = 2e4; // cells
  const double usual = 2.0 * half / coarsest;
  const double wanted = spacing > 0.0 ? std::clamp(spacing, 2.0 * half / finest, usual) : usual;
  const double size = std::max(wanted, track / longest_track);
  return {2 * static_cast<int>(std::ceil(half / size)) + 1, size, Boundary::open};
}

} // namespace

Meeting estimated_meeting(const ShapedBody& lower, const ShapedBody& upper, const Numerics& numerics, const Way& way,
                          double approach)
{
  // Where the shapes are lower than this height the surfaces may touch. The minimum keeps some cells if they cannot touch at all.
  const double tops = reach(lower.texture).height + reach(upper.texture).height;
  constexpr double least = 1e-12; // [m]
  const double highest = std::max({approach + tops, 0.01 * tops, least});
  const auto axis = [&](const Domain::Axis& of, bool along_y)
  {
    const double spacing = numerics.spacing ? (*numerics.spacing)[along_y ? 1 : 0] : 0.0;
    return of.is_periodic()
               ? periodic_axis(of, spacing)
               : open_axis(half_below(upper.shape, highest, along_y), along_y ? 0.0 : way.to - way.from, spacing);
  };
  const EstimateAxis x = axis(numerics.domain.x, false), y = axis(numerics.domain.y, true);
  const SurfaceGrid grid{x.cells, y.cells, x.size, y.size, x.boundary, y.boundary};
  return meeting(lower, upper, grid, way, approach,
                 depths); // heights at points, as means would hide the peaks that touch
}

namespace
{

/// Footprint of a ball on a flat with the same overlap and area of overlap, which is 2 pi R times the overlap for paraboloids.
Footprint of_peaks(const ShapedBody& lower, const ShapedBody& upper, double overlap, double area, double friction)
{
  const double radius = area / (2.0 * std::numbers::pi * overlap);
  const ShapedBody flat{Plane{}, lower.material, {}};
  const ShapedBody peak{Paraboloid{radius, radius}, upper.material, {}};
  return smooth_footprint(flat, peak, {Drive::Kind::approach, overlap}, {}, friction);
}

} // namespace

Footprint footprint_on_the_way(const ShapedBody& lower, const ShapedBody& upper, const Numerics& numerics,
                               const Meeting& met, double approach)
{
  constexpr double extent = 1.5; // smallest ratio of grids to footprint in lay_out
  const double overlap = approach - met.touch;
  const double friction = numerics.friction.coefficient;
  Footprint f = approach >= 0.5 * overlap
                    ? footprint(lower, upper, {Drive::Kind::approach, approach}, numerics.domain, friction)
                    : of_peaks(lower, upper, overlap, met.area, friction);
  if (met.reach_x > extent * f.over_x)
    f.over_x = met.reach_x;
  if (met.reach_y > extent * f.over_y && !f.straight_y && !f.endless_y)
    f.over_y = met.reach_y;
  return f;
}

} // namespace brinell::simulation
