// SPDX-License-Identifier: BSD-3-Clause
#include "record.hpp"
#include "scenario_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <omp.h>
#include <string>
#include <vector>

/// Bodies that slide with friction: balance of energy, symmetry, the limit of the shear.
namespace brinell::verification::friction_test
{
namespace
{

using simulation::RollingCase;
using simulation::RollingRecord;
using simulation::TuggingCase;
using simulation::TuggingRecord;

double unaccounted(const simulation::StepRecord& r)
{
  return r.work - r.dissipation_lower - r.dissipation_upper - r.dissipation_friction - r.energy_residual -
         r.energy_elastic;
}

/// A ball that turns too slowly on a flat of the same steel, which both can yield.
RollingCase skidding(double p0_over_k, double friction, double slide_to_roll, double cells)
{
  RollingCase c = ball_on_flat(track_steel(20e9), p0_over_k * 1e9, 1e-3);
  c.upper.material = c.lower.material;
  c.resolution = cells;
  c.slide_to_roll = slide_to_roll;
  c.friction.coefficient = friction;
  const double half_width = simulation::plan(c).half_width_x;
  c.distance = 4.0 * half_width;
  return c;
}

TEST(Friction, ElasticBodiesTurnAllWorkIntoHeat)
{
  // Whatever the materials: in each step to the rounding of long sums and the tolerance of the contact, but for the trapezoidal
  // rule of the work of the pressure, of second order in the step; at the end of the pass, when it is symmetric, no more of it
  // is left than 1e-5.
  for (const double stiffness : {1.0, 3.0})
    for (const bool coupling : {true, false})
    {
      TuggingCase t = rubbing(4.0, 0.3, slow_build ? 4.0 : 6.0);
      t.lower.material = t.upper.material = elastic_material();
      t.upper.material.elastic.young_modulus *= stiffness;
      t.friction.coupling = coupling;
      const TuggingRun run = computed(t);
      const std::string name = "upper body " + std::to_string(static_cast<int>(stiffness)) + " times as stiff" +
                               (coupling ? "" : ", no coupling");
      double previous = 0.0;
      for (const TuggingRecord& r : run.history)
      {
        EXPECT_NEAR(r.F_friction, 0.3 * r.F_n, 1e-9 * run.summary.peak_F_Z);
        EXPECT_GE(r.dissipation_friction, previous);
        previous = r.dissipation_friction;
      }
      test::expect_close(name + ": heat / work, elastic pass", run.summary.dissipation_friction / run.summary.work, 1.0,
                         1e-5, "exact: all of it");
    }
}

TEST(Friction, EnergyClosesWithPlasticity)
{
  const TuggingRun tugging = computed(rubbing(4.0, 0.2, slow_build ? 5.0 : 16.0));
  test::expect_close("error of the energy balance, tugging, friction 0.2, 16 cells",
                     tugging.summary.energy_balance_error, 0.0, 5e-3, "bound: mesh and steps");
  const RollingRun rolling = computed(skidding(4.0, 0.2, 0.4, slow_build ? 3.0 : 6.0));
  test::expect_close("error of the energy balance, rolling with slip, friction 0.2, 6 cells",
                     rolling.summary.energy_balance_error, 0.0, 5e-3, "bound: mesh and steps");
  for (const simulation::RunTotals* s : {static_cast<const simulation::RunTotals*>(&tugging.summary),
                                         static_cast<const simulation::RunTotals*>(&rolling.summary)})
  {
    EXPECT_GT(s->dissipation_lower, 0.0);
    EXPECT_GT(s->dissipation_friction, s->dissipation_lower);
  }
}

TEST(Friction, SwappingTheBodiesMirrorsTheResult)
{
  // One problem seen from either side, cell by cell, as in DissimilarBodies: the tolerance of the iteration is left.
  TuggingCase t = small_case(4.0);
  t.friction.coefficient = 0.25;
  t.upper.material.elastic.young_modulus *= 2.0;
  t.upper.material.hardening = constitutive::LinearHardening{1.5 * yield_stress, 20e9};
  TuggingCase other = t;
  std::swap(other.lower, other.upper);
  const TuggingRun run = computed(t), mirror = computed(other);
  ASSERT_EQ(run.history.size(), mirror.history.size());
  const auto same = [&](const char* name, double TuggingRecord::*a, double TuggingRecord::*b)
  {
    test::expect_close(std::string(name) + ", swapped with friction", difference(run, a, mirror, b), 0.0, 1e-3,
                       "exact: symmetry");
  };
  same("F_X", &TuggingRecord::F_X, &TuggingRecord::F_X);
  same("F_friction", &TuggingRecord::F_friction, &TuggingRecord::F_friction);
  same("heat", &TuggingRecord::dissipation_friction, &TuggingRecord::dissipation_friction);
  same("dissipation of the lower body", &TuggingRecord::dissipation_lower, &TuggingRecord::dissipation_upper);
  same("residual displacement of the lower body", &TuggingRecord::max_residual_lower,
       &TuggingRecord::max_residual_upper);
}

TEST(Friction, MirrorImageIsSolvedOnce)
{
  TuggingCase t = small_case(4.0);
  t.friction.coefficient = 0.25;
  const TuggingRun one = computed(t);
  t.solver.mirror = false;
  const TuggingRun both = computed(t);
  EXPECT_EQ(one.plan.twin, elastoplastic::Twin::mirror_image);
  EXPECT_EQ(both.plan.twin, elastoplastic::Twin::none);
  const auto same = [&](const char* name, double TuggingRecord::*member)
  {
    test::expect_close(std::string(name) + ", one body or both solved, friction", difference(one, member, both, member),
                       0.0, 1e-3, "exact: symmetry");
  };
  same("F_X", &TuggingRecord::F_X);
  same("heat", &TuggingRecord::dissipation_friction);
}

TEST(Friction, DirectionOfTheSlip)
{
  // A ball that turns too fast pulls the flat back: shear and stress the other way, and F_X that drives where the other resists;
  // on a short way, elastic, mirrored.
  RollingCase c = skidding(2.0, 0.2, 0.5, 4.0);
  c.lower.material.hardening.reset();
  c.upper.material.hardening.reset();
  const RollingRun slow = computed(c);
  c.slide_to_roll = -0.5;
  const RollingRun fast = computed(c);
  const auto at = [](const RollingRun& run) { return run.history[run.history.size() / 2]; };
  const double share = 1.5 / 2.5;                                                     // of the upper body's way
  EXPECT_NEAR(at(slow).F_X, (1.0 - share) * 0.2 * at(slow).F_n, 0.01 * at(slow).F_X); // the slope under shear: p0/E'
  EXPECT_NEAR(at(fast).F_X, (1.0 / share - 1.0) * 0.2 * at(fast).F_n,
              0.01 * at(fast).F_X); // friction takes work always
  EXPECT_GT(fast.summary.dissipation_friction, 0.0);
  EXPECT_NEAR(unaccounted(at(fast)), 0.0, 1e-3 * at(fast).work);
}

TEST(Friction, CapActsAndIsTold)
{
  // At friction 0.4 and p0/k = 4.5 the surface of a flat that hardens would have to carry 1.8 k.
  RollingCase c = skidding(4.5, 0.4, 0.4, slow_build ? 3.0 : 5.0);
  const RollingRun run = computed(c);
  EXPECT_GT(run.summary.max_share_at_shear_limit, 0.3);
  double largest = 0.0;
  for (const RollingRecord& r : run.history)
  {
    largest = std::max(largest, r.share_at_shear_limit);
    EXPECT_LE(r.F_friction, 0.4 * r.F_n * (1.0 + 1e-12));
    if (r.share_at_shear_limit > 0.0)
    {
      EXPECT_LT(r.F_friction, 0.4 * r.F_n);
    }
  }
  EXPECT_EQ(run.summary.max_share_at_shear_limit, largest);
  EXPECT_NEAR(run.summary.energy_balance_error, 0.0, 0.01);
}

TEST(Friction, LargestStrainClimbsToTheSurface)
{
  // First yield does near friction 0.3 (Hamilton 1983).
  const auto layer = [](double friction)
  {
    const RollingRun run = computed(skidding(3.6, friction, 0.4, slow_build ? 3.0 : 5.0));
    const std::vector<double>& strain = run.summary.profile.equivalent_plastic_strain;
    return run.summary.profile
               .depth[static_cast<std::size_t>(std::max_element(strain.begin(), strain.end()) - strain.begin())] /
           simulation::plan(skidding(3.6, friction, 0.4, slow_build ? 3.0 : 5.0)).half_width_x;
  };
  test::expect_within("depth of the largest strain over the contact radius, friction 0", layer(0.0), 0.25, 0.8,
                      "Hamilton 1983: beneath the surface");
  test::expect_within("the same, friction 0.4", layer(0.4), 0.0, slow_build ? 0.3 : 0.15, "Hamilton 1983: the surface");
}

TEST(Friction, ThreadsChangeNothing)
{
  TuggingCase t = small_case(4.0);
  t.friction.coefficient = 0.25;
  t.upper.material.elastic.young_modulus *= 2.0;
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const TuggingRun one = computed(t);
  omp_set_num_threads(3);
  const TuggingRun three = computed(t);
  omp_set_num_threads(before);
  ASSERT_EQ(one.history.size(), three.history.size());
  for (std::size_t i = 0; i < one.history.size(); ++i)
  {
    EXPECT_EQ(one.history[i].F_X, three.history[i].F_X);
    EXPECT_EQ(one.history[i].dissipation_friction, three.history[i].dissipation_friction);
    EXPECT_EQ(one.history[i].max_equivalent_plastic_strain, three.history[i].max_equivalent_plastic_strain);
  }
}

} // namespace
} // namespace brinell::verification::friction_test
