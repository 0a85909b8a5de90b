// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/heat_source.hpp"

#include "brinell/foundation/error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brinell::elastoplastic
{

namespace
{

using Shape = HeatSource::Shape;

/// Area of a disc about the origin in the rectangle between the origin and (x, y), with the sign of x y.
double disc_area(double radius, double x, double y)
{
  const double width = std::min(std::abs(x), radius), height = std::min(std::abs(y), radius);
  const double sign = (x < 0.0) != (y < 0.0) ? -1.0 : 1.0;
  if (std::hypot(width, height) <= radius)
    return sign * width * height;
  const auto other_leg = [radius](double leg) // 0 or more, whatever the rounding
  { return std::sqrt(std::max(0.0, (radius - leg) * (radius + leg))); };
  const auto below_arc = [&](double to)
  { return 0.5 * (to * other_leg(to) + radius * radius * std::asin(to / radius)); };
  const double cut = other_leg(height); // where the arc falls below the rectangle
  return sign * (height * cut + below_arc(width) - below_arc(cut));
}

/// Area of a rectangle about the origin, of which half the sides are given, between the axes and the point; signed as xy.
double rectangle_area(double half_x, double half_y, double x, double y)
{
  return std::clamp(x, -half_x, half_x) * std::clamp(y, -half_y, half_y);
}

} // namespace

SourceReach reach(const HeatSource& source)
{
  if (source.shape == Shape::disc)
    return {std::abs(source.offset) + *source.radius, *source.radius};
  if (source.shape == Shape::rectangle)
    return {std::abs(source.offset) + 0.5 * *source.length, 0.5 * source.width.value_or(0.0)};
  return {};
}

std::vector<double> flux_on(const HeatSource& source, const SurfaceGrid& contact)
{
  std::vector<double> flux(contact.size(), 0.0);
  if (!source.is_on_body())
    return flux;
  constexpr double rounding = 1.0 + 1e-9;
  const double half_x = 0.5 * contact.nx * contact.dx, half_y = 0.5 * contact.ny * contact.dy;
  if (const SourceReach most = reach(source); most.x > half_x * rounding || most.y > half_y * rounding)
    throw InternalError("HeatSource: a part lies beyond the contact grid");
  const bool is_disc = source.shape == Shape::disc;
  const double breadth = is_disc ? 0.0 : 0.5 * source.width.value_or(2.0 * half_y);
  const auto area = [&](double x, double y)
  { return is_disc ? disc_area(*source.radius, x, y) : rectangle_area(0.5 * *source.length, breadth, x, y); };
  const double whole = is_disc ? std::numbers::pi * *source.radius * *source.radius : 2.0 * *source.length * breadth;
  const double value = source.power ? *source.power / whole : source.flux.value();
  for (int j = 0; j < contact.ny; ++j)
    for (int i = 0; i < contact.nx; ++i)
    {
      const double left = contact.x(i) - source.offset - 0.5 * contact.dx, right = left + contact.dx;
      const double front = contact.y(j) - 0.5 * contact.dy, back = front + contact.dy;
      const double covered = area(right, back) - area(left, back) - area(right, front) + area(left, front);
      flux[contact.index(i, j)] = value * std::max(0.0, covered) / contact.cell_area();
    }
  return flux;
}

} // namespace brinell::elastoplastic
