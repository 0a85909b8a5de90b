// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/case_file.hpp"
#include "brinell/io/case_template.hpp"

#include <stdexcept>
#include <string>
#include <variant>

/// A case of every scenario, also of one that is new: that of `brinell new`, on few cells.
namespace brinell::test
{

/// The key, as for --set, that gives the case of a scenario few cells.
inline std::string few_cells(const std::string& scenario)
{
  const bool has_period = io::case_template(scenario).find("\nspacing = ") != std::string::npos;
  return has_period ? R"(grid.spacing=["10 um", "10 um", "5 um"])" : "grid.resolution=3";
}

template <typename ScenarioCase>
ScenarioCase template_case()
{
  for (const std::string& scenario : io::scenario_names())
  {
    const io::Case c = io::parse_case(io::case_template(scenario), "case.toml", {few_cells(scenario)});
    if (const auto* found = std::get_if<ScenarioCase>(&c.scenario))
      return *found;
  }
  throw std::logic_error("no template is of this scenario");
}

} // namespace brinell::test
