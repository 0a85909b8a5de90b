// SPDX-License-Identifier: BSD-3-Clause
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
#include <numbers>

namespace brinell::halfspace::periodic_shear_test
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

// --- one periodic axis --------------------------------------------------------------------------------------------

TEST(SlidingCylinderTest, StressIsMcEwens)
{
  // A shear q0 sqrt(1 - x^2) across a line contact (Johnson 1985, Eqs. 7.8): zz and xz are xz and xx of the pressure, and
  // xx = n (2 - (z^2 - m^2)/(m^2 + n^2)) - 2 x,   z = m n' of the confocal coordinates m, n.
  Field errors;
  for (const int cells : {4, 8, 16, 32})
  {
    const int n = 2 * cells + 3, middle = n / 2;
    const double h = 1.0 / cells;
    const VolumeGrid g{{n, 1, h, 1.0, open, periodic}, 2 * cells, h};
    const Field shear = hertz(g.surface);
    const auto stress = StressField::of(HalfSpace(g, elastic), {.shear_x = shear});
    double largest = 0.0;
    for (const int i : {-cells / 2, 0, cells / 4, cells})
      for (int k = cells / 4; k < 2 * cells; ++k)
      {
        SymTensor expected{};
        for (std::size_t q = 0; q < layer_rule.point.size(); ++q)
        {
          const double x = i * h, z = (k + 0.5 + layer_rule.point[q]) * h;
          const double a = 1.0 - x * x + z * z, root = std::sqrt(a * a + 4.0 * x * x * z * z);
          const double m2 = 0.5 * (root + a), n2 = 0.5 * (root - a);
          const SymTensor p = reference::line_contact_stress(x, z, 1.0, 1.0, nu);
          const double xx = std::copysign(std::sqrt(n2), x) * (2.0 - (z * z - m2) / (m2 + n2)) - 2.0 * x;
          const double zz = p[4], xz = p[0];
          add({xx, nu * (xx + zz), zz, 0.0, xz, 0.0}, layer_rule.weight[q], expected);
        }
        const SymTensor found = stress.at(g.index(middle + i, 0, k));
        for (std::size_t c = 0; c < 6; ++c)
          largest = std::max(largest, std::abs(found[c] - expected[c]));
      }
    errors.push_back(largest);
  }
  EXPECT_GT(test::Orders("McEwen's stress of a shear", errors).last, 1.8);
  EXPECT_LT(errors.back(), 1e-3);
}

TEST(OnePeriodicAxisShearTest, IsTheMiddleOfARowOfCopies)
{
  // What is missing beyond `count` copies on either side: the stress of a force falls as 1/r^2 along the row, but is odd there,
  // so that copies on both sides leave 1/r^3: of second order.
  const VolumeGrid grid{{6, 8, 1.0, 1.2, open, periodic}, 3, 1.0};
  Field q_x = test::random_field(grid.surface.size(), 4), q_y = test::random_field(grid.surface.size(), 5);
  const StressField exact = StressField::of(HalfSpace(grid, elastic), {.shear_x = q_x, .shear_y = q_y});
  Field errors;
  for (const int count : {4, 8, 16})
  {
    VolumeGrid row = grid;
    row.surface.boundary_y = open;
    row.surface.ny *= 2 * count + 1;
    const auto copied = [&](const Field& q)
    { return sampled(row.surface, [&](int i, int j) { return q[grid.surface.index(i, j % grid.surface.ny)]; }); };
    const Field copied_x = copied(q_x), copied_y = copied(q_y);
    const auto found = StressField::of(HalfSpace(row, elastic), {.shear_x = copied_x, .shear_y = copied_y});
    errors.push_back(test::largest_difference(grid, exact, row, found, count * grid.surface.ny));
  }
  EXPECT_GT(test::Orders("row of copies of a shear, copies doubled", errors).last, 1.8);
  EXPECT_LT(errors.back(), 2e-3);
}

// --- both axes periodic -------------------------------------------------------------------------------------------

TEST(PeriodicShearTest, UniformShearIsConstantOverTheDepth)
{
  const VolumeGrid g{{6, 5, 0.5, 0.6, periodic, periodic}, 4, 0.7};
  const Field q_x(g.surface.size(), 2.0), q_y(g.surface.size(), -3.0);
  const auto stress = StressField::of(HalfSpace(g, elastic), {.shear_x = q_x, .shear_y = q_y});
  const SymTensor expected{0.0, 0.0, 0.0, 3.0, -2.0, 0.0};
  for (std::size_t cell = 0; cell < g.size(); ++cell)
    for (std::size_t c = 0; c < 6; ++c)
      EXPECT_NEAR(stress.at(cell)[c], expected[c], 1e-13);
}

