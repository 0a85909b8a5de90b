// SPDX-License-Identifier: BSD-3-Clause
// Plastic strain -> residual stress against closed forms: the cuboid under a free surface, and Eshelby's inclusion.
#include "brinell/halfspace/half_space.hpp"

#include "brinell/green/cuboid.hpp"
#include "direct/smooth_strain.hpp"
#include "order.hpp"
#include "volume_fields.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace brinell::halfspace
{
namespace
{

using test::unit_deviator;

class EigenstrainClosedFormTest : public testing::TestWithParam<int>
{
};

// The operator is exact for a strain that is constant in each layer and smooth in the plane, and gives the layer's mean;
// the reference is the sum of cuboids, refined in the plane. What is left: the blob's spectrum beyond the grid's
// wavenumbers, exp(-(1.5 pi)^2/2) = 1.5e-5; its edge cut off at 5 s, exp(-12.5) = 4e-6; the extrapolated sum, 1e-5
// (against five parts a cell); and the operator's treatment of the periodic images, which has the rest of the 1e-4 that
// the free boundary is promised.
TEST_P(EigenstrainClosedFormTest, SmoothBlobUnderAFreeSurfaceMeetsTheSumOfCuboids)
{
  const Elastic elastic{1.0, 0.3};
  const VolumeGrid grid{{25, 17, 1.0, 1.2}, 8, 0.9};
  const double sx = 1.5 * grid.surface.dx;
  const double sy = 1.5 * grid.surface.dy;
  const std::array<double, 8> profile{1.0, 0.0, 0.0, -0.7, 0.0, 0.0, 0.0, 0.0};
  const Deviator strain = unit_deviator(GetParam());
  const auto blob = [&](double x, double y)
  {
    const double r2 = std::pow((x - 7.7 * grid.surface.dx) / sx, 2) + std::pow((y - 8.2 * grid.surface.dy) / sy, 2);
    return r2 < 27.0 ? std::exp(-0.5 * r2) : 0.0;
  };
  const direct::LayeredStrain layered = [&](double x, double y, int layer)
  { return test::as_tensor((profile[static_cast<std::size_t>(layer)] * blob(x, y)) * strain); };

  const test::StressField stress(HalfSpace(grid, elastic), {},
                                 test::sampled_strain(grid, strain,
                                                      [&](double x, double y, double z)
                                                      { return profile[static_cast<std::size_t>(z / 0.9)] * blob(x, y); }));
  constexpr std::array<std::array<int, 3>, 8> points{
      {{8, 8, 0}, {10, 7, 0}, {6, 10, 1}, {8, 9, 3}, {10, 10, 4}, {8, 8, 7}, {23, 15, 0}, {24, 0, 7}}};
  const double scale = 2.0 * elastic.shear_modulus();
  double worst = 0.0;
  for (const auto& [i, j, k] : points)
  {
    const SymTensor expected = direct::extrapolated_strain_stress(grid, layered, i, j, k, elastic);
    const SymTensor found = stress.at(test::cell_index(grid, i, j, k));
    for (std::size_t c = 0; c < 6; ++c)
    {
      EXPECT_NEAR(found[c], expected[c], 1e-4 * scale) << "component " << c << " at " << i << ' ' << j << ' ' << k;
      worst = std::max(worst, std::abs(found[c] - expected[c]) / scale);
    }
  }
  std::printf("strain %s: largest difference %.2e of 2 mu max|eps|\n",
              test::deviator_names[static_cast<std::size_t>(GetParam())], worst);
}

INSTANTIATE_TEST_SUITE_P(Strains, EigenstrainClosedFormTest, testing::Range(0, Deviator::size),
                         [](const auto& p) { return test::deviator_names[static_cast<std::size_t>(p.param)]; });

} // namespace
} // namespace brinell::halfspace
