// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/scenario_text.hpp"
#include "brinell/quality/quality.hpp"

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

/// Line about wear; empty without wear.
std::string wear_text(const simulation::RunTotals& s)
{
  if (s.worn_volume_lower == 0.0 && s.worn_volume_upper == 0.0)
    return {};
  return fmt::format(
      "wear      {:>13.6e} m^3 of the lower body, up to {:.3e} m deep; {:.6e} m^3 of the upper one, up to "
      "{:.3e} m\n",
      s.worn_volume_lower, s.max_worn_depth_lower, s.worn_volume_upper, s.max_worn_depth_upper);
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
        return io_of(scenario).results(c, s) + friction_text(s) + wear_text(s);
      },
      c.scenario);
}

} // namespace brinell::io
