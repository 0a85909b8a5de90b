// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/halfspace/thermal_field.hpp"
#include "gauss.hpp"
#include "grid_fields.hpp"
#include "heated_body.hpp"
#include "mirrored_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

/// Heat that arises in the layers of a half space.
namespace brinell::halfspace::buried_heat_test
{
namespace
{

constexpr double pi = std::numbers::pi;
constexpr auto open = Boundary::open;
constexpr auto periodic = Boundary::periodic;
using test::displacement_of;
using test::Field;
using test::Gauss;
using test::layer_of;

const Thermal& body = test::heated_body; // rho c = 4
const Elastic& elastic = test::heated_elastic;
const double kappa = body.diffusivity(), nu = elastic.poisson_ratio, capacity = body.density * body.specific_heat;

std::vector<double> middles(int count, double thickness)
{
  std::vector<double> depths;
  for (int k = 0; k < count; ++k)
    depths.push_back((k + 0.5) * thickness);
  return depths;
}

/// Share in [a, b] of what was even in [c, d] a time before and has spread along a line, of a unit in all.
double passed(double a, double b, double c, double d, double time)
{
  const double width = std::sqrt(4.0 * kappa * time);
  const auto integral = [width](double x) // of (1 + erf(x/width))/2
  {
    const double u = x / width;
    return 0.5 * width * (u * std::erf(u) + std::exp(-u * u) / std::sqrt(pi));
  };
  return (integral(b - c) - integral(a - c) - integral(b - d) + integral(a - d)) / (d - c);
}

/// Mean rise of a layer under an insulated surface (Carslaw and Jaeger 1959, section 10.10, and its image).
double mean_rise(double a, double b, double c, double d, double time)
{
  return (passed(a, b, c, d, time) + passed(a, b, -d, -c, time)) / (b - a);
}

TEST(BuriedHeat, HeatOfALayerSpreadsInDepth)
{
  // Heat arises evenly over the first of four steps, between the depths of 0.5 and 1.
  const SurfaceGrid g{2, 2, 1.0, 1.0, periodic, periodic};
  const double step = 0.1;
  std::vector<double> errors;
  for (const int fine : {1, 2, 4})
  {
    const int layers = 8 * fine;
    const double h = 0.25 / fine;
    ThermalField field(g, body, elastic, {step, 4.0 * step}, middles(layers, h), HeatImages::fine, {layers, h});
    std::vector<double> heat(static_cast<std::size_t>(layers) * g.size(), 0.0);
    for (int k = 2 * fine; k < 4 * fine; ++k)
      std::fill_n(heat.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(k) * g.size()), g.size(), 3.0);
    const std::vector<double> none(heat.size(), 0.0);
    const Field no_flux(g.size(), 0.0);
    double error = 0.0;
    for (int n = 0; n < 4; ++n)
    {
      field.add_heat_in_body(n == 0 ? heat : none, step);
      field.add_step(no_flux, {step});
      // All of it is there: a layer that cannot expand along the surface is lifted by alpha (1 + nu)/(1 - nu) times it.
      EXPECT_NEAR(displacement_of(field).front(), -body.expansion * (1.0 + nu) / (1.0 - nu) * 1.5 / capacity, 1e-12);
    }
    for (int k = 0; k < layers; ++k)
    {
      double exact = 0.0;
      const Gauss since(12, 3.0 * step, 4.0 * step);
      for (std::size_t q = 0; q < since.point.size(); ++q)
        exact += since.weight[q] / step * 1.5 / capacity * mean_rise(k * h, (k + 1) * h, 0.5, 1.0, since.point[q]);
      error = std::max(error, std::abs(layer_of(field, static_cast<std::size_t>(k)).temperature.front() - exact));
    }
    errors.push_back(error);
  }
  EXPECT_LT(errors[2], 2e-3 * 1.5 / capacity);
  EXPECT_GT(errors[0] / errors[1], 3.6); // second order
  EXPECT_GT(errors[1] / errors[2], 3.6);
}

/// In layers of that thickness.
void expect_heat_stays(HeatImages images, double thickness)
{
  Thermal slow = body;
  slow.conductivity = 1e-9 * thickness;
  const SurfaceGrid g{9, 7, 0.2, 0.2, open, open};
  const int layers = 6;
  ThermalField field(g, slow, elastic, {0.1, 1.0}, middles(layers, thickness), images, {layers, thickness});
  std::vector<double> heat(static_cast<std::size_t>(layers) * g.size(), 0.0), sum(heat);
  for (int n = 0; n < 5; ++n)
  {
    for (std::size_t i = 0; i < heat.size(); ++i)
    {
      heat[i] = i % 7 == static_cast<std::size_t>(n) ? 2.0 : 0.0;
      sum[i] += heat[i] / capacity;
    }
    field.add_heat_in_body(heat, 0.1);
    field.add_step(Field(g.size(), 0.0), {0.1});
  }
  for (std::size_t k = 0; k < static_cast<std::size_t>(layers); ++k)
  {
    const test::HeatedLayer layer = layer_of(field, k);
    for (std::size_t i = 0; i < g.size(); ++i)
      EXPECT_NEAR(layer.temperature[i], sum[k * g.size() + i], 1e-7);
  }
}

TEST(BuriedHeat, WhatDoesNotConductStaysWhereItArises)
{
  expect_heat_stays(HeatImages::fine, 0.2);
  expect_heat_stays(HeatImages::coarse, 0.2);
  expect_heat_stays(HeatImages::coarse, 0.002); // images of one layer for all of them
}

/// A cube that warms for a time, in an open half space: erf products over x, y and z with the image (Carslaw and Jaeger 1959,
/// section 10.3), integrated over the time.
double rise_of_cuboid(double x, double y, double z, double half, double top, double bottom, double power,
                      double duration)
{
  const auto along = [](double at, double from, double to, double width)
  { return 0.5 * (std::erf((to - at) / width) - std::erf((from - at) / width)); };
  double sum = 0.0, last = 0.0;
  const double end = std::sqrt(duration);
  for (double next = 1e-3 * end; last < end; next *= 1.5)
  {
    const Gauss root(8, last, std::min(next, end));
    for (std::size_t q = 0; q < root.point.size(); ++q)
    {
      const double t = root.point[q] * root.point[q], width = std::sqrt(4.0 * kappa * t);
      sum += root.weight[q] * 2.0 * root.point[q] * along(x, -half, half, width) * along(y, -half, half, width) *
             (along(z, top, bottom, width) + along(z, -bottom, -top, width));
    }
    last = next;
  }
  return sum * power / capacity;
}

TEST(BuriedHeat, CubeInAnOpenHalfSpace)
{
  // Heat spreads over 0.2, 1.5 and 12 times the width of the grid.
  const double width = 2.0;
  for (const double duration : {0.08, 4.5, 288.0})
  {
    std::vector<double> errors;
    for (const int fine : {1, 2})
    {
      const int cells = 16 * fine, layers = 8 * fine;
      const double h = width / cells;
      const SurfaceGrid g{cells, cells, h, h, open, open};
      const int steps = 4;
      ThermalField field(g, body, elastic, {duration / steps, duration}, middles(layers, h), HeatImages::fine,
                         {layers, h});
      std::vector<double> heat(static_cast<std::size_t>(layers) * g.size(), 0.0);
      for (int k = 2 * fine; k < 4 * fine; ++k)
        for (int j = 6 * fine; j < 10 * fine; ++j)
          for (int i = 6 * fine; i < 10 * fine; ++i)
            heat[static_cast<std::size_t>(k) * g.size() + g.index(i, j)] = 5.0 * duration / steps;
      for (int n = 0; n < steps; ++n)
      {
        field.add_heat_in_body(heat, duration / steps);
        field.add_step(Field(g.size(), 0.0), {duration / steps});
      }
      double error = 0.0, largest = 0.0;
      for (int k = 0; k < layers; ++k)
      {
        const Field T = layer_of(field, static_cast<std::size_t>(k)).temperature;
        for (const int j : {0, cells / 2, cells - 3})
          for (int i = 0; i < cells; i += fine)
          {
            const double exact = rise_of_cuboid((i + 0.5) * h - 0.5 * width, (j + 0.5) * h - 0.5 * width, (k + 0.5) * h,
                                                0.25, 0.25, 0.5, 5.0, duration);
            largest = std::max(largest, exact);
            error = std::max(error, std::abs(T[g.index(i, j)] - exact));
          }
      }
      errors.push_back(error / largest);
      Field surface(g.size(), 0.0);
      field.add_temperature_of_body(surface);
      const double exact = rise_of_cuboid(0.5 * h, 0.5 * h, 0.0, 0.25, 0.25, 0.5, 5.0, duration);
      EXPECT_NEAR(surface[g.index(cells / 2, cells / 2)] / exact, 1.0, fine == 1 ? 0.1 : 0.03) << duration;
    }
    // The cube has four, and eight, cells along an edge, and two, and four, layers: second order, to the images.
    EXPECT_LT(errors[1], 0.02) << duration;
    EXPECT_GT(errors[0] / errors[1], 3.4) << duration;
  }
}

TEST(BuriedHeat, LiftsTheSurfaceAsNucleiOfStrain)
{
  // Mindlin and Cheng (1950): 2 (1 + nu) alpha Q/(rho c) z/(2 pi R^3).
  Thermal slow = body;
  slow.conductivity = 1e-9;
  const int cells = 24;
  const double h = 0.1;
  const SurfaceGrid g{cells, cells, h, h, open, open};
  for (const HeatImages images : {HeatImages::fine, HeatImages::coarse})
  {
    ThermalField field(g, slow, elastic, {1.0, 1.0}, middles(8, h), images, {8, h});
    std::vector<double> heat(8 * g.size(), 0.0);
    const double sigma = 0.2;
    const auto place = [&](int i) { return (i - 11.5) * h; };
    for (int j = 0; j < cells; ++j)
      for (int i = 0; i < cells; ++i)
        heat[5 * g.size() + g.index(i, j)] =
            std::exp(-0.5 * (place(i) * place(i) + place(j) * place(j)) / (sigma * sigma)) /
            (2.0 * pi * sigma * sigma * h);
    field.add_heat_in_body(heat, 1.0);
    field.add_step(Field(g.size(), 0.0), {1.0});
    const Field u = displacement_of(field);
    double error = 0.0, largest = 0.0;
    for (int j = 0; j < cells; j += 3)
      for (int i = 0; i < cells; ++i)
      {
        const double r = std::hypot(place(i), place(j));
        const auto of_wave = [&](double k)
        {
          return k / (2.0 * pi) * std::exp(-0.5 * k * k * sigma * sigma) *
                 (std::exp(-k * 5 * h) - std::exp(-k * 6 * h)) / (k * h);
        };
        const double exact = -2.0 * (1.0 + nu) * body.expansion / capacity * test::over_wavenumbers(sigma, r, of_wave);
        largest = std::max(largest, std::abs(exact));
        error = std::max(error, std::abs(u[g.index(i, j)] - exact));
      }
    EXPECT_LT(error, 3e-5 * largest);
  }
}

TEST(BuriedHeat, GoesBackAndGoesOn)
{
  const SurfaceGrid g{12, 9, 0.2, 0.3, open, open};
  const auto make = [&](bool is_mirrored)
  {
    return ThermalField(test::mirrored(g, is_mirrored), body, elastic, {0.05, 1.0}, middles(5, 0.1), HeatImages::fine,
                        {5, 0.1});
  };
  const auto heat_of = [&](int n)
  {
    std::vector<double> heat(5 * g.size(), 0.0);
    for (int k = 1; k < 4; ++k)
      for (int j = 0; j < g.ny; ++j)
        for (int i = 0; i < g.nx; ++i)
          heat[static_cast<std::size_t>(k) * g.size() + g.index(i, j)] =
              std::exp(-0.3 * ((i - 4 - n) * (i - 4 - n) + (j - 4) * (j - 4))) * k;
    return heat;
  };
  const Field none(g.size(), 0.0);
  ThermalField straight = make(false), back = make(false), mirrored = make(true);
  for (int n = 0; n < 3; ++n)
  {
    back.add_heat_in_body(heat_of(7), 0.2);
    back.restore_heat_in_body();
    for (ThermalField* field : {&straight, &back, &mirrored})
    {
      field->add_heat_in_body(heat_of(n), 0.05);
      field->add_step(none, {0.05});
    }
    Archive stored;
    back.exchange(stored);
    back = make(false);
    Archive taken(stored.fields());
    back.exchange(taken);
  }
  const Field u = displacement_of(straight);
  const double most = -*std::min_element(u.begin(), u.end());
  EXPECT_LT(test::largest_difference(u, displacement_of(back)), 1e-13 * most);
  EXPECT_LT(test::largest_difference(u, displacement_of(mirrored)), 1e-12 * most);
  for (std::size_t k = 0; k < 5; ++k)
  {
    const Field T = layer_of(straight, k).temperature;
    EXPECT_LT(test::largest_difference(T, layer_of(back, k).temperature), 1e-13);
    EXPECT_LT(test::largest_difference(T, layer_of(mirrored, k).temperature), 1e-12);
  }
}

TEST(BuriedHeat, DeeperLayersThanPlannedKeepTheirHeat)
{
  const SurfaceGrid g{4, 4, 1.0, 1.0, periodic, periodic};
  ThermalField field(g, body, elastic, {0.1, 1.0}, middles(6, 0.25), HeatImages::fine, {3, 0.25});
  field.add_heat_in_body(std::vector<double>(6 * g.size(), 2.0), 0.1); // twice as many
  field.add_step(Field(g.size(), 0.0), {0.1});
  EXPECT_NEAR(displacement_of(field).front(), -body.expansion * (1.0 + nu) / (1.0 - nu) * 2.0 * 1.5 / capacity, 1e-12);
}

TEST(BuriedHeat, InAThinSkinItIsAFluxThroughTheSurface)
{
  // What has arisen evenly in the first layer differs little after a while from what has entered through the surface.
  const int cells = 16, layers = 24;
  const double h = 0.05, d = 0.25, step = 0.2;
  const SurfaceGrid g{cells, cells, d, d, open, open};
  ThermalField through(g, body, elastic, {step, 4.0}, middles(layers, h));
  ThermalField inside(g, body, elastic, {step, 4.0}, middles(layers, h), HeatImages::fine, {layers, h});
  const auto flux =
      test::sampled(g, [&](int i, int j) { return std::exp(-0.2 * ((i - 9) * (i - 9) + 1.5 * (j - 7) * (j - 7))); });
  const Field none(g.size(), 0.0);
  std::vector<double> heat(static_cast<std::size_t>(layers) * g.size(), 0.0), nothing(heat);
  for (std::size_t i = 0; i < g.size(); ++i)
    heat[i] = flux[i] * step / h;
  for (int n = 0; n < 10; ++n)
  {
    through.add_step(n < 4 ? flux : none, {step});
    inside.add_heat_in_body(n < 4 ? heat : nothing, step);
    inside.add_step(none, {step});
  }
  const Field u = displacement_of(through), v = displacement_of(inside);
  // The skin is h^2/6 / (4 kappa t) = 2e-4 too deep.
  EXPECT_LT(test::largest_difference(u, v), 2e-3 * -*std::min_element(u.begin(), u.end()));
  for (const std::size_t k : {0, 3, 10, 23})
  {
    const test::HeatedLayer a = layer_of(through, k), b = layer_of(inside, k);
    double error = 0.0, largest = 0.0;
    for (std::size_t i = 0; i < g.size(); ++i)
      for (std::size_t c = 0; c < 6; ++c)
      {
        error = std::max(error, std::abs(a.stress[i][c] - b.stress[i][c]));
        largest = std::max(largest, std::abs(a.stress[i][c]));
      }
    EXPECT_LT(test::largest_difference(a.temperature, b.temperature),
              6e-3 * *std::max_element(a.temperature.begin(), a.temperature.end()))
        << k;
    EXPECT_LT(error, 1.2e-2 * largest) << k;
  }
}

TEST(BuriedHeat, ImagesOfThickerLayers)
{
  // Images are at least 80 layers away, and taken off with those of four times the thickness: to what coarse images promise.
  constexpr double promised = 3e-4;
  const int cells = 16, layers = 24;
  const double h = 0.05;
  const SurfaceGrid g{cells, cells, 0.25, 0.25, open, open};
  const auto make = [&](HeatImages images) {
    return ThermalField(g, body, elastic, {1.0, 40.0}, middles(layers, h), images, {layers, h});
  };
  ThermalField all = make(HeatImages::fine), thick = make(HeatImages::coarse);
  std::vector<double> heat(static_cast<std::size_t>(layers) * g.size(), 0.0);
  for (std::size_t k = 3; k < 11; ++k)
    for (int j = 5; j < 11; ++j)
      for (int i = 3; i < 10; ++i)
        heat[k * g.size() + g.index(i, j)] = 1.0 + 0.1 * static_cast<double>(k);
  for (const double duration : {1.0, 39.0}) // heat spreads over half and over three times the width of the grid
  {
    for (ThermalField* field : {&all, &thick})
    {
      field->add_heat_in_body(heat, duration);
      field->add_step(Field(g.size(), 0.0), {duration});
    }
    const Field u = displacement_of(all);
    EXPECT_LT(test::largest_difference(u, displacement_of(thick)), -promised * *std::min_element(u.begin(), u.end()));
    double largest = 0.0, error = 0.0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(layers); k += 3)
    {
      const Field T = layer_of(all, k).temperature;
      largest = std::max(largest, *std::max_element(T.begin(), T.end()));
      error = std::max(error, test::largest_difference(T, layer_of(thick, k).temperature));
    }
    EXPECT_LT(error, promised * largest);
  }
  Archive of_all, of_thick;
  all.exchange(of_all);
  thick.exchange(of_thick);
  EXPECT_EQ(of_thick.fields().at("body0").size(), of_all.fields().at("body0").size());
  EXPECT_LT(of_thick.fields().at("body1").size(), 0.5 * static_cast<double>(of_all.fields().at("body1").size()));
}

} // namespace
} // namespace brinell::halfspace::buried_heat_test
