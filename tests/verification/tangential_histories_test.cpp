// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/contact/tangential_contact.hpp"

#include "random_field.hpp"
#include "shear_fields.hpp"
#include "tangential_violations.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

/// Histories of stick and slip on grids, bodies and bounds of any kind, each step against what it must meet.
namespace brinell::contact::tangential_histories_test
{
namespace
{

using Kind = TangentialDrive::Kind;

/// A history of a few steps, everything in it random.
struct RandomCase
{
  std::mt19937_64 engine;
  SurfaceGrid grid;
  Elastic body1, body2;
  int bound_kind;

  explicit RandomCase(unsigned seed) : engine(seed)
  {
    const auto boundary = [&] { return uniform(0.0, 1.0) < 0.5 ? Boundary::open : Boundary::periodic; };
    const int nx = 8 + static_cast<int>(uniform(0.0, 50.0));
    const bool is_plane = uniform(0.0, 1.0) < 0.2;
    const int ny = is_plane ? 1 : 8 + static_cast<int>(uniform(0.0, 40.0));
    const double dy = uniform(0.5, 2.0);
    const Boundary along_x = boundary(), along_y = boundary();
    grid = {nx, ny, 1.0, dy, along_x, is_plane ? Boundary::periodic : along_y};
    body1 = {1.0, uniform(-0.3, 0.499)};
    const bool is_rigid = uniform(0.0, 1.0) < 0.3;
    const double modulus = uniform(0.2, 5.0), ratio = uniform(-0.3, 0.499);
    body2 = {is_rigid ? std::numeric_limits<double>::infinity() : modulus, ratio};
    bound_kind = static_cast<int>(uniform(0.0, 3.0));
  }

  double uniform(double low, double high) { return test::uniform(engine, low, high); }
  [[nodiscard]] double length() const { return std::max(grid.nx * grid.dx, grid.ny * grid.dy); }

  /// Spots of single cells, one round contact, or a wavy surface.
  Field bound()
  {
    const double phase = uniform(0.0, 6.0), wave = uniform(0.1, 1.0);
    Field g(grid.size());
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i)
      {
        const double x = grid.x(i) / (0.4 * grid.nx * grid.dx), y = grid.y(j) / (0.4 * grid.ny * grid.dy);
        const double random = uniform(-1.0, 1.0);
        const double value = bound_kind == 0   ? random
                             : bound_kind == 1 ? 1.0 - x * x - (grid.ny > 1 ? y * y : 0.0)
                                               : std::sin(wave * i + phase) + std::cos(wave * j) + 0.3 * random;
        g[grid.index(i, j)] = std::max(0.0, value);
      }
    return g;
  }

  TangentialDrive drive(double carried)
  {
    const double angle = uniform(0.0, 6.3), share = std::pow(uniform(0.0, 1.0), 0.3) * 0.999;
    const auto axis = [&](double direction)
    {
      const double size = uniform(-1.0, 1.0) * std::pow(10.0, uniform(-3.0, 1.0));
      return uniform(0.0, 1.0) < 0.5 ? TangentialDrive::Axis{Kind::force, share * carried * direction}
                                     : TangentialDrive::Axis{Kind::shift, size};
    };
    TangentialDrive result;
    result.x = axis(std::cos(angle));
    result.y = axis(std::sin(angle));
    const double spin = uniform(-1.0, 1.0) / length();
    result.spin = uniform(0.0, 1.0) < 0.3 ? spin : 0.0;
    return result;
  }
};

TEST(TangentialContactTest, ConvergesForRandomHistories)
{
  long iterations = 0, steps = 0;
  int most = 0;
  for (unsigned seed = 1; seed <= 300; ++seed)
  {
    RandomCase random(seed);
    const SurfaceGrid& g = random.grid;
    const halfspace::SurfaceCompliance compliance(g, random.body1, random.body2, 10.0 * random.length());
    TangentialContact contact(compliance);
    Fields shear(g.size()), before(g.size()), slip(g.size()), change(g.size());
    // Bounds are about 1; a shear of 1 on a square as large as the grid displaces by some of its length.
    const double tolerance = 1e-8 * random.length();
    for (int n = 0; n < 4; ++n)
    {
      const Field bound = random.bound();
      const double carried = total(bound, g.cell_area());
      if (carried == 0.0)
        continue;
      TangentialStep step{bound, before.in(), {}, random.drive(carried)};
      if (random.uniform(0.0, 1.0) < 0.3)
      {
        change.x = test::random_field(g.size(), seed, -0.1, 0.1);
        change.y = test::random_field(g.size(), seed + 1, -0.1, 0.1);
        step.change = change.in();
      }
      const TangentialReport report = contact.solve(step, tolerance, 2000, shear.out(), slip.out());
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", step " << n);
      ASSERT_TRUE(report.converged) << report.slip_error;
      const Violations worst = violations(compliance, step, report, shear, slip);
      EXPECT_LE(worst.bound, 1e-14 * 3.0);
      EXPECT_LE(worst.slip, 1.01 * tolerance);
      EXPECT_LE(worst.reported, 0.01 * tolerance);
      if (step.drive.x.kind == Kind::force)
      {
        EXPECT_NEAR(total(shear.x, g.cell_area()), step.drive.x.value, 1e-9 * carried);
      }
      if (step.drive.y.kind == Kind::force)
      {
        EXPECT_NEAR(total(shear.y, g.cell_area()), step.drive.y.value, 1e-9 * carried);
      }
      EXPECT_GE(report.dissipated, -tolerance * carried);
      iterations += report.iterations;
      most = std::max(most, report.iterations);
      ++steps;
      before = shear;
    }
  }
  std::printf("  %ld random steps: %.1f iterations in the mean, at most %d\n", steps,
              static_cast<double>(iterations) / static_cast<double>(steps), most);
}

} // namespace
} // namespace brinell::contact::tangential_histories_test
