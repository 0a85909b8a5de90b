// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/reference/hertz.hpp"
#include "brinell/reference/sliding_contact.hpp"
#include "brinell/simulation/first_yield.hpp"
#include "brinell/simulation/indentation.hpp"
#include "brinell/simulation/quality.hpp"
#include "brinell/simulation/run.hpp"
#include "brinell/simulation/tugging.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>

namespace brinell::simulation
{
namespace
{

constexpr double critical_interference = 2.214290e-4; // Boucly, Nelias & Green (2006)

TuggingCase spheres(double interference_ratio)
{
  const constitutive::Material material{{200e9, 0.32}, constitutive::PerfectPlasticity{0.9115e9}};
  TuggingCase t;
  t.lower = {Paraboloid{1.0, 1.0}, material};
  t.upper = {Paraboloid{1.0, 1.0}, material};
  t.interference = interference_ratio * critical_interference;
  return t;
}

TuggingCase paper()
{
  TuggingCase t = spheres(9.0);
  t.spacing = {{3.85e-3, 7.7e-3, 1.925e-3}};
  return t;
}

std::string refusal(const TuggingCase& tugging)
{
  try
  {
    (void)plan(tugging);
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "";
}

// Of the case file these are checked by its reader; a program may give them, too.
TEST(PlanTest, WhatAProgramMustNotGiveIsRefused)
{
  IndentationCase good;
  good.lower = {Plane{}, {{210e9, 0.3}, {}}};
  good.upper = {Paraboloid{1e-3, 1e-3}, {{210e9, 0.3}, {}}};
  good.sequence = {{contact::Drive::Kind::load, 50.0}};
  ASSERT_NO_THROW((void)plan(good));
  const std::function<void(IndentationCase&)> mistakes[] = {
      [](auto& c) { c.steps = 0; },
      [](auto& c) { c.steps = -3; },
      [](auto& c) { c.sequence.clear(); },
      [](auto& c) { c.places.clear(); },
      [](auto& c) { c.resolution = 0.0; },
      [](auto& c) { c.extent = -1.0; },
      [](auto& c) {
        c.spacing = {{1e-6, 0.0, 1e-6}};
      },
      [](auto& c) {
        c.upper.shape = Paraboloid{0.0, 0.0};
      },
      [](auto& c) { c.sequence[0].value = -5.0; },
      [](auto& c) { c.sequence[0].value = std::numeric_limits<double>::quiet_NaN(); },
  };
  for (std::size_t i = 0; i < std::size(mistakes); ++i)
  {
    IndentationCase bad = good;
    mistakes[i](bad);
    EXPECT_THROW((void)plan(bad), InputError) << "mistake " << i;
  }
}

TEST(PlanTest, GridOfThePaper)
{
  const TuggingPlan p = plan(paper());
  EXPECT_EQ(p.contact, (SurfaceGrid{33, 13, 3.85e-3, 7.7e-3})); // the paper's points in x and y
  EXPECT_EQ(p.lower.nz, 31);
  EXPECT_EQ(p.lower.dz, 1.925e-3);
  EXPECT_EQ(p.lower, p.upper);
  EXPECT_EQ(p.steps_per_pass, 24);
  EXPECT_EQ(p.shift, 3.85e-3);
  EXPECT_NEAR(p.start_distance, 0.089261, 0.5e-6);
  EXPECT_NEAR(p.elastic_contact_radius, std::sqrt(0.5 * 9.0 * critical_interference), 1e-15);
  EXPECT_GT(p.memory_bytes, 1e6);
  EXPECT_LT(p.memory_bytes, 1e9);
}

TEST(PlanTest, ResolutionGivesTheCells)
{
  TuggingCase t = spheres(4.0);
  for (const double resolution : {3.0, 8.0, 12.5})
  {
    t.resolution = resolution;
    const TuggingPlan p = plan(t);
    const double cell = p.elastic_contact_radius / resolution;
    EXPECT_DOUBLE_EQ(p.contact.dx, cell);
    EXPECT_DOUBLE_EQ(p.contact.dy, 2.0 * cell);
    EXPECT_DOUBLE_EQ(p.lower.dz, 0.5 * cell);
    EXPECT_DOUBLE_EQ(p.shift, cell);
  }
}

TEST(PlanTest, GridsHoldTheContactAndTheTrack)
{
  TuggingCase t = spheres(9.0);
  t.upper.shape = Paraboloid{2.5, 2.5};
  t.resolution = 6.0;
  const TuggingPlan p = plan(t);
  const double a = p.elastic_contact_radius, dx = p.contact.dx;
  const double theta0 = std::atan2(p.start_distance, 3.5 - t.interference);
  // An odd number of cells: one in the middle, where the spheres first touch at alignment.
  for (const int n : {p.contact.nx, p.contact.ny, p.lower.surface.nx, p.upper.surface.nx})
    EXPECT_EQ(n % 2, 1);
  // A fully plastic contact reaches 1.15 elastic radii.
  EXPECT_GE(0.5 * p.contact.nx * dx, 1.15 * a);
  EXPECT_GE(0.5 * p.contact.ny * p.contact.dy, 1.15 * a);
  EXPECT_GE(p.lower.nz * p.lower.dz, 1.6 * a);
  for (const auto& [grid, radius] : {std::pair{p.lower, 1.0}, std::pair{p.upper, 2.5}})
  {
    EXPECT_GE(0.5 * grid.surface.nx * dx, radius * theta0); // the arc from first touch to alignment
    EXPECT_GE(0.5 * grid.surface.nx * dx, 1.15 * a);
    EXPECT_EQ(grid.surface.ny, p.contact.ny); // rows and cells coincide
    EXPECT_EQ(grid.surface.dx, dx);
    EXPECT_EQ(grid.surface.dy, p.contact.dy);
  }
  EXPECT_GT(p.upper.surface.nx, p.lower.surface.nx); // the larger sphere is passed over a longer arc
}

TEST(PlanTest, TuggingTakesWhatCanPass)
{
  TuggingCase t = spheres(4.0);
  constexpr double infinite = std::numeric_limits<double>::infinity();
  for (const Shape& shape : {Shape(Plane{}), Shape(Cone{1.2, 0.0}), Shape(Pyramid{4, 1.2, 0.0}),
                             Shape(Paraboloid{-3.0, 1.0}), Shape(Paraboloid{infinite, 1.0})})
  {
    t.upper.shape = shape;
    EXPECT_EQ(refusal(t),
              "upper.shape has no radius > 0 in the plane of motion and cannot pass another body; allowed in "
              "tugging: paraboloids with radius_x > 0, and rollers");
    EXPECT_FALSE(passing_radius(shape).has_value());
  }
  // Two endless cylinders touch in a line without ends.
  t.lower.shape = t.upper.shape = Paraboloid{1.0, infinite};
  EXPECT_NE(refusal(t).find("neither in a point nor in a line of finite length"), std::string::npos);
  t.upper.shape = Roller{1.0, 0.2};
  const TuggingPlan roller = plan(t);
  EXPECT_DOUBLE_EQ(roller.elastic_contact_radius_y, 0.1);
  const double rows = 0.2 / roller.contact.dy;
  EXPECT_NEAR(rows, std::round(rows), 1e-9) << "the ends are those of cells";
  EXPECT_GT(roller.contact.ny * roller.contact.dy, 0.2);
}

TEST(PlanTest, TexturesOfTuggingWidenTheGridsByWhatTheyCanTouch)
{
  TuggingCase t = spheres(4.0);
  t.resolution = 6.0;
  const TuggingPlan smooth = plan(t);
  EXPECT_EQ(smooth.twin, elastoplastic::Twin::mirror_image);
  t.lower.texture = Dent{.depth = -t.interference, .radius = 0.5};
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
  t.lower.texture = Dent{.depth = -t.interference, .radius = 1e-3};
  EXPECT_EQ(plan(t).contact.ny, smooth.contact.ny);
  t.lower.texture = Dent{.depth = -1.5, .radius = 0.5};
  EXPECT_NE(refusal(t).find("the textures are together 1.5 m high"), std::string::npos) << refusal(t);
}

TEST(PlanTest, FirstYieldOfAHardenedLayerIsThatOfItsCoreInEveryScenario)
{
  // The yield stress is that of the surface; below the layer it is half of it.
  TuggingCase t = spheres(4.0);
  for (ShapedBody* body : {&t.lower, &t.upper})
    body->material.yield_factor = constitutive::DepthProfile({5e-3, 10e-3}, {1.0, 0.5});
  IndentationCase i;
  i.lower = t.lower;
  i.upper = t.upper;
  i.sequence = {{contact::Drive::Kind::approach, t.interference}};
  const double of_core = 0.25 * critical_interference; // the approach goes with the square of the pressure
  EXPECT_NEAR(plan(t).scales.displacement, of_core, 1e-5 * of_core);
  EXPECT_NEAR(plan(i).scales.displacement, of_core, 1e-5 * of_core);
  // The units of the paper stay those of the nominal yield stress.
  EXPECT_EQ(nominal_yield(t.lower.material, t.upper.material, ContactKind::point)->yield_stress, 0.9115e9);
  EXPECT_EQ(earliest_yield(t.lower.material, t.upper.material, ContactKind::point, 0.0)->yield_stress, 0.5 * 0.9115e9);
  EXPECT_NEAR(nominal_first_yield(t.lower, t.upper, t.domain)->critical.interference, critical_interference, 1e-10);
  EXPECT_NEAR(earliest_first_yield(t.lower, t.upper, t.domain, 0.0)->critical.interference, of_core, 1e-10);
  // A layer that is hard throughout yields late.
  t.lower.material.yield_factor = t.upper.material.yield_factor = constitutive::DepthProfile({0.0}, {1.2});
  EXPECT_NEAR(plan(t).scales.displacement, 1.44 * critical_interference, 1e-5 * critical_interference);
}

TEST(FirstYield, IsThatOfTheWeakerBody)
{
  const constitutive::Material weak{{200e9, 0.3}, constitutive::PerfectPlasticity{0.5e9}};
  const constitutive::Material strong{{200e9, 0.3}, constitutive::PerfectPlasticity{1e9}};
  const constitutive::Material elastic{{200e9, 0.3}, {}};
  for (const ContactKind kind : {ContactKind::point, ContactKind::line})
  {
    const auto of = [kind](const auto& lower, const auto& upper) { return nominal_yield(lower, upper, kind); };
    EXPECT_EQ(of(weak, strong)->body, YieldsFirst::lower);
    EXPECT_EQ(of(strong, weak)->body, YieldsFirst::upper);
    EXPECT_EQ(of(weak, weak)->body, YieldsFirst::both);
    EXPECT_EQ(of(elastic, weak)->body, YieldsFirst::upper);
    EXPECT_FALSE(of(elastic, elastic).has_value());
    EXPECT_EQ(of(elastic, weak)->peak_pressure(), of(weak, weak)->peak_pressure());
  }
  // From nu = 0 to 0.3, C grows from 1 to 1.79 of a line, and from 1.30 to 1.61 only of a point.
  const constitutive::Material at_zero{{200e9, 0.0}, constitutive::PerfectPlasticity{0.7e9}};
  EXPECT_EQ(nominal_yield(at_zero, weak, ContactKind::point)->body, YieldsFirst::upper);
  EXPECT_EQ(nominal_yield(at_zero, weak, ContactKind::line)->body, YieldsFirst::lower);
}

/// Two cylinders of 1 m and 3 m in plane strain.
TuggingCase cylinders()
{
  TuggingCase t = spheres(1.0);
  t.lower.shape = Roller{1.0, std::numeric_limits<double>::infinity()};
  t.upper.shape = Roller{3.0, std::numeric_limits<double>::infinity()};
  t.domain.y = {Boundary::periodic, 2.0, 1};
  return t;
}

TEST(FirstYield, OfCylindersInPlaneStrainIsThatOfTheirLineContact)
{
  TuggingCase t = cylinders();
  const auto yield = nominal_first_yield(t.lower, t.upper, t.domain);
  ASSERT_TRUE(yield);
  const double modulus = contact_modulus(t.lower.material.elastic, t.upper.material.elastic);
  const double C = reference::line_contact_first_yield(0.32).pressure_ratio;
  const reference::Line line{2.0, 2.0 * 0.75 / std::numbers::e};
  const auto critical = reference::critical_values(0.75, modulus, C, 0.9115e9, line);
  EXPECT_NEAR(yield->critical.interference / critical.interference, 1.0, 1e-14);
  EXPECT_NEAR(yield->critical.load / critical.load, 1.0, 1e-14);
  EXPECT_NEAR(yield->critical.energy / critical.energy, 1.0, 1e-14);
  // The approach counts from the reference of the case, and the plan's own first yield is the same.
  t.domain.reference = 0.2;
  const double alpha_c = nominal_first_yield(t.lower, t.upper, t.domain)->critical.interference;
  EXPECT_NEAR(alpha_c / reference::critical_values(0.75, modulus, C, 0.9115e9, {2.0, 0.2}).interference, 1.0, 1e-14);
  t.interference = 3.0 * alpha_c;
  EXPECT_NEAR(plan(t).scales.displacement, alpha_c, 1e-9 * alpha_c);
  t.interference = alpha_c * (1.0 - 1e-9);
  EXPECT_EQ(expected_quality(t, plan(t)).warnings.front().key, "no_yield");
}

TEST(FirstYield, HasAReasonWhereItIsNotInClosedForm)
{
  const auto reason = [](const TuggingCase& t)
  { return reason_against_first_yield(t.lower, t.upper, t.domain).value_or("none"); };
  TuggingCase t = cylinders();
  EXPECT_EQ(reason(t), "none");
  t.domain.reference = 1e-3; // a_c is 22 mm
  EXPECT_EQ(reason(t), "grid.reference = 0.001 m is too short beside the contact at first yield");
  EXPECT_FALSE(nominal_first_yield(t.lower, t.upper, t.domain));
  EXPECT_FALSE(earliest_first_yield(t.lower, t.upper, t.domain, 0.0));
  t = cylinders();
  t.upper.shape = Roller{3.0, 0.5}; // shorter than the period
  EXPECT_NE(reason(t).find("nor cylinders in plane strain"), std::string::npos) << reason(t);
  t = cylinders();
  t.lower.shape = t.upper.shape = Roller{1.0, 0.5};
  t.domain = {};
  EXPECT_NE(reason(t).find("nor cylinders in plane strain"), std::string::npos) << reason(t);
  t = cylinders();
  t.lower.material.hardening = t.upper.material.hardening = {};
  EXPECT_EQ(reason(t), "neither body can yield");
}

TEST(PlanTest, FrictionBringsFirstYieldForward)
{
  const TuggingCase t = spheres(4.0);
  const double without = earliest_first_yield(t.lower, t.upper, t.domain, 0.0)->critical.interference;
  const double with = earliest_first_yield(t.lower, t.upper, t.domain, 0.4)->critical.interference;
  const double C = reference::critical_pressure_ratio(t.lower.material.elastic.poisson_ratio);
  const double sliding = reference::sliding_first_yield(t.lower.material.elastic.poisson_ratio, 0.4).pressure_ratio;
  EXPECT_NEAR(with / without, std::pow(sliding / C, 2),
              1e-12); // Hertz: the approach goes as the square of the pressure
  EXPECT_LT(with, 0.7 * without);
}

TEST(PlanTest, AnyShiftIsPossible)
{
  TuggingCase t = paper();
  const int steps = plan(t).steps_per_pass;
  for (const double cells : {0.3, 0.5, 0.75, 1.0, 1.25, 2.0, 4.0})
  {
    t.shift = cells * 3.85e-3;
    const TuggingPlan p = plan(t);
    EXPECT_DOUBLE_EQ(p.shift, *t.shift);
    // 2 (R1 + R2) theta0 is crossed by 2 shifts a step; one step more on each side at most.
    EXPECT_NEAR(p.steps_per_pass * cells, steps, 2.0 * cells + 2.0) << cells;
  }
  for (const double cells : {0.0, -1.0})
  {
    t.shift = cells * 3.85e-3;
    const std::string text = refusal(t);
    EXPECT_NE(text.find("tugging.shift"), std::string::npos) << cells << ": " << text;
  }
}

TEST(PlanTest, RefusesGridsBeyondAllMeasure)
{
  TuggingCase t = paper();
  t.spacing = {{1e-9, 1e-9, 1e-9}};
  EXPECT_NE(refusal(t).find("grid"), std::string::npos);
}

TEST(PlanTest, StepsLieOnTheCellsOfBothBodies)
{
  // The contact cells are cells of both bodies, whatever the radii and the shift: seen from the centre of contact, each
  // body's cells lie where the contact's do, and that centre is at most half a cell from the middle one.
  for (const double upper_radius : {1.0, 1.7})
    for (const double shift : {0.5, 1.0, 1.5})
      for (const Kinematics kinematics : {Kinematics::exact, Kinematics::paper})
      {
        TuggingCase t = spheres(0.5); // elastic: nothing to iterate
        t.upper.shape = Paraboloid{upper_radius, upper_radius};
        t.kinematics = kinematics;
        t.resolution = 3.0;
        t.shift = shift * plan(t).contact.dx;
        const TuggingPlan p = plan(t);
        const double dx = p.contact.dx;
        double before_lower = 0.0, before_upper = 0.0;
        int snapshots = 0;
        Observer<TuggingRecord> observer;
        observer.wants_snapshot = [](const TuggingRecord&) { return true; };
        observer.on_snapshot = [&](const TuggingRecord&, const Snapshot& s)
        {
          EXPECT_LE(std::abs(s.x0 + 0.5 * (s.contact.nx - 1) * dx), 0.5001 * dx);
          for (const BodySnapshot* body : {&s.lower, &s.upper})
          {
            const double columns = (body->x0 - body->contact_x - s.x0) / dx;
            EXPECT_NEAR(columns, std::round(columns), 1e-9) << upper_radius << " " << shift;
            EXPECT_EQ(body->y0, s.y0);
          }
          if (snapshots++ > 0) // arcs shared by the radii, together 2 shifts
          {
            const double sum = 1.0 + upper_radius;
            EXPECT_NEAR(s.lower.contact_x - before_lower, 2.0 * p.shift / sum, 1e-12);
            EXPECT_NEAR(s.upper.contact_x - before_upper, -2.0 * p.shift * upper_radius / sum, 1e-12);
          }
          before_lower = s.lower.contact_x;
          before_upper = s.upper.contact_x;
        };
        (void)run(t, observer);
        EXPECT_GT(snapshots, 2);
      }
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
      map.heights.push_back(amplitude * std::cos(2.0 * 3.14159265358979 * (i - points / 2) * map.dx / length));
  return map;
}

TEST(PlanTest, ARoughContactThatIsElasticAsAWholeNeedsLittleDepth)
{
  IndentationCase c = light_press(50.0);
  const IndentationPlan smooth = plan(c);
  constexpr double length = 30e-6;
  c.upper.texture = waves(length, 10e-9, 1.2e-3);
  const IndentationPlan rough = plan(c);
  EXPECT_GT(smooth.lower.nz * smooth.lower.dz, 1.8 * smooth.contact_radius);
  EXPECT_NEAR(rough.lower.nz * rough.lower.dz, length, 0.02 * length + rough.lower.dz);
  EXPECT_LT(rough.memory_bytes, 0.2 * smooth.memory_bytes);
  // Pressed so far that the smooth bodies yield, too, it needs the depth of these.
  c.sequence = {{contact::Drive::Kind::load, 5000.0}};
  const IndentationPlan deep = plan(c);
  EXPECT_GT(deep.lower.nz * deep.lower.dz, 1.8 * deep.contact_radius);
}

TEST(PlanTest, RoughnessEverywhereIsCoveredWhereItCanTouch)
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

TEST(PlanTest, ATextureWidensTheGrids)
{
  IndentationCase c = light_press(50.0);
  const IndentationPlan smooth = plan(c);
  c.lower.texture = Dent{.y = 0.4e-3, .depth = -6e-6, .radius = 0.3e-3}; // a bump beside the contact, which bears
  const IndentationPlan rough = plan(c);
  EXPECT_EQ(rough.contact.dy, smooth.contact.dy);
  EXPECT_LT(smooth.contact.ny * smooth.contact.dy, 2.0 * 0.4e-3);
  EXPECT_GT(rough.contact.ny * rough.contact.dy, 2.0 * 0.4e-3);
}

} // namespace
} // namespace brinell::simulation
