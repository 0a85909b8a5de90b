// SPDX-License-Identifier: BSD-3-Clause
#include "result_size.hpp"

#include "brinell/simulation/surface_fields.hpp"
#include "io/results/stored_parts.hpp"
#include "io/scenarios/scenario_io.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

/// Parts of the result that a run stores, and their size.
namespace brinell::io
{

namespace
{

constexpr double small = 200e6; ///< largest result that is stored without being asked for [bytes]
constexpr double large = 1e9;   ///< from here on a result is warned of [bytes]

using Words = std::vector<std::string>;

/// Number of steps whose fields will be stored, not counting the final state.
template <typename ScenarioCase>
double stored_steps(const ScenarioCase& c, const typename ScenarioCase::Plan& plan, const SnapshotRule& rule)
{
  if (rule.kind == SnapshotRule::Kind::aligned)
    return io_of(c).key_steps(c, plan);
  double count = 0.0;
  for (int step = 0; step < plan.steps; ++step)
    count += rule.stores(step, false) ? 1.0 : 0.0;
  return count;
}

double stored_steps(const Case& c, const ScenarioPlan& plan)
{
  return std::visit([&]<typename ScenarioCase>(const ScenarioCase& scenario)
                    { return stored_steps(scenario, std::get<typename ScenarioCase::Plan>(plan), c.snapshots); },
                    c.scenario);
}

/// Words for all that acts in a case, so that fields exist: see simulation::SurfaceField::needs.
struct Acting
{
  explicit Acting(const simulation::PairCase& c)
      : words(elastoplastic::names_of(c, {&c.lower.material, &c.upper.material}))
  {
    const bool has_friction = c.friction.coefficient > 0.0;
    if (has_friction)
      words.emplace_back("friction");
    if ((c.lower.material.thermal || c.upper.material.thermal) && (has_friction || c.heat.source.exists()))
      words.emplace_back("heat");
  }
  [[nodiscard]] bool has(std::string_view word) const { return std::ranges::find(words, word) != words.end(); }

