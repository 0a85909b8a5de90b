// SPDX-License-Identifier: BSD-3-Clause
#include "order.hpp"
#include "record.hpp"
#include "rubbing_punch.hpp"
#include "scenario_runs.hpp"

#include "brinell/simulation/fretting.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

/// Bodies of unlike materials that are pressed together with friction: their surfaces are stretched by the pressure, one more
/// than the other, and slip at the rim of the contact.
namespace brinell::verification::pressing_test
{
namespace
{

using simulation::FrettingCase;
using simulation::FrettingRecord;

const Elastic rigid{std::numeric_limits<double>::infinity(), 0.0};

/// An elastic body on a rigid flat; Dundurs' constant is (1 - 2 nu)/(2 (1 - nu)).
FrettingCase pressed(const simulation::Shape& shape, double poisson_ratio, double friction, int steps)
{
  FrettingCase c;
  c.lower = {simulation::Plane{}, {rigid, {}}};
  c.upper = {shape, {{200e9, poisson_ratio}, {}}};
  c.press = load(1e5);
  c.press_steps = steps;
  c.friction.coefficient = friction;
  c.cycles = 0;
  return c;
}

std::vector<FrettingRecord> history_of(const FrettingCase& c)
{
  std::vector<FrettingRecord> history;
  simulation::Observer<FrettingRecord> observer;
  observer.on_step = [&](const FrettingRecord& r, int) { history.push_back(r); };
  static_cast<void>(simulation::run(c, observer));
  return history;
}

double dundurs(double nu)
{
  return (1.0 - 2.0 * nu) / (2.0 * (1.0 - nu));
}

/// Stick radius over that of the contact: mean over the steps between two shares of them, as it jumps with the cells on both edges.
/// @param power  of the share of the area that sticks
double stick_radius(const std::vector<FrettingRecord>& history, double power, double from, double to)
{
  const auto at = [&](double share)
  { return history.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(history.size())); };
  return std::accumulate(at(from), at(to), 0.0,
                         [&](double sum, const FrettingRecord& r) { return sum + std::pow(r.stick_share, power); }) /
         static_cast<double>(at(to) - at(from));
}

/// Complete elliptic integral with the complementary modulus.
double complementary_K(double c)
{
  return std::comp_ellint_1(std::sqrt(1.0 - c * c));
}

/// Where a function that grows is zero, between 0 and 1.
template <typename Function>
double root(const Function& f)
{
  double low = 1e-6, high = 1.0 - 1e-9;
  for (int i = 0; i < 60; ++i)
    (f(0.5 * (low + high)) < 0.0 ? low : high) = 0.5 * (low + high);
  return low;
}

/// What the closed forms leave out is what the shear does to the pressure, about friction times Dundurs' constant; edges are found to
/// half a cell.
double tolerance(const FrettingCase& c)
{
  return 0.5 / c.resolution + c.friction.coefficient * dundurs(c.upper.material.elastic.poisson_ratio);
}

TEST(Spence, StickOfACylinderPressedOnAFlat)
{
  // As the load grows the solution stays similar to itself, and each increment of it is that of a flat punch (Spence 1968, 1975).
  // Without what shear does to the pressure (Goodman 1962), q = f p in |x| > c and the surfaces do not move within; that the rest of
  // q is bounded at c asks for beta K(c/a) = f K'(c/a).
  const double nu = 0.45, friction = dundurs(nu);
  const double without = root([](double c) { return std::comp_ellint_1(c) - complementary_K(c); });
  EXPECT_NEAR(without, std::sqrt(0.5), 1e-12);
  std::vector<double> differences;
  double coarser = 0.0, found = 0.0;
  for (const int steps : {20, 40, 80, 160})
  {
    FrettingCase c = pressed(simulation::Roller{1.0, std::numeric_limits<double>::infinity()}, nu, friction, steps);
    c.domain.y = {Boundary::periodic, 1.0, 1};
    c.resolution = 32.0;
    const std::vector<FrettingRecord> history = history_of(c);
    found = stick_radius(history, 1.0, 0.5, 1.0);
    if (coarser > 0.0)
      differences.push_back(found - coarser);
    coarser = found;
    if (steps < 160)
      continue;
    // Similar to itself.
    EXPECT_NEAR(stick_radius(history, 1.0, 0.75, 1.0), stick_radius(history, 1.0, 0.5, 0.75), 0.5 / c.resolution);
    test::expect_close("cylinder pressed on a flat, friction as Dundurs' constant: stick over contact", found, without,
                       tolerance(c), "exact without coupling: Spence (1975); edges to half a cell");
    test::expect_close("the same with all of the coupling", found, test::stick_of_a_punch(friction, friction),
                       0.5 / c.resolution, "integral equations of a punch (Spence 1973, 1975); edges to half a cell");
  }
  EXPECT_GT(test::Orders("stick of a pressed cylinder, steps halved", differences).overall, 0.8);
}

/// Stick over contact of a cylinder pressed on a rigid flat in plane strain, extrapolated from 80 and 160 steps.
double stick_of_a_cylinder(double nu, double friction, double resolution)
{
  double coarser = 0.0, found = 0.0;
  for (const int steps : {80, 160})
  {
    FrettingCase c = pressed(simulation::Roller{1.0, std::numeric_limits<double>::infinity()}, nu, friction, steps);
    c.domain.y = {Boundary::periodic, 1.0, 1};
    c.resolution = resolution;
    coarser = std::exchange(found, stick_radius(history_of(c), 1.0, 0.5, 1.0));
  }
  return 2.0 * found - coarser;
}

TEST(Spence, StickOfACylinderWithAllOfTheCoupling)
{
  // Without what shear does to the pressure, the stick of a cylinder of nu = 0 would be 0.28 and 0.87 of the contact in place of 0.18 and 0.70.
  constexpr double cells = 32.0;
  for (const auto& [nu, friction] : {std::pair{0.3, 0.3}, {0.0, 0.3}, {0.0, 0.65}})
    test::expect_close(
        fmt::format("cylinder of nu = {:g} pressed on a rigid flat, friction {:g}: stick over contact", nu, friction),
        stick_of_a_cylinder(nu, friction, cells), test::stick_of_a_punch(dundurs(nu), friction), 0.5 / cells,
        "integral equations of a punch, which has the same stick (Spence 1973, 1975); edges to half a cell");
  std::vector<double> errors;
  for (const double resolution : {16.0, 32.0, 64.0})
    errors.push_back(stick_of_a_cylinder(0.0, 0.3, resolution) - test::stick_of_a_punch(dundurs(0.0), 0.3));
  EXPECT_GT(test::Orders("stick of a cylinder of nu = 0, cells halved", errors).overall, 0.7);
}

TEST(Spence, StickOfABallPressedOnAFlat)
{
  // Likewise ln((1 + c)/(1 - c))/2c = (f/beta) K'(c), for a radius of the contact of 1.
  const double nu = 0.48, friction = dundurs(nu);
  const double exact = root([](double c) { return std::log((1.0 + c) / (1.0 - c)) / (2.0 * c) - complementary_K(c); });
  FrettingCase c = pressed(ball(1.0), nu, friction, 40);
  c.resolution = 16.0;
  const std::vector<FrettingRecord> history = history_of(c);
  test::expect_close("ball pressed on a flat, friction as Dundurs' constant: stick radius over contact radius",
                     stick_radius(history, 0.5, 0.5, 1.0), exact, tolerance(c),
                     "exact without coupling: Spence (1975); edges to half a cell");
}

} // namespace
} // namespace brinell::verification::pressing_test
