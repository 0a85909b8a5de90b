// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/thermal_field.hpp"

#include "brinell/foundation/error.hpp"
#include "gauss.hpp"
#include "grid_fields.hpp"
#include "heated_body.hpp"
#include "mirrored_grid.hpp"
#include "random_field.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

/// What heat does to an elastic half space, wave by wave.
namespace brinell::halfspace::thermal_field_test
{
namespace
{

constexpr double pi = std::numbers::pi;
constexpr auto open = Boundary::open;
constexpr auto periodic = Boundary::periodic;
using test::displacement_of;
using test::Field;
using Layer = test::HeatedLayer;
using test::Gauss;
using test::largest_difference;
using test::layer_of;
using test::over_past;

const Thermal& body = test::heated_body;
const Elastic& elastic = test::heated_elastic;
const double kappa = body.diffusivity(), nu = elastic.poisson_ratio;

TEST(ThermalField, UniformHeatInAPeriod)
{
  const SurfaceGrid g{6, 4, 0.3, 0.4, periodic, periodic};
  ThermalField field(g, body, elastic, {0.1, 1.0}, {0.0, 0.2, 1.0, 4.0});
  const Field flux(g.size(), 3.0);
  for (int n = 0; n < 10; ++n)
    field.add_step(flux, {0.1, 0.4, 0.1});
  // A layer that cannot expand along the surface: alpha (1 + nu)/(1 - nu) times the heat in it over rho c.
  const double rise = body.expansion * (1.0 + nu) / (1.0 - nu) * 3.0 / 4.0;
  EXPECT_NEAR(displacement_of(field).back(), -rise, 1e-12);
  for (std::size_t n = 0; n < field.depths().size(); ++n)
  {
    // Carslaw and Jaeger (1959), section 2.9.
    const double x = field.depths()[n] / (2.0 * std::sqrt(kappa));
    const double T = 3.0 / 2.0 * 2.0 * std::sqrt(kappa) * (std::exp(-x * x) / std::sqrt(pi) - x * std::erfc(x));
    const Layer layer = layer_of(field, n);
    // The waves in depth are good to some 1e-5 of the temperature of the surface, 1.2.
    EXPECT_NEAR(layer.temperature[3], T, 3e-5) << x;
    const SymTensor& stress = layer.stress[3];
    const double plane = -elastic.young_modulus * body.expansion / (1.0 - nu) * layer.temperature[3];
    EXPECT_NEAR(stress[0], plane, 1e-12);
    EXPECT_NEAR(stress[1], plane, 1e-12);
    for (int c = 2; c < 6; ++c)
      EXPECT_NEAR(stress[static_cast<std::size_t>(c)], 0.0, 1e-12);
  }
}

/// One wave of flux, cos(kx x + ky y), over a surface that is periodic.
struct OneWave
{
  SurfaceGrid grid{24, 24, 2.0 * pi / 24, pi / 24, periodic, periodic};
  double kx = 1.0, ky = 2.0, k = std::sqrt(5.0);
  [[nodiscard]] Field flux(double phase = 0.0) const
  {
    return test::sampled(grid, [&](int i, int j) { return std::cos(kx * i * grid.dx + ky * j * grid.dy - phase); });
  }
};

TEST(ThermalField, DisplacementOfOneWaveIsThatOfNucleiOfStrain)
{
  // A nucleus at the depth z lifts the surface by 2 (1 + nu) alpha z/(2 pi R^3) (Mindlin and Cheng 1950), one wave of them by
  // 2 (1 + nu) alpha e^{-kz}; z and the time integrated by Gauss's rule.
  const OneWave wave;
  const double duration = 0.02;
  for (const int steps : {1, 3, 60})
  {
    ThermalField field(wave.grid, body, elastic, {duration, steps * duration});
    for (int n = 0; n < steps; ++n)
      field.add_step(wave.flux(), {duration});
    const auto left = [&](double t)
    {
      const double length = std::sqrt(kappa * t);
      const Gauss z(40, 0.0, 14.0 * length);
      double sum = 0.0;
      for (std::size_t n = 0; n < z.point.size(); ++n)
        sum += z.weight[n] * std::exp(-wave.k * z.point[n] - std::pow(0.5 * z.point[n] / length, 2));
      return kappa / body.conductivity * std::exp(-kappa * wave.k * wave.k * t) / (std::sqrt(pi) * length) * sum;
    };
    const double exact = -2.0 * (1.0 + nu) * body.expansion * over_past(steps * duration, left);
    // Waves in depth that hardly decay are counted as if they did not: 3e-6.
    EXPECT_NEAR(displacement_of(field).front() / exact, 1.0, 1e-5) << steps;
  }
}

TEST(ThermalField, StressOfOneWaveIsInEquilibriumAndCompatible)
{
  const OneWave wave;
  // Amplitudes: those of xz and yz are where the cosine of all others is zero.
  const double spacing = 0.05, quarter = 0.25 * 2.0 * pi / wave.kx;
  const std::size_t crest = 0, flank = wave.grid.index(static_cast<int>(std::lround(quarter / wave.grid.dx)), 0);
  for (const double depth : {0.15, 0.5, 1.2})
  {
    ThermalField field(wave.grid, body, elastic, {0.05, 0.5}, {depth - spacing, depth, depth + spacing});
    for (int n = 0; n < 10; ++n)
      field.add_step(wave.flux(), {0.05});
    std::vector<SymTensor> s;
    std::vector<double> T;
    for (std::size_t n = 0; n < 3; ++n)
    {
      const Layer layer = layer_of(field, n);
      SymTensor amplitude = layer.stress[crest];
      amplitude[3] = layer.stress[flank][3]; // of sin(kx x + ky y)
      amplitude[4] = layer.stress[flank][4];
      s.push_back(amplitude);
      T.push_back(layer.temperature[crest]);
    }
    const auto slope = [&](std::size_t c) { return (s[2][c] - s[0][c]) / (2.0 * spacing); };
    const auto bend = [&](double a, double b, double c) { return (a - 2.0 * b + c) / (spacing * spacing); };
    // Central differences: (k h)^2/6 = 2e-3 of a term.
    const double E_alpha = elastic.young_modulus * body.expansion;
    const double unit = 4e-3 * E_alpha * T[1] * wave.k;
    EXPECT_NEAR(-wave.kx * s[1][0] - wave.ky * s[1][5] + slope(4), 0.0, unit);
    EXPECT_NEAR(-wave.kx * s[1][5] - wave.ky * s[1][1] + slope(3), 0.0, unit);
    EXPECT_NEAR(wave.kx * s[1][4] + wave.ky * s[1][3] + slope(2), 0.0, unit);
    // Beltrami and Michell, with heat: lap(s_ij) + tr(s),ij/(1 + nu) = -E alpha [T,ij/(1 + nu) + delta_ij lap(T)/(1 - nu)].
    std::array<double, 3> f{};
    for (std::size_t n = 0; n < 3; ++n)
      f[n] = (trace(s[n]) + E_alpha * T[n]) / (1.0 + nu);
    const double k2 = wave.k * wave.k, lap_T = bend(T[0], T[1], T[2]) - k2 * T[1];
    const double f_slope = (f[2] - f[0]) / (2.0 * spacing);
    const std::array<double, 6> second{-wave.kx * wave.kx * f[1], -wave.ky * wave.ky * f[1], bend(f[0], f[1], f[2]),
                                       -wave.ky * f_slope,        -wave.kx * f_slope,        -wave.kx * wave.ky * f[1]};
    for (std::size_t c = 0; c < 6; ++c)
    {
      const double lap = bend(s[0][c], s[1][c], s[2][c]) - k2 * s[1][c];
      const double heat = c < 3 ? E_alpha * lap_T / (1.0 - nu) : 0.0;
      EXPECT_NEAR(lap + second[c] + heat, 0.0, unit * wave.k) << depth << " " << c;
    }
  }
}

TEST(ThermalField, SurfaceIsFreeOfTraction)
{
  for (const Boundary boundary : {open, periodic})
  {
    const SurfaceGrid g{20, 15, 0.1, 0.12, boundary, open};
    ThermalField field(g, body, elastic, {0.01, 0.1}, {0.0});
    for (unsigned n = 0; n < 4; ++n)
      field.add_step(test::random_field(g.size(), n), {0.01, 5.0});
    for (const double later : {0.0, 0.02})
      for (const SymTensor& stress : layer_of(field, 0, later).stress)
        for (const std::size_t c : {2U, 3U, 4U})
          EXPECT_NEAR(stress[c], 0.0, 1e-12);
  }
}

TEST(ThermalField, StepsOfOneFluxAreOneStep)
{
  const SurfaceGrid g{20, 16, 0.1, 0.12};
  const Field flux = test::random_field(g.size(), 3);
  const HeatTimes times{0.02, 0.12};
  ThermalField two(g, body, elastic, times, {0.0, 0.3}), one(g, body, elastic, times, {0.0, 0.3});
  two.add_step(flux, {0.02});
  two.add_step(flux, {0.04});
  one.add_step(flux, {0.06});
  for (const double later : {0.0, 0.03})
  {
    const Field u = displacement_of(one, later);
    EXPECT_LT(largest_difference(displacement_of(two, later), u), 1e-12 * test::largest(u));
    for (std::size_t n = 0; n < 2; ++n)
    {
      const Layer a = layer_of(one, n, later), b = layer_of(two, n, later);
      EXPECT_LT(largest_difference(a.temperature, b.temperature), 1e-12);
      for (std::size_t i = 0; i < g.size(); ++i)
        for (std::size_t c = 0; c < 6; ++c)
          EXPECT_NEAR(a.stress[i][c], b.stress[i][c], 1e-12);
    }
  }
}

/// Where depths lie at equal distances, waves decay from one to the next by one product; one by one, each by its own exponential.
TEST(ThermalField, ManyLayersAtOnceAreThoseOneByOne)
{
  const SurfaceGrid g{15, 11, 0.2, 0.25, periodic, periodic}; // without images, which many layers have by interpolation
  std::vector<double> depths;
  depths.reserve(33);
  for (int k = 0; k < 30; ++k)
    depths.push_back((k + 0.5) * 0.1);
  for (const double depth : {0.05, 4.0, 0.0}) // and no longer so
    depths.push_back(depth);
  const std::size_t cells = g.size(), fields = 2 + Deviator::size;
  const Field flux = test::random_field(cells, 5);
  for (const HeatedLayers& heated : {HeatedLayers{}, HeatedLayers{6, 0.1}})
  {
    ThermalField field(g, body, elastic, {0.1, 10.0}, depths, HeatImages::fine, heated);
    if (heated.count > 0)
      field.add_heat_in_body(test::random_field(6 * cells, 8), 0.1);
    field.add_step(flux, {0.1, 2.0});
    Field together(fields * depths.size() * cells), alone(together.size());
    const auto of_layer = [&](Field& all, std::size_t k)
    {
      const std::span<double> part = std::span(all).subspan(k * fields * cells, fields * cells);
      return ThermalLayer{part.first(cells), part.subspan(2 * cells), part.subspan(cells, cells)};
    };
    std::vector<ThermalLayer> layers;
    for (std::size_t k = 0; k < depths.size(); ++k)
    {
      layers.push_back(of_layer(together, k));
      field.layer(k, of_layer(alone, k));
    }
    field.layers(0, layers);
    const auto part = [&](const Field& all, std::size_t k, std::size_t f)
    {
      const auto first = all.begin() + static_cast<std::ptrdiff_t>((k * fields + f) * cells);
      return Field(first, first + static_cast<std::ptrdiff_t>(cells));
    };
    // Depths that are summed together leave out the waves that turn too often at the least of them, 1e-7 each.
    for (std::size_t f = 0; f < fields; ++f)
      for (std::size_t k = 0; k < depths.size(); ++k)
        EXPECT_LT(largest_difference(part(together, k, f), part(alone, k, f)),
                  1e-6 * largest_difference(part(alone, 0, f), Field(cells)))
            << "depth " << depths[k] << ", field " << f << ", layers " << heated.count;
  }
}

/// On fewer cells, in the layout of a body, with images that are interpolated in depth.
TEST(ThermalField, InABodyIsWhatItsLayersHave)
{
  const SurfaceGrid g{15, 11, 0.2, 0.25};
  const VolumeGrid cells_of_body{{9, 7, 0.2, 0.25}, 8, 0.1};
  std::vector<double> depths;
  depths.reserve(12);
  for (int k = 0; k < 12; ++k)
    depths.push_back((k + 0.5) * 0.1);
  Field flux = test::random_field(g.size(), 5);
  for (int j = 0; 2 * j < g.ny; ++j)
    for (int i = 0; i < g.nx; ++i)
      flux[g.index(i, g.ny - 1 - j)] = flux[g.index(i, j)];
  for (const bool is_mirrored : {false, true})
  {
    ThermalField field(test::mirrored(g, is_mirrored), body, elastic, {0.1, 10.0}, depths, HeatImages::coarse);
    field.add_step(flux, {0.1, 2.0});
    EXPECT_FALSE(field.holds({17, 7, 0.2, 0.25}));
    EXPECT_FALSE(field.holds({8, 7, 0.2, 0.25}));
    ASSERT_TRUE(field.holds(cells_of_body.surface));
    const std::size_t size = cells_of_body.size(), in_layer = g.size();
    Field temperature(size), deviator(Deviator::size * size), trace(size);
    field.in_body(cells_of_body, {temperature, deviator, trace});
    std::vector<Field> whole(static_cast<std::size_t>(cells_of_body.nz), Field((2 + Deviator::size) * in_layer));
    std::vector<ThermalLayer> layers;
    for (Field& layer : whole)
      layers.push_back({std::span(layer).first(in_layer), std::span(layer).subspan(2 * in_layer),
                        std::span(layer).subspan(in_layer, in_layer)});
    field.layers(0, layers);
    for (int k = 0; k < cells_of_body.nz; ++k)
      for (int j = 0; j < 7; ++j)
        for (int i = 0; i < 9; ++i)
        {
          const std::size_t at = cells_of_body.index(i, j, k), there = g.index(i + 3, j + 2);
          const ThermalLayer& layer = layers[static_cast<std::size_t>(k)];
          EXPECT_DOUBLE_EQ(temperature[at], layer.temperature[there]);
          EXPECT_DOUBLE_EQ(trace[at], layer.trace[there]);
          for (std::size_t c = 0; c < Deviator::size; ++c)
            EXPECT_DOUBLE_EQ(deviator[c * size + at], layer.deviator[c * in_layer + there]) << c;
        }
    EXPECT_GT(largest_difference(deviator, Field(deviator.size())), 0.0);
  }
  ThermalField field(g, body, elastic, {0.1, 10.0}, depths);
  EXPECT_THROW(field.in_body({{8, 7, 0.2, 0.25}, 8, 0.1}, {}), InternalError);
  EXPECT_THROW(field.in_body({{9, 7, 0.2, 0.25}, 13, 0.1}, {}), InternalError);
}

TEST(ThermalField, WhatCannotBe)
{
  const SurfaceGrid g{4, 4, 0.1, 0.1};
  Field f(g.size());
  EXPECT_THROW(ThermalField(g, body, elastic, {0.1, 1.0}, {-0.1}), InputError);
  EXPECT_THROW(ThermalField(g, body, elastic, {0.1, 0.05}), InputError);
  EXPECT_THROW(ThermalField(g, body, {std::numeric_limits<double>::infinity(), 0.3}, {0.1, 1.0}, {0.0}), InputError);
  ThermalField field(g, body, elastic, {0.1, 1.0}, {0.1});
  EXPECT_THROW(field.displacement({f, {}, {}}, 0.05), InputError);
  EXPECT_THROW(field.layer(1, {f, {}, {}}), InternalError);
  EXPECT_THROW(field.layer(0, {{}, f, {}}), InternalError);
  field.add_step(f, {0.9});
  EXPECT_THROW(field.add_step(f, {0.2}), InputError);
  EXPECT_NEAR(field.time(), 0.9, 1e-15);
}

TEST(ThermalField, RemembersAsMuchAfterManyStepsAsAfterOne)
{
  const SurfaceGrid g{12, 8, 0.25, 0.25};
  ThermalField field(g, test::heated_body, test::heated_elastic, {0.1, 50.0}, {0.1, 0.4});
  const std::vector<double> flux(g.size(), 1.0);
  const auto numbers = [&]
  {
    Archive archive;
    field.exchange(archive);
    std::size_t count = 0;
    for (const auto& [name, values] : archive.fields())
      count += values.size();
    return count;
  };
  field.add_step(flux, {0.1, 1.0});
  const std::size_t after_one = numbers();
  for (int step = 1; step < 500; ++step)
    field.add_step(flux, {0.1, 1.0});
  EXPECT_EQ(numbers(), after_one);
  EXPECT_GT(after_one, g.size());
}

} // namespace
} // namespace brinell::halfspace::thermal_field_test
