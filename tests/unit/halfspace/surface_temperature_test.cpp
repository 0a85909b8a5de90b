// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/surface_temperature.hpp"

#include "brinell/foundation/error.hpp"
#include "grid_fields.hpp"
#include "halfspace/transform/coarser_surface.hpp"
#include "random_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

/// The memory of a body that is heated step by step.
namespace brinell::halfspace::surface_temperature_test
{
namespace
{

constexpr auto open = Boundary::open;
constexpr auto periodic = Boundary::periodic;
using test::Field;
const Thermal body{2.0, 4.0, 1.0, 0.0};

/// Temperature after `steps` equal steps of one flux that moves: the memory of all but the last one, and the last one itself.
Field after(const SurfaceGrid& g, int steps, const HeatMotion& step, const std::vector<Field>& fluxes)
{
  SurfaceTemperature memory(g, body, {step.duration, steps * step.duration});
  for (int n = 0; n + 1 < steps; ++n)
    memory.add_step(fluxes[static_cast<std::size_t>(n)], step);
  Field remaining(g.size()), own(g.size());
  memory.remaining(step.duration, remaining);
  const HeatResponse response(g, body, step);
  HeatResponse::Scratch scratch = response.make_scratch();
  response.apply(fluxes.back(), own, scratch);
  for (std::size_t n = 0; n < own.size(); ++n)
    own[n] += remaining[n];
  return own;
}

Field shifted(const SurfaceGrid& g, const Field& flux, int cells)
{
  Field result(g.size());
  for (int j = 0; j < g.ny; ++j)
    for (int i = 0; i < g.nx; ++i)
      if (const int from = i - cells; g.is_periodic_x() || (from >= 0 && from < g.nx))
        result[g.index(i, j)] = flux[g.index((from + g.nx) % g.nx, j)];
  return result;
}

TEST(CoarserSurface, KeepsCubicsAndMoments)
{
  const SurfaceGrid fine{9, 6, 0.5, 0.25};
  const CoarserSurface cells(fine, 0);
  const SurfaceGrid& coarse = cells.grid();
  // Both grids have one middle.
  const auto cubic = [](double x, double y) { return 1.0 - 0.3 * x + 0.2 * x * x * y - 0.7 * y * y * y + x * x * x; };
  const Field field = test::sampled(coarse, [&](int i, int j) { return cubic(coarse.x(i), coarse.y(j)); });
  const Field result = cells.to_finer(field);
  const Field load = test::random_field(fine.size(), 5);
  const Field on_coarse = cells.from_finer(load);
  double moment = 0.0, coarse_moment = 0.0;
  for (int j = 0; j < fine.ny; ++j)
    for (int i = 0; i < fine.nx; ++i)
    {
      const double exact = cubic(fine.x(i), fine.y(j));
      EXPECT_NEAR(result[fine.index(i, j)], exact, 1e-11);
      moment += load[fine.index(i, j)] * exact * fine.cell_area();
    }
  for (std::size_t n = 0; n < coarse.size(); ++n)
    coarse_moment += on_coarse[n] * field[n] * coarse.cell_area();
  EXPECT_NEAR(coarse_moment, moment, 1e-11);
}

TEST(CoarserSurface, KeepsWhatIsEvenAndOdd)
{
  // Numbers of rows that are odd, twice an odd one and twice an even one, and two coarsenings of each.
  for (const int rows : {7, 9, 19, 6, 8})
  {
    SurfaceGrid grid{11, rows, 0.5, 0.25};
    const CoarserSurface cells(grid, 0), coarser(cells.grid(), CoarserSurface::margin);
    for (const double parity : {1.0, -1.0})
    {
      Field load = test::random_field(grid.size(), 5), mirrored = load;
      for (int j = 0; j < rows; ++j)
        for (int i = 0; i < grid.nx; ++i)
          mirrored[grid.index(i, j)] = parity * load[grid.index(i, rows - 1 - j)];
      for (std::size_t n = 0; n < load.size(); ++n)
        load[n] += mirrored[n];
      const Field coarse = coarser.from_finer(cells.from_finer(load));
      const Field back = cells.to_finer(coarser.to_finer(coarse));
      for (const auto& [field, on] : {std::pair{&coarse, &coarser.grid()}, {&back, &grid}})
        for (int j = 0; j < on->ny; ++j)
          for (int i = 0; i < on->nx; ++i)
            EXPECT_NEAR((*field)[on->index(i, j)], parity * (*field)[on->index(i, on->ny - 1 - j)], 1e-14)
                << rows << " rows";
    }
  }
}

/// The grid, how far the flux moves in a step, in cells, and the length of heat sqrt(4 kappa t) in a step, in cells.
struct Split
{
  SurfaceGrid grid;
  int shift;
  double heat_length;
  int steps;
};

class HeatInSteps : public testing::TestWithParam<Split>
{
};

TEST_P(HeatInSteps, ManyStepsAreOne)
{
  const SurfaceGrid& g = GetParam().grid;
  const int shift = GetParam().shift, steps = GetParam().steps;
  const double heat_length = GetParam().heat_length;
  // A smooth flux in the middle, at the end of the last step; before it was further back, on the grid all the time.
  const double width = 0.09 * g.nx * g.dx;
  const double end = g.is_periodic_x() ? 0.0 : 0.5 * shift * (steps - 1) * g.dx;
  const Field flux = test::sampled(g,
                                   [&](int i, int j)
                                   {
                                     const double y = g.ny > 1 ? g.y(j) : 0.0;
                                     return std::exp(-(std::pow(g.x(i) - end, 2) + y * y) / (width * width));
                                   });
  const double duration = std::pow(heat_length * g.dx, 2) / (4.0 * body.diffusivity());
  const double velocity = shift * g.dx / duration;
  std::vector<Field> fluxes;
  fluxes.reserve(static_cast<std::size_t>(steps));
  for (int n = 0; n < steps; ++n)
    fluxes.push_back(shifted(g, flux, shift * (n + 1 - steps)));
  const Field split = after(g, steps, {duration, velocity}, fluxes);

  const HeatResponse response(g, body, {steps * duration, velocity});
  HeatResponse::Scratch scratch = response.make_scratch();
  Field whole(g.size());
  response.apply(flux, whole, scratch);
  double largest = 0.0, error = 0.0;
  for (std::size_t n = 0; n < whole.size(); ++n)
  {
    largest = std::max(largest, whole[n]);
    error = std::max(error, std::abs(split[n] - whole[n]));
  }
  std::printf("%d steps, shift %d, heat %.2g cells: %.1e\n", steps, shift, heat_length, error / largest);
  // The sum over waves in depth is good to some 1e-6; of the edges of the cells the memory does not know the waves beyond the
  // shortest, of which exp(-(pi w/2)^2) is left after a step in which heat spreads by w cells: half of them for w = 1/2.
  EXPECT_LT(error, (heat_length < 1.0 ? 1e-3 : 1e-5) * largest);
}

INSTANTIATE_TEST_SUITE_P(All, HeatInSteps,
                         testing::Values(Split{{40, 40, 0.1, 0.1}, 0, 1.0, 30}, Split{{40, 40, 0.1, 0.1}, 0, 8.0, 60},
                                         Split{{40, 40, 0.1, 0.1}, 0, 60.0, 40},
                                         Split{{41, 35, 0.1, 0.12}, 0, 20.0, 25}, Split{{64, 40, 0.1, 0.1}, 1, 0.5, 20},
                                         Split{{64, 40, 0.1, 0.1}, 1, 3.0, 20}, Split{{64, 40, 0.1, 0.1}, 2, 30.0, 10},
                                         Split{{64, 40, 0.1, 0.1}, -1, 2.0, 20},
                                         Split{{64, 1, 0.1, 0.1, open, periodic}, 1, 2.0, 20},
                                         Split{{64, 1, 0.1, 0.1, open, periodic}, 0, 30.0, 40},
                                         Split{{40, 40, 0.1, 0.1, open, periodic}, 1, 5.0, 10},
                                         Split{{40, 40, 0.1, 0.1, periodic, periodic}, 3, 2.0, 30},
                                         Split{{40, 40, 0.1, 0.1, periodic, periodic}, 0, 9.0, 200}));

TEST(SurfaceTemperature, FluxThatChangesIsASumOfStepsOfItsOwn)
{
  // The last of three different fluxes, and each of the two before as it would be alone.
  const SurfaceGrid g{24, 20, 0.1, 0.1};
  const HeatMotion step{0.02, 1.0};
  std::vector<Field> fluxes;
  for (unsigned n = 0; n < 3; ++n)
    fluxes.push_back(test::random_field(g.size(), n));
  const Field zero(g.size());
  const Field all = after(g, 3, step, fluxes);
  const Field one = after(g, 3, step, {fluxes[0], zero, zero});
  const Field two = after(g, 3, step, {zero, fluxes[1], zero});
  const Field three = after(g, 3, step, {zero, zero, fluxes[2]});
  for (std::size_t n = 0; n < all.size(); ++n)
    EXPECT_NEAR(all[n], one[n] + two[n] + three[n], 1e-13);
}

TEST(SurfaceTemperature, StepsOutsideWhatWasPlanned)
{
  const SurfaceGrid g{4, 4, 0.1, 0.1};
  Field field(g.size());
  SurfaceTemperature memory(g, body, {0.1, 1.0});
  EXPECT_THROW(memory.remaining(0.05, field), InputError);
  EXPECT_THROW(memory.add_step(field, {0.05}), InputError);
  memory.add_step(field, {0.6});
  EXPECT_DOUBLE_EQ(memory.time(), 0.6);
  EXPECT_THROW(memory.add_step(field, {0.6}), InputError);
  EXPECT_THROW(SurfaceTemperature(g, body, {0.0, 1.0}), InputError);
  EXPECT_THROW(SurfaceTemperature(g, body, {1.0, 0.5}), InputError);
}

} // namespace
} // namespace brinell::halfspace::surface_temperature_test
