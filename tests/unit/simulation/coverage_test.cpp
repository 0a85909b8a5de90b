// SPDX-License-Identifier: BSD-3-Clause
// What a run remembers about its contact, from which the errors on textures are judged.
#include "brinell/simulation/indentation.hpp"
#include "brinell/simulation/run.hpp"

#include <gtest/gtest.h>

namespace brinell::simulation::coverage_test
{
namespace
{

IndentationCase ball(double cells)
{
  IndentationCase c;
  c.lower = {Plane{}, {{210e9, 0.3}, {}}};
  c.upper = {Paraboloid{1e-3, 1e-3}, {{210e9, 0.3}, {}}};
  c.sequence = {{contact::Drive::Kind::load, 10.0}};
  c.resolution = cells;
  c.steps = 2;
  return c;
}

TEST(Coverage, OfASmoothBallIsTheContactRadius)
{
  const Coverage seen = run(ball(10.0)).coverage;
  const double radius = 0.5 * seen.contact_columns;
  EXPECT_NEAR(seen.patch_cells, radius, 0.08 * radius) << "cells are squares";
  EXPECT_NEAR(seen.peak_cells, radius, 0.08 * radius) << "a pressure by Hertz";
}

TEST(Coverage, OfWavesIsTheirCrests)
{
  IndentationCase c = ball(16.0);
  const Coverage smooth = run(c).coverage;
  const double cell = plan(c).contact.dx;
  c.lower.texture = Sinusoid{.amplitude = 3e-7, .wavelength_x = 8.0 * cell};
  const Coverage wavy = run(c).coverage;
  EXPECT_LT(wavy.patch_cells, 4.0) << "narrower than half a wave";
  EXPECT_GT(wavy.patch_cells, 0.5);
  EXPECT_LT(wavy.peak_cells, 4.0);
  EXPECT_GT(smooth.peak_cells, 14.0);
}

} // namespace
} // namespace brinell::simulation::coverage_test
