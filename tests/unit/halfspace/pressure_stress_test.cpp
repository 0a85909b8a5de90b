// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/half_space.hpp"

#include "brinell/green/rectangle.hpp"
#include "brinell/reference/hertz.hpp"
#include "gauss.hpp"
#include "order.hpp"
#include "random_field.hpp"
#include "tensors.hpp"
#include "volume_fields.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace brinell::halfspace::pressure_stress_test
{
namespace
{

using test::StressField;

class PressureStressTest : public testing::TestWithParam<VolumeGrid>
{
};

INSTANTIATE_TEST_SUITE_P(Grids, PressureStressTest,
                         testing::Values(VolumeGrid{{6, 6, 1.0, 1.0}, 3, 1.0}, VolumeGrid{{9, 4, 0.5, 1.5}, 4, 0.3},
                                         VolumeGrid{{1, 5, 1.0, 1.0}, 1, 2.0},
                                         VolumeGrid{{11, 7, 1e-6, 2e-6}, 2, 5e-7}),
                         [](const auto& p)
                         {
                           const VolumeGrid& g = p.param;
                           return std::to_string(g.surface.nx) + "x" + std::to_string(g.surface.ny) + "x" +
                                  std::to_string(g.nz);
                         });

TEST_P(PressureStressTest, EqualsTheSumOfRectanglesMeanOverALayer)
{
  const VolumeGrid& g = GetParam();
  const SurfaceGrid& s = g.surface;
  const double nu = 0.3;
  const std::vector<double> pressure = test::random_field(s.size(), 1);
  const StressField fast(HalfSpace(g, {1.0, nu}), pressure, {});
  const test::Gauss layer(3, -0.5, 0.5);
  for (int k = 0; k < g.nz; ++k)
    for (int j = 0; j < s.ny; ++j)
      for (int i = 0; i < s.nx; ++i)
      {
        SymTensor sum{};
        for (int m = 0; m < s.ny; ++m)
          for (int l = 0; l < s.nx; ++l)
            for (std::size_t q = 0; q < layer.point.size(); ++q)
              test::add(green::rectangle_stress((i - l) * s.dx, (j - m) * s.dy, (k + 0.5 + layer.point[q]) * g.dz, s.dx,
                                                s.dy, nu),
                        layer.weight[q] * pressure[s.index(l, m)], sum);
        const SymTensor found = fast.at(g.index(i, j, k));
        for (std::size_t c = 0; c < 6; ++c) // round-off of the transforms; stresses and pressures of order one
          EXPECT_NEAR(found[c], sum[c], 1e-13) << "component " << c << " at " << i << ' ' << j << ' ' << k;
      }
}

TEST_P(PressureStressTest, ItsTransposeIsTheSurfaceDisplacementOfPlasticStrain)
{
  // Betti: integral of stress(p) : eps over the volume = integral of p u(eps) over the surface.
  const VolumeGrid& g = GetParam();
  const HalfSpace half_space(g, {1.0, 0.3});
  const std::vector<double> strain = test::random_field(Deviator::size * g.size(), 2);
  const std::vector<double> pressure = test::random_field(g.surface.size(), 3);
  HalfSpace::Work work = half_space.make_work();
  std::vector<double> u(g.surface.size());
  half_space.load(strain, g.nz, work).displacement({.z = u});
  const std::vector<double> stress = StressField(half_space, pressure, {}).deviator;
  const double inside = test::contracted(stress, strain) * g.cell_volume();
  const double outside = test::dot(pressure, u) * g.surface.cell_area();
  const double scale = std::sqrt(test::contracted(stress, stress) * test::contracted(strain, strain)) * g.cell_volume();
  EXPECT_NEAR(inside, outside, 1e-13 * scale);
}

TEST(UniformPressureStressTest, IsThatOfAHeldLayerUnderTheMiddleOfALargePatch)
{
  // At depth z << a under the middle of a square of side 2a: sigma_zz = -p, sigma_xx = sigma_yy = -(1 + 2 nu)/2 p, no
  // shear (Johnson 1985, Eq. 3.33 for the circle; the square has the same trace and symmetry). Error of first order in
  // z/a, with a factor of order one.
  const double nu = 0.3, p = 2.0;
  const int n = 61;
  const VolumeGrid g{{n, n, 1.0, 1.0}, 2, 0.1};
  const StressField stress(HalfSpace(g, {1.0, nu}), std::vector<double>(g.surface.size(), p), {});
  const std::array<double, 6> expected{-0.5 * (1.0 + 2.0 * nu) * p, -0.5 * (1.0 + 2.0 * nu) * p, -p, 0.0, 0.0, 0.0};
  for (int k = 0; k < g.nz; ++k)
  {
    const SymTensor found = stress.at(g.index(n / 2, n / 2, k));
    const double bound = 2.0 * p * (k + 0.5) * g.dz / (0.5 * n);
    for (std::size_t c = 0; c < 6; ++c)
      EXPECT_NEAR(found[c], expected[c], bound) << "component " << c;
  }
}

TEST(HertzStressTest, MeetsHubersUnderAHertzPressure)
{
  // The pressure of a cell is its mean; the stress is compared with the mean of the exact one over the layer, on the
  // axis and beside it. Second order in the cell.
  const double nu = 0.3;
  const double root = std::sqrt(0.15);
  std::vector<double> errors;
  for (const int cells : {4, 8, 16})
  {
    const int n = 2 * cells + 3, middle = n / 2;
    const double h = 1.0 / cells;
    const VolumeGrid g{{n, n, h, h}, 2 * cells, h};
    constexpr int parts = 32;
    std::vector<double> pressure(g.surface.size());
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        for (int b = 0; b < parts; ++b)
          for (int a = 0; a < parts; ++a)
          {
            const double x = (i - middle - 0.5 + (a + 0.5) / parts) * h, y = (j - middle - 0.5 + (b + 0.5) / parts) * h;
            pressure[static_cast<std::size_t>(i + n * j)] +=
                std::sqrt(std::max(0.0, 1.0 - x * x - y * y)) / (parts * parts);
          }
    const StressField stress(HalfSpace(g, {1.0, nu}), pressure, {});
    double largest = 0.0;
    for (const int off : {0, cells / 4, cells / 2}) // the same places on every grid
      for (int k = cells / 4; k < 2 * cells; ++k)
      {
        SymTensor expected{};
        for (const auto& [point, weight] : {std::array{-root, 5.0 / 18.0}, {0.0, 8.0 / 18.0}, {root, 5.0 / 18.0}})
        {
          const SymTensor part =
              reference::point_contact_stress(off * h, -off * h, (k + 0.5 + point) * h, 1.0, 1.0, nu);
          for (std::size_t c = 0; c < 6; ++c)
            expected[c] += weight * part[c];
        }
        const SymTensor found = stress.at(g.index(middle + off, middle - off, k));
        for (std::size_t c = 0; c < 6; ++c)
          largest = std::max(largest, std::abs(found[c] - expected[c]));
      }
    errors.push_back(largest);
  }
  EXPECT_GT(test::Orders("Huber's stress under a Hertz pressure", errors).last, 1.8);
  EXPECT_LT(errors.back(), 2e-3);
}

} // namespace
} // namespace brinell::halfspace::pressure_stress_test