  std::vector<std::string_view> words;
};

/// Number of fields on a surface that exist and are chosen.
double number_of(const auto& fields, const Acting& acting, const Words& words)
{
  return static_cast<double>(std::ranges::count_if(
      fields, [&](const simulation::SurfaceField& field)
      { return (field.needs.empty() || acting.has(field.needs)) && chooses(words, field.name); }));
}

/// Numbers of a body in a state; its grid is taken to lie about the origin of its coordinates.
double numbers_of_body(const simulation::ShapedBody& body, const VolumeGrid& grid, Acting acting, const Words& words,
                       const StoredCells& cells)
{
  const auto chosen = [&](std::string_view field, double count) { return chooses(words, field) ? count : 0.0; };
  const SurfaceGrid& surface = grid.surface;
  const VolumeGrid stored =
      stored_grid(grid, -0.5 * (surface.nx - 1) * surface.dx, -0.5 * (surface.ny - 1) * surface.dy, cells);
  const bool is_rigid = body.material.elastic.is_rigid();
  if (!is_rigid)
    acting.words.emplace_back("strain");
  if (!body.texture.is_smooth())
    acting.words.emplace_back("texture");
  const simulation::BodySnapshot none;
  const double within = is_rigid ? 0.0
                                 : chosen("stress", 6.0) + chosen("von_mises_stress", 1.0) +
                                       chosen("plastic_strain", 6.0) + chosen("equivalent_plastic_strain", 1.0) +
                                       (acting.has("heat") ? chosen("temperature", 1.0) : 0.0) +
                                       (body.inclusions.empty() ? 0.0 : chosen("inclusion", 1.0)) +
                                       (body.fatigue ? chosen("fatigue", simulation::fatigue_fields.size()) : 0.0);
  return number_of(simulation::surface_fields(none), acting, words) * static_cast<double>(stored.surface.size()) +
         within * static_cast<double>(stored.size());
}

const simulation::Plan& part_of_all(const ScenarioPlan& plan)
{
  return std::visit([](const auto& one) -> const simulation::Plan& { return one; }, plan);
}

/// Numbers of the fields of a state.
double numbers_of_state(const Case& c, const ScenarioPlan& any_plan, const Words& words, const StoredParts& parts)
{
  return std::visit(
      [&](const auto& scenario)
      {
        const simulation::Plan& plan = part_of_all(any_plan);
        const Acting acting(scenario);
        const simulation::Snapshot none;
        const double stride = parts.cells.stride;
        double numbers = number_of(simulation::surface_fields(none), acting, words) *
                         static_cast<double>(plan.contact.size()) / (stride * stride);
        if (parts.bodies != StoredBodies::upper)
          numbers += numbers_of_body(scenario.lower, plan.lower, acting, words, parts.cells);
        if (parts.bodies != StoredBodies::lower)
          numbers += numbers_of_body(scenario.upper, plan.upper, acting, words, parts.cells);
        return numbers;
      },
      c.scenario);
}

double bytes_of(const Case& c, const ScenarioPlan& plan, const StoredParts& parts)
{
  const double numbers = stored_steps(c, plan) * numbers_of_state(c, plan, parts.in_steps, parts) +
                         numbers_of_state(c, plan, parts.in_final, parts);
  return numbers * (parts.precision == Precision::single ? sizeof(float) : sizeof(double));
}

/// Candidates for the parts that are stored if the case does not name fields: the first one that is small counts, or the last one.
std::vector<StoredParts> candidates(const OutputChoice& choice, const simulation::Plan& plan)
{
  const Words all{"all"}, surface{"surface"},
      scalars{"surface", "von_mises_stress", "equivalent_plastic_strain", "temperature", "fatigue", "inclusion"};
  std::vector<std::pair<Words, Words>> in_steps_and_final{
      {all, all}, {scalars, all}, {surface, all}, {surface, scalars}, {surface, surface}};
  if (plan.surfaces_only)
    in_steps_and_final = {{surface, surface}};
  if (choice.fields)
    in_steps_and_final = {{*choice.fields, *choice.fields}};
  std::vector<StoredParts> result;
  for (const auto& [in_steps, in_final] : in_steps_and_final)
    for (const Precision precision : {Precision::double_precision, Precision::single})
      if (precision == choice.precision.value_or(precision) &&
          (choice.precision || precision == Precision::single || result.empty()))
        result.push_back({in_steps, in_final, choice.bodies, precision, choice.cells});
  return result;
}

/// "the final state without tensors and the steps without fields within the bodies, in single precision"
std::string text_of(const StoredParts& parts)
{
  const auto text = [](const Words& words)
  {
    return words.front() == "all" ? "all fields"
           : words.size() == 1    ? "the fields on surfaces"
                                  : "the fields on surfaces and the scalars within the bodies";
  };
  return fmt::format("of the stored steps {}, of the final state {}{}", text(parts.in_steps), text(parts.in_final),
                     parts.precision == Precision::single ? ", in single precision" : "");
}

} // namespace

std::string size_text(double bytes)
{
  constexpr std::array units{"kB", "MB", "GB", "TB"};
  double value = bytes / 1e3;
  std::size_t unit = 0;
  for (; value >= 1000.0 && unit + 1 < units.size(); ++unit)
    value /= 1e3;
  return fmt::format("{:.3g} {}", value, units[unit]);
}

StoredParts stored_parts(const Case& c, const ScenarioPlan& plan)
{
  const std::vector<StoredParts> possible = candidates(c.output, part_of_all(plan));
  const auto found =
      std::ranges::find_if(possible, [&](const StoredParts& parts) { return bytes_of(c, plan, parts) <= small; });
  return found != possible.end() ? *found : possible.back();
}

double stored_states(const Case& c, const ScenarioPlan& plan)
{
  return stored_steps(c, plan) + 1.0;
}

double result_bytes(const Case& c, const ScenarioPlan& plan)
{
  return bytes_of(c, plan, stored_parts(c, plan));
}

std::string result_report(const Case& c, const ScenarioPlan& plan)
{
  const double steps = stored_steps(c, plan);
  return fmt::format("# Result: {:.0f} stored step{} and the final state, {} before compression\n", steps,
                     steps == 1.0 ? "" : "s", size_text(result_bytes(c, plan)));
}

std::string left_out_text(const Case& c, const ScenarioPlan& plan)
{
  if (!part_of_all(plan).surfaces_only || c.output.fields)
    return "";
  return "neither body can yield: fields on the surfaces are computed and stored, none within the bodies; "
         "output.fields = \"all\", or names such as [\"surface\", \"von_mises_stress\"], adds those";
}

std::vector<Warning> result_warnings(const Case& c, const ScenarioPlan& plan)
{
  std::vector<Warning> warnings;
  const StoredParts parts = stored_parts(c, plan);
  const StoredParts most = candidates(c.output, part_of_all(plan)).front();
  const double bytes = bytes_of(c, plan, parts);
  if (parts.in_steps != most.in_steps) // single precision alone needs no words
    warnings.push_back(
        {"reduced_result",
         fmt::format("the whole result would take {} before compression; without output.fields it is kept small, {}: "
                     "stored are {}; output.fields = \"all\" stores everything",
                     size_text(bytes_of(c, plan, most)), size_text(bytes), text_of(parts))});
  if (bytes > large)
    warnings.push_back(
        {"large_result",
         fmt::format("the result takes about {} before compression; output.snapshots, fields, bodies, "
                     "depth, region_x, region_y, region_z, stride, stride_z and precision of the case make it "
                     "smaller",
                     size_text(bytes))});
  return warnings;
}

} // namespace brinell::io
