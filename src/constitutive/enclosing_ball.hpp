// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace brinell::constitutive
{

template <std::size_t D>
using Point = std::array<double, D>;

template <std::size_t D>
double product(const Point<D>& a, const Point<D>& b)
{
  double sum = 0.0;
  for (std::size_t c = 0; c < D; ++c)
    sum += a[c] * b[c];
  return sum;
}

template <std::size_t D>
Point<D> difference(const Point<D>& a, const Point<D>& b)
{
  Point<D> d;
  for (std::size_t c = 0; c < D; ++c)
    d[c] = a[c] - b[c];
  return d;
}

template <std::size_t D>
double squared_distance(const Point<D>& a, const Point<D>& b)
{
  const Point<D> d = difference(a, b);
  return product(d, d);
}

template <std::size_t D>
struct Ball
{
  Point<D> centre{};
  double radius = 0.0; ///< all points are within it
};

/// The points that carry a ball: its centre is their mean with positive weights.
template <std::size_t D>
class Carriers
{
public:
  explicit Carriers(const Point<D>& point) : points_{point}, weights_{1.0}, centre_(point) {}

  [[nodiscard]] const Point<D>& centre() const { return centre_; }
  /// Mean square of the distance from the centre: not above the square of the smallest radius.
  [[nodiscard]] double variance() const
  {
    double sum = 0.0;
    for (std::size_t n = 0; n < count_; ++n)
      sum += weights_[n] * squared_distance(points_[n], centre_);
    return sum;
  }

  /// Takes a point in, and moves to the smallest ball around the carriers; those that it does not need are left out.
  void add(const Point<D>& point)
  {
    points_[count_] = point;
    weights_[count_++] = 0.0;
    while (count_ > 1)
    {
      const Weights wanted = weights_of_equal_distance();
      double step = 1.0;
      for (std::size_t n = 0; n < count_; ++n)
        if (wanted[n] < 0.0)
          step = std::min(step, weights_[n] / (weights_[n] - wanted[n]));
      for (std::size_t n = 0; n < count_; ++n)
        weights_[n] += step * (wanted[n] - weights_[n]);
      const std::size_t before = count_;
      leave_out();
      if (count_ == before)
        break;
    }
    if (count_ == most) // rounding has kept one too many
      leave_out_least();
    centre_ = {};
    for (std::size_t n = 0; n < count_; ++n)
      for (std::size_t c = 0; c < D; ++c)
        centre_[c] += weights_[n] * points_[n][c];
  }

private:
  static constexpr std::size_t most = D + 2; ///< one more than a ball can need
  using Weights = std::array<double, most>;

  /// Weights, of any sign, of the point in the affine hull that is equally far from all: G m = diag(G) / 2 with the products G of the
  /// edges from the first point. Where these are not independent, a small diagonal term leads far away in the direction in which
  /// the variance grows.
  [[nodiscard]] Weights weights_of_equal_distance() const
  {
    constexpr double small = 1e-12;
    const std::size_t n = count_ - 1;
    std::array<Weights, most> g{};
    Weights m{};
    std::array<Point<D>, most> edges{};
    double largest = 0.0;
    for (std::size_t i = 0; i < n; ++i)
    {
      edges[i] = difference(points_[i + 1], points_[0]);
      for (std::size_t j = 0; j <= i; ++j)
        g[i][j] = product(edges[i], edges[j]);
      m[i] = 0.5 * g[i][i];
      largest = std::max(largest, g[i][i]);
    }
    if (largest <= 0.0) // all at one place
      return weights_;
    for (std::size_t i = 0; i < n; ++i) // Cholesky, and forward substitution
    {
      g[i][i] += small * largest;
      for (std::size_t j = 0; j <= i; ++j)
      {
        for (std::size_t k = 0; k < j; ++k)
          g[i][j] -= g[i][k] * g[j][k];
        g[i][j] = i == j ? std::sqrt(std::max(g[i][i], 0.01 * small * largest)) : g[i][j] / g[j][j];
      }
      for (std::size_t k = 0; k < i; ++k)
        m[i] -= g[i][k] * m[k];
      m[i] /= g[i][i];
    }
    for (std::size_t i = n; i-- > 0;)
    {
      for (std::size_t k = i + 1; k < n; ++k)
        m[i] -= g[k][i] * m[k];
      m[i] /= g[i][i];
    }
    Weights result{1.0};
    for (std::size_t i = 0; i < n; ++i)
    {
      result[i + 1] = m[i];
      result[0] -= m[i];
    }
    return result;
  }

  void leave_out()
  {
    constexpr double nothing = 1e-14;
    std::size_t kept = 0;
    for (std::size_t n = 0; n < count_; ++n)
      if (weights_[n] > nothing)
      {
        points_[kept] = points_[n];
        weights_[kept++] = weights_[n];
      }
    count_ = kept;
  }

  void leave_out_least()
  {
    const auto least = static_cast<std::size_t>(std::min_element(weights_.begin(), weights_.end()) - weights_.begin());
    const double others = 1.0 - weights_[least];
    weights_[least] = 0.0;
    for (double& weight : weights_)
      weight /= others;
    leave_out();
  }

  std::array<Point<D>, most> points_{};
  Weights weights_{};
  std::size_t count_ = 1;
  Point<D> centre_;
};

/// The smallest ball around points. Its centre is the convex combination of points whose weights maximise the variance
/// sum w |p - centre|^2: the farthest point joins those that carry the ball, which is then the smallest one around these (as in the
/// method of Wolfe 1976 for the point of least norm), until the variance certifies the radius to `tolerance` / 2.
template <std::size_t D>
Ball<D> smallest_ball(std::span<const Point<D>> points, double tolerance = 1e-5)
{
  Ball<D> ball;
  if (points.empty())
    return ball;
  Carriers<D> carriers(points[0]);
  constexpr int most = 200;
  for (int i = 0; i < most; ++i)
  {
    std::size_t far = 0;
    double farthest = -1.0;
    for (std::size_t n = 0; n < points.size(); ++n)
      if (const double d = squared_distance(points[n], carriers.centre()); d > farthest)
        farthest = d, far = n;
    if (i == 0 || std::sqrt(farthest) < ball.radius)
      ball = {carriers.centre(), std::sqrt(farthest)};
    if (farthest - carriers.variance() <= tolerance * farthest)
      break;
    carriers.add(points[far]);
  }
  return ball;
}

} // namespace brinell::constitutive
