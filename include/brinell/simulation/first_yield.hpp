// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/reference/coated_contact.hpp"
#include "brinell/reference/critical.hpp"
#include "brinell/simulation/scenario.hpp"

#include <optional>
#include <string>

/// First yield of a pair of bodies. Because materials may change with depth there are two kinds of values. Nominal values use the
/// yield stress of the hardening law without its profile over depth; they are the units of normalised results (Boucly, Nelias,
/// Green 2006, Eqs. 24-28). Earliest values use the smallest yield stress at any depth, and include friction: below them nothing
/// yields (initial stresses apart), however deep the softest layer lies. Grids, tolerances and warnings use the earliest values.
/// Without profiles and friction both kinds are equal.
namespace brinell::simulation
{

/// Which body yields first in their normal contact: the one with the smaller C(nu) S_y.
enum class YieldsFirst
{
  lower,
  upper,
  both
};

/// Kind of contact of smooth bodies, as far as first yield is concerned.
enum class ContactKind
{
  point, ///< point contact, and every other contact that is not an infinite line
  line   ///< infinite cylinders, in plane strain
};

[[nodiscard]] ContactKind contact_kind(const Shape& lower, const Shape& upper, const Domain& domain);

/// First yield of an elastic contact: at the peak pressure C(nu) S_y of the weaker body.
struct PairYield
{
  double pressure_ratio =
      0.0; ///< C of the weaker body: Green's (2005) fit for a point contact; exact for a line, and with friction
  double yield_stress = 0.0; ///< S_y of the weaker body [Pa]
  YieldsFirst body = YieldsFirst::both;

  [[nodiscard]] double peak_pressure() const { return pressure_ratio * yield_stress; } ///< [Pa]
};

/// Nominal first yield. Empty if both bodies stay elastic.
[[nodiscard]] std::optional<PairYield> nominal_yield(const constitutive::Material& lower,
                                                     const constitutive::Material& upper, ContactKind kind);

/// Earliest first yield. Empty if both bodies stay elastic.
/// @param friction  coefficient of sliding surfaces: shear makes the bodies yield earlier, from about 0.3 on at the surface.
[[nodiscard]] std::optional<PairYield> earliest_yield(const constitutive::Material& lower,
                                                      const constitutive::Material& upper, ContactKind kind,
                                                      double friction);

/// First yield of the normal contact of two smooth bodies, in a point or along a line.
struct FirstYield
{
  reference::CriticalValues critical;
  YieldsFirst body = YieldsFirst::both;
  std::optional<reference::Line> line{}; ///< for cylinders only
};

/// Why these bodies have no critical values in closed form; empty if they have.
[[nodiscard]] std::optional<std::string> reason_against_first_yield(const ShapedBody& lower, const ShapedBody& upper,
                                                                    const Domain& domain);

/// Nominal values. Empty if `reason_against_first_yield` gives a reason.
[[nodiscard]] std::optional<FirstYield> nominal_first_yield(const ShapedBody& lower, const ShapedBody& upper,
                                                            const Domain& domain);

/// Earliest values. Empty if `reason_against_first_yield` gives a reason.
/// @param friction  as for `earliest_yield`
[[nodiscard]] std::optional<FirstYield> earliest_first_yield(const ShapedBody& lower, const ShapedBody& upper,
                                                             const Domain& domain, double friction);

/// First yield of round bodies that touch in a point, one of them with layers, by the yield stress at each depth and without
/// friction. The values above are those of the substrates. Empty for other bodies, and where `reference::coated_first_yield` is.
[[nodiscard]] std::optional<reference::CoatedYield> coated_yield(const ShapedBody& lower, const ShapedBody& upper,
                                                                 const Domain& domain);

/// Smallest factor on the yield stress at any depth; 1 without a profile.
[[nodiscard]] double smallest_yield_factor(const constitutive::Material& material);

} // namespace brinell::simulation
