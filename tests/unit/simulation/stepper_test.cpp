// SPDX-License-Identifier: BSD-3-Clause
// What happens to an increment that does not converge: it is halved, and a piece that still does not converge is solved by
// the plain fixed point. Both must end where an increment with all the evaluations it wants ends.
#include "simulation/stepping/stepper.hpp"

#include "brinell/foundation/error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

namespace brinell::simulation::stepper_test
{
namespace
{

constexpr double alpha_c = 2.214290e-4;   // m, first yield of two spheres of 1 m with the constants below
constexpr double yield_stress = 0.9115e9; // Pa

elastoplastic::Settings settings(int max_evaluations)
{
  elastoplastic::Settings s;
  // The convex problem, which has one answer whichever way it is solved; `path` depends on the stiffness in use.
  s.integration = elastoplastic::Integration::backward_euler;
  s.yield_tolerance = 1e-6;
  s.displacement_tolerance = 1e-7;
  s.max_evaluations = max_evaluations;
  return s;
}

/// Two spheres of 1 m, one of them elastic, on cells of a fifth of the contact radius.
class Press
{
public:
  explicit Press(const elastoplastic::Settings& solver, const std::vector<constitutive::KinematicTerm>& kinematic = {})
      : solver_(solver), plastic_{{200e9, 0.32}, constitutive::LinearHardening{yield_stress, 10e9}, kinematic},
        stepper_(plan(), {plastic_, elastic_, [](double x, double y) { return x * x + y * y; }, solver_, {}})
  {
  }

  /// The approach goes to `to` critical ones.
  /// @param finest  of the pieces, as a share of the way
  int go(double to, double finest)
  {
    tried_.clear();
    const double from = at_;
    const auto path = [&](double t)
    {
      tried_.push_back(t);
      return Target{{}, {contact::Drive::Kind::approach, (from + t * (to - from)) * alpha_c}};
    };
    const int evaluations = stepper_.advance(path, finest, "the press");
    at_ = to;
    return evaluations;
  }

  [[nodiscard]] const Stepper& stepper() const { return stepper_; }
  [[nodiscard]] const elastoplastic::BodyState& state() const { return stepper_.pair().lower().solved().state(); }
  /// Shares of the way that were tried, in their order.
  [[nodiscard]] const std::vector<double>& tried() const { return tried_; }
  /// Whether the plain fixed point was called for: it takes the same piece again.
  [[nodiscard]] bool was_descended() const { return std::adjacent_find(tried_.begin(), tried_.end()) != tried_.end(); }
  /// The shares of the way at which the pieces ended that converged: those after which the way went on.
  [[nodiscard]] std::vector<double> pieces() const
  {
    std::vector<double> ends;
    for (std::size_t i = 0; i < tried_.size(); ++i)
      if (i + 1 == tried_.size() || tried_[i + 1] > tried_[i])
        ends.push_back(tried_[i]);
    return ends;
  }

private:
  [[nodiscard]] static Plan plan()
  {
    Plan p;
    p.contact = {17, 17, 5e-3, 5e-3};
    p.lower = p.upper = VolumeGrid{p.contact, 12, 5e-3};
    p.scales = {alpha_c, 6.0 * alpha_c};
    return p;
  }

