// SPDX-License-Identifier: BSD-3-Clause
#include "record.hpp"
#include "scenario_runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

/// Heat of friction on surfaces that are strained: their slip is not that of the undeformed ones everywhere.
namespace brinell::verification::slip_heat_test
{
namespace
{

using elastoplastic::HeatRegime;
using simulation::RollingCase;

constexpr double pi = std::numbers::pi;
constexpr double poisson_ratio = 0.4999; // pressure does not stretch the surfaces, nor does shear move the gap

/// An elastic ball that skids on an elastic flat.
RollingCase skidding(double upper_stiffness, double cells)
{
  constitutive::Material lower{{200e9, poisson_ratio}, {}}, upper = lower;
  upper.elastic.young_modulus *= upper_stiffness;
  lower.thermal = upper.thermal = Thermal{50.0, 7800.0, 470.0, 0.0};
  if (upper.elastic.is_rigid())
    upper.elastic.poisson_ratio = 0.0;
  RollingCase c;
  c.lower = {simulation::Plane{}, lower};
  c.upper = {ball(10e-3), upper};
  c.drive = load(200.0);
  c.load_steps = 1;
  c.resolution = cells;
  c.slide_to_roll = 0.1;
  c.friction.coefficient = 0.2;
  c.speed = 1.0;
  c.heat.partition = 0.5;
  c.heat.regime = HeatRegime::steady;
  c.heat.displacement = false;
  c.distance = 1e-3; // until the contact is known
  c.distance = simulation::plan(c).half_width_x;
  return c;
}

/// Heat per area of a step over the shear times the sliding of the undeformed surfaces, at cells on the line y = 0.
std::vector<double> slip_ratio(const RollingCase& c, double radius, std::vector<double>& places)
{
  simulation::Run<RollingCase> run(c);
  for (int step = 0; step < 3; ++step) // the surfaces slide steadily from the second step of sliding on
    static_cast<void>(run.step());
  const simulation::Snapshot s = run.snapshot();
  const SurfaceGrid& g = s.contact;
  const double sliding = *c.speed * (1.0 - upper_share(c));
  std::vector<double> ratio;
  for (int i = 0; i < g.nx; ++i)
    if (std::abs(g.x(i)) < 0.8 * radius)
    {
      const std::size_t here = g.index(i, g.ny / 2);
      places.push_back(g.x(i) / radius);
      ratio.push_back((s.heat_flux[0][here] + s.heat_flux[1][here]) / (std::abs(s.shear[0][here]) * sliding));
    }
  return ratio;
}

TEST(SlipHeat, ShearStretchesTheSurfacesOfASkiddingBall)
{
  for (const double stiffness : {1.0, 3.0, std::numeric_limits<double>::infinity()})
    for (const double cells : {8.0, 16.0})
    {
      const RollingCase c = skidding(stiffness, cells);
      const double modulus = contact_modulus(c.lower.material.elastic, c.upper.material.elastic);
      const double radius = std::cbrt(0.75 * c.drive.value * 10e-3 / modulus);
      const double shear = c.friction.coefficient * 1.5 * c.drive.value / (pi * radius * radius);
      // Within a circle under shear as Hertz's pressure, u_x = pi q/(32 G a) [4 (2 - nu) a^2 - (4 - 3 nu) x^2 - (4 - nu) y^2] (Johnson
      // 1985, Eq. 3.91a). The material passes with the speed V, so that its surface is displaced by -V du_x/dx per time.
      const auto passed = [&](double speed, const Elastic& body)
      { return body.is_rigid() ? 0.0 : speed / body.shear_modulus(); };
      const double lower_speed = *c.speed, upper_speed = lower_speed * upper_share(c);
      const double front =
          pi * shear * (4.0 - 3.0 * poisson_ratio) / 16.0 *
          (passed(lower_speed, c.lower.material.elastic) + passed(upper_speed, c.upper.material.elastic)) /
          (lower_speed - upper_speed);
      std::vector<double> places;
      const std::vector<double> ratio = slip_ratio(c, radius, places);
      double mean = 0.0, slope = 0.0, squares = 0.0;
      for (std::size_t i = 0; i < places.size(); ++i)
      {
        mean += ratio[i] / static_cast<double>(places.size());
        slope += ratio[i] * places[i];
        squares += places[i] * places[i];
      }
      // Slopes are differences between cells: second order.
      const std::string name = fmt::format("ball {} times as stiff as the flat, {} cells: ", stiffness, cells);
      EXPECT_GT(front, 0.04);
      test::expect_close(name + "mean slip / that of undeformed surfaces", mean, 1.0, 1e-4,
                         "by symmetry; pressure stretches them by (1 - 2 nu) of p/E");
      test::expect_close(name + "slip lost per radius towards the front / the same", -slope / squares, front,
                         0.15 * front / (cells * cells), "exact: Johnson (1985), Eq. 3.91a");
    }
}

// The step that lifts the ball includes its way back, during which no heat passes through the gap: only the heat that the surfaces
// make as they part is added, whatever the difference of their temperatures.
TEST(SlipHeat, PartedSurfacesExchangeNothingOnTheWayBack)
{
  RollingCase c = skidding(1.0, 4.0);
  c.heat.partition.reset();
  c.heat.regime = HeatRegime::transient;
  c.upper.material.temperature = c.lower.material.temperature + 100.0;
  const RollingRun run = computed(c);
  const auto& lifted = run.history.back();
  const auto& before = run.history[run.history.size() - 2];
  EXPECT_LT(before.heat_upper, -1e-3 * lifted.dissipation_friction) << "the hot ball loses heat while it touches";
  // Both take halves of what friction leaves in the last step.
  const double last = lifted.dissipation_friction - before.dissipation_friction;
  EXPECT_NEAR(lifted.heat_upper - before.heat_upper, 0.5 * last, 1e-9 * std::abs(before.heat_upper));
  EXPECT_NEAR(lifted.heat_lower - before.heat_lower, 0.5 * last, 1e-9 * std::abs(before.heat_upper));
}

} // namespace
} // namespace brinell::verification::slip_heat_test
