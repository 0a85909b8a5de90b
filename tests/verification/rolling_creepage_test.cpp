// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/quality/quality.hpp"
#include "creeping_cylinder.hpp"
#include "order.hpp"
#include "record.hpp"
#include "scenario_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <omp.h>
#include <string>
#include <utility>
#include <vector>

/// The scenario rolling with creepage: closed forms and tables of elastic bodies, full sliding, balance of energy with plasticity.
namespace brinell::verification::rolling_creepage_test
{
namespace
{

using simulation::Creepage;
using simulation::RollingCase;
using simulation::RollingRecord;

constexpr double pi = std::numbers::pi;

TEST(RollingCreepage, CylindersFollowCarter)
{
  // Carter (1926; Johnson 1985, section 8.3): F = f P (1 - (1 - xi R/(f a))^2). Points move freely until they touch, which makes the
  // error one of second order.
  const double f = 0.3, share = 0.4, creepage = share * f * Cylinder::a / Cylinder::R;
  const double exact = f * Cylinder::load_per_length() * (1.0 - std::pow(1.0 - share, 2));
  std::vector<double> errors, sticks;
  for (const double cells : {8.0, 16.0, 32.0})
  {
    const RollingCase c = Cylinder::rolling(cells, f, creepage);
    const RollingRun run = computed(c);
    const RollingRecord& r = at_the_end(c, run);
    errors.push_back(r.F_x / exact - 1.0);
    sticks.push_back(r.stick_share);
    EXPECT_NEAR(r.F_y, 0.0, 1e-9 * exact);
    EXPECT_TRUE(run.summary.passes[0].creeps_steadily());
    // At rest there is no force; it grows on the way, and never above that of steady rolling by more than the tolerance.
    double before = 0.0;
    for (std::size_t i = 0; i + static_cast<std::size_t>(c.load_steps) < run.history.size(); ++i)
    {
      EXPECT_GE(run.history[i].F_x, before - 1e-4 * exact);
      before = run.history[i].F_x;
    }
  }
  EXPECT_GT(test::Orders("Carter, force at a creepage, cells halved", errors).last, 1.5);
  test::expect_close("cylinders that roll with creepage, 8 cells: force, share of the exact one", 1.0 + errors.front(),
                     1.0, 2e-3, "exact: Carter (1926)");
  test::expect_close("cylinders that roll with creepage, 32 cells: force, share of the exact one", 1.0 + errors.back(),
                     1.0, 2e-4, "exact: Carter (1926); second order");
  test::expect_close("the same: share of the contact that sticks", sticks.back(), 1.0 - share, 1.5 / 64,
                     "exact: Carter (1926); a cell of the contact at either end");
}

/// Two balls of 2 m that are alike, so that their contact is that of one of R = 1 m on a flat.
struct PairOfBalls
{
  static constexpr double R = 1.0, G = 80e9, a = 0.01, f = 0.3;
  double nu = 0.25;

