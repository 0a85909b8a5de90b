// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/contact/tangential_contact.hpp"

#include "brinell/foundation/error.hpp"
#include "random_field.hpp"
#include "refusal.hpp"
#include "shear_fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <omp.h>
#include <vector>

namespace brinell::contact::tangential_contact_test
{
namespace
{

using Kind = TangentialDrive::Kind;

/// What a step must meet, from products with the compliance alone.
struct Violations
{
  double bound = 0.0;    ///< of the size of the shear [Pa]
  double slip = 0.0;     ///< where it sticks, and across or against the shear elsewhere [m]
  double reported = 0.0; ///< slip of the report against that of its shears and its shift [m]
};

Violations violations(const halfspace::TractionCompliance& compliance, const TangentialStep& step,
                      const TangentialReport& report, const Fields& shear, const Fields& slip)
{
  const SurfaceGrid& g = compliance.grid();
  Fields added(g.size()), u(g.size());
  for (std::size_t i = 0; i < g.size(); ++i)
  {
    added.x[i] = shear.x[i] - (step.before[0].empty() ? 0.0 : step.before[0][i]);
    added.y[i] = shear.y[i] - (step.before[1].empty() ? 0.0 : step.before[1][i]);
  }
  compliance.apply({.shear_x = added.x, .shear_y = added.y}, {.x = u.x, .y = u.y});
  Violations worst;
  for (int j = 0; j < g.ny; ++j)
    for (int i = 0; i < g.nx; ++i)
    {
      const std::size_t c = g.index(i, j);
      const double q = std::hypot(shear.x[c], shear.y[c]);
      worst.bound = std::max(worst.bound, q - step.bound[c]);
      if (!(step.bound[c] > 0.0))
        continue;
      const double sx =
          report.shift[0] - step.drive.spin * g.y(j) - u.x[c] - (step.change[0].empty() ? 0.0 : step.change[0][c]);
      const double sy =
          report.shift[1] + step.drive.spin * g.x(i) - u.y[c] - (step.change[1].empty() ? 0.0 : step.change[1][c]);
      worst.reported = std::max(worst.reported, std::hypot(sx - slip.x[c], sy - slip.y[c]));
      const double along =
          q >= slip_threshold * step.bound[c] ? std::max(0.0, sx * shear.x[c] + sy * shear.y[c]) / (q * q) : 0.0;
      worst.slip = std::max(worst.slip, std::hypot(sx - along * shear.x[c], sy - along * shear.y[c]));
    }
  return worst;
}

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
    const halfspace::TractionCompliance compliance(g, random.body1, random.body2, 10.0 * random.length());
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

/// A bound like Hertz's pressure on a grid, pushed obliquely.
struct Push
{
  SurfaceGrid grid;
  halfspace::TractionCompliance compliance;
  TangentialContact contact;
  Field bound;
  Fields shear, slip;

