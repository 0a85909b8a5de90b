// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/return_mapping.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <type_traits>

/// Return mapping in closed form, for laws whose yield stress is linear in the plastic strain. Written for any number: `Real` is a
/// double or several of them in lanes.
namespace brinell::constitutive
{

/// Laws whose yield stress is linear in the plastic strain.
template <typename Law>
inline constexpr bool is_linear = std::is_same_v<Law, PerfectPlasticity> || std::is_same_v<Law, LinearHardening>;

/// Arguments and results of `path_return`, for one point, or for several in lanes.
template <typename Real>
struct PointsOf
{
  using Deviators = std::array<Real, Deviator::size>;
  Deviators start{}, trial{};       ///< stress deviator before the increment, trial deviator [Pa]
  Real yield{}, modulus{};          ///< yield stress before the increment, its slope [Pa]
  Deviators strain{};               ///< plastic strain of the increment
  Real equivalent{}, dissipation{}; ///< equivalent of this strain, and plastic work [J/m^3]
};

namespace detail
{

template <typename Real>
BRINELL_HOST_DEVICE inline Real root(const Real& of)
{
  if constexpr (std::is_same_v<Real, double>)
    return std::sqrt(of);
  else
  {
    constexpr std::size_t lanes = sizeof(Real) / sizeof(double);
    alignas(Real) std::array<double, lanes> value;
    std::memcpy(value.data(), &of, sizeof of);
#pragma omp simd
    for (std::size_t lane = 0; lane < lanes; ++lane)
      value[lane] = std::sqrt(value[lane]);
    Real result;
    std::memcpy(&result, value.data(), sizeof result);
    return result;
  }
}

template <typename Real>
BRINELL_HOST_DEVICE inline Real contract(const std::array<Real, Deviator::size>& a,
                                         const std::array<Real, Deviator::size>& b)
{
  using D = Deviator;
  return 2.0 * (a[D::xx] * b[D::xx] + a[D::yy] * b[D::yy] + a[D::yz] * b[D::yz] + a[D::xz] * b[D::xz] +
                a[D::xy] * b[D::xy]) +
         a[D::xx] * b[D::yy] + a[D::yy] * b[D::xx];
}

/// a + f b
template <typename Real>
BRINELL_HOST_DEVICE inline std::array<Real, Deviator::size>
sum(const std::array<Real, Deviator::size>& a, const Real& f, const std::array<Real, Deviator::size>& b)
{
  std::array<Real, Deviator::size> result;
  for (std::size_t c = 0; c < Deviator::size; ++c)
    result[c] = a[c] + f * b[c];
  return result;
}

} // namespace detail

/// Whether, or lanes in which, the trial deviator lies outside the yield surface, or is NaN.
template <typename Real>
[[nodiscard]] BRINELL_HOST_DEVICE inline auto is_outside(const PointsOf<Real>& p)
{
  return !(1.5 * detail::contract(p.trial, p.trial) - p.yield * p.yield <= 0.0);
}

/// `path_return` of a point, or of all lanes. With the yield stress Y + H x its condition |q - mu x n0| = Y + (3/2 mu + H) x is quadratic in x,
///     D - b x - H (3 mu + H) x^2 = 0,  D = |q|^2 - Y^2,  b = 3 mu (q : n0 + Y) + 2 Y H.
template <typename Real>
BRINELL_HOST_DEVICE inline void path_return(PointsOf<Real>& p, double mu)
{
  using Deviators = typename PointsOf<Real>::Deviators;
  const Real zero{};
  const Real square = 1.5 * detail::contract(p.trial, p.trial);
  const Real outside = square - p.yield * p.yield; // D
  // Where the straight path leaves the yield surface, as in `yield_crossing`.
  const Deviators way = detail::sum(p.trial, zero - 1.0, p.start);
  const Real dd = 1.5 * detail::contract(way, way);
  const Real sd = 1.5 * detail::contract(p.start, way);
  const Real ss = 1.5 * detail::contract(p.start, p.start) - p.yield * p.yield;
  const Real under = sd * sd - dd * ss;
  const Real crossing = (detail::root(under > 0.0 ? under : zero) - sd) / dd;
  const Real above = crossing > 0.0 ? crossing : zero;
  const Deviators entry = detail::sum(p.start, above < 1.0 ? above : zero + 1.0, way);
  const Real to_normal = 1.5 / detail::root(1.5 * detail::contract(entry, entry));
  const Real b = 3.0 * mu * (to_normal * detail::contract(p.trial, entry) + p.yield) + 2.0 * p.yield * p.modulus;
  const Real x = 2.0 * outside / (b + detail::root(b * b + 4.0 * p.modulus * (3.0 * mu + p.modulus) * outside));
  const Deviators r = detail::sum(p.trial, -mu * x * to_normal, entry);
  const Real to_end = (p.yield + p.modulus * x) / detail::root(1.5 * detail::contract(r, r));
  const auto flows = !(outside <= 0.0);
  Deviators mean = entry;
  for (std::size_t c = 0; c < Deviator::size; ++c)
  {
    const Real end = to_end * r[c];
    mean[c] += end;
    p.strain[c] = flows ? (0.5 / mu) * (p.trial[c] - end) : zero;
  }
  p.equivalent = flows ? x : zero;
  p.dissipation = flows ? 0.5 * detail::contract(mean, p.strain) : zero;
}

} // namespace brinell::constitutive
