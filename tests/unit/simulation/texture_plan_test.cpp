// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/indentation.hpp"
#include "sphere_pairs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

/// Grids of bodies with textures.
namespace brinell::simulation::texture_plan_test
{
namespace
{

TEST(TexturePlan, TexturesOfTuggingWidenTheGridsByWhatTheyCanTouch)
{
  TuggingCase t = spheres(4.0);
  t.resolution = 6.0;
  const TuggingPlan smooth = plan(t);
  EXPECT_EQ(smooth.twin, elastoplastic::Twin::mirror_image);
  t.lower.texture = Dent{.depth = -t.interference, .edge_radius = 0.125};
  const TuggingPlan rough = plan(t);
  EXPECT_EQ(rough.twin, elastoplastic::Twin::none) << "a bump has no mirror image";
  EXPECT_EQ(rough.texture_height, t.interference);
  // Spheres that are larger by the bump begin to touch farther out, and overlap farther than the elastic contact reaches.
  const double sum = 2.0 + t.interference;
  const double arc = std::acos((2.0 - t.interference) / sum);
  EXPECT_GE(0.5 * rough.lower.surface.nx * rough.lower.surface.dx, arc);
  EXPECT_GE(0.5 * rough.contact.nx * rough.contact.dx, std::sqrt(2.0 * t.interference));
  EXPECT_GT(rough.contact.ny, smooth.contact.ny);
  EXPECT_EQ(rough.contact.dx, smooth.contact.dx);
  // On a narrow bump only the columns are more.
  t.lower.texture = Dent{.depth = -t.interference, .edge_radius = 0.25e-3};
  EXPECT_EQ(plan(t).contact.ny, smooth.contact.ny);
  t.lower.texture = Dent{.depth = -1.5, .edge_radius = 0.125};
  EXPECT_NE(refusal(t).find("the textures are together 1.5 m high"), std::string::npos) << refusal(t);
}

/// A steel ball of 20 mm on a flat, pressed lightly: the smooth bodies would stay elastic.
IndentationCase light_press(double newton)
{
  const constitutive::Material steel{{210e9, 0.3}, constitutive::PerfectPlasticity{1.5e9}};
  IndentationCase c;
  c.lower = {Plane{}, steel};
  c.upper = {Paraboloid{20e-3, 20e-3}, steel};
  c.sequence = {{contact::Drive::Kind::load, newton}};
  return c;
}

/// A sinusoid along x.
HeightMap waves(double length, double amplitude, double extent)
{
  constexpr int points = 257;
  HeightMap map{points, points, extent / (points - 1), extent / (points - 1), 0.0, 0.0, {}};
  for (int j = 0; j < points; ++j)
    for (int i = 0; i < points; ++i)
      map.heights.push_back(amplitude * std::cos(2.0 * std::numbers::pi * (i - points / 2) * map.dx / length));
  return map;
}

TEST(TexturePlan, ARoughContactThatIsElasticAsAWholeNeedsLittleDepth)
{
  IndentationCase c = light_press(50.0);
  const IndentationPlan smooth = plan(c);
  constexpr double length = 30e-6;
  c.upper.texture = waves(length, 10e-9, 1.2e-3);
  const IndentationPlan rough = plan(c);
  EXPECT_GT(smooth.lower.nz * smooth.lower.dz, 1.8 * smooth.contact_radius);
  EXPECT_NEAR(rough.lower.nz * rough.lower.dz, length, 0.02 * length + rough.lower.dz);
  EXPECT_LT(static_cast<double>(rough.lower.size()), 0.2 * static_cast<double>(smooth.lower.size()));
  // Pressed so far that the smooth bodies yield, too, it needs the depth of these.
  c.sequence = {{contact::Drive::Kind::load, 5000.0}};
  const IndentationPlan deep = plan(c);
  EXPECT_GT(deep.lower.nz * deep.lower.dz, 1.8 * deep.contact_radius);
}

TEST(TexturePlan, RoughnessEverywhereIsCoveredWhereItCanTouch)
{
  IndentationCase c = light_press(50.0);
  const IndentationPlan smooth = plan(c);
  const SelfAffine p{.hurst = 0.8,
                     .rms_height = 0.3 * smooth.scales.gap,
                     .rms_slope = {},
                     .rolloff = 0.5 * smooth.contact_radius,
                     .cutoff = 0.25 * smooth.contact_radius,
                     .size_x = 8.0 * smooth.contact_radius,
                     .size_y = 8.0 * smooth.contact_radius,
                     .seed = 2};
  c.upper.texture = RandomSurface(p);
  const IndentationPlan rough = plan(c);
  EXPECT_GT(rough.contact.nx, smooth.contact.nx);
  EXPECT_LT(rough.contact.nx, 4 * smooth.contact.nx) << "but not the whole plane";
  c.upper.texture = Sinusoid{.amplitude = p.rms_height.value(), .wavelength_x = smooth.contact_radius};
  EXPECT_LT(plan(c).contact.nx, 4 * smooth.contact.nx);
  // Tugging: wherever the highest points can touch.
  TuggingCase t;
  t.lower = t.upper = {Paraboloid{20e-3, 20e-3}, c.lower.material};
  t.interference = 2e-6;
  const TuggingPlan plain = plan(t);
  SelfAffine of_tugging = p;
  of_tugging.rms_height = 2e-7;
  t.lower.texture = RandomSurface(of_tugging);
  const TuggingPlan textured = plan(t);
  EXPECT_EQ(textured.texture_height, reach(t.lower.texture).height);
  EXPECT_GT(textured.contact.ny, plain.contact.ny);
  EXPECT_LT(textured.contact.ny, 3 * plain.contact.ny);
}

TEST(TexturePlan, ATextureWidensTheGrids)
{
  IndentationCase c = light_press(50.0);
  const IndentationPlan smooth = plan(c);
  c.lower.texture =
      Dent{.y = 0.4e-3, .depth = -6e-6, .edge_radius = 0.075e-3}; // a bump beside the contact, which bears
  const IndentationPlan rough = plan(c);
  EXPECT_EQ(rough.contact.dy, smooth.contact.dy);
  EXPECT_LT(smooth.contact.ny * smooth.contact.dy, 2.0 * 0.4e-3);
  EXPECT_GT(rough.contact.ny * rough.contact.dy, 2.0 * 0.4e-3);
}

} // namespace
} // namespace brinell::simulation::texture_plan_test
