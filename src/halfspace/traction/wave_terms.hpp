// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

/// Waves along a surface whose amplitudes are functions of the wavenumber, times cosines and sines of multiples of the direction of the
/// wavevector: docs/theory/stacks.md (stack-cells).
namespace brinell::halfspace
{

/// Functions of the wavenumber.
using WaveParts = std::array<double, 6>;
/// Components of a field. Those with odd orders are imaginary in the amplitudes, without the factor i.
using WaveComponents = std::array<double, 6>;

/// A part in a component: factor * part * cos(order * phi), or the sine.
struct WaveTerm
{
  std::size_t component, part;
  int order;
  bool is_sine;
  double factor;
};

/// The terms of a field. A part has one order in all its terms.
using WaveTerms = std::span<const WaveTerm>;

/// cos(order phi) and sin(order phi) from those of phi, for orders 0 ... 3.
[[nodiscard]] inline double circular(int order, bool is_sine, double cosine, double sine)
{
  switch (order)
  {
  case 0:
    return is_sine ? 0.0 : 1.0;
  case 1:
    return is_sine ? sine : cosine;
  case 2:
    return is_sine ? 2.0 * cosine * sine : cosine * cosine - sine * sine;
  default:
    return is_sine ? sine * (3.0 - 4.0 * sine * sine) : cosine * (4.0 * cosine * cosine - 3.0);
  }
}

/// Amplitudes of the components of a wave with the direction (lx, ly).
[[nodiscard]] inline WaveComponents components_of(WaveTerms terms, const WaveParts& parts, double lx, double ly)
{
  WaveComponents sum{};
  for (const WaveTerm& t : terms)
    sum[t.component] += t.factor * parts[t.part] * circular(t.order, t.is_sine, lx, ly);
  return sum;
}

[[nodiscard]] inline double sinc(double x)
{
  return x == 0.0 ? 1.0 : std::sin(x) / x;
}

/// Range of wavenumbers that matter.
struct WaveScales
{
  double decay;           ///< the waves decay as e^{-k decay} [m]
  double reach;           ///< distance beyond which the field is that of the longest waves [m]
  bool is_over_k = false; ///< whether the amplitudes are the parts over k
  WaveParts at_zero{};    ///< parts of the longest waves, if they are over k

  [[nodiscard]] double smallest() const { return 1e-5 / reach; }
  [[nodiscard]] double largest() const { return 30.0 / decay; }
};

/// An interval of a quadrature over wavenumbers, and its half with Gauss points.
struct WaveNodes
{
  std::vector<double> k, weight;
  /// @param distance  at which waves are to be integrated, at most
  WaveNodes(const WaveScales& scales, double distance);
};

} // namespace brinell::halfspace
