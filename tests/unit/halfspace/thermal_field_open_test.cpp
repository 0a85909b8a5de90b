// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/symmetry.hpp"
#include "brinell/halfspace/thermal_field.hpp"
#include "brinell/halfspace/thermal_response.hpp"

#include "grid_fields.hpp"
#include "heated_body.hpp"
#include "mirrored_grid.hpp"
#include "random_field.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

/// What heat does to an elastic half space without ends.
namespace brinell::halfspace::thermal_field_open_test
{
namespace
{

constexpr double pi = std::numbers::pi;
constexpr auto open = Boundary::open;
constexpr auto periodic = Boundary::periodic;
using test::displacement_of;
using test::Field;
using Layer = test::HeatedLayer;
using test::largest_difference;
using test::layer_of;
using test::over_past;
using test::over_wavenumbers;

const Thermal& body = test::heated_body;
const Elastic& elastic = test::heated_elastic;
const double kappa = body.diffusivity(), nu = elastic.poisson_ratio;

/// Flux that ends at the edges, where images are nearest; smoothly, as waves of cells ring at a jump: the grid, the motion, and how far heat has spread, in cells.
struct Filled
{
  SurfaceGrid grid;
  double spread, shift;
};

class FluxEverywhere : public testing::TestWithParam<Filled>
{
protected:
  /// Of one step; it smoothly ends at the edges.
  [[nodiscard]] static Field flux(int step)
  {
    const SurfaceGrid& g = GetParam().grid;
    const auto ends = [](int i, int count, bool is_periodic) {
      return is_periodic ? 1.0 + 0.3 * std::sin(2.0 * pi * i / count) : std::pow(std::sin(pi * (i + 0.5) / count), 2);
    };
    return test::sampled(
        g, [&](int i, int j)
        { return (1.0 + 0.5 * std::cos(0.2 * i + step)) * ends(i, g.nx, false) * ends(j, g.ny, g.is_periodic_y()); });
  }
  /// Displacements along z and x and the stress in two layers on the cells of the grid, which may lie within a larger one.
  [[nodiscard]] std::array<Field, 4> fields(int around_x, int around_y) const
  {
    const auto& [own, spread, shift] = GetParam();
    SurfaceGrid g = own;
    g.nx += 2 * around_x;
    g.ny += 2 * around_y;
    const double duration = std::pow(spread * g.dx, 2) / kappa;
    ThermalField field(g, body, elastic, {duration, 3.0 * duration}, {0.0, 5.0 * g.dx});
    for (int n = 0; n < 3; ++n)
    {
      const Field inner = flux(n);
      Field heat(g.size());
      for (int j = 0; j < own.ny; ++j)
        for (int i = 0; i < own.nx; ++i)
          heat[g.index(i + around_x, j + around_y)] = inner[own.index(i, j)];
      field.add_step(heat, {duration, shift * g.dx / duration});
    }
    const auto cut = [&](const auto& whole)
    { return test::sampled(own, [&](int i, int j) { return whole(g.index(i + around_x, j + around_y)); }); };
    Field z(g.size()), x(g.size());
    field.displacement({z, x, {}});
    const Layer surface = layer_of(field, 0), below = layer_of(field, 1);
    return {
        cut([&](std::size_t n) { return z[n]; }), cut([&](std::size_t n) { return x[n]; }),
        cut([&](std::size_t n) { return surface.stress[n][0] + 2.0 * surface.stress[n][5]; }),
        cut([&](std::size_t n) { return below.stress[n][2] + 2.0 * below.stress[n][0] + 3.0 * below.stress[n][4]; })};
  }
};

TEST_P(FluxEverywhere, ImagesAreTakenOff)
{
  const SurfaceGrid& g = GetParam().grid;
  const std::array<Field, 4> own = fields(0, 0);
  const std::array<Field, 4> within = fields(g.is_periodic_x() ? 0 : g.nx, g.is_periodic_y() ? 0 : g.ny);
  std::printf("spread %.3g shift %.2g:", GetParam().spread, GetParam().shift);
  for (std::size_t f = 0; f < own.size(); ++f)
  {
    const double error = largest_difference(own[f], within[f]) / test::largest(within[f < 2 ? 0 : 2]);
    std::printf(" %.1e", error);
    EXPECT_LT(error, 1e-3);
  }
  std::printf("\n");
}

TEST_P(FluxEverywhere, LastStepIsAResponse)
{
  // What remains of the steps before and the response to the flux of the last one are the displacement at its end: by other lattices.
  const auto& [g, spread, shift] = GetParam();
  const double duration = std::pow(spread * g.dx, 2) / kappa;
  const HeatMotion motion{duration, shift * g.dx / duration};
  ThermalField field(g, body, elastic, {duration, 3.0 * duration});
  for (int n = 0; n < 2; ++n)
    field.add_step(flux(n), motion);
  const Field last = flux(2);
  std::array<Field, 3> remaining, sum, whole;
  for (std::array<Field, 3>* displacement : {&remaining, &sum, &whole})
    displacement->fill(Field(g.size()));
  field.displacement({remaining[0], remaining[1], remaining[2]}, duration);
  const ThermalResponse response(g, body, elastic, motion, {}, Displacements::all);
  ThermalResponse::Scratch scratch = response.make_scratch();
  response.apply(last, {sum[0], sum[1], sum[2]}, scratch);
  field.add_step(last, motion);
  field.displacement({whole[0], whole[1], whole[2]});
  std::printf("response:");
  for (std::size_t part = 0; part < sum.size(); ++part)
  {
    for (std::size_t n = 0; n < g.size(); ++n)
      sum[part][n] += remaining[part][n];
    const double error = largest_difference(sum[part], whole[part]) / test::largest(whole[0]);
    std::printf(" %.1e", error);
    EXPECT_LT(error, 5e-4) << "part " << part;
  }
  std::printf("\n");
}

const SurfaceGrid square{24, 24, 0.1, 0.1}, strip{24, 12, 0.1, 0.1, open, periodic},
    plane{24, 1, 0.1, 0.1, open, periodic};
INSTANTIATE_TEST_SUITE_P(All, FluxEverywhere,
                         testing::Values(Filled{square, 0.5, 0}, Filled{square, 2, 0}, Filled{square, 6, 0},
                                         Filled{square, 12, 0}, Filled{square, 30, 0}, Filled{square, 300, 0},
                                         Filled{square, 1, 5}, Filled{{48, 12, 0.1, 0.1}, 5, 0}, Filled{strip, 0.5, 0},
                                         Filled{strip, 3, 0}, Filled{strip, 30, 0}, Filled{plane, 1, 0},
                                         Filled{plane, 10, 0}, Filled{plane, 300, 0}));

/// A Gaussian flux exp(-r^2/w^2) in the middle of a grid, and how far its heat has spread in the end.
struct Spot
{
  SurfaceGrid grid;
  double width;  ///< w
  double spread; ///< sqrt(kappa t)
  int steps;
};

class HeatedSpot : public testing::TestWithParam<Spot>
{
protected:
  [[nodiscard]] ThermalField heated(std::vector<double> depths) const
  {
    const Spot& spot = GetParam();
    const double duration = spot.spread * spot.spread / kappa;
    const Field flux = test::sampled(
        spot.grid, [&](int i, int j)
        { return std::exp(-(std::pow(spot.grid.x(i), 2) + std::pow(spot.grid.y(j), 2)) / (spot.width * spot.width)); });
    ThermalField field(spot.grid, body, elastic, {duration / spot.steps, duration}, std::move(depths));
    for (int n = 0; n < spot.steps; ++n)
      field.add_step(flux, {duration / spot.steps});
    return field;
  }
};

TEST_P(HeatedSpot, DisplacementIsThatOfAHalfSpace)
{
  const auto& [g, w, spread, steps] = GetParam();
  const Field result = displacement_of(heated({}));
  const double time = spread * spread / kappa;
  // Integral of the sources over the time, erfc(k sqrt(kappa t)) in closed form, by Hankel's transform: absolute values.
  const auto exact = [&](double r)
  {
    const auto wave = [&](double k)
    {
      const double a = k * spread;
      const double grown = a < 1e-3 ? time * (1.0 - 4.0 * a / (3.0 * std::sqrt(pi)))
                                    : time * std::erfc(a) + (std::erf(a) - 2.0 * a / std::sqrt(pi) * std::exp(-a * a)) /
                                                                (2.0 * kappa * k * k);
      return 0.5 * w * w * k * std::exp(-0.25 * k * k * w * w) * grown;
    };
    return -2.0 * (1.0 + nu) * body.expansion * kappa / body.conductivity * over_wavenumbers(w, r, wave);
  };
  double error = 0.0;
  const double largest = exact(0.0);
  for (const int i : {0, g.nx / 4, g.nx / 2})
    for (const int j : {0, g.ny / 2})
      error = std::max(error, std::abs(result[g.index(i, j)] - exact(std::hypot(g.x(i), g.y(j)))));
  std::printf("w %.2g spread %.3g, %d steps: %.1e of %.3g\n", w, spread, steps, error / std::abs(largest), largest);
  EXPECT_LT(error, 1e-3 * std::abs(largest));
}

TEST_P(HeatedSpot, TemperatureInTheBody)
{
  const auto& [g, w, spread, steps] = GetParam();
  const std::vector<double> depths{0.25 * w, 1.5 * w, 4.0 * w};
  const ThermalField field = heated(depths);
  // Carslaw and Jaeger (1959), section 10.2, over the Gaussian.
  const auto exact = [&](double r, double z)
  {
    return kappa / body.conductivity *
           over_past(spread * spread / kappa,
                     [&](double t)
                     {
                       const double wide = w * w + 4.0 * kappa * t;
                       return w * w / wide * std::exp(-r * r / wide - z * z / (4.0 * kappa * t)) /
                              std::sqrt(pi * kappa * t);
                     });
  };
  for (std::size_t n = 0; n < depths.size(); ++n)
  {
    const Layer layer = layer_of(field, n);
    double error = 0.0;
    for (const int i : {0, g.nx / 4, g.nx / 2})
      error = std::max(error, std::abs(layer.temperature[g.index(i, g.ny / 2)] -
                                       exact(std::hypot(g.x(i), g.y(g.ny / 2)), depths[n])));
    std::printf("spread %.3g depth %.2g: %.1e\n", spread, depths[n], error / exact(0.0, 0.0));
    EXPECT_LT(error, 1e-4 * exact(0.0, 0.0));
  }
}

TEST_P(HeatedSpot, StressIsThatOnALargerGrid)
{
  // On a grid three times as large images are nine and more times as far away, and 27 times as small.
  const auto& [g, w, spread, steps] = GetParam();
  Spot larger = GetParam();
  larger.grid.nx = 3 * g.nx;
  larger.grid.ny = 3 * g.ny;
  const double duration = spread * spread / kappa;
  const auto stress = [&](const SurfaceGrid& grid)
  {
    const Field flux =
        test::sampled(grid, [&, width = w](int i, int j)
                      { return std::exp(-(grid.x(i) * grid.x(i) + grid.y(j) * grid.y(j)) / (width * width)); });
    ThermalField field(grid, body, elastic, {duration, duration}, {0.0, w});
    field.add_step(flux, {duration});
    return std::pair{layer_of(field, 0), layer_of(field, 1)};
  };
  const auto own = stress(g), reference = stress(larger.grid);
  const double largest = elastic.young_modulus * body.expansion * test::largest(own.first.temperature);
  double error = 0.0;
  for (int j = 0; j < g.ny; ++j)
    for (int i = 0; i < g.nx; ++i)
      for (std::size_t c = 0; c < 6; ++c)
      {
        const std::size_t here = g.index(i, j), there = larger.grid.index(i + g.nx, j + g.ny);
        error = std::max({error, std::abs(own.first.stress[here][c] - reference.first.stress[there][c]),
                          std::abs(own.second.stress[here][c] - reference.second.stress[there][c])});
      }
  std::printf("spread %.3g: stress %.1e of E alpha T\n", spread, error / largest);
  EXPECT_LT(error, 1e-3 * largest);
}

TEST_P(HeatedSpot, CoarseImagesAreNearFineOnes)
{
  const auto& [g, w, spread, steps] = GetParam();
  const double duration = spread * spread / kappa;
  const Field flux =
      test::sampled(g, [&, grid = g, width = w](int i, int j)
                    { return std::exp(-(grid.x(i) * grid.x(i) + grid.y(j) * grid.y(j)) / (width * width)); });
  const auto heated_with = [&, grid = g, width = w](HeatImages images)
  {
    ThermalField field(grid, body, elastic, {duration, duration}, {0.0, width}, images);
    field.add_step(flux, {duration});
    return field;
  };
  const ThermalField fine = heated_with(HeatImages::fine), coarse = heated_with(HeatImages::coarse);
  const Field u = displacement_of(fine);
  const double of_displacement = largest_difference(u, displacement_of(coarse)) / test::largest(u);
  double of_stress = 0.0;
  const double stress = elastic.young_modulus * body.expansion * test::largest(layer_of(fine, 0).temperature);
  for (const std::size_t layer : {0U, 1U})
  {
    const Layer a = layer_of(fine, layer), b = layer_of(coarse, layer);
    for (std::size_t i = 0; i < a.stress.size(); ++i)
      for (std::size_t c = 0; c < 6; ++c)
        of_stress = std::max(of_stress, std::abs(a.stress[i][c] - b.stress[i][c]) / stress);
  }
  std::printf("spread %.3g, coarse images: displacement %.1e, stress %.1e\n", spread, of_displacement, of_stress);
  EXPECT_LT(of_displacement, 3e-4);
  EXPECT_LT(of_stress, 3e-4);
}

/// Half of the waves tell all of a flux that is even: every field, of steps that are taken up, amended, stored and gone back to.
TEST(ThermalField, OneSideTellsAll)
{
  for (const SurfaceGrid& g :
       {SurfaceGrid{40, 9, 0.1, 0.1}, SurfaceGrid{12, 41, 0.1, 0.1}, SurfaceGrid{12, 8, 0.1, 0.1},
        SurfaceGrid{12, 9, 0.1, 0.1, open, periodic}, SurfaceGrid{8, 6, 0.1, 0.1, periodic, open},
        SurfaceGrid{8, 6, 0.1, 0.1, periodic, periodic}})
  {
    Field flux = test::random_field(g.size(), 3), more = test::random_field(g.size(), 4);
    for (Field* field : {&flux, &more})
      complete_in_y(g, 1.0, field->data(), field->size());
    const HeatMotion motion{0.3 / kappa, 0.2 * kappa};
    const auto heated = [&](bool is_mirrored)
    {
      ThermalField field(test::mirrored(g, is_mirrored), body, elastic, {motion.duration, 4.0 * motion.duration},
                         {0.05, 0.3, 0.0}, HeatImages::coarse);
      field.add_step(flux, motion);
      field.add_step(flux, motion);
      field.add_to_last_step(more, motion);
      return field;
    };
    ThermalField one_side = heated(true);
    const ThermalField both = heated(false);
    EXPECT_THROW(one_side.add_step(flux, {motion.duration, 0.0, 1.0}), InputError);
    // Rounding, of fields some of which are much smaller than what they are summed from.
    constexpr double rounding = 1e-12;
    Field a(g.size()), b(g.size());
    for (const double duration : {0.0, 1.5 * motion.duration})
    {
      const double largest = test::largest(displacement_of(both));
      std::array<Field, 3> of_one, of_both;
      for (auto* fields : {&of_one, &of_both})
        for (Field& field : *fields)
          field.resize(g.size());
      one_side.displacement({of_one[0], of_one[1], of_one[2]}, duration);
      both.displacement({of_both[0], of_both[1], of_both[2]}, duration);
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_LT(largest_difference(of_one[c], of_both[c]), rounding * largest) << g.ny << " rows, displacement " << c;
      if (duration == 0.0)
        continue;
      one_side.remaining_temperature(duration, a);
      both.remaining_temperature(duration, b);
      EXPECT_LT(largest_difference(a, b), rounding * test::largest(b)) << g.ny << " rows";
    }
    for (const std::size_t layer : {0U, 1U, 2U})
    {
      const Layer of_one = layer_of(one_side, layer), of_both = layer_of(both, layer);
      const double largest = test::largest(of_both.temperature);
      EXPECT_LT(largest_difference(of_one.temperature, of_both.temperature), rounding * largest);
      const double unit = elastic.young_modulus * body.expansion * largest;
      double error = 0.0;
      for (std::size_t i = 0; i < of_one.stress.size(); ++i)
        for (std::size_t c = 0; c < 6; ++c)
          error = std::max(error, std::abs(of_one.stress[i][c] - of_both.stress[i][c]));
      EXPECT_LT(error, rounding * unit) << g.ny << " rows, layer " << layer;
    }
  }
}

// The flux is 1e-5 of the largest at the edges.
const SurfaceGrid cells{40, 40, 0.1, 0.1};
INSTANTIATE_TEST_SUITE_P(All, HeatedSpot,
                         testing::Values(Spot{cells, 0.6, 0.02, 2}, Spot{cells, 0.6, 0.2, 5}, Spot{cells, 0.6, 1.0, 5},
                                         Spot{cells, 0.6, 4.0, 20}, Spot{{40, 61, 0.1, 0.07}, 0.6, 30.0, 20},
                                         Spot{cells, 0.6, 300.0, 3}));

} // namespace
} // namespace brinell::halfspace::thermal_field_open_test
