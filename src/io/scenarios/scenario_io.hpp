// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/case_file.hpp"
#include "brinell/io/history_csv.hpp"
#include "brinell/io/snapshot_choice.hpp"
#include "brinell/simulation/estimates.hpp"

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
  bool moves = true; ///< the contact moves on both bodies: then x is no periodic axis
  /// Why a body cannot have that shape; empty if it can.
  std::string_view (*against_shape)(const simulation::Shape& shape) = [](const simulation::Shape&)
  { return std::string_view(); };

  // --- Output of `brinell check` ---
  std::string (*motion)(const ScenarioCase& scenario, const Plan& plan); ///< lines that begin with #
  /// Goes on with the line that tells E', and with those of first yield.
  std::string (*drive)(const ScenarioCase& scenario) = [](const ScenarioCase&) { return std::string(); };
  std::string (*drive_at_yield)(const ScenarioCase& scenario, const reference::CriticalValues& critical) =
      [](const ScenarioCase&, const reference::CriticalValues&) { return std::string(); };
  simulation::Work work{};

  // --- Steps and results ---
  bool (*is_key_step)(const ScenarioCase& scenario, const Record& record, NearestToMiddle& middle); ///< "aligned"
  double (*key_steps)(const ScenarioCase& scenario, const Plan& plan);                              ///< number of them
  std::string_view aligned{}; ///< description of these steps, if not the middles of the passes: a clause for the schema
  std::string (*place)(const Case& c, const Record& record);     ///< position of a step, for the progress display
  std::string (*results)(const Case& c, const Summary& summary); ///< lines for a terminal
  /// Puts its numbers into summary.json, between what every summary begins with and what it ends with: energies, heat, wear and
  /// residual displacement. What it says of "energy" itself comes last there.
  void (*summarise)(Json& json, const Case& c, const ScenarioCase& scenario, const Plan& plan, const Summary& summary);
  /// Lists in the summary, and their columns.
  std::vector<std::pair<std::string, std::vector<NamedNumber>>> lists{};

  // --- Accuracy ---
  std::vector<std::string> result_parts{}; ///< of the summary, beside energy, residual and the lists
  /// Names of the key numbers: "forces.peak_F_X_N"; "indents[].hardness_Pa" refers to the last entry of a list.
  std::vector<std::string> (*key_numbers)(const ScenarioCase& scenario);
  /// The key by which steps become finer; those that it leaves alone go with the cells if it is not given.
  std::string_view steps{};
  /// The drive that is imposed throughout, if there is a single one; other forces may be small compared with an imposed load.
  contact::Drive ScenarioCase::*drive_kept = nullptr;

  // --- Papers ---
  void (*cite)(Sources& sources, const ScenarioCase& scenario) = [](Sources&, const ScenarioCase&) {};
};

/// Its definition: description.hpp.
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

/// For each scenario, in their order; the action takes a ScenarioIo.
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
