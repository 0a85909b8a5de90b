// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/material.hpp"

#include <optional>

/// Where a pair of bodies begins to yield. Materials may change with depth, so there are two answers, side by side here.
namespace brinell::simulation
{

/// Which body yields first in their normal contact: the one with the smaller C(nu) S_y.
enum class YieldsFirst
{
  lower,
  upper,
  both
};

/// First yield of a round elastic contact: at the peak pressure C(nu) S_y of the weaker body.
struct PairYield
{
  double pressure_ratio = 0.0; ///< C(nu) of the weaker body, Green's (2005) fit
  double yield_stress = 0.0;   ///< its S_y [Pa]
  YieldsFirst body = YieldsFirst::both;

  [[nodiscard]] double peak_pressure() const { return pressure_ratio * yield_stress; } ///< [Pa]
};

/// By the yield stress of the hardening law, whatever its profile over depth: the unit in which alpha_c, P_c and U_c are
/// (Boucly, Nelias, Green 2006, Eqs. 24-28). Empty if both bodies stay elastic.
[[nodiscard]] std::optional<PairYield> nominal_yield(const constitutive::Material& lower,
                                                     const constitutive::Material& upper);

/// By the smallest yield stress at any depth: up to that pressure nothing yields, but for initial stresses, however deep the
/// softest layer lies. Grids, tolerances and warnings go by it. The same as the nominal one without profiles.
[[nodiscard]] std::optional<PairYield> earliest_yield(const constitutive::Material& lower,
                                                      const constitutive::Material& upper);

/// Smallest factor on the yield stress at any depth; 1 without a profile.
[[nodiscard]] double smallest_yield_factor(const constitutive::Material& material);

} // namespace brinell::simulation
