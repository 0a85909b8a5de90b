// SPDX-License-Identifier: BSD-3-Clause
#include "summary_json.hpp"

#include "brinell/io/versions.hpp"
#include "value_text.hpp"

#include <limits>
#include <nlohmann/json.hpp>

namespace brinell::io
{

namespace
{

using Json = nlohmann::ordered_json;
using simulation::TuggingPlan;
using simulation::TuggingSummary;

constexpr double nan = std::numeric_limits<double>::quiet_NaN(); // null in JSON

Json critical_json(const Case& c)
{
  if (!c.first_yield)
    return {{"C", nullptr},           {"interference_m", nullptr},   {"load_N", nullptr},
            {"energy_J", nullptr},    {"contact_radius_m", nullptr}, {"peak_pressure_Pa", nullptr},
            {"yields_first", nullptr}};
  constexpr std::array bodies{"lower", "upper", "both"};
  const auto& critical = c.first_yield->critical;
  return {{"C", critical.C},
          {"interference_m", critical.interference},
          {"load_N", critical.load},
          {"energy_J", critical.energy},
          {"contact_radius_m", critical.contact_radius},
          {"peak_pressure_Pa", critical.peak_pressure},
          {"yields_first", bodies[static_cast<std::size_t>(c.first_yield->body)]}};
}

Json geometry_json(const simulation::TuggingCase& t, const TuggingPlan& plan)
{
  return {{"lower_radius_m", t.lower.radius},
          {"upper_radius_m", t.upper.radius},
          {"equivalent_radius_m", equivalent_radius(t)},
          {"contact_modulus_Pa", contact_modulus(t)},
          {"interference_m", t.interference},
          {"start_distance_m", plan.start_distance}};
}

Json normalised_json(const Case& c, const TuggingSummary& s)
{
  // Without first yield every quotient becomes NaN, hence null.
  const reference::CriticalValues scale =
      c.first_yield ? c.first_yield->critical
                    : reference::CriticalValues{.interference = nan, .load = nan, .energy = nan};
  return {{"interference", c.tugging.interference / scale.interference},
          {"peak_F_X", s.peak_F_X / scale.load},
          {"X_over_R_at_peak_F_X", s.X_at_peak_F_X / equivalent_radius(c.tugging)},
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

Json energy_json(const TuggingSummary& s)
{
  return {{"net_J", s.work},
          {"work_to_alignment_J", s.work_to_alignment},
          {"dissipation_lower_J", s.dissipation_lower},
          {"dissipation_upper_J", s.dissipation_upper},
          {"residual_J", s.energy_residual},
          {"balance_error", s.energy_balance_error}};
}

Json cells(const VolumeGrid& grid)
{
  return Json::array({grid.surface.nx, grid.surface.ny, grid.nz});
}

Json grid_json(const TuggingPlan& plan)
{
  return {{"spacing_m", Json::array({plan.contact.dx, plan.contact.dy, plan.lower.dz})},
          {"contact_cells", Json::array({plan.contact.nx, plan.contact.ny})},
          {"lower_cells", cells(plan.lower)},
          {"upper_cells", cells(plan.upper)},
          {"shift_m", plan.shift},
          {"memory_bytes", plan.memory_bytes}};
}

Json versions_json()
{
  const Versions versions = library_versions();
  return {
      {"brinell", versions.brinell}, {"git_hash", versions.git_hash}, {"fftw", versions.fftw}, {"hdf5", versions.hdf5}};
}

/// Dotted keys as nested objects.
Json case_json(const CaseValues& values)
{
  Json root = Json::object();
  for (const auto& [key, value] : values.all())
  {
    Json* place = &root;
    std::string_view rest = key;
    for (auto dot = rest.find('.'); dot != rest.npos; dot = rest.find('.'))
    {
      place = &(*place)[std::string(rest.substr(0, dot))];
      rest.remove_prefix(dot + 1);
    }
    (*place)[std::string(rest)] = json_value(value);
  }
  return root;
}

} // namespace

std::string summary_text(const Case& c, const TuggingPlan& plan, const TuggingSummary& s, const RunInfo& info)
{
  Json json;
  json["format"] = "brinell-summary";
  json["format_version"] = 1;
  json["complete"] = true;
  json["scenario"] = c.values.get<std::string>("scenario");
  json["title"] = c.title;
  json["critical"] = critical_json(c);
  json["geometry"] = geometry_json(c.tugging, plan);
  json["normalised"] = normalised_json(c, s);
  json["load_ratio"] = {{"aligned", s.load_ratio_aligned}, {"end", s.load_ratio_end}};
  json["forces"] = forces_json(s);
  json["energy"] = energy_json(s);
  json["residual"] = {{"max_lower_m", s.max_residual_lower},
                      {"max_upper_m", s.max_residual_upper},
                      {"max_equivalent_plastic_strain", s.max_equivalent_plastic_strain}};
  json["grid"] = grid_json(plan);
  json["run"] = {{"steps", s.steps},
                 {"iterations", s.iterations},
                 {"split_increments", s.split_increments},
                 {"threads", info.threads},
                 {"wall_time_s", info.wall_time}};
  json["versions"] = versions_json();
  json["case"] = case_json(c.values);
  // Titles come from files in any encoding: a bad byte must not cost a finished run its summary.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace brinell::io
