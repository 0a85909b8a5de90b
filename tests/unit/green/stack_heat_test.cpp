// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/green/stack_strain.hpp"
#include "green/stack_heat.hpp"

#include "gauss.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

/// One wave of heat in a stack, and what it does to it.
namespace brinell::green::stack_heat_test
{
namespace
{

using Complex = std::complex<double>;

constexpr Thermal slow{2.0, 2.0, 1.0, 0.3}, fast{7.0, 1.0, 2.0, 0.5}, base{3.0, 2.0, 0.5, 0.2};
const ThermalStack thermal{{{0.7, slow}, {0.4, fast}}, base};
const ElasticStack elastic{{{0.7, {5.0, 0.2}}, {0.4, {2.0, 0.4}}}, {3.0, 0.3}};
const double reference = slow.diffusivity();

/// Derivative along z within a layer, by differences of fourth order.
Complex slope(const StackHeat& heat, std::size_t layer, double depth)
{
  constexpr double h = 1e-3;
  const auto at = [&](double z) { return heat.at(layer, z); };
  return (8.0 * (at(depth + h) - at(depth - h)) - (at(depth + 2.0 * h) - at(depth - 2.0 * h))) / (12.0 * h);
}

TEST(StackHeat, IsConducted)
{
  for (const Complex rate : {Complex{0.3, 0.0}, Complex{-2.0, 3.0}, Complex{40.0, 20.0}})
  {
    const double k = 1.3;
    const StackHeat heat(thermal, k, rate, reference);
    EXPECT_LT(std::abs(heat.at(0, 0.0) - heat.at_surface()), 1e-14 * std::abs(heat.at_surface()));
    EXPECT_LT(std::abs(slow.conductivity * slope(heat, 0, 0.0) + 1.0), 1e-9);
    double depth = 0.0;
    for (std::size_t n = 0; n < 2; ++n)
    {
      depth += thermal.layers[n].thickness;
      EXPECT_LT(std::abs(heat.at(n, depth) - heat.at(n + 1, depth)), 1e-14);
      EXPECT_LT(std::abs(thermal.of_layer(n).conductivity * slope(heat, n, depth) -
                         thermal.of_layer(n + 1).conductivity * slope(heat, n + 1, depth)),
                1e-9);
    }
    // The time of the wave runs as e^{(rate - kappa k^2) t}: T'' = (k^2 + p/kappa) T in each layer.
    const Complex p = rate - reference * k * k;
    for (const auto& [layer, z] : {std::pair{0, 0.3}, {1, 0.9}, {2, 1.6}})
    {
      constexpr double h = 1e-3;
      const auto at = [&](double depth_of) { return heat.at(static_cast<std::size_t>(layer), depth_of); };
      const Complex bent = (at(z + h) - 2.0 * at(z) + at(z - h)) / (h * h);
      const Complex expected = (k * k + p / thermal.of_layer(static_cast<std::size_t>(layer)).diffusivity()) * at(z);
      EXPECT_LT(std::abs(bent - expected), 1e-4 * std::abs(heat.at_surface()) * (1.0 + std::norm(rate)));
    }
    const StackHeat half_space({{}, slow}, k, rate, reference);
    EXPECT_LT(std::abs(heat.at_surface() - half_space.at_surface() - heat.excess_at_surface()), 1e-14);
  }
}

/// Stress and displacement by thin slices of the thermal strain, each of which is a strain of a stack that exists for itself.
struct Slices
{
  StrainedField at_depth, at_surface;

