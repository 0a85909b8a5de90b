// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/accuracy.hpp"

#include "brinell/io/member_keys.hpp"
#include "brinell/io/versions.hpp"
#include "io/case/value_text.hpp"
#include "io/scenarios/scenario_io.hpp"
#include "summary_parts.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <set>

namespace brinell::io
{

namespace
{

/// The numbers of a summary that count as results.
struct Results
{
  std::vector<std::string> parts{"energy", "residual"};
  /// Numbers in these parts that are not results: positions, indices, the error of the energy balance, and quantities that
  /// depend on the steps or the cells.
  std::set<std::string_view> excluded{"x_m", "balance_error", "max_depth_of_an_increment_m", "spots",
                                      "max_density_A_m2"};
};

Results results_of_all_scenarios()
{
  Results results;
  for (const elastoplastic::EffectColumn& total : elastoplastic::effect_columns)
    if (std::find(results.parts.begin(), results.parts.end(), total.effect) == results.parts.end())
      results.parts.emplace_back(total.effect);
  for_each_scenario(
      [&](const auto& io)
      {
        results.parts.insert(results.parts.end(), io.result_parts.begin(), io.result_parts.end());
        for (const auto& [name, columns] : io.lists)
        {
          results.parts.push_back(name);
          for (const NamedNumber& column : columns)
            if (std::holds_alternative<int>(column.value))
              results.excluded.insert(column.name);
        }
      });
  return results;
}

void collect(const Json& json, const std::string& name, const Results& results, Numbers& numbers)
{
  if (json.is_number())
  {
    if (const double number = json.get<double>(); std::isfinite(number))
      numbers[name] = number;
  }
  else if (json.is_array())
    for (std::size_t i = 0; i < json.size(); ++i)
      collect(json[i], fmt::format("{}[{}]", name, i), results, numbers);
  else if (json.is_object())
    for (const auto& [key, value] : json.items())
      if (!results.excluded.contains(key))
        collect(value, fmt::format("{}.{}", name, key), results, numbers);
}

/// The numbers and errors of a run, as its summary has them.
Level level_in(const Json& summary, double cells)
{
  Level level{
      .cells = cells, .spacing = summary.at("grid").at("spacing_m").get<Vector3>(), .numbers = {}, .stated_errors = {}};
  const Results results = results_of_all_scenarios();
  for (const std::string& part : results.parts)
    if (summary.contains(part))
      collect(summary[part], part, results, level.numbers);
  const Json& resolution = summary.at("resolution");
  const char* const stated = resolution.contains("errors_of_tables") ? "errors_of_tables" : "expected_errors";
  level.stated_errors = resolution.value(stated, level.stated_errors);
  return level;
}

/// Number of entries in a list.
int size_of(const std::string& list, const Numbers& numbers)
{
  int count = 0;
  for (auto found = numbers.begin(); found != numbers.end(); ++count)
  {
    const std::string entry = fmt::format("{}[{}].", list, count);
    found = numbers.lower_bound(entry);
    if (found == numbers.end() || !found->first.starts_with(entry))
      break;
  }
  return count;
}

/// The key numbers; "indents[].hardness_Pa" refers to the last entry of the list.
std::vector<std::string> key_names(const Scenario& scenario, const Numbers& numbers)
{
  std::vector<std::string> names = std::visit([](const auto& s) { return io_of(s).key_numbers(s); }, scenario);
  for (std::string& name : names)
    if (const auto open = name.find("[]"); open != name.npos)
      name.insert(open + 1, std::to_string(size_of(name.substr(0, open), numbers) - 1));
  names.insert(names.end(),
               {"heat.max_temperature_lower_degC", "heat.max_temperature_upper_degC"}); // only of heated runs
  std::erase_if(names, [&](const std::string& name) { return !numbers.contains(name); });
  return names;
}

/// The longest unit with which the name ends, because N/m also ends with m. Empty for a pure number.
std::string_view unit_of(const std::string& name)
{
  std::string_view longest;
  for (const std::string_view unit : {"_N", "_J", "_m", "_Pa", "_m2", "_m3", "_Nm", "_N_per_m", "_Pa_per_m", "_degC"})
    if (name.ends_with(unit) && unit.size() > longest.size())
      longest = unit;
  return longest;
}

/// The largest number of the run for each unit.
std::map<std::string_view, double> largest_by_unit(const Case& c, const Numbers& numbers)
{
  std::map<std::string_view, double> largest;
  for (const auto& [name, value] : numbers)
    largest[unit_of(name)] = std::max(largest[unit_of(name)], std::abs(value));
  std::visit(
      [&](const auto& scenario)
      {
        largest["_m"] = std::max(largest["_m"], simulation::plan(scenario).scales.gap);
        const auto drive = io_of(scenario).drive_kept;
        if (drive && (scenario.*drive).kind == contact::Drive::Kind::load)
          largest["_N"] = std::max(largest["_N"], (scenario.*drive).value);
      },
      c.scenario);
  return largest;
}

/// Scale of a number: a small share of the largest number with the same unit. Smaller numbers count as zero, for example the net
/// energy of elastic bodies.
double scale_of_number(const std::string& name, const std::map<std::string_view, double>& largest)
{
  constexpr double strain = 1e-4, ratio = 1e-3;
  if (const auto unit = unit_of(name); !unit.empty())
    return (unit == "_J" ? 1e-2 : 1e-3) * largest.at(unit);
  return name.starts_with("load_ratio") ? ratio : strain;
}

/// Whether the name of a number fits a pattern of an expected error.
bool matches(std::string_view name, std::string_view pattern)
{
  const auto star = pattern.find('*');
  return star == pattern.npos ? !pattern.empty() && name == pattern
                              : name.starts_with(pattern.substr(0, star)) && name.ends_with(pattern.substr(star + 1));
}

/// Expected error of a number and its order, from the tables that also give the expected errors of every run; none
/// without an entry.
quality::ExpectedError expected_error(const std::vector<quality::ExpectedError>& errors, std::string_view name)
{
  const auto found =
      std::find_if(errors.begin(), errors.end(), [&](const auto& error) { return matches(name, error.name); });
  return found == errors.end() ? quality::ExpectedError{} : *found;
}

/// Expected errors of a run of the series: those that it has stated itself, which know the contact as it was, otherwise
/// those before it.
std::vector<quality::ExpectedError> expected_errors(const Case& c, const Level& level)
{
  auto errors = std::visit([](const auto& scenario) { return quality::expected(scenario, simulation::plan(scenario)); },
                           with_cells(c, level.cells).scenario)
                    .resolution.expected_errors;
  for (quality::ExpectedError& error : errors)
    if (const auto stated = level.stated_errors.find(error.quantity); stated != level.stated_errors.end())
      error.relative = stated->second;
  return errors;
}

} // namespace

Level level_of(const Case& c, const simulation::AnyPlan& plan, const simulation::AnySummary& summary,
               const RunInfo& info, double cells)
{
  return level_in(summary_json(c, plan, summary, info), cells);
}

std::optional<Level> level_of_this_build(const std::string& summary, double cells)
{
  const Json json = Json::parse(summary, nullptr, false); // discarded if the file is damaged
  if (json.is_discarded() || json.value("/versions/git_hash"_json_pointer, "") != library_versions().git_hash)
    return std::nullopt;
  return level_in(json, cells);
}

Case with_cells(const Case& c, double size)
{
  Case finer = c;
  try
  {
    std::visit([size](auto& s) { quality::scale_cells(s, s.lower.shape, s.upper.shape, size); }, finer.scenario);
  }
  catch (const GridError& error)
  {
    throw InputError(fmt::format("{}: {}", c.grid_source, with_keys(error.what())));
  }
  return finer;
}

Accuracy accuracy_of(const Case& c, std::vector<Level> levels)
{
  Accuracy accuracy;
  accuracy.asked = c.accuracy.value_or(0.0);
  // A period is a whole number of cells, so that these are not exactly as asked.
  std::vector<double> cells(levels.size());
  std::transform(levels.begin(), levels.end(), cells.begin(), [](const Level& level) { return level.spacing[0]; });
  const Numbers& finest = levels.back().numbers;
  const auto largest = largest_by_unit(c, finest);
  const auto errors = expected_errors(c, levels.back());
  for (const auto& [name, value] : finest)
  {
    std::vector<double> values;
    for (const Level& level : levels)
      if (const auto found = level.numbers.find(name); found != level.numbers.end() && std::isfinite(found->second))
        values.push_back(found->second);
    if (values.size() != levels.size())
      continue;
    const quality::ExpectedError expected = expected_error(errors, name);
    accuracy.numbers[name] =
        quality::convergence(cells, values, scale_of_number(name, largest), expected.relative, expected.order);
  }
  accuracy.key_numbers = key_names(c.scenario, finest);
  std::erase_if(accuracy.key_numbers, [&](const std::string& name) { return !accuracy.numbers.contains(name); });
  for (const std::string& name : accuracy.key_numbers)
    accuracy.error = std::max(accuracy.error, accuracy.numbers.at(name).relative_error);
  accuracy.reached = !accuracy.key_numbers.empty() && accuracy.error <= accuracy.asked;
  accuracy.levels = std::move(levels);
  return accuracy;
}

void take_measured_errors(const Accuracy& accuracy, quality::Resolution& resolution)
{
  for (quality::ExpectedError& error : resolution.expected_errors)
  {
    double size = 0.0, width = 0.0;
    for (const auto& [name, number] : accuracy.numbers)
      if (matches(name, error.name))
      {
        size = std::max(size, std::abs(number.value));
        width = std::max(width, number.high - number.value);
      }
    if (size > 0.0)
      error.measured = width / size;
  }
}

std::string accuracy_advice(const Case& c, const Accuracy& accuracy)
{
  const auto error = [&](const std::string& name) { return accuracy.numbers.at(name).relative_error; };
  const auto worst = std::max_element(accuracy.key_numbers.begin(), accuracy.key_numbers.end(),
                                      [&](const auto& a, const auto& b) { return error(a) < error(b); });
  std::string text = worst == accuracy.key_numbers.end() ? "" : fmt::format("in {}; ", *worst);
  text += c.values.find("grid.spacing")      ? "a smaller grid.spacing to start with"
          : c.values.find("grid.resolution") ? "a larger grid.resolution to start with"
                                             : "more grid.cells to start with";
  const auto [steps, enough] = std::visit(
      [](const auto& scenario) { return std::pair(std::string(io_of(scenario).steps), io_of(scenario).enough_steps); },
      c.scenario);
  const Value* given = c.values.find(steps); // null for a length if the steps scale with the cells
  const auto* number = given ? std::get_if<std::int64_t>(given) : nullptr;
  if (given && !(number && *number >= enough))
    text += fmt::format(", or {} than {} = {}, which the series keeps,",
                        steps.ends_with("shift") ? "a smaller step" : "more steps", steps, toml_text(*given));
  return text + " would reduce it";
}

} // namespace brinell::io
