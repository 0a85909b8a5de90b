// SPDX-License-Identifier: BSD-3-Clause
#include "quality_cases.hpp"

#include <gtest/gtest.h>

#include <cmath>

/// Warnings about surfaces that slide: their heat and their shear limit.
namespace brinell::quality::quality_of_sliding_test
{
namespace
{

TEST(Quality, SurfacesSoHotThatConstantsAreOthers)
{
  RollingCase c = ball_on_flat();
  for (ShapedBody* body : {&c.lower, &c.upper})
  {
    body->material.thermal = Thermal{50.0, 7850.0, 460.0, 12e-6};
    body->material.temperature = 80.0;
  }
  RunTotals t = good_totals(c);
  t.max_temperature = {579.0, 80.0};
  EXPECT_EQ(after(c, t), Keys{});
  t.max_temperature = {4000.0, 80.0};
  ASSERT_EQ(after(c, t), Keys{"hot_surface"});
  const std::string of_yielding = quality::judged(c, plan(c), t).warnings.front().text;
  EXPECT_NE(of_yielding.find("the lower surface reaches 4000 degC, 3920 K above the bulk temperature"),
            std::string::npos);
  EXPECT_NE(of_yielding.find("give the material a softening law"), std::string::npos) << of_yielding;
  t.max_temperature = {581.0, 581.0};
  ASSERT_EQ(after(c, t), (Keys{"hot_surface", "hot_surface"}));
  const std::string of_elastic = quality::judged(c, plan(c), t).warnings.back().text;
  EXPECT_EQ(of_elastic.find("softening"), std::string::npos) << "the upper body does not yield: " << of_elastic;
  c.lower.material.softening = constitutive::LinearSoftening{80.0, 1500.0};
  t.max_temperature = {4000.0, 80.0};
  EXPECT_EQ(after(c, t), (Keys{"hot_surface", "melting"})) << "conductivity and modulus do not soften";
}

TEST(Quality, HeatThroughCellsThatNeitherTouchNorAreOpen)
{
  const RollingCase c = ball_on_flat();
  RunTotals t = good_totals(c);
  t.share_of_held_cells = 0.009;
  EXPECT_EQ(after(c, t), Keys{});
  t.share_of_held_cells = 0.027;
  ASSERT_EQ(after(c, t), Keys{"undecided_contact"});
  EXPECT_EQ(quality::judged(c, plan(c), t).warnings.front().text.find("2.7 % of the heat passed"), 0u);
}

TEST(Quality, HotSkinsThinnerThanTheLayers)
{
  RollingCase c = ball_on_flat();
  c.lower.material.thermal = c.upper.material.thermal = Thermal{50.0, 7850.0, 460.0, 12e-6};
  c.lower.material.hardening = constitutive::LinearHardening{1e9, 20e9};
  RunTotals t = good_totals(c);
  t.max_temperature = {c.lower.material.temperature + 300.0, c.upper.material.temperature};
  // While the contact passes a point, heat goes sqrt(4 kappa t) deep.
  const RollingPlan p = plan(c);
  const double kappa = c.lower.material.thermal->diffusivity();
  const auto speed_for = [&](double layers)
  { return 2.0 * p.half_width_x * 4.0 * kappa / std::pow(layers * p.lower.dz, 2); };
  EXPECT_EQ(after(c, t), Keys{}) << "no speed, no heat";
  c.speed = speed_for(3.1);
  EXPECT_EQ(after(c, t), Keys{});
  c.speed = speed_for(2.9);
  EXPECT_EQ(after(c, t), Keys{"thin_hot_skin"});
  t.max_temperature[0] = c.lower.material.temperature + 1.0;
  EXPECT_EQ(after(c, t), Keys{}) << "a stress of 3.6 MPa decides of no yield";
  t.max_temperature[0] = c.lower.material.temperature + 300.0;
  c.heat.stress = false;
  EXPECT_EQ(after(c, t), Keys{}) << "thermal stress is switched off";
}

TEST(Quality, SurfacesAtTheirShearStrength)
{
  RollingCase c = ball_on_flat();
  c.lower.material.hardening = constitutive::LinearHardening{1e9, 20e9};
  c.friction.coefficient = 0.4;
  c.slide_to_roll = 1.0;
  RunTotals t = good_totals(c);
  t.max_share_at_shear_limit = 0.04;
  EXPECT_EQ(after(c, t), Keys{});
  EXPECT_FALSE(quality::judged(c, plan(c), t).resolution.expected_errors.empty());
  t.max_share_at_shear_limit = 0.3;
  EXPECT_EQ(after(c, t), Keys{"surface_flow"});
  EXPECT_TRUE(quality::judged(c, plan(c), t).resolution.expected_errors.empty()) << "the tables are for less shear";
  c.friction.shear_limit = 1e8;
  EXPECT_EQ(after(c, t), Keys{}) << "a film below the strength of the surface";
  c.friction.shear_limit = 1e9;
  EXPECT_EQ(after(c, t), Keys{"surface_flow"}) << "a film that is stronger than the surface";
  EXPECT_TRUE(quality::judged(c, plan(c), t).resolution.expected_errors.empty());
  c.friction.shear_limit = 5e8;
  EXPECT_EQ(after(c, t), Keys{}) << "weaker than the surface, 577 MPa";
  c.lower.material.yield_factor = constitutive::DepthProfile({0.0, 1e-3}, {0.8, 1.0});
  EXPECT_EQ(after(c, t), Keys{"surface_flow"}) << "but stronger than one that is softer than the core";
}

TEST(Quality, AFilmThatHeatLeavesStrongerThanTheSurface)
{
  RollingCase c = ball_on_flat();
  constitutive::Material& flat = c.lower.material;
  flat.hardening = constitutive::LinearHardening{1e9, 20e9};
  flat.softening = constitutive::LinearSoftening{20.0, 1520.0};
  flat.thermal = c.upper.material.thermal = Thermal{50.0, 7800.0, 470.0, 12e-6};
  c.friction = {.coefficient = 0.4, .shear_limit = 5e8};
  c.slide_to_roll = 1.0;
  c.speed = 1.0;
  RunTotals t = good_totals(c);
  t.max_share_at_shear_limit = 0.3;
  t.max_temperature = {100.0, 100.0};
  EXPECT_EQ(after(c, t), Keys{}) << "547 MPa";
  t.max_temperature = {300.0, 300.0};
  EXPECT_EQ(after(c, t), Keys{"surface_flow"}) << "470 MPa";
}

TEST(Quality, SurfacesExpectedAtTheirShearStrength)
{
  RollingCase c = ball_on_flat();
  c.lower.material.hardening = constitutive::LinearHardening{1e9, 20e9};
  c.slide_to_roll = 1.0;
  const double limit = 1e9 / std::sqrt(3.0);
  const auto load_of = [&](double peak_pressure)
  { return load_of_peak_pressure(c.lower.shape, c.upper.shape, c.domain, 0.5 * 210e9 / 0.91, peak_pressure).value(); };
  const auto expects_errors = [&] { return !quality::expected(c, plan(c)).resolution.expected_errors.empty(); };
  // An ellipsoid as well as a ball: friction times the pressure of Hertz exceeds the limit in 4 and in 6 % of the contact.
  for (const double radius_y : {5e-3, 20e-3})
  {
    c.upper.shape = Paraboloid{5e-3, radius_y};
    c.friction.coefficient = 0.25;
    c.drive.value = load_of(limit / 0.25 / std::sqrt(0.96));
    EXPECT_EQ(before(c), Keys{}) << radius_y;
    EXPECT_TRUE(expects_errors()) << radius_y;
    c.drive.value = load_of(limit / 0.25 / std::sqrt(0.94));
    EXPECT_EQ(before(c), Keys{"surface_flow"}) << radius_y;
    EXPECT_FALSE(expects_errors()) << radius_y;
  }
  // No pressure is far above the hardness of the material.
  c.drive.value = load_of(20e9);
  c.friction.coefficient = 0.2;
  EXPECT_EQ(before(c), Keys{});
  c.friction.coefficient = 0.3;
  EXPECT_EQ(before(c), Keys{"surface_flow"});
  c.friction.shear_limit = 1e8;
  EXPECT_EQ(before(c), Keys{}) << "a film below the strength of the surface";
  c.friction.shear_limit = 1e9;
  EXPECT_EQ(before(c), Keys{"surface_flow"}) << "a film that is stronger than the surface";
  c.friction.shear_limit.reset();
  c.slide_to_roll = 0.0;
  c.creepage = Creepage{1e-4, 0.0, 0.0};
  EXPECT_EQ(before(c), Keys{}) << "most of the contact sticks";
}

} // namespace
} // namespace brinell::quality::quality_of_sliding_test
