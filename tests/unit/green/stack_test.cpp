// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/green/stack.hpp"

#include "brinell/foundation/error.hpp"
#include "oracle_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

namespace brinell::green::stack_test
{
namespace
{

constexpr WaveLoad loads[] = {WaveLoad::pressure, WaveLoad::along, WaveLoad::across};
constexpr double rigid = std::numeric_limits<double>::infinity();

/// The stacks of tools/oracles/stack.py.
const std::map<std::string, ElasticStack>& stacks()
{
  static const std::map<std::string, ElasticStack> all{
      {"soft_on_hard", {{{1.0, {1.0, 0.4}}}, {10.0, 0.3}}},
      {"hard_on_soft", {{{0.5, {4.0, 0.2}}}, {1.0, 0.3}}},
      {"on_rigid", {{{1.0, {1.0, 0.3}}}, {rigid, 0.0}}},
      {"three_layers", {{{0.2, {3.0, 0.25}}, {0.7, {0.5, 0.45}}, {0.1, {8.0, 0.1}}}, {2.0, 0.3}}}};
  return all;
}

double top_of(const ElasticStack& stack, std::size_t layer)
{
  double top = 0.0;
  for (std::size_t j = 0; j < layer; ++j)
    top += stack.layers[j].thickness;
  return top;
}

TEST(Stack, IsTheOracle)
{
  const test::OracleTable oracle("stack_oracle.csv");
  for (std::size_t row = 0; row < oracle.size(); ++row)
  {
    const ElasticStack& stack = stacks().at(oracle.text(row, "stack"));
    const double k = oracle.number(row, "k");
    const std::string& name = oracle.text(row, "load");
    const WaveLoad load = name == "pressure" ? loads[0] : name == "along" ? loads[1] : loads[2];
    const auto layer = static_cast<std::size_t>(oracle.number(row, "layer"));
    const double depth = top_of(stack, layer) + oracle.number(row, "depth_in_layer");
    const StackWave wave(stack, k);
    const auto field = wave.field_of(load);
    const WaveStress s = wave.stress(load, field, layer, depth);
    const auto u = wave.displacement(load, field, layer, depth);
    const auto number = [&](const char* column) { return oracle.number(row, column); };
    // Deep below short waves everything is far below the values at the surface, of which the rounding errors are a part.
    const double rounding = 1e-13, size = std::max(1.0 / k, 1.0);
    const std::string where =
        oracle.text(row, "stack") + ' ' + name + " k " + oracle.text(row, "k") + " layer " + oracle.text(row, "layer");
    if (load == WaveLoad::across)
    {
      EXPECT_NEAR(u[2], number("v0"), rounding * 10.0 * size) << where;
      EXPECT_NEAR(s.tz, number("v1"), rounding * 10.0) << where;
      EXPECT_NEAR(s.lt, number("v2"), rounding * 100.0) << where;
      continue;
    }
    const double sign = load == WaveLoad::along ? -1.0 : 1.0; // of a factor i twice
    EXPECT_NEAR(-u[0], number("v0"), rounding * 10.0 * size) << where;
    EXPECT_NEAR(u[1], number("v1"), rounding * 10.0 * size) << where;
    EXPECT_NEAR(sign * s.lz, number("v2"), rounding * 10.0) << where;
    EXPECT_NEAR(s.zz, number("v3"), rounding * 10.0) << where;
    EXPECT_NEAR(s.ll, number("v4"), rounding * 100.0) << where;
  }
}

TEST(Stack, OfOneMaterialIsTheHalfSpace)
{
  const Elastic steel{210e9, 0.3};
  const ElasticStack layered{{{1e-6, steel}, {3e-6, steel}}, steel}, whole{{}, steel};
  const double mu = steel.shear_modulus(), nu = 0.3;
  for (const double k : {1e-3, 1.0, 1e4, 1e6, 1e8})
  {
    const StackWave one(layered, k), other(whole, k);
    const WaveCompliance c = one.compliance();
    EXPECT_NEAR(c.normal * mu * k / (1.0 - nu), 1.0, 1e-13);
    EXPECT_NEAR(c.along * mu * k / (1.0 - nu), 1.0, 1e-13);
    EXPECT_NEAR(c.across * mu * k, 1.0, 1e-13);
    EXPECT_NEAR(c.coupling * 2.0 * mu * k / (1.0 - 2.0 * nu), -1.0, 1e-13);
    for (const WaveLoad load : loads)
      for (const double depth : {0.0, 0.5e-6, 2e-6, 9e-6})
      {
        const WaveStress a = one.stress(load, one.field_of(load), layered.layer_at(depth), depth);
        const WaveStress b = other.stress(load, other.field_of(load), 0, depth);
        for (const auto part :
             {&WaveStress::ll, &WaveStress::tt, &WaveStress::zz, &WaveStress::lz, &WaveStress::lt, &WaveStress::tz})
          EXPECT_NEAR(a.*part, b.*part, 1e-13) << k << ' ' << depth;
      }
  }
}

TEST(Stack, WavesOfAHalfSpaceAreThoseOfTheClosedForm)
{
  // Johnson 1985, section 13.2: see halfspace/traction/traction_stress.cpp.
  const StackWave wave({{}, {1.0, 0.3}}, 2.0);
  const double z = 0.4, kz = 0.8, e = std::exp(-kz);
  const WaveStress p = wave.stress(WaveLoad::pressure, wave.field_of(WaveLoad::pressure), 0, z);
  EXPECT_NEAR(p.ll, -(1.0 - kz) * e, 1e-15);
  EXPECT_NEAR(p.zz, -(1.0 + kz) * e, 1e-15);
  EXPECT_NEAR(p.tt, -0.6 * e, 1e-15);
  EXPECT_NEAR(p.lz, kz * e, 1e-15);
  const WaveStress q = wave.stress(WaveLoad::along, wave.field_of(WaveLoad::along), 0, z);
  EXPECT_NEAR(q.ll, (2.0 - kz) * e, 1e-15);
  EXPECT_NEAR(q.zz, kz * e, 1e-15);
  EXPECT_NEAR(q.tt, 0.6 * e, 1e-15);
  EXPECT_NEAR(q.lz, -(1.0 - kz) * e, 1e-15);
  const WaveStress t = wave.stress(WaveLoad::across, wave.field_of(WaveLoad::across), 0, z);
  EXPECT_NEAR(t.lt, e, 1e-15);
  EXPECT_NEAR(t.tz, -e, 1e-15);
}

TEST(Stack, IsContinuousAtInterfacesAndLoadedAtTheSurface)
{
  for (const auto& [name, stack] : stacks())
    for (const double k : {1e-4, 0.03, 1.0, 7.0, 60.0})
      for (const WaveLoad load : loads)
      {
        const StackWave wave(stack, k);
        const auto field = wave.field_of(load);
        const WaveStress s = wave.stress(load, field, 0, 0.0);
        EXPECT_NEAR(s.zz, load == WaveLoad::pressure ? -1.0 : 0.0, 1e-12) << name;
        EXPECT_NEAR(s.lz, load == WaveLoad::along ? -1.0 : 0.0, 1e-12) << name;
        EXPECT_NEAR(s.tz, load == WaveLoad::across ? -1.0 : 0.0, 1e-12) << name;
        for (std::size_t j = 0; j < stack.layers.size(); ++j)
        {
          const double z = top_of(stack, j + 1);
          const auto above = wave.displacement(load, field, j, z);
          if (j + 1 == stack.layers.size() && stack.substrate.is_rigid())
          {
            for (const double u : above)
              EXPECT_NEAR(u * k, 0.0, 1e-12) << name;
            continue;
          }
          const auto below = wave.displacement(load, field, j + 1, z);
          for (std::size_t i = 0; i < 3; ++i)
            EXPECT_NEAR(above[i] * k, below[i] * k, 1e-12) << name << ' ' << k;
          const WaveStress a = wave.stress(load, field, j, z), b = wave.stress(load, field, j + 1, z);
          EXPECT_NEAR(a.zz, b.zz, 1e-12) << name << ' ' << k;
          EXPECT_NEAR(a.lz, b.lz, 1e-12) << name << ' ' << k;
          EXPECT_NEAR(a.tz, b.tz, 1e-12) << name << ' ' << k;
        }
      }
}

TEST(Stack, IsReciprocalAndStoresEnergy)
{
  for (const auto& [name, stack] : stacks())
    for (const double k : {1e-3, 0.2, 1.0, 5.0, 100.0})
    {
      const StackWave wave(stack, k);
      const WaveCompliance c = wave.compliance();
      // Betti: u_z of a unit shear along l and u_l of a unit pressure are one number.
      EXPECT_NEAR(wave.displacement(WaveLoad::along, wave.field_of(WaveLoad::along), 0, 0.0)[1], c.coupling,
                  1e-12 * c.normal)
          << name << ' ' << k;
      EXPECT_GT(c.normal, 0.0);
      EXPECT_GT(c.normal * c.along, c.coupling * c.coupling);
      EXPECT_GT(c.across, 0.0);
    }
}

TEST(Stack, HasTheLimitsOfThickAndThinLayers)
{
  const Elastic coat{4.0, 0.2}, body{1.0, 0.3};
  const auto normal = [&](double thickness, double k) {
    return StackWave({{{thickness, coat}}, body}, k).compliance().normal;
  };
  const auto alone = [](const Elastic& e, double k) { return (1.0 - e.poisson_ratio) / (e.shear_modulus() * k); };
  EXPECT_NEAR(normal(20.0, 1.0) / alone(coat, 1.0), 1.0, 1e-13); // e^{-40} of the wave returns
  EXPECT_NEAR(normal(800.0, 1.0) / alone(coat, 1.0), 1.0, 1e-13);
  // A thin layer adds an amount proportional to its thickness.
  const double first = normal(1e-5, 1.0) / alone(body, 1.0) - 1.0, second = normal(2e-5, 1.0) / alone(body, 1.0) - 1.0;
  EXPECT_LT(std::abs(first), 1e-4);
  EXPECT_NEAR(second / first, 2.0, 1e-3);
  // A thin compressible layer on a rigid base is compressed uniaxially: (1 - 2 nu) / (2 mu (1 - nu)) h.
  const ElasticStack bed{{{1e-4, coat}}, {rigid, 0.0}};
  EXPECT_NEAR(StackWave(bed, 1.0).compliance().normal,
              1e-4 * (1.0 - 2.0 * 0.2) / (2.0 * coat.shear_modulus() * (1.0 - 0.2)), 1e-11);
}

TEST(Stack, DividedLayersAreTheSameBody)
{
  const Elastic coat{4.0, 0.2}, body{1.0, 0.3};
  const ElasticStack one{{{1.0, coat}}, body};
  ElasticStack many{{}, body};
  for (int n = 0; n < 50; ++n)
    many.layers.push_back({0.02, coat});
  for (const double k : {0.01, 1.0, 30.0})
    EXPECT_NEAR(StackWave(many, k).compliance().normal / StackWave(one, k).compliance().normal, 1.0, 1e-12);
}

TEST(Stack, MeanStressIsTheIntegral)
{
  const ElasticStack& stack = stacks().at("three_layers");
  const StackWave wave(stack, 2.0);
  for (const WaveLoad load : loads)
  {
    const auto field = wave.field_of(load);
    const double from = 0.3, to = 0.5;
    // Simpson's rule with 100 intervals: its error is (width / 100)^4 times the fourth derivative, below 1e-11.
    double lz = 0.0, ll = 0.0, lt = 0.0;
    for (int i = 0; i <= 100; ++i)
    {
      const WaveStress s = wave.stress(load, field, 1, from + (to - from) * i / 100.0);
      const double weight = (i == 0 || i == 100 ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) / 300.0;
      lz += weight * s.lz;
      ll += weight * s.ll;
      lt += weight * s.lt;
    }
    const WaveStress mean = wave.mean_stress(load, field, 1, from, to);
    EXPECT_NEAR(mean.lz, lz, 1e-10);
    EXPECT_NEAR(mean.ll, ll, 1e-10);
    EXPECT_NEAR(mean.lt, lt, 1e-10);
  }
}

TEST(Stack, IsThinnedFromTheTop)
{
  const Elastic hard{400e9, 0.2}, soft{80e9, 0.35}, steel{210e9, 0.3};
  const ElasticStack stack{{{2.0, hard}, {1.0, soft}}, steel};
  EXPECT_EQ(stack.without_top(0.0), stack);
  EXPECT_EQ(stack.without_top(0.5), (ElasticStack{{{1.5, hard}, {1.0, soft}}, steel}));
  EXPECT_EQ(stack.without_top(2.0), (ElasticStack{{{1.0, soft}}, steel}));
  EXPECT_EQ(stack.without_top(2.25), (ElasticStack{{{0.75, soft}}, steel}));
  EXPECT_EQ(stack.without_top(7.0), (ElasticStack{{}, steel}));
}

TEST(Stack, ComplianceChangesByWhatIsTakenOff)
{
  const Elastic hard{400e9, 0.2}, steel{210e9, 0.3};
  const ElasticStack bare{{}, steel}, coated{{{1.0, hard}}, steel};
  EXPECT_EQ(change_of_compliance(coated, coated, 0.01, 100.0), 0.0);
  // Short waves feel one of the two half spaces.
  const auto compliance = [](const Elastic& e) { return (1.0 - e.poisson_ratio * e.poisson_ratio) / e.young_modulus; };
  EXPECT_NEAR(change_of_compliance(coated, bare, 0.01, 100.0), compliance(steel) / compliance(hard) - 1.0, 1e-9);
  EXPECT_NEAR(change_of_compliance(bare, coated, 0.01, 100.0), compliance(hard) / compliance(steel) - 1.0, 1e-9);
  // Far below the thickness, a thinner coat changes nothing; in proportion to what is lost elsewhere.
  EXPECT_NEAR(change_of_compliance(coated, coated.without_top(0.1), 40.0, 100.0), 0.0, 1e-9);
  const double one = change_of_compliance(coated, coated.without_top(0.01), 0.01, 100.0),
               two = change_of_compliance(coated, coated.without_top(0.02), 0.01, 100.0);
  EXPECT_GT(one, 1e-3);
  EXPECT_NEAR(two / one, 2.0, 0.03);
}

TEST(Stack, RefusesWhatIsNoStack)
{
  const Elastic steel{210e9, 0.3};
  EXPECT_THROW(StackWave({{{0.0, steel}}, steel}, 1.0), InputError);
  EXPECT_THROW(StackWave({{{1.0, {rigid, 0.3}}}, steel}, 1.0), InputError);
  EXPECT_THROW(StackWave({{{1.0, {1.0, 0.5}}}, steel}, 1.0), InputError);
  EXPECT_THROW(StackWave({{}, {rigid, 0.3}}, 1.0), InputError);
}

} // namespace
} // namespace brinell::green::stack_test
