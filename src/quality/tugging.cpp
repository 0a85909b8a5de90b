// SPDX-License-Identifier: BSD-3-Clause
#include "of_scenario.hpp"

#include <algorithm>

/// Quality of results of tugging, before and after a run.
namespace brinell::quality
{

namespace
{

// docs/verification/accuracy.md (expected error)
constexpr Documented peak_force{.quantity = "peak force",
                                .name = "forces.peak_*_N",
                                .error = 0.014,
                                .cells = 8.0,
                                .order = 2.0,
                                .of = Documented::Of::elastic_contact,
                                .on_textures = 0.12};
/// Under a load F_Z is given, and the peak of F_X lies where the load rises or falls, within a few steps.
constexpr Documented peak_under_load{.quantity = "peak F_X",
                                     .name = "forces.peak_F_X_N",
                                     .error = 0.06,
                                     .cells = 8.0,
                                     .order = 1.0,
                                     .of = Documented::Of::elastic_contact};

constexpr Documented dents{.quantity = "dents",
                           .name = "residual.max_*_m",
                           .error = 0.017,
                           .cells = 8.0,
                           .order = 1.8,
                           .of = Documented::Of::plastic_zone,
                           .of_steps = 0.5,
                           .on_textures = 1.3};
constexpr Documented net_energy{.quantity = "net energy",
                                .name = "energy.net_J",
                                .error = 0.036,
                                .cells = 8.0,
                                .order = 1.7,
                                .of = Documented::Of::contact,
                                .of_steps = 1.0,
                                .on_textures = 3.0};
/// Under a load the net work is a small difference of what the load does on its way down and up.
constexpr Documented net_energy_under_load{.quantity = "net energy",
                                           .name = "energy.net_J",
                                           .error = 0.08,
                                           .cells = 8.0,
                                           .order = 1.7,
                                           .of = Documented::Of::contact,
                                           .of_steps = 1.0,
                                           .on_textures = 3.0};
constexpr Documented resistance_to_tugging{.quantity = "F_X at alignment",
                                           .name = "forces.F_X_aligned_N",
                                           .error = 0.043,
                                           .cells = 8.0,
                                           .order = 1.7,
                                           .of = Documented::Of::contact,
                                           .of_steps = 1.0,
                                           .on_textures = 2.5};
// Of point contacts.
constexpr Documented work_of_tugging{.quantity = "plastic work",
                                     .name = "energy.dissipation_*er_J",
                                     .error = 0.065,
                                     .cells = 8.0,
                                     .order = 1.0,
                                     .of = Documented::Of::contact,
                                     .of_steps = 1.0};
constexpr Documented strain_of_tugging{.quantity = "largest plastic strain",
                                       .name = "residual.max_equivalent_plastic_strain",
                                       .error = 0.055,
                                       .cells = 8.0,
                                       .order = 1.0,
                                       .of = Documented::Of::contact,
                                       .of_steps = 0.1,
                                       .on_textures = 1.3};
/// Error of the largest strain with friction, which moves the largest strain to the surface, into the uppermost layers of cells.
constexpr double error_of_rubbed_strain = 0.3;

/// Share of the work that is not friction; 1 before the run.
double share_of_ploughing(const RunTotals* totals)
{
  return totals && totals->work > 0.0 ? std::clamp(1.0 - totals->dissipation_friction / totals->work, 0.0, 1.0) : 1.0;
}

/// The error of a quantity to which friction contributes. That of friction is the error of the normal force, which is small.
Documented with_friction(Documented error, double ploughing)
{
  constexpr double of_cells = 0.004, of_steps = 0.05, of_usual_steps = 0.003;
  const double rubbing = 1.0 - ploughing;
  error.error = ploughing * error.error + rubbing * of_cells;
  error.of_steps = ploughing * error.of_steps + rubbing * of_steps;
  error.further = rubbing * of_usual_steps;
  return error;
}

} // namespace

template <>
Facts facts(const TuggingCase& c, const TuggingPlan& plan, const Seen<TuggingCase>& seen)
{
  Facts f = facts_of(c, plan, plan.elastic_contact_radius, plan.elastic_contact_radius_y);
  const double ploughing = share_of_ploughing(seen.totals);
  f.documented = {c.load ? peak_under_load : peak_force, dents,
                  with_friction(c.load ? net_energy_under_load : net_energy, ploughing),
                  with_friction(resistance_to_tugging, ploughing)};
  if (!f.is_plane)
  {
    f.documented.insert(f.documented.end(), {work_of_tugging, strain_of_tugging});
    if (c.friction.coefficient > 0.0)
      f.documented.back().error = error_of_rubbed_strain;
  }
  f.moves = f.slides = true;
  if (c.shift)
    f.shift = plan.shift;
  if (c.speed)
    f.heating_time = 2.0 * f.half_x / (0.5 * *c.speed);
  return f;
}

template Quality expected(const TuggingCase&, const TuggingPlan&);
template Quality judged(const TuggingCase&, const TuggingPlan&, const RunTotals&);
template Quality judged(const TuggingCase&, const TuggingPlan&, const TuggingSummary&);

} // namespace brinell::quality
