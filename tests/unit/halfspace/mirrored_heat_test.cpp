// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/foundation/symmetry.hpp"
#include "brinell/halfspace/heat_response.hpp"
#include "brinell/halfspace/steady_field.hpp"
#include "brinell/halfspace/thermal_response.hpp"
#include "grid_fields.hpp"
#include "heated_body.hpp"
#include "mirrored_grid.hpp"
#include "random_field.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

/// Responses to a flux whose sides of y = 0 are mirror images, from one of them.
namespace brinell::halfspace::mirrored_heat_test
{
namespace
{

using test::Field;

constexpr double rounding = 1e-13;

void expect_alike(const Field& one_side, const Field& both, double scale)
{
  EXPECT_LT(test::largest_difference(one_side, both), rounding * scale);
}

class MirroredHeatTest : public testing::TestWithParam<SurfaceGrid>
{
protected:
  SurfaceGrid grid = GetParam(), half = test::mirrored(grid);
  Field flux = test::random_field(grid.size(), 3, 0.0, 1.0);

  void SetUp() override { complete_in_y(grid, 1.0, flux.data(), flux.size()); }
};

constexpr auto open = Boundary::open;
constexpr auto periodic = Boundary::periodic;
INSTANTIATE_TEST_SUITE_P(Grids, MirroredHeatTest,
                         testing::Values(SurfaceGrid{14, 9, 0.1, 0.15}, SurfaceGrid{11, 8, 0.1, 0.15},
                                         SurfaceGrid{12, 7, 0.1, 0.15, open, periodic}),
                         [](const auto& p) { return std::to_string(p.param.nx) + "x" + std::to_string(p.param.ny); });

TEST_P(MirroredHeatTest, Temperature)
{
  const HeatMotion motion{0.2, 1.5};
  const HeatResponse both(grid, test::heated_body, motion), one(half, test::heated_body, motion);
  HeatResponse::Scratch of_both = both.make_scratch(), of_one = one.make_scratch();
  Field expected(grid.size()), found(grid.size());
  both.apply(flux, expected, of_both);
  one.apply(flux, found, of_one);
  expect_alike(found, expected, test::largest(expected));
  EXPECT_THROW(HeatResponse(half, test::heated_body, {0.2, 0.0, 1.0}), InputError);
}

TEST_P(MirroredHeatTest, Displacement)
{
  const HeatMotion motion{0.2, 1.5};
  const ThermalResponse both(grid, test::heated_body, test::heated_elastic, motion, {}, Displacements::all),
      one(half, test::heated_body, test::heated_elastic, motion, {}, Displacements::all);
  ThermalResponse::Scratch of_both = both.make_scratch(), of_one = one.make_scratch();
  std::array<Field, 3> expected, found;
  for (auto* fields : {&expected, &found})
    fields->fill(Field(grid.size()));
  both.apply(flux, {expected[0], expected[1], expected[2]}, of_both);
  one.apply(flux, {found[0], found[1], found[2]}, of_one);
  for (std::size_t part = 0; part < 3; ++part)
    expect_alike(found[part], expected[part], test::largest(expected[0]));
  EXPECT_THROW(ThermalResponse(half, test::heated_body, test::heated_elastic, {0.2, 0.0, 1.0}), InputError);
}

TEST_P(MirroredHeatTest, SteadyFields)
{
  const std::vector<double> depths{0.0, 0.2};
  const SteadyField both(grid, test::heated_body, test::heated_elastic, {1.5}, depths),
      one(half, test::heated_body, test::heated_elastic, {1.5}, depths);
  Field expected(grid.size()), found(grid.size());
  both.displacement(flux, expected);
  one.displacement(flux, found);
  expect_alike(found, expected, test::largest(expected));
  const std::size_t cells = grid.size();
  for (std::size_t layer = 0; layer < depths.size(); ++layer)
  {
    std::array<Field, 2> temperature, deviator, trace;
    for (std::size_t n = 0; n < 2; ++n)
    {
      temperature[n].resize(cells);
      deviator[n].resize(Deviator::size * cells);
      trace[n].resize(cells);
      const std::array<ThermalLayer, 1> out{{{temperature[n], deviator[n], trace[n]}}};
      (n == 0 ? both : one).layers(flux, layer, out);
    }
    expect_alike(temperature[1], temperature[0], test::largest(temperature[0]));
    expect_alike(trace[1], trace[0], test::largest(trace[0]));
    expect_alike(deviator[1], deviator[0], test::largest(deviator[0]));
  }
}

} // namespace
} // namespace brinell::halfspace::mirrored_heat_test
