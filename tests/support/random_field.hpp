// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/deviator.hpp"

#include <cstddef>
#include <random>
#include <vector>

namespace brinell::test
{

/// Uniform in [low, high). std::uniform_real_distribution is not the same in every library, the engine is.
inline double uniform(std::mt19937_64& engine, double low, double high)
{
  return low + (high - low) * (static_cast<double>(engine() >> 11) * 0x1p-53);
}

/// `size` values, uniform in [low, high), the same for the same seed on every machine.
inline std::vector<double> random_field(std::size_t size, unsigned seed, double low = -1.0, double high = 1.0)
{
  std::mt19937_64 engine(seed);
  std::vector<double> field(size);
  for (double& value : field)
    value = uniform(engine, low, high);
  return field;
}

/// A deviator of the given von Mises size in a random direction.
inline Deviator random_deviator(unsigned seed, double size)
{
  const std::vector<double> v = random_field(Deviator::size, seed);
  Deviator d;
  for (int c = 0; c < Deviator::size; ++c)
    d[c] = v[static_cast<std::size_t>(c)];
  return (size / von_mises(d)) * d;
}

inline double dot(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return sum;
}

} // namespace brinell::test
