// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
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
  static constexpr std::size_t nodes = 12; ///< of an interval
  using Values = std::array<double, count>;

  /// Wavenumbers at which the functions must be given.
  [[nodiscard]] static std::vector<double> wavenumbers(double smallest, double largest)
  {
    std::vector<double> result;
    for (double low = smallest; low <= largest; low *= 2.0)
      for (std::size_t n = 0; n < nodes; ++n)
        result.push_back(low * std::exp2(0.5 + 0.5 * cosine(n, 1)));
    return result;
  }

  /// @param values  at these wavenumbers
  RadialTable(double smallest, const std::vector<Values>& values)
      : smallest_(smallest), coefficients_(values.size() / nodes)
  {
    for (std::size_t interval = 0; interval < coefficients_.size(); ++interval)
      for (std::size_t degree = 0; degree < nodes; ++degree)
        for (std::size_t n = 0; n < nodes; ++n)
          for (std::size_t f = 0; f < count; ++f)
            coefficients_[interval][degree][f] += (degree == 0 ? 1.0 : 2.0) / static_cast<double>(nodes) *
                                                  cosine(n, degree) * values[interval * nodes + n][f];
  }

  [[nodiscard]] Values at(double k) const
  {
    const double octave = std::max(std::log2(k / smallest_), 0.0);
    const auto interval = std::min(static_cast<std::size_t>(octave), coefficients_.size() - 1);
    const double twice = 2.0 * (2.0 * (octave - static_cast<double>(interval)) - 1.0);
    const auto& c = coefficients_[interval];
    Values b1{}, b2{};
    for (std::size_t degree = nodes; degree-- > 1;)
      for (std::size_t f = 0; f < count; ++f)
      {
        const double b0 = c[degree][f] + twice * b1[f] - b2[f];
        b2[f] = b1[f];
        b1[f] = b0;
      }
    for (std::size_t f = 0; f < count; ++f)
      b1[f] = c[0][f] + 0.5 * twice * b1[f] - b2[f];
    return b1;
  }

private:
  [[nodiscard]] static double cosine(std::size_t node, std::size_t degree)
  {
    return std::cos(std::numbers::pi * static_cast<double>(degree) * (static_cast<double>(node) + 0.5) /
                    static_cast<double>(nodes));
  }

  double smallest_;
  std::vector<std::array<Values, nodes>> coefficients_;
};

} // namespace brinell::halfspace
