// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/texture.hpp"

#include "brinell/foundation/error.hpp"
#include "random_surface.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace brinell::simulation
{

namespace
{

double depth_of(const Dent& d, double x, double y)
{
  const double r = std::hypot(x - d.x, y - d.y) / d.wavelength();
  return d.depth * std::pow(10.0, -10.0 * r * r) * std::cos(2.0 * std::numbers::pi * r);
}

/// Index of a point's column or row within the map, wrapped if the map is periodic; none outside.
std::optional<int> index_in(int index, int count, bool periodic)
{
  if (!periodic)
    return index >= 0 && index < count ? std::optional(index) : std::nullopt;
  const int rest = index % count;
  return rest < 0 ? rest + count : rest;
}

/// Index along x of the map's centre. The cells of a run have a column at x = 0, but rows symmetric about y = 0. A periodic map
/// with an even number of points follows this rule, so that cells of an equal grid lie on the points and not between them, where
/// heights would be means of two points.
double points_before_centre(const HeightMap& map)
{
  return map.periodic && map.nx % 2 == 0 ? 0.5 * map.nx : 0.5 * (map.nx - 1);
}

double depth_of(const HeightMap& map, double x, double y)
{
  double u = (x - map.x) / map.dx + points_before_centre(map);
  double v = (y - map.y) / map.dy + 0.5 * (map.ny - 1);
  if (map.periodic)
  {
    u -= map.nx * std::floor(u / map.nx);
    v -= map.ny * std::floor(v / map.ny);
  }
  if (!(u > -1.0 && u < map.nx + 1.0 && v > -1.0 && v < map.ny + 1.0))
    return 0.0;
  const auto i = static_cast<int>(std::floor(u));
  const auto j = static_cast<int>(std::floor(v));
  const auto at = [&](int column, int row)
  {
    const auto inside_x = index_in(column, map.nx, map.periodic), inside_y = index_in(row, map.ny, map.periodic);
    return inside_x && inside_y ? map.heights[static_cast<std::size_t>(*inside_x) +
                                              static_cast<std::size_t>(map.nx) * static_cast<std::size_t>(*inside_y)]
                                : 0.0;
  };
  const double s = u - i;
  const double t = v - j;
  return -((1.0 - t) * ((1.0 - s) * at(i, j) + s * at(i + 1, j)) +
           t * ((1.0 - s) * at(i, j + 1) + s * at(i + 1, j + 1)));
}

/// cos(2 pi distance/wavelength), evaluated after removing whole waves for accuracy; 1 for an infinite wavelength.
double cosine(double distance, double wavelength)
{
  return std::cos(2.0 * std::numbers::pi * std::remainder(distance / wavelength, 1.0));
}

double depth_of(const Sinusoid& s, double x, double y)
{
  return -s.amplitude * cosine(x - s.x, s.wavelength_x) * cosine(y - s.y, s.wavelength_y);
}

double depth_of(const RandomSurface& surface, double x, double y)
{
  return -height_of(surface, x, y, {});
}

/// Numbers of points along x and y at which a texture is sampled in a cell; one is enough if the cells resolve it.
std::array<int, 2> samples_of(double length_x, double length_y, double dx, double dy)
{
  constexpr double max_points = 100.0; // with more points the mean hardly changes
  const auto count = [&](double length, double cell)
  { return cell > 1.001 * length ? static_cast<int>(std::min(max_points, std::ceil(2.0 * cell / length))) : 1; };
  return {count(length_x, dx), count(length_y, dy)};
}

std::array<int, 2> samples(const Dent& d, double dx, double dy)
{
  return samples_of(d.edge_radius, d.edge_radius, dx, dy);
}

std::array<int, 2> samples(const HeightMap& map, double dx, double dy)
{
  return samples_of(map.dx, map.dy, dx, dy);
}

/// Mean over a cell, by sampling.
template <typename Part>
double cell_depth_of(const Part& part, double x, double y, double dx, double dy)
{
  const auto [nx, ny] = samples(part, dx, dy);
  double sum = 0.0;
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i)
      sum += depth_of(part, x + ((i + 0.5) / nx - 0.5) * dx, y + ((j + 0.5) / ny - 0.5) * dy);
  return sum / (nx * ny);
}

/// Sides over which waves are averaged: those of cells too coarse to resolve the wavelengths; otherwise 0.
Averaged averaged(double wavelength_x, double wavelength_y, double dx, double dy)
{
  const auto side = [](double wavelength, double cell) { return cell > 0.501 * wavelength ? cell : 0.0; };
  return {side(wavelength_x, dx), side(wavelength_y, dy)};
}

Averaged averaged(const RandomSurface& surface, double dx, double dy)
{
  const double cutoff = surface.parameters().cutoff;
  return averaged(cutoff, cutoff, dx, dy);
}

double cell_depth_of(const Sinusoid& s, double x, double y, double dx, double dy)
{
  const Averaged over = averaged(s.wavelength_x, s.wavelength_y, dx, dy);
  return depth_of(s, x, y) * mean_over_cell(over[0], s.wavelength_x) * mean_over_cell(over[1], s.wavelength_y);
}

double cell_depth_of(const RandomSurface& surface, double x, double y, double dx, double dy)
{
  return -height_of(surface, x, y, averaged(surface, dx, dy));
}

/// Adds depth(x, y) at each cell. Rows are counted from the middle of the grid, so that a symmetry about it is exact.
template <typename Depth>
void add_at_cells(const Depth& depth, const SurfaceGrid& grid, double x0, double y0, std::vector<double>& depths)
{
  const double middle = y0 - grid.y(0);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      depths[grid.index(i, j)] += depth(x0 + i * grid.dx, middle + grid.y(j));
}

template <typename Part>
void add_depths(const Part& part, const SurfaceGrid& grid, double x0, double y0, std::vector<double>& depths)
{
  add_at_cells([&](double x, double y) { return depth_of(part, x, y); }, grid, x0, y0, depths);
}
void add_depths(const RandomSurface& surface, const SurfaceGrid& grid, double x0, double y0,
                std::vector<double>& depths)
{
  add_heights(surface, grid, x0, y0, {}, -1.0, depths);
}

template <typename Part>
void add_cell_depths(const Part& part, const SurfaceGrid& grid, double x0, double y0, std::vector<double>& depths)
{
  add_at_cells([&](double x, double y) { return cell_depth_of(part, x, y, grid.dx, grid.dy); }, grid, x0, y0, depths);
}
void add_cell_depths(const RandomSurface& surface, const SurfaceGrid& grid, double x0, double y0,
                     std::vector<double>& depths)
{
  add_heights(surface, grid, x0, y0, averaged(surface, grid.dx, grid.dy), -1.0, depths);
}

constexpr double everywhere = std::numeric_limits<double>::infinity();

TextureReach reach_of(const Dent& d)
{
  constexpr double shoulder = 0.041; // highest of 10^(-10 r^2) (-cos(2 pi r)), at r = 0.31
  constexpr double end = 2.0;        // edge radii: beyond, less than 4 % of the depth, and falling fast
  return {d.depth > 0.0 ? shoulder * d.depth : -d.depth, std::abs(d.y) + end * d.edge_radius};
}

TextureReach reach_of(const HeightMap& map)
{
  const auto highest = std::max_element(map.heights.begin(), map.heights.end());
  return {highest == map.heights.end() ? 0.0 : std::max(0.0, *highest),
          map.periodic ? everywhere : std::abs(map.y) + 0.5 * (map.ny + 1) * map.dy};
}

TextureReach reach_of(const Sinusoid& s)
{
  return {std::abs(s.amplitude), everywhere};
}

TextureReach reach_of(const RandomSurface& surface)
{
  return {highest_point(surface), everywhere};
}

/// Whether a size is a whole number of periods; an infinite one is.
bool holds_periods(double size, double period)
{
  if (std::isinf(size))
    return true;
  constexpr double rounding = 1e-9;
  const double count = size / period;
  const double nearest = std::round(count);
  return nearest >= 1.0 && std::abs(count - nearest) <= rounding * nearest;
}

using Reason = std::optional<std::string>; ///< why a part does not repeat; none: it does

Reason against_periods(const char* what, double period_x, double period_y, double size_x, double size_y)
{
  if (holds_periods(size_x, period_x) && holds_periods(size_y, period_y))
    return std::nullopt;
  return fmt::format("{} of {:g} x {:g} m does not go a whole number of times into {:g} x {:g} m", what, period_x,
                     period_y, size_x, size_y);
}

Reason against(const Dent& d, double, double)
{
  return fmt::format("a {} does not repeat", d.depth < 0.0 ? "bump" : "dent");
}

Reason against(const HeightMap& map, double size_x, double size_y)
{
  if (!map.periodic)
    return "the height map is zero outside; periodic = true lets it repeat";
  return against_periods("the height map", map.nx * map.dx, map.ny * map.dy, size_x, size_y);
}

Reason against(const Sinusoid& s, double size_x, double size_y)
{
  for (const auto& [size, wavelength] : {std::pair{size_x, s.wavelength_x}, {size_y, s.wavelength_y}})
    if (std::isfinite(wavelength) && !holds_periods(size, wavelength))
      return fmt::format("the wavelength of {:g} m does not go a whole number of times into {:g} m", wavelength, size);
  return std::nullopt;
}

Reason against(const RandomSurface& surface, double size_x, double size_y)
{
  const SelfAffine& p = surface.parameters();
  return against_periods("the random surface", p.size_x, p.size_y, size_x, size_y);
}

} // namespace

