// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/green/stack_strain.hpp"

#include "brinell/green/eigenstrain_sheet.hpp"
#include "gauss.hpp"
#include "oracle_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

namespace brinell::green::stack_strain_test
{
namespace
{

using Complex = std::complex<double>;
constexpr double rigid = std::numeric_limits<double>::infinity();
constexpr Complex i(0.0, 1.0);

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

struct Range
{
  std::size_t layer;
  double top, thickness;
};

Range layer_of(const ElasticStack& stack, std::size_t layer)
{
  double top = 0.0;
  for (std::size_t j = 0; j < layer; ++j)
    top += stack.layers[j].thickness;
  return {layer, top, layer < stack.layers.size() ? stack.layers[layer].thickness : 1.0};
}

WaveStrain unit(const std::string& component)
{
  WaveStrain e;
  (component == "ll"   ? e.ll
   : component == "tt" ? e.tt
   : component == "zz" ? e.zz
   : component == "lz" ? e.lz
   : component == "lt" ? e.lt
                       : e.tz) = 1.0;
  return e;
}

TEST(StackStrain, IsTheOracle)
{
  const test::OracleTable oracle("stack_strain_oracle.csv");
  for (std::size_t row = 0; row < oracle.size(); ++row)
  {
    const std::string& name = oracle.text(row, "stack");
    const std::string& component = oracle.text(row, "component");
    const ElasticStack& stack = stacks().at(name);
    const auto number = [&](const char* column) { return oracle.number(row, column); };
    const double k = number("k");
    const Range source = layer_of(stack, static_cast<std::size_t>(number("source")));
    const Range target = layer_of(stack, static_cast<std::size_t>(number("layer")));
    const StackWave wave(stack, k);
    const StackStrain strain(wave, source.layer, source.top + number("begin") * source.thickness,
                             source.top + number("end") * source.thickness, unit(component));
    const StrainedField f = strain.at(target.layer, target.top + number("depth_in_layer"));
    // The oracle's lz and lt are times i.
    const Complex turn = component == "lz" || component == "lt" ? i : 1.0;
    const double u = 1e-12 * std::max(1.0, 1.0 / k), s = 1e-11; // moduli up to 10; k times a thickness as small as 2e-3
    const std::string where = name + ' ' + component + " k " + oracle.text(row, "k") + " from " +
                              oracle.text(row, "source") + " in " + oracle.text(row, "layer");
    const auto expect = [&](const Complex& found, double expected, double tolerance, const char* what)
    {
      EXPECT_NEAR(found.real(), expected, tolerance) << what << ' ' << where;
      EXPECT_NEAR(found.imag(), 0.0, tolerance) << what << ' ' << where;
    };
    if (component == "lt" || component == "tz")
    {
      expect(turn * f.u_t, number("v0"), u, "u_t");
      expect(turn * f.tz, number("v1"), s, "tz");
      expect(turn * f.lt / i, number("v2"), s, "lt");
      continue;
    }
    expect(turn * f.u_l / i, number("v0"), u, "u_l");
    expect(turn * f.u_z, number("v1"), u, "u_z");
    expect(turn * f.lz / i, number("v2"), s, "lz");
    expect(turn * f.zz, number("v3"), s, "zz");
    expect(turn * f.ll, number("v4"), s, "ll");
    expect(turn * f.tt, number("v5"), s, "tt");
  }
}

const WaveStrain some{0.7, -0.3, 0.5, 0.4, -0.6, 0.9};
const WaveStrain other{-0.2, 0.8, 0.1, -0.5, 0.3, 0.4};

TEST(StackStrain, IsContinuousAndLeavesTheSurfaceFree)
{
  for (const auto& [name, stack] : stacks())
    for (const double k : {1e-2, 0.3, 2.0, 40.0, 2000.0})
      for (std::size_t source = 0; source < stack.layers.size(); ++source)
      {
        const Range s = layer_of(stack, source);
        const StackWave wave(stack, k);
        const StackStrain strain(wave, source, s.top + 0.3 * s.thickness, s.top + s.thickness, some);
        const StrainedField surface = strain.at(0, 0.0);
        for (const Complex& traction : {surface.zz, surface.lz, surface.tz})
          EXPECT_NEAR(std::abs(traction), 0.0, 1e-12) << name << ' ' << k;
        for (std::size_t j = 0; j < wave.layers().size(); ++j)
        {
          const Range l = layer_of(stack, j);
          const StrainedField above = strain.at(j, l.top + l.thickness);
          if (j + 1 == wave.layers().size())
          {
            for (const Complex& u : {above.u_l, above.u_z, above.u_t})
              EXPECT_NEAR(stack.substrate.is_rigid() ? std::abs(u) * k : 0.0, 0.0, 1e-12) << name << ' ' << k;
            continue;
          }
          const StrainedField below = strain.at(j + 1, l.top + l.thickness);
          for (const auto part : {&StrainedField::u_l, &StrainedField::u_z, &StrainedField::u_t})
            EXPECT_NEAR(std::abs(above.*part - below.*part) * k, 0.0, 1e-12) << name << ' ' << k;
          for (const auto part : {&StrainedField::zz, &StrainedField::lz, &StrainedField::tz})
            EXPECT_NEAR(std::abs(above.*part - below.*part), 0.0, 1e-11) << name << ' ' << k;
        }
      }
}

/// Integral of sigma : strain over a range of depths.
Complex work(const StackStrain& field, const WaveStrain& e, std::size_t layer, double from, double to)
{
  const test::Gauss rule(24, from, to);
  Complex sum{};
  for (std::size_t n = 0; n < rule.point.size(); ++n)
  {
    const StrainedField s = field.at(layer, rule.point[n]);
    sum += rule.weight[n] * (s.ll * e.ll + s.tt * e.tt + s.zz * e.zz + 2.0 * (s.lz * e.lz + s.lt * e.lt + s.tz * e.tz));
  }
  return sum;
}

TEST(StackStrain, TwoStrainsAreReciprocal)
{
  // The work of the stress of one wave on the conjugate of the other: Betti.
  for (const auto& [name, stack] : stacks())
    for (const double k : {0.05, 1.0, 6.0})
      for (std::size_t p = 0; p < stack.layers.size(); ++p)
        for (std::size_t q = 0; q < stack.layers.size(); ++q)
        {
          const Range a = layer_of(stack, p), b = layer_of(stack, q);
          const StackWave wave(stack, k);
          const double a1 = a.top, a2 = a.top + 0.4 * a.thickness, b1 = b.top + 0.5 * b.thickness,
                       b2 = b.top + b.thickness;
          const Complex of_a = work({wave, p, a1, a2, some}, other, q, b1, b2);
          const Complex of_b = work({wave, q, b1, b2, other}, some, p, a1, a2);
          EXPECT_NEAR(std::abs(of_a - std::conj(of_b)), 0.0, 1e-12) << name << ' ' << k << ' ' << p << ' ' << q;
        }
}

TEST(StackStrain, DisplacementOfTheSurfaceIsTheAdjointOfTheStressOfALoad)
{
  for (const auto& [name, stack] : stacks())
    for (const double k : {0.05, 1.0, 6.0})
      for (std::size_t p = 0; p < stack.layers.size(); ++p)
      {
        const Range a = layer_of(stack, p);
        const StackWave wave(stack, k);
        const double from = a.top + 0.2 * a.thickness, to = a.top + 0.9 * a.thickness;
        const StrainedField u = StackStrain(wave, p, from, to, some).at(0, 0.0);
        const auto mean = [&](WaveLoad load) { return wave.mean_stress(load, wave.field_of(load), p, from, to); };
        const WaveStress n = mean(WaveLoad::pressure), l = mean(WaveLoad::along), t = mean(WaveLoad::across);
        const WaveStrain& e = some;
        // The stress of a load that is ahead by a quarter period is conjugated.
        const Complex by_pressure = n.ll * e.ll + n.tt * e.tt + n.zz * e.zz - 2.0 * i * n.lz * e.lz;
        const Complex by_along = -i * (l.ll * e.ll + l.tt * e.tt + l.zz * e.zz) + 2.0 * l.lz * e.lz;
        const Complex by_across = 2.0 * (-i * t.lt * e.lt + t.tz * e.tz);
        const double d = to - from, tolerance = 1e-12 * std::max(1.0, 1.0 / k);
        EXPECT_NEAR(std::abs(u.u_z - d * by_pressure), 0.0, tolerance) << name << ' ' << k << ' ' << p;
        EXPECT_NEAR(std::abs(u.u_l - d * by_along), 0.0, tolerance) << name << ' ' << k << ' ' << p;
        EXPECT_NEAR(std::abs(u.u_t - d * by_across), 0.0, tolerance) << name << ' ' << k << ' ' << p;
      }
}

TEST(StackStrain, LayersOfOneMaterialAreTheHalfSpace)
{
  const Elastic steel{2.0, 0.3};
  const ElasticStack layered{{{0.4, steel}, {0.3, steel}}, steel};
  const double m = 1.2, n = -0.9, k = std::hypot(m, n), z_source = 0.5;
  // Along the wavevector: the axes turned back.
  const Deviator strain{{0.3, 0.2, -0.1, 0.4, 0.25}};
  const double lx = m / k, ly = n / k;
  using D = Deviator;
  const double xx = strain[D::xx], yy = strain[D::yy], xy = strain[D::xy];
  const WaveStrain e{lx * lx * xx + ly * ly * yy + 2.0 * lx * ly * xy,
                     ly * ly * xx + lx * lx * yy - 2.0 * lx * ly * xy,
                     -xx - yy,
                     lx * strain[D::xz] + ly * strain[D::yz],
                     lx * ly * (yy - xx) + (lx * lx - ly * ly) * xy,
                     lx * strain[D::yz] - ly * strain[D::xz]};
  const StackWave wave(layered, k);
  const StackStrain sheet = StackStrain::sheet(wave, 1, z_source, e);
  for (const auto& [layer, z] :
       {std::pair<std::size_t, double>{0, 0.0}, {0, 0.2}, {1, 0.45}, {1, 0.5}, {1, 0.6}, {2, 1.1}})
  {
    const SheetStress expected = eigenstrain_sheet_stress(m, n, z, z_source, strain, steel);
    const StrainedField s = sheet.at(layer, z);
    const Complex trace = s.ll + s.tt + s.zz;
    EXPECT_NEAR(std::abs(trace - expected.trace), 0.0, 1e-14) << z;
    EXPECT_NEAR(
        std::abs(lx * lx * s.ll + ly * ly * s.tt - 2.0 * lx * ly * s.lt - trace / 3.0 - expected.deviator[D::xx]), 0.0,
        1e-14)
        << z;
    EXPECT_NEAR(std::abs(lx * s.lz - ly * s.tz - expected.deviator[D::xz]), 0.0, 1e-14) << z;
    EXPECT_NEAR(std::abs(ly * s.lz + lx * s.tz - expected.deviator[D::yz]), 0.0, 1e-14) << z;
    EXPECT_NEAR(std::abs(lx * ly * (s.ll - s.tt) + (lx * lx - ly * ly) * s.lt - expected.deviator[D::xy]), 0.0, 1e-14)
        << z;
  }
}

} // namespace
} // namespace brinell::green::stack_strain_test
