// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/green/surface_terms.hpp"

#include "brinell/green/strip.hpp"
#include "green/scaled_asinh.hpp"

#include <cmath>
#include <numbers>

namespace brinell::green
{
namespace
{

constexpr double pi = std::numbers::pi;

/// Y ln R + X atan(Y/X), continued to the axes.
double tilt(double X, double Y)
{
  const double logarithm = Y == 0.0 ? 0.0 : Y * std::log(std::hypot(X, Y));
  return X == 0.0 ? logarithm : logarithm + X * std::atan(Y / X);
}

} // namespace

SurfaceTerms rectangle_surface_corner(double X, double Y)
{
  return {scaled_asinh(Y, X), scaled_asinh(X, Y), -std::hypot(X, Y), tilt(X, Y), tilt(Y, X)};
}

SurfaceTerms rectangle_surface_terms(double x, double y, double dx, double dy)
{
  const double left = x - 0.5 * dx, right = x + 0.5 * dx;
  const double front = y - 0.5 * dy, back = y + 0.5 * dy;
  const SurfaceTerms rb = rectangle_surface_corner(right, back), lb = rectangle_surface_corner(left, back);
  const SurfaceTerms rf = rectangle_surface_corner(right, front), lf = rectangle_surface_corner(left, front);
  SurfaceTerms terms{};
  for (std::size_t t = 0; t < terms.size(); ++t)
    terms[t] = rb[t] - lb[t] - rf[t] + lf[t];
  return terms;
}

SurfaceTerms strip_surface_edge(double X, double reference)
{
  // The integral of x^2/r^3 along a line is 2 for any point: a constant, which the choice of the reference absorbs.
  return {0.0, strip_displacement_edge(X, reference), 0.0, pi * std::abs(X), 0.0};
}

SurfaceTerms surface_wave_terms(double m, double n)
{
  const double k2 = m * m + n * n, f = 2.0 * pi / k2, g = f / std::sqrt(k2);
  return {g * n * n, g * m * m, -g * m * n, -f * m, -f * n};
}

PairConstants pair_constants(const Elastic& body1, const Elastic& body2)
{
  const auto of_body = [](const Elastic& body) -> PairConstants
  {
    const double f = 0.5 / (pi * body.shear_modulus()); // zero for a rigid body
    const double nu = body.poisson_ratio;
    return {f * (1.0 - nu), f * nu, 0.5 * f * (1.0 - 2.0 * nu)};
  };
  const PairConstants a = of_body(body1), b = of_body(body2);
  // Set to zero explicitly: with fused multiply-add, the difference of two equal products need not be exactly zero.
  return {a.normal + b.normal, a.along + b.along, body1 == body2 ? 0.0 : a.coupling - b.coupling};
}

} // namespace brinell::green
