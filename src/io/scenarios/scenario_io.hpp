// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/case_file.hpp"
#include "brinell/io/history_csv.hpp"
#include "brinell/io/snapshot_choice.hpp"
#include "brinell/simulation/estimates.hpp"
#include "brinell/simulation/forecast.hpp"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace brinell::io
{

struct CaseReader;
class Sources;
using Json = nlohmann::ordered_json;

/// Everything about one scenario that files and messages need, defined in src/io/scenarios/NAME.cpp. The code that treats all
/// scenarios alike (case, results, cite) names none of them.
template <typename ScenarioCase>
struct ScenarioIo
{
  using Plan = typename ScenarioCase::Plan;
  using Record = typename ScenarioCase::Record;
  using Summary = typename ScenarioCase::Summary;

  // --- The case file ---
  std::string_view name; ///< the word of the key `scenario`; also its table and its template
  std::string_view text; ///< description of the scenario, a clause
  std::vector<Entry> (*keys)();
  /// Reads the keys that need more than the schema, after bodies and domain have been read.
  /// @returns the key to which problems of the plan are attributed
  std::string (*read)(const CaseReader& reader, Case& c, ScenarioCase& scenario);
  double Plan::*half_x; ///< half-lengths of the contact, estimates [m]
  double Plan::*half_y;
  bool moves = true;           ///< whether the contact moves on both bodies; then the x axis cannot be periodic
  const char* speed = "speed"; ///< name of the key of the case that gives the pace of the motion, on which heat depends
  /// Why the scenario does not allow a shape; empty if it does.
  std::string_view (*against_shape)(const simulation::Shape& shape) = [](const simulation::Shape&)
  { return std::string_view(); };

  // --- Output of `brinell check` ---
  std::string (*motion)(const ScenarioCase& scenario, const Plan& plan); ///< lines that begin with #
  /// Text that is appended to the line with E', and lines that are appended to those of first yield.
  std::string (*drive)(const ScenarioCase& scenario) = [](const ScenarioCase&) { return std::string(); };
  std::string (*drive_at_yield)(const ScenarioCase& scenario, const reference::CriticalValues& critical) =
      [](const ScenarioCase&, const reference::CriticalValues&) { return std::string(); };
  simulation::Course (*course)(const ScenarioCase& scenario, const Plan& plan); ///< on which the time depends

  // --- Steps and results ---
  bool (*is_key_step)(const ScenarioCase& scenario, const Record& record, NearestToMiddle& middle); ///< "aligned"
  double (*key_steps)(const ScenarioCase& scenario, const Plan& plan);                              ///< number of them
  std::string_view aligned{}; ///< description of these steps, if not the middles of the passes: a clause for the schema
  std::string (*place)(const Case& c, const Record& record);     ///< position of a step, for the progress display
  std::string (*results)(const Case& c, const Summary& summary); ///< lines for a terminal
  /// Adds the numbers of the scenario to summary.json, between the first part of every summary and its last one: energies, heat,
  /// wear and residual displacement. Numbers that the scenario adds to "energy" come last there.
  void (*summarise)(Json& json, const Case& c, const ScenarioCase& scenario, const Plan& plan, const Summary& summary);
  /// Lists in the summary, and their columns.
  std::vector<std::pair<std::string, std::vector<NamedNumber>>> lists{};

  // --- Accuracy ---
  std::vector<std::string>
      result_parts{}; ///< parts of the summary with results, besides energy, residual and the lists
  /// Names of the key numbers: "forces.peak_F_X_N"; "indents[].hardness_Pa" refers to the last entry of a list.
  std::vector<std::string> (*key_numbers)(const ScenarioCase& scenario);
  /// The key that sets the size or number of the steps. If it is not given, the steps scale with the cells.
  std::string_view steps{};
  int enough_steps = 0; ///< number of steps above which more of them change little; 0 if the key is a length
  /// The drive that is kept throughout the run, if there is a single one. Forces are compared with an imposed load.
  contact::Drive ScenarioCase::*drive_kept = nullptr;

  // --- Papers ---
  void (*cite)(Sources& sources, const ScenarioCase& scenario) = [](Sources&, const ScenarioCase&) {};
};

/// The description of a scenario; defined in description.hpp.
template <typename ScenarioCase>
[[nodiscard]] const ScenarioIo<ScenarioCase>& scenario_io();

template <typename ScenarioCase>
[[nodiscard]] const ScenarioIo<ScenarioCase>& io_of(const ScenarioCase& /*scenario*/)
{
  return scenario_io<ScenarioCase>();
}

template <typename ScenarioCase>
[[nodiscard]] const typename ScenarioCase::Record& record_of(const simulation::AnyRecord& record)
{
  return std::get<std::reference_wrapper<const typename ScenarioCase::Record>>(record);
}
template <typename ScenarioCase>
[[nodiscard]] const typename ScenarioCase::Summary& summary_of(const simulation::AnySummary& summary)
{
  return std::get<std::reference_wrapper<const typename ScenarioCase::Summary>>(summary);
}

template <typename... ScenarioCases>
struct EachScenario
{
  template <typename Action>
  static void take(const Action& action)
  {
    (action(scenario_io<ScenarioCases>()), ...);
  }
};

/// Calls an action with the ScenarioIo of each scenario, in their order.
template <typename Action>
void for_each_scenario(const Action& action)
{
  simulation::Scenarios<EachScenario>::take(action);
}

/// Names of the scenarios for which a condition holds.
template <typename Predicate>
[[nodiscard]] std::vector<std::string> scenarios_with(const Predicate& holds)
{
  std::vector<std::string> names;
  for_each_scenario(
      [&](const auto& io)
      {
        if (holds(io))
          names.emplace_back(io.name);
      });
  return names;
}

} // namespace brinell::io
