// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gauss.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

/// Temperature rises under heat sources that have always moved over a half space, by quadrature of the moving point source.
namespace brinell::test
{

/// A rise [K] and where it is, ahead of the middle of the source [m].
struct Peak
{
  double rise = 0.0, place = 0.0;
};

/// A heat source on the surface, symmetric about the line y = 0: what a ray from a place on that line meets of it.
struct UniformRectangle
{
  double half_x, half_y, flux; ///< [m], [m], [W/m^2]
  /// Integral of the flux times e^{-decay r} over the distance r from the place.
  /// @param angle  of the ray from the motion, 0 to pi
  [[nodiscard]] double along_ray(double x, double angle, double decay) const
  {
    const double c = std::cos(angle), s = std::sin(angle);
    const double way = std::max(0.0, std::min(((c > 0.0 ? half_x : -half_x) - x) / c, half_y / s));
    return flux * (decay * way > 1e-12 ? -std::expm1(-decay * way) / decay : way);
  }
  /// Directions of the corners.
  [[nodiscard]] std::vector<double> corners(double x) const
  {
    return {std::atan2(half_y, half_x - x), std::atan2(half_y, -half_x - x)};
  }
  [[nodiscard]] double size() const { return half_x; }
};

struct UniformDisc
{
  double radius, flux;
  [[nodiscard]] double along_ray(double x, double angle, double decay) const
  {
    const double s = std::sin(angle);
    const double way = std::max(0.0, -x * std::cos(angle) + std::sqrt(radius * radius - x * x * s * s));
    return flux * (decay * way > 1e-12 ? -std::expm1(-decay * way) / decay : way);
  }
  [[nodiscard]] std::vector<double> corners(double) const { return {0.5 * std::numbers::pi}; }
  [[nodiscard]] double size() const { return radius; }
};

/// flux sqrt(1 - x^2/a^2 - y^2/b^2) (1 - tilt x/a).
struct HertzianFlux
{
  double a, b, flux, tilt = 0.0;
  [[nodiscard]] double along_ray(double x, double angle, double decay) const
  {
    const double c = std::cos(angle), s = std::sin(angle);
    const double square = c * c / (a * a) + s * s / (b * b), linear = x * c / (a * a), at_place = x * x / (a * a) - 1.0;
    const double root = std::sqrt(linear * linear - square * at_place);
    const double end = (-linear + root) / square, begin = (-linear - root) / square; // of the chord; begin <= 0 <= end
    // In the root of the way from the rim the flux is smooth; e^{-decay r} is resolved piece by piece.
    double sum = 0.0, last = 0.0;
    for (const double ways : {1.0, 3.0, 7.0, 15.0, 40.0})
    {
      const double next = decay * end < ways ? end : ways / decay;
      const Gauss w(10, std::sqrt(1.0 - next / end), std::sqrt(1.0 - last / end));
      for (std::size_t n = 0; n < w.point.size(); ++n)
      {
        const double r = end * (1.0 - w.point[n] * w.point[n]);
        const double pressure = std::sqrt(square * end * (r - begin)) * w.point[n];
        sum += w.weight[n] * 2.0 * end * w.point[n] * pressure * (1.0 - tilt * (x + r * c) / a) * std::exp(-decay * r);
      }
      if (next >= end)
        break;
      last = next;
    }
    return flux * sum;
  }
  [[nodiscard]] std::vector<double> corners(double) const { return {0.5 * std::numbers::pi}; }
  [[nodiscard]] double size() const { return a; }
};

/// Rise at (x, 0) under a source that has moved along +x for ever: Jaeger's (1942) point source, e^{-slowness (r + ahead)}/(2 pi K r)
/// with the distance `ahead` of the place before the point, over the source. About the place, in polar coordinates, 1/r drops out.
/// @param slowness  V/(2 kappa) [1/m], >= 0
template <typename Source>
double moving_rise(const Source& source, double x, double slowness, double conductivity)
{
  // The wake is narrow about the direction of the motion: sqrt(1/slowness) wide.
  const double narrowest = 0.05 / std::sqrt(1.0 + slowness * source.size());
  std::vector<double> ends = source.corners(x);
  ends.push_back(0.0);
  for (double angle = std::numbers::pi; angle > narrowest; angle *= 0.8)
    ends.push_back(angle);
  std::sort(ends.begin(), ends.end());
  double sum = 0.0;
  for (std::size_t e = 0; e + 1 < ends.size(); ++e)
    if (ends[e + 1] > ends[e])
    {
      const Gauss angle(10, ends[e], ends[e + 1]);
      for (std::size_t n = 0; n < angle.point.size(); ++n)
      {
        const double half_sine = std::sin(0.5 * angle.point[n]);
        sum += angle.weight[n] * source.along_ray(x, angle.point[n], 2.0 * slowness * half_sine * half_sine);
      }
    }
  return sum / (std::numbers::pi * conductivity); // both sides of y = 0
}

/// The largest value of rise(x) between two places, by golden section, of a function that first rises and then falls.
template <typename Rise>
Peak largest_rise(double from, double to, Rise rise)
{
  constexpr double golden = 0.6180339887498949;
  while (to - from > 1e-6 * (std::abs(to) + std::abs(from)))
  {
    const double left = to - golden * (to - from), right = from + golden * (to - from);
    if (rise(left) < rise(right))
      from = left;
    else
      to = right;
  }
  const double place = 0.5 * (from + to);
  return {rise(place), place};
}

/// Largest rise under a moving source.
template <typename Source>
Peak largest_moving_rise(const Source& source, double slowness, double conductivity)
{
  return largest_rise(-source.size(), source.size(),
                      [&](double x) { return moving_rise(source, x, slowness, conductivity); });
}

/// Rise at x under a uniform flux on |x| < half_width that has moved along +x for ever, in plane conduction: Jaeger's (1942) moving
/// line, e^{-u} K_0(|u|)/(pi K) with u = slowness times the distance ahead, in closed form.
inline double moving_strip_rise(double x, double half_width, double flux, double slowness, double conductivity)
{
  // From 0 on, the integral of e^{-u} K_0(|u|), as the derivative of u e^{-u} (K_0 - K_1) is e^{-u} K_0, and that of v e^v (K_0 + K_1)
  // is e^v K_0.
  const auto from_zero = [](double u)
  {
    if (u == 0.0)
      return 0.0;
    const double k0 = std::cyl_bessel_k(0.0, std::abs(u)), k1 = std::cyl_bessel_k(1.0, std::abs(u));
    return 1.0 + u * std::exp(-u) * (u > 0.0 ? k0 - k1 : k0 + k1);
  };
  return flux / (std::numbers::pi * conductivity * slowness) *
         (from_zero(slowness * (x + half_width)) - from_zero(slowness * (x - half_width)));
}

} // namespace brinell::test
