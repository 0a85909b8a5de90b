// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/io/member_keys.hpp"
#include "tugging_runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

/// Two bodies that pass beside each other, against what is known of their centres in space.
namespace brinell::verification::offset_tugging_test
{
namespace
{

using simulation::Paraboloid;
using simulation::TuggingCase;
using simulation::TuggingRecord;

/// Hertz between two spheres whose centres are (X, y, omega) apart: the force along the line of centres, in space. It knows
/// nothing of a tilted plane of motion.
struct Spheres
{
  double R1, R2, interference, offset, modulus;

  [[nodiscard]] std::array<double, 3> force(double X) const
  {
    const double omega = R1 + R2 - interference;
    const double distance = std::sqrt(X * X + offset * offset + omega * omega);
    const double overlap = std::max(0.0, R1 + R2 - distance);
    const double load = 4.0 / 3.0 * modulus * std::sqrt(R1 * R2 / (R1 + R2)) * std::pow(overlap, 1.5);
    return {-load * X / distance, load * offset / distance, load * omega / distance};
  }
};

TuggingCase elastic_pair(double R1, double R2, double interference, double offset, double cells)
{
  TuggingCase t;
  t.lower = {Paraboloid{R1, R1}, elastic_material()};
  t.upper = {Paraboloid{R2, R2}, elastic_material()};
  t.interference = interference;
  t.offset = offset;
  const double a = simulation::plan(t).elastic_contact_radius;
  t.spacing = {{a / cells, a / cells, a}};
  return t;
}

TEST(OffsetTugging, ElasticForcesAreThoseOfTheSpheresInSpace)
{
  const double cells = slow_build ? 6.0 : 12.0;
  const double interference = 0.004, offset = 0.08; // of the interference 0.0027 is left along the line of centres
  const TuggingRun run = computed(elastic_pair(1.0, 1.5, interference, offset, cells));
  const Spheres exact{1.0, 1.5, interference, offset, contact_modulus(elastic, elastic)};
  std::array<double, 3> error{}, size{};
  for (const TuggingRecord& r : run.history)
  {
    const auto expected = exact.force(r.X);
    const std::array<double, 3> found{r.F_X, r.F_Y, r.F_Z};
    for (std::size_t i = 0; i < 3; ++i)
    {
      error[i] = std::max(error[i], std::abs(found[i] - expected[i]));
      size[i] = std::max(size[i], std::abs(expected[i]));
    }
    // The direction of the centres alone tells it.
    EXPECT_NEAR(r.F_Y, r.F_Z * offset / (2.5 - interference), 1e-12 * r.F_Z);
    EXPECT_NEAR(r.height, 2.5 - interference, 1e-12);
  }
  // The mesh error of an elastic contact: elastic_tugging_test.cpp.
  const double mesh = 0.25 * std::pow(cells, -1.5);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_LT(error[i] / size[i], mesh) << "component " << i;
  EXPECT_NEAR(run.summary.peak_F_Y, exact.force(0.0)[1], mesh * exact.force(0.0)[1]);
  EXPECT_NEAR(run.summary.work / run.summary.work_to_alignment, 0.0, 1e-3); // nothing is lost
}

TEST(OffsetTugging, EllipsoidsLoseTheHeightOfTheirSides)
{
  // Relative curvature 2 along and across, but 2 m of radii along and 2.667 m across.
  TuggingCase t;
  t.lower = {Paraboloid{1.0, 2.0 / 3.0}, elastic_material()};
  t.upper = {Paraboloid{1.0, 2.0}, elastic_material()};
  t.interference = 1e-3;
  t.offset = 0.04;
  const double left = t.interference - t.offset * t.offset / (2.0 * (2.0 / 3.0 + 2.0)); // 7e-4
  EXPECT_NEAR(simulation::plan(t).closest.interference, left, 1e-3 * left);             // second order in y/(R1 + R2)
  const double a = simulation::plan(t).elastic_contact_radius;
  const double cells = slow_build ? 6.0 : 12.0;
  t.spacing = {{a / cells, a / cells, a}};
  const TuggingRun run = computed(t);
  const double load = 4.0 / 3.0 * contact_modulus(elastic, elastic) * std::sqrt(0.5) * std::pow(left, 1.5);
  EXPECT_NEAR(run.aligned().F_n, load, (0.25 * std::pow(cells, -1.5) + 2e-3) * load);
}

TEST(OffsetTugging, MirrorsWithTheSignOfTheOffset)
{
  TuggingCase t = small_case(9.0);
  t.upper.shape = Paraboloid{1.4, 1.4};
  t.offset = 0.05;
  const TuggingRun left = computed(t);
  t.offset = -t.offset;
  const TuggingRun right = computed(t);
  ASSERT_EQ(left.history.size(), right.history.size());
  for (std::size_t i = 0; i < left.history.size(); ++i)
  {
    const TuggingRecord &a = left.history[i], &b = right.history[i];
    const double tiny = 1e-9 * left.summary.peak_F_Z;
    EXPECT_NEAR(a.F_Y, -b.F_Y, tiny);
    EXPECT_NEAR(a.F_X, b.F_X, tiny);
    EXPECT_NEAR(a.F_Z, b.F_Z, tiny);
  }
  EXPECT_GT(left.summary.peak_F_Y, 0.01 * left.summary.peak_F_Z);
}

TEST(OffsetTugging, YieldsByWhatIsLeftOfTheInterference)
{
  for (const double left : {0.97, 1.2}) // of that at first yield, by Hertz and Green
  {
    TuggingCase t = small_case(3.0);
    const double remaining = left * critical().interference, sum = 2.0;
    t.offset = std::sqrt((sum - remaining) * (sum - remaining) - (sum - t.interference) * (sum - t.interference));
    t.spacing.reset();
    const TuggingRun run = computed(t);
    EXPECT_NEAR(run.plan.closest.interference, remaining, 1e-12 * sum);
    EXPECT_EQ(run.summary.dissipation_lower > 0.0, left > 1.0) << left;
  }
}

TEST(OffsetTugging, ItsEnergyCloses)
{
  TuggingCase t = small_case(9.0);
  const auto imbalance = [](const TuggingRun& run)
  {
    const auto& s = run.summary;
    return std::abs(s.work - s.dissipation_lower - s.dissipation_upper - s.energy_residual) / s.work_to_alignment;
  };
  const TuggingRun straight = computed(t);
  t.offset = 0.04;
  const TuggingRun beside = computed(t);
  EXPECT_GT(beside.summary.work, 0.0);
  EXPECT_LT(beside.summary.work, straight.summary.work); // less overlap, less ploughing
  // Of either run that of the mesh: paper_tugging_test.cpp. Slow builds have 3 cells to a contact radius in place of 5.
  const double mesh = slow_build ? 0.06 : 0.03;
  EXPECT_LT(imbalance(beside), mesh);
  EXPECT_LT(imbalance(straight), mesh);
}

TEST(OffsetTugging, TexturesAreMetBesideTheTop)
{
  // A dent where the contact passes is, for spheres, the same dent on the top of an aligned pair with what overlap is left.
  for (const bool on_upper : {false, true})
  {
    TuggingCase t = small_case(9.0);
    t.upper.shape = Paraboloid{1.4, 1.4};
    t.offset = 0.05;
    t.solver.anderson_depth = 0; // the acceleration enlarges rounding, in which alone the two runs differ
    const simulation::ClosestApproach closest = simulation::closest_approach(t);
    EXPECT_NEAR(closest.y_lower, t.offset / 2.4, 2e-3 * closest.y_lower); // the arc is the offset's share, R1/(R1 + R2)
    EXPECT_NEAR(closest.y_upper, -t.offset * 1.4 / 2.4, -2e-3 * closest.y_upper);
    simulation::ShapedBody& body = on_upper ? t.upper : t.lower;
    const double edge = 0.02, depth = 5e-4;
    body.texture = simulation::Dent{0.0, on_upper ? closest.y_upper : closest.y_lower, depth, edge};
    const TuggingRun beside = computed(t);
    body.texture = simulation::Dent{0.0, 0.0, depth, edge};
    const TuggingRun far = computed(t);
    t.offset = 0.0;
    t.interference = closest.interference;
    const TuggingRun aligned = computed(t);
    EXPECT_NEAR(beside.summary.peak_F_X, aligned.summary.peak_F_X, 1e-9 * aligned.summary.peak_F_X);
    EXPECT_NEAR(beside.summary.peak_F_Z, aligned.summary.peak_F_Z * std::cos(closest.tilt),
                1e-9 * aligned.summary.peak_F_Z);
    EXPECT_GT(std::abs(far.summary.peak_F_Z / beside.summary.peak_F_Z - 1.0), 0.01); // the dent is felt at all
  }
}

std::string refusal(const TuggingCase& t)
{
  try
  {
    static_cast<void>(simulation::plan(t));
  }
  catch (const InputError& error)
  {
    return io::with_keys(error.what());
  }
  return "";
}

TEST(OffsetTugging, RefusesBodiesThatNeverTouch)
{
  TuggingCase t = equal_spheres(9.0, perfect_material());
  const double most = std::sqrt(t.interference * (4.0 - t.interference));
  t.offset = 0.999 * most;
  EXPECT_EQ(refusal(t), "");
  t.offset = -1.001 * most;
  EXPECT_NE(refusal(t).find("without touching"), std::string::npos) << refusal(t);
  t.offset = 0.01;
  t.lower.shape = simulation::Roller{1.0, 0.2};
  EXPECT_NE(refusal(t).find("lower.shape is not rounded across"), std::string::npos) << refusal(t);
}

} // namespace
} // namespace brinell::verification::offset_tugging_test
