// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/halfspace/heat_response.hpp"
#include "brinell/halfspace/thermal_field.hpp"
#include "brinell/halfspace/thermal_response.hpp"

#include "coated_heat.hpp"
#include "grid_fields.hpp"
#include "heated_body.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <tuple>
#include <vector>

/// Heat in coated bodies.
namespace brinell::halfspace::coated_heat_test
{
namespace
{

using test::Field;
using test::over_wavenumbers;

constexpr Thermal steel{50.0, 7800.0, 470.0, 12e-6}, carbon{2.0, 2200.0, 900.0, 2e-6},
    gold{318.0, 19300.0, 129.0, 14e-6}, polymer{0.25, 2150.0, 1000.0, 1e-4}, diamond{2000.0, 3500.0, 620.0, 1e-6};
constexpr Elastic of_steel{210e9, 0.3}, of_coat{150e9, 0.2};

ThermalStack stack_of(const Thermal& film, double thickness, const Thermal& base)
{
  return {{{thickness, film}}, base};
}
ElasticStack elastic_of(double thickness)
{
  return {{{thickness, of_coat}}, of_steel};
}

/// A spot of a Gaussian flux of 1 W/m^2 in its middle.
struct Spot
{
  SurfaceGrid grid;
  double width;
  [[nodiscard]] Field flux() const
  {
    return test::sampled(grid, [&](int i, int j)
                         { return std::exp(-(std::pow(grid.x(i), 2) + std::pow(grid.y(j), 2)) / (width * width)); });
  }
  /// Field at a distance from the middle, of a response to a wave of flux.
  template <typename Wave>
  [[nodiscard]] double at(double r, Wave wave) const
  {
    return over_wavenumbers(width, r,
                            [&](double k)
                            { return 0.5 * width * width * k * std::exp(-0.25 * k * k * width * width) * wave(k); });
  }
};

constexpr double cell = 1e-6;
const Spot spot{{41, 41, cell, cell}, 7.0 * cell};

struct Pair
{
  const char* name;
  Thermal film, base;
};
constexpr Pair pairs[] = {
    {"carbon on steel", carbon, steel}, {"gold on steel", gold, steel},
    {"polymer on gold", polymer, gold}, {"steel on polymer", steel, polymer},
    {"gold on polymer", gold, polymer}, {"diamond on polymer", diamond, polymer}}; // from the images heat comes fastest

class Coated : public testing::TestWithParam<Pair>
{
};

/// Largest difference from the expected values at three places.
template <typename Expected>
double error_of(const Field& field, Expected expected)
{
  double error = 0.0;
  for (const int column : {20, 25, 34})
  {
    const double value = expected(spot.grid.x(column));
    error = std::max(error, std::abs(field[spot.grid.index(column, 20)] - value));
  }
  return error;
}

Field rise_of(const HeatResponse& response)
{
  Field rise(spot.grid.size());
  auto scratch = response.make_scratch();
  response.apply(spot.flux(), rise, scratch);
  return rise;
}

TEST_P(Coated, TemperatureOfASpot)
{
  // At once and later, on the surface and in the body, against Hankel's and Laplace's transforms. The errors are those of sums over
  // waves, 1e-5 of each wave.
  for (const double thickness : {0.25 * cell, 3.0 * cell})
    for (const double spread : {0.5, 20.0})
    {
      const ThermalStack stack = stack_of(GetParam().film, thickness, GetParam().base);
      const double time = std::pow(spread * cell, 2) / (4.0 * stack.top().diffusivity());
      const std::vector<double> depths{0.25 * thickness, thickness + 2.0 * cell, 0.0};
      ThermalField field(spot.grid, stack, elastic_of(thickness), {time, 3.0 * time}, depths);
      field.add_step(spot.flux(), {time});
      Field later(spot.grid.size()), upper(spot.grid.size()), lower(spot.grid.size()), surface(spot.grid.size());
      field.remaining_temperature(time, later);
      const std::vector<ThermalLayer> layers{{upper, {}, {}}, {lower, {}, {}}, {surface, {}, {}}};
      field.layers(0, layers);
      Field excess = rise_of(HeatResponse(spot.grid, stack, {time}));
      const Field of_film = rise_of(HeatResponse(spot.grid, stack.top(), {time}));
      for (std::size_t i = 0; i < excess.size(); ++i)
        excess[i] -= of_film[i];
      const auto after = [&](double k, double t, double depth) { return test::coated_wave_after(stack, k, t, depth); };
      // On the surface the flux is uniform in each cell.
      const auto in_cells = [](double k) { return std::exp(-k * k * cell * cell / 24.0); };
      const auto film = [&](double k)
      { return std::erf(k * std::sqrt(stack.top().diffusivity() * time)) / (stack.top().conductivity * k); };
      const double highest = spot.at(0.0, [&](double k) { return after(k, time, 0.0); });
      const double first =
          error_of(excess, [&](double r)
                   { return spot.at(r, [&](double k) { return in_cells(k) * (after(k, time, 0.0) - film(k)); }); });
      const double second =
          error_of(later,
                   [&](double r) {
                     return spot.at(r, [&](double k)
                                    { return in_cells(k) * (after(k, 2.0 * time, 0.0) - after(k, time, 0.0)); });
                   });
      const auto in_depth = [&](double depth)
      { return [&, depth](double r) { return spot.at(r, [&](double k) { return after(k, time, depth); }); }; };
      const double in_film = error_of(upper, in_depth(depths[0])), beneath = error_of(lower, in_depth(depths[1])),
                   at_surface = error_of(surface, in_depth(0.0));
      std::printf("%s, %.2f cells thick, spread over %.1f: excess %.0e, later %.0e, in the film %.0e, beneath %.0e, at "
                  "the surface %.0e\n",
                  GetParam().name, thickness / cell, spread, first / highest, second / highest, in_film / highest,
                  beneath / highest, at_surface / highest);
      for (const double error : {second, in_film, beneath, at_surface})
        EXPECT_LT(error, 1e-4 * highest);
      // Of a quarter of a cell, e^{-2 k h} of the shortest waves of a third of a cell is 1 %.
      EXPECT_LT(first, (thickness < 0.5 * cell ? 2e-3 : 3e-4) * highest);
    }
}

INSTANTIATE_TEST_SUITE_P(Pairs, Coated, testing::ValuesIn(pairs),
                         [](const auto& p)
                         {
                           std::string name = p.param.name;
                           for (char& c : name)
                             c = c == ' ' ? '_' : c;
                           return name;
                         });

/// Displacements along z, x and y.
std::array<Field, 3> displacement_of(const ThermalField& field)
{
  std::array<Field, 3> parts;
  parts.fill(Field(field.grid().size()));
  field.displacement({parts[0], parts[1], parts[2]});
  return parts;
}

double largest_stress_difference(const test::HeatedLayer& one, const test::HeatedLayer& other)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < one.stress.size(); ++i)
    for (std::size_t c = 0; c < 6; ++c)
      largest = std::max(largest, std::abs(one.stress[i][c] - other.stress[i][c]));
  return largest;
}

