// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/summary_json.hpp"

#include "brinell/io/versions.hpp"
#include "brinell/simulation/columns.hpp"
#include "io/case/value_text.hpp"

#include <limits>
#include <nlohmann/json.hpp>

namespace brinell::io
{

namespace
{

using Json = nlohmann::ordered_json;
using simulation::RunTotals;
using simulation::TuggingPlan;
using simulation::TuggingSummary;

constexpr double nan = std::numeric_limits<double>::quiet_NaN(); // null in JSON

Json critical_json(const Case& c)
{
  Json json = {{"C", nullptr},
               {"interference_m", nullptr},
               {"load_N", nullptr},
               {"energy_J", nullptr},
               {"contact_radius_m", nullptr},
               {"contact_area_m2", nullptr},
               {"peak_pressure_Pa", nullptr},
               {"yields_first", nullptr},
               {"contact", nullptr},
               {"line_length_m", nullptr},
               {"line_reference_m", nullptr}};
  if (!c.first_yield)
    return json;
  constexpr std::array bodies{"lower", "upper", "both"};
  const auto& critical = c.first_yield->critical;
  json.update({{"C", critical.C},
               {"interference_m", critical.interference},
               {"load_N", critical.load},
               {"energy_J", critical.energy},
               {"contact_radius_m", critical.contact_radius},
               {"contact_area_m2", critical.contact_area},
               {"peak_pressure_Pa", critical.peak_pressure},
               {"yields_first", bodies[static_cast<std::size_t>(c.first_yield->body)]},
               {"contact", c.first_yield->line ? "line" : "point"}});
  if (const auto& line = c.first_yield->line)
    json.update({{"line_length_m", line->length}, {"line_reference_m", line->reference}});
  return json;
}

constexpr reference::CriticalValues no_scale{.interference = nan, .load = nan, .energy = nan, .contact_area = nan};

/// Units of what is normalised; without first yield every quotient becomes NaN, hence null.
reference::CriticalValues scale_of(const Case& c)
{
  return c.first_yield ? c.first_yield->critical : no_scale;
}

Json geometry_json(const Case& c)
{
  Json json = {{"equivalent_radius_m", nullptr}, {"contact_modulus_Pa", c.contact_modulus}};
  if (c.equivalent_radius)
    json["equivalent_radius_m"] = *c.equivalent_radius;
  return json;
}

Json tugging_geometry_json(const Case& c, const TuggingPlan& plan)
{
  const auto& t = std::get<simulation::TuggingCase>(c.scenario);
  Json json = {{"lower_radius_m", simulation::passing_radius(t.lower.shape).value_or(nan)},
               {"upper_radius_m", simulation::passing_radius(t.upper.shape).value_or(nan)}};
  json.update(geometry_json(c));
  json["interference_m"] = t.interference;
  json["start_distance_m"] = plan.start_distance;
  return json;
}

Json normalised_json(const Case& c, const TuggingSummary& s)
{
  const reference::CriticalValues scale = scale_of(c);
  return {{"interference", std::get<simulation::TuggingCase>(c.scenario).interference / scale.interference},
          {"peak_F_X", s.peak_F_X / scale.load},
          {"X_over_R_at_peak_F_X", s.X_at_peak_F_X / c.equivalent_radius.value_or(nan)},
          {"min_F_X", s.min_F_X / scale.load},
          {"peak_F_Z", s.peak_F_Z / scale.load},
          {"F_X_aligned", s.F_X_aligned / scale.load},
          {"F_Z_aligned", s.F_Z_aligned / scale.load},
          {"work_to_alignment", s.work_to_alignment / scale.energy},
          {"net_energy", s.work / scale.energy},
          {"dissipation_lower", s.dissipation_lower / scale.energy},
          {"dissipation_upper", s.dissipation_upper / scale.energy},
          {"energy_residual", s.energy_residual / scale.energy},
          {"max_residual_lower", s.max_residual_lower / scale.interference},
          {"max_residual_upper", s.max_residual_upper / scale.interference}};
}

Json forces_json(const TuggingSummary& s)
{
  return {{"peak_F_X_N", s.peak_F_X}, {"X_at_peak_F_X_m", s.X_at_peak_F_X}, {"min_F_X_N", s.min_F_X},
          {"peak_F_Z_N", s.peak_F_Z}, {"F_X_aligned_N", s.F_X_aligned},     {"F_Z_aligned_N", s.F_Z_aligned}};
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

Json cells(const VolumeGrid& grid)
{
  return Json::array({grid.surface.nx, grid.surface.ny, grid.nz});
}

Json residual_json(const RunTotals& s)
{
  return {{"max_lower_m", s.max_residual_lower},
          {"max_upper_m", s.max_residual_upper},
          {"max_equivalent_plastic_strain", s.max_equivalent_plastic_strain}};
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
          {"lower_cells", cells(end.lower.grid)},
          {"upper_cells", cells(end.upper.grid)},
          {"memory_bytes", s.memory_bytes},
          {"changes", std::move(changes)}};
}

Json versions_json()
{
  const Versions versions = library_versions();
  return {
      {"brinell", versions.brinell}, {"git_hash", versions.git_hash}, {"fftw", versions.fftw}, {"hdf5", versions.hdf5}};
}

/// Of one part of a key: a member, or an entry of a list as of texture[0].
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

/// What every summary begins with.
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

Json warnings_json(const std::vector<Warning>& warnings)
{
  Json json = Json::array();
  for (const Warning& warning : warnings)
    json.push_back({{"key", warning.key}, {"text", warning.text}});
  return json;
}

Json resolution_json(const simulation::Resolution& r)
{
  Json json = {{"cells_per_contact_radius", r.cells},
               {"cells_per_contact_radius_x", r.cells_x},
               {"cells_per_contact_radius_y", r.cells_y},
               {"cells_per_shortest_wave", nullptr},
               {"layers_of_plastic_zone", nullptr},
               {"expected_errors", Json::object()},
               {"text", simulation::resolution_text(r)},
               {"source", "estimate from the convergence tables of brinell, docs/verification.md"}};
  if (r.cells_per_wave)
    json["cells_per_shortest_wave"] = *r.cells_per_wave;
  if (r.plastic_layers)
    json["layers_of_plastic_zone"] = *r.plastic_layers;
  for (const simulation::ExpectedError& e : r.expected_errors)
    json["expected_errors"][e.quantity] = e.relative;
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

/// What every summary ends with, and its text.
std::string finished(Json json, const Case& c, const RunTotals& s, const RunInfo& info)
{
  const Json grid = grid_json(s);
  json["grid"].update(grid);
  json["run"] = {{"steps", s.steps},
                 {"evaluations", s.evaluations},
                 {"split_increments", s.split_increments},
                 {"threads", info.threads},
                 {"wall_time_s", info.wall_time}};
  json["warnings"] = warnings_json(info.quality.warnings);
  json["resolution"] = resolution_json(info.quality.resolution);
  if (info.accuracy)
    json["accuracy"] = accuracy_json(*info.accuracy);
  json["versions"] = versions_json();
  json["case"] = case_json(c.values);
  // Titles come from files in any encoding: a bad byte must not cost a finished run its summary.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// "hardness_Pa", "loading_stiffness_N_per_m": a name and, unless the number is pure, its unit.
template <typename Record>
std::string key_of(const simulation::Column<Record>& column)
{
  std::string key(column.name);
  if (column.unit == "1")
    return key;
  key += '_';
  for (const char c : column.unit)
    if (c == '/')
      key += "_per_";
    else if (c != '^')
      key += c;
  return key;
}

template <typename Record>
void put(Json& json, const simulation::Column<Record>& column, const Record& record)
{
  std::visit([&](auto number) { json[key_of(column)] = number; }, column.value(record));
}

Json indent_json(const simulation::Indent& indent)
{
  Json json;
  for (const auto& column : simulation::columns<simulation::Indent>)
    put(json, column, indent);
  return json;
}

Json normalised_indent_json(const Case& c, const simulation::Indent& i)
{
  const reference::CriticalValues scale = scale_of(c);
  return {{"max_load", i.max_load / scale.load},
          {"max_approach", i.max_approach / scale.interference},
          {"contact_area", i.contact_area / scale.contact_area},
          {"final_approach", i.final_approach / scale.interference},
          {"residual_depth", i.residual_depth / scale.interference},
          {"work", i.work / scale.energy}};
}

Json pass_json(const simulation::RollingPass& pass)
{
  Json json;
  for (const auto& column : simulation::columns<simulation::RollingPass>)
  {
    if (column.name == "unsteadiness")
      json["steady"] = pass.is_steady(); // beside what it follows from
    put(json, column, pass);
  }
  return json;
}

} // namespace

std::string summary_text(const Case& c, const TuggingPlan& plan, const TuggingSummary& s, const RunInfo& info)
{
  Json json = head_json(c);
  json["geometry"] = tugging_geometry_json(c, plan);
  if (const auto& load = std::get<simulation::TuggingCase>(c.scenario).load)
    json["drive"] = {{"load_N", *load}};
  json["normalised"] = normalised_json(c, s);
  json["max_share_at_shear_limit"] = s.max_share_at_shear_limit;
  json["load_ratio"] = {{"aligned", s.load_ratio_aligned}, {"end", s.load_ratio_end}};
  json["forces"] = forces_json(s);
  json["energy"] = energy_json(s);
  json["energy"]["work_to_alignment_J"] = s.work_to_alignment;
  json["residual"] = residual_json(s);
  json["grid"]["shift_m"] = plan.shift;
  return finished(std::move(json), c, s, info);
}

std::string summary_text(const Case& c, const simulation::IndentationPlan& plan,
                         const simulation::IndentationSummary& s, const RunInfo& info)
{
  Json json = head_json(c);
  json["geometry"] = geometry_json(c);
  json["geometry"]["estimated_contact_radius_m"] = plan.contact_radius;
  json["geometry"]["touching_gap_m"] = plan.touching_gap;
  json["geometry"]["rms_height_m"] = s.rms_height;
  json["geometry"]["rms_slope"] = s.rms_slope;
  json["indents"] = Json::array();
  json["normalised"] = Json::array();
  for (const simulation::Indent& indent : s.indents)
  {
    json["indents"].push_back(indent_json(indent));
    json["normalised"].push_back(normalised_indent_json(c, indent));
  }
  json["energy"] = energy_json(s);
  json["residual"] = residual_json(s);
  return finished(std::move(json), c, s, info);
}

std::string summary_text(const Case& c, const simulation::RollingPlan& plan, const simulation::RollingSummary& s,
                         const RunInfo& info)
{
  Json json = head_json(c);
  json["geometry"] = geometry_json(c);
  json["geometry"]["estimated_half_width_x_m"] = plan.half_width_x;
  json["geometry"]["estimated_half_width_y_m"] = plan.half_width_y;
  const auto& drive = std::get<simulation::RollingCase>(c.scenario).drive;
  json["drive"] = {{drive.kind == contact::Drive::Kind::load ? "load_N" : "approach_m", drive.value}};
  json["max_share_at_shear_limit"] = s.max_share_at_shear_limit;
  json["passes"] = Json::array();
  for (const simulation::RollingPass& pass : s.passes)
    json["passes"].push_back(pass_json(pass));
  json["profile"] = {{"depth_m", s.profile.depth},
                     {"residual_xx_Pa", s.profile.residual_xx},
                     {"residual_yy_Pa", s.profile.residual_yy},
                     {"equivalent_plastic_strain", s.profile.equivalent_plastic_strain}};
  json["energy"] = energy_json(s);
  json["residual"] = residual_json(s);
  json["grid"]["shift_m"] = plan.shift;
  return finished(std::move(json), c, s, info);
}

} // namespace brinell::io
