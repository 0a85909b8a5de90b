// SPDX-License-Identifier: BSD-3-Clause
#include "record.hpp"
#include "tugging_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

/// Hardening laws in the tugging of two spheres. That each law follows its curve is in tests/unit/constitutive.
namespace brinell::verification::hardening_test
{
namespace
{

using constitutive::Material;
using simulation::TuggingCase;
using simulation::TuggingRecord;

TuggingCase with_material(double interference_ratio, const Material& material)
{
  TuggingCase t = small_case(interference_ratio);
  t.lower.material = t.upper.material = material;
  return t;
}

TEST(LinearHardening, ReducesPlasticStrainAndDissipation)
{
  double strain = 1e9, dissipation = 1e9, force = 0.0;
  for (const double modulus : {0.0, 0.02, 0.1}) // of E
  {
    TuggingCase t = small_case(6.0);
    t.lower.material.hardening = constitutive::LinearHardening{yield_stress, modulus * elastic.young_modulus};
    t.upper.material = t.lower.material;
    const simulation::TuggingSummary s = simulation::run(t);
    const double lost = (s.dissipation_lower + s.dissipation_upper) / critical().energy;
    const std::string name = "hardening modulus / E = " + std::to_string(modulus).substr(0, 4) + ": ";
    test::expect_within(name + "largest plastic strain", s.max_equivalent_plastic_strain, 0.0,
                        std::nextafter(strain, 0.0), "bound: below that of less hardening");
    test::expect_within(name + "dissipation / U_c", lost, 0.0, std::nextafter(dissipation, 0.0),
                        "bound: below that of less hardening");
    test::expect_within(name + "peak F_Z / P_c", s.peak_F_Z / critical().load, std::nextafter(force, 1e9),
                        std::pow(6.0, 1.5), "bounds: above that of less hardening, below elastic spheres");
    strain = s.max_equivalent_plastic_strain;
    dissipation = lost;
    force = s.peak_F_Z / critical().load;
  }
}

TEST(LinearHardening, WithoutModulusIsPerfectPlasticity)
{
  TuggingCase t = small_case(4.0);
  const TuggingRun perfect = computed(t);
  t.lower.material.hardening = t.upper.material.hardening = constitutive::LinearHardening{yield_stress, 0.0};
  const TuggingRun linear = computed(t);
  // The same arithmetic, compiled twice: rounding may differ, and the iteration carries it along up to its tolerance.
  test::expect_close("F_X", difference(perfect, &TuggingRecord::F_X, linear, &TuggingRecord::F_X), 0.0, 1e-4,
                     "exact: the same law");
}

TEST(Hardening, OneLawInSeveralForms)
{
  // A straight line: linear; Swift and Ludwik with the exponent 1; a table of two points.
  using namespace constitutive;
  const double modulus = 0.05 * elastic.young_modulus;
  const TuggingRun linear = computed(with_material(4.0, {elastic, LinearHardening{yield_stress, modulus}}));
  const auto same = [&](const char* name, const HardeningLaw& law)
  {
    const TuggingRun run = computed(with_material(4.0, {elastic, law}));
    test::expect_close(std::string(name) + ": F_X", difference(linear, &TuggingRecord::F_X, run, &TuggingRecord::F_X),
                       0.0, 1e-4, "exact: the same law");
    test::expect_close(std::string(name) + ": work",
                       difference(linear, &TuggingRecord::work, run, &TuggingRecord::work), 0.0, 1e-4,
                       "exact: the same law");
  };
  same("Swift", SwiftHardening{modulus, yield_stress / modulus, 1.0});
  same("Ludwik", LudwikHardening{yield_stress, modulus, 1.0});
  same("table", TabulatedHardening({0.0, 0.5}, {yield_stress, yield_stress + 0.5 * modulus}));
}

struct Named
{
  const char* name;
  Material material;
};

/// Constants of the size of hardened steels.
std::vector<Named> hardening_materials()
{
  using namespace constitutive;
  return {{"Swift", {elastic, SwiftHardening{1.6e9, 0.003, 0.1}}},
          {"Hollomon", {elastic, hollomon(yield_stress, 1.5e9, 0.1)}},
          {"Ludwik", {elastic, LudwikHardening{yield_stress, 1e9, 0.5}}},
          {"Voce", {elastic, VoceHardening{yield_stress, 0.4e9, 60.0}}},
          {"table", {elastic, TabulatedHardening({0.0, 0.002, 0.02}, {yield_stress, 1.1e9, 1.3e9})}},
          {"Prager", {elastic, PerfectPlasticity{yield_stress}, {{20e9, 0.0}}}},
          {"Armstrong-Frederick", {elastic, PerfectPlasticity{yield_stress}, {{60e9, 150.0}}}},
          {"Chaboche and Voce",
           {elastic, VoceHardening{yield_stress, 0.2e9, 30.0}, {{150e9, 800.0}, {20e9, 60.0}, {1e9, 0.0}}}}};
}

TEST(Hardening, EveryLawKeepsTheEnergyAndStiffensThePerfectOne)
{
  const double ratio = slow_build ? 2.0 : 6.0;
  const TuggingRun perfect = computed(with_material(ratio, perfect_material()));
  for (const Named& law : hardening_materials())
  {
    const TuggingRun run = computed(with_material(ratio, law.material));
    const std::string name = std::string(law.name) + ": ";
    // Coarse cells: the edge's error, first order in the cell at worst.
    test::expect_close(name + "energy balance over the largest work", run.summary.energy_balance_error, 0.0, 0.05,
                       "exact: conservation of energy");
    test::expect_within(name + "peak F_Z / that of perfect plasticity", run.summary.peak_F_Z / perfect.summary.peak_F_Z,
                        1.0, 1.3, "bounds: perfect plasticity, elastic spheres");
    test::expect_within(name + "largest plastic strain / that of perfect plasticity",
                        run.summary.max_equivalent_plastic_strain / perfect.summary.max_equivalent_plastic_strain, 0.05,
                        1.0, "bound: below perfect plasticity");
    EXPECT_EQ(run.summary.split_increments, 0) << law.name;
  }
}

TEST(DepthProfiles, OneFactorIsAnotherYieldStress)
{
  Material harder = perfect_material(), profiled = perfect_material();
  harder.hardening = constitutive::PerfectPlasticity{1.25 * yield_stress};
  profiled.yield_factor = constitutive::DepthProfile({0.0}, {1.25});
  TuggingCase t = small_case(6.0); // the interference in units of the same S_y
  t.lower.material = t.upper.material = harder;
  const TuggingRun a = computed(t);
  t.lower.material = t.upper.material = profiled;
  const TuggingRun b = computed(t);
  test::expect_close("F_X", difference(a, &TuggingRecord::F_X, b, &TuggingRecord::F_X), 0.0, 2e-4,
                     "exact: the same law");
  test::expect_close("work", difference(a, &TuggingRecord::work, b, &TuggingRecord::work), 0.0, 2e-4,
                     "exact: the same law");
}

TEST(DepthProfiles, HardCaseAndInitialStressKeepTheEnergy)
{
  TuggingCase t = small_case(slow_build ? 2.0 : 6.0);
  const double a = simulation::plan(t).elastic_contact_radius;
  const double soft = computed(t).summary.work;
  Material& m = t.lower.material;
  m.yield_factor = constitutive::DepthProfile({0.0, 0.5 * a, a}, {1.4, 1.2, 1.0}); // nitrided
  m.initial_stress =
      constitutive::DepthProfile({0.0, 0.6 * a, 1.2 * a}, {-0.5 * yield_stress, 0.0, 0.1 * yield_stress});
  t.upper.material = m;
  const TuggingRun run = computed(t);
  test::expect_close("energy balance over the largest work", run.summary.energy_balance_error, 0.0, 0.05,
                     "exact: conservation of energy");
  test::expect_within("net work / that of the core material", run.summary.work / soft, 0.1, 1.0,
                      "bound: less than the softer one");
  // Far from the contact the stress is nearly the initial one.
  const simulation::BodySnapshot& body = run.summary.final_state.lower;
  test::expect_close("sigma_xx in the corner of the first layer / initial",
                     body.stress[0][0] / m.initial_stress.at(0.5 * body.grid.dz, 0.0), 1.0, 0.05,
                     "limit: far from the track");
  EXPECT_NEAR(body.stress[2][0], 0.0, 0.01 * yield_stress);
}

TEST(DepthProfiles, WithoutPlasticStrainTheInitialStressIsWhatRemains)
{
  TuggingCase t = small_case(0.5); // below first yield
  const double a = simulation::plan(t).elastic_contact_radius;
  Material& m = t.lower.material;
  m.initial_stress = constitutive::DepthProfile({0.3 * a, 1.2 * a}, {-0.3 * yield_stress, 0.1 * yield_stress});
  t.upper.material = m;
  const simulation::BodySnapshot body = simulation::run(t).final_state.upper;
  double error = 0.0;
  for (std::size_t i = 0; i < body.grid.size(); ++i)
  {
    const double depth = (static_cast<double>(i / body.grid.surface.size()) + 0.5) * body.grid.dz;
    const double initial = m.initial_stress.at(depth, 0.0);
    ASSERT_EQ(body.equivalent_plastic_strain[i], 0.0);
    for (std::size_t c = 0; c < 6; ++c)
      error = std::max(error, std::abs(body.stress[c][i] - (c < 2 ? initial : 0.0)));
  }
  test::expect_close("stress after the pass - initial stress / yield stress", error / yield_stress, 0.0, 1e-14,
                     "exact: xx = yy = the profile, all else zero");
}

TEST(KinematicHardening, WithoutModulusIsPerfectPlasticity)
{
  const TuggingRun perfect = computed(small_case(4.0));
  Material material = perfect_material();
  material.kinematic = {{0.0, 0.0}, {0.0, 30.0}};
  const TuggingRun run = computed(with_material(4.0, material));
  test::expect_close("F_X", difference(perfect, &TuggingRecord::F_X, run, &TuggingRecord::F_X), 0.0, 1e-4,
                     "exact: the same law");
}

TEST(KinematicHardening, OneOfTwoMirrorImages)
{
  TuggingCase t = with_material(4.0, hardening_materials().back().material);
  t.passes = 2;
  const TuggingRun one = computed(t);
  t.solver.mirror = false;
  const TuggingRun both = computed(t);
  test::expect_close("F_X, two passes", difference(both, &TuggingRecord::F_X, one, &TuggingRecord::F_X), 0.0, 2e-4,
                     "exact: symmetry");
  test::expect_close("dissipation of the upper body",
                     difference(both, &TuggingRecord::dissipation_upper, one, &TuggingRecord::dissipation_upper), 0.0,
                     2e-4, "exact: symmetry");
}

} // namespace
} // namespace brinell::verification::hardening_test