TEST(CoatedHeat, LayersOfOneMaterialAreTheHalfSpace)
{
  const ThermalStack stack{{{cell, steel}, {2.0 * cell, steel}}, steel};
  const ElasticStack elastic{{{cell, of_steel}, {2.0 * cell, of_steel}}, of_steel};
  const double time = std::pow(4.0 * cell, 2) / (4.0 * steel.diffusivity());
  const HeatMotion motion{time, 2.0 * cell / time};
  const std::vector<double> depths{0.5 * cell, 2.5 * cell, 5.0 * cell};
  ThermalField layered(spot.grid, stack, elastic, {time, 4.0 * time}, depths),
      whole(spot.grid, steel, of_steel, {time, 4.0 * time}, depths);
  for (int n = 0; n < 3; ++n)
    for (ThermalField* field : {&layered, &whole})
      field->add_step(spot.flux(), motion);
  // On the surface only differences from the half space are computed: they are zero.
  EXPECT_EQ(rise_of(HeatResponse(spot.grid, stack, motion)), rise_of(HeatResponse(spot.grid, steel, motion)));
  Field a(spot.grid.size()), b(spot.grid.size());
  layered.remaining_temperature(time, a);
  whole.remaining_temperature(time, b);
  EXPECT_EQ(a, b);
  // In the body and of the displacement the sums are others, as accurate as those of the half space (heat.md, in depth).
  const std::array<Field, 3> u = displacement_of(layered), v = displacement_of(whole);
  for (std::size_t part = 0; part < 3; ++part)
    EXPECT_LT(test::largest_difference(u[part], v[part]), 1e-4 * test::largest(v[0]));
  const double hottest = test::largest(a), stress = of_steel.young_modulus * steel.expansion * hottest;
  for (std::size_t d = 0; d < depths.size(); ++d)
  {
    const auto one = test::layer_of(layered, d), other = test::layer_of(whole, d);
    EXPECT_LT(test::largest_difference(one.temperature, other.temperature), 1e-5 * hottest);
    EXPECT_LT(largest_stress_difference(one, other), 3e-4 * stress); // images are interpolated at other depths
  }
}

