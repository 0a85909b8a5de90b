// SPDX-License-Identifier: BSD-3-Clause
#include "simulation/plan/symmetry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace brinell::simulation::symmetry_test
{
namespace
{

/// Largest difference between the depths at y and -y.
double asymmetry(const Texture& texture)
{
  double difference = 0.0;
  for (double y = 0.03; y < 2.0; y += 0.17)
    for (double x = -2.0; x < 2.0; x += 0.23)
      difference = std::max(difference, std::abs(depth(texture, x, y) - depth(texture, x, -y)));
  return difference;
}

TEST(Symmetry, ShapesAreWhatTheirHeightsAre)
{
  const std::vector<Shape> shapes{Plane{},
                                  Paraboloid{1.0, 0.7},
                                  Paraboloid{1.0, -3.0},
                                  Roller{1.0, 1.3},
                                  Cone{1.1, 0.2},
                                  Pyramid{4, 1.19, 0.1},
                                  Pyramid{3, 1.14, 0.1},
                                  Pyramid{5, 1.0, 0.0},
                                  Pyramid{3, 1.0, 0.0}};
  for (const Shape& shape : shapes)
  {
    EXPECT_TRUE(is_symmetric_in_y(shape));
    for (double y = 0.0; y < 1.0; y += 0.09)
      for (double x = -1.0; x < 1.0; x += 0.11)
        EXPECT_NEAR(height(shape, x, y), height(shape, x, -y), 1e-12) << shape.index() << " at " << x << ", " << y;
  }
}

TEST(Symmetry, TexturesAreWhatTheirDepthsAre)
{
  const Dent dent{.x = 0.3, .y = 0.4, .depth = 0.1, .edge_radius = 0.2};
  Dent image = dent;
  image.y = -0.4;
  Dent deeper = image;
  deeper.depth = 0.2;
  const auto map = [](double y, bool mirrored)
  {
    return sampled([=](double u, double v) { return u + (mirrored ? std::abs(v - y) : v - y); }, 4, 5, 0.3, 0.2, 0.1,
                   y);
  };
  const auto waves = [](double y, double wavelength)
  { return Sinusoid{.amplitude = 0.1, .wavelength_x = 0.9, .wavelength_y = wavelength, .x = 0.2, .y = y}; };
  using Parts = std::vector<TexturePart>;
  struct Example
  {
    Texture texture;
    bool is_symmetric;
  };
  const std::vector<Example> examples{{{}, true},
                                      {dent, false},
                                      {Dent{.x = 0.3, .y = 0.0, .depth = 0.1, .edge_radius = 0.2}, true},
                                      {Parts{dent, image}, true},
                                      {Parts{dent, deeper}, false},
                                      {Parts{dent, image, image}, false},
                                      {map(0.0, true), true},
                                      {map(0.0, false), false},
                                      {map(0.3, true), false},
                                      {Parts{map(0.3, true), map(-0.3, true)}, true},
                                      {waves(0.0, 0.7), true},
                                      {waves(0.1, 0.7), false},
                                      {waves(0.35, 0.7), true},
                                      {waves(0.1, std::numeric_limits<double>::infinity()), true}};
  for (std::size_t i = 0; i < examples.size(); ++i)
  {
    EXPECT_EQ(is_symmetric_in_y(examples[i].texture), examples[i].is_symmetric) << i;
    EXPECT_EQ(asymmetry(examples[i].texture) < 1e-12, examples[i].is_symmetric) << i;
  }
  EXPECT_FALSE(is_symmetric_in_y(RandomSurface({.rms_height = 0.1, .cutoff = 0.5, .size_x = 1.0, .size_y = 1.0})));
}

TEST(Symmetry, IsUsedOnlyWhereItHolds)
{
  const constitutive::Material steel{{200e9, 0.3}, constitutive::PerfectPlasticity{1e9}};
  const SurfaceGrid grid{9, 7, 0.1, 0.1};
  const ShapedBody smooth{Paraboloid{1.0, 1.0}, steel};
  const ShapedBody dented{Plane{}, steel, Dent{.x = 0.0, .y = 0.1, .depth = 1e-6, .edge_radius = 0.025}};
  ShapedBody elastic = smooth;
  elastic.material.hardening.reset();
  const auto pair = [](const ShapedBody& lower, const ShapedBody& upper) { return PairCase{{}, lower, upper}; };
  PairCase switched_off = pair(smooth, elastic);
  switched_off.solver.symmetry = false;
  EXPECT_TRUE(is_solved_by_halves(pair(smooth, elastic), grid));
  EXPECT_FALSE(is_solved_by_halves(switched_off, grid));
  EXPECT_FALSE(is_solved_by_halves(pair(smooth, dented), grid));
  EXPECT_FALSE(is_solved_by_halves(pair(dented, smooth), grid));
  EXPECT_FALSE(is_solved_by_halves(pair(elastic, elastic), grid)) << "nothing to gain";
  EXPECT_FALSE(is_solved_by_halves(pair(smooth, elastic), grid, true)) << "partial slip";
  EXPECT_FALSE(is_solved_by_halves(pair(smooth, elastic), {9, 1, 0.1, 0.1})) << "one row";
}

} // namespace
} // namespace brinell::simulation::symmetry_test
