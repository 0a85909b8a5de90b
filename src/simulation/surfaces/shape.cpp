// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/shape.hpp"

#include <algorithm>
#include <cmath>
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

/// The point nearest to p in the regular polygon whose corners are at the distance `radius` from the origin, the first one on the
/// x axis.
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

/// Height of a convex surface whose slopes fill the set G, rounded by a ball (a paraboloid) of radius R: the maximum of
/// g.x - R |g|^2/2 over g in G, which is attained at the point of G nearest to x/R; for R = 0 the point x/R is at infinity.
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
  // The slopes of the faces are the corners of G. Without rounding, a point so far out is used that a corner is nearest.
  return rounded_height(x, y, p.tip_radius, 1e9 * slope,
                        [&](Vector v) { return nearest_in_polygon(v, p.faces, slope); });
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

} // namespace brinell::simulation
