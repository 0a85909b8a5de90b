// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/shape.hpp"

#include "brinell/foundation/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>

namespace brinell::simulation
{

namespace
{

struct Vector
{
  double x = 0.0, y = 0.0;
};

/// The point nearest to p of the regular polygon whose corners have the distance `radius` from the origin, the first one on
/// the x axis.
Vector nearest_in_polygon(Vector p, int corners, double radius)
{
  const double sector = 2.0 * std::numbers::pi / corners;
  const double inradius = radius * std::cos(0.5 * sector);
  const double turn = sector * (std::floor(std::atan2(p.y, p.x) / sector) + 0.5); // the middle of an edge
  const double along = p.x * std::cos(turn) + p.y * std::sin(turn);
  const double across = p.y * std::cos(turn) - p.x * std::sin(turn);
  const double half_edge = inradius * std::tan(0.5 * sector);
  if (along <= inradius)
    return p;
  const double side = std::clamp(across, -half_edge, half_edge);
  return {inradius * std::cos(turn) - side * std::sin(turn), inradius * std::sin(turn) + side * std::cos(turn)};
}

Vector nearest_in_disc(Vector p, double radius)
{
  const double r = std::hypot(p.x, p.y);
  const double scale = r > radius ? radius / r : 1.0;
  return {p.x * scale, p.y * scale};
}

/// Height of a convex surface whose slopes fill the set G, rounded by a ball (a paraboloid) of radius R: the largest of
/// g.x - R |g|^2/2 over g in G, taken at the point of G nearest to x/R; for R = 0 that is far away.
template <typename Nearest>
double rounded_height(double x, double y, double R, double far, const Nearest& nearest)
{
  const double r = std::hypot(x, y);
  if (r == 0.0)
    return 0.0;
  const double scale = R > 0.0 ? 1.0 / R : far / r;
  const Vector g = nearest(Vector{x * scale, y * scale});
  return g.x * x + g.y * y - 0.5 * R * (g.x * g.x + g.y * g.y);
}

double height_of(const Plane&, double, double)
{
  return 0.0;
}

double height_of(const Paraboloid& p, double x, double y)
{
  return 0.5 * (x * x / p.radius_x + y * y / p.radius_y);
}

double height_of(const Roller& r, double x, double y)
{
  const double side = 0.5 * x * x / r.radius;
  return std::abs(y) <= 0.5 * r.length * (1.0 + 1e-12) ? side : side + 2.0 * r.radius;
}

double height_of(const Cone& c, double x, double y)
{
  const double slope = 1.0 / std::tan(c.half_angle);
  return rounded_height(x, y, c.tip_radius, 2.0 * slope, [&](Vector p) { return nearest_in_disc(p, slope); });
}

double height_of(const Pyramid& p, double x, double y)
{
  const double slope = 1.0 / std::tan(p.face_angle);
  // The slopes of its faces are the corners. Without rounding: so far out that a corner is nearest.
  return rounded_height(x, y, p.tip_radius, 1e9 * slope,
                        [&](Vector v) { return nearest_in_polygon(v, p.faces, slope); });
}

double depth_of(const Smooth&, double, double)
{
  return 0.0;
}

double depth_of(const Dent& d, double x, double y)
{
  const double r = std::hypot(x - d.x, y - d.y) / d.radius;
  return d.depth * std::pow(10.0, -10.0 * r * r) * std::cos(2.0 * std::numbers::pi * r);
}

double depth_of(const HeightMap& map, double x, double y)
{
  const double u = (x - map.x) / map.dx + 0.5 * (map.nx - 1);
  const double v = (y - map.y) / map.dy + 0.5 * (map.ny - 1);
  if (!(u > -1.0 && u < map.nx && v > -1.0 && v < map.ny))
    return 0.0;
  const auto i = static_cast<int>(std::floor(u));
  const auto j = static_cast<int>(std::floor(v));
  const auto at = [&](int column, int row)
  {
    const bool inside = column >= 0 && column < map.nx && row >= 0 && row < map.ny;
    return inside ? map.heights[static_cast<std::size_t>(column) +
                                static_cast<std::size_t>(map.nx) * static_cast<std::size_t>(row)]
                  : 0.0;
  };
  const double s = u - i;
  const double t = v - j;
  return -((1.0 - t) * ((1.0 - s) * at(i, j) + s * at(i + 1, j)) +
           t * ((1.0 - s) * at(i, j + 1) + s * at(i + 1, j + 1)));
}

/// Points along x and y of a cell at which a texture has to be read; one is enough where the cells resolve it.
std::array<int, 2> samples(const Smooth&, double, double)
{
  return {1, 1};
}

std::array<int, 2> samples_of(double length_x, double length_y, double dx, double dy)
{
  constexpr double most = 100.0; // beyond, the mean changes no more
  const auto count = [&](double length, double cell)
  { return cell > 1.001 * length ? static_cast<int>(std::min(most, std::ceil(2.0 * cell / length))) : 1; };
  return {count(length_x, dx), count(length_y, dy)};
}

std::array<int, 2> samples(const Dent& d, double dx, double dy)
{
  return samples_of(0.25 * d.radius, 0.25 * d.radius, dx, dy); // of its hollow
}

std::array<int, 2> samples(const HeightMap& map, double dx, double dy)
{
  return samples_of(map.dx, map.dy, dx, dy);
}

TextureReach reach_of(const Smooth&)
{
  return {};
}

TextureReach reach_of(const Dent& d)
{
  constexpr double shoulder = 0.041; // highest of 10^(-10 r^2) (-cos(2 pi r)), at r = 0.31
  constexpr double end = 0.5;        // of the radius: beyond, less than 4 % of the depth, and falling fast
  return {d.depth > 0.0 ? shoulder * d.depth : -d.depth, std::abs(d.y) + end * d.radius};
}

TextureReach reach_of(const HeightMap& map)
{
  const auto highest = std::max_element(map.heights.begin(), map.heights.end());
  return {highest == map.heights.end() ? 0.0 : std::max(0.0, *highest), std::abs(map.y) + 0.5 * (map.ny + 1) * map.dy};
}

} // namespace

std::optional<std::array<double, 2>> curvature(const Shape& shape)
{
  if (std::holds_alternative<Plane>(shape))
    return std::array{0.0, 0.0};
  if (const auto* p = std::get_if<Paraboloid>(&shape))
    return std::array{1.0 / p->radius_x, 1.0 / p->radius_y};
  if (const auto* r = std::get_if<Roller>(&shape))
    return std::array{1.0 / r->radius, 0.0};
  return std::nullopt;
}

std::optional<std::array<double, 2>> relative_curvature(const Shape& lower, const Shape& upper)
{
  const auto a = curvature(lower);
  const auto b = curvature(upper);
  if (!a || !b)
    return std::nullopt;
  return std::array{(*a)[0] + (*b)[0], (*a)[1] + (*b)[1]};
}

std::optional<double> equivalent_radius(const Shape& lower, const Shape& upper)
{
  constexpr double rounding = 1e-12;
  const auto k = relative_curvature(lower, upper);
  if (!k || !((*k)[0] > 0.0) || !(std::abs((*k)[0] - (*k)[1]) < rounding * (*k)[0]))
    return std::nullopt;
  return 1.0 / (*k)[0];
}

bool contact_is_finite(const Shape& lower, const Shape& upper)
{
  const auto k = relative_curvature(lower, upper);
  if (!k) // a tip
    return true;
  const bool ends = (*k)[1] == 0.0 && std::isfinite(roller_length(lower, upper));
  return (*k)[0] > 0.0 && ((*k)[1] > 0.0 || ends);
}

double roller_length(const Shape& lower, const Shape& upper)
{
  double length = std::numeric_limits<double>::infinity();
  for (const Shape* shape : {&lower, &upper})
    if (const auto* roller = std::get_if<Roller>(shape))
      length = std::min(length, roller->length);
  return length;
}

double height(const Shape& shape, double x, double y)
{
  return std::visit([&](const auto& s) { return height_of(s, x, y); }, shape);
}

double depth(const Texture& texture, double x, double y)
{
  return std::visit([&](const auto& t) { return depth_of(t, x, y); }, texture);
}

TextureReach reach(const Texture& texture)
{
  return std::visit([](const auto& t) { return reach_of(t); }, texture);
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

double cell_depth(const Texture& texture, double x, double y, double dx, double dy)
{
  const auto [nx, ny] = std::visit([&](const auto& t) { return samples(t, dx, dy); }, texture);
  double sum = 0.0;
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i)
      sum += depth(texture, x + ((i + 0.5) / nx - 0.5) * dx, y + ((j + 0.5) / ny - 0.5) * dy);
  return sum / (nx * ny);
}

} // namespace brinell::simulation
