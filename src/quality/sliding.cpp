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
constexpr Documented ploughing{
    "friction by ploughing", "strokes[*].friction_ploughing", 0.14, 4.2, 1.9, Of::contact, 0.3, 2.2};
constexpr Documented work_of_strokes{
    "plastic work", "strokes[*].dissipation_plastic_J", 0.06, 8.0, 1.0, Of::plastic_zone, 1.0, 1.5};
/// Of point contacts.
constexpr Documented of_slid_points[] = {
    {"largest plastic strain", "residual.max_equivalent_plastic_strain", 0.05, 8.0, 1.0, Of::contact, 0.1, 1.5},
    {"contact area", "strokes[*].contact_area_m2", 0.016, 8.0, 1.0, Of::elastic_contact, 0.02, 2.5},
    {"largest pressure", "strokes[*].max_pressure_Pa", 0.01, 8.0, 1.0, Of::elastic_contact, 0.02, 2.5}};

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
  Facts f = facts_of(c, c.lower, c.upper, plan, plan.half_width_x, plan.half_width_y);
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
