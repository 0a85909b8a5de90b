// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "chebyshev_series.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace brinell::halfspace
{

/// Some functions of the wavenumber, by Chebyshev polynomials in its logarithm on intervals of a factor of two. Functions of
/// waves in layers have their singularities at imaginary wavenumbers, pi/2 away in the logarithm, so that twelve polynomials
/// leave an error of about 1e-11 of the largest value.
template <std::size_t count>
class RadialTable
{
public:
  using Values = std::array<double, count>;

  /// Wavenumbers at which the functions must be given.
  [[nodiscard]] static std::vector<double> wavenumbers(double smallest, double largest)
  {
    std::vector<double> result;
    for (double low = smallest; low <= largest; low *= 2.0)
      for (std::size_t n = 0; n < nodes; ++n)
        result.push_back(low * std::exp2(0.5 + 0.5 * Octave::node(n)));
    return result;
  }

  /// @param values  at these wavenumbers
  RadialTable(double smallest, const std::vector<Values>& values) : smallest_(smallest)
  {
    octaves_.reserve(values.size() / nodes);
    for (std::size_t first = 0; first + nodes <= values.size(); first += nodes)
      octaves_.emplace_back([&](std::size_t n) { return values[first + n]; });
  }

  [[nodiscard]] Values at(double k) const
  {
    const double octave = std::max(std::log2(k / smallest_), 0.0);
    const auto number = std::min(static_cast<std::size_t>(octave), octaves_.size() - 1);
    return octaves_[number].at(2.0 * (octave - static_cast<double>(number)) - 1.0);
  }

private:
  static constexpr std::size_t nodes = 12;
  using Octave = ChebyshevSeries<count, nodes>;

  double smallest_;
  std::vector<Octave> octaves_;
};

} // namespace brinell::halfspace
