// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/reference/critical.hpp"
#include "brinell/reference/elastic_tugging.hpp"
#include "brinell/reference/hertz.hpp"

#include "gauss.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace brinell::reference::elastic_tugging_test
{
namespace
{

// Boucly, Nelias & Green (2006): R1 = R2 = 1 m, E = 200 GPa, nu = 0.32, S_y = 0.9115 GPa.
constexpr double contact_modulus = 0.5 * 200e9 / (1.0 - 0.32 * 0.32);

CriticalValues critical()
{
  return critical_values(0.5, contact_modulus, critical_pressure_ratio(0.32), 0.9115e9);
}

ElasticTugging tugging(double interference_ratio)
{
  return {1.0, 1.0, contact_modulus, interference_ratio * critical().interference};
}

struct Row
{
  double interference, first_touch, peak, at, normal, work;
};

TEST(ElasticTuggingTest, Table)
{
  // Exact values, rounded to the digits given: half of the last one.
  for (const Row& row :
       {Row{1.0, 0.01488, 0.00483, -0.02976, 1.000, 1.000}, Row{4.0, 0.02977, 0.07733, -0.05951, 8.000, 32.00},
        Row{9.0, 0.04467, 0.39156, -0.08923, 27.000, 243.0}, Row{15.0, 0.05770, 1.08790, -0.11516, 58.095, 871.4}})
  {
    const ElasticTugging t = tugging(row.interference);
    const CriticalValues c = critical();
    const double d0 = half_sliding_distance(t), omega = 2.0 - t.interference;
    EXPECT_NEAR(d0 / omega, row.first_touch, 6e-6);
    const TuggingPeak peak = elastic_tugging_peak(t);
    EXPECT_NEAR(peak.F_X / c.load, row.peak, 6e-6);
    EXPECT_NEAR(peak.X / 0.5, row.at, 1.1e-5);
    EXPECT_NEAR(elastic_tugging_forces(t, 0.0).F_Z / c.load, row.normal, 6e-4);
    EXPECT_NEAR(elastic_tugging_work(t, -d0, 0.0) / c.energy / row.work, 1.0, 1e-4);
    EXPECT_NEAR(elastic_tugging_work(t, -d0, d0), 0.0, 1e-12 * c.energy);
  }
  EXPECT_NEAR(half_sliding_distance(tugging(9.0)), 0.089261, 6e-7);
}

TEST(ElasticTuggingTest, ForcesAreSymmetricAndResistBeforeAlignment)
{
  const ElasticTugging t = tugging(9.0);
  const TuggingForces before = elastic_tugging_forces(t, -0.05), after = elastic_tugging_forces(t, 0.05);
  EXPECT_GT(before.F_X, 0.0);
  EXPECT_EQ(before.F_X, -after.F_X);
  EXPECT_EQ(before.F_Z, after.F_Z);
  EXPECT_NEAR(std::hypot(before.F_X, before.F_Z), before.load, 1e-15 * before.load);
  EXPECT_EQ(elastic_tugging_forces(t, 0.0).F_X, 0.0);
  EXPECT_EQ(elastic_tugging_forces(t, 0.0).interference, t.interference);
}

TEST(ElasticTuggingTest, NoForceWithoutContact)
{
  const ElasticTugging t = tugging(9.0);
  const double d0 = half_sliding_distance(t);
  EXPECT_GT(elastic_tugging_forces(t, -0.999 * d0).load, 0.0);
  EXPECT_EQ(elastic_tugging_forces(t, -1.001 * d0).load, 0.0);
}

TEST(ElasticTuggingTest, WorkIsTheIntegralOfTheForce)
{
  // Away from the first touch the force is smooth: a rule of 20 points is exact to rounding.
  const ElasticTugging t{0.8, 1.5, contact_modulus, 2e-3};
  const test::Gauss rule(20, -0.04, 0.02);
  double work = 0.0;
  for (std::size_t i = 0; i < rule.point.size(); ++i)
    work += rule.weight[i] * elastic_tugging_forces(t, rule.point[i]).F_X;
  EXPECT_NEAR(work / elastic_tugging_work(t, -0.04, 0.02), 1.0, 1e-12);
}

TEST(ElasticTuggingTest, PeakIsTheLargestForce)
{
  const ElasticTugging t{0.8, 1.5, contact_modulus, 2e-3};
  const TuggingPeak peak = elastic_tugging_peak(t);
  const double d0 = half_sliding_distance(t);
  for (int i = -200; i <= 200; ++i)
    EXPECT_LE(elastic_tugging_forces(t, d0 * i / 200.0).F_X, peak.F_X);
}

TEST(ElasticTuggingTest, CylindersPressAsTheirLineContactAndGiveBackTheWork)
{
  const Line line{2.0, 0.4};
  const ElasticTugging t{0.8, 1.5, contact_modulus, 2e-3, line};
  const double R = 0.8 * 1.5 / 2.3;
  const LineContact aligned = line_contact_at_approach(R, contact_modulus, 2e-3, line.reference);
  EXPECT_NEAR(elastic_tugging_forces(t, 0.0).F_Z / (2.0 * aligned.load_per_length), 1.0, 1e-14);
  const test::Gauss rule(20, -0.04, 0.02);
  double work = 0.0;
  for (std::size_t i = 0; i < rule.point.size(); ++i)
    work += rule.weight[i] * elastic_tugging_forces(t, rule.point[i]).F_X;
  EXPECT_NEAR(work / elastic_tugging_work(t, -0.04, 0.02), 1.0, 1e-12);
  const double d0 = half_sliding_distance(t);
  EXPECT_NEAR(elastic_tugging_work(t, -d0, 0.0), 2.0 * line_contact_work(aligned, contact_modulus, line.reference),
              1e-12 * work);
  const TuggingPeak peak = elastic_tugging_peak(t);
  for (int i = -200; i <= 200; ++i)
    EXPECT_LE(elastic_tugging_forces(t, d0 * i / 200.0).F_X, peak.F_X);
  EXPECT_THROW((void)half_sliding_distance({1.0, 1.0, 1e11, 1e-3, Line{1.0, 0.0}}), InputError);
  EXPECT_THROW((void)elastic_tugging_forces({1.0, 1.0, 1e11, 1e-3, Line{1.0, 1e-3}}, 0.0), InputError);
}

TEST(ElasticTuggingTest, RefusesNonsense)
{
  EXPECT_THROW((void)half_sliding_distance({1.0, 1.0, 1e11, 0.0}), InputError);
  EXPECT_THROW((void)half_sliding_distance({1.0, 1.0, 1e11, 2.5}), InputError);
  EXPECT_THROW((void)elastic_tugging_forces({-1.0, 1.0, 1e11, 0.1}, 0.0), InputError);
}

} // namespace
} // namespace brinell::reference::elastic_tugging_test
