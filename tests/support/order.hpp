// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <vector>

namespace brinell::test
{

/// Order of convergence between the first and the last of several grids, each `ratio` times finer than the one before;
/// prints what it saw. Over the whole range, because the error of a contact's edge jumps with the cells it happens to
/// touch.
inline double observed_order(const char* what, const std::vector<double>& errors, double ratio = 2.0)
{
  std::printf("%-44s", what);
  for (const double e : errors)
    std::printf(" %9.2e", e);
  const double steps = static_cast<double>(errors.size() - 1);
  const double order = std::log(std::abs(errors.front() / errors.back())) / (steps * std::log(ratio));
  std::printf("   order %.2f\n", order);
  return order;
}

} // namespace brinell::test
