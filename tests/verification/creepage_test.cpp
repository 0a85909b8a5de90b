// SPDX-License-Identifier: BSD-3-Clause
#include "frictional_pairs.hpp"
#include "order.hpp"
#include "record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

/// Stick and slip of elastic bodies that roll.
namespace brinell::verification::creepage_test
{
namespace
{

TEST(Carter, SteadyRollingOfCylinders)
{
  // Cylinders that roll along x with creepage xi (Carter 1926; Johnson 1985, section 8.3): stick begins at the leading edge,
  // over 2 d, q = f (p(x; a) - p(x - (a - d); d)), xi = f (a - d)/R and Q = f P (1 - (d/a)^2). Steps of one cell; the nearer the point that shifts
  // count from, the sooner the rolling is steady. Points move freely until they touch, so that the error is of the order 3/2 at
  // least, as the pressure falls with the root of the distance from the edge.
  const double R = 100.0, P = pi / 4.0 / R, f = 0.3, d = 0.6; // a = 1 with E' = 1
  Field forces, shears;
  for (const int cells : {8, 16, 32, 64})
  {
    const SurfaceGrid g{2 * cells + 7, 1, 1.0 / cells, 1.0, Boundary::open, Boundary::periodic};
    const Elastic body{2.0 * (1.0 - 0.09), 0.3};
    Pair pair(g, body, body, f, test::sampled(g, [&](int i, int) { return std::pow(g.x(i), 2) / (2.0 * R); }), 1.0 / R,
              2.0);
    FrictionState state = pair.untouched();
    FrictionReport report;
    for (int step = 0; step < 20 * cells; ++step) // ten widths of the contact: steady
      report = pair.step({Drive::Kind::load, P}, {shift(f * (1.0 - d) / R * g.dx), shift(0.0)}, state, {-1, 0});
    const auto p = [&](double x, double c) { return std::sqrt(std::max(0.0, c * c - x * x)) / (2.0 * R); };
    double squares = 0.0;
    for (int i = 0; i < g.nx; ++i)
      squares += std::pow(state.shear_x[g.index(i, 0)] - f * (p(g.x(i), 1.0) - p(g.x(i) - (1.0 - d), d)), 2) * g.dx;
    shears.push_back(std::sqrt(squares) / (f * P));
    forces.push_back(report.tangential.force[0] / (f * P * (1.0 - d * d)) - 1.0);
  }
  test::expect_close("cylinders that roll, 8 cells: force at a creepage, share of the exact one", 1.0 + forces.front(),
                     1.0, 2e-3, "exact: Carter (1926)");
  EXPECT_GT(test::Orders("Carter, shear", shears).overall, 0.7);
  test::expect_close("cylinders that roll: force at a creepage, share of the exact one", 1.0 + forces.back(), 1.0, 1e-4,
                     "exact: Carter (1926)");
}

TEST(Kalker, CreepCoefficientsOfBalls)
{
  // Without slip the force is C G a b times the creepage: C11 = 4.12 along and C22 = 3.67 across the rolling direction for
  // nu = 0.25 (Kalker 1967; Johnson 1985, table 8.1), which has three digits. A very small creepage leaves slip only at the trailing
  // edge, where the shear without slip has no end, so that the error is of first order in the cell.
  Field along, across;
  for (const int cells : {8, 16, 32})
  {
    Balls balls(cells, 0.25);
    const double creepage = 1e-3 * balls.mu * balls.P;
    for (const bool is_along : {true, false})
    {
      FrictionState state = balls.untouched();
      FrictionReport report;
      const TangentialDrive::Axis moved = shift(creepage * balls.grid.dx);
      for (int step = 0; step < 10 * cells; ++step)
        report = balls.step({Drive::Kind::load, balls.P},
                            {is_along ? moved : shift(0.0), is_along ? shift(0.0) : moved}, state, {-1, 0});
      (is_along ? along : across).push_back(report.tangential.force[is_along ? 0 : 1] / creepage);
    }
  }
  std::printf("  C11 %.4f %.4f %.4f, C22 %.4f %.4f %.4f\n", along[0], along[1], along[2], across[0], across[1],
              across[2]);
  for (const auto& [found, table] : {std::pair{along[0], 4.12}, {across[0], 3.67}})
    test::expect_close("balls that roll, 8 cells: creep coefficient over the table's", found / table, 1.0, 0.03,
                       "table: Kalker (1967)");
  const auto limit = [](const Field& values) { return 2.0 * values[2] - values[1]; }; // of first order
  test::expect_close("balls that roll: creep coefficient C11, nu = 0.25", limit(along), 4.12, 0.02 * 4.12,
                     "table: Kalker (1967)");
  test::expect_close("balls that roll: creep coefficient C22, nu = 0.25", limit(across), 3.67, 0.02 * 3.67,
                     "table: Kalker (1967)");
}

} // namespace
} // namespace brinell::verification::creepage_test
