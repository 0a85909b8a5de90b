// SPDX-License-Identifier: BSD-3-Clause
#include "record.hpp"
#include "tugging_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <omp.h>

/// What a result must not depend on.
namespace brinell::verification::invariance_test
{
namespace
{

using simulation::TuggingCase;
using simulation::TuggingRecord;

/// alpha* = 4, some four cells per contact radius along x; both bodies are solved, though they are alike.
TuggingCase small_case()
{
  TuggingCase t = equal_spheres(4.0, perfect_material());
  const double a = simulation::plan(t).elastic_contact_radius;
  const double cells = slow_build ? 3.0 : 4.0;
  t.spacing = {{a / cells, 1.5 * a / cells, a / cells}};
  t.solver.mirror = false;
  return t;
}

/// A column of the history, and the powers of length and stress in its unit.
struct Column
{
  const char* name;
  double TuggingRecord::*value;
  int length, stress;
};

constexpr std::array columns{
    Column{"F_n", &TuggingRecord::F_n, 2, 1},
    Column{"F_X", &TuggingRecord::F_X, 2, 1},
    Column{"F_Z", &TuggingRecord::F_Z, 2, 1},
    Column{"max_pressure", &TuggingRecord::max_pressure, 0, 1},
    Column{"contact_area", &TuggingRecord::contact_area, 2, 0},
    Column{"work", &TuggingRecord::work, 3, 1},
    Column{"dissipation_lower", &TuggingRecord::dissipation_lower, 3, 1},
    Column{"dissipation_upper", &TuggingRecord::dissipation_upper, 3, 1},
    Column{"energy_residual", &TuggingRecord::energy_residual, 3, 1},
    Column{"energy_elastic", &TuggingRecord::energy_elastic, 3, 1},
    Column{"max_residual_lower", &TuggingRecord::max_residual_lower, 1, 0},
    Column{"max_equivalent_plastic_strain", &TuggingRecord::max_equivalent_plastic_strain, 0, 0}};

/// Largest difference over all columns of a history and its image in other units, over the largest value of each.
double difference(const TuggingRun& a, const TuggingRun& b, double length = 1.0, double stress = 1.0)
{
  EXPECT_EQ(a.history.size(), b.history.size());
  double worst = 0.0;
  for (const Column& column : columns)
  {
    const double scale = std::pow(length, column.length) * std::pow(stress, column.stress);
    double change = 0.0, largest = 0.0;
    for (std::size_t i = 0; i < std::min(a.history.size(), b.history.size()); ++i)
    {
      change = std::max(change, std::abs(a.history[i].*column.value - b.history[i].*column.value / scale));
      largest = std::max(largest, std::abs(a.history[i].*column.value));
    }
    worst = std::max(worst, change / largest);
  }
  return worst;
}

TuggingRun computed_with_threads(const TuggingCase& t, int threads)
{
  const int before = omp_get_max_threads();
  omp_set_num_threads(threads);
  TuggingRun run = computed(t);
  omp_set_num_threads(before);
  return run;
}

TEST(Invariance, NumberOfThreads)
{
  // Every sum has a fixed order, so that only the choice of transform plans may differ, by rounding.
  const TuggingCase t = small_case();
  const TuggingRun one = computed_with_threads(t, 1), two = computed_with_threads(t, 2);
  test::expect_close("history, 1 and 2 threads", difference(one, two), 0.0, 1e-10, "exact: the same sums");
}

TEST(Invariance, RepeatedRun)
{
  const TuggingCase t = small_case();
  test::expect_close("history, twice", difference(computed(t), computed(t)), 0.0, 1e-10, "exact: the same sums");
}

TEST(Invariance, UnitOfLength)
{
  // Spheres of one micrometre: all lengths by 1e-6, stresses as they are.
  const TuggingCase metres = small_case();
  TuggingCase micro = metres;
  constexpr double scale = 1e-6;
  for (simulation::ShapedBody* body : {&micro.lower, &micro.upper})
    body->shape = ball(scale);
  micro.interference *= scale;
  for (double& spacing : *micro.spacing)
    spacing *= scale;
  // The tolerances scale with the case. Rounding differs, and may end an iteration one evaluation earlier or later: then
  // the difference is one of the tolerances, 1e-4 of the yield stress.
  test::expect_close("history, metre and micrometre", difference(computed(metres), computed(micro), scale), 0.0, 1e-4,
                     "exact: similarity");
}

TEST(Invariance, UnitOfStress)
{
  const TuggingCase t = small_case();
  TuggingCase soft = t;
  constexpr double scale = 1e-3; // a gel a thousand times softer and weaker
  for (simulation::ShapedBody* body : {&soft.lower, &soft.upper})
    body->material = {{scale * elastic.young_modulus, elastic.poisson_ratio},
                      constitutive::PerfectPlasticity{scale * yield_stress}};
  test::expect_close("history, 200 GPa and 0.2 GPa", difference(computed(t), computed(soft), 1.0, scale), 0.0, 1e-4,
                     "exact: similarity");
}

TEST(Invariance, OneOfTwoMirrorImages)
{
  // Solved apart, the two bodies end their iterations together but not at the same digits: the difference is one of the
  // tolerances, 1e-4 of the yield stress.
  const TuggingCase both = small_case();
  TuggingCase one = both;
  one.solver.mirror = true;
  test::expect_close("history, both bodies solved and one of them mirrored", difference(computed(both), computed(one)),
                     0.0, 1e-4, "exact: symmetry");
}

TEST(Invariance, ToleranceOfTheIteration)
{
  // Ten times tighter tolerances change the result by what the default ones allow: 1e-4 of the yield stress in a cell at
  // every step, which adds up over the steps at worst.
  const TuggingCase t = small_case();
  TuggingCase tight = t;
  tight.solver.yield_tolerance *= 0.1;
  tight.solver.displacement_tolerance *= 0.1;
  tight.solver.contact_tolerance *= 0.1;
  const TuggingRun run = computed(t);
  test::expect_close("history, default and tighter tolerances", difference(run, computed(tight)), 0.0,
                     1e-4 * static_cast<double>(run.history.size()), "bound: the tolerance of each step");
}

} // namespace
} // namespace brinell::verification::invariance_test
