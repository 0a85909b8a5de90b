// SPDX-License-Identifier: BSD-3-Clause
#include "record.hpp"
#include "tugging_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

/// What Boucly, Nelias & Green (2006, Part II) say of two elastic-perfectly plastic spheres, at their mesh.
namespace brinell::verification::paper_tugging_test
{
namespace
{

constexpr const char* paper = "literature: Boucly, Nelias & Green (2006)";

/// The paper's interferences; without the two expensive ones in slow builds.
std::vector<double> interferences()
{
  return slow_build ? std::vector{1.0, 2.0} : std::vector{1.0, 2.0, 4.0, 6.0, 9.0};
}

/// Largest difference of a force at X and -X, with a sign, over the largest force: exact kinematics has both.
double asymmetry(const TuggingRun& run, double simulation::TuggingRecord::*force, double sign)
{
  double difference = 0.0, largest = 0.0;
  for (const simulation::TuggingRecord& a : run.history)
    for (const simulation::TuggingRecord& b : run.history)
      if (std::abs(a.X + b.X) < 1e-9)
      {
        difference = std::max(difference, std::abs(a.*force - sign * b.*force));
        largest = std::max(largest, std::abs(a.*force));
      }
  return difference / largest;
}

TEST(PaperTugging, DefaultMeshIsRightToOnePercent)
{
  // Nothing is said about the grid. Limits of fine meshes: docs/verification/accuracy.md (convergence); of the peak of F_Z
  // the value at 16 cells, which meshes from 12 on have to 0.1 %.
  if (slow_build)
    GTEST_SKIP() << "needs the default mesh: too slow in this build";
  simulation::TuggingCase t;
  t.lower = {ball(1.0), perfect_material()};
  t.upper = t.lower;
  t.interference = 9.0 * critical().interference;
  const simulation::TuggingSummary s = simulation::run(t);
  const auto check = [](const std::string& what, double value, double limit, double share)
  { test::expect_close("default mesh: " + what, value / limit, 1.0, share, "recorded: limit of refined meshes"); };
  check("peak F_X", s.peak_F_X / critical().load, 0.3493, 0.01);
  check("min F_X", s.min_F_X / critical().load, -0.1330, 0.015);
  check("peak F_Z", s.peak_F_Z / critical().load, 20.17, 0.01);
  check("F_Z at X = 0", s.F_Z_aligned / critical().load, 19.974, 0.01);
  check("largest residual displacement", s.max_residual_lower / critical().interference, 2.350, 0.01);
  check("net work", s.work / critical().energy, 190.2, 0.02);
  check("F_X at X = 0", s.F_X_aligned / critical().load, 0.1380, 0.02);
}

TEST(PaperTugging, AtFirstYieldTheForcesAreThoseOfElasticSpheres)
{
  const TuggingRun& run = paper_run(1.0);
  const double peak = run.summary.peak_F_X;
  // This mesh has less than three cells per contact radius here (a_c = 10.5 mm, dx = 3.85, dy = 7.7 mm) and sees single
  // cells yield a little early: plastic strain of 1e-4, a share of 1e-3 of the work.
  test::expect_close("F_X at X = 0 over its peak", run.summary.F_X_aligned / peak, 0.0, 1e-3, paper);
  test::expect_close("asymmetry of F_X", asymmetry(run, &simulation::TuggingRecord::F_X, -1.0), 0.0, 2e-3, paper);
  test::expect_close("asymmetry of F_Z", asymmetry(run, &simulation::TuggingRecord::F_Z, 1.0), 0.0, 2e-3, paper);
  test::expect_close("net work / work to alignment", run.summary.work / run.summary.work_to_alignment, 0.0, 2e-3,
                     paper);
  // (dx dy)^(1/2) = 0.52 a_c: the edge's error, (0.52)^1.5 / 4.
  test::expect_close("F_Z / P_c at X = 0", run.summary.F_Z_aligned / critical().load, 1.0, 0.09, "exact: Hertz");
}

TEST(PaperTugging, ResistanceAtAlignmentGrowsWithTheInterference)
{
  double before = 0.0, ratio_before = 0.0;
  for (const double alpha : interferences())
  {
    const TuggingRun& run = paper_run(alpha);
    const double force = run.summary.F_X_aligned / critical().load;
    test::expect_within(labelled(alpha, "F_X / P_c at X = 0"), force, alpha > 1.0 ? std::nextafter(before, 1e9) : -1e-6,
                        1e9, std::string(paper) + ": grows with the interference");
    test::expect_within(labelled(alpha, "F_X / F_Z at X = 0"), run.summary.load_ratio_aligned,
                        alpha > 1.0 ? std::nextafter(ratio_before, 1e9) : -1e-6, 1e9,
                        std::string(paper) + ": grows with the interference");
    before = force;
    ratio_before = run.summary.load_ratio_aligned;
  }
}

TEST(PaperTugging, MoreEnergyGoesInThanComesBack)
{
  double before = 0.0;
  for (const double alpha : interferences())
  {
    const TuggingRun& run = paper_run(alpha);
    const double net = run.summary.work / critical().energy;
    const double lost = run.summary.work / run.summary.work_to_alignment;
    test::expect_within(labelled(alpha, "net work / U_c"), net, std::nextafter(before, 1e9), 1e9,
                        std::string(paper) + ": grows with the interference");
    test::expect_within(labelled(alpha, "net work / work to alignment"), lost, 0.0, 1.0, std::string(paper));
    before = net;
  }
  if (!slow_build)
  {
    // "Most of the energy is produced during loading, just a small part is released during unloading."
    const TuggingRun& run = paper_run(9.0);
    test::expect_within("alpha* = 9: share of the work to alignment that comes back",
                        1.0 - run.summary.work / run.summary.work_to_alignment, 0.0, 0.5, paper);
  }
}

TEST(PaperTugging, NormalForceLeansSlightlyForward)
{
  for (const double alpha : interferences())
  {
    const TuggingRun& run = paper_run(alpha);
    const double normal = asymmetry(run, &simulation::TuggingRecord::F_Z, 1.0);
    const double tangential = asymmetry(run, &simulation::TuggingRecord::F_X, -1.0);
    test::expect_within(labelled(alpha, "asymmetry of F_Z"), normal, 0.0, 1.0, paper);
    if (alpha < 2.0)
      continue;
    EXPECT_GT(normal, 0.0);
    test::expect_within(labelled(alpha, "asymmetry of F_Z over that of F_X"), normal / tangential, 0.0, 1.0,
                        std::string(paper) + ": less pronounced than for the tangential force");
    // Loading is the harder half.
    double first = 0.0, second = 0.0;
    for (const simulation::TuggingRecord& r : run.history)
      (r.X < -1e-9 ? first : r.X > 1e-9 ? second : first) += std::abs(r.X) > 1e-9 ? r.F_Z : 0.0;
    EXPECT_GT(first, second) << alpha;
  }
}

TEST(PaperTugging, LoadRatioTendsToTheSlopeOfTheLastContact)
{
  if (slow_build)
    GTEST_SKIP() << "the largest interference is too expensive in this build";
  // The paper reads 0.045 off its Fig. 14, which is tan(theta0) = 0.0447 of rigid spheres at alpha* = 9; the slope of the
  // pile-up on the last contact takes a little off. 10 %: a figure read to half of its last digit.
  const TuggingRun& run = paper_run(9.0);
  test::expect_close("alpha* = 9: F_X / F_Z at the end of contact", run.summary.load_ratio_end, -0.045, 0.0045, paper);
}

TEST(PaperTugging, LargestPermanentDisplacementIsAQuarterOfTheInterference)
{
  double before = 0.0;
  for (const double alpha : interferences())
  {
    const TuggingRun& run = paper_run(alpha);
    const double share = run.summary.max_residual_lower / (alpha * critical().interference);
    test::expect_within(labelled(alpha, "largest residual displacement / interference"), share,
                        std::nextafter(before, 1.0), 0.275, std::string(paper) + ": up to 25 %, growing");
    before = share;
  }
  if (!slow_build)
    // Two digits in the paper, and a shift step and mesh that are not converged in either computation: 10 % of it.
    test::expect_close("alpha* = 9: largest residual displacement / interference", before, 0.25, 0.025, paper);
}

TEST(PaperTugging, WorkIsDissipationPlusLockedInEnergy)
{
  for (const double alpha : interferences())
    test::expect_close(labelled(alpha, "energy balance over the largest work"),
                       paper_run(alpha).summary.energy_balance_error, 0.0, 0.03,
                       "exact: conservation of energy; 3 % allowed on this mesh");
}

TEST(PaperTugging, EnergyBalanceClosesWithTheMesh)
{
  if (slow_build)
    GTEST_SKIP() << "the largest interference is too expensive in this build";
  // All cells and the shift together: twice and four thirds of the paper's, and the paper's. The slope of the residual
  // surface is a central difference, the trapezoidal work and the step are second order, the contact's edge 1.5.
  std::vector<double> errors;
  for (const double coarsening : {2.0, 4.0 / 3.0, 1.0})
  {
    const double error = coarsening == 1.0 ? paper_run(9.0).summary.energy_balance_error
                                           : computed(paper_case(9.0, coarsening)).summary.energy_balance_error;
    errors.push_back(error);
    test::expect_close("alpha* = 9: energy balance over the largest work, cells of " +
                           std::to_string(coarsening).substr(0, 4) + " of the paper's",
                       error, 0.0, 0.03 * coarsening, "exact: conservation of energy");
  }
  test::expect_within("order of the energy balance in the cells", std::log2(std::abs(errors.front() / errors.back())),
                      1.0, 3.0, "theory: 1.5 to 2");
}

TEST(PaperTugging, EqualBodiesEndAlike)
{
  simulation::TuggingCase t = paper_case(slow_build ? 2.0 : 4.0);
  t.solver.mirror = false;
  const TuggingRun run = computed(t);
  const simulation::TuggingSummary& s = run.summary;
  // Both are computed separately, to the tolerance of the iteration: 1e-4 of the yield stress, 1e-5 alpha_c.
  test::expect_close("dissipation, upper / lower", s.dissipation_upper / s.dissipation_lower, 1.0, 1e-4,
                     "exact: symmetry");
  test::expect_close("largest residual displacement, upper / lower", s.max_residual_upper / s.max_residual_lower, 1.0,
                     1e-4, "exact: symmetry");
  double sideways = 0.0;
  for (const simulation::TuggingRecord& r : run.history)
    sideways = std::max(sideways, std::abs(r.F_Y));
  test::expect_close("largest F_Y over the largest F_Z", sideways / s.peak_F_Z, 0.0, 1e-9, "exact: symmetry");
}

TEST(PaperTugging, BothKinematicsGiveTheSameForces)
{
  // They differ by theta0^2 in the sliding distance, and start the steps at other places: the trapezoidal work and the
  // interpolation to X = 0 differ by the square of a step over the half distance.
  const double alpha = slow_build ? 2.0 : 4.0;
  simulation::TuggingCase t = paper_case(alpha);
  t.kinematics = simulation::Kinematics::paper;
  const TuggingRun run = computed(t);
  const TuggingRun& exact = paper_run(alpha);
  const double n = 0.5 * exact.plan.steps_per_pass;
  const double step_error = 1.0 / (n * n);
  test::expect_close("F_Z at X = 0, paper / exact", run.summary.F_Z_aligned / exact.summary.F_Z_aligned, 1.0,
                     step_error, "theory: second order in the angle");
  test::expect_close("F_X at X = 0 over the peak, paper - exact",
                     (run.summary.F_X_aligned - exact.summary.F_X_aligned) / exact.summary.peak_F_X, 0.0, step_error,
                     "theory: second order in the angle");
  test::expect_close("net work over the work to alignment, paper - exact",
                     (run.summary.work - exact.summary.work) / exact.summary.work_to_alignment, 0.0, 2.0 * step_error,
                     "theory: second order in the angle");
}

} // namespace
} // namespace brinell::verification::paper_tugging_test
