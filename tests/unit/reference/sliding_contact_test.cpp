// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/reference/sliding_contact.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/reference/hertz.hpp"
#include "gauss.hpp"
#include "point_force.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace brinell::reference::sliding_contact_test
{
namespace
{

using std::numbers::pi;

TEST(SlidingPointContactTest, StressIsTheIntegralOfPointForces)
{
  // Cerruti's point force over the disc: r = sin(t), so that the shear's root is smooth, and the trapezium rule round.
  const double a = 2e-3, q0 = 3e8, nu = 0.31;
  const test::Gauss along(80, 0.0, 0.5 * pi);
  constexpr int round = 160;
  for (const auto& [x, y, z] : {std::array{0.2, -0.3, 0.4}, {-0.9, 0.1, 0.3}, {1.4, 0.8, 0.5}, {0.0, 0.0, 0.6}})
  {
    SymTensor sum{};
    for (std::size_t i = 0; i < along.point.size(); ++i)
      for (int j = 0; j < round; ++j)
      {
        const double r = std::sin(along.point[i]), phi = 2.0 * pi * j / round;
        const SymTensor part = test::point_force_along_x(x - r * std::cos(phi), y - r * std::sin(phi), z, nu);
        const double weight = along.weight[i] * r * std::pow(std::cos(along.point[i]), 2) * 2.0 * pi / round;
        for (std::size_t c = 0; c < 6; ++c)
          sum[c] += q0 * weight * part[c];
      }
    const SymTensor found = point_contact_shear_stress(a * x, a * y, a * z, a, q0, nu);
    for (std::size_t c = 0; c < 6; ++c) // the quadrature: 80 points at a depth of 0.3 radii or more
      EXPECT_NEAR(found[c], sum[c], 1e-9 * q0) << "component " << c << " at " << x << ' ' << y << ' ' << z;
  }
}

TEST(SlidingPointContactTest, SurfaceCarriesTheShearAndIsPulledBehind)
{
  const double nu = 0.3;
  for (const double x : {-0.999, -0.6, 0.0, 0.3, 0.95})
  {
    const SymTensor s = point_contact_shear_stress(x, 0.0, 0.0, 1.0, 1.0, nu);
    const std::array expected{
        -pi * (4.0 + nu) * x / 8.0, -3.0 * pi * nu * x / 8.0, 0.0, 0.0, -std::sqrt(1.0 - x * x), 0.0};
    for (std::size_t c = 0; c < 6; ++c)
      EXPECT_NEAR(s[c], expected[c], 1e-8) << "component " << c << " at " << x; // as documented near the rim
  }
  const SymTensor at_rim = point_contact_shear_stress(-1.0, 0.0, 0.0, 1.0, 1.0, nu);
  EXPECT_NEAR(at_rim[0], pi * (4.0 + nu) / 8.0, 1e-7);
  for (const double x : {1.001, 1.5, 4.0})
  {
    const SymTensor outside = point_contact_shear_stress(x, 0.3, 0.0, 1.0, 1.0, nu);
    for (const std::size_t c : {2, 3, 4})
      EXPECT_NEAR(outside[c], 0.0, 1e-8) << "no traction at " << x;
  }
}

TEST(SlidingLineContactTest, StressIsTheIntegralOfLineForces)
{
  // sqrt(1 - s^2) ds by Chebyshev's rule of the second kind, to rounding at these depths.
  constexpr int n = 400;
  const double nu = 0.27;
  for (const auto& [x, z] : {std::array{0.3, 0.4}, {-0.7, 1.1}, {1.3, 0.2}, {0.0, 0.3}})
  {
    double xx = 0.0, zz = 0.0, xz = 0.0;
    for (int i = 1; i < n; ++i)
    {
      const double angle = pi * i / n, dx = x - std::cos(angle);
      const double flamant = -2.0 / pi * dx / std::pow(dx * dx + z * z, 2) * std::pow(std::sin(angle), 2) * pi / n;
      xx += flamant * dx * dx;
      zz += flamant * z * z;
      xz += flamant * dx * z;
    }
    const SymTensor s = line_contact_shear_stress(x, z, 1.0, 1.0, nu);
    const std::array expected{xx, nu * (xx + zz), zz, 0.0, xz, 0.0};
    for (std::size_t c = 0; c < 6; ++c)
      EXPECT_NEAR(s[c], expected[c], 1e-12) << "component " << c << " at " << x << ' ' << z;
  }
}

/// The largest stress of a scan over the half space around the contact.
template <typename Stress>
double scanned(const Stress& stress, bool off_the_plane)
{
  double largest = 0.0;
  for (double x = -1.0; x < 1.01; x += 0.05)
    for (double y = 0.0; y < (off_the_plane ? 1.01 : 0.01); y += 0.1)
      for (double z = 0.0; z < 1.2; z += 0.02)
        largest = std::max(largest, von_mises(stress(x, y, z)));
  return largest;
}

TEST(SlidingFirstYieldTest, IsWhereAScanFindsTheLargestStress)
{
  for (const double friction : {0.1, 0.25, 0.35, 0.5})
  {
    const SlidingYield point = sliding_first_yield(0.3, friction);
    const auto point_stress = [&](double x, double y, double z)
    { return sliding_point_contact_stress(x, y, z, 1.0, 1.0, 0.3, friction); };
    const double at_place = von_mises(point_stress(point.x_ratio, 0.0, point.depth_ratio));
    EXPECT_NEAR(at_place * point.pressure_ratio, 1.0, 1e-12);
    const double largest = scanned(point_stress, true);
    EXPECT_LE(largest, at_place * (1.0 + 1e-8));
    EXPECT_GT(largest, at_place * (1.0 - 2e-3)); // between the places of the scan
    const SlidingYield line = line_sliding_first_yield(0.3, friction);
    const double of_line = scanned(
        [&](double x, double, double z) { return sliding_line_contact_stress(x, z, 1.0, 1.0, 0.3, friction); }, false);
    EXPECT_LE(of_line * line.pressure_ratio, 1.0 + 1e-8);
    EXPECT_GT(of_line * line.pressure_ratio, 1.0 - 2e-3);
  }
}

TEST(SlidingFirstYieldTest, ClimbsToTheEdgeNearFrictionThreeTenths)
{
  EXPECT_EQ(sliding_first_yield(0.3, 0.0).pressure_ratio, first_yield(0.3).pressure_ratio);
  EXPECT_EQ(line_sliding_first_yield(0.3, 0.0).depth_ratio, line_contact_first_yield(0.3).depth_ratio);
  EXPECT_NEAR(sliding_first_yield(0.3, 1e-6).pressure_ratio, first_yield(0.3).pressure_ratio, 1e-6);
  EXPECT_GT(sliding_first_yield(0.3, 0.3).depth_ratio, 0.3);
  const SlidingYield edge = sliding_first_yield(0.3, 0.4);
  EXPECT_EQ(edge.x_ratio, -1.0);
  EXPECT_EQ(edge.depth_ratio, 0.0);
  // There Huber's stress is (1 - 2 nu)/3 along x and less that along y, and the shear adds what is pulled.
  const double xx = 0.4 / 3.0 + 0.4 * pi * 4.3 / 8.0, yy = -0.4 / 3.0 + 0.4 * 3.0 * pi * 0.3 / 8.0;
  EXPECT_NEAR(1.0 / edge.pressure_ratio, std::sqrt(xx * xx - xx * yy + yy * yy), 1e-7);
  EXPECT_THROW((void)sliding_first_yield(0.3, -0.1), InputError);
  EXPECT_THROW((void)line_sliding_first_yield(0.6, 0.1), InputError);
}

} // namespace
} // namespace brinell::reference::sliding_contact_test
