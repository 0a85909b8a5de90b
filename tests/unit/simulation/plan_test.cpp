// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/indentation.hpp"
#include "brinell/simulation/run.hpp"
#include "sphere_pairs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace brinell::simulation::plan_test
{
namespace
{

TuggingCase paper()
{
  TuggingCase t = spheres(9.0);
  t.spacing = {{3.85e-3, 7.7e-3, 1.925e-3}};
  return t;
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
      [](auto& c) { c.wear.lower = 1e-15; },
      [](auto& c) { c.heat.source.shape = elastoplastic::HeatSource::Shape::contact; },
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
  EXPECT_EQ(p.contact.whole(), (SurfaceGrid{33, 13, 3.85e-3, 7.7e-3})); // the paper's points in x and y
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
              "tugging: spheres, ellipsoids with radius_x > 0, and cylinders");
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
        observer.on_snapshot = [&](const TuggingRecord&, const StepFields& fields)
        {
          const Snapshot& s = fields.surfaces;
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

} // namespace
} // namespace brinell::simulation::plan_test
