// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <toml++/toml.h>
#include <vector>

/// The file expected.toml of a case: a list of [[check]] with
///   key                 in summary.json, dotted
///   value | same_as     a number, or another key that must have the same value
///   relative_tolerance, absolute_tolerance   at least one; they add up
///   origin              "analytic: ...", "literature: ..." or "recorded ..."
namespace brinell::regression
{

struct Check
{
  std::string key, same_as, origin;
  double value = 0.0, relative_tolerance = 0.0, absolute_tolerance = 0.0;

  [[nodiscard]] bool is_recorded() const { return origin.starts_with("recorded"); }
};

inline std::vector<Check> read_checks(const std::filesystem::path& file)
{
  std::vector<Check> checks;
  const toml::table table = toml::parse_file(file.string());
  const toml::array* list = table["check"].as_array();
  if (!list)
    throw std::runtime_error(file.string() + ": no [[check]]");
  for (const toml::node& node : *list)
  {
    const toml::table& entry = *node.as_table();
    Check check;
    check.key = entry["key"].value_or(std::string());
    check.same_as = entry["same_as"].value_or(std::string());
    check.origin = entry["origin"].value_or(std::string());
    check.value = entry["value"].value_or(0.0);
    check.relative_tolerance = entry["relative_tolerance"].value_or(0.0);
    check.absolute_tolerance = entry["absolute_tolerance"].value_or(0.0);
    if (check.key.empty() || entry.contains("value") != check.same_as.empty() ||
        check.relative_tolerance + check.absolute_tolerance <= 0.0)
      throw std::runtime_error(file.string() +
                               ": a [[check]] needs key, value or same_as, and a tolerance: " + check.key);
    checks.push_back(check);
  }
  return checks;
}

/// A number of summary.json by its dotted key.
inline double number(const nlohmann::json& summary, const std::string& key)
{
  std::string pointer = "/" + key;
  std::replace(pointer.begin(), pointer.end(), '.', '/');
  const nlohmann::json& value = summary.at(nlohmann::json::json_pointer(pointer));
  if (!value.is_number())
    throw std::runtime_error("summary.json: " + key + " = " + value.dump() + " is no number");
  return value.get<double>();
}

/// The text of expected.toml with new recorded values; comments and everything else stay.
inline std::string updated(const std::string& text, const nlohmann::json& summary)
{
  const std::string mark = "origin = \"recorded at version " + summary["versions"]["brinell"].get<std::string>() +
                           " (" + summary["versions"]["git_hash"].get<std::string>() + ")\"";
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    lines.push_back(line);
  for (std::size_t begin = 0; begin < lines.size();)
  {
    const auto is_head = [](const std::string& line) { return line.starts_with("[[check]]"); };
    const auto first = lines.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = std::find_if(first + 1, lines.end(), is_head);
    const auto origin =
        std::find_if(first, last, [](const auto& line) { return line.starts_with("origin = \"recorded"); });
    const auto value = std::find_if(first, last, [](const auto& line) { return line.starts_with("value = "); });
    const auto key = std::find_if(first, last, [](const auto& line) { return line.starts_with("key = \""); });
    if (origin != last && value != last && key != last)
    {
      *origin = mark;
      const double found = number(summary, key->substr(7, key->rfind('"') - 7));
      std::ostringstream number_text;
      number_text.precision(8); // far below every tolerance
      number_text << std::showpoint << found;
      *value = "value = " + number_text.str();
    }
    begin = static_cast<std::size_t>(last - lines.begin());
  }
  std::string result;
  for (const std::string& line : lines)
    result += line + "\n";
  return result;
}

} // namespace brinell::regression