double depth(const Texture& texture, double x, double y)
{
  double sum = 0.0;
  for (const TexturePart& part : texture.parts)
    sum += std::visit([&](const auto& p) { return depth_of(p, x, y); }, part);
  return sum;
}

double cell_depth(const Texture& texture, double x, double y, double dx, double dy)
{
  double sum = 0.0;
  for (const TexturePart& part : texture.parts)
    sum += std::visit([&](const auto& p) { return cell_depth_of(p, x, y, dx, dy); }, part);
  return sum;
}

std::vector<double> depths(const Texture& texture, const SurfaceGrid& grid, double x0, double y0)
{
  std::vector<double> sum(grid.size(), 0.0);
  for (const TexturePart& part : texture.parts)
    std::visit([&](const auto& p) { add_depths(p, grid, x0, y0, sum); }, part);
  return sum;
}

std::vector<double> cell_depths(const Texture& texture, const SurfaceGrid& grid, double x0, double y0)
{
  std::vector<double> sum(grid.size(), 0.0);
  for (const TexturePart& part : texture.parts)
    std::visit([&](const auto& p) { add_cell_depths(p, grid, x0, y0, sum); }, part);
  return sum;
}

bool is_periodic(const Texture& texture, double size_x, double size_y)
{
  return !reason_against_period(texture, size_x, size_y);
}

