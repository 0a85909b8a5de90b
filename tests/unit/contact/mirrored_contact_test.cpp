// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/contact/elastic_contact.hpp"
#include "brinell/foundation/symmetry.hpp"
#include "contact_solution.hpp"
#include "grid_fields.hpp"
#include "mirrored_grid.hpp"
#include "random_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

/// Contacts whose two sides of y = 0 are mirror images, solved on one side: docs/theory/contact.md, The iteration.
namespace brinell::contact::mirrored_contact_test
{
namespace
{

using test::largest;
using test::largest_difference;

class MirroredContactTest : public testing::TestWithParam<SurfaceGrid>
{
};

constexpr auto periodic = Boundary::periodic;
INSTANTIATE_TEST_SUITE_P(Grids, MirroredContactTest,
                         testing::Values(SurfaceGrid{33, 25, 1.0, 1.2}, SurfaceGrid{24, 30, 1.0, 1.2},
                                         SurfaceGrid{70, 61, 1.0, 1.2}, // a guess on larger cells
                                         SurfaceGrid{12, 1, 1.0, 1.2},
                                         SurfaceGrid{20, 9, 1.0, 1.2, Boundary::open, periodic},
                                         SurfaceGrid{18, 16, 1.0, 1.2, periodic, periodic}),
                         [](const auto& p) { return std::to_string(p.param.nx) + "x" + std::to_string(p.param.ny); });

/// A rough ball, by an approach, a load and, where it is possible, a mean gap; with and without a layer.
TEST_P(MirroredContactTest, IsThatOfBothSides)
{
  const SurfaceGrid& grid = GetParam();
  std::vector<double> distance = test::paraboloid(grid, 0.0, 40.0),
                      layer = test::random_field(grid.size(), 2, 0.0, 0.5);
  const std::vector<double> rough = test::random_field(grid.size(), 1, 0.0, 0.2);
  for (std::size_t i = 0; i < grid.size(); ++i)
    distance[i] += rough[i];
  for (std::vector<double>* field : {&distance, &layer})
    complete_in_y(grid, 1.0, field->data(), field->size());
  const halfspace::SurfaceCompliance both(grid, 1.0, 500.0), one(test::mirrored(grid), 1.0, 500.0);
  std::vector<Drive> drives{{Drive::Kind::approach, 0.4}, {Drive::Kind::load, 3.0}};
  if (grid.is_periodic())
    drives.push_back({Drive::Kind::mean_gap, 0.5});
  for (const Drive& drive : drives)
    for (const std::vector<double>& between : {std::vector<double>{}, layer})
    {
      constexpr double tolerance = 1e-11;
      const auto solve = [&](const halfspace::SurfaceCompliance& compliance)
      {
        test::ContactSolution s{{}, std::vector<double>(grid.size()), std::vector<double>(grid.size())};
        ElasticContact contact(compliance);
        s.report = contact.solve(distance, drive, tolerance, 2000, s.pressure, s.gap, {}, between);
        return s;
      };
      const test::ContactSolution whole = solve(both), half = solve(one);
      ASSERT_TRUE(whole.report.converged && half.report.converged);
      EXPECT_GT(half.cells_in_contact(), 0);
      // The tolerance, through the preconditioner of the shortest waves; of the approach, through the mean gap.
      EXPECT_LT(largest_difference(half.pressure, whole.pressure), 100.0 * tolerance);
      EXPECT_LT(largest_difference(half.gap, whole.gap), 100.0 * tolerance);
      EXPECT_NEAR(half.report.approach, whole.report.approach, 100.0 * tolerance);
      std::vector<double> completed = half.pressure;
      complete_in_y(grid, 1.0, completed.data(), completed.size());
      EXPECT_EQ(completed, half.pressure);
    }
}

/// Rounding may make the other side touch first, and what is left there of an earlier pressure is no guess.
TEST_P(MirroredContactTest, BeginsOnTheSideThatIsSolved)
{
  const SurfaceGrid grid = test::mirrored(GetParam());
  std::vector<double> distance = test::random_field(grid.size(), 1, 0.0, 0.2);
  complete_in_y(grid, 1.0, distance.data(), distance.size());
  for (std::size_t i = grid.independent_cells(); i < grid.size(); ++i)
    distance[i] -= 1e-16;
  const halfspace::SurfaceCompliance compliance(grid, 1.0, 500.0);
  for (const double left : {0.0, 1.0})
  {
    ElasticContact contact(compliance);
    std::vector<double> pressure(grid.size()), gap(grid.size());
    std::fill(pressure.begin() + static_cast<std::ptrdiff_t>(grid.independent_cells()), pressure.end(), left);
    EXPECT_TRUE(contact.solve(distance, {Drive::Kind::load, 3.0}, 1e-11, 2000, pressure, gap).converged) << left;
  }
}

} // namespace
} // namespace brinell::contact::mirrored_contact_test
