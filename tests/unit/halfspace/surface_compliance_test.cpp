// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/surface_compliance.hpp"

#include "brinell/foundation/error.hpp"
#include "direct/half_space_sums.hpp"
#include "order.hpp"
#include "random_field.hpp"
#include "refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <vector>

namespace brinell::halfspace::surface_compliance_test
{
namespace
{

std::vector<double> displacement_under(const SurfaceCompliance& compliance, const std::vector<double>& pressure)
{
  std::vector<double> u(pressure.size());
  SurfaceCompliance::Scratch scratch = compliance.make_scratch();
  compliance.apply({.pressure = pressure}, {.z = u}, scratch);
  return u;
}

class SurfaceComplianceTest : public testing::TestWithParam<SurfaceGrid>
{
};

INSTANTIATE_TEST_SUITE_P(Grids, SurfaceComplianceTest,
                         testing::Values(SurfaceGrid{1, 1, 1.0, 2.0}, SurfaceGrid{6, 6, 1.0, 1.0},
                                         SurfaceGrid{9, 4, 0.5, 1.5}, SurfaceGrid{13, 7, 1e-6, 2e-6},
                                         SurfaceGrid{1, 8, 1.0, 1.0}),
                         [](const auto& p) { return std::to_string(p.param.nx) + "x" + std::to_string(p.param.ny); });

TEST_P(SurfaceComplianceTest, EqualsTheSumOverAllPairsOfCells)
{
  const double modulus = 1.1e11;
  const std::vector<double> pressure = test::random_field(GetParam().size(), 1);
  const std::vector<double> fast = displacement_under(SurfaceCompliance(GetParam(), modulus), pressure);
  const std::vector<double> slow = direct::pressure_to_displacement(GetParam(), pressure, 1.0 / modulus);
  double largest = 0.0;
  for (const double u : slow)
    largest = std::max(largest, std::abs(u));
  for (std::size_t i = 0; i < slow.size(); ++i)
    EXPECT_NEAR(fast[i], slow[i], 1e-13 * largest); // round-off of two transforms and of a sum of up to 91 terms
}

TEST_P(SurfaceComplianceTest, IsSymmetric)
{
  const SurfaceCompliance compliance(GetParam(), 1.0);
  const std::vector<double> p = test::random_field(GetParam().size(), 2), q = test::random_field(GetParam().size(), 3);
  const double a = test::dot(q, displacement_under(compliance, p)), b = test::dot(p, displacement_under(compliance, q));
  // Relative to the product of the norms: either sum may cancel.
  const double scale =
      std::sqrt(test::dot(p, displacement_under(compliance, p)) * test::dot(q, displacement_under(compliance, q)));
  EXPECT_NEAR(a, b, 1e-13 * scale);
}

TEST_P(SurfaceComplianceTest, IsPositive)
{
  const SurfaceGrid& grid = GetParam();
  const SurfaceCompliance compliance(grid, 1.0);
  for (unsigned seed = 4; seed < 12; ++seed)
  {
    const std::vector<double> p = test::random_field(grid.size(), seed);
    EXPECT_GT(test::dot(p, displacement_under(compliance, p)), 0.0);
  }
  std::vector<double> checkerboard(grid.size()); // the shortest wave, the softest response
  for (std::size_t i = 0; i < grid.size(); ++i)
    checkerboard[i] = (i % static_cast<std::size_t>(grid.nx) + i / static_cast<std::size_t>(grid.nx)) % 2 ? 1.0 : -1.0;
  EXPECT_GT(test::dot(checkerboard, displacement_under(compliance, checkerboard)), 0.0);
}

TEST(UniformPressureTest, SinksTheCentreOfASquareByLovesNumber)
{
  // Unit pressure on a unit square, mu = 1, nu = 0.28 (Love 1929, to eight digits); the square is one cell or 25.
  const double modulus = 2.0 / (1.0 - 0.28);
  EXPECT_NEAR(displacement_under(SurfaceCompliance({1, 1, 1.0, 1.0}, modulus), {1.0})[0], 0.40399189, 1e-8);
  const std::vector<double> many =
      displacement_under(SurfaceCompliance({5, 5, 0.2, 0.2}, modulus), std::vector<double>(25, 1.0));
  EXPECT_NEAR(many[12], 0.40399189, 1e-8);
}

TEST(UniformPressureTest, SinksTheCentreOfACircleByTwoPressureRadiusOverModulus)
{
  // Cells on the rim carry the share of them that lies inside: second order, u = 2 p a/E' (Johnson 1985, Eq. 3.29a).
  const auto error = [](int cells)
  {
    const int n = 2 * cells + 3;
    const double h = 1.0 / cells;
    std::vector<double> pressure(static_cast<std::size_t>(n * n));
    constexpr int parts = 64; // share of the area to 1e-3 of a cell, and the errors of the rim's cells average out
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
      {
        int inside = 0;
        for (int b = 0; b < parts; ++b)
          for (int a = 0; a < parts; ++a)
            inside += std::hypot(i - n / 2 - 0.5 + (a + 0.5) / parts, j - n / 2 - 0.5 + (b + 0.5) / parts) < cells;
        pressure[static_cast<std::size_t>(i + n * j)] = static_cast<double>(inside) / (parts * parts);
      }
    const std::vector<double> u = displacement_under(SurfaceCompliance({n, n, h, h}, 2.0), pressure);
    return u[static_cast<std::size_t>(n * n / 2)] - 1.0;
  };
  const std::vector<double> errors{error(4), error(8), error(16)};
  EXPECT_GT(test::Orders("uniform circle, centre displacement", errors).overall, 1.8);
}

TEST(InverseTest, UndoesTheOperatorOnPeriodicSurfacesAndNearlySoOnOpenOnes)
{
  for (const auto& [along_x, along_y, rest] :
       {std::tuple{Boundary::periodic, Boundary::periodic, 1e-12}, std::tuple{Boundary::open, Boundary::open, 0.5},
        std::tuple{Boundary::periodic, Boundary::open, 0.5}})
  {
    const SurfaceGrid grid{21, 16, 1.0, 1.3, along_x, along_y};
    const SurfaceCompliance compliance(grid, 2.0, grid.is_periodic() || along_x == along_y ? 0.0 : 100.0);
    SurfaceCompliance::Scratch scratch = compliance.make_scratch();
    std::vector<double> p = test::random_field(grid.size(), 3, -1.0, 1.0), u(grid.size()), q(grid.size());
    const double mean = std::accumulate(p.begin(), p.end(), 0.0) / static_cast<double>(p.size());
    for (double& value : p)
      value -= mean; // a uniform pressure has no displacement where both axes are periodic
    compliance.apply({.pressure = p}, {.z = u}, scratch);
    compliance.apply_inverse(u, q, scratch);
    double difference = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i)
      difference += (q[i] - p[i]) * (q[i] - p[i]), squares += p[i] * p[i];
    EXPECT_LT(std::sqrt(difference / squares), rest);
    // Symmetric and positive: a b = b a within rounding, a a > 0; and in place as well.
    std::vector<double> r = test::random_field(grid.size(), 4, -1.0, 1.0), s(grid.size());
    compliance.apply_inverse(r, s, scratch);
    const auto dot = [](const std::vector<double>& a, const std::vector<double>& b)
    { return std::inner_product(a.begin(), a.end(), b.begin(), 0.0); };
    EXPECT_NEAR(dot(u, s), dot(r, q), 1e-12 * std::sqrt(dot(s, s) * dot(u, u)));
    EXPECT_GT(dot(r, s), 0.0);
    compliance.apply_inverse(r, r, scratch);
    EXPECT_EQ(r, s);
  }
}

TEST(SurfaceComplianceDoorTest, RefusesFieldsOfAnotherSize)
{
  const SurfaceCompliance compliance({4, 3, 1.0, 1.0}, 1.0);
  std::vector<double> p(12), u(11);
  SurfaceCompliance::Scratch scratch = compliance.make_scratch();
  test::expect_refused("SurfaceCompliance::apply: the displacement", 11, 12,
                       [&] { compliance.apply({.pressure = p}, {.z = u}, scratch); });
  test::expect_refused("SurfaceCompliance::apply: the pressure", 11, 12,
                       [&] { compliance.apply({.pressure = u}, {.z = p}, scratch); });
}

} // namespace
} // namespace brinell::halfspace::surface_compliance_test
