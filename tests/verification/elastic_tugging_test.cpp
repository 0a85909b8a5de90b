// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/reference/elastic_tugging.hpp"

#include "order.hpp"
#include "record.hpp"
#include "tugging_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

/// Two spheres that stay elastic give back all the work that went in, along the closed form of Hertz' theory.
namespace brinell::verification::elastic_tugging_test
{
namespace
{

constexpr const char* origin = "exact: Hertz along the passage of two spheres";

/// Square cells, `cells` of them per contact radius at alignment. Nothing happens in depth: one coarse layer or two.
TuggingRun elastic_run(double interference_ratio, double cells)
{
  simulation::TuggingCase t = equal_spheres(interference_ratio, elastic_material());
  const double a = simulation::plan(t).elastic_contact_radius;
  t.spacing = {{a / cells, a / cells, a}};
  return computed(t);
}

reference::ElasticTugging closed_form(double interference_ratio)
{
  return {1.0, 1.0, contact_modulus(elastic, elastic), interference_ratio * critical().interference};
}

/// Largest error of a force over the pass, over its largest value.
template <typename Force>
double largest_error(const TuggingRun& run, const reference::ElasticTugging& exact, Force force)
{
  double error = 0.0, size = 0.0;
  for (const simulation::TuggingRecord& r : run.history)
  {
    const auto [computed_force, exact_force] = force(r, reference::elastic_tugging_forces(exact, r.X));
    error = std::max(error, std::abs(computed_force - exact_force));
    size = std::max(size, std::abs(exact_force));
  }
  return error / size;
}

double error_of_F_X(const TuggingRun& run, const reference::ElasticTugging& exact)
{
  return largest_error(run, exact, [](const auto& r, const auto& e) { return std::pair{r.F_X, e.F_X}; });
}

double error_of_F_Z(const TuggingRun& run, const reference::ElasticTugging& exact)
{
  return largest_error(run, exact, [](const auto& r, const auto& e) { return std::pair{r.F_Z, e.F_Z}; });
}

struct Row
{
  double interference, first_touch, peak, at, normal, work;
};

class ElasticTuggingTable : public testing::TestWithParam<Row>
{
};

TEST_P(ElasticTuggingTable, FollowsTheClosedForm)
{
  const Row& row = GetParam();
  const double cells = slow_build ? 8.0 : 16.0;
  const TuggingRun run = elastic_run(row.interference, cells);
  const reference::ElasticTugging exact = closed_form(row.interference);
  const reference::CriticalValues c = critical();
  const auto name = [&](const char* what) { return labelled(row.interference, what); };
  // A circle of n cells radius, filled with constant pressures, misses the load by (dx/a)^1.5 times a factor well
  // below one (the pressure falls to zero like a square root at the edge; ErrorFallsWithTheGrid).
  const double mesh = 0.25 * std::pow(cells, -1.5);
  test::expect_close(name("error of F_X along the pass / peak F_X"), error_of_F_X(run, exact), 0.0, mesh, origin);
  test::expect_close(name("error of F_Z along the pass / peak F_Z"), error_of_F_Z(run, exact), 0.0, mesh, origin);
  test::expect_close(name("F_Z / P_c at X = 0"), run.summary.F_Z_aligned / c.load, row.normal, mesh * row.normal,
                     origin);
  test::expect_close(name("start distance d0 / omega"),
                     run.plan.start_distance / (2.0 - row.interference * c.interference), row.first_touch, 0.5e-5,
                     origin); // digits of the table

  // Peak between the steps: the parabola through the three largest values. Its third-order remainder over a step h is
  // F''' h^3/27 at most, and F''' ~ 6 peak/|X_peak|^3 for a curve of this width.
  const auto top = std::max_element(run.history.begin(), run.history.end(),
                                    [](const auto& a, const auto& b) { return a.F_X < b.F_X; });
  ASSERT_GT(top - run.history.begin(), 0);
  const double before = std::prev(top)->F_X, at = top->F_X, after = std::next(top)->F_X;
  const double h = 0.5 * (std::next(top)->X - std::prev(top)->X);
  const double offset = 0.5 * (before - after) / (before - 2.0 * at + after);
  const double peak = at - 0.25 * (before - after) * offset;
  const double step_share = std::pow(h / std::abs(0.5 * row.at), 3.0) * 6.0 / 27.0;
  test::expect_close(name("peak F_X / P_c"), peak / c.load, row.peak, (mesh + step_share) * row.peak + 0.5e-5, origin);
  // The top is flat: an error e of the force moves it by e/F'' per unit of e's slope over a step, F'' ~ 2 peak/X_peak^2.
  const double shift = std::abs(row.at) * (mesh * std::abs(0.5 * row.at) / h + step_share);
  test::expect_close(name("X / R of the peak"), (top->X + offset * h) / 0.5, row.at, shift, origin);
  // Trapezoidal rule with n steps on a force that starts like a power 1.5 and ends with a slope: 1/(2 n^2) of the whole.
  const double n = 0.5 * run.plan.steps_per_pass;
  test::expect_close(name("work to alignment / U_c"), run.summary.work_to_alignment / c.energy, row.work,
                     (mesh + 0.5 / (n * n)) * row.work, origin);
  // Antisymmetric steps: only the tolerance of the contact solver is left.
  test::expect_close(name("net work / work to alignment"), run.summary.work / run.summary.work_to_alignment, 0.0, 1e-3,
                     "exact: nothing is lost");
  test::expect_close(name("F_X / F_Z at X = 0"), run.summary.load_ratio_aligned, 0.0, 1e-12, "exact: symmetry");
  EXPECT_EQ(run.summary.dissipation_lower + run.summary.dissipation_upper, 0.0);
  EXPECT_EQ(run.summary.energy_residual, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Interferences, ElasticTuggingTable,
                         testing::Values(Row{1.0, 0.01488, 0.00483, -0.02976, 1.000, 1.000},
                                         Row{4.0, 0.02977, 0.07733, -0.05951, 8.000, 32.00},
                                         Row{9.0, 0.04467, 0.39156, -0.08923, 27.000, 243.0},
                                         Row{15.0, 0.05770, 1.08790, -0.11516, 58.095, 871.4}),
                         [](const auto& row) { return "Alpha" + std::to_string(std::lround(row.param.interference)); });

TEST(ElasticTugging, ErrorFallsWithTheGrid)
{
  const reference::ElasticTugging exact = closed_form(9.0);
  std::vector<double> tangential, normal, work;
  for (const double cells : slow_build ? std::vector{4.0, 8.0} : std::vector{4.0, 8.0, 16.0})
  {
    const TuggingRun run = elastic_run(9.0, cells);
    tangential.push_back(error_of_F_X(run, exact));
    normal.push_back(error_of_F_Z(run, exact));
    work.push_back(run.summary.work_to_alignment / critical().energy / 243.0 - 1.0);
  }
  // Square-root edge: order 1.5 for the load, with jumps as the edge passes cells. The work adds a second-order step.
  test::expect_within("order of F_X in dx", test::Orders("F_X", tangential).overall, 1.2, 2.5, "theory: 1.5");
  test::expect_within("order of F_Z in dx", test::Orders("F_Z", normal).overall, 1.2, 2.5, "theory: 1.5");
  test::expect_within("order of the work to alignment in dx", test::Orders("work", work).overall, 1.2, 2.5,
                      "theory: 1.5 to 2");
}

TEST(ElasticTugging, PaperKinematicsComeBackToZeroWork)
{
  simulation::TuggingCase t = equal_spheres(9.0, elastic_material());
  const double a = simulation::plan(t).elastic_contact_radius;
  t.spacing = {{a / 16.0, a / 16.0, a}};
  t.kinematics = simulation::Kinematics::paper;
  const TuggingRun run = computed(t);
  // The steps are not symmetric about alignment, but the force at each X is the closed form's: what is left is the
  // trapezoidal rule at the two ends, where the force starts like a power 1.5, and the mesh.
  test::expect_close("net work / work to alignment", run.summary.work / run.summary.work_to_alignment, 0.0, 1e-3,
                     "exact: nothing is lost");
  test::expect_close("error of F_X along the pass / peak F_X", error_of_F_X(run, closed_form(9.0)), 0.0,
                     0.25 * std::pow(16.0, -1.5), origin);
}

} // namespace
} // namespace brinell::verification::elastic_tugging_test
