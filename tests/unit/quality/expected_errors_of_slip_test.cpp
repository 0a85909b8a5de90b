// SPDX-License-Identifier: BSD-3-Clause
// The expected errors of creep, heat, wear and fretting: docs/verification/accuracy.md (expected error).
#include "stated_errors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace brinell::quality::expected_errors_of_slip_test
{
namespace
{

TEST(ExpectedErrorsOfSlip, OfCreepForcesAreThoseOfTheResultant)
{
  RollingCase c = ball_on_flat();
  c.friction.coefficient = 0.3;
  c.creepage = Creepage{1e-3, 0.0, 0.0};
  RollingSummary s;
  static_cast<RunTotals&>(s) = good_totals(c);
  s.passes.resize(1);
  const double largest = c.friction.coefficient * c.drive.value;
  const auto of_force = [&](double F_x, double F_y)
  {
    s.passes[0].F_x = F_x * largest;
    s.passes[0].F_y = F_y * largest;
    return find_stated(quality::judged(c, plan(c), s), "creep force").value();
  };
  const double usual = of_force(0.5, 0.0).relative;
  EXPECT_EQ(of_force(0.5, 0.0).name, "passes[*].F_x_N");
  EXPECT_EQ(of_force(1e-9, 0.5).name, "passes[*].F_y_N");
  EXPECT_DOUBLE_EQ(of_force(1e-9, 0.5).relative, usual);
  EXPECT_DOUBLE_EQ(of_force(0.1, 0.0).relative, usual);
  EXPECT_EQ(of_force(0.0, 0.0).relative, 1.0);
  // Shears of bodies that differ are large even if their sum is not.
  c.upper.material.elastic.young_modulus *= 2.0;
  EXPECT_NEAR(of_force(0.1, 0.0).relative, 3.0 * usual, 1e-12);
  c.upper.material.elastic = c.lower.material.elastic;
  // Lateral creepage and spin the other way, each of which slides everywhere alone: their errors do not cancel.
  c.creepage = Creepage{0.0, 0.01, -300.0};
  EXPECT_NEAR(of_force(0.0, 0.1).relative, 10.0 * usual, 1e-12);
  // So little creeps that both parts are a hundredth of friction times load.
  c.creepage = Creepage{0.0, 1e-6, -0.03};
  EXPECT_LT(of_force(0.0, 0.01).relative, 2.0 * usual);
}

TEST(ExpectedErrorsOfSlip, OfHeatAndWearAreThoseOfElasticBodiesAsWell)
{
  RollingCase c = ball_on_flat();
  c.lower.material.hardening.reset();
  c.slide_to_roll = 0.1;
  c.friction.coefficient = 0.1;
  RunTotals t = good_totals(c);
  t.coverage.plastic_layers = 0;
  const auto found = [&](const char* quantity) { return find_stated(quality::judged(c, plan(c), t), quantity); };
  EXPECT_FALSE(found("temperature rise") || found("worn depth"));
  c.wear.lower = 1e-15;
  ASSERT_TRUE(found("worn depth"));
  EXPECT_EQ(found("worn depth")->name, "wear.max_depth_*_m");
  EXPECT_FALSE(found("temperature rise"));
  c.wear = {};
  c.speed = 1.0;
  c.lower.material.thermal = c.upper.material.thermal = Thermal{50.0, 7850.0, 460.0, 12e-6};
  ASSERT_TRUE(found("temperature rise"));
  t.coverage.contact_columns *= 2;
  t.coverage.contact_rows *= 2;
  const double fine = found("temperature rise")->relative;
  t.coverage.contact_columns /= 2;
  EXPECT_DOUBLE_EQ(found("temperature rise")->relative, 2.0 * fine) << "first order in the cells along the motion";
  c.heat.source.shape = elastoplastic::HeatSource::Shape::contact;
  c.heat.source.power = 1.0;
  EXPECT_FALSE(found("temperature rise")) << "the tables are for friction";
}

TEST(ExpectedErrorsOfSlip, OfTheRimThatWearsInFrettingAreLarger)
{
  FrettingCase c;
  c.lower = c.upper = {Paraboloid{1e-3, 1e-3}, {{210e9, 0.3}, {}}};
  c.press = {contact::Drive::Kind::load, 2.0};
  c.friction.coefficient = 0.3;
  c.wear.lower = 1e-15;
  c.amplitude = 1e-7;
  const double sliding = plan(c).sliding_displacement;
  const auto of_amplitude = [&](double share)
  {
    c.amplitude = share * sliding;
    return stated_error(quality::judged(c, plan(c), totals(8, 0)), "worn depth");
  };
  EXPECT_DOUBLE_EQ(of_amplitude(2.0), 0.015);
  EXPECT_DOUBLE_EQ(of_amplitude(0.8), 0.06);
  EXPECT_GT(of_amplitude(0.1), 0.5) << "half a cell slips";
}

TEST(ExpectedErrorsOfSlip, OfAThinRingOfSlipGrow)
{
  FrettingCase c;
  c.lower = {Plane{}, {{210e9, 0.3}, constitutive::PerfectPlasticity{1e9}}};
  c.upper = {Paraboloid{1e-3, 1e-3}, {{210e9, 0.3}, {}}};
  c.press = {contact::Drive::Kind::load, 2.0};
  c.friction.coefficient = 0.3;
  c.amplitude = 1e-7;
  const double sliding = plan(c).sliding_displacement;
  const auto of_amplitude = [&](double share)
  {
    c.amplitude = share * sliding;
    return quality::judged(c, plan(c), totals(8, 25));
  };
  const Quality wide = of_amplitude(0.8), thin = of_amplitude(0.1);
  EXPECT_GT(stated_error(wide, "heat of friction"), 0.02);
  EXPECT_LT(stated_error(wide, "heat of friction"), 0.04);
  double before = stated_error(of_amplitude(0.3), "heat of friction");
  for (double share = 0.32; share < 0.9; share += 0.02) // through two cells, where the warning ends
  {
    const double now = stated_error(of_amplitude(share), "heat of friction");
    EXPECT_LT(now, before);
    EXPECT_GT(now, 0.8 * before) << share;
    before = now;
  }
  EXPECT_GT(stated_error(thin, "heat of friction"), 0.5);
  EXPECT_GT(stated_error(thin, "slip amplitude"), 2.0 * stated_error(wide, "slip amplitude"));
  EXPECT_NE(thin.warnings.at(0).text.find("the energy of a cycle may be off by"), std::string::npos);
}

} // namespace
} // namespace brinell::quality::expected_errors_of_slip_test
