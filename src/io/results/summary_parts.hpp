// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/case_file.hpp"
#include "brinell/simulation/columns.hpp"

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

/// Functions with which a scenario writes its parts of summary.json.
namespace brinell::io
{

using Json = nlohmann::ordered_json;
struct RunInfo;

/// Content of summary.json.
[[nodiscard]] Json summary_json(const Case& c, const simulation::AnyPlan& plan, const simulation::AnySummary& summary,
                                const RunInfo& info);

/// Values at first yield, by which results are normalised. Without first yield they are NaN, so that every quotient is NaN and
/// becomes null in JSON.
[[nodiscard]] reference::CriticalValues scale_of(const Case& c);

[[nodiscard]] Json geometry_json(const Case& c);
/// Key of a number: its name and, unless it is a pure number, its unit, as in "hardness_Pa", "loading_stiffness_N_per_m".
[[nodiscard]] std::string key_of(std::string_view name, std::string_view unit);

template <typename Record>
void put(Json& json, const Column<Record>& column, const Record& record)
{
  std::visit([&](auto number) { json[key_of(column.name, column.unit)] = number; }, column.value(record));
}

/// An object with all columns of a record.
template <typename Record>
[[nodiscard]] Json row_json(const Record& record)
{
  Json json;
  for (const auto& column : simulation::columns<Record>)
    put(json, column, record);
  return json;
}

template <typename Record>
[[nodiscard]] Json rows_json(const std::vector<Record>& records)
{
  Json json = Json::array();
  for (const Record& record : records)
    json.push_back(row_json(record));
  return json;
}

} // namespace brinell::io
