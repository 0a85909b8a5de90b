// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdio>
#include <vector>

namespace brinell::test
{

/// Orders of convergence seen on several grids, each `ratio` times finer than the one before; printed when made.
struct Orders
{
  double overall =
      0.0; ///< between the first and the last: for an error that jumps with the cells an edge happens to touch
  double last = 0.0; ///< between the last two: for a smooth error whose first grid is too coarse to show the order

  Orders(const char* what, const std::vector<double>& errors, double ratio = 2.0)
  {
    const std::size_t n = errors.size();
    const auto order = [&](std::size_t a, std::size_t b)
    { return std::log(std::abs(errors[a] / errors[b])) / (static_cast<double>(b - a) * std::log(ratio)); };
    overall = order(0, n - 1);
    last = order(n - 2, n - 1);
    std::printf("%-44s", what);
    for (const double e : errors)
      std::printf(" %9.2e", e);
    std::printf("   order %.2f, last %.2f\n", overall, last);
  }
};

} // namespace brinell::test
