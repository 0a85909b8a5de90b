// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/reference/critical.hpp"
#include "brinell/simulation/scenario.hpp"

#include <optional>
#include <string>

/// Where a pair of bodies begins to yield. Materials may change with depth, so there are two answers, side by side here:
/// nominal ones by the yield stress of the hardening law, whatever its profile over depth, the unit of all that is normalised
/// (Boucly, Nelias, Green 2006, Eqs. 24-28); and the earliest ones by the smallest yield stress at any depth, and with friction: up to
/// there nothing yields, but for initial stresses, however deep the softest layer lies. Grids, tolerances and warnings go by these.
/// Without profiles and friction both are the same.
namespace brinell::simulation
{

/// Which body yields first in their normal contact: the one with the smaller C(nu) S_y.
enum class YieldsFirst
{
  lower,
  upper,
  both
};

/// How smooth bodies touch, as far as first yield is concerned.
enum class ContactKind
{
  point, ///< and whatever else is no line without ends
  line   ///< of cylinders without ends, in plane strain
};

[[nodiscard]] ContactKind contact_kind(const Shape& lower, const Shape& upper, const Domain& domain);

/// First yield of an elastic contact: at the peak pressure C(nu) S_y of the weaker body.
struct PairYield
{
  double pressure_ratio =
      0.0; ///< C of the weaker body: Green's (2005) fit of a point contact, exact of a line and with friction
  double yield_stress = 0.0; ///< its S_y [Pa]
  YieldsFirst body = YieldsFirst::both;

  [[nodiscard]] double peak_pressure() const { return pressure_ratio * yield_stress; } ///< [Pa]
};

/// Nominal. Empty if both bodies stay elastic.
[[nodiscard]] std::optional<PairYield> nominal_yield(const constitutive::Material& lower,
                                                     const constitutive::Material& upper, ContactKind kind);

/// Earliest. Empty if both bodies stay elastic.
/// @param friction  of surfaces that slide: their shear brings yield on, and at the surface from about 0.3 on.
[[nodiscard]] std::optional<PairYield> earliest_yield(const constitutive::Material& lower,
                                                      const constitutive::Material& upper, ContactKind kind,
                                                      double friction);

/// First yield of the normal contact of two smooth bodies, in a point or along a line.
struct FirstYield
{
  reference::CriticalValues critical;
  YieldsFirst body = YieldsFirst::both;
  std::optional<reference::Line> line{}; ///< of cylinders
};

/// Why these bodies have no critical values in closed form; empty if they have.
[[nodiscard]] std::optional<std::string> reason_against_first_yield(const ShapedBody& lower, const ShapedBody& upper,
                                                                    const Domain& domain);

/// Nominal. Empty if there is a reason against it.
[[nodiscard]] std::optional<FirstYield> nominal_first_yield(const ShapedBody& lower, const ShapedBody& upper,
                                                            const Domain& domain);

/// Earliest. Empty if there is a reason against it.
/// @param friction  as of `earliest_yield`
[[nodiscard]] std::optional<FirstYield> earliest_first_yield(const ShapedBody& lower, const ShapedBody& upper,
                                                             const Domain& domain, double friction);

/// Smallest factor on the yield stress at any depth; 1 without a profile.
[[nodiscard]] double smallest_yield_factor(const constitutive::Material& material);

} // namespace brinell::simulation