  [[nodiscard]] double load_of_contact() const { return 4.0 / 3.0 * G / (1.0 - nu) * a * a * a / R; }
  /// Creepage from which on the linear force of Kalker would be above friction times load.
  [[nodiscard]] double saturation(double coefficient) const
  {
    return f * load_of_contact() / (G * a * a * coefficient);
  }
  [[nodiscard]] RollingCase rolling(double cells, const Creepage& creepage, double lengths) const
  {
    RollingCase c;
    c.lower = c.upper = {ball(2.0 * R), {{2.0 * (1.0 + nu) * G, nu}, {}}};
    c.drive = load(load_of_contact());
    c.friction.coefficient = f;
    c.creepage = creepage;
    c.distance = lengths * a;
    c.spacing = {{a / cells, a / cells, a}}; // nothing yields: layers mean nothing
    c.load_steps = 2;
    return c;
  }
};

TEST(RollingCreepage, BallsFollowKalker)
{
  // F_x = C11 G a^2 xi, F_y = C22 G a^2 eta + C23 G a^3 phi, M = -C23 G a^3 eta + .. of small creepages on a circle (Kalker 1967; Johnson 1985, table
  // 8.1), which has three digits. So little slips that the force is proportional.
  struct Row
  {
    double nu, C11, C22, C23;
  };
  for (const Row& row : {Row{0.0, 3.40, 3.40, 1.33}, Row{0.25, 4.12, 3.67, 1.47}, Row{0.5, 5.20, 3.98, 1.63}})
  {
    const PairOfBalls balls{row.nu};
    const double G = PairOfBalls::G, a = PairOfBalls::a;
    const double small = 1e-3 * balls.saturation(4.0);
    std::vector<double> along, across, turned, moments;
    for (const double cells : {8.0, 16.0, 32.0})
    {
      const auto end = [&](const Creepage& creepage)
      {
        const RollingCase c = balls.rolling(cells, creepage, 10.0);
        return at_the_end(c, computed(c));
      };
      along.push_back(end({small, 0.0, 0.0}).F_x / (G * a * a * small));
      const RollingRecord lateral = end({0.0, small, 0.0});
      across.push_back(lateral.F_y / (G * a * a * small));
      moments.push_back(lateral.M_z / (G * a * a * a * small));
      turned.push_back(end({0.0, 0.0, small / a}).F_y / (G * a * a * small));
      // Reciprocity, but for the trailing edge, where the shear without slip has no end and the moment its largest lever.
      EXPECT_NEAR(turned.back(), -moments.back(), 0.6 / cells * turned.back());
    }
    const auto limit = [](const std::vector<double>& values) { return 2.0 * values[2] - values[1]; };
    for (const auto& [found, table] : {std::pair{along[0], row.C11}, {across[0], row.C22}, {turned[0], row.C23}})
      EXPECT_NEAR(found / table, 1.0, 0.03) << "8 cells, nu = " << row.nu;
    std::printf("  nu %.2f  C11 %.3f %.3f %.3f  C22 %.3f %.3f %.3f  C23 %.3f %.3f %.3f  C32 %.3f %.3f %.3f\n", row.nu,
                along[0], along[1], along[2], across[0], across[1], across[2], turned[0], turned[1], turned[2],
                moments[0], moments[1], moments[2]);
    const std::string of = ", nu = " + std::to_string(row.nu).substr(0, 4);
    test::expect_close("balls that roll with creepage: C11" + of, limit(along), row.C11, 0.02 * row.C11,
                       "table: Kalker (1967)");
    test::expect_close("balls that roll with creepage: C22" + of, limit(across), row.C22, 0.02 * row.C22,
                       "table: Kalker (1967)");
    test::expect_close("balls that roll with spin: C23" + of, std::abs(limit(turned)), row.C23, 0.02 * row.C23,
                       "table: Kalker (1967)");
    test::expect_close("balls that roll with creepage: C32" + of, std::abs(limit(moments)), row.C23, 0.02 * row.C23,
                       "table: Kalker (1967)");
  }
}

// Without slip the shear has no end at the trailing edge, where its moment has the longest lever: the error is that of the place of the
// edge between two cells, of either sign.
TEST(RollingCreepage, AMomentScattersWithTheEdge)
{
  constexpr double C32 = 1.47; // nu = 1/4 (Kalker 1967)
  const PairOfBalls balls{0.25};
  const double small = 1e-3 * balls.saturation(4.0), a = PairOfBalls::a;
  double sum = 0.0, largest = 0.0;
  const std::vector<double> meshes{7.0, 7.5, 8.0, 8.5, 9.0, 9.5, 10.0};
  for (const double cells : meshes)
  {
    const RollingCase c = balls.rolling(cells, {0.0, small, 0.0}, 10.0);
    const double error = -at_the_end(c, computed(c)).M_z / (PairOfBalls::G * a * a * a * small) / C32 - 1.0;
    sum += error;
    largest = std::max(largest, std::abs(error));
  }
  test::expect_close("moment of a lateral creepage: C32 over the table's, mean of 7 to 10 cells",
                     1.0 + sum / static_cast<double>(meshes.size()), 1.0, 0.03, "table: Kalker (1967)");
  test::expect_close("moment of a lateral creepage: C32, largest error with 7 to 10 cells", largest, 0.0, 0.5 / 7.0,
                     "half a cell at the trailing edge");
}

TEST(RollingCreepage, StickShareIsWithinItsExpectedError)
{
  for (const double share : {0.1, 0.3, 0.6}) // of the creepage from which on all slips
  {
    std::vector<double> sticks;
    double stated = 0.0;
    for (const double cells : {8.0, 24.0})
    {
      const PairOfBalls balls;
      const RollingCase c = balls.rolling(cells, {3.0 * share * balls.saturation(4.12), 0.0, 0.0}, 8.0);
      const RollingRun run = computed(c);
      sticks.push_back(run.summary.passes[0].stick_share);
      for (const quality::ExpectedError& e :
           quality::judged(c, simulation::plan(c), run.summary).resolution.expected_errors)
        if (e.quantity == "stick share" && cells == 8.0)
          stated = e.relative;
    }
    std::printf("  share of saturation %.1f: sticks %.4f, %.4f, stated %.3f\n", share, sticks[0], sticks[1], stated);
    EXPECT_NEAR(sticks[0], sticks[1], 0.02) << share;
    EXPECT_LE(std::abs(sticks[0] / sticks[1] - 1.0), stated) << share;
  }
}

TEST(RollingCreepage, LargeCreepageFollowsCoulomb)
{
  // All slips: friction times load against the slip, to the angle by which displacements across the creepage turn it.
  const PairOfBalls balls;
  const double full = 3.0 * balls.saturation(4.12);
  for (const Creepage& creepage : {Creepage{2.0 * full, 0.0, 0.0}, Creepage{1.6 * full, -1.2 * full, 0.0}})
  {
    const RollingCase c = balls.rolling(16.0, creepage, 6.0);
    const RollingRun run = computed(c);
    const RollingRecord& r = at_the_end(c, run);
    const double limit = PairOfBalls::f * balls.load_of_contact();
    const double size = std::hypot(creepage.longitudinal, creepage.lateral);
    EXPECT_EQ(r.stick_share, 0.0);
    const bool is_along = creepage.lateral == 0.0;
    test::expect_close(is_along ? "balls, large creepage along: force over friction times load"
                                : "balls, large creepage at an angle: force along it over friction times load",
                       (r.F_x * creepage.longitudinal + r.F_y * creepage.lateral) / (size * limit), 1.0, 1e-3,
                       "exact: Coulomb; the slip turns by some hundredths");
  }
}

TEST(RollingCreepage, ForcesFollowVermeulenAndJohnson)
{
  // F/(f P) = 1 - (1 - t)^3 with t = C G a^2 xi/(3 f P): Vermeulen and Johnson (1964) with the coefficients of Kalker. It takes
  // an ellipse of stick that touches the leading edge, which does not satisfy the condition of slip between that edge and the ellipse;
  // beside the exact theory it is known to be good to some percent (Kalker 1990, section 2.2.4).
  const PairOfBalls balls;
  const double full = 3.0 * balls.saturation(4.12), limit = PairOfBalls::f * balls.load_of_contact();
  double worst = 0.0, before = 0.0;
  for (const double t : {0.2, 0.4, 0.6, 0.8, 1.0})
  {
    const RollingCase c = balls.rolling(16.0, {t * full, 0.0, 0.0}, 10.0);
    const RollingRun run = computed(c);
    const RollingRecord& r = at_the_end(c, run);
    const double share = r.F_x / limit, approximate = 1.0 - std::pow(1.0 - t, 3);
    std::printf("  t %.1f  F/(f P) %.4f, Vermeulen and Johnson %.4f, sticks %.3f\n", t, share, approximate,
                r.stick_share);
    EXPECT_GT(share, before);
    before = share;
    worst = std::max(worst, std::abs(share - approximate));
  }
  test::expect_within("balls, force over friction times load: farthest from Vermeulen and Johnson's", worst, 0.0, 0.05,
                      "Vermeulen and Johnson (1964), approximate");
}

/// A ball rolls over a flat, and both yield: p0/k = 4.
RollingCase yielding(double cells, const Creepage& creepage, bool are_alike)
{
  RollingCase c = ball_on_flat(track_steel(20e9), 4e9, 1e-3);
  c.upper.material = c.lower.material;
  if (!are_alike)
  {
    c.upper.material.elastic.young_modulus *= 2.0;
    c.upper.material.hardening = constitutive::LinearHardening{2.2e9, 30e9};
    c.drive = ball_on_flat(track_steel(20e9), 4.4e9, 1e-3).drive;
  }
  c.creepage = Creepage{0.0, 0.0, 1e-3};
  c.resolution = cells;
  c.friction.coefficient = 0.3;
  c.creepage = creepage;
  c.load_steps = 6;
  c.distance = 3.0 * simulation::plan(c).half_width_x;
  return c;
}

TEST(RollingCreepage, EnergyClosesWithPlasticity)
{
  for (const bool are_alike : {true, false})
  {
    RollingCase c = yielding(slow_build ? 5.0 : (are_alike ? 16.0 : 8.0), {0.004, 0.002, 4.0}, are_alike);
    c.distance *= 0.5; // both bodies are solved on many cells
    const RollingRun run = computed(c);
    const std::string name = are_alike ? "equal bodies, 16 cells" : "unlike bodies, 8 cells";
    test::expect_close("error of the energy balance, rolling with creepage and spin of " + name,
                       run.summary.energy_balance_error, 0.0, 5e-3, "bound: mesh and steps");
    EXPECT_GT(run.summary.dissipation_lower, 0.0);
    EXPECT_GT(run.summary.dissipation_upper, 0.0);
    EXPECT_GT(run.summary.dissipation_friction, 0.0);
    EXPECT_EQ(run.summary.split_increments, 0);
  }
}

TEST(RollingCreepage, ElasticWorkIsHeat)
{
  // Nothing is left in the end. Pressure, shear and heat work by trapezoidal rules over cells rolled and load steps, as many as there
  // are cells: all of second order.
  std::vector<double> errors;
  for (const double cells : {4.0, 8.0, 16.0, 32.0})
  {
    RollingCase c = yielding(cells, {0.004, 0.002, 4.0}, true);
    for (auto* body : {&c.lower, &c.upper})
      body->material.hardening.reset();
    c.load_steps = static_cast<int>(cells);
    const simulation::RollingSummary s = computed(c).summary;
    errors.push_back(s.dissipation_friction / s.work - 1.0);
  }
  // Slip at the bound is of second order; points that begin to slip or leave the contact within a step are of the order 3/2, as
  // the pressure falls with the root of the distance from the edge.
  EXPECT_GT(test::Orders("elastic rolling with creepage: heat over work", errors).last, 1.5);
  test::expect_close("elastic rolling with creepage and spin, 32 cells: heat over work", 1.0 + errors.back(), 1.0, 2e-3,
                     "exact: all of it; of the order 3/2 from 0.7 % with 8 cells");
}

TEST(RollingCreepage, HeatOfSteadyRollingIsTheWorkOfTheCreepForce)
{
  // Steady elastic rolling stores nothing: the heat per distance is the creepage times the force. With little creepage all slip is
  // at the trailing edge, where the bound of the shear falls to a small part of itself within a step.
  const PairOfBalls balls;
  for (const double share : {0.003, 0.03, 0.3, 1.5})
  {
    const double creepage = share * balls.saturation(4.12);
    std::vector<double> errors;
    for (const double cells : {8.0, 16.0})
    {
      const RollingCase c = balls.rolling(cells, {creepage, 0.0, 0.0}, 8.0);
      const RollingRun run = computed(c);
      const RollingRecord& end = at_the_end(c, run);
      const RollingRecord& before = *(&end - static_cast<std::ptrdiff_t>(cells));
      const double heat = end.dissipation_friction - before.dissipation_friction;
      const double work = creepage * (end.x - before.x) * 0.5 * (end.F_x + before.F_x);
      errors.push_back(heat / work - 1.0);
    }
    std::printf("  creepage %.3f of saturation: heat over work of the force %+.2f %%, %+.2f %%\n", share,
                100.0 * errors[0], 100.0 * errors[1]);
    test::expect_close("balls that roll with a creepage of " + std::to_string(share).substr(0, 5) +
                           " of saturation, 16 cells: heat per distance over creepage times force",
                       1.0 + errors[1], 1.0, 0.03,
                       "exact: all of the work is heat; of second order in the slip of a step");
  }
}

/// Heat of friction in the second half of the track [J]: surfaces that may stick slip only after some way, which their elastic
/// displacement takes up, while in full sliding this way counts.
double heat_of_second_half(const RollingRun& run)
{
  const auto rolled_to = [&](double x)
  { return std::find_if(run.history.begin(), run.history.end(), [&](const RollingRecord& r) { return r.x >= x; }); };
  const double end = run.history.back().x;
  return rolled_to(end)->dissipation_friction - rolled_to(0.5 * (end + run.history.front().x))->dissipation_friction;
}

TEST(RollingCreepage, WhereAllSlipsItIsFullSliding)
{
  // The same bodies by slide_to_roll: each is carried past the contact by its own way then, and here both by the same cells. So the
  // difference is of first order in the creepage.
  std::vector<double> forces, ruts, heats;
  for (const double creepage : {0.08, 0.04})
  {
    RollingCase c = yielding(6.0, {creepage, 0.0, 0.0}, true);
    c.friction.coefficient = 0.1;
    const RollingRun creeping = computed(c);
    EXPECT_EQ(at_the_end(c, creeping).stick_share, 0.0);
    c.creepage.reset();
    c.slide_to_roll = creepage;
    const RollingRun sliding = computed(c);
    forces.push_back(at_the_end(c, creeping).F_friction / at_the_end(c, sliding).F_friction - 1.0);
    ruts.push_back(creeping.summary.passes[0].rut_depth / sliding.summary.passes[0].rut_depth - 1.0);
    heats.push_back(heat_of_second_half(creeping) / heat_of_second_half(sliding) - 1.0);
    std::printf("  creepage %.2f: force %.2e, rut %.2e, heat %.2e\n", creepage, forces.back(), ruts.back(),
                heats.back());
  }
  test::expect_close("creepage of 4 % that slips everywhere: force over that of full sliding", 1.0 + forces.back(), 1.0,
                     1e-3, "the same contact, but for the angle of the slip");
  test::expect_close("the same, rut", 1.0 + ruts.back(), 1.0, 0.04, "bound: of first order in the creepage");
  // Full sliding counts the slip per way on the lower body, creepage per mean way of both, and more of that kind.
  test::expect_close("the same, heat, from creepages of 8 and 4 % to none", 1.0 + 2.0 * heats[1] - heats[0], 1.0, 5e-3,
                     "exact: the difference is of first order in the creepage");
}

TEST(RollingCreepage, SwappingTheBodiesMirrorsTheResult)
{
  // Seen from the upper body the lower one creeps the other way, and carries the opposite shear.
  RollingCase c = yielding(4.0, {0.004, 0.002, 0.0}, false);
  const RollingRun one = computed(c);
  std::swap(c.lower, c.upper);
  c.creepage = Creepage{-0.004, -0.002, 0.0};
  const RollingRun other = computed(c);
  const double limit = c.friction.coefficient * c.drive.value;
  double largest = 0.0;
  ASSERT_EQ(one.history.size(), other.history.size());
  for (std::size_t i = 0; i < one.history.size(); ++i)
    largest = std::max(
        largest,
        std::hypot(one.history[i].F_x + other.history[i].F_x, one.history[i].F_y + other.history[i].F_y) / limit);
  test::expect_close("swapped bodies: largest change of the force along the surface, over friction times load", largest,
                     0.0, 1e-3, "exact: the tolerance of the yield condition, 1e-4, over some steps");
  test::expect_close("swapped bodies: heat", other.summary.dissipation_friction / one.summary.dissipation_friction, 1.0,
                     1e-3, "exact");
}

TEST(RollingCreepage, ThreadsChangeNothing)
{
  const RollingCase c = yielding(4.0, {0.004, 0.002, 4.0}, false);
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const RollingRun one = computed(c);
  omp_set_num_threads(3);
  const RollingRun three = computed(c);
  omp_set_num_threads(before);
  ASSERT_EQ(one.history.size(), three.history.size());
  for (std::size_t i = 0; i < one.history.size(); ++i)
  {
    EXPECT_EQ(one.history[i].F_x, three.history[i].F_x);
    EXPECT_EQ(one.history[i].M_z, three.history[i].M_z);
    EXPECT_EQ(one.history[i].dissipation_friction, three.history[i].dissipation_friction);
  }
}

} // namespace
} // namespace brinell::verification::rolling_creepage_test
