// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/green/cuboid.hpp"
#include "brinell/green/rectangle.hpp"

#include "gauss.hpp"
#include "oracle_table.hpp"
#include "tensors.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

namespace brinell::green::cuboid_half_space_test
{
namespace
{

using std::numbers::pi;
using test::component_names;
using test::unit_tensor;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

// Cuboid, image and freeing pressure, each a sum over eight corners of terms of size pi: stress per E.
constexpr double rounding = 64.0 * epsilon;

struct OracleCase
{
  double x, y, z, zc, dx, dy, dz, nu;
  SymTensor strain, stress;
  double u_z;
};

std::vector<OracleCase> oracle_cases()
{
  const test::OracleTable oracle("cuboid_oracle.csv");
  std::vector<OracleCase> cases;
  for (std::size_t row = 0; row < oracle.size(); ++row)
  {
    if (oracle.text(row, "kind") != "half")
      continue;
    const auto at = [&](const std::string& column) { return oracle.number(row, column); };
    OracleCase c{at("x"), at("y"), at("z"), at("zc"), at("dx"), at("dy"), at("dz"), at("nu"), {}, {}, at("u_z")};
    for (std::size_t i = 0; i < 6; ++i)
    {
      c.strain[i] = oracle.text(row, "eigenstrain") == component_names[i] ? 1.0 : 0.0;
      c.stress[i] = at(component_names[i] + std::string("_per_E"));
    }
    cases.push_back(c);
  }
  return cases;
}

TEST(CuboidHalfSpaceTest, StressEqualsIntegratedPointForces)
{
  const auto cases = oracle_cases();
  EXPECT_EQ(cases.size(), 11U * 6U);
  for (const OracleCase& c : cases)
  {
    const SymTensor stress =
        cuboid_stress_half_space(c.x, c.y, c.z, c.zc, c.dx, c.dy, c.dz, c.strain, Elastic{1.0, c.nu});
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_NEAR(stress[i], c.stress[i], rounding) << c.x << ' ' << c.y << ' ' << c.z << ' ' << component_names[i];
  }
}

TEST(CuboidHalfSpaceTest, SurfaceDisplacementEqualsIntegratedPointForces)
{
  int surface_points = 0;
  for (const OracleCase& c : oracle_cases())
  {
    if (c.z != 0.0)
      continue;
    ++surface_points;
    // Corner terms of the size of the distance times a few.
    EXPECT_NEAR(cuboid_surface_displacement(c.x, c.y, c.zc, c.dx, c.dy, c.dz, c.strain, c.nu), c.u_z,
                32.0 * epsilon * (1.0 + std::hypot(c.x, c.y)));
  }
  EXPECT_EQ(surface_points, 3 * 6);
}

TEST(CuboidHalfSpaceTest, SurfaceIsFreeOfTraction)
{
  for (const double nu : {0.0, 0.3, 0.49})
    for (std::size_t component = 0; component < 6; ++component)
      for (const double zc : {0.3, 0.5, 2.0}) // touching the surface first
        for (const auto& [x, y] : {std::array{0.1, -0.2}, std::array{0.9, 0.3}, std::array{-2.0, 1.5}})
        {
          const SymTensor s =
              cuboid_stress_half_space(x, y, 0.0, zc, 1.0, 0.8, 0.6, unit_tensor(component), Elastic{1.0, nu});
          for (const std::size_t c : {2U, 3U, 4U})
            EXPECT_NEAR(s[c], 0.0, rounding) << component_names[component] << ' ' << component_names[c] << ' ' << zc;
        }
}

TEST(CuboidHalfSpaceTest, SurfaceTouchingCuboidIsTheLimitFromBelow)
{
  // One-sided: at z = 0 the stresses along the surface are those just inside. Probe 1e-10 below, gradients of order 10.
  for (std::size_t component = 0; component < 6; ++component)
  {
    const auto stress = [&](double z) {
      return cuboid_stress_half_space(0.2, -0.1, z, 0.3, 1.0, 0.8, 0.6, unit_tensor(component), Elastic{1.0, 0.3});
    };
    const SymTensor on = stress(0.0), below = stress(1e-10);
    for (std::size_t c = 0; c < 6; ++c)
      EXPECT_NEAR(on[c], below[c], 1e-8) << component_names[component] << ' ' << component_names[c];
  }
}

TEST(CuboidHalfSpaceTest, DeepCuboidIsInFullSpace)
{
  // The surface's part falls with the cube of the depth.
  const Elastic elastic{1.0, 0.3};
  for (std::size_t component = 0; component < 6; ++component)
  {
    const auto difference = [&](double zc)
    {
      const SymTensor half =
          cuboid_stress_half_space(0.2, 0.1, zc + 0.7, zc, 1.0, 0.8, 0.6, unit_tensor(component), elastic);
      const SymTensor full = cuboid_stress(0.2, 0.1, 0.7, 1.0, 0.8, 0.6, unit_tensor(component), elastic);
      double largest = 0.0;
      for (std::size_t c = 0; c < 6; ++c)
        largest = std::max(largest, std::abs(half[c] - full[c]));
      return largest;
    };
    EXPECT_NEAR(std::log2(difference(50.0) / difference(100.0)), 3.0, 0.1) << component_names[component];
    EXPECT_LT(difference(100.0), 1e-6);
  }
}

TEST(CuboidHalfSpaceTest, EightHalfSizeCuboidsMakeOne)
{
  const Elastic elastic{1.0, 0.3};
  const SymTensor strain{0.3, -0.7, 0.2, 0.4, -0.5, 0.6};
  for (const auto& [x, y, z] : {std::array{0.11, 0.23, 0.4}, std::array{0.9, -0.3, 0.1}, std::array{-0.2, 0.1, 2.0}})
  {
    SymTensor sum{};
    double displacement = 0.0;
    for (const double a : {-0.25, 0.25})
      for (const double b : {-0.25, 0.25})
        for (const double c : {-0.25, 0.25})
        {
          const SymTensor part = cuboid_stress_half_space(x - a, y - b, z, 0.7 + c, 0.5, 0.5, 0.5, strain, elastic);
          for (std::size_t i = 0; i < 6; ++i)
            sum[i] += part[i];
          displacement += cuboid_surface_displacement(x - a, y - b, 0.7 + c, 0.5, 0.5, 0.5, strain, 0.3);
        }
    const SymTensor whole = cuboid_stress_half_space(x, y, z, 0.7, 1.0, 1.0, 1.0, strain, elastic);
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_NEAR(sum[i], whole[i], 8.0 * rounding) << component_names[i];
    EXPECT_NEAR(displacement, cuboid_surface_displacement(x, y, 0.7, 1.0, 1.0, 1.0, strain, 0.3), 8.0 * rounding);
  }
}

TEST(CuboidHalfSpaceTest, DivergenceVanishesInSecondOrder)
{
  for (std::size_t component = 0; component < 6; ++component)
  {
    const auto divergence = [&](double h)
    {
      return test::divergence(
          0.4, 0.25, 0.3, h,
          [&](double x, double y, double z) {
            return cuboid_stress_half_space(x, y, z, 0.9, 1.0, 0.8, 0.6, unit_tensor(component), Elastic{1.0, 0.3});
          });
    };
    EXPECT_NEAR(std::log2(divergence(1e-2) / divergence(5e-3)), 2.0, 0.05) << component_names[component];
  }
}

TEST(CuboidHalfSpaceTest, TwoCuboidsAreReciprocal)
{
  // Gauss points as in full space; the one cuboid touches the surface.
  const Elastic elastic{1.0, 0.3};
  const double ax = 0.0, ay = 0.0, az = 0.3, bx = 1.1, by = -0.4, bz = 1.4;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j)
    {
      const double over_a =
          test::box_integral(12, ax - 0.5, ax + 0.5, ay - 0.4, ay + 0.4, az - 0.3, az + 0.3,
                             [&](double x, double y, double z)
                             {
                               return double_contraction(cuboid_stress_half_space(x - bx, y - by, z, bz, 0.6, 0.4, 0.8,
                                                                                  unit_tensor(j), elastic),
                                                         unit_tensor(i));
                             });
      const double over_b =
          test::box_integral(12, bx - 0.3, bx + 0.3, by - 0.2, by + 0.2, bz - 0.4, bz + 0.4,
                             [&](double x, double y, double z)
                             {
                               return double_contraction(cuboid_stress_half_space(x - ax, y - ay, z, az, 1.0, 0.8, 0.6,
                                                                                  unit_tensor(i), elastic),
                                                         unit_tensor(j));
                             });
      EXPECT_NEAR(over_a, over_b, 1e-10) << component_names[i] << ' ' << component_names[j];
    }
}

TEST(CuboidHalfSpaceTest, SurfaceDisplacementIsBettisIntegral)
{
  // Mean displacement of a rectangle times its area = integral over the cuboid of the stress of a unit pressure on the
  // rectangle : eigenstrain. Both integrands are smooth at a distance of 0.4 sides: 1e-10 with 16 points.
  const double zc = 0.9, nu = 0.3;
  for (std::size_t component = 0; component < 6; ++component)
  {
    const test::Gauss u(16, 0.1, 0.7), v(16, -0.5, 0.3);
    double over_rectangle = 0.0;
    for (std::size_t i = 0; i < 16; ++i)
      for (std::size_t j = 0; j < 16; ++j)
        over_rectangle +=
            u.weight[i] * v.weight[j] *
            cuboid_surface_displacement(u.point[i], v.point[j], zc, 1.0, 0.8, 1.0, unit_tensor(component), nu);
    const double over_cuboid = test::box_integral(
        16, -0.5, 0.5, -0.4, 0.4, zc - 0.5, zc + 0.5,
        [&](double x, double y, double z)
        { return double_contraction(rectangle_stress(x - 0.4, y + 0.1, z, 0.6, 0.8, nu), unit_tensor(component)); });
    EXPECT_NEAR(over_rectangle, over_cuboid, 1e-10) << component_names[component];
  }
}

TEST(CuboidHalfSpaceTest, DilatationLiftsTheSurfaceAsMindlinAndCheng)
{
  // 4 (1 - nu) times the full-space displacement (1 + nu)/(1 - nu) e/(4 pi) d(phi)/dz, phi = integral of 1/R; also far
  // away, where the cuboid is Mogi's point.
  for (const double nu : {0.0, 0.3, 0.45})
    for (const auto& [x, y] : {std::array{0.3, -0.2}, std::array{40.0, 30.0}})
    {
      const double e = 1e-3, zc = 1.1;
      const double attraction =
          test::box_integral(20, -0.5, 0.5, -0.4, 0.4, zc - 0.3, zc + 0.3,
                             [&](double u, double v, double w)
                             { return w / std::pow((x - u) * (x - u) + (y - v) * (y - v) + w * w, 1.5); });
      const double full = -(1.0 + nu) / (1.0 - nu) * e / (4.0 * pi) * attraction;
      const double half = cuboid_surface_displacement(x, y, zc, 1.0, 0.8, 0.6, {e, e, e, 0.0, 0.0, 0.0}, nu);
      EXPECT_LT(half, 0.0);
      EXPECT_NEAR(half, 4.0 * (1.0 - nu) * full, 1e-12 * e * (1.0 + std::hypot(x, y)));
    }
}

/// Force across a whole horizontal plane (axis 2, at z = level) or across the part of a vertical plane below the
/// surface (axis 0, at x = level): polar coordinates with r = t/(1 - t), which makes a decay as r^-3 smooth.
double force_across_plane(std::size_t axis, double level, std::size_t component)
{
  const test::Gauss radius(60, 0.0, 1.0), angle(60, 0.0, axis == 2 ? 2.0 * pi : pi);
  double sum = 0.0;
  for (std::size_t i = 0; i < 60; ++i)
    for (std::size_t j = 0; j < 60; ++j)
    {
      const double t = radius.point[i], r = t / (1.0 - t);
      const double u = r * std::cos(angle.point[j]), v = r * std::sin(angle.point[j]);
      const double weight = radius.weight[i] * angle.weight[j] * r / ((1.0 - t) * (1.0 - t));
      const double x = axis == 2 ? u : level, y = axis == 2 ? v : u, z = axis == 2 ? level : v;
      sum += weight * cuboid_stress_half_space(x, y, z, 1.0, 1.0, 0.8, 0.6, unit_tensor(component), {1.0, 0.3})[axis];
    }
  return sum;
}

TEST(CuboidHalfSpaceTest, ResidualForcesBalanceOnEveryPlane)
{
  // Nothing pulls on the body, so no net force crosses a plane. The planes pass beside the cuboid, where the integrand
  // is smooth, and the rule converges exponentially. What is left is the rounding of the stress, 4 eps or so, times the
  // area of the circle that the farthest points stand for, of radius 2600.
  const double tolerance = 4.0 * epsilon * pi * 2600.0 * 2600.0;
  for (std::size_t component = 0; component < 6; ++component)
  {
    EXPECT_NEAR(force_across_plane(2, 0.4, component), 0.0, tolerance) << component_names[component];
    EXPECT_NEAR(force_across_plane(2, 1.9, component), 0.0, tolerance) << component_names[component];
    EXPECT_NEAR(force_across_plane(0, 0.9, component), 0.0, tolerance) << component_names[component];
  }
}

} // namespace
} // namespace brinell::green::cuboid_half_space_test
