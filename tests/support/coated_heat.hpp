// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/green/thermal_stack.hpp"

#include <cmath>
#include <complex>
#include <vector>

/// Heat in a body with one layer, by other functions of the depth and another inversion of Laplace's transform than the engine.
namespace brinell::test
{

/// Function of time from its Laplace transform: Euler's summation (Abate and Whitt 2006), 1e-8 for smooth functions.
template <typename Transform>
double inverse_laplace(double time, Transform transform)
{
  using Real = long double;
  constexpr int terms = 16;
  std::vector<Real> weights(2 * terms + 1, 1.0L);
  weights[0] = 0.5L;
  Real binomial = 1.0L;
  const Real last = std::pow(2.0L, -terms);
  weights[2 * terms] = last;
  for (int n = 1; n < terms; ++n)
  {
    binomial *= static_cast<Real>(terms - n + 1) / n;
    weights[static_cast<std::size_t>(2 * terms - n)] =
        weights[static_cast<std::size_t>(2 * terms - n + 1)] + last * binomial;
  }
  const Real real_part = terms * std::log(10.0L) / 3.0L;
  Real sum = 0.0L;
  for (int n = 0; n <= 2 * terms; ++n)
  {
    const std::complex<Real> p{real_part / time, std::acos(-1.0L) * n / time};
    sum += (n % 2 == 0 ? 1.0L : -1.0L) * weights[static_cast<std::size_t>(n)] * transform(p).real();
  }
  return static_cast<double>(std::pow(10.0L, terms / 3.0L) / time * sum);
}

/// Laplace transform of the temperature of a wave in a layer on a half space, after a unit impulse of heat [K m^2 s/J].
inline std::complex<long double> coated_wave(const ThermalStack& stack, long double k, std::complex<long double> p,
                                             long double depth)
{
  const Thermal &film = stack.layers.front().thermal, &base = stack.substrate;
  const long double h = stack.layers.front().thickness;
  const auto q = std::sqrt(k * k + p / static_cast<long double>(film.diffusivity()));
  const auto below = std::sqrt(k * k + p / static_cast<long double>(base.diffusivity()));
  const auto own = static_cast<long double>(film.conductivity) * q;
  const auto other = static_cast<long double>(base.conductivity) * below;
  const auto at = [&](long double z)
  {
    const auto up = q * (h - z);
    return (own * std::cosh(up) + other * std::sinh(up)) / (own * std::sinh(q * h) + other * std::cosh(q * h)) / own;
  };
  return depth < h ? at(depth) : at(h) * std::exp(-below * (depth - h));
}

/// Temperature of a wave under a unit flux that has acted for a time.
inline double coated_wave_after(const ThermalStack& stack, double k, double time, double depth)
{
  return inverse_laplace(time, [&](std::complex<long double> p) { return coated_wave(stack, k, p, depth) / p; });
}

} // namespace brinell::test
