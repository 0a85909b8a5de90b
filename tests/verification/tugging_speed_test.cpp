// SPDX-License-Identifier: BSD-3-Clause
#include "record.hpp"
#include "scenario_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string>

/// What the speed changes in a pass of two asperities that heat each other by friction.
namespace brinell::verification::tugging_speed_test
{
namespace
{

using simulation::TuggingCase;
using simulation::TuggingRecord;

struct Pass
{
  double F_X = 0.0, F_Z = 0.0; ///< largest values over those of friction alone
  double rise = 0.0;           ///< largest of both surfaces [K]
  double work = 0.0;           ///< of the whole pass over that of friction alone
  double energy_error = 0.0;   ///< of the balance of the pass
  double heat_error = 0.0;     ///< friction work that is not found as heat, over all of it
};

Pass pass_at(double speed, const TuggingRun& cold)
{
  const TuggingCase t = warm_spheres(perfect_material(), 4.0, speed, slow_build ? 4.0 : 8.0);
  const TuggingRun run = computed(t);
  const TuggingRecord& last = run.summary.last;
  Pass pass;
  pass.F_X = run.summary.peak_F_X / cold.summary.peak_F_X;
  pass.F_Z = run.summary.peak_F_Z / cold.summary.peak_F_Z;
  for (const TuggingRecord& r : run.history)
    pass.rise = std::max({pass.rise, r.max_temperature_lower, r.max_temperature_upper});
  pass.rise -= t.lower.material.temperature;
  pass.work = last.work / cold.summary.last.work;
  pass.energy_error = run.summary.energy_balance_error;
  pass.heat_error = 1.0 - (last.heat_lower + last.heat_upper) / last.dissipation_friction;
  return pass;
}

TuggingRun cold_pass()
{
  TuggingCase t = warm_spheres(perfect_material(), 4.0, 1.0, slow_build ? 4.0 : 8.0);
  t.speed.reset();
  for (simulation::ShapedBody* body : {&t.lower, &t.upper})
    body->material.thermal.reset();
  return computed(t);
}

/// Hotter surfaces bulge more: all forces, the work and the temperature rise with the speed, from those of friction alone.
TEST(TuggingSpeed, ForcesAndTemperaturesRiseWithIt)
{
  constexpr double all = 1e9; // no upper bound
  const TuggingRun cold = cold_pass();
  Pass slower{.F_X = 1.0, .F_Z = 1.0, .rise = 0.0, .work = 1.0};
  for (const double speed : {0.01, 0.1, 1.0, 10.0})
  {
    const Pass pass = pass_at(speed, cold);
    const std::string name = fmt::format("{:g} m/s: ", speed);
    test::expect_within(name + "largest F_X / that of friction alone", pass.F_X, slower.F_X, all,
                        "that of a lower speed");
    test::expect_within(name + "largest F_Z / that of friction alone", pass.F_Z, slower.F_Z, all,
                        "that of a lower speed");
    test::expect_within(name + "work of the pass / that of friction alone", pass.work, slower.work, all,
                        "that of a lower speed");
    test::expect_within(name + "largest rise of a surface [K]", pass.rise, slower.rise, all, "that of a lower speed");
    test::expect_close(name + "energy balance of the pass", pass.energy_error, 0.0, 5e-3, "first law");
    test::expect_close(name + "friction work not found as heat", pass.heat_error, 0.0, 1e-3, "first law");
    slower = pass;
  }
}

/// The rise is proportional to the speed where heat spreads faster than the contact moves, and so is what it changes.
TEST(TuggingSpeed, ItsLimitIsFrictionAlone)
{
  const TuggingRun cold = cold_pass();
  const Pass pass = pass_at(1e-9, cold);
  test::expect_close("1e-9 m/s: largest F_X / that of friction alone", pass.F_X, 1.0, 1e-6, "isothermal run");
  test::expect_close("1e-9 m/s: largest F_Z / that of friction alone", pass.F_Z, 1.0, 1e-6, "isothermal run");
  test::expect_close("1e-9 m/s: work of the pass / that of friction alone", pass.work, 1.0, 1e-6, "isothermal run");
}

} // namespace
} // namespace brinell::verification::tugging_speed_test
