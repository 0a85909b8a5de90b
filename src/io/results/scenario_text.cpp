// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/scenario_text.hpp"
#include "brinell/quality/quality.hpp"

#include "fatigue_parts.hpp"
#include "io/scenarios/scenario_io.hpp"

#include <fmt/format.h>

namespace brinell::io
{

namespace
{

/// Line about friction; empty without friction.
std::string friction_text(const simulation::RunTotals& s)
{
  if (s.dissipation_friction == 0.0)
    return {};
  std::string text = fmt::format("friction  {:>13.6e} J of heat", s.dissipation_friction);
  if (s.max_share_at_shear_limit > 0.0)
    text += fmt::format("; shear at the limit of the surface in up to {} of the contact",
                        quality::percent_text(s.max_share_at_shear_limit));
  return text + "\n";
}

/// Lines about the effects that act: their totals by the names of their columns.
std::string effects_text(const simulation::PairCase& c, const simulation::RunTotals& s)
{
  constexpr std::size_t width = 100;
  std::string text;
  for (const std::string_view name : elastoplastic::names_of(c, {&c.lower.material, &c.upper.material}))
  {
    std::string line = fmt::format("{:<9}", name);
    for (const elastoplastic::EffectColumn& total : elastoplastic::effect_columns)
      if (total.effect == name)
      {
        const auto& column = total.column;
        const double value = std::visit([](auto number) { return static_cast<double>(number); }, column.value(s));
        const std::string part =
            fmt::format(" {} {:.6g} {}", column.name, value, column.unit == "1" ? "" : column.unit);
        if (line.size() + part.size() > width)
        {
          text += line + ",\n";
          line = std::string(9, ' ');
        }
        else if (line.size() > 9)
          line += ',';
        line += part;
      }
    text += line + "\n";
  }
  return text;
}

} // namespace

std::string step_text(const Case& c, const simulation::AnyRecord& record)
{
  return std::visit([&]<typename ScenarioCase>(const ScenarioCase& scenario)
                    { return io_of(scenario).place(c, record_of<ScenarioCase>(record)); },
                    c.scenario);
}

std::string results_text(const Case& c, const simulation::AnySummary& summary)
{
  return std::visit(
      [&]<typename ScenarioCase>(const ScenarioCase& scenario)
      {
        const auto& s = summary_of<ScenarioCase>(summary);
        return io_of(scenario).results(c, s) + friction_text(s) + effects_text(scenario, s) + fatigue_text(s);
      },
      c.scenario);
}

} // namespace brinell::io
