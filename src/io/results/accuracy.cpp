// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace brinell::io
{

namespace
{

using Json = nlohmann::ordered_json;

/// Parts of a summary that hold results.
constexpr const char* result_parts[] = {"load_ratio", "forces", "energy", "residual", "indents", "passes"};
/// What in them is no result: which one it is, where, and the energies' own error.
constexpr const char* no_results[] = {"place", "cycle", "pass", "x_m", "balance_error"};

void collect(const Json& json, const std::string& name, Numbers& numbers)
{
  if (json.is_number())
    numbers[name] = json.get<double>();
  else if (json.is_array())
    for (std::size_t i = 0; i < json.size(); ++i)
      collect(json[i], fmt::format("{}[{}]", name, i), numbers);
  else if (json.is_object())
    for (const auto& [key, value] : json.items())
      if (std::find(std::begin(no_results), std::end(no_results), key) == std::end(no_results))
        collect(value, fmt::format("{}.{}", name, key), numbers);
}

/// What one looks for first; of a series of passes or indents, in the last one.
std::vector<std::string> key_names(const Scenario& scenario, const Numbers& numbers)
{
  std::vector<std::string> names;
  const auto last = [&](const char* list)
  {
    int count = 0;
    while (numbers.lower_bound(fmt::format("{}[{}].", list, count)) != numbers.end() &&
           numbers.lower_bound(fmt::format("{}[{}].", list, count))
               ->first.starts_with(fmt::format("{}[{}].", list, count)))
      ++count;
    return fmt::format("{}[{}].", list, count - 1);
  };
  if (std::holds_alternative<simulation::TuggingCase>(scenario))
    names = {"forces.peak_F_X_N", "forces.peak_F_Z_N", "energy.net_J", "residual.max_lower_m", "residual.max_upper_m"};
  else if (const auto* i = std::get_if<simulation::IndentationCase>(&scenario))
    for (const char* name : {i->sequence.front().kind == contact::Drive::Kind::load ? "max_approach_m" : "max_load_N",
                             "hardness_Pa", "residual_depth_m"})
      names.push_back(last("indents") + name);
  else
    for (const char* name : {"rut_depth_m", "resistance_N", "dissipation_J"})
      names.push_back(last("passes") + name);
  std::erase_if(names, [&](const std::string& name) { return !numbers.contains(name); });
  return names;
}

/// What is large for a number: a small share of the largest force, energy or length that the run has. Below it a number is as
/// good as zero, as the net energy of elastic bodies.
class ScaleOf
{
public:
  ScaleOf(const Case& c, const Numbers& numbers)
  {
    for (const auto& [name, value] : numbers)
      largest_[unit_of(name)] = std::max(largest_[unit_of(name)], std::abs(value));
    std::visit(
        [&](const auto& scenario)
        {
          const simulation::Plan plan = simulation::plan(scenario);
          largest_["_m"] = std::max(largest_["_m"], plan.scales.gap);
        },
        c.scenario);
    if (const auto* rolling = std::get_if<simulation::RollingCase>(&c.scenario))
      if (rolling->drive.kind == contact::Drive::Kind::load)
        largest_["_N"] = std::max(largest_["_N"], rolling->drive.value);
  }

  [[nodiscard]] double operator()(const std::string& name) const
  {
    constexpr double strain = 1e-4, ratio = 1e-3;
    if (const auto unit = unit_of(name); !unit.empty())
      return (unit == "_J" ? 1e-2 : 1e-3) * largest_.at(unit);
    return name.starts_with("load_ratio") ? ratio : strain;
  }

private:
  /// The longest unit that the name ends with: N/m is no length. Empty for a pure number.
  [[nodiscard]] static std::string_view unit_of(std::string_view name)
  {
    std::string_view longest;
    for (const std::string_view unit : {"_N", "_J", "_m", "_Pa", "_m2", "_N_per_m"})
      if (name.ends_with(unit) && unit.size() > longest.size())
        longest = unit;
    return longest;
  }

  std::map<std::string_view, double> largest_;
};

/// A cylinder is an odd number of cells long.
double fitting_dy(const Scenario& scenario, double dy)
{
  return std::visit(
      [dy](const auto& s)
      {
        if constexpr (requires { s.lower.shape; })
          if (const double length = simulation::roller_length(s.lower.shape, s.upper.shape); std::isfinite(length))
            return length / (2.0 * std::max(0.0, std::round(0.5 * (length / dy - 1.0))) + 1.0);
        return dy;
      },
      scenario);
}

} // namespace

Level level_of(const std::string& summary, double cells)
{
  return {cells, Json::parse(summary).at("grid").at("spacing_m").get<Vector3>(), numbers_of(summary)};
}

Numbers numbers_of(const std::string& summary)
{
  const Json json = Json::parse(summary);
  Numbers numbers;
  for (const char* part : result_parts)
    if (json.contains(part))
      collect(json[part], part, numbers);
  return numbers;
}

Case with_cells(const Case& c, double size)
{
  Case finer = c;
  std::visit(
      [&](auto& scenario)
      {
        if (!scenario.spacing)
        {
          scenario.resolution /= size;
          return;
        }
        Vector3& spacing = *scenario.spacing;
        if (size != 1.0)
          spacing = {spacing[0] * size, fitting_dy(c.scenario, spacing[1] * size), spacing[2] * size};
      },
      finer.scenario);
  return finer;
}

Accuracy accuracy_of(const Case& c, std::vector<Level> levels)
{
  Accuracy accuracy;
  accuracy.asked = c.accuracy.value_or(0.0);
  std::vector<double> cells(levels.size());
  std::transform(levels.begin(), levels.end(), cells.begin(), [](const Level& level) { return level.cells; });
  const Numbers& finest = levels.back().numbers;
  const ScaleOf scale(c, finest);
  for (const auto& [name, value] : finest)
  {
    std::vector<double> values;
    for (const Level& level : levels)
      if (const auto found = level.numbers.find(name); found != level.numbers.end() && std::isfinite(found->second))
        values.push_back(found->second);
    if (values.size() == levels.size())
      accuracy.numbers[name] = simulation::convergence(cells, values, scale(name));
  }
  accuracy.key_numbers = key_names(c.scenario, finest);
  std::erase_if(accuracy.key_numbers, [&](const std::string& name) { return !accuracy.numbers.contains(name); });
  for (const std::string& name : accuracy.key_numbers)
    accuracy.error = std::max(accuracy.error, accuracy.numbers.at(name).relative_error);
  accuracy.reached = !accuracy.key_numbers.empty() && accuracy.error <= accuracy.asked;
  accuracy.levels = std::move(levels);
  return accuracy;
}

} // namespace brinell::io