std::optional<std::string> reason_against_period(const Texture& texture, double size_x, double size_y)
{
  for (std::size_t i = 0; i < texture.parts.size(); ++i)
    if (const Reason reason = std::visit([&](const auto& p) { return against(p, size_x, size_y); }, texture.parts[i]))
      return fmt::format("texture{}: {}", texture.parts.size() > 1 ? fmt::format("[{}]", i) : "", *reason);
  return std::nullopt;
}

TextureReach reach(const Texture& texture)
{
  TextureReach sum;
  for (const TexturePart& part : texture.parts)
  {
    const TextureReach of_part = std::visit([](const auto& p) { return reach_of(p); }, part);
    sum.height += of_part.height;
    sum.half_width_y = std::max(sum.half_width_y, of_part.half_width_y);
  }
  return sum;
}

HeightMap sampled(const std::function<double(double, double)>& height, int nx, int ny, double dx, double dy, double x,
                  double y)
{
  if (nx < 1 || ny < 1 || !(dx > 0.0) || !(dy > 0.0))
    throw InputError(fmt::format("sampled: {} x {} points at distances of {:g} x {:g} m; allowed: one point or more, "
                                 "distances > 0",
                                 nx, ny, dx, dy));
  HeightMap map{nx, ny, dx, dy, x, y, {}};
  map.heights.reserve(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny));
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i)
    {
      const double at_x = x + (i - 0.5 * (nx - 1)) * dx;
      const double at_y = y + (j - 0.5 * (ny - 1)) * dy;
      map.heights.push_back(height(at_x, at_y));
      if (!std::isfinite(map.heights.back()))
        throw InputError(
            fmt::format("sampled: the height at x = {:g} m, y = {:g} m is {}; allowed: finite numbers, in m", at_x,
                        at_y, map.heights.back()));
    }
  return map;
}

} // namespace brinell::simulation
