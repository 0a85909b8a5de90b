// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/fatigue.hpp"

#include <array>
#include <span>
#include <vector>

/// Fatigue of several points at once, in single precision: as `FatigueCriterion`, to `lane_tolerance`.
namespace brinell::constitutive
{

inline constexpr int fatigue_lanes = 16;
using FatigueLanes = std::array<float, fatigue_lanes>;

/// The tensor of the deviator xx, yy, yz, xz, xy and a third of the trace.
[[nodiscard]] constexpr SymTensor tensor_of(const std::array<float, 6>& numbers)
{
  const double a = numbers[0], b = numbers[1], third = numbers[5];
  return {a + third, b + third, third - a - b, numbers[2], numbers[3], numbers[4]};
}

/// The cycles of so many points side by side.
struct LaneCycles
{
  /// One number of a stress: deviator xx, yy, yz, xz, xy, a third of the trace [Pa].
  using Stress = std::array<FatigueLanes, 6>;
  std::vector<Stress> stress;
  /// Twice the shear modulus times the deviator of the strain, of which the sixth number is unused; empty: not needed.
  std::vector<Stress> strain;

  [[nodiscard]] SymTensor stress_at(std::size_t point, int lane) const { return tensor(stress[point], lane); }
  [[nodiscard]] SymTensor strain_at(std::size_t point, int lane) const { return tensor(strain[point], lane); }
  [[nodiscard]] static SymTensor tensor(const Stress& numbers, int lane)
  {
    const auto l = static_cast<std::size_t>(lane);
    return tensor_of({numbers[0][l], numbers[1][l], numbers[2][l], numbers[3][l], numbers[4][l], numbers[5][l]});
  }
};

struct LaneFatigue
{
  FatigueLanes orthogonal;            ///< half the range of the shear xz or yz, the larger one [Pa]
  FatigueLanes principal;             ///< largest principal shear [Pa]
  FatigueLanes least_mean, most_mean; ///< hydrostatic stress [Pa]
  FatigueLanes utilisation;           ///< Dang Van and Crossland; other criteria: an upper bound of it
  FatigueLanes slack;                 ///< bound for the error of the utilisation; 0 if that is a bound
};

/// Buffers, kept from call to call.
struct LaneScratch
{
  std::vector<std::array<FatigueLanes, 5>> points;
  std::vector<FatigueLanes> weights, j2;
};

/// @param accepted_shear  error of the shear in the utilisation [Pa] that is accepted, if it is above 0.03 of the amplitude
[[nodiscard]] LaneFatigue fatigue_of(const LaneCycles& cycles, const FatigueCriterion& criterion, LaneScratch& scratch,
                                     double accepted_shear = 0.0);

} // namespace brinell::constitutive
