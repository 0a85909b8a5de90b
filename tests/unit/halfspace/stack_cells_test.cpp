// SPDX-License-Identifier: BSD-3-Clause
#include "halfspace/traction/stack_cells.hpp"
#include "halfspace/traction/stack_shears.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/halfspace/half_space.hpp"
#include "brinell/halfspace/surface_compliance.hpp"
#include "gauss.hpp"
#include "random_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brinell::halfspace::stack_cells_test
{
namespace
{

using std::numbers::pi;

const ElasticStack soft_on_hard{{{1.0, {1.0, 0.4}}}, {10.0, 0.3}};
const ElasticStack hard_on_soft{{{1.0, {4.0, 0.2}}}, {1.0, 0.3}};
const ElasticStack two_layers{{{0.5, {3.0, 0.25}}, {1.0, {0.5, 0.45}}}, {2.0, 0.3}};

/// Displacement along z by a unit pressure on a cell, less that of a homogeneous body of the top material.
Quadrant<double> displaced(const SurfaceGrid& grid, const ElasticStack& stack, double reference)
{
  const Quadrant<SurfaceExcess> all = excess_surface(grid, stack, reference);
  Quadrant<double> along_z(grid);
  for (std::size_t n = 0; n < along_z.values.size(); ++n)
    along_z.values[n] = all.values[n][excess::zz];
  return along_z;
}

/// Integral of f(k) J0(k r) dk / (2 pi) from 0 to where f has decayed as e^{-2 k thickness}.
template <typename Function>
double hankel(const Function& f, double r, double thickness)
{
  const double end = 18.0 / thickness; // e^{-36}
  const int panels = 20 + static_cast<int>(end * r / pi);
  double sum = 0.0;
  for (int p = 0; p < panels; ++p)
  {
    const test::Gauss rule(12, end * p / panels, end * (p + 1) / panels);
    for (std::size_t n = 0; n < rule.point.size(); ++n)
      sum += rule.weight[n] * f(rule.point[n]) * std::cyl_bessel_j(0, rule.point[n] * r);
  }
  return sum / (2.0 * pi);
}

/// Mean of a function of the distance from the centre of a cell times its area.
template <typename Function>
double over_cell(double x, double y, double dx, double dy, const Function& f)
{
  const test::Gauss along(4, -0.5, 0.5);
  double sum = 0.0;
  for (std::size_t i = 0; i < along.point.size(); ++i)
    for (std::size_t j = 0; j < along.point.size(); ++j)
      sum += along.weight[i] * along.weight[j] * f(std::hypot(x - along.point[i] * dx, y - along.point[j] * dy));
  return sum * dx * dy;
}

TEST(StackCells, ExcessDisplacementIsTheLayeredIntegral)
{
  for (const auto& [stack, cell] : {std::pair{soft_on_hard, 0.25},
                                    {hard_on_soft, 0.25},
                                    {two_layers, 0.25},
                                    {soft_on_hard, 1.0},
                                    {hard_on_soft, 1.0}})
  {
    const SurfaceGrid grid{24, 16, cell, 1.5 * cell};
    const Quadrant<double> excess = displaced(grid, stack, 0.0);
    const Elastic& top = stack.top();
    const double of_top = (1.0 - top.poisson_ratio) / top.shear_modulus();
    const auto point = [&](double r)
    {
      return hankel([&](double k) { return k * green::StackWave(stack, k).compliance().normal - of_top; }, r,
                    stack.layers.front().thickness);
    };
    // The rule of the test in the cell is exact to 1e-5.
    const double scale = std::abs(excess.at(0, 0)) + of_top * cell;
    for (const auto& [i, j] : {std::pair{0, 0}, {1, 0}, {3, 2}, {10, 0}, {23, 15}})
      EXPECT_NEAR(excess.at(i, j), over_cell(i * grid.dx, j * grid.dy, grid.dx, grid.dy, point), 1e-5 * scale)
          << cell << " at " << i << ' ' << j;
  }
}

TEST(StackCells, ExcessOfASmallGridIsThatOfAWideOne)
{
  for (const ElasticStack& stack : {soft_on_hard, hard_on_soft, two_layers})
  {
    const VolumeGrid small{{12, 10, 0.5, 0.5}, 6, 0.5}, wide{{32, 32, 0.5, 0.5}, 6, 0.5};
    const Quadrant<double> a = displaced(small.surface, stack, 0.0);
    const Quadrant<double> b = displaced(wide.surface, stack, 0.0);
    for (int j = 0; j < a.ny; ++j)
      for (int i = 0; i < a.nx; ++i)
        EXPECT_NEAR(a.at(i, j), b.at(i, j), 1e-7 * std::abs(b.at(0, 0))) << i << ' ' << j;
    for (const Traction traction : {Traction::pressure, Traction::shear_x})
      for (const int layer : {0, 2, 5})
      {
        const Quadrant<SymTensor> s = ExcessStress(small, stack, traction).of_layer(layer);
        const Quadrant<SymTensor> t = ExcessStress(wide, stack, traction).of_layer(layer);
        double largest = 0.0;
        for (const SymTensor& value : t.values)
          for (const double component : value)
            largest = std::max(largest, std::abs(component));
        for (int j = 0; j < s.ny; ++j)
          for (int i = 0; i < s.nx; ++i)
            for (std::size_t c = 0; c < 6; ++c)
              EXPECT_NEAR(s.at(i, j)[c], t.at(i, j)[c], 1e-7 * largest)
                  << "layer " << layer << " component " << c << " at " << i << ' ' << j;
      }
  }
}

TEST(StackCells, StressAcrossTheSurfaceIsTheLayeredIntegral)
{
  const VolumeGrid grid{{16, 16, 0.5, 0.5}, 4, 0.5};
  for (const ElasticStack& stack : {soft_on_hard, hard_on_soft})
  {
    const ExcessStress excess(grid, stack, Traction::pressure);
    for (const int layer : {0, 1, 2})
    {
      const double from = layer * grid.dz, to = from + grid.dz;
      const ElasticStack alone{{}, {1.0, stack.at(0.5 * (from + to)).poisson_ratio}};
      const std::size_t at = stack.layer_at(0.5 * (from + to));
      const auto point = [&](double r)
      {
        return hankel(
            [&](double k)
            {
              const green::StackWave wave(stack, k), other(alone, k);
              constexpr auto load = green::WaveLoad::pressure;
              return k * (wave.mean_stress(load, wave.field_of(load), at, from, to).zz -
                          other.mean_stress(load, other.field_of(load), 0, from, to).zz);
            },
            r, 0.25);
      };
      const Quadrant<SymTensor> found = excess.of_layer(layer);
      for (const auto& [i, j] :
           {std::pair{0, 0}, {2, 1}, {9, 4}}) // the rule in the cell has 4 x 4 points, exact to 1e-5
        EXPECT_NEAR(found.at(i, j)[2], over_cell(i * 0.5, j * 0.5, 0.5, 0.5, point), 1e-4) << layer << ' ' << i;
    }
  }
}

TEST(StackCells, LayersOfOneMaterialHaveNoExcess)
{
  const Elastic steel{1.0, 0.3};
  const ElasticStack same{{{0.5, steel}, {1.0, steel}}, steel};
  const VolumeGrid grid{{8, 6, 0.5, 0.5}, 4, 0.5};
  for (const double value : displaced(grid.surface, same, 0.0).values)
    EXPECT_NEAR(value, 0.0, 1e-10);
  for (const Traction traction : {Traction::pressure, Traction::shear_x})
    for (const int layer : {0, 1, 3})
      for (const SymTensor& value : ExcessStress(grid, same, traction).of_layer(layer).values)
        for (const double component : value)
          EXPECT_NEAR(component, 0.0, 1e-9); // a slope at long waves, by differences
}

TEST(StackCells, PeriodicBodiesHaveTheWavesOfTheStack)
{
  const SurfaceGrid grid{16, 8, 0.25, 0.5, Boundary::periodic, Boundary::periodic};
  const SurfaceCompliance pair(grid, hard_on_soft, {{}, {3.0, 0.25}});
  std::vector<double> pressure(grid.size()), u(grid.size());
  const double m = 2.0 * pi * 2.0 / 4.0, n = 2.0 * pi / 4.0;
  const auto wave = [&](int i, int j) { return std::cos(m * i * grid.dx + n * j * grid.dy); };
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      pressure[grid.index(i, j)] = wave(i, j);
  pair.apply({.pressure = pressure}, {.z = u});
  const double k = std::hypot(m, n);
  const double expected = green::StackWave(hard_on_soft, k).compliance().normal + 2.0 * (1.0 - 0.25 * 0.25) / (3.0 * k);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      EXPECT_NEAR(u[grid.index(i, j)], expected * wave(i, j), 1e-13);
}

TEST(StackCells, IsSymmetricAndPositive)
{
  const SurfaceGrid grid{20, 14, 0.3, 0.4};
  const SurfaceCompliance pair(grid, soft_on_hard, two_layers);
  const std::vector<double> p = test::random_field(grid.size(), 1), q = test::random_field(grid.size(), 2);
  std::vector<double> of_p(grid.size()), of_q(grid.size());
  pair.apply({.pressure = p}, {.z = of_p});
  pair.apply({.pressure = q}, {.z = of_q});
  double pq = 0.0, qp = 0.0, pp = 0.0;
  for (std::size_t n = 0; n < p.size(); ++n)
  {
    pq += p[n] * of_q[n];
    qp += q[n] * of_p[n];
    pp += p[n] * of_p[n];
  }
  EXPECT_NEAR(pq, qp, 1e-12 * pp);
  EXPECT_GT(pp, 0.0);
}

TEST(StackCells, StressUnderALoadIsThatOfACloseNeighbourInTheLimit)
{
  // A layer much thicker than the grid is deep is a half space of its own.
  const VolumeGrid grid{{10, 8, 1.0, 1.0}, 5, 1.0};
  const Elastic top{2.0, 0.25};
  const HalfSpace thick(grid, ElasticStack{{{400.0, top}}, {1.0, 0.3}}), alone(grid, top);
  const std::vector<double> pressure = test::random_field(grid.surface.size(), 5);
  std::vector<double> a(6 * grid.surface.size()), b(a.size());
  HalfSpace::Work work = thick.make_guest(), other = alone.make_guest();
  for (const int layer : {0, 4})
  {
    thick.stress_of_load({.pressure = pressure}, layer, work, a);
    alone.stress_of_load({.pressure = pressure}, layer, other, b);
    for (std::size_t n = 0; n < a.size(); ++n)
      EXPECT_NEAR(a[n], b[n], 1e-3); // the size of the grid over the thickness, squared
  }
}

TEST(StackCells, CellsMayContainInterfacesWhereNothingYields)
{
  // The stress in a layer of cells is the mean over those in eight, which end at the interfaces.
  const ElasticStack stack{{{0.5, {4.0, 0.2}}, {1.0, {0.5, 0.45}}}, {1.0, 0.3}};
  const VolumeGrid coarse{{8, 7, 1.0, 1.2}, 2, 1.0}, fine{coarse.surface, 16, 0.125};
  const HalfSpace whole(coarse, stack), divided(fine, stack);
  HalfSpace::Work work = whole.make_guest(), other = divided.make_guest();
  const std::vector<double> load = test::random_field(coarse.surface.size(), 5);
  std::vector<double> stress(6 * load.size()), part(stress.size());
  for (const SurfaceLoad& by : {SurfaceLoad{.pressure = load}, SurfaceLoad{.shear_x = load}})
    for (const int layer : {0, 1})
    {
      whole.stress_of_load(by, layer, work, stress);
      std::vector<double> mean(stress.size());
      for (int n = 8 * layer; n < 8 * (layer + 1); ++n)
      {
        divided.stress_of_load(by, n, other, part);
        for (std::size_t i = 0; i < mean.size(); ++i)
          mean[i] += part[i] / 8.0;
      }
      // The error of the rule of three points, in the half of a cell at the surface.
      for (std::size_t i = 0; i < mean.size(); ++i)
        EXPECT_NEAR(stress[i], mean[i], 1e-4) << layer;
    }
}

TEST(StackCells, LayersMuchThinnerThanCellsAreRefused)
{
  const SurfaceGrid coarse{4, 4, 4.1, 1.0}, periodic{4, 4, 4.1, 1.0, Boundary::periodic, Boundary::periodic};
  EXPECT_THROW(SurfaceCompliance(coarse, soft_on_hard, soft_on_hard), InputError);
  EXPECT_THROW(HalfSpace({coarse, 1, 1.0}, soft_on_hard), InputError);
  EXPECT_NO_THROW(SurfaceCompliance(periodic, soft_on_hard, soft_on_hard));
}

} // namespace
} // namespace brinell::halfspace::stack_cells_test