  Slices(const StackWave& wave, const StackHeat& heat, std::size_t layer, double depth)
  {
    double top = 0.0;
    for (std::size_t n = 0; n < 3; ++n)
    {
      const double bottom = n < 2 ? top + thermal.layers[n].thickness : top + 30.0 / wave.wavenumber();
      // The field has a kink at the depth where it is wanted.
      std::vector<double> ends{top, bottom};
      if (n == layer)
        ends = {top, depth, bottom};
      for (std::size_t e = 0; e + 1 < ends.size(); ++e)
        for (double from = ends[e], to = 0.0; from < ends[e + 1]; from = to)
        {
          to = std::min(ends[e + 1], from + 0.5 / std::max(1.0, wave.wavenumber()));
          const test::Gauss z(12, from, to);
          for (std::size_t g = 0; g < z.point.size(); ++g)
          {
            // Temperatures are real for a real rate.
            const double strain = z.weight[g] * thermal.of_layer(n).expansion * heat.at(n, z.point[g]).real();
            const auto sheet = StackStrain::sheet(wave, n, z.point[g], {.ll = strain, .tt = strain, .zz = strain});
            add(sheet.at(layer, depth), at_depth);
            add(sheet.at(0, 0.0), at_surface);
          }
        }
      top = bottom;
    }
  }
  static void add(const StrainedField& field, StrainedField& sum)
  {
    sum.ll += field.ll;
    sum.tt += field.tt;
    sum.zz += field.zz;
    sum.lz += field.lz;
    sum.u_l += field.u_l;
    sum.u_z += field.u_z;
  }
};

TEST(StackHeat, ExpandsAsItsSlices)
{
  for (const double k : {0.2, 1.0, 4.0})
    for (const double rate : {0.05, 2.0})
    {
      const StackHeat heat(thermal, k, rate, reference);
      const StackWave wave(elastic, k);
      StackExpansion expansion(elastic, thermal, k);
      const std::vector<std::pair<std::size_t, double>> depths{{0, 0.0}, {0, 0.2}, {1, 0.9}, {2, 1.5}};
      for (const auto& [layer, depth] : depths)
        expansion.add_depth(layer, depth);
      std::vector<StackExpansion::Stress> stresses;
      StackExpansion::Displacement moved;
      expansion.find(heat, stresses, moved);
      const double unit = 5.0 * 0.5 * std::abs(heat.at_surface());
      for (std::size_t d = 0; d < depths.size(); ++d)
      {
        const auto& [layer, depth] = depths[d];
        const Slices slices(wave, heat, layer, depth);
        // The sheets do not contain the stress within themselves: of a strain held in its plane.
        const Elastic& body = elastic.of_layer(layer);
        const double held = body.young_modulus * thermal.of_layer(layer).expansion * heat.at(layer, depth).real() /
                            (1.0 - body.poisson_ratio);
        EXPECT_LT(std::abs(stresses[d].temperature - heat.at(layer, depth)), 1e-14);
        EXPECT_LT(std::abs(stresses[d].ll - (slices.at_depth.ll - held)), 1e-9 * unit) << k << " " << depth;
        EXPECT_LT(std::abs(stresses[d].zz - slices.at_depth.zz), 1e-9 * unit) << k << " " << depth;
        EXPECT_LT(std::abs(Complex{0.0, 1.0} * stresses[d].lz - slices.at_depth.lz), 1e-9 * unit) << k << " " << depth;
        const Complex tt = body.poisson_ratio * (stresses[d].ll + stresses[d].zz) -
                           body.young_modulus * thermal.of_layer(layer).expansion * stresses[d].temperature;
        EXPECT_LT(std::abs(tt - (slices.at_depth.tt - held)), 1e-9 * unit) << k << " " << depth;
        EXPECT_LT(std::abs(moved.z - slices.at_surface.u_z), 1e-9 * unit);
        EXPECT_LT(std::abs(Complex{0.0, -1.0} * moved.l - slices.at_surface.u_l), 1e-9 * unit);
      }
      EXPECT_LT(std::abs(stresses[0].zz) + std::abs(stresses[0].lz), 1e-12 * unit); // the surface is free
    }
}

TEST(StackHeat, RootOfTheHeatMayBeThatOfTheStress)
{
  // A particular solution in T/p would be infinite at p = 0.
  const double k = 1.3, rate = reference * k * k;
  std::vector<StackExpansion::Stress> at, beside;
  StackExpansion::Displacement moved_at, moved_beside;
  StackExpansion expansion(elastic, thermal, k);
  expansion.add_depth(1, 0.9);
  expansion.find(StackHeat(thermal, k, rate, reference), at, moved_at);
  expansion.find(StackHeat(thermal, k, rate * (1.0 + 1e-7), reference), beside, moved_beside);
  EXPECT_LT(std::abs(at[0].ll - beside[0].ll), 1e-6 * std::abs(at[0].ll));
  EXPECT_LT(std::abs(at[0].zz - beside[0].zz), 1e-6 * std::abs(at[0].zz));
  EXPECT_LT(std::abs(moved_at.z - moved_beside.z), 1e-6 * std::abs(moved_at.z));
}

} // namespace
} // namespace brinell::green::stack_heat_test
