// SPDX-License-Identifier: BSD-3-Clause
#include "of_scenario.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

/// Quality of results of indentation, before and after a run.
namespace brinell::quality
{

namespace
{

using contact::Drive;

// docs/verification/accuracy.md (expected error)
constexpr Documented load{.quantity = "load",
                          .name = "indents[*].max_load_N",
                          .error = 0.014,
                          .cells = 5.0,
                          .order = 2.0,
                          .of = Of::elastic_contact,
                          .of_steps = 0.05,
                          .on_textures = 0.3};
constexpr Documented documented[] = {{.quantity = "residual depth",
                                      .name = "indents[*].residual_depth_m",
                                      .error = 0.022,
                                      .cells = 5.6,
                                      .order = 1.5,
                                      .of = Of::plastic_zone,
                                      .of_steps = 0.06,
                                      .is_of_lower = true,
                                      .on_textures = 3.0},
                                     {.quantity = "hardness",
                                      .name = "indents[*].hardness_Pa",
                                      .error = 0.06,
                                      .cells = 5.6,
                                      .order = 1.0,
                                      .of = Of::elastic_contact,
                                      .of_steps = 0.04},
                                     {.quantity = "pile-up",
                                      .name = "indents[*].pile_up_m",
                                      .error = 0.065,
                                      .cells = 5.6,
                                      .order = 1.5,
                                      .of = Of::plastic_zone,
                                      .of_steps = 0.08,
                                      .is_of_lower = true,
                                      .on_coats = 4.0},
                                     {.quantity = "residual stress at a depth",
                                      .name = "",
                                      .error = 0.05,
                                      .cells = 8.0,
                                      .order = 1.5,
                                      .of = Of::plastic_zone},
                                     {.quantity = "largest plastic strain",
                                      .name = "residual.max_equivalent_plastic_strain",
                                      .error = 0.09,
                                      .cells = 8.0,
                                      .order = 1.0,
                                      .of = Of::contact,
                                      .of_steps = 0.1}};
/// Under a tip, whose largest strain grows without bound as cells get finer.
constexpr Documented documented_of_tips[] = {{.quantity = "residual depth",
                                              .name = "indents[*].residual_depth_m",
                                              .error = 0.08,
                                              .cells = 5.6,
                                              .order = 1.0,
                                              .of = Of::plastic_zone,
                                              .of_steps = 0.06,
                                              .is_of_lower = true},
                                             {.quantity = "hardness",
                                              .name = "indents[*].hardness_Pa",
                                              .error = 0.08,
                                              .cells = 5.6,
                                              .order = 2.0,
                                              .of = Of::elastic_contact,
                                              .of_steps = 0.1},
                                             {.quantity = "pile-up",
                                              .name = "indents[*].pile_up_m",
                                              .error = 0.1,
                                              .cells = 5.6,
                                              .order = 1.5,
                                              .of = Of::plastic_zone,
                                              .of_steps = 0.3,
                                              .is_of_lower = true},
                                             {.quantity = "residual stress at a depth",
                                              .name = "",
                                              .error = 0.05,
                                              .cells = 8.0,
                                              .order = 1.5,
                                              .of = Of::plastic_zone}};

/// Of textured bodies only, whose peaks of pressure stand on summits and shoulders.
constexpr Documented documented_of_textures[] = {{.quantity = "largest pressure",
                                                  .name = "",
                                                  .error = 0.045,
                                                  .cells = 8.0,
                                                  .order = 1.0,
                                                  .of = Of::elastic_contact,
                                                  .of_steps = 0.02},
                                                 {.quantity = "plastic work",
                                                  .name = "energy.dissipation_*er_J",
                                                  .error = 0.065,
                                                  .cells = 8.0,
                                                  .order = 1.0,
                                                  .of = Of::plastic_zone,
                                                  .of_steps = 1.0}};

/// Of the power law through the largest load.
Documented loading_stiffness(bool is_tip)
{
  Documented error{.quantity = "loading stiffness",
                   .name = "indents[*].loading_stiffness_N_per_m",
                   .error = 0.012,
                   .cells = 6.5,
                   .order = 1.5,
                   .of = Of::elastic_contact,
                   .on_coats = 1.5};
  error.on_textures = 1.5;
  if (is_tip)
    error.error = 0.04;
  error.further = 0.005;
  return error;
}

/// Error of the unloading stiffness: that of loading if the bodies are unloaded completely; otherwise of the parabola over the
/// first two steps of unloading.
Documented unloading_stiffness(bool is_tip, int steps, bool is_complete)
{
  Documented error = loading_stiffness(is_tip);
  error.quantity = "unloading stiffness";
  error.name = "indents[*].unloading_stiffness_N_per_m";
  if (!is_complete)
  {
    error.error = std::max(error.error, 0.03);
    error.further = 0.12 / steps;
  }
  return error;
}

/// Least value to which the bodies are unloaded from the largest one; none if they are not.
std::optional<double> unloaded_to(const IndentationCase& c)
{
  const auto next = std::max_element(c.sequence.rbegin(), c.sequence.rend(),
                                     [](const Drive& a, const Drive& b) { return a.value < b.value; })
                        .base(); // after the last one of several largest
  return next == c.sequence.end() ? std::nullopt : std::optional(next->value);
}

bool has_tip(const ShapedBody& body)
{
  return std::holds_alternative<Cone>(body.shape) || std::holds_alternative<Pyramid>(body.shape);
}

/// Text about mean gaps in the sequence that leave the surfaces apart, except the last one, which lifts off; empty if there are
/// none.
std::optional<std::string> gaps_without_contact(const IndentationCase& c, double touching_gap)
{
  if (c.sequence.front().kind != Drive::Kind::mean_gap)
    return std::nullopt;
  const auto apart = [&](const Drive& drive) { return drive.value >= touching_gap; };
  const auto count = std::count_if(c.sequence.begin(), c.sequence.end() - 1, apart);
  if (count == 0)
    return std::nullopt;
  return fmt::format("{} of the mean gaps before the last one {} not below {:.4g} m, where the surfaces first touch: "
                     "there is no contact there",
                     count, count == 1 ? "is" : "are", touching_gap);
}

} // namespace

template <>
Facts facts(const IndentationCase& c, const IndentationPlan& plan, const Seen<IndentationCase>& /*seen*/)
{
  Facts f = facts_of(c, plan, plan.contact_radius, plan.contact_radius_y);
  const bool is_tip = has_tip(c.lower) || has_tip(c.upper);
  if (is_tip)
    f.documented.assign(std::begin(documented_of_tips), std::end(documented_of_tips));
  else
    f.documented.assign(std::begin(documented), std::end(documented));
  if (f.is_plane) // the width of a contact of two edges scatters more than the area within a closed one
    for (Documented& d : f.documented)
      d.error *= std::string_view(d.quantity) == "hardness" ? 2.0 : 1.0;
  if (f.cells_per_texture)
    f.documented.insert(f.documented.end(), std::begin(documented_of_textures), std::end(documented_of_textures));
  const bool is_given = std::all_of(c.sequence.begin(), c.sequence.end(),
                                    [](const Drive& drive) { return drive.kind == Drive::Kind::load; });
  if (!is_given)
    f.documented.insert(f.documented.begin(), load);
  if (c.steps > 1)
    f.documented.push_back(loading_stiffness(is_tip));
  if (const std::optional<double> end = unloaded_to(c); end && c.steps > 1)
    f.documented.push_back(unloading_stiffness(is_tip, c.steps, *end <= 0.0));
  f.forgets_if_elastic = true;
  f.steps = c.steps;
  if (auto text = gaps_without_contact(c, plan.touching_gap))
    f.further_warnings.push_back({"no_contact", std::move(*text)});
  return f;
}

template Quality expected(const IndentationCase&, const IndentationPlan&);
template Quality judged(const IndentationCase&, const IndentationPlan&, const RunTotals&);
template Quality judged(const IndentationCase&, const IndentationPlan&, const IndentationSummary&);

} // namespace brinell::quality
