// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

namespace brinell::test
{

/// Gauss-Legendre rule of one interval.
struct Gauss
{
  std::vector<double> point, weight;

  /// @param order  number of points; polynomials of degree 2 order - 1 are exact.
  Gauss(int order, double low, double high)
  {
    for (int i = 0; i < order; ++i)
    {
      double t = std::cos(std::numbers::pi * (i + 0.75) / (order + 0.5)), slope = 0.0;
      for (int iteration = 0; iteration < 10; ++iteration) // Newton on Legendre's polynomial
      {
        double p0 = 1.0, p1 = t;
        for (int n = 2; n <= order; ++n)
        {
          const double p2 = ((2 * n - 1) * t * p1 - (n - 1) * p0) / n;
          p0 = p1;
          p1 = p2;
        }
        slope = order * (t * p1 - p0) / (t * t - 1.0);
        t -= p1 / slope;
      }
      point.push_back(0.5 * (low + high) + 0.5 * (high - low) * t);
      weight.push_back((high - low) / ((1.0 - t * t) * slope * slope));
    }
  }
};

/// Integral of f(x, y, z) over a box, by `order` points a side.
template <class F>
double box_integral(int order, double x0, double x1, double y0, double y1, double z0, double z1, F f)
{
  const Gauss gx(order, x0, x1), gy(order, y0, y1), gz(order, z0, z1);
  double sum = 0.0;
  for (int i = 0; i < order; ++i)
    for (int j = 0; j < order; ++j)
      for (int k = 0; k < order; ++k)
        sum += gx.weight[static_cast<std::size_t>(i)] * gy.weight[static_cast<std::size_t>(j)] *
               gz.weight[static_cast<std::size_t>(k)] *
               f(gx.point[static_cast<std::size_t>(i)], gy.point[static_cast<std::size_t>(j)],
                 gz.point[static_cast<std::size_t>(k)]);
  return sum;
}

} // namespace brinell::test
