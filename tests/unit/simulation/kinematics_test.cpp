// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/kinematics.hpp"

#include "order.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace brinell::simulation::kinematics_test
{
namespace
{

// Boucly, Nelias & Green (2006): R1 = R2 = 1 m, nine critical interferences, Delta = dx = 3.85 mm on each body.
constexpr double critical_interference = 2.214290e-4;
constexpr double paper_dx = 3.85e-3;
constexpr int paper_cells = 2;
constexpr double paper_shift = paper_cells * paper_dx;

std::vector<Position> positions(const Passing& passing)
{
  std::vector<Position> all{passing.start(0)};
  for (int i = 0; i < passing.step_count(); ++i)
    all.push_back(passing.next(all.back()));
  return all;
}

TEST(PassingTest, StartDistanceAndAngleOfThePaper)
{
  const Passing p(1.0, 1.0, 9.0 * critical_interference, paper_cells, paper_dx, Kinematics::paper);
  EXPECT_NEAR(p.start_distance(), 0.089261, 0.5e-6); // digits of the source
  EXPECT_DOUBLE_EQ(p.separation(), 2.0 - 9.0 * critical_interference);
  EXPECT_NEAR(std::tan(p.angle_at_touch()), 0.04467, 0.5e-5);
  EXPECT_DOUBLE_EQ(p.start(0).X, -p.start_distance());
}

TEST(PassingTest, StepsOfThePaper)
{
  // Eqs. 9-14, written once more: d = sum of omega atan(2 Delta/omega').
  const double omega = 2.0 - 9.0 * critical_interference;
  const double d0 = std::sqrt(4.0 - omega * omega);
  const Passing passing(1.0, 1.0, 9.0 * critical_interference, paper_cells, paper_dx, Kinematics::paper);
  EXPECT_EQ(passing.step_count(), 24); // crosses 2 d0 (the paper counts the positions: 25)
  double d = 0.0;
  int i = 0;
  for (const Position& p : positions(passing))
  {
    const double separation = std::sqrt(omega * omega + (d0 - d) * (d0 - d));
    EXPECT_NEAR(p.X, d - d0, 1e-14); // rounding of 24 sums
    EXPECT_NEAR(p.interference, 2.0 - separation, 1e-14);
    EXPECT_EQ(p.index, i++);
    d += omega * std::atan(paper_shift / separation);
  }
  EXPECT_GE(positions(passing).back().X, d0);
  EXPECT_LT(positions(passing)[23].X, d0);
}

class Kinds : public testing::TestWithParam<Kinematics>
{
};

TEST_P(Kinds, CentresStayAtOneHeight)
{
  for (const double upper : {1.0, 1.7})
  {
    const double interference = 0.002;
    const Passing passing(0.8, upper, interference, 4, 1e-3, GetParam());
    for (const Position& p : positions(passing))
    {
      // omega'^2 = omega^2 + X^2, tan theta = X/omega, alpha = R1 + R2 - omega': to rounding.
      const double separation = 0.8 + upper - p.interference;
      EXPECT_NEAR(separation * std::cos(p.theta), passing.separation(), 1e-14);
      EXPECT_NEAR(separation * std::sin(p.theta), p.X, 1e-14);
      EXPECT_LE(p.interference, interference + 1e-14);
    }
  }
}

TEST_P(Kinds, ArcsAreSharedByTheRadii)
{
  const double shift = 0.004;
  const Passing passing(0.8, 1.7, 0.002, 4, 1e-3, GetParam());
  const std::vector<Position> all = positions(passing);
  for (std::size_t i = 1; i < all.size(); ++i)
  {
    EXPECT_NEAR(all[i].arc_lower - all[i - 1].arc_lower, shift * 0.8 / 2.5, 1e-15);
    EXPECT_NEAR(all[i].arc_upper - all[i - 1].arc_upper, -shift * 1.7 / 2.5, 1e-15);
    EXPECT_GT(all[i].X, all[i - 1].X);
  }
}

TEST_P(Kinds, BeginsOutsideContactAndEndsOutsideIt)
{
  for (const double shift : {0.0005, 0.004, 0.0173, 0.1})
  {
    const Passing passing(1.0, 1.3, 0.003, 3, shift / 3.0, GetParam());
    const std::vector<Position> all = positions(passing);
    EXPECT_LE(all.front().interference, 1e-15) << shift;
    EXPECT_GT(all[1].interference, 0.0) << shift;
    EXPECT_GT(all[all.size() - 2].interference, 0.0) << shift;
    EXPECT_LE(all.back().interference, 1e-15) << shift;
  }
}

TEST_P(Kinds, EarlierStartsLieOnTheSamePath)
{
  const Passing passing(1.0, 1.0, 0.002, paper_cells, paper_dx, GetParam());
  Position p = passing.start(3);
  EXPECT_EQ(p.index, passing.start(0).index - 3);
  for (int i = 0; i < 3; ++i)
    p = passing.next(p);
  // The paper's step depends on where it begins, d(step)/dX = -step X/omega'^2: each of the three steps back misses the
  // way forth by step^2 X/omega'^2, with |X| below 0.12 m here.
  const double tolerance = GetParam() == Kinematics::exact ? 1e-14 : 3.0 * paper_shift * paper_shift * 0.12 / 4.0;
  EXPECT_NEAR(p.X, passing.start(0).X, tolerance);
  EXPECT_NEAR(p.arc_lower, passing.start(0).arc_lower, 1e-15);
  EXPECT_EQ(p.index, passing.start(0).index);
}

INSTANTIATE_TEST_SUITE_P(Passing, Kinds, testing::Values(Kinematics::exact, Kinematics::paper),
                         [](const auto& kind) { return kind.param == Kinematics::exact ? "Exact" : "Paper"; });

TEST(PassingTest, ExactStepsAreSymmetricAboutAlignment)
{
  const Passing passing(0.8, 1.7, 0.002, 4, 1e-3, Kinematics::exact);
  const std::vector<Position> all = positions(passing);
  ASSERT_EQ(all.size() % 2, 1u);
  const std::size_t middle = all.size() / 2;
  EXPECT_EQ(all[middle].X, 0.0);
  EXPECT_EQ(all[middle].index, 0);
  EXPECT_EQ(all[middle].theta, 0.0);
  EXPECT_NEAR(all[middle].interference, 0.002, 1e-15);
  for (std::size_t i = 0; i < middle; ++i)
  {
    EXPECT_EQ(all[i].X, -all[all.size() - 1 - i].X);
    EXPECT_EQ(all[i].interference, all[all.size() - 1 - i].interference);
    EXPECT_EQ(all[i].arc_lower, -all[all.size() - 1 - i].arc_lower);
  }
}

TEST(PassingTest, ExactArcsAreRadiusTimesAngle)
{
  const Passing passing(0.8, 1.7, 0.002, 4, 1e-3, Kinematics::exact);
  for (const Position& p : positions(passing))
  {
    EXPECT_NEAR(p.arc_lower, 0.8 * p.theta, 1e-15);
    EXPECT_NEAR(p.arc_upper, -1.7 * p.theta, 1e-15);
  }
}

TEST_P(Kinds, PartsOfAStepLeadToItsEnd)
{
  // An increment that has to be split stops at whole cells in between.
  const Passing passing(0.8, 1.7, 0.002, 4, 1e-3, GetParam());
  const Position from = passing.next(passing.start(0)), to = passing.next(from);
  EXPECT_EQ(to.columns - from.columns, 4);
  double before = from.X;
  for (int columns = 1; columns <= 3; ++columns)
  {
    const Position part = passing.within_step(from, columns);
    EXPECT_EQ(part.columns, from.columns + columns);
    EXPECT_NEAR(part.arc_lower - from.arc_lower, columns * 1e-3 * 0.8 / 2.5, 1e-15);
    EXPECT_GT(part.X, before);
    EXPECT_LT(part.X, to.X);
    before = part.X;
  }
  const Position end = passing.within_step(from, 4);
  EXPECT_EQ(end.X, to.X);
  EXPECT_EQ(end.index, to.index);
}

TEST(PassingTest, StepThatLandsOnFirstTouchIsNotDoubled)
{
  const Passing any(1.0, 1.0, 0.002, 4, 1e-3, Kinematics::exact);
  for (const int n : {1, 3, 7, 12, 29})
  {
    const Passing passing(1.0, 1.0, 0.002, 1, 2.0 * any.angle_at_touch() / n, Kinematics::exact);
    EXPECT_EQ(passing.first_index(), -n);
    EXPECT_EQ(passing.step_count(), 2 * n);
  }
}

TEST(PassingTest, BothKinematicsAgreeToSecondOrderInTheAngle)
{
  // At the same arc the sliding distances differ by theta0^2 of d0: per unit of arc they grow by cos(theta) and
  // cos(theta0)/cos^2(theta). A fourth of the interference halves the angle.
  std::vector<double> errors;
  for (const double interference : {36.0, 9.0, 2.25, 0.5625})
  {
    const Passing passing(0.8, 1.2, interference * critical_interference, 1, 1e-3, Kinematics::paper);
    double error = 0.0;
    for (const Position& p : positions(passing))
      error = std::max(error, std::abs(p.X - passing.separation() * std::tan(p.arc_lower / 0.8)));
    errors.push_back(error / passing.start_distance());
    EXPECT_LT(errors.back(), passing.angle_at_touch() * passing.angle_at_touch());
  }
  EXPECT_NEAR(test::Orders("paper's kinematics in theta0", errors).overall, 2.0, 0.1); // the step leaves a little
}

} // namespace
} // namespace brinell::simulation::kinematics_test
