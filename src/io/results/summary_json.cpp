// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/summary_json.hpp"

#include "brinell/io/versions.hpp"
#include "brinell/quality/quality.hpp"
#include "fatigue_parts.hpp"
#include "foundation/nan.hpp"
#include "io/case/value_text.hpp"
#include "io/scenarios/scenario_io.hpp"
#include "summary_parts.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::io
{

namespace
{

using simulation::RunTotals;

/// The values at first yield; null if there are none.
Json critical_json(const Case& c)
{
  constexpr std::array bodies{"lower", "upper", "both"};
  const reference::CriticalValues critical = scale_of(c);
  Json json = {{"C", critical.C},
               {"interference_m", critical.interference},
               {"load_N", critical.load},
               {"energy_J", critical.energy},
               {"contact_radius_m", critical.contact_radius},
               {"contact_area_m2", critical.contact_area},
               {"peak_pressure_Pa", critical.peak_pressure},
               {"yields_first", nullptr},
               {"contact", nullptr},
               {"line_length_m", nullptr},
               {"line_reference_m", nullptr}};
  if (const auto& coated = c.coated_yield)
    json["with_layers"] = {{"interference_m", coated->approach},
                           {"load_N", coated->load},
                           {"contact_radius_m", coated->contact_radius},
                           {"pressure_on_axis_Pa", coated->peak_pressure},
                           {"body", coated->in_upper ? "upper" : "lower"},
                           {"layer", coated->place.layer},
                           {"depth_m", coated->place.depth},
                           {"distance_from_axis_m", coated->place.r}};
  if (!c.first_yield)
    return json;
  json["yields_first"] = bodies[static_cast<std::size_t>(c.first_yield->body)];
  json["contact"] = c.first_yield->line ? "line" : "point";
  if (const auto& line = c.first_yield->line)
    json.update({{"line_length_m", line->length}, {"line_reference_m", line->reference}});
  return json;
}

Json cell_counts(const VolumeGrid& grid)
{
  return Json::array({grid.surface.nx, grid.surface.ny, grid.nz});
}

/// The grids at the end of the run, and how they grew.
Json grid_json(const RunTotals& s)
{
  const simulation::Snapshot& end = s.final_state;
  Json changes = Json::array();
  for (const simulation::GridChange& change : s.grid_changes)
    changes.push_back({{"step", change.step},
                       {"extent", extent_name(change.extent)},
                       {"before", change.before},
                       {"after", change.after}});
  return {{"spacing_m", Json::array({end.contact.dx, end.contact.dy, end.lower.grid.dz})},
          {"contact_cells", Json::array({end.contact.nx, end.contact.ny})},
          {"lower_cells", cell_counts(end.lower.grid)},
          {"upper_cells", cell_counts(end.upper.grid)},
          {"symmetric_in_y", s.is_mirrored_y},
          {"memory_bytes", s.memory_bytes},
          {"changes", std::move(changes)}};
}

Json versions_json()
{
  const Versions versions = library_versions();
  return {{"brinell", versions.brinell},
          {"git_hash", versions.git_hash},
          {"hdf5", versions.hdf5},
          {"processor", versions.processor}};
}

/// The child for one part of a key: a member, or an entry of a list such as texture[0].
Json& child(Json& parent, std::string_view part)
{
  const auto open = part.find('[');
  Json& member = parent[std::string(part.substr(0, open))];
  return open == part.npos ? member : member[std::stoul(std::string(part.substr(open + 1)))];
}

/// Dotted keys as nested objects, numbered tables as lists of them.
Json case_json(const CaseValues& values)
{
  Json root = Json::object();
  for (const auto& [key, value] : values.all())
  {
    Json* place = &root;
    std::string_view rest = key;
    for (auto dot = rest.find('.'); dot != rest.npos; dot = rest.find('.'))
    {
      place = &child(*place, rest.substr(0, dot));
      rest.remove_prefix(dot + 1);
    }
    (*place)[std::string(rest)] = json_value(value);
  }
  return root;
}

/// The first part of every summary.
Json head_json(const Case& c)
{
  Json json;
  json["format"] = "brinell-summary";
  json["format_version"] = format_version;
  json["complete"] = true;
  json["scenario"] = c.values.get<std::string>("scenario");
  json["title"] = c.title;
  json["critical"] = critical_json(c);
  return json;
}

Json energy_json(const RunTotals& s)
{
  return {{"net_J", s.work},
          {"dissipation_lower_J", s.dissipation_lower},
          {"dissipation_upper_J", s.dissipation_upper},
          {"dissipation_friction_J", s.dissipation_friction},
          {"residual_J", s.energy_residual},
          {"elastic_J", s.energy_elastic},
          {"balance_error", s.energy_balance_error}};
}

/// Adds the totals of each effect between the surfaces that acts.
template <typename ScenarioCase>
void put_effects(Json& json, const ScenarioCase& c, const RunTotals& s)
{
  for (const std::string_view name : elastoplastic::names_of(c, {&c.lower.material, &c.upper.material}))
    for (const elastoplastic::EffectColumn& total : elastoplastic::effect_columns)
      if (total.effect == name)
        std::visit([&](auto value) { json[std::string(name)][std::string(total.in_summary)] = value; },
                   total.column.value(s));
}

/// @param fraction  share of the friction work that heats the bodies
Json heat_json(double fraction, const RunTotals& s, const simulation::HeatedRecord& last)
{
  const double given = fraction * s.dissipation_friction + last.heat_of_source + last.heat_of_current;
  // Between bodies of different temperatures far more heat may flow than friction generates.
  const double largest = std::max({given, std::abs(last.heat_lower), std::abs(last.heat_upper)});
  return {{"max_temperature_lower_degC", s.max_temperature[0]},
          {"max_temperature_upper_degC", s.max_temperature[1]},
          {"lower_J", last.heat_lower},
          {"upper_J", last.heat_upper},
          {"of_source_J", last.heat_of_source},
          {"of_current_J", last.heat_of_current},
          {"of_plastic_work_J", last.heat_of_plastic_work},
          {"work_of_expansion_J", s.work_of_expansion},
          {"balance_error", largest > 0.0 ? (given - last.heat_lower - last.heat_upper) / largest : 0.0},
          {"held_cells", s.most_held_cells},
          {"held_share", s.share_of_held_cells}};
}

Json residual_json(const RunTotals& s)
{
  return {{"max_lower_m", s.max_residual_lower},
          {"max_upper_m", s.max_residual_upper},
          {"max_equivalent_plastic_strain", s.max_equivalent_plastic_strain}};
}

/// Adds energies, heat, effects, residual displacement and shift after the scenario's own part.
template <typename ScenarioCase>
void put_totals(Json& json, const ScenarioCase& c, const typename ScenarioCase::Plan& plan,
                const typename ScenarioCase::Summary& s)
{
  Json energy = energy_json(s);
  if (json.contains("energy"))
    energy.update(json["energy"]);
  json["energy"] = std::move(energy);
  if constexpr (std::derived_from<typename ScenarioCase::Record, simulation::HeatedRecord>)
    if (s.last.heat_lower != 0.0 || s.last.heat_upper != 0.0 || s.last.heat_of_plastic_work != 0.0)
      json["heat"] = heat_json(c.heat.fraction, s, s.last);
  put_effects(json, c, s);
  json["residual"] = residual_json(s);
  if constexpr (requires { plan.shift; })
    json["grid"]["shift_m"] = plan.shift;
  json["grid"]["surfaces_only"] = plan.surfaces_only;
}

Json warnings_json(const std::vector<Warning>& warnings)
{
  Json json = Json::array();
  for (const Warning& warning : warnings)
    json.push_back({{"key", warning.key}, {"text", warning.text}});
  return json;
}

Json resolution_json(const quality::Resolution& r)
{
  Json json = {{"cells_per_contact_radius", r.cells},
               {"cells_per_contact_radius_x", r.cells_x},
               {"cells_per_contact_radius_y", r.cells_y},
               {"cells_per_shortest_wave", nullptr},
               {"layers_of_plastic_zone", nullptr},
               {"cells_per_patch_radius", nullptr},
               {"cells_per_peak_radius", nullptr},
               {"expected_errors", Json::object()},
               {"text", quality::resolution_text(r)},
               {"source", "estimate from the convergence tables of brinell, docs/verification.md"}};
  if (r.cells_per_wave)
    json["cells_per_shortest_wave"] = *r.cells_per_wave;
  if (r.patch_cells)
    json["cells_per_patch_radius"] = *r.patch_cells;
  if (r.peak_cells)
    json["cells_per_peak_radius"] = *r.peak_cells;
  if (r.plastic_layers)
    json["layers_of_plastic_zone"] = *r.plastic_layers;
  for (const quality::ExpectedError& e : r.expected_errors)
    json["expected_errors"][e.quantity] = e.best();
  if (std::any_of(r.expected_errors.begin(), r.expected_errors.end(), [](const auto& e) { return e.measured; }))
    for (const quality::ExpectedError& e : r.expected_errors)
      json["errors_of_tables"][e.quantity] = e.relative;
  return json;
}

Json accuracy_json(const Accuracy& a)
{
  Json json = {{"asked", a.asked},      {"reached", a.reached},     {"error", a.error}, {"key_numbers", a.key_numbers},
               {"runs", Json::array()}, {"numbers", Json::object()}};
  for (const Level& level : a.levels)
    json["runs"].push_back({{"cells", level.cells}, {"spacing_m", level.spacing}});
  for (const auto& [name, n] : a.numbers)
    json["numbers"][name] = {{"value", n.value}, {"order", n.order}, {"extrapolated", n.extrapolated},
                             {"low", n.low},     {"high", n.high},   {"relative_error", n.relative_error}};
  return json;
}

/// Adds the last part of every summary.
void put_last(Json& json, const Case& c, const RunTotals& s, const RunInfo& info)
{
  const Json grid = grid_json(s);
  json["grid"].update(grid);
  json["run"] = {{"steps", s.steps},
                 {"evaluations", s.evaluations},
                 {"split_increments", s.split_increments},
                 {"threads", info.threads},
                 {"wall_time_s", info.wall_time}};
  if (s.inclusions)
    json["run"]["inclusions"] = {{"iterations", s.inclusions->iterations},
                                 {"largest_residual", s.inclusions->largest_residual}};
  json["warnings"] = warnings_json(info.quality.warnings);
  json["resolution"] = resolution_json(info.quality.resolution);
  if (info.accuracy)
    json["accuracy"] = accuracy_json(*info.accuracy);
  json["versions"] = versions_json();
  json["case"] = case_json(c.values);
}

} // namespace

reference::CriticalValues scale_of(const Case& c)
{
  constexpr reference::CriticalValues no_scale{.C = nan,
                                               .interference = nan,
                                               .load = nan,
                                               .energy = nan,
                                               .contact_radius = nan,
                                               .contact_area = nan,
                                               .peak_pressure = nan};
  return c.first_yield ? c.first_yield->critical : no_scale;
}

Json geometry_json(const Case& c)
{
  Json json = {{"equivalent_radius_m", nullptr}, {"contact_modulus_Pa", c.contact_modulus}};
  if (c.equivalent_radius)
    json["equivalent_radius_m"] = *c.equivalent_radius;
  const auto [lower, upper] = std::visit(
      [](const auto& s) {
        return std::pair{&s.lower.material, &s.upper.material};
      },
      c.scenario);
  if (!lower->layers.empty() || !upper->layers.empty())
    json["surface_modulus_Pa"] = contact_modulus(lower->top(), upper->top());
  return json;
}

std::string key_of(std::string_view name, std::string_view unit)
{
  std::string key(name);
  if (unit == "1")
    return key;
  key += '_';
  for (const char c : unit)
    if (c == '/')
      key += "_per_";
    else if (c != '^' && c != ' ')
      key += c;
  return key;
}

Json summary_json(const Case& c, const simulation::AnyPlan& plan, const simulation::AnySummary& summary,
                  const RunInfo& info)
{
  return std::visit(
      [&]<typename ScenarioCase>(const ScenarioCase& scenario)
      {
        const auto& s = summary_of<ScenarioCase>(summary);
        Json json = head_json(c);
        const auto& p = std::get<typename ScenarioCase::Plan>(plan);
        io_of(scenario).summarise(json, c, scenario, p, s);
        put_totals(json, scenario, p, s);
        put_fatigue(json, c, s);
        put_last(json, c, s, info);
        return json;
      },
      c.scenario);
}

std::string summary_text(const Case& c, const simulation::AnyPlan& plan, const simulation::AnySummary& summary,
                         const RunInfo& info)
{
  // Titles come from files in any encoding: a bad byte must not cost a finished run its summary.
  return summary_json(c, plan, summary, info).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace brinell::io
