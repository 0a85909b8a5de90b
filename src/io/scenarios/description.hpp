// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/drive_text.hpp"
#include "io/case/case_reader.hpp"
#include "io/cite/sources.hpp"
#include "io/results/summary_parts.hpp"
#include "scenario_io.hpp"

#include <algorithm>

/// Helpers for the files that describe a scenario.
namespace brinell::io
{

/// Description of a scenario. Each scenario specialises this function and instantiates `scenario_io`.
template <typename ScenarioCase>
ScenarioIo<ScenarioCase> description();

template <typename ScenarioCase>
const ScenarioIo<ScenarioCase>& scenario_io()
{
  static const ScenarioIo<ScenarioCase> io = description<ScenarioCase>();
  return io;
}

template <typename ScenarioCase>
[[nodiscard]] bool can_yield(const ScenarioCase& c)
{
  return c.lower.material.is_plastic() || c.upper.material.is_plastic();
}

/// "1 pass", "3 passes"
[[nodiscard]] inline std::string count_text(int count, std::string_view one, std::string_view several)
{
  return fmt::format("{} {}", count, count == 1 ? one : several);
}

/// A key that imposes the drive of a case; of its group, exactly one key is given.
template <typename ScenarioCase>
[[nodiscard]] Entry drive_key(const std::string& key, const ValueKind& of, const std::string& text,
                              const std::string& group, contact::Drive ScenarioCase::*drive, contact::Drive::Kind kind)
{
  return {.key = key,
          .of = of,
          .unset = "not imposed",
          .text = text,
          .one_of = group,
          .fill = [drive, kind](Case& c, const Value& value) {
            std::get<ScenarioCase>(c.scenario).*drive = {kind, std::get<double>(value)};
          }};
}

/// "load = 1.000000e+01 N"
[[nodiscard]] inline std::string text_of(const contact::Drive& drive)
{
  const auto [name, unit] = contact::text_of(drive.kind);
  return fmt::format("{} = {:.6e} {}", name, drive.value, unit);
}

/// {"load_N": 10.0}
[[nodiscard]] inline Json drive_json(const contact::Drive& drive)
{
  const auto [name, unit] = contact::text_of(drive.kind);
  return {{key_of(name, unit), drive.value}};
}

/// A table for a terminal, with a limited number of rows.
template <typename Row, typename Line>
[[nodiscard]] std::string table_text(std::string text, const std::vector<Row>& rows, const Line& line)
{
  constexpr std::size_t most_rows = 20;
  for (std::size_t n = 0; n < std::min(rows.size(), most_rows); ++n)
    text += line(rows[n]);
  if (rows.size() > most_rows)
    text += fmt::format("and {} more in summary.json\n", rows.size() - most_rows);
  return text;
}

} // namespace brinell::io