/// The fields of a heated body at its surface and at two depths.
struct Heated
{
  Field rise;
  std::array<Field, 3> displacement;
  std::array<test::HeatedLayer, 2> layers;
};

Heated heated(const ThermalStack& thermal, const ElasticStack& elastic, double time, const std::vector<double>& depths)
{
  const HeatMotion motion{time, 2.0 * cell / time};
  ThermalField field(spot.grid, thermal, elastic, {time, 4.0 * time}, depths);
  for (int n = 0; n < 3; ++n)
    field.add_step(spot.flux(), motion);
  const bool is_resolved = thermal.thickness_of_first() > cell;
  return {is_resolved ? rise_of(HeatResponse(spot.grid, thermal, motion)) : Field(),
          displacement_of(field),
          {test::layer_of(field, 0), test::layer_of(field, 1)}};
}

/// @param share  of the largest values by which they may differ
void expect_alike(const Heated& one, const Heated& other, double share)
{
  const double hottest = test::largest(other.layers[0].temperature),
               stress = of_steel.young_modulus * steel.expansion * hottest;
  EXPECT_TRUE(one.rise.empty() || test::largest_difference(one.rise, other.rise) < share * test::largest(other.rise));
  for (std::size_t part = 0; part < 3; ++part)
    EXPECT_LT(test::largest_difference(one.displacement[part], other.displacement[part]),
              share * test::largest(other.displacement[0]));
  for (std::size_t d = 0; d < 2; ++d)
  {
    EXPECT_LT(test::largest_difference(one.layers[d].temperature, other.layers[d].temperature), share * hottest);
    EXPECT_LT(largest_stress_difference(one.layers[d], other.layers[d]), share * stress);
  }
}

TEST(CoatedHeat, ThickLayerIsABodyThinOneIsNone)
{
  const double time = std::pow(4.0 * cell, 2) / (4.0 * steel.diffusivity());
  const std::vector<double> depths{0.5 * cell, 3.0 * cell};
  const Heated whole = heated({{}, steel}, {{}, of_steel}, time, depths);
  // Waves as long as the layer is thick are too long for heat of this time; the elastic ones decrease with the third power.
  const double thick = 200.0 * cell;
  expect_alike(heated(stack_of(steel, thick, carbon), {{{thick, of_steel}}, of_coat}, time, depths), whole, 3e-4);
  const double thin = 1e-4 * cell;
  expect_alike(heated(stack_of(carbon, thin, steel), {{{thin, of_coat}}, of_steel}, time, depths), whole, 1e-3);
}

TEST(CoatedHeat, CellsMustResolveTheFirstLayer)
{
  // A layer of a quarter of a cell is represented; beneath a layer that conducts like the first one it may be thinner.
  const double time = 1e-6, quarter = 0.25 * cell;
  EXPECT_THROW(HeatResponse(spot.grid, stack_of(carbon, 0.99 * quarter, steel), {time}), InputError);
  const ThermalStack two{{{0.5 * quarter, carbon}, {0.5 * quarter, carbon}}, steel};
  EXPECT_LT(test::largest_difference(rise_of(HeatResponse(spot.grid, two, {time})),
                                     rise_of(HeatResponse(spot.grid, stack_of(carbon, quarter, steel), {time}))),
            1e-9 * test::largest(rise_of(HeatResponse(spot.grid, steel, {time}))));
}

