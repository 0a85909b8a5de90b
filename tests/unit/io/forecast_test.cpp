// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/forecast.hpp"
#include "sample.hpp"

#include <gtest/gtest.h>

namespace brinell::io::forecast_test
{

namespace
{

Forecast lasting(double seconds, double spread = 2.0)
{
  Forecast forecast;
  forecast.seconds = seconds;
  forecast.shortest = seconds / spread;
  forecast.longest = seconds * spread;
  forecast.memory = 180e6;
  return forecast;
}

TEST(Forecast, IsSaidAsARange)
{
  EXPECT_EQ(forecast_text(lasting(12.0)), "about 12 s (6 to 24 s) on one core, 180 MB of memory");
  EXPECT_EQ(forecast_text(lasting(3.0)), "about 3 s (1.5 to 6 s) on one core, 180 MB of memory");
  EXPECT_EQ(forecast_text(lasting(1200.0, 4.0)), "about 20 min (5 to 80 min) on one core, 180 MB of memory");
  EXPECT_EQ(forecast_text(lasting(4.0 * 3600.0)), "about 4 h (2 to 8 h) on one core, 180 MB of memory");
  EXPECT_EQ(forecast_text(lasting(10.0 * 86400.0)), "about 10 days (5 to 20 days) on one core, 180 MB of memory");
  EXPECT_EQ(forecast_text(lasting(0.4)), "less than a second on one core, 180 MB of memory");
}

TEST(Forecast, IsPartOfTheReport)
{
  const Case c = sample::parsed({"grid.resolution=30"});
  const ScenarioPlan plan = plan_case(c);
  EXPECT_NE(check_report(c, plan).find("# Cost: " + forecast_text(forecast(c, plan))), std::string::npos);
}

TEST(Forecast, HasAllStepsAndMoreThanOneEvaluationWhereBodiesYield)
{
  const Case c = sample::parsed();
  const ScenarioPlan plan = plan_case(c);
  const int steps = std::get<simulation::TuggingPlan>(plan).steps;
  EXPECT_EQ(workload(c, plan).steps, steps);
  EXPECT_GT(forecast(c, plan).evaluations, 1.5 * steps);
}

TEST(Forecast, CountsWhatIsStored)
{
  const auto memory = [](const std::string& snapshots)
  {
    const Case c = sample::parsed({"output.snapshots=" + snapshots});
    return forecast(c, plan_case(c)).memory;
  };
  EXPECT_GT(memory("all"), memory("none") + 2e6);
}

} // namespace

} // namespace brinell::io::forecast_test
