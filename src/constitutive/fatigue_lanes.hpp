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
  [[nodiscard]] static SymTensor tensor(const Stress& numbers, int lane);
};

struct LaneFatigue
{
  FatigueLanes orthogonal;            ///< half the range of the shear xz or yz, the larger one [Pa]
  FatigueLanes principal;             ///< largest principal shear [Pa]
  FatigueLanes least_mean, most_mean; ///< hydrostatic stress [Pa]
  FatigueLanes utilisation;           ///< Dang Van and Crossland; other criteria: an upper bound of it
};

/// Buffers, kept from call to call.
struct LaneScratch
{
  std::vector<std::array<FatigueLanes, 5>> points;
  std::vector<FatigueLanes> weights, j2;
};

[[nodiscard]] LaneFatigue fatigue_of(const LaneCycles& cycles, const FatigueCriterion& criterion, LaneScratch& scratch);

} // namespace brinell::constitutive
