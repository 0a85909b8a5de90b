// SPDX-License-Identifier: BSD-3-Clause
#include "contact/coarser_contact.hpp"

#include "random_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace brinell::contact::coarser_contact_test
{
namespace
{

struct Outcome
{
  Report report;
  std::vector<double> pressure;
};

/// @param nested  whether the solver finds its first guess on larger cells; if not, the guess is that of small grids: the
///                overlap times the smallest stiffness, or the cell that touches first.
Outcome outcome(const SurfaceGrid& grid, const std::vector<double>& distance, const Drive& drive, double tolerance,
                bool nested)
{
  const halfspace::SurfaceCompliance compliance(grid, 1.0);
  ElasticContact contact(compliance);
  Outcome result{{}, std::vector<double>(grid.size(), 0.0)};
  if (!nested && drive.kind == Drive::Kind::load)
    result.pressure[static_cast<std::size_t>(std::min_element(distance.begin(), distance.end()) - distance.begin())] =
        1.0;
  else if (!nested)
    std::transform(distance.begin(), distance.end(), result.pressure.begin(),
                   [&](double d) { return std::max(0.0, drive.value - d) / compliance.largest(); });
  std::vector<double> gap(grid.size());
  result.report = contact.solve(distance, drive, tolerance, 2000, result.pressure, gap);
  return result;
}

/// A ball, or one with bumps of random height on every cell, so that the larger cells see another surface.
std::vector<double> surface(const SurfaceGrid& grid, double roughness)
{
  std::vector<double> distance = test::random_field(grid.size(), 11, 0.0, roughness);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      distance[grid.index(i, j)] += 0.5 * (grid.x(i) * grid.x(i) + grid.y(j) * grid.y(j));
  return distance;
}

TEST(CoarserContactTest, ASolutionDoesNotDependOnWhereItBegan)
{
  for (const SurfaceGrid& grid :
       {SurfaceGrid{65, 49, 0.02, 0.02}, {96, 51, 0.02, 0.03}, {128, 128, 0.01, 0.01}, {48, 200, 0.03, 0.005}})
  {
    ASSERT_TRUE(CoarserCells::helps(grid));
    for (const double roughness : {0.0, 0.02})
      for (const Drive& drive : {Drive{Drive::Kind::approach, 0.05}, Drive{Drive::Kind::load, 0.01}})
      {
        constexpr double tolerance = 1e-9; // approaches are 0.05
        const std::vector<double> distance = surface(grid, roughness);
        const Outcome nested = outcome(grid, distance, drive, tolerance, true);
        const Outcome plain = outcome(grid, distance, drive, tolerance, false);
        ASSERT_TRUE(nested.report.converged && plain.report.converged);
        EXPECT_NEAR(nested.report.approach, plain.report.approach, 10.0 * tolerance);
        const double largest = *std::max_element(plain.pressure.begin(), plain.pressure.end());
        // A gap of the tolerance at a cell is a pressure of tolerance / dx there.
        for (std::size_t i = 0; i < plain.pressure.size(); ++i)
          ASSERT_NEAR(nested.pressure[i], plain.pressure[i], 1e-5 * largest) << grid.nx << " x " << grid.ny;
      }
  }
}

TEST(CoarserContactTest, ItSavesIterationsOnALargeSmoothContact)
{
  const SurfaceGrid grid{129, 129, 0.01, 0.01};
  const std::vector<double> distance = surface(grid, 0.0);
  const Drive drive{Drive::Kind::approach, 0.1};
  EXPECT_LT(outcome(grid, distance, drive, 1e-8, true).report.iterations,
            0.9 * outcome(grid, distance, drive, 1e-8, false).report.iterations);
}

TEST(CoarserContactTest, SurfacesThatDoNotTouchStayApart)
{
  const SurfaceGrid grid{64, 64, 0.02, 0.02};
  const Outcome apart = outcome(grid, surface(grid, 0.0), {Drive::Kind::approach, -0.01}, 1e-9, true);
  EXPECT_TRUE(apart.report.converged);
  EXPECT_EQ(*std::max_element(apart.pressure.begin(), apart.pressure.end()), 0.0);
}

} // namespace
} // namespace brinell::contact::coarser_contact_test
