// SPDX-License-Identifier: BSD-3-Clause
#include "of_scenario.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace brinell::quality
{

namespace
{

/// Ratio of the width of the slip annulus at the reversals to the contact radius, for smooth elastic balls: Mindlin (1949),
/// Mindlin and Deresiewicz (1953). None if these do not apply, if nothing moves, or if the whole contact slides.
std::optional<double> slip_ring(const FrettingCase& c, const FrettingPlan& plan)
{
  const bool is_round = c.lower.texture.is_smooth() && c.upper.texture.is_smooth() && !c.domain.x.is_periodic() &&
                        !c.domain.y.is_periodic() && plan.sliding_displacement > 0.0;
  if (!is_round || c.amplitude == 0.0)
    return std::nullopt;
  if (c.kind == FrettingCase::Kind::shift)
  {
    const double share = c.amplitude / plan.sliding_displacement;
    return share < 1.0 ? std::optional(1.0 - std::sqrt(1.0 - share)) : std::nullopt;
  }
  if (c.press.kind != contact::Drive::Kind::load)
    return std::nullopt;
  return 1.0 - std::cbrt(1.0 - c.amplitude / (c.friction.coefficient * c.press.value));
}

/// Cells across the slip annulus; none where its width is unknown.
std::optional<double> cells_across_ring(const FrettingCase& c, const FrettingPlan& plan)
{
  const std::optional<double> ring = slip_ring(c, plan);
  if (!ring)
    return std::nullopt;
  return *ring * std::min(plan.contact_radius / plan.contact.dx, plan.contact_radius_y / plan.contact.dy);
}

constexpr double fewest_across_ring = 2.0;

/// Error of heat and slip of a cycle with few cells across the slip annulus: 35 to 66 % of the heat with half a cell, 12 to 26 %
/// with 0.9, 1 to 11 % with 1.6 to 1.9 (docs/verification/accuracy.md, expected error).
double error_of_thin_ring(double cells)
{
  return std::min(1.0, 0.2 / (cells * cells));
}

/// Warning about too few cells across the slip annulus.
std::optional<Warning> thin_slip(const FrettingCase& c, const FrettingPlan& plan)
{
  const std::optional<double> across = cells_across_ring(c, plan);
  if (!across || !(*across < fewest_across_ring))
    return std::nullopt;
  return Warning{
      "thin_slip",
      fmt::format("the ring that slips is only about {:.2g} cells wide, by the elastic solution of two balls: the "
                  "energy of a cycle may be off by {}, and its slip by more. Take a grid.resolution of {:.0f}",
                  *across, percent_text(error_of_thin_ring(*across)),
                  std::ceil(fewest_across_ring / *slip_ring(c, plan)))};
}

} // namespace

// docs/verification/accuracy.md (expected error)
template <>
Facts facts(const FrettingCase& c, const FrettingPlan& plan, const Seen<FrettingCase>& /*seen*/)
{
  Facts f = facts_of(c, plan, plan.contact_radius, plan.contact_radius_y);
  constexpr Of elastic = Of::elastic_contact;
  Documented heat{.quantity = "heat of friction",
                  .name = "cycles[*].dissipation_friction_J",
                  .error = 0.02,
                  .cells = 8.0,
                  .order = 1.0,
                  .of = elastic,
                  .on_textures = 4.0};
  const std::optional<double> across = cells_across_ring(c, plan);
  const bool is_thin = across && *across < fewest_across_ring;
  Documented slip{.quantity = "slip amplitude",
                  .name = "cycles[*].slip_amplitude_m",
                  .error = 0.2,
                  .cells = 8.0,
                  .order = 1.0,
                  .of = elastic};
  if (across)
    heat.further = error_of_thin_ring(*across); // 2.9 % with 2.2 cells
  if (is_thin)
    slip.further = f.slip.further = f.temperature_rise.further = heat.further;
  if (c.kind != FrettingCase::Kind::force)
    f.documented.push_back({.quantity = "largest force along the surface",
                            .name = "cycles[*].max_force_N",
                            .error = is_thin ? 0.01 : 0.005,
                            .cells = 8.0,
                            .order = 1.0,
                            .of = elastic,
                            .on_textures = 2.5});
  f.documented.push_back(heat);
  f.documented.push_back({.quantity = "plastic work",
                          .name = "cycles[*].dissipation_plastic_J",
                          .error = 0.05,
                          .cells = 8.0,
                          .order = 1.0,
                          .of = Documented::Of::plastic_zone});
  f.documented.push_back(slip);
  if (const std::optional<double> ring = slip_ring(c, plan); ring && *ring < 1.0)
  {
    constexpr double of_area = 0.05; // a row of cells around the part that sticks
    f.documented.push_back({.quantity = "stick share",
                            .name = "cycles[*].stick_share",
                            .error = of_area / std::pow(1.0 - *ring, 2),
                            .cells = 8.0,
                            .order = 1.0,
                            .of = elastic});
  }
  f.slides =
      c.kind == FrettingCase::Kind::shift && plan.sliding_displacement > 0.0 && c.amplitude > plan.sliding_displacement;
  f.may_stick = !f.slides;
  if (c.frequency)
    f.heating_time = 0.5 / *c.frequency;
  f.while_heated = "in half a cycle";
  if (!f.slides) // the rim of the contact wears most, and is heated alone
  {
    f.slip.error = 0.06;
    f.temperature_rise.error = temperature_error_of_sticking;
  }
  f.warning = thin_slip(c, plan);
  return f;
}

template Quality expected(const FrettingCase&, const FrettingPlan&);
template Quality judged(const FrettingCase&, const FrettingPlan&, const RunTotals&);
template Quality judged(const FrettingCase&, const FrettingPlan&, const FrettingSummary&);

} // namespace brinell::quality
