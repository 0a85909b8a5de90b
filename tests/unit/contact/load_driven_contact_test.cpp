// SPDX-License-Identifier: BSD-3-Clause
// Contacts of which the load is given, and the approach is found.
#include "brinell/contact/elastic_contact.hpp"

#include "contact_solution.hpp"
#include "grid_fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace brinell::contact::load_driven_contact_test
{
namespace
{

using Solution = test::ContactSolution;
using test::expect_complementary;
using test::largest;
using test::paraboloid;

/// A paraboloid of radius 1 under a load; its distance times `scale`.
Solution under_load(const SurfaceGrid& grid, double modulus, double load, double tolerance, double scale = 1.0)
{
  std::vector<double> distance = paraboloid(grid, 0.0);
  for (double& d : distance)
    d *= scale;
  return test::solved(halfspace::SurfaceCompliance(grid, modulus), distance, {Drive::Kind::load, load}, tolerance);
}

TEST(LoadDrivenTest, FindsTheApproachThatGivesTheLoad)
{
  const SurfaceGrid g{31, 27, 0.012, 0.014};
  const double approach = 0.01, tolerance = 1e-12 * approach;
  const Solution given = test::solved(halfspace::SurfaceCompliance(g, 2.0), paraboloid(g, approach), {}, tolerance);
  const double load = given.load(g);
  const Solution found = under_load(g, 2.0, load, tolerance);
  expect_complementary(found, tolerance);
  EXPECT_NEAR(found.report.approach, approach, 1e-9 * approach);
  EXPECT_NEAR(found.load(g), load, 1e-12 * load);
  for (std::size_t i = 0; i < g.size(); ++i)
    EXPECT_NEAR(found.pressure[i], given.pressure[i], 1e-8 * largest(given.pressure));
}

TEST(LoadDrivenTest, NoLoadIsTheFirstTouch)
{
  const SurfaceGrid g{9, 9, 0.1, 0.1};
  const halfspace::SurfaceCompliance compliance(g, 1.0);
  ElasticContact contact(compliance);
  std::vector<double> pressure(g.size(), 3.0), gap(g.size());
  const Report report = contact.solve(paraboloid(g, 0.25), {Drive::Kind::load, 0.0}, 1e-12, 100, pressure, gap);
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.approach, -0.25);
  EXPECT_EQ(largest(pressure), 0.0);
  EXPECT_EQ(*std::min_element(gap.begin(), gap.end()), 0.0);
}

TEST(LoadDrivenTest, AFlatPunchAndANearlyFlatOne)
{
  // Everything touches from the start, or nearly so: no cell to begin with is better than another.
  const SurfaceGrid g{15, 15, 0.1, 0.1};
  for (const double scale : {0.0, 1e-9})
  {
    const Solution s = under_load(g, 1.0, 1.0, 1e-12, scale);
    expect_complementary(s, 1e-12);
    EXPECT_NEAR(s.load(g), 1.0, 1e-12);
  }
}

TEST(LoadDrivenTest, ANumberThatIsNoneIsNotAConvergedOne)
{
  const SurfaceGrid g{5, 5, 0.1, 0.1};
  const halfspace::SurfaceCompliance compliance(g, 1.0);
  ElasticContact contact(compliance);
  std::vector<double> distance = paraboloid(g, 0.0);
  distance[7] = std::nan("");
  for (const Drive& drive : {Drive{Drive::Kind::load, 1.0}, Drive{Drive::Kind::approach, 0.02}})
  {
    std::vector<double> pressure(g.size(), 0.0), gap(g.size());
    EXPECT_FALSE(contact.solve(distance, drive, 1e-9, 50, pressure, gap).converged);
  }
}

} // namespace
} // namespace brinell::contact::load_driven_contact_test
