// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace brinell::halfspace
{

/// Some functions on [-1, 1] by Chebyshev polynomials through their values at the nodes.
template <std::size_t count, std::size_t nodes>
class ChebyshevSeries
{
public:
  using Values = std::array<double, count>;

  /// @returns a point in [-1, 1]
  [[nodiscard]] static double node(std::size_t number) { return cosine(number, 1); }

  ChebyshevSeries() = default; ///< zero
  /// @param values  values(n) at the node n
  template <class F>
  explicit ChebyshevSeries(const F& values)
  {
    for (std::size_t degree = 0; degree < nodes; ++degree)
      for (std::size_t n = 0; n < nodes; ++n)
        for (std::size_t f = 0; f < count; ++f)
          coefficients_[degree][f] +=
              (degree == 0 ? 1.0 : 2.0) / static_cast<double>(nodes) * cosine(n, degree) * values(n)[f];
  }

  /// Clenshaw's recursion.
  [[nodiscard]] Values at(double t) const
  {
    Values b1{}, b2{};
    for (std::size_t degree = nodes; degree-- > 1;)
      for (std::size_t f = 0; f < count; ++f)
      {
        const double b0 = coefficients_[degree][f] + 2.0 * t * b1[f] - b2[f];
        b2[f] = b1[f];
        b1[f] = b0;
      }
    for (std::size_t f = 0; f < count; ++f)
      b1[f] = coefficients_[0][f] + t * b1[f] - b2[f];
    return b1;
  }

private:
  [[nodiscard]] static double cosine(std::size_t node, std::size_t degree)
  {
    return std::cos(std::numbers::pi * static_cast<double>(degree) * (static_cast<double>(node) + 0.5) /
                    static_cast<double>(nodes));
  }

  std::array<Values, nodes> coefficients_{};
};

} // namespace brinell::halfspace
