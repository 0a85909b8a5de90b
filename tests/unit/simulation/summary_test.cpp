// SPDX-License-Identifier: BSD-3-Clause
#include "simulation/motion/tugging_peaks.hpp"
#include "simulation/stepping/records.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace brinell::simulation::summary_test
{
namespace
{

constexpr double rounding = 1e-13;

/// A history as it comes in, row by row.
struct History
{
  TuggingRecord last;
  TuggingPeaks peaks;

  void add(TuggingRecord record)
  {
    record.work = last.work + work_between(last, record);
    simulation::add(last, record, peaks);
    last = record;
  }
};

TuggingRecord step(int number, int pass, double X, double F_X, double F_Z)
{
  TuggingRecord r;
  r.step = number;
  r.pass = pass;
  r.X = X;
  r.F_X = F_X;
  r.F_Z = F_Z;
  return r;
}

TEST(SummaryTest, WorkIsTheIntegralOfTheForce)
{
  // Exact for a force that is linear between the steps, however they are spaced.
  History s;
  const std::vector<double> places{-2.0, -1.5, -0.25, 0.0, 0.5, 2.0};
  int number = 0;
  for (const double X : places)
  {
    s.add(step(number++, 1, X, 1.0 - X, 10.0));
    const double work = (X - 0.5 * X * X) - (-2.0 - 2.0);
    EXPECT_NEAR(s.last.work, work, rounding);
  }
  EXPECT_NEAR(s.last.work, 4.0, rounding);
  EXPECT_NEAR(s.peaks.work_to_alignment, 4.0, rounding);
}

TEST(SummaryTest, AlignmentBetweenTwoStepsIsInterpolated)
{
  History s;
  s.add(step(0, 1, -0.3, 8.0, 20.0));
  s.add(step(1, 1, 0.1, 4.0, 16.0));
  const TuggingPeaks& r = s.peaks;
  EXPECT_NEAR(r.F_X_aligned, 5.0, rounding);
  EXPECT_NEAR(r.F_Z_aligned, 17.0, rounding);
  EXPECT_NEAR(r.load_ratio_aligned, 5.0 / 17.0, rounding);
  EXPECT_NEAR(r.work_to_alignment, 0.75 * 0.4 * 6.0, rounding); // linear in the work as well
}

TEST(SummaryTest, PeaksAndTheLastTouch)
{
  History s;
  s.add(step(0, 1, -2.0, 0.0, 0.0));
  s.add(step(1, 1, -1.0, 5.0, 9.0));
  s.add(step(2, 1, 0.0, 1.0, 11.0));
  s.add(step(3, 1, 1.0, -3.0, 10.0));
  s.add(step(4, 1, 2.0, -0.1, 2.0));
  s.add(step(5, 1, 3.0, 0.0, 0.0));
  const TuggingPeaks& r = s.peaks;
  EXPECT_EQ(r.peak_F_X, 5.0);
  EXPECT_EQ(r.X_at_peak_F_X, -1.0);
  EXPECT_EQ(r.min_F_X, -3.0);
  EXPECT_EQ(r.peak_F_Z, 11.0);
  EXPECT_EQ(r.load_ratio_end, -0.05);
  EXPECT_EQ(r.F_X_aligned, 1.0);
}

TEST(SummaryTest, TheWayBackBetweenPassesIsNoWork)
{
  History s;
  int number = 0;
  for (const int pass : {1, 2})
    for (const double X : {-1.0, 0.0, 1.0})
      s.add(step(number++, pass, X, 1.0 + pass, 1.0));
  EXPECT_NEAR(s.last.work, 2.0 * 2.0 + 2.0 * 3.0, rounding);
  EXPECT_NEAR(s.peaks.work_to_alignment, 2.0, rounding); // of the first pass
  EXPECT_EQ(s.peaks.F_X_aligned, 2.0);
}

TEST(SummaryTest, EnergyBalanceIsRelativeToTheLargestWork)
{
  // Largest work 10, 6 at the end; 5.5 of it are accounted for.
  StepRecord last;
  last.work = 6.0;
  last.dissipation_lower = 2.0;
  last.dissipation_upper = 1.0;
  last.dissipation_friction = 0.5;
  last.energy_residual = 2.0;
  RunTotals totals;
  take_totals(last, 10.0, totals);
  EXPECT_NEAR(totals.energy_balance_error, (6.0 - 5.5) / 10.0, rounding);
  take_totals(StepRecord{}, 0.0, totals);
  EXPECT_EQ(totals.work, 0.0);
}

TEST(SummaryTest, NothingHappened)
{
  History s;
  s.add(step(0, 1, -1.0, 0.0, 0.0));
  s.add(step(1, 1, 1.0, 0.0, 0.0));
  EXPECT_EQ(s.peaks.load_ratio_aligned, 0.0);
  EXPECT_EQ(s.peaks.load_ratio_end, 0.0);
}

} // namespace
} // namespace brinell::simulation::summary_test
