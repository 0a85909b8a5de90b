// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <random>
#include <vector>

namespace brinell::test
{

/// `size` values, uniform in [low, high), the same for the same seed on every machine.
inline std::vector<double> random_field(std::size_t size, unsigned seed, double low = -1.0, double high = 1.0)
{
  // std::uniform_real_distribution is not the same in every library, the engine is.
  std::mt19937_64 engine(seed);
  std::vector<double> field(size);
  for (double& value : field)
    value = low + (high - low) * (static_cast<double>(engine() >> 11) * 0x1p-53);
  return field;
}

inline double dot(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return sum;
}

} // namespace brinell::test
