// SPDX-License-Identifier: BSD-3-Clause
#include "record.hpp"
#include "tugging_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

/// Bodies of different size and material, several passes.
namespace brinell::verification::dissimilar_bodies_test
{
namespace
{

using simulation::TuggingCase;
using simulation::TuggingRecord;

TuggingCase swapped(TuggingCase t)
{
  std::swap(t.lower, t.upper);
  return t;
}

struct Pair
{
  const char* name;
  const char* label; ///< the same as an identifier
  simulation::ShapedBody lower, upper;
};

class DissimilarBodies : public testing::TestWithParam<Pair>
{
};

TEST_P(DissimilarBodies, SwappingThemMirrorsTheResult)
{
  TuggingCase t = small_case(4.0);
  t.lower = GetParam().lower;
  t.upper = GetParam().upper;
  const TuggingRun run = computed(t), mirror = computed(swapped(t));
  ASSERT_EQ(run.history.size(), mirror.history.size());
  const std::string pair = std::string(GetParam().name) + ": ";
  // The two runs are one problem seen from either side, cell by cell. What remains is the tolerance of the iteration:
  // 1e-4 of the yield stress in a cell, at most as much in a sum, added up over the steps.
  const auto same = [&](const char* what, double TuggingRecord::*a, double TuggingRecord::*b)
  { test::expect_close(pair + what, difference(run, a, mirror, b), 0.0, 1e-3, "exact: symmetry"); };
  same("F_X, swapped", &TuggingRecord::F_X, &TuggingRecord::F_X);
  same("F_Z, swapped", &TuggingRecord::F_Z, &TuggingRecord::F_Z);
  same("F_n, swapped", &TuggingRecord::F_n, &TuggingRecord::F_n);
  same("work, swapped", &TuggingRecord::work, &TuggingRecord::work);
  same("dissipation of the lower, swapped", &TuggingRecord::dissipation_lower, &TuggingRecord::dissipation_upper);
  same("dissipation of the upper, swapped", &TuggingRecord::dissipation_upper, &TuggingRecord::dissipation_lower);
  same("residual displacement of the lower, swapped", &TuggingRecord::max_residual_lower,
       &TuggingRecord::max_residual_upper);
  same("residual displacement of the upper, swapped", &TuggingRecord::max_residual_upper,
       &TuggingRecord::max_residual_lower);
  same("locked-in energy, swapped", &TuggingRecord::energy_residual, &TuggingRecord::energy_residual);
  // Coarse cells: the edge's error, first order in the cell at worst.
  test::expect_close(pair + "energy balance over the largest work", run.summary.energy_balance_error, 0.0,
                     slow_build ? 0.1 : 0.05, "exact: conservation of energy");
  for (const auto& [body, dissipation] :
       {std::pair{t.lower, run.summary.dissipation_lower}, std::pair{t.upper, run.summary.dissipation_upper}})
    EXPECT_EQ(dissipation > 0.0, body.material.is_plastic()) << pair;
}

const constitutive::Material soft{{70e9, 0.33}, constitutive::LinearHardening{0.6e9, 2e9}};
const constitutive::Material hard{{210e9, 0.28}, constitutive::PerfectPlasticity{0.65e9}};
const constitutive::Material ceramic{{310e9, 0.24}, {}};

INSTANTIATE_TEST_SUITE_P(
    Pairs, DissimilarBodies,
    testing::Values(
        Pair{"radii 0.8 m and 1.5 m", "UnequalRadii", {ball(0.8), perfect_material()}, {ball(1.5), perfect_material()}},
        Pair{"all different", "AllDifferent", {ball(0.7), soft}, {ball(1.3), hard}},
        Pair{"one elastic", "OneElastic", {ball(1.0), ceramic}, {ball(1.0), perfect_material()}}),
    [](const auto& parameter) { return std::string(parameter.param.label); });

TEST(OneElasticBody, TakesNothingAndTheOtherTakesAll)
{
  TuggingCase t = small_case(4.0);
  t.upper.material = elastic_material();
  const TuggingRun one = computed(t), both = computed(small_case(4.0));
  EXPECT_EQ(one.summary.dissipation_upper, 0.0);
  EXPECT_EQ(one.summary.max_residual_upper, 0.0);
  // One dent instead of two leaves more pressure, which makes that one deeper than either of the two.
  test::expect_within("residual displacement of the plastic body / that of two plastic ones",
                      one.summary.max_residual_lower / both.summary.max_residual_lower, 1.0, 2.0,
                      "bounds: one of two dents, and both in one");
  test::expect_within("peak F_Z / that of two plastic bodies", one.summary.peak_F_Z / both.summary.peak_F_Z, 1.0,
                      8.0 * critical().load / both.summary.peak_F_Z,
                      "bounds: two plastic bodies, and two elastic ones");
}

TEST(RepeatedPasses, LoseLessAndKeepTheWholeTrack)
{
  TuggingCase t = small_case(6.0);
  t.passes = slow_build ? 2 : 3;
  const TuggingRun run = computed(t);
  std::array<double, 3> work{}, dissipation{}, peak{};
  double work_before = 0.0, dissipation_before = 0.0;
  for (int pass = 0; pass < t.passes; ++pass)
  {
    const auto n = static_cast<std::size_t>(pass);
    const TuggingRecord* last = nullptr;
    for (const TuggingRecord& r : run.history)
      if (r.pass == pass + 1)
      {
        last = &r;
        peak[n] = std::max(peak[n], r.F_X);
      }
    ASSERT_NE(last, nullptr);
    const double lost = last->dissipation_lower + last->dissipation_upper;
    work[n] = last->work - work_before;
    dissipation[n] = lost - dissipation_before;
    work_before = last->work;
    dissipation_before = lost;
    EXPECT_EQ(last->F_n, 0.0); // parted before the next pass
  }
  // The track is already pressed into shape: less interference is left, and residual stress helps.
  for (std::size_t n = 1; n < static_cast<std::size_t>(t.passes); ++n)
  {
    const std::string name = "pass " + std::to_string(n + 1) + " / pass " + std::to_string(n) + ": ";
    test::expect_within(name + "dissipation", dissipation[n] / dissipation[n - 1], 0.0, 1.0, "bound: less");
    // What later passes lose is small beside the error of the energy balance, 3 % of the work of the first at this mesh.
    test::expect_within("pass " + std::to_string(n + 1) + " / pass 1: work", work[n] / work[0], -0.03, 1.0,
                        "bound: less");
    test::expect_within(name + "peak F_X", peak[n] / peak[n - 1], 0.0, 1.0, "bound: less");
  }
  // What the first steps did is still there, far behind the last contact: the track of each body at both its ends.
  const simulation::Snapshot& end = run.summary.final_state;
  for (const simulation::BodySnapshot* body : {&end.lower, &end.upper})
  {
    const SurfaceGrid& g = body->grid.surface;
    const auto depth_at = [&](double x)
    {
      const auto i = static_cast<int>(std::lround((x - body->x0) / g.dx));
      return body->residual_displacement[static_cast<std::size_t>(i + g.nx * ((g.ny - 1) / 2))];
    };
    const double deepest = *std::max_element(body->residual_displacement.begin(), body->residual_displacement.end());
    // Half-way between first touch and alignment the interference was three quarters of the largest: on both sides.
    const double half_way = 0.25 * run.plan.start_distance;
    const std::string name = body == &end.lower ? "lower: " : "upper: ";
    for (const double side : {-1.0, 1.0})
      test::expect_within(name + "depth of the track half-way " + (side < 0.0 ? "before" : "after") +
                              " alignment / deepest",
                          depth_at(side * half_way) / deepest, 0.05, 1.0, "bound: the track is kept");
  }
}

} // namespace
} // namespace brinell::verification::dissimilar_bodies_test
