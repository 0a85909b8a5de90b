// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/reference/hertz.hpp"
#include "frictional_pairs.hpp"
#include "order.hpp"
#include "random_field.hpp"
#include "record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

/// Stick and slip of elastic bodies.
namespace brinell::verification::tangential_contact_test
{
namespace
{

TEST(CattaneoMindlin, StickRadiusShearAndShiftOfTwoBalls)
{
  // Without Poisson's effect slip is along the force, and the solution is exact: q = mu (p(r; a) - p(r; c)). At both rims the
  // shear is a root: it errs by the root of the cell on a strip as wide as the cell, so by first order in the mean square; the
  // stick area by cells on its rim; the shift, an integral of the shear, by the power 1.5.
  const double share = 7.0 / 8.0, c = 0.5;
  Field shears, radii, shifts;
  for (const int cells : {10, 20, 40, 80})
  {
    Balls balls(cells, 0.0);
    FrictionState state = balls.untouched();
    const FrictionReport report = balls.push(share, state);
    double squares = 0.0;
    for (int j = 0; j < balls.grid.ny; ++j)
      for (int i = 0; i < balls.grid.nx; ++i)
      {
        const double r = std::hypot(balls.grid.x(i), balls.grid.y(j));
        const double exact = balls.friction * (balls.pressure(r, 1.0) - balls.pressure(r, c));
        squares += std::pow(state.shear_x[balls.grid.index(i, j)] - exact, 2) * balls.grid.cell_area();
        EXPECT_NEAR(state.shear_y[balls.grid.index(i, j)], 0.0, 1e-6 * balls.P);
      }
    shears.push_back(std::sqrt(squares) / (balls.friction * balls.P));
    radii.push_back(std::sqrt(balls.sticking_area(state) / pi) / c - 1.0);
    shifts.push_back(report.tangential.shift[0] / (balls.sliding_shift() * (1.0 - c * c)) - 1.0);
    EXPECT_NEAR(report.tangential.force[0], share * balls.friction * balls.P, 1e-12 * balls.P);
  }
  EXPECT_GT(test::Orders("Cattaneo-Mindlin, shear, cells halved", shears).overall, 0.95);
  EXPECT_GT(test::Orders("Cattaneo-Mindlin, stick radius", radii).overall, 0.8);
  EXPECT_GT(test::Orders("Cattaneo-Mindlin, shift", shifts).overall, 1.3);
  test::expect_close("balls: stick radius, share of the exact one", 1.0 + radii.back(), 1.0, 1.0 / 80,
                     "exact: Cattaneo (1938), Mindlin (1949); half a cell of a stick radius of 40");
  test::expect_close("balls: shift at 7/8 of the limit, share of the exact one", 1.0 + shifts.back(), 1.0,
                     0.2 * std::pow(80.0, -1.5), "exact: Mindlin (1949)");
}

TEST(CattaneoMindlin, WithPoissonsEffectTheClosedFormIsNearlyTrue)
{
  // Shears along x then displace along y where they vary, and slip is not quite along the force, as the closed form has it
  // (Johnson 1985, section 7.2). It errs by some tenths of a percent; that is not an error of the grid.
  Field ratios;
  for (const int cells : {16, 32, 64})
  {
    Balls balls(cells, 0.42);
    FrictionState state = balls.untouched();
    const FrictionReport report = balls.push(7.0 / 8.0, state);
    ratios.push_back(report.tangential.shift[0] / (0.75 * balls.sliding_shift()));
  }
  test::expect_within("balls, nu = 0.42: shift over Mindlin's", ratios.back(), 0.995, 1.0005,
                      "Mindlin (1949), approximate: slip across the force is ignored");
  EXPECT_LT(std::abs(ratios[2] - ratios[1]), 0.3 * std::abs(1.0 - ratios[2])); // what is left is not the grid's
}

TEST(MindlinDeresiewicz, UnloadingReversalAndEnergyOfCycles)
{
  // From +Q to -Q and back in one step each. The steps are exact: bound and direction stay, so that nothing is lost between.
  const double share = 0.8;
  Field backs, energies;
  for (const int cells : {16, 32, 64})
  {
    Balls balls(cells, 0.0);
    FrictionState state = balls.untouched();
    (void)balls.push(share, state);
    (void)balls.push(0.3 * share, state);
    const double turned = std::pow(1.0 - 0.5 * 0.7 * share, 2.0 / 3.0), first = std::pow(1.0 - share, 2.0 / 3.0);
    backs.push_back(state.shift[0] / (balls.sliding_shift() * (2.0 * turned - first - 1.0)) - 1.0);
    (void)balls.push(-share, state);
    const double before = state.dissipated, low = state.shift[0];
    (void)balls.push(share, state);
    EXPECT_NEAR(state.shift[0], -low, 1e-6 * balls.sliding_shift()); // the loop is closed and symmetric
    (void)balls.push(-share, state);
    EXPECT_NEAR(state.shift[0], low, 1e-6 * balls.sliding_shift());
    const double exact = 4.8 * balls.sliding_shift() * balls.friction * balls.P *
                         (1.0 - std::pow(1.0 - share, 5.0 / 3.0) - 5.0 / 6.0 * share * (1.0 + first));
    energies.push_back((state.dissipated - before) / exact - 1.0);
  }
  EXPECT_GT(test::Orders("Mindlin-Deresiewicz, shift on unloading", backs).overall, 1.0);
  EXPECT_GT(test::Orders("Mindlin-Deresiewicz, energy of a cycle", energies).overall, 1.0);
  test::expect_close("balls: shift on unloading, share of the exact one", 1.0 + backs.back(), 1.0, 1.0 / (64 * 64),
                     "exact: Mindlin and Deresiewicz (1953)");
  test::expect_close("balls: energy of a cycle, share of the exact one", 1.0 + energies.back(), 1.0,
                     0.5 * std::pow(64.0, -1.5), "exact: Mindlin and Deresiewicz (1953)");
}

TEST(CattaneoMindlin, StickOfCylinders)
{
  // In plane strain the closed form is exact for any material (Cattaneo 1938): c/a = sqrt(1 - Q/(mu P)), and no shear along
  // the axis.
  const double share = 0.75, R = 100.0, P = pi / 4.0 / R; // a = 1 with E' = 1
  Field errors;
  for (const int cells : {16, 32, 64, 128})
  {
    const SurfaceGrid g{2 * cells + 5, 1, 1.0 / cells, 1.0, Boundary::open, Boundary::periodic};
    const Elastic body{2.0 * (1.0 - 0.09), 0.3};
    Pair pair(g, body, body, 0.3, test::sampled(g, [&](int i, int) { return std::pow(g.x(i), 2) / (2.0 * R); }),
              1.0 / R, 20.0);
    FrictionState state = pair.untouched();
    (void)pair.step({Drive::Kind::load, P}, {force(share * 0.3 * P), shift(0.0)}, state);
    const auto p = [&](double x, double c) { return std::sqrt(std::max(0.0, c * c - x * x)) / (2.0 * R); };
    double squares = 0.0;
    for (int i = 0; i < g.nx; ++i)
      squares += std::pow(state.shear_x[g.index(i, 0)] - 0.3 * (p(g.x(i), 1.0) - p(g.x(i), 0.5)), 2) * g.dx;
    errors.push_back(std::sqrt(squares) / (0.3 * P));
    EXPECT_NEAR(pair.sticking_area(state), 1.0, 2.01 * g.dx);
  }
  EXPECT_GT(test::Orders("Cattaneo, cylinders, shear, cells halved", errors).overall, 0.95);
  // First order, as for balls: sqrt(2 h) on a width h on both rims of both pressures, over P = pi/2 times the peak.
  test::expect_close("cylinders: shear, mean square error over the mean", errors.back(), 0.0, 1.0 / 128,
                     "exact: Cattaneo (1938)");
}

/// A self-affine looking surface: some waves of random direction and phase.
Field rough(const SurfaceGrid& g, unsigned seed)
{
  std::mt19937_64 engine(seed);
  Field h(g.size());
  for (int wave = 1; wave <= 12; ++wave)
  {
    const double m = std::round(test::uniform(engine, -6.0, 6.0)),
                 n = g.ny > 1 ? std::round(test::uniform(engine, -6.0, 6.0)) : 0.0;
    const double phase = test::uniform(engine, 0.0, 2.0 * pi), height = 0.01 / (1.0 + std::hypot(m, n));
    for (int j = 0; j < g.ny; ++j)
      for (int i = 0; i < g.nx; ++i)
        h[g.index(i, j)] += height * std::cos(2.0 * pi * (m * i / g.nx + n * j / g.ny) + phase);
  }
  return h;
}

TEST(Ciavarella, ShearIsTheDifferenceOfTwoPressuresForAnyShape)
{
  // q = mu (p(P) - p(P - Q/mu)) (Jaeger 1998; Ciavarella 1998): for equal bodies, exact in plane strain and without Poisson's
  // effect. There shear and pressure have the same discrete operator, but for a uniform displacement, so that this holds
  // cell by cell; what is left are the tolerances.
  struct Case
  {
    SurfaceGrid grid;
    double nu;
  };
  const Boundary open = Boundary::open, periodic = Boundary::periodic;
  for (const Case& c :
       {Case{{128, 1, 1.0 / 128, 1.0, periodic, periodic}, 0.3}, Case{{96, 1, 1.0 / 96, 1.0, open, periodic}, 0.3},
        Case{{64, 48, 1.0 / 64, 1.0 / 64, periodic, periodic}, 0.0},
        Case{{48, 40, 1.0 / 48, 1.0 / 48, open, open}, 0.0}, Case{{40, 48, 1.0 / 40, 1.0 / 48, periodic, open}, 0.0}})
  {
    const Elastic body{2.0, c.nu};
    const double P = 0.02 * (c.grid.ny == 1 ? c.grid.ny * c.grid.dy : 1.0), friction = 0.4, Q = 0.7 * friction * P;
    Pair pair(c.grid, body, body, friction, rough(c.grid, 5), 0.02, 20.0);
    pair.relative = 1e-10;
    FrictionState state = pair.untouched(), less = pair.untouched();
    (void)pair.step({Drive::Kind::load, P}, {force(Q), shift(0.0)}, state);
    (void)pair.step({Drive::Kind::load, P - Q / friction}, {}, less);
    const double peak = *std::max_element(state.pressure.begin(), state.pressure.end());
    double largest = 0.0;
    for (std::size_t i = 0; i < c.grid.size(); ++i)
      largest =
          std::max(largest, std::abs(state.shear_x[i] - friction * (state.pressure[i] - less.pressure[i])) / peak);
    std::printf("  Ciavarella on %d x %d cells: largest difference %.1e of the peak pressure\n", c.grid.nx, c.grid.ny,
                largest);
    // A gap of the tolerance at one cell is a pressure of E' times the tolerance over its size.
    EXPECT_LT(largest, 10.0 * 2e-12 / c.grid.dx / peak + 1e-9);
  }
}

TEST(Stick, OfASurfaceThatIsStretchedInWavesHasTheClosedForm)
{
  // Full contact of a period that sticks, while a wave of displacement along the surface is forced on it: the shear takes it
  // back, with (1 - nu)/(G k) along the wave and 1/(G k) across it, of each body.
  const SurfaceGrid g{24, 20, 0.5, 0.7, Boundary::periodic, Boundary::periodic};
  const Elastic one{1.3, 0.28}, two{4.0, 0.1};
  const halfspace::SurfaceCompliance tractions(g, one, two);
  contact::TangentialContact contact(tractions);
  const double m = 2.0 * pi * 2 / (g.nx * g.dx), n = 2.0 * pi * 3 / (g.ny * g.dy), k = std::hypot(m, n);
  const double along = 0.02, across = -0.03, c = m / k, s = n / k;
  const auto wave = [&](double factor)
  { return test::sampled(g, [&](int i, int j) { return factor * std::cos(m * i * g.dx + n * j * g.dy); }); };
  const Field change_x = wave(along * c - across * s), change_y = wave(along * s + across * c), bound(g.size(), 1.0);
  Field x(g.size()), y(g.size()), slip_x(g.size()), slip_y(g.size());
  contact::TangentialStep step{bound, {}, {change_x, change_y}, {force(0.0), force(0.0)}};
  ASSERT_TRUE(contact.solve(step, 1e-14, 100, {x, y}, {slip_x, slip_y}).converged);
  const auto sum = [](const Elastic& a, const Elastic& b, auto part) { return part(a) + part(b); };
  const double q_l =
      -along * k / sum(one, two, [](const Elastic& b) { return (1.0 - b.poisson_ratio) / b.shear_modulus(); });
  const double q_t = -across * k / sum(one, two, [](const Elastic& b) { return 1.0 / b.shear_modulus(); });
  const Field exact_x = wave(q_l * c - q_t * s), exact_y = wave(q_l * s + q_t * c);
  for (std::size_t i = 0; i < g.size(); ++i)
  {
    EXPECT_NEAR(x[i], exact_x[i], 1e-11);
    EXPECT_NEAR(y[i], exact_y[i], 1e-11);
  }
}

TEST(Sliding, OfAllIsTheLimitOfALargeShift)
{
  Balls balls(20, 0.3);
  FrictionState state = balls.untouched();
  const double share = 5.0;
  const FrictionReport report =
      balls.push({shift(share * 0.6 * balls.sliding_shift()), shift(-share * 0.8 * balls.sliding_shift())}, state);
  // The shear turns out of the direction of the shift by a part of the slip, so that the force is a little less.
  EXPECT_NEAR(std::hypot(report.tangential.force[0], report.tangential.force[1]), balls.friction * balls.P,
              1e-3 * balls.friction * balls.P);
  EXPECT_EQ(balls.sticking_area(state), 0.0);
  for (std::size_t i = 0; i < balls.grid.size(); ++i)
    EXPECT_NEAR(std::hypot(state.shear_x[i], state.shear_y[i]), balls.friction * state.pressure[i], 1e-12 * balls.P);
  EXPECT_NEAR(report.tangential.dissipated,
              std::inner_product(state.shear_x.begin(), state.shear_x.end(), balls.slip_x.begin(), 0.0) *
                      balls.grid.cell_area() +
                  std::inner_product(state.shear_y.begin(), state.shear_y.end(), balls.slip_y.begin(), 0.0) *
                      balls.grid.cell_area(),
              1e-12 * report.tangential.dissipated);
}

TEST(PartialSlip, ForceAndShiftAreTwoWaysToTheSameState)
{
  Balls balls(24, 0.3);
  FrictionState by_force = balls.untouched(), by_shift = balls.untouched();
  const double limit = balls.friction * balls.P;
  for (const auto& [x, y] : {std::pair{0.6, 0.2}, {0.1, 0.5}, {-0.4, 0.1}})
  {
    const FrictionReport one = balls.push({force(x * limit), force(y * limit)}, by_force);
    const FrictionReport two = balls.push({shift(one.tangential.shift[0]), shift(one.tangential.shift[1])}, by_shift);
    // The stiffness of the contact, about 4 G a/(2 - nu), times the tolerance of the shift.
    EXPECT_NEAR(two.tangential.force[0], x * limit, 1e-6 * limit);
    EXPECT_NEAR(two.tangential.force[1], y * limit, 1e-6 * limit);
    EXPECT_NEAR(by_shift.dissipated, by_force.dissipated, 1e-5 * by_force.dissipated);
  }
}

TEST(PartialSlip, DoesNotKnowDirections)
{
  // Without Poisson's effect the operator is the same in all directions; with it, up to the cells. A quarter of a turn is
  // exact.
  const double share = 0.8, c = std::cos(0.5), s = std::sin(0.5);
  Field differences;
  for (const int cells : {8, 16, 32})
    for (const double nu : {0.0, 0.4})
    {
      Balls balls(cells, nu);
      FrictionState along = balls.untouched(), turned = balls.untouched(), oblique = balls.untouched();
      const double limit = balls.friction * balls.P;
      const FrictionReport one = balls.push(share, along);
      const FrictionReport quarter = balls.push({shift(0.0), force(share * limit)}, turned);
      const FrictionReport other = balls.push({force(c * share * limit), force(s * share * limit)}, oblique);
      EXPECT_NEAR(quarter.tangential.shift[1], one.tangential.shift[0], 1e-6 * one.tangential.shift[0]);
      EXPECT_NEAR(quarter.tangential.dissipated, one.tangential.dissipated, 1e-5 * one.tangential.dissipated);
      const double difference =
          std::hypot(other.tangential.shift[0], other.tangential.shift[1]) / one.tangential.shift[0] - 1.0;
      if (nu == 0.0)
      {
        EXPECT_NEAR(difference, 0.0, 1e-6);
      }
      else
        differences.push_back(difference);
    }
  EXPECT_GT(test::Orders("partial slip, shift in an oblique direction", differences).overall, 1.0);
  EXPECT_LT(std::abs(differences.back()), 1e-3);
}

TEST(Coupling, EqualBodiesKeepThePressureOfAFrictionlessContact)
{
  Balls balls(24, 0.3);
  FrictionState with = balls.untouched(), without = balls.untouched();
  const FrictionReport report = balls.push(0.8, with);
  balls.friction = 0.0;
  (void)balls.step({Drive::Kind::load, balls.P}, {}, without);
  EXPECT_EQ(report.alternations, 1);
  EXPECT_EQ(with.pressure, without.pressure);
}

TEST(Coupling, PunchThatSticksIsStifferByTheFactorOfMossakovskii)
{
  // A rigid flat circular punch on a half space with nu: without slip the load at an approach is (1 - nu) ln(3 - 4 nu)/(1 - 2 nu)
  // times that without friction (Mossakovskii 1954; Spence 1968). A pressed area of cells differs from the circle by first
  // order, in both loads alike; the rest is from the singular edge.
  for (const double nu : {0.0, 0.3})
  {
    Field errors;
    const double exact = (1.0 - nu) * std::log(3.0 - 4.0 * nu) / (1.0 - 2.0 * nu);
    for (const int cells : {8, 16, 32})
    {
      const SurfaceGrid g = Balls::square(cells);
      const Elastic body{2.0 * (1.0 + nu), nu};
      const Field punch = test::sampled(g, [&](int i, int j) { return std::hypot(g.x(i), g.y(j)) < 1.0 ? 0.0 : 10.0; });
      std::vector<double> loads;
      for (const double friction : {0.0, 1000.0})
      {
        Pair pair(g, body, rigid, friction, punch, 0.01);
        pair.relative = 1e-6;
        FrictionState state = pair.untouched();
        (void)pair.step({Drive::Kind::approach, 0.01}, {}, state);
        loads.push_back(std::accumulate(state.pressure.begin(), state.pressure.end(), 0.0));
      }
      errors.push_back(loads[1] / loads[0] / exact - 1.0);
    }
    EXPECT_GT(test::Orders("flat punch that sticks, load, cells halved", errors).overall, 0.8);
    test::expect_close(nu == 0.0 ? "flat punch that sticks, nu = 0: load over that without friction"
                                 : "flat punch that sticks, nu = 0.3: load over that without friction",
                       exact * (1.0 + errors.back()), exact, 0.2 / 32 * exact,
                       "exact: Mossakovskii (1954), Spence (1968)");
  }
}

TEST(Coupling, StripThatSticksHasThePressureOfTheClosedForm)
{
  // In the middle of a rigid flat strip p = 2 (1 - nu)/sqrt(3 - 4 nu) P/(pi a), against P/(pi a) without friction (Johnson
  // 1985, Eq. 2.69). First order, by the edge.
  const double nu = 0.1, exact = 2.0 * (1.0 - nu) / std::sqrt(3.0 - 4.0 * nu);
  Field errors;
  for (const int cells : {17, 51, 153})
  {
    const SurfaceGrid g{cells + 6, 1, 2.0 / cells, 1.0, Boundary::open, Boundary::periodic};
    const Field punch = test::sampled(g, [&](int i, int) { return std::abs(g.x(i)) < 1.0 ? 0.0 : 10.0; });
    Pair pair(g, {2.0 * (1.0 + nu), nu}, rigid, 1000.0, punch, 0.01, 20.0);
    FrictionState state = pair.untouched();
    (void)pair.step({Drive::Kind::load, 0.01}, {force(0.0), shift(0.0)}, state);
    errors.push_back(state.pressure[g.index(g.nx / 2, 0)] * pi / 0.01 / exact - 1.0);
  }
  EXPECT_GT(test::Orders("flat strip that sticks, pressure, cells thirded", errors, 3.0).overall, 0.8);
  test::expect_close("flat strip that sticks: pressure in the middle, times pi a/P", exact * (1.0 + errors.back()),
                     exact, 0.5 / 76 * exact, "exact: Johnson (1985), Eq. 2.69");
}

} // namespace
} // namespace brinell::verification::tangential_contact_test