TEST(PeriodicShearTest, WavesAreThoseOfRowsOfRectangles)
{
  // A wave along y of a shear along x and of one along y, on a surface so wide in x that its middle does not see the ends:
  // there the closed forms of rectangles, which have no waves in them, tend to the periodic operator; second order.
  for (const bool across : {false, true})
  {
    Field errors;
    for (const int ny : {8, 16, 32})
    {
      const double h = 1.0 / ny;
      VolumeGrid row{{8 * ny + 1, ny, h, h, open, periodic}, 4, 0.125};
      VolumeGrid wave = row;
      wave.surface.nx = 1;
      wave.surface.boundary_x = periodic;
      const auto load = [&](const SurfaceGrid& s)
      { return sampled(s, [&](int, int j) { return std::cos(2.0 * pi * j / ny); }); };
      const auto stress_on = [&](const VolumeGrid& g)
      {
        const Field q = load(g.surface);
        return StressField::of(HalfSpace(g, elastic), across ? SurfaceLoad{.shear_x = q} : SurfaceLoad{.shear_y = q});
      };
      const StressField of_rows = stress_on(row), of_waves = stress_on(wave);
      double largest = 0.0;
      for (int k = 1; k < row.nz; ++k)
        for (int j = 0; j < ny; ++j)
          for (std::size_t c = 0; c < 6; ++c)
            largest = std::max(largest,
                               std::abs(of_rows.at(row.index(4 * ny, j, k))[c] - of_waves.at(wave.index(0, j, k))[c]));
      errors.push_back(largest);
    }
    EXPECT_GT(test::Orders(across ? "wave of shear across it" : "wave of shear along it", errors).last, 1.9);
  }
}

TEST(PeriodicShearTest, ObliqueWavesAreTurnedOnes)
{
  // Isotropy: a wave of a shear along its wavevector, and one of a shear across it, seen in axes turned with them.
  const VolumeGrid g{{12, 10, 0.5, 0.6, periodic, periodic}, 3, 0.4};
  const double m = 2.0 * pi * 2 / (g.surface.nx * g.surface.dx), n = 2.0 * pi * 1 / (g.surface.ny * g.surface.dy);
  const double k = std::hypot(m, n), c = m / k, s = n / k;
  const VolumeGrid straight{{16, 1, 2.0 * pi / (16.0 * k), 1.0, periodic, periodic}, g.nz, g.dz};
  for (const double along : {1.0, 0.0})
  {
    const double across = 1.0 - along;
    const Field q_x = sampled(g.surface, [&](int i, int j)
                              { return (along * c - across * s) * std::cos(m * i * 0.5 + n * j * 0.6); });
    const Field q_y = sampled(g.surface, [&](int i, int j)
                              { return (along * s + across * c) * std::cos(m * i * 0.5 + n * j * 0.6); });
    const Field q_l = sampled(straight.surface, [&](int i, int) { return along * std::cos(2.0 * pi * i / 16.0); });
    const Field q_t = sampled(straight.surface, [&](int i, int) { return across * std::cos(2.0 * pi * i / 16.0); });
    const auto oblique = StressField::of(HalfSpace(g, elastic), {.shear_x = q_x, .shear_y = q_y});
    const auto axial = StressField::of(HalfSpace(straight, elastic), {.shear_x = q_l, .shear_y = q_t});
    for (int layer = 0; layer < g.nz; ++layer)
    {
      // The wave at (i, j) from its values at the phases 0 and pi/2.
      const auto turned = [&](double phase)
      {
        const SymTensor even = axial.at(straight.index(0, 0, layer)), odd = axial.at(straight.index(4, 0, layer));
        SymTensor t{};
        for (std::size_t i = 0; i < 6; ++i)
          t[i] = even[i] * std::cos(phase) + odd[i] * std::sin(phase);
        return SymTensor{c * c * t[0] + s * s * t[1] - 2.0 * c * s * t[5],
                         s * s * t[0] + c * c * t[1] + 2.0 * c * s * t[5],
                         t[2],
                         s * t[4] + c * t[3],
                         c * t[4] - s * t[3],
                         c * s * (t[0] - t[1]) + (c * c - s * s) * t[5]};
      };
      for (const auto& [i, j] : {std::pair{0, 0}, {3, 1}, {7, 8}})
      {
        const SymTensor expected = turned(m * i * 0.5 + n * j * 0.6);
        for (std::size_t q = 0; q < 6; ++q)
          EXPECT_NEAR(oblique.at(g.index(i, j, layer))[q], expected[q], 1e-13) << "component " << q;
      }
    }
  }
}

} // namespace
} // namespace brinell::halfspace::periodic_shear_test
