// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace brinell::reference
{

/// Spherical Bessel functions j_0 ... of x >= 0, by recursion in the direction in which they rise (Miller's algorithm downwards).
inline void spherical_bessel(double x, std::span<double> j)
{
  const std::size_t orders = j.size();
  std::fill(j.begin(), j.end(), 0.0);
  if (x < 1e-30) // below, the recursion would overflow
  {
    j[0] = 1.0;
    return;
  }
  const double j0 = std::sin(x) / x;
  if (x > static_cast<double>(orders))
  {
    double before = j0, now = (j0 - std::cos(x)) / x;
    for (std::size_t l = 0; l < orders; ++l)
    {
      j[l] = before;
      const double next = static_cast<double>(2 * l + 3) / x * now - before;
      before = now;
      now = next;
    }
    return;
  }
  constexpr double large = 1e200;
  double above = 0.0, now = 1.0 / large;
  for (std::size_t l = orders + 40 + static_cast<std::size_t>(x); l > 0; --l)
  {
    const double below = static_cast<double>(2 * l + 1) / x * now - above;
    above = now;
    now = below; // j_{l-1} but for a factor
    if (l <= orders)
      j[l - 1] = now;
    if (std::abs(now) > large)
    {
      above /= large;
      now /= large;
      for (double& value : j)
        value /= large;
    }
  }
  const double j1 = (j0 - std::cos(x)) / x; // j_0 and j_1 are never both small
  const double factor = orders < 2 || std::abs(j0) > std::abs(j1) ? j0 / j[0] : j1 / j[1];
  for (double& value : j)
    value *= factor;
}

} // namespace brinell::reference