TEST(CoatedHeat, StaysInTheBody)
{
  // On a period no heat leaves: its mean over the depth is what has entered. Gauss in each layer.
  SurfaceGrid grid = spot.grid;
  grid.boundary_x = grid.boundary_y = Boundary::periodic;
  const double thickness = 3.0 * cell, time = std::pow(6.0 * cell, 2) / (4.0 * gold.diffusivity());
  const ThermalStack stack = stack_of(gold, thickness, steel);
  std::vector<double> depths, weights;
  for (const auto& [from, to, film] : {std::tuple{0.0, thickness, &gold},
                                       {thickness, 2.0 * thickness, &steel},
                                       {2.0 * thickness, 5.0 * thickness, &steel},
                                       {5.0 * thickness, 14.0 * thickness, &steel}})
  {
    const test::Gauss z(8, from, to);
    for (std::size_t g = 0; g < z.point.size(); ++g)
    {
      depths.push_back(z.point[g]);
      weights.push_back(z.weight[g] * film->density * film->specific_heat * grid.cell_area());
    }
  }
  ThermalField field(grid, stack, elastic_of(thickness), {time, 3.0 * time}, depths);
  double entered = 0.0;
  for (int n = 0; n < 3; ++n)
  {
    field.add_step(spot.flux(), {time, 3.0 * cell / time});
    for (const double q : spot.flux())
      entered += q * grid.cell_area() * time;
  }
  double kept = 0.0;
  for (std::size_t d = 0; d < depths.size(); ++d)
    for (const double rise : test::layer_of(field, d).temperature)
      kept += weights[d] * rise;
  std::printf("heat in the body - heat through the surface: %.1e of it\n", kept / entered - 1.0);
  EXPECT_NEAR(kept, entered, 1e-4 * entered);
}

TEST(CoatedHeat, FilmIsStressedByTheDifferenceOfExpansions)
{
  // A thin film has the strain of what is beneath: E_f (alpha_s - alpha_f) T/(1 - nu_f) more than one that expands alike.
  const double thickness = 0.01 * cell, time = std::pow(30.0 * cell, 2) / (4.0 * steel.diffusivity());
  const auto stress_of = [&](double expansion)
  {
    Thermal film = carbon;
    film.expansion = expansion;
    ThermalField field(spot.grid, stack_of(film, thickness, steel), elastic_of(thickness), {time, time},
                       {0.5 * thickness});
    field.add_step(spot.flux(), {time});
    return test::layer_of(field, 0);
  };
  const auto alike = stress_of(steel.expansion), other = stress_of(carbon.expansion);
  const std::size_t middle = spot.grid.size() / 2;
  const double unit = of_coat.young_modulus * (steel.expansion - carbon.expansion) / (1.0 - of_coat.poisson_ratio);
  const double rise = alike.temperature[middle];
  for (const std::size_t c : {0U, 1U})
  {
    const double more = other.stress[middle][c] - alike.stress[middle][c];
    std::printf("film: %.6f of E (alpha_s - alpha_f) T/(1 - nu)\n", more / (unit * rise));
    EXPECT_NEAR(more, unit * rise, 5e-3 * unit * rise); // the film is as thick as 0.01 cells: waves feel its bending
  }
  // It slides on nothing: the surface is free, and the film is too thin for shear across it.
  EXPECT_LT(std::abs(other.stress[middle][2]), 1e-3 * unit * rise);
}

TEST(CoatedHeat, FastSourceHeatsTheLayerAloneAndASlowOneTheStack)
{
  // While heat has come a tenth of the thickness deep nothing is felt of what is beneath; after a long time the difference between two
  // places is that of the steady state, with the reflected wave of Kohlrausch's layer.
  const double thickness = 4.0 * cell;
  const ThermalStack stack = stack_of(carbon, thickness, steel);
  const double fast = std::pow(0.1 * thickness, 2) / (4.0 * carbon.diffusivity());
  const HeatMotion rushes{fast, 7.0 * cell / fast};
  const Field alone = rise_of(HeatResponse(spot.grid, carbon, rushes));
  EXPECT_LT(test::largest_difference(rise_of(HeatResponse(spot.grid, stack, rushes)), alone),
            1e-6 * test::largest(alone));
  const double slow = std::pow(3000.0 * cell, 2) / (4.0 * steel.diffusivity());
  const Field rise = rise_of(HeatResponse(spot.grid, stack, {slow}));
  const auto steady = [&](double r)
  {
    return spot.at(
        r,
        [&](double k)
        {
          const double share = (carbon.conductivity - steel.conductivity) / (carbon.conductivity + steel.conductivity),
                       wave = share * std::exp(-2.0 * k * thickness);
          return std::exp(-k * k * cell * cell / 24.0) * (1.0 + wave) / (1.0 - wave) / (carbon.conductivity * k);
        });
  };
  const std::size_t middle = spot.grid.index(20, 20), aside = spot.grid.index(35, 20);
  const double expected = steady(0.0) - steady(spot.grid.x(35));
  std::printf("steady difference of the temperature: %.1e off\n", (rise[middle] - rise[aside]) / expected - 1.0);
  EXPECT_NEAR(rise[middle] - rise[aside], expected, 1e-3 * expected);
}

} // namespace
} // namespace brinell::halfspace::coated_heat_test