  elastoplastic::Settings solver_;
  constitutive::Material plastic_;
  constitutive::Material elastic_{{200e9, 0.32}, {}};
  Stepper stepper_;
  std::vector<double> tried_;
  double at_ = 0.0;
};

/// Largest difference over the largest value.
double difference(std::span<const double> a, std::span<const double> b)
{
  double change = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < b.size(); ++i)
  {
    change = std::max(change, std::abs(a[i] - b[i]));
    largest = std::max(largest, std::abs(b[i]));
  }
  return change / largest;
}

/// Both ended alike. The stress is known to 1e-6 of yield, and the plastic strain to that times the ratio of the elastic
/// stiffness to the softest one, which is ten or so here.
/// @param of_work  with back stresses the plastic work of a point follows the straight path to q, which depends on the
///                 stiffness that the solution took: to second order in the step.
void expect_alike(const Press& a, const Press& b, double of_work = 1e-5)
{
  constexpr double tolerance = 1e-5;
  EXPECT_LE(difference(a.state().plastic_strain, b.state().plastic_strain), tolerance);
  EXPECT_LE(difference(a.state().residual_displacement, b.state().residual_displacement), tolerance);
  EXPECT_LE(difference(a.stepper().pair().pressure(), b.stepper().pair().pressure()), tolerance);
  EXPECT_NEAR(a.state().dissipation, b.state().dissipation, of_work * b.state().dissipation);
  EXPECT_GT(*std::max_element(b.state().equivalent.begin(), b.state().equivalent.end()), 1e-3); // it did yield
}

/// The same way in increments that converge whole, with as many evaluations as they want.
Press in_pieces(const Press& split, double to, const std::vector<constitutive::KinematicTerm>& kinematic = {})
{
  constexpr int unlimited = 1000;
  Press press(settings(unlimited), kinematic);
  for (const double end : split.pieces())
    press.go(to * end, 1.0);
  EXPECT_EQ(press.stepper().split_increments(), 0);
  return press;
}

constexpr double most = 5.0; // critical approaches

TEST(StepperTest, AnIncrementThatFailsWholeIsHalvedAndEndsWhereShorterOnesEnd)
{
  struct Limit
  {
    int anderson_depth, max_evaluations;
  };
  for (const Limit limit : {Limit{0, 30}, {6, 14}})
  {
    SCOPED_TRACE(limit.anderson_depth);
    elastoplastic::Settings few = settings(limit.max_evaluations);
    few.anderson_depth = limit.anderson_depth;
    Press split(few);
    const int evaluations = split.go(most, 1.0 / 64);
    EXPECT_GT(evaluations, 2 * limit.max_evaluations); // what the whole increment may take
    EXPECT_EQ(split.stepper().split_increments(), 1);
    EXPECT_GT(split.pieces().size(), 1U);
    EXPECT_EQ(split.stepper().pair().approach(), most * alpha_c); // it went all the way
    EXPECT_FALSE(split.was_descended());                          // halving was enough
    expect_alike(split, in_pieces(split, most));

    // The next increment is not affected: it goes whole if it is short, as in the run without a limit.
    Press other = in_pieces(split, most);
    split.go(most - 0.1, 1.0 / 64);
    other.go(most - 0.1, 1.0);
    EXPECT_EQ(split.stepper().split_increments(), 1);
    expect_alike(split, other);
  }
}

TEST(StepperTest, APieceThatCannotBeHalvedIsSolvedByThePlainFixedPoint)
{
  // So few evaluations that no piece converges by them; with back stresses the plain fixed point has no energy to watch.
  const std::vector<constitutive::KinematicTerm> back_stress{{20e9, 50.0}};
  for (const auto& kinematic : {std::vector<constitutive::KinematicTerm>{}, back_stress})
  {
    SCOPED_TRACE(kinematic.size());
    constexpr int few = 3;
    Press split(settings(few), kinematic);
    const int evaluations = split.go(most, 1.0 / 4);
    // Each of the four pieces is tried, and then tried again the other way.
    EXPECT_EQ(split.tried(), (std::vector{1.0, 0.5, 0.25, 0.25, 0.5, 0.5, 1.0, 0.75, 0.75, 1.0, 1.0}));
    EXPECT_TRUE(split.was_descended());
    EXPECT_GT(evaluations, 7 * 2 * few); // of the tries
    EXPECT_EQ(split.stepper().split_increments(), 1);
    expect_alike(split, in_pieces(split, most, kinematic), kinematic.empty() ? 1e-5 : 1e-3);
  }
}

TEST(StepperTest, TheSplitPathErrsNoMoreThanTheWholeOne)
{
  // Pieces are shorter increments: what comes out lies nearer to the run with many of them than one increment does.
  const auto pressed = [](int steps, int max_evaluations)
  {
    Press press(settings(max_evaluations));
    for (int step = 1; step <= steps; ++step)
      press.go(most * step / steps, 1.0 / 64);
    return press.state().dissipation;
  };
  const double fine = pressed(64, 1000);
  const double whole = pressed(1, 1000);
  const double split = pressed(1, 14);
  EXPECT_NE(split, whole);
  EXPECT_LT(std::abs(split - fine), std::abs(whole - fine));
}

TEST(StepperTest, WhereNothingConvergesTheErrorSaysWhatWasReached)
{
  Press press(settings(1));
  try
  {
    press.go(most, 1.0 / 4);
    FAIL() << "20 evaluations were enough";
  }
  catch (const ConvergenceError& error)
  {
    EXPECT_NE(std::string(error.what()).find("the press: no convergence after"), std::string::npos) << error.what();
  }
}

} // namespace
} // namespace brinell::simulation::stepper_test
