// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/return_mapping.hpp"
#include "foundation/lanes.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <type_traits>

/// Return mapping of several points at once, one per lane, for laws for which it has a closed-form solution.
namespace brinell::constitutive
{

/// Laws whose yield stress is linear in the plastic strain.
template <typename Law>
inline constexpr bool is_linear = std::is_same_v<Law, PerfectPlasticity> || std::is_same_v<Law, LinearHardening>;

/// Arguments and results of `path_return`, for one point per lane.
struct LanePoints
{
  using Deviators = std::array<Lanes, Deviator::size>;
  Deviators start{}, trial{};        ///< stress deviator before the increment, trial deviator [Pa]
  Lanes yield{}, modulus{};          ///< yield stress before the increment, its slope [Pa]
  Deviators strain{};                ///< plastic strain of the increment
  Lanes equivalent{}, dissipation{}; ///< equivalent of this strain, and plastic work [J/m^3]

  void set(std::size_t lane, const Deviator& before, const Deviator& q, double yield_stress, double slope);
  [[nodiscard]] PlasticIncrement increment(std::size_t lane) const;
};

inline void LanePoints::set(std::size_t lane, const Deviator& before, const Deviator& q, double yield_stress,
                            double slope)
{
  for (std::size_t c = 0; c < Deviator::size; ++c)
  {
    start[c][lane] = before.v[c];
    trial[c][lane] = q.v[c];
  }
  yield[lane] = yield_stress;
  modulus[lane] = slope;
}

inline PlasticIncrement LanePoints::increment(std::size_t lane) const
{
  PlasticIncrement result;
  for (std::size_t c = 0; c < Deviator::size; ++c)
    result.strain.v[c] = strain[c][lane];
  result.equivalent = equivalent[lane];
  result.dissipation = dissipation[lane];
  return result;
}

namespace detail
{

inline Lanes root(const Lanes& of)
{
  alignas(Lanes) std::array<double, lane_count> value;
  std::memcpy(value.data(), &of, sizeof of);
#pragma omp simd
  for (std::size_t lane = 0; lane < lane_count; ++lane)
    value[lane] = std::sqrt(value[lane]);
  Lanes result;
  std::memcpy(&result, value.data(), sizeof result);
  return result;
}

inline Lanes contract(const LanePoints::Deviators& a, const LanePoints::Deviators& b)
{
  using D = Deviator;
  return 2.0 * (a[D::xx] * b[D::xx] + a[D::yy] * b[D::yy] + a[D::yz] * b[D::yz] + a[D::xz] * b[D::xz] +
                a[D::xy] * b[D::xy]) +
         a[D::xx] * b[D::yy] + a[D::yy] * b[D::xx];
}

/// a + f b
inline LanePoints::Deviators sum(const LanePoints::Deviators& a, const Lanes& f, const LanePoints::Deviators& b)
{
  LanePoints::Deviators result;
  for (std::size_t c = 0; c < Deviator::size; ++c)
    result[c] = a[c] + f * b[c];
  return result;
}

} // namespace detail

/// Lanes in which the trial deviator lies outside the yield surface, or is NaN.
[[nodiscard]] inline auto is_outside(const LanePoints& p)
{
  return !(1.5 * detail::contract(p.trial, p.trial) - p.yield * p.yield <= 0.0);
}

/// `path_return` of all lanes. With the yield stress Y + H x its condition |q - mu x n0| = Y + (3/2 mu + H) x is quadratic in x,
///     D - b x - H (3 mu + H) x^2 = 0,  D = |q|^2 - Y^2,  b = 3 mu (q : n0 + Y) + 2 Y H.
inline void path_return(LanePoints& p, double mu)
{
  const Lanes zero{};
  const Lanes square = 1.5 * detail::contract(p.trial, p.trial);
  const Lanes outside = square - p.yield * p.yield; // D
  // Where the straight path leaves the yield surface, as in `yield_crossing`.
  const LanePoints::Deviators way = detail::sum(p.trial, zero - 1.0, p.start);
  const Lanes dd = 1.5 * detail::contract(way, way);
  const Lanes sd = 1.5 * detail::contract(p.start, way);
  const Lanes ss = 1.5 * detail::contract(p.start, p.start) - p.yield * p.yield;
  const Lanes under = sd * sd - dd * ss;
  const Lanes crossing = (detail::root(under > 0.0 ? under : zero) - sd) / dd;
  const Lanes above = crossing > 0.0 ? crossing : zero;
  const LanePoints::Deviators entry = detail::sum(p.start, above < 1.0 ? above : zero + 1.0, way);
  const Lanes to_normal = 1.5 / detail::root(1.5 * detail::contract(entry, entry));
  const Lanes b = 3.0 * mu * (to_normal * detail::contract(p.trial, entry) + p.yield) + 2.0 * p.yield * p.modulus;
  const Lanes x = 2.0 * outside / (b + detail::root(b * b + 4.0 * p.modulus * (3.0 * mu + p.modulus) * outside));
  const LanePoints::Deviators r = detail::sum(p.trial, -mu * x * to_normal, entry);
  const Lanes to_end = (p.yield + p.modulus * x) / detail::root(1.5 * detail::contract(r, r));
  const auto flows = !(outside <= 0.0);
  LanePoints::Deviators mean = entry;
  for (std::size_t c = 0; c < Deviator::size; ++c)
  {
    const Lanes end = to_end * r[c];
    mean[c] += end;
    p.strain[c] = flows ? (0.5 / mu) * (p.trial[c] - end) : zero;
  }
  p.equivalent = flows ? x : zero;
  p.dissipation = flows ? 0.5 * detail::contract(mean, p.strain) : zero;
}

} // namespace brinell::constitutive
