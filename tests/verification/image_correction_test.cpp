// SPDX-License-Identifier: BSD-3-Clause
// What is left of the periodic images of plastic strain: grids of any aspect, long in x and long in y, thin and thick.
#include "brinell/halfspace/half_space.hpp"

#include "direct/smooth_strain.hpp"
#include "volume_fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

namespace brinell::halfspace::image_correction_test
{
namespace
{

const Elastic elastic{1.0, 0.3};
constexpr double promised = 1e-4; ///< of 2 mu max|eps|

/// A strain over cells (i, j), 1 at most. All of them are resolved by the cells, and zero where the grid ends: else not the
/// images would be seen but the interpolant of strain that the cells do not resolve, which also feels the padded length.
struct Shape
{
  const char* name;
  std::function<double(const SurfaceGrid&, double, double)> value;
};

/// 1 inside a grid of `cells`, falling to zero, to 3e-5 of 1, within the last ten cells.
double plateau(double i, int cells)
{
  const double s = 1.25 * std::sqrt(2.0);
  return 0.5 * (std::erf((i - 5.0) / s) - std::erf((i - (cells - 6.0)) / s));
}

double bell(double distance, double width)
{
  return std::exp(-0.5 * distance * distance / (width * width));
}

std::vector<Shape> shapes()
{
  return {
      {"one place in the middle", [](const SurfaceGrid& s, double i, double j)
       { return bell(i - 0.5 * (s.nx - 1), 1.3) * bell(j - 0.5 * (s.ny - 1), 1.3); }},
      {"one place at the end",
       [](const SurfaceGrid&, double i, double j) { return bell(i - 5.5, 1.3) * bell(j - 5.5, 1.3); }},
      {"a row along the grid",
       [](const SurfaceGrid& s, double i, double j)
       {
         return s.nx >= s.ny ? plateau(i, s.nx) * bell(j - 0.5 * (s.ny - 1), 1.3)
                             : plateau(j, s.ny) * bell(i - 0.5 * (s.nx - 1), 1.3);
       }},
      {"all of the grid", [](const SurfaceGrid& s, double i, double j) { return plateau(i, s.nx) * plateau(j, s.ny); }},
      {"signs that change", [](const SurfaceGrid& s, double i, double j)
       { return plateau(i, s.nx) * plateau(j, s.ny) * std::cos(0.37 * i + 0.9) * std::cos(0.61 * j + 0.2); }}};
}

class ImageCorrectionTest : public testing::TestWithParam<VolumeGrid>
{
};

// The same strain on a square grid at least as wide as this one is long, and 1.5 times if that is short: there the images are
// far from a narrow strain, and taken off by the polynomial alone, not by waves. Every cell of the grid is compared.
TEST_P(ImageCorrectionTest, StrainHasNoImages)
{
  const VolumeGrid& grid = GetParam();
  VolumeGrid wide = grid;
  const int longest = std::max(grid.surface.nx, grid.surface.ny);
  const bool is_long = longest > 2 * std::min(grid.surface.nx, grid.surface.ny);
  wide.surface.nx = wide.surface.ny = is_long ? longest : 3 * longest / 2;
  const HalfSpace narrow_space(grid, elastic);
  const HalfSpace wide_space(wide, elastic);
  const double scale = 2.0 * elastic.shear_modulus();
  for (const Shape& shape : shapes())
  {
    double worst = 0.0;
    for (int component = 0; component < Deviator::size; ++component)
    {
      const auto profile = [&](double x, double y, double)
      {
        const bool inside = x < grid.surface.nx - 0.5 && y < grid.surface.ny - 0.5;
        return inside ? shape.value(grid.surface, x, y) : 0.0;
      };
      const Deviator unit = test::unit_deviator(component);
      const test::StressField narrow(narrow_space, {}, test::sampled_strain(grid, unit, profile));
      const test::StressField reference(wide_space, {}, test::sampled_strain(wide, unit, profile));
      for (int k = 0; k < grid.nz; ++k)
        for (int j = 0; j < grid.surface.ny; ++j)
          for (int i = 0; i < grid.surface.nx; ++i)
          {
            const SymTensor a = narrow.at(grid.index(i, j, k));
            const SymTensor b = reference.at(wide.index(i, j, k));
            for (std::size_t c = 0; c < 6; ++c)
              worst = std::max(worst, std::abs(a[c] - b[c]) / scale);
          }
    }
    std::printf("%d x %d x %d, %s: images leave %.1e of 2 mu max|eps|\n", grid.surface.nx, grid.surface.ny, grid.nz,
                shape.name, worst);
    EXPECT_LE(worst, promised) << shape.name;
  }
}

VolumeGrid cubes(int nx, int ny, int nz)
{
  return {{nx, ny, 1.0, 1.0}, nz, 1.0};
}

INSTANTIATE_TEST_SUITE_P(Grids, ImageCorrectionTest,
                         testing::Values(cubes(16, 16, 4), cubes(24, 24, 24), cubes(19, 16, 4), cubes(24, 16, 4),
                                         cubes(32, 16, 4), cubes(16, 32, 4), cubes(64, 16, 4), cubes(16, 64, 4),
                                         cubes(48, 16, 16), cubes(16, 48, 16), cubes(128, 16, 2), cubes(16, 128, 2),
                                         cubes(192, 12, 2), cubes(12, 192, 2)),
                         [](const auto& p)
                         {
                           const VolumeGrid& g = p.param;
                           return std::to_string(g.surface.nx) + "x" + std::to_string(g.surface.ny) + "x" +
                                  std::to_string(g.nz);
                         });

// Without any transform: the closed form of cuboids, refined in the plane, for a track on a long grid.
TEST(LongGridTest, TrackMeetsTheSumOfCuboids)
{
  const VolumeGrid grid = cubes(130, 18, 2);
  const auto track = [&](double x, double y) { return plateau(x, grid.surface.nx) * bell(y - 8.5, 1.8); };
  const double scale = 2.0 * elastic.shear_modulus();
  for (const int component : {Deviator::xx, Deviator::xz})
  {
    const Deviator strain = test::unit_deviator(component);
    const direct::LayeredStrain layered = [&](double x, double y, int)
    { return test::as_tensor(track(x, y) * strain); };
    const test::StressField found(
        HalfSpace(grid, elastic), {},
        test::sampled_strain(grid, strain, [&](double x, double y, double) { return track(x, y); }));
    double worst = 0.0;
    for (const auto& [i, j] : {std::pair{65, 8}, {20, 15}})
    {
      const SymTensor expected = direct::extrapolated_strain_stress(grid, layered, i, j, 0, 5, elastic);
      for (std::size_t c = 0; c < 6; ++c)
        worst = std::max(worst, std::abs(found.at(grid.index(i, j, 0))[c] - expected[c]) / scale);
    }
    std::printf("track on 130 x 18 cells, strain %s: %.1e of 2 mu max|eps| from the sum of cuboids\n",
                test::deviator_names[static_cast<std::size_t>(component)], worst);
    EXPECT_LE(worst, 2.0 * promised); // the images', and as much for the sum's error (EigenstrainClosedFormTest)
  }
}

} // namespace
} // namespace brinell::halfspace::image_correction_test
