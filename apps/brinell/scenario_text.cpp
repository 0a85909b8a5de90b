// SPDX-License-Identifier: BSD-3-Clause
#include "scenario_text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace brinell::app
{

std::string step_text(const io::Case& c, const simulation::TuggingRecord& record)
{
  return fmt::format("X/R {:+.4f}", record.X / c.equivalent_radius.value_or(1.0));
}

std::string step_text(const io::Case&, const simulation::IndentationRecord& record)
{
  if (!std::isnan(record.contact_fraction)) // a period
    return fmt::format("mean gap {:.3e} m  pressure {:.3e} Pa  contact {:.3g} %", record.mean_gap,
                       record.nominal_pressure, 100.0 * record.contact_fraction);
  return fmt::format("approach {:.3e} m  load {:.3e} N", record.approach, record.F_n);
}

std::string step_text(const io::Case&, const simulation::RollingRecord& record)
{
  return fmt::format("pass {}  x {:+.3e} m", record.pass, record.x);
}

namespace
{

/// Empty without friction.
std::string friction_text(const simulation::RunTotals& s)
{
  if (s.dissipation_friction == 0.0)
    return {};
  return fmt::format(
      "friction  {:>13.6e} J of heat; shear at the limit of the surface in up to {:.0f} % of the contact\n",
      s.dissipation_friction, 100.0 * s.max_share_at_shear_limit);
}

} // namespace

std::string summary_text(const io::Case& c, const simulation::TuggingSummary& s)
{
  const double X = s.X_at_peak_F_X / c.equivalent_radius.value_or(1.0);
  if (!c.first_yield)
    return fmt::format("peak F_X  {:>13.6e} N at X/R = {:+.5f}\nmin F_X   {:>13.6e} N\npeak F_Z  {:>13.6e} N\nnet work "
                       " {:>13.6e} J\n",
                       s.peak_F_X, X, s.min_F_X, s.peak_F_Z, s.work) +
           friction_text(s);
  const auto& critical = c.first_yield->critical;
  return fmt::format("peak F_X  {:>11.5f} P_c at X/R = {:+.5f}\nmin F_X   {:>11.5f} P_c\npeak F_Z  {:>11.5f} P_c\n"
                     "net work  {:>11.5f} U_c\n",
                     s.peak_F_X / critical.load, X, s.min_F_X / critical.load, s.peak_F_Z / critical.load,
                     s.work / critical.energy) +
         friction_text(s);
}

std::string summary_text(const io::Case&, const simulation::IndentationSummary& s)
{
  std::string text =
      "place cycle      load [N]  approach [m] hardness [Pa] unloading [N/m] residual [m]  pile-up [m]\n";
  constexpr std::size_t most_rows = 20;
  for (std::size_t n = 0; n < std::min(s.indents.size(), most_rows); ++n)
  {
    const simulation::Indent& i = s.indents[n];
    text += fmt::format("{:5} {:5} {:13.6e} {:13.6e} {:13.6e}   {:13.6e} {:12.5e} {:12.5e}\n", i.place, i.cycle,
                        i.max_load, i.max_approach, i.hardness, i.unloading_stiffness, i.residual_depth, i.pile_up);
  }
  if (s.indents.size() > most_rows)
    text += fmt::format("and {} more in summary.json\n", s.indents.size() - most_rows);
  if (std::any_of(s.indents.begin(), s.indents.end(), [](const auto& i) { return i.max_approach < 0.0; }))
    text += "approach: from where the mean planes meet; negative while peaks hold them apart\n";
  return text;
}

std::string summary_text(const io::Case&, const simulation::RollingSummary& s)
{
  std::string text = "pass      rut [m]  shoulder [m]  plastic strain     increment  dissipated [J]  resistance [N]\n";
  constexpr std::size_t most_rows = 20;
  for (std::size_t n = 0; n < std::min(s.passes.size(), most_rows); ++n)
  {
    const simulation::RollingPass& p = s.passes[n];
    text +=
        fmt::format("{:4} {:12.5e} {:13.6e} {:15.6e} {:13.6e} {:15.6e} {:15.6e}\n", n + 1, p.rut_depth,
                    p.shoulder_height, p.track_plastic_strain, p.track_plastic_increment, p.dissipation, p.resistance);
  }
  if (s.passes.size() > most_rows)
    text += fmt::format("and {} more in summary.json\n", s.passes.size() - most_rows);
  return text + friction_text(s);
}

} // namespace brinell::app
