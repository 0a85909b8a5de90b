// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/contact/tangential_contact.hpp"

#include "brinell/foundation/error.hpp"
#include "random_field.hpp"
#include "refusal.hpp"
#include "shear_fields.hpp"
#include "tangential_violations.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <omp.h>
#include <vector>

namespace brinell::contact::tangential_contact_test
{
namespace
{

using Kind = TangentialDrive::Kind;

/// A bound like Hertz's pressure on a grid, pushed obliquely.
struct Push
{
  SurfaceGrid grid;
  halfspace::SurfaceCompliance compliance;
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
  const halfspace::SurfaceCompliance compliance(g, {1.0, 0.3}, {2.0, 0.3});
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
  const halfspace::SurfaceCompliance plain(open, {1.0, 0.3}, {2.0, 0.3});
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
    const halfspace::SurfaceCompliance compliance(grid, {1.0, 0.3}, {2.0, 0.2}, 10.0);
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
