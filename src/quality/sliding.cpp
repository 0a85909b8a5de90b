// SPDX-License-Identifier: BSD-3-Clause
#include "of_scenario.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

/// Quality of results of sliding, before and after a run.
namespace brinell::quality
{

namespace
{

// docs/verification/accuracy.md (expected error)
constexpr Documented ploughing{.quantity = "friction by ploughing",
                               .name = "strokes[*].friction_ploughing",
                               .error = 0.21,
                               .cells = 4.2,
                               .order = 1.9,
                               .of = Documented::Of::contact,
                               .of_steps = 0.3,
                               .on_textures = 1.5};
constexpr Documented work_of_strokes{.quantity = "plastic work",
                                     .name = "strokes[*].dissipation_plastic_J",
                                     .error = 0.06,
                                     .cells = 8.0,
                                     .order = 1.0,
                                     .of = Documented::Of::plastic_zone,
                                     .of_steps = 1.0,
                                     .on_textures = 1.5};
/// Of point contacts.
constexpr Documented of_slid_points[] = {{.quantity = "largest plastic strain",
                                          .name = "residual.max_equivalent_plastic_strain",
                                          .error = 0.05,
                                          .cells = 8.0,
                                          .order = 1.0,
                                          .of = Documented::Of::contact,
                                          .of_steps = 0.1,
                                          .on_textures = 1.5},
                                         {.quantity = "contact area",
                                          .name = "strokes[*].contact_area_m2",
                                          .error = 0.016,
                                          .cells = 8.0,
                                          .order = 1.0,
                                          .of = Documented::Of::elastic_contact,
                                          .of_steps = 0.02,
                                          .on_textures = 2.5},
                                         {.quantity = "largest pressure",
                                          .name = "strokes[*].max_pressure_Pa",
                                          .error = 0.01,
                                          .cells = 8.0,
                                          .order = 1.0,
                                          .of = Documented::Of::elastic_contact,
                                          .of_steps = 0.02,
                                          .on_textures = 2.5}};

/// Whether the friction by ploughing is so small a difference of large forces that its relative error says nothing.
bool hardly_ploughs(const std::vector<SlidingStroke>& strokes)
{
  constexpr double least = 1e-3;
  return std::all_of(strokes.begin(), strokes.end(),
                     [](const SlidingStroke& s) { return std::abs(s.friction_ploughing) < least; });
}

/// Whether so little yields in the strokes after pressing, as where only the upper body is plastic, that a relative
/// error of their plastic work says nothing.
bool hardly_yields(const SlidingSummary& summary)
{
  constexpr double least = 0.02; // over the plastic work of the whole run
  const double all = summary.dissipation_lower + summary.dissipation_upper;
  return std::all_of(summary.strokes.begin(), summary.strokes.end(),
                     [&](const SlidingStroke& s) { return s.dissipation_plastic < least * all; });
}

/// @param summary  of a finished run; none before
std::vector<Documented> documented_of_strokes(bool is_plane, const SlidingSummary* summary)
{
  std::vector<Documented> errors;
  if (!summary || !hardly_ploughs(summary->strokes))
    errors.push_back(ploughing);
  if (!summary || !hardly_yields(*summary))
    errors.push_back(work_of_strokes);
  if (!is_plane)
    errors.insert(errors.end(), std::begin(of_slid_points), std::end(of_slid_points));
  return errors;
}

} // namespace

template <>
Facts facts(const SlidingCase& c, const SlidingPlan& plan, const Seen<SlidingCase>& seen)
{
  Facts f = facts_of(c, plan, plan.half_width_x, plan.half_width_y);
  f.documented = documented_of_strokes(f.is_plane, seen.summary);
  f.moves = true;
  if (c.shift)
    f.shift = plan.shift;
  if (c.speed)
    f.heating_time = 2.0 * f.half_x / *c.speed;
  return f;
}

template Quality expected(const SlidingCase&, const SlidingPlan&);
template Quality judged(const SlidingCase&, const SlidingPlan&, const RunTotals&);
template Quality judged(const SlidingCase&, const SlidingPlan&, const SlidingSummary&);

} // namespace brinell::quality
