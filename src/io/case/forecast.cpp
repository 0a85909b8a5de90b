// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/forecast.hpp"

#include "io/scenarios/scenario_io.hpp"
#include "result_size.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace brinell::io
{

namespace
{

struct Unit
{
  const char* name;
  double seconds;
};

Unit unit_for(double seconds)
{
  constexpr double minute = 60.0, hour = 3600.0, day = 86400.0;
  if (seconds < 100.0)
    return {"s", 1.0};
  if (seconds < 100.0 * minute)
    return {"min", minute};
  return seconds < 48.0 * hour ? Unit{"h", hour} : Unit{"days", day};
}

/// Two digits, as more would promise too much.
std::string number_text(double value)
{
  return value < 10.0 ? fmt::format("{:.2g}", value) : fmt::format("{:.0f}", value);
}

std::string time_text(const Forecast& f)
{
  constexpr double short_time = 1.0; // [s]
  if (f.longest < short_time)
    return "less than a second";
  const Unit unit = unit_for(f.seconds);
  return fmt::format("about {} {} ({} to {} {})", number_text(f.seconds / unit.seconds), unit.name,
                     number_text(f.shortest / unit.seconds), number_text(f.longest / unit.seconds), unit.name);
}

/// Memory of the library that writes the results, which keeps what it knows of the fields of earlier states (measured). Part of it
/// is memory that increments of bodies that yield have freed.
double writer_bytes(double states, simulation::Certainty certainty)
{
  constexpr double per_further_state = 0.15e6, first_states = 18.0;
  const double per_state = certainty == simulation::Certainty::elastic ? 1.1e6 : 0.8e6;
  const double more = states - 1.0;
  return per_state * std::min(more, first_states) + per_further_state * std::max(0.0, more - first_states);
}

} // namespace

simulation::Workload workload(const Case& c, const ScenarioPlan& plan)
{
  const simulation::Storage storage{stored_states(c, plan), result_bytes(c, plan)};
  return std::visit(
      [&]<typename ScenarioCase>(const ScenarioCase& scenario)
      {
        const auto& io = io_of(scenario);
        const auto& p = std::get<typename ScenarioCase::Plan>(plan);
        return simulation::workload(scenario, p, p.*io.half_x, io.course(scenario, p), storage);
      },
      c.scenario);
}

Forecast forecast(const Case& c, const ScenarioPlan& plan)
{
  const simulation::Workload work = workload(c, plan);
  const double memory = std::visit([](const simulation::Plan& p) { return p.memory_bytes; }, plan);
  return {simulation::forecast(work), memory + writer_bytes(stored_states(c, plan), work.certainty)};
}

std::string forecast_text(const Forecast& f)
{
  return fmt::format("{} on one core, {} of memory", time_text(f), size_text(f.memory));
}

} // namespace brinell::io
