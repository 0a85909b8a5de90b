// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

namespace brinell::constitutive
{

template <std::size_t D>
using Point = std::array<double, D>;

template <std::size_t D>
double squared_distance(const Point<D>& a, const Point<D>& b)
{
  double sum = 0.0;
  for (std::size_t c = 0; c < D; ++c)
    sum += (a[c] - b[c]) * (a[c] - b[c]);
  return sum;
}

template <std::size_t D>
struct Ball
{
  Point<D> centre{};
  double radius = 0.0; ///< all points are within it
};

/// The smallest ball around points. Its centre is the convex combination of points whose weights maximise the variance
/// sum w |p - centre|^2. Pairs of weights are improved, that of the farthest point at the cost of the nearest one that has any
/// (pairwise Frank-Wolfe), until the dual gap certifies the radius to `tolerance` / 2.
/// @param weights  buffer of as many numbers
template <std::size_t D>
Ball<D> smallest_ball(std::span<const Point<D>> points, std::span<double> weights, double tolerance = 1e-5)
{
  Ball<D> ball;
  if (points.empty())
    return ball;
  std::fill(weights.begin(), weights.end(), 0.0);
  weights[0] = 1.0;
  ball.centre = points[0];
  constexpr int most = 2000;
  for (int i = 0; i < most; ++i)
  {
    std::size_t far = 0, near = 0;
    double farthest = -1.0, nearest = std::numeric_limits<double>::infinity(), variance = 0.0;
    for (std::size_t n = 0; n < points.size(); ++n)
    {
      const double d = squared_distance(points[n], ball.centre);
      if (d > farthest)
        farthest = d, far = n;
      if (weights[n] > 0.0 && d < nearest)
        nearest = d, near = n;
      variance += weights[n] * d;
    }
    ball.radius = std::sqrt(farthest);
    if (farthest - variance <= tolerance * farthest)
      break;
    const double apart = squared_distance(points[far], points[near]);
    const double step = std::min(weights[near], 0.5 * (farthest - nearest) / apart);
    weights[far] += step;
    weights[near] -= step;
    for (std::size_t c = 0; c < D; ++c)
      ball.centre[c] += step * (points[far][c] - points[near][c]);
  }
  return ball;
}

} // namespace brinell::constitutive