  explicit Push(int n, double nu = 0.3)
      : grid{n, n, 2.0 / n, 2.0 / n}, compliance(grid, {1.0, nu}, {1.0, nu}), contact(compliance), bound(grid.size()),
        shear(grid.size()), slip(grid.size())
  {
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        bound[grid.index(i, j)] =
            std::sqrt(std::max(0.0, 1.0 - (std::pow(grid.x(i), 2) + std::pow(grid.y(j), 2)) / 0.81));
  }
  [[nodiscard]] double carried() const { return total(bound, grid.cell_area()); }
  TangentialReport solve(const TangentialDrive& drive, int max_iterations = 500,
                         const std::function<bool()>& wants_stop = {})
  {
    return contact.solve({bound, {}, {}, drive}, 1e-9, max_iterations, shear.out(), slip.out(), wants_stop);
  }
};

TEST(TangentialContactTest, DoesNotDependOnTheNumberOfThreads)
{
  const int threads = omp_get_max_threads();
  std::vector<Fields> results;
  for (const int count : {1, 3})
  {
    omp_set_num_threads(count);
    Push push(128); // enough cells to be shared out
    ASSERT_TRUE(push.solve({{Kind::force, 0.6 * push.carried()}, {Kind::shift, 0.1}, 0.0}).converged);
    results.push_back(push.shear);
  }
  omp_set_num_threads(threads);
  EXPECT_EQ(results[0].x, results[1].x);
  EXPECT_EQ(results[0].y, results[1].y);
}

TEST(TangentialContactTest, ASolutionDoesNotDependOnTheGuess)
{
  Push push(40);
  const TangentialDrive drive{{Kind::force, 0.6 * push.carried()}, {Kind::force, 0.5 * push.carried()}, 0.0};
  ASSERT_TRUE(push.solve(drive).converged);
  const Fields first = push.shear;
  push.shear.x = test::random_field(push.grid.size(), 3);
  push.shear.y = test::random_field(push.grid.size(), 4);
  ASSERT_TRUE(push.solve(drive).converged);
  // A slip of the tolerance at one cell is a shear of about it over the size of the cell.
  for (std::size_t i = 0; i < first.x.size(); ++i)
  {
    EXPECT_NEAR(push.shear.x[i], first.x[i], 1e-6);
    EXPECT_NEAR(push.shear.y[i], first.y[i], 1e-6);
  }
}

TEST(TangentialContactTest, ASpinTurnsTheShears)
{
  Push push(40);
  const TangentialReport report = push.solve({{}, {}, 0.5});
  ASSERT_TRUE(report.converged);
  EXPECT_NEAR(report.force[0], 0.0, 1e-8);
  const std::size_t right = push.grid.index(33, 20), left = push.grid.index(6, 20);
  EXPECT_GT(push.shear.y[right], 0.1);
  EXPECT_NEAR(push.shear.y[left], -push.shear.y[push.grid.index(33, 19)], 1e-6);
}

TEST(TangentialContactTest, ShearsThatAreCarriedAreThoseOfShearsThatWereThere)
{
  // On a periodic surface nothing is lost: with the bound carried along, too, a step without a shift changes nothing else.
  const SurfaceGrid g{12, 10, 1.0, 1.0, Boundary::periodic, Boundary::periodic};
  const halfspace::TractionCompliance compliance(g, {1.0, 0.3}, {2.0, 0.3});
  TangentialContact contact(compliance);
  Field bound = test::random_field(g.size(), 1, 0.1, 1.0), carried_bound(g.size());
  Fields shear(g.size()), slip(g.size()), carried(g.size());
  const TangentialDrive push{{Kind::force, 20.0}, {Kind::force, 10.0}, 0.0};
  ASSERT_TRUE(contact.solve({bound, {}, {}, push}, 1e-11, 500, shear.out(), slip.out()).converged);
  for (int j = 0; j < g.ny; ++j)
    for (int i = 0; i < g.nx; ++i)
      carried_bound[g.index((i + 9) % g.nx, (j + 2) % g.ny)] = bound[g.index(i, j)];
  const TangentialStep step{carried_bound, shear.in(), {}, push, {-3, 2}};
  const TangentialReport report = contact.solve(step, 1e-11, 500, carried.out(), slip.out());
  ASSERT_TRUE(report.converged);
  EXPECT_NEAR(report.dissipated, 0.0, 1e-9);
  for (int j = 0; j < g.ny; ++j)
    for (int i = 0; i < g.nx; ++i)
      EXPECT_NEAR(carried.x[g.index((i + 9) % g.nx, (j + 2) % g.ny)], shear.x[g.index(i, j)], 1e-8);
  // Over an open end shears are lost.
  const SurfaceGrid open{6, 1, 1.0, 1.0, Boundary::open, Boundary::open};
  const halfspace::TractionCompliance plain(open, {1.0, 0.3}, {2.0, 0.3});
  const Field ones(open.size(), 1.0);
  Fields before(open.size()), after(open.size()), none(open.size());
  before.x = {1.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  TangentialContact lost(plain);
  const TangentialStep away{ones, before.in(), {}, {}, {-1, 0}};
  ASSERT_TRUE(lost.solve(away, 1e-12, 100, after.out(), none.out()).converged);
  EXPECT_NEAR(total(after.x, 1.0), 0.0, 1e-10);
}

TEST(TangentialContactTest, OnManyCellsTheGuessIsOfLargerOnes)
{
  // Odd numbers of cells and a spin, so that the larger cells have another middle; unlike bounds, so that they see another surface;
  // a step before, carried along, and a change.
  for (const SurfaceGrid& grid :
       {SurfaceGrid{65, 51, 0.03, 0.04}, {64, 48, 0.03, 0.04, Boundary::periodic, Boundary::open}})
  {
    const halfspace::TractionCompliance compliance(grid, {1.0, 0.3}, {2.0, 0.2}, 10.0);
    TangentialContact contact(compliance);
    const Field rough = test::random_field(grid.size(), 5, 0.7, 1.0),
                changes = test::random_field(grid.size(), 6, -0.01, 0.01);
    Field bound(grid.size());
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i)
        bound[grid.index(i, j)] =
            rough[grid.index(i, j)] * std::max(0.0, 1.0 - 2.0 * (std::pow(grid.x(i), 2) + std::pow(grid.y(j), 2)));
    const double carried = total(bound, grid.cell_area());
    Fields shear(grid.size()), slip(grid.size()), before(grid.size());
    constexpr double tolerance = 1e-9;
    for (const TangentialDrive& drive :
         {TangentialDrive{{Kind::force, 0.9 * carried}, {Kind::shift, 0.05}, 0.2},
          TangentialDrive{{Kind::force, -0.5 * carried}, {Kind::force, 0.3 * carried}, 0.0},
          TangentialDrive{{Kind::force, 0.9995 * carried}, {}, 0.0}})
    {
      const TangentialStep step{bound, before.in(), {changes, changes}, drive};
      const TangentialReport report = contact.solve(step, tolerance, 200, shear.out(), slip.out());
      ASSERT_TRUE(report.converged) << report.slip_error;
      const Violations worst = violations(compliance, step, report, shear, slip);
      EXPECT_LE(worst.bound, 1e-14);
      EXPECT_LE(worst.slip, 1.01 * tolerance);
      EXPECT_LE(worst.reported, 0.01 * tolerance);
      before = shear;
    }
  }
}

TEST(TangentialContactTest, AGuessOfLargerCellsSavesIterations)
{
  // A bound near the limit of sliding: from no shear it takes 24 iterations with 38 products.
  Push push(256);
  const TangentialReport report = push.solve({{Kind::force, 0.9 * push.carried()}, {}, 0.0});
  ASSERT_TRUE(report.converged);
  EXPECT_LE(report.iterations, 20);
  EXPECT_LE(report.products, 30);
}

TEST(TangentialContactTest, SaysThatItHasNotConverged)
{
  Push push(40);
  const TangentialReport report = push.solve({{Kind::force, 0.6 * push.carried()}, {}, 0.0}, 2);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.iterations, 2);
  EXPECT_GT(report.slip_error, 1e-9);
}

TEST(TangentialContactTest, CanBeInterrupted)
{
  Push push(16);
  EXPECT_THROW((void)push.solve({{Kind::shift, 0.1}, {}, 0.0}, 100, [] { return true; }), Interrupted);
}

TEST(TangentialContactTest, RefusesWhatHasNoSolution)
{
  Push push(16);
  const double carried = push.carried();
  const auto message = [&](const TangentialDrive& drive)
  {
    try
    {
      (void)push.solve(drive);
    }
    catch (const InputError& error)
    {
      return std::string(error.what());
    }
    return std::string("not refused");
  };
  EXPECT_NE(message({{Kind::force, 1.01 * carried}, {}, 0.0}).find("the whole contact slides"), std::string::npos);
  EXPECT_NE(message({{Kind::force, 0.8 * carried}, {Kind::force, 0.7 * carried}, 0.0}).find("allowed: below"),
            std::string::npos);
  EXPECT_NE(message({{Kind::shift, std::nan("")}, {}, 0.0}).find("allowed: finite"), std::string::npos);
  push.bound[5] = -1.0;
  EXPECT_NE(message({}).find("the bound of the shear is -1 Pa in cell 5"), std::string::npos);
  Field few(3);
  test::expect_refused("TangentialContact::solve: the bound", 3, push.grid.size(),
                       [&] {
                         (void)push.contact.solve({few, {}, {}, {}}, 1.0, 1, push.shear.out(), push.slip.out());
                       });
}

TEST(TangentialContactTest, WithoutABoundNothingIsCarried)
{
  Push push(16);
  std::fill(push.bound.begin(), push.bound.end(), 0.0);
  const TangentialReport report = push.solve({{Kind::shift, 1.0}, {Kind::force, 0.0}, 0.0});
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.force[0], 0.0);
  EXPECT_EQ(push.shear.x, Field(push.grid.size()));
  EXPECT_EQ(push.slip.x, Field(push.grid.size()));
}

} // namespace
} // namespace brinell::contact::tangential_contact_test
