// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/green/rectangle.hpp"
#include "brinell/halfspace/half_space.hpp"
#include "brinell/reference/hertz.hpp"
#include "gauss.hpp"
#include "grid_fields.hpp"
#include "order.hpp"
#include "random_field.hpp"
#include "tensors.hpp"
#include "volume_fields.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

namespace brinell::halfspace::shear_stress_test
{
namespace
{

using test::add;
using test::Field;
using test::hertz;
using test::sampled;
using test::StressField;

constexpr double pi = std::numbers::pi;
const Elastic elastic{1.3, 0.28};
const double nu = elastic.poisson_ratio;

constexpr auto open = Boundary::open;
constexpr auto periodic = Boundary::periodic;

/// Over the layer of a cell, from its middle in units of its thickness.
const test::Gauss layer_rule(3, -0.5, 0.5);

class ShearStressTest : public testing::TestWithParam<VolumeGrid>
{
};

INSTANTIATE_TEST_SUITE_P(Grids, ShearStressTest,
                         testing::Values(VolumeGrid{{6, 6, 1.0, 1.0}, 3, 1.0}, VolumeGrid{{9, 4, 0.5, 1.5}, 4, 0.3},
                                         VolumeGrid{{1, 5, 1.0, 1.0}, 1, 2.0},
                                         VolumeGrid{{11, 7, 1e-6, 2e-6}, 2, 5e-7}));

TEST_P(ShearStressTest, EqualsTheSumOfRectanglesMeanOverALayer)
{
  const VolumeGrid& g = GetParam();
  const SurfaceGrid& s = g.surface;
  const std::array<Field, 3> load{test::random_field(s.size(), 1), test::random_field(s.size(), 2),
                                  test::random_field(s.size(), 3)};
  const auto fast = StressField::of(HalfSpace(g, elastic), {load[0], load[1], load[2]});
  constexpr std::array tractions{Traction::pressure, Traction::shear_x, Traction::shear_y};
  for (int k = 0; k < g.nz; ++k)
    for (int j = 0; j < s.ny; ++j)
      for (int i = 0; i < s.nx; ++i)
      {
        SymTensor sum{};
        for (int m = 0; m < s.ny; ++m)
          for (int l = 0; l < s.nx; ++l)
            for (std::size_t q = 0; q < layer_rule.point.size(); ++q)
              for (std::size_t t = 0; t < tractions.size(); ++t)
                add(green::rectangle_stress((i - l) * s.dx, (j - m) * s.dy, (k + 0.5 + layer_rule.point[q]) * g.dz,
                                            s.dx, s.dy, nu, tractions[t]),
                    layer_rule.weight[q] * load[t][s.index(l, m)], sum);
        const SymTensor found = fast.at(g.index(i, j, k));
        for (std::size_t c = 0; c < 6; ++c) // round-off of the transforms; stresses and loads of order one
          EXPECT_NEAR(found[c], sum[c], 1e-12) << "component " << c << " at " << i << ' ' << j << ' ' << k;
      }
}

Field scaled(double factor, Field field)
{
  for (double& value : field)
    value *= factor;
  return field;
}

class SlidingSphereTest : public testing::TestWithParam<double>
{
};

INSTANTIATE_TEST_SUITE_P(Friction, SlidingSphereTest, testing::Values(0.25, 0.5));

TEST_P(SlidingSphereTest, StressOnTheSurfaceIsHamiltons)
{
  // Inside the circle a shear q0 sqrt(1 - r^2) along x gives (Hamilton 1983; from the displacements of Johnson 1985, Eqs. 3.91)
  //   xx = -pi q0 x (4 + nu)/8    yy = -3 pi nu q0 x/8    xy = -pi q0 y (2 - nu)/8,
  // and the pressure Huber's stress. On the surface xx feels the slope of the shear within the cell itself, which cells do
  // not have: first order, with about q'/2 <= f/2 in front. Extrapolated to no cells the order 3/2 of the steps along the
  // circle is left.
  const double f = GetParam();
  std::vector<Field> values;
  Field exact, errors;
  for (const int cells : {8, 16, 32})
  {
    const int n = 2 * cells + 3, middle = n / 2;
    const double h = 1.0 / cells;
    const VolumeGrid g{{n, n, h, h}, 1, 1e-6 * h};
    const Field pressure = hertz(g.surface), shear = scaled(f, pressure);
    const auto stress = StressField::of(HalfSpace(g, elastic), {.pressure = pressure, .shear_x = shear});
    values.emplace_back();
    exact.clear();
    double largest = 0.0;
    for (const int i : {-cells / 2, -cells / 4, 0, cells / 4, cells / 2})
      for (const int j : {0, cells / 4, cells / 2})
      {
        const double x = i * h, y = j * h;
        SymTensor expected = reference::point_contact_stress(x, y, 0.5 * g.dz, 1.0, 1.0, nu);
        add({-pi * x * (4.0 + nu) / 8.0, -3.0 * pi * nu * x / 8.0, 0.0, 0.0, -std::sqrt(1.0 - x * x - y * y),
             -pi * y * (2.0 - nu) / 8.0},
            f, expected);
        const SymTensor found = stress.at(g.index(middle + i, middle + j, 0));
        for (std::size_t c = 0; c < 6; ++c)
        {
          values.back().push_back(found[c]);
          exact.push_back(expected[c]);
          largest = std::max(largest, std::abs(found[c] - expected[c]));
        }
      }
    errors.push_back(largest);
  }
  const test::Orders orders("Hamilton's stress on the surface", errors);
  EXPECT_GT(orders.last, 1.0);
  EXPECT_LT(errors.back(), 0.5 * f / 32.0);
  double extrapolated = 0.0;
  for (std::size_t n = 0; n < exact.size(); ++n)
    extrapolated = std::max(extrapolated, std::abs(2.0 * values[2][n] - values[1][n] - exact[n]));
  std::printf("extrapolated: %.2e\n", extrapolated);
  EXPECT_LT(extrapolated, 1e-3);
}

TEST_P(SlidingSphereTest, StressOnTheAxisIsHamiltons)
{
  // There the shear adds xz alone, -q0 (1 - 3/2 z acot(z) + z^2/(2 (1 + z^2))): from (V,z - z V,xx)/(2 pi) with
  // V,xx = -V,zz/2 and V,z = -2 pi (1 - z acot(z)), the same V as that of the pressure.
  const double f = GetParam();
  Field errors;
  for (const int cells : {4, 8, 16})
  {
    const int n = 2 * cells + 3, middle = n / 2;
    const double h = 1.0 / cells;
    const VolumeGrid g{{n, n, h, h}, 2 * cells, h};
    const Field pressure = hertz(g.surface), shear = scaled(f, pressure);
    const auto stress = StressField::of(HalfSpace(g, elastic), {.pressure = pressure, .shear_x = shear});
    double largest = 0.0;
    for (int k = cells / 4; k < 2 * cells; ++k)
    {
      SymTensor expected{};
      for (std::size_t q = 0; q < layer_rule.point.size(); ++q)
      {
        const double z = (k + 0.5 + layer_rule.point[q]) * h;
        add(reference::point_contact_stress(0.0, 0.0, z, 1.0, 1.0, nu), layer_rule.weight[q], expected);
        expected[4] -= layer_rule.weight[q] * f * (1.0 - 1.5 * z * std::atan(1.0 / z) + 0.5 * z * z / (1.0 + z * z));
      }
      const SymTensor found = stress.at(g.index(middle, middle, k));
      for (std::size_t c = 0; c < 6; ++c)
        largest = std::max(largest, std::abs(found[c] - expected[c]));
    }
    errors.push_back(largest);
  }
  EXPECT_GT(test::Orders("Hamilton's stress on the axis", errors).last, 1.8);
  EXPECT_LT(errors.back(), 2e-3);
}

class ShearBoundaryTest : public testing::TestWithParam<SurfaceGrid>
{
};

INSTANTIATE_TEST_SUITE_P(Grids, ShearBoundaryTest,
                         testing::Values(SurfaceGrid{9, 4, 0.5, 1.5}, SurfaceGrid{8, 6, 0.7, 0.9, periodic, periodic},
                                         SurfaceGrid{7, 5, 0.7, 0.9, periodic, periodic},
                                         SurfaceGrid{6, 1, 1.0, 1.0, periodic, periodic},
                                         SurfaceGrid{8, 6, 0.7, 0.9, open, periodic},
                                         SurfaceGrid{7, 5, 0.7, 0.9, periodic, open},
                                         SurfaceGrid{9, 1, 0.7, 0.9, open, periodic}));

TEST_P(ShearBoundaryTest, TheTransposeIsTheDisplacementOfPlasticStrain)
{
  // Betti: integral of stress(p, q) : eps over the volume = integral of p u_z + q_x u_x + q_y u_y over the surface.
  const VolumeGrid g{GetParam(), 4, 0.6};
  const std::size_t cells = g.surface.size();
  const HalfSpace half_space(g, elastic);
  HalfSpace::Work work = half_space.make_work();
  const Field strain = test::random_field(Deviator::size * g.size(), 6);
  const Field p = test::random_field(cells, 7), q_x = test::random_field(cells, 8), q_y = test::random_field(cells, 9);
  Field u_x(cells), u_y(cells), u_z(cells), u_z_alone(cells);
  half_space.load(strain, g.nz, work, Displacements::all).displacement({.z = u_z, .x = u_x, .y = u_y});
  half_space.load(strain, g.nz, work).displacement({.z = u_z_alone});
  EXPECT_EQ(u_z, u_z_alone);
  const Field stress = StressField::of(half_space, {p, q_x, q_y}).deviator;
  const double inside = test::contracted(stress, strain) * g.cell_volume();
  const double outside = (test::dot(p, u_z) + test::dot(q_x, u_x) + test::dot(q_y, u_y)) * g.surface.cell_area();
  const double scale = std::sqrt(test::contracted(stress, stress) * test::contracted(strain, strain)) * g.cell_volume();
  EXPECT_NEAR(inside, outside, 1e-13 * scale);
  EXPECT_GT(std::sqrt(test::dot(u_x, u_x)), 0.1 * std::sqrt(test::dot(u_z, u_z))); // not zero for want of kernels
}

TEST_P(ShearBoundaryTest, AxesCanBeExchanged)
{
  const VolumeGrid g{GetParam(), 3, 0.6};
  const SurfaceGrid& s = g.surface;
  const VolumeGrid h{{s.ny, s.nx, s.dy, s.dx, s.boundary_y, s.boundary_x}, 3, 0.6};
  const Field q_x = test::random_field(s.size(), 10), q_y = test::random_field(s.size(), 11);
  const auto exchanged = [&](const Field& q)
  { return sampled(h.surface, [&](int i, int j) { return q[s.index(j, i)]; }); };
  const Field of_x = exchanged(q_y), of_y = exchanged(q_x);
  const auto a = StressField::of(HalfSpace(g, elastic), {.shear_x = q_x, .shear_y = q_y});
  const auto b = StressField::of(HalfSpace(h, elastic), {.shear_x = of_x, .shear_y = of_y});
  for (int k = 0; k < g.nz; ++k)
    for (int j = 0; j < s.ny; ++j)
      for (int i = 0; i < s.nx; ++i)
      {
        const SymTensor other = xy_exchanged(b.at(h.index(j, i, k)));
        for (std::size_t c = 0; c < 6; ++c)
          EXPECT_NEAR(a.at(g.index(i, j, k))[c], other[c], 1e-12) << "component " << c;
      }
}

TEST(ShearDoorTest, DisplacementsThatWereNotPreparedAreRefused)
{
  const HalfSpace half_space(VolumeGrid{{4, 3, 1.0, 1.0}, 2, 1.0}, elastic);
  HalfSpace::Work work = half_space.make_work();
  Field strain(120), u(12);
  EXPECT_THROW(half_space.load(strain, 2, work).displacement({.x = u}), InternalError);
  EXPECT_NO_THROW(half_space.load(strain, 2, work, Displacements::all).displacement({.x = u}));
}

} // namespace
} // namespace brinell::halfspace::shear_stress_test
