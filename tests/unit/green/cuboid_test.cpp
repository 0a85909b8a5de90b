// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/green/cuboid.hpp"

#include "gauss.hpp"
#include "oracle_table.hpp"
#include "tensors.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

namespace brinell::green::cuboid_test
{
namespace
{

using std::numbers::pi;
using test::component_names;
using test::unit_tensor;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

// Eight corner terms of size pi, times E/(8 pi (1 - nu^2)), with about ten operations each: stress per E.
constexpr double rounding = 16.0 * epsilon;

TEST(CuboidTest, StressEqualsIntegratedPointForces)
{
  const test::OracleTable oracle("cuboid_oracle.csv");
  int cases = 0;
  for (std::size_t row = 0; row < oracle.size(); ++row)
  {
    if (oracle.text(row, "kind") != "full")
      continue;
    ++cases;
    const auto at = [&](const std::string& column) { return oracle.number(row, column); };
    SymTensor strain{};
    for (std::size_t c = 0; c < 6; ++c)
      strain[c] = oracle.text(row, "eigenstrain") == component_names[c] ? 1.0 : 0.0;
    const SymTensor stress =
        cuboid_stress(at("x"), at("y"), at("z"), at("dx"), at("dy"), at("dz"), strain, Elastic{1.0, at("nu")});
    for (std::size_t c = 0; c < 6; ++c)
      EXPECT_NEAR(stress[c], at(component_names[c] + std::string("_per_E")), rounding) << "row " << row + 2;
  }
  EXPECT_EQ(cases, 8 * 6);
}

TEST(CuboidTest, CentreOfADilatedCube)
{
  const double E = 2.0e11, e = 1e-3;
  for (const double nu : {0.0, 0.25, 0.32, 0.49})
  {
    const SymTensor s = cuboid_stress(0.0, 0.0, 0.0, 2e-3, 2e-3, 2e-3, {e, e, e, 0.0, 0.0, 0.0}, Elastic{E, nu});
    const double expected = -2.0 * E * e / (3.0 * (1.0 - nu));
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(s[c], expected, 4.0 * rounding * E * e);
    for (std::size_t c = 3; c < 6; ++c)
      EXPECT_NEAR(s[c], 0.0, rounding * E * e);
  }
}

TEST(CuboidTest, PotentialsAreHarmonicAndBiharmonic)
{
  const auto laplacians = [](double x, double y, double z)
  {
    const CuboidPotentials p = cuboid_potentials(x, y, z, 1.0, 0.8, 0.6);
    const auto& f = p.psi; // Laplacian of psi, differentiated twice, minus 2 phi likewise
    return std::array{p.phi[0] + p.phi[1] + p.phi[2],        f[0] + f[3] + f[5] - 2.0 * p.phi[0],
                      f[3] + f[1] + f[4] - 2.0 * p.phi[1],   f[5] + f[4] + f[2] - 2.0 * p.phi[2],
                      f[12] + f[9] + f[11] - 2.0 * p.phi[3], f[7] + f[13] + f[10] - 2.0 * p.phi[4],
                      f[6] + f[8] + f[14] - 2.0 * p.phi[5]};
  };
  const auto inside = laplacians(0.1, -0.3, 0.2), outside = laplacians(0.9, 0.3, -0.2);
  EXPECT_NEAR(inside[0], -4.0 * pi, 1e-14);
  EXPECT_NEAR(outside[0], 0.0, 1e-14);
  for (std::size_t i = 1; i < inside.size(); ++i)
  {
    EXPECT_NEAR(inside[i], 0.0, 1e-14) << i; // rounding of terms of size 10
    EXPECT_NEAR(outside[i], 0.0, 1e-14) << i;
  }
}

TEST(CuboidTest, EightHalfSizeCuboidsMakeOne)
{
  const Elastic elastic{1.0, 0.3};
  const SymTensor strain{0.3, -0.7, 0.2, 0.4, -0.5, 0.6};
  for (const auto& [x, y, z] : {std::array{0.11, 0.23, -0.12}, std::array{0.9, -0.3, 0.8}})
  {
    SymTensor sum{};
    for (const double a : {-0.25, 0.25})
      for (const double b : {-0.25, 0.25})
        for (const double c : {-0.25, 0.25})
        {
          const SymTensor part = cuboid_stress(x - a, y - b, z - c, 0.5, 0.5, 0.5, strain, elastic);
          for (std::size_t i = 0; i < 6; ++i)
            sum[i] += part[i];
        }
    const SymTensor whole = cuboid_stress(x, y, z, 1.0, 1.0, 1.0, strain, elastic);
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_NEAR(sum[i], whole[i], 8.0 * rounding) << component_names[i];
  }
}

TEST(CuboidTest, JumpsAcrossAFaceAsAPlaneLayerDoes)
{
  // Across the face z = dz/2 the traction and the in-plane strain are continuous, so the other stresses jump by
  // plane stress of the in-plane eigenstrain. Probe d off the face: d ln d from the smooth part, 1e-8.
  const Elastic elastic{1.0, 0.3};
  const double nu = 0.3, plane = 1.0 / (1.0 - nu * nu), d = 1e-10;
  const SymTensor strain{0.3, -0.7, 0.2, 0.4, -0.5, 0.6};
  const SymTensor in = cuboid_stress(0.1, -0.2, 0.5 - d, 1.0, 1.0, 1.0, strain, elastic);
  const SymTensor on = cuboid_stress(0.1, -0.2, 0.5, 1.0, 1.0, 1.0, strain, elastic);
  const SymTensor out = cuboid_stress(0.1, -0.2, 0.5 + d, 1.0, 1.0, 1.0, strain, elastic);
  const SymTensor jump{-plane * (0.3 - nu * 0.7), -plane * (-0.7 + nu * 0.3), 0.0, 0.0, 0.0, -0.6 / (1.0 + nu)};
  for (std::size_t c = 0; c < 6; ++c)
  {
    EXPECT_NEAR(in[c] - out[c], jump[c], 1e-8) << component_names[c];
    EXPECT_NEAR(on[c], 0.5 * (in[c] + out[c]), 1e-8) << component_names[c];
  }
}

TEST(CuboidTest, IsFiniteAndContinuousOnTheLineOfAnEdge)
{
  // X = Y = 0 beyond the end of an edge: every logarithm has an infinite twin.
  const Elastic elastic{1.0, 0.3};
  for (std::size_t c = 0; c < 6; ++c)
    for (const double z : {-1.3, 0.9})
    {
      const SymTensor on = cuboid_stress(0.5, -0.5, z, 1.0, 1.0, 1.0, unit_tensor(c), elastic);
      const SymTensor near = cuboid_stress(0.5 + 1e-9, -0.5 + 2e-9, z, 1.0, 1.0, 1.0, unit_tensor(c), elastic);
      for (std::size_t i = 0; i < 6; ++i)
        EXPECT_NEAR(on[i], near[i], 1e-8) << component_names[c] << ' ' << component_names[i];
    }
}

TEST(CuboidTest, DivergenceVanishesInSecondOrder)
{
  for (std::size_t component = 0; component < 6; ++component)
  {
    const auto divergence = [&](double h)
    {
      return test::divergence(0.9, 0.35, -0.55, h,
                              [&](double x, double y, double z) {
                                return cuboid_stress(x, y, z, 1.0, 0.8, 0.6, unit_tensor(component), Elastic{1.0, 0.3});
                              });
    };
    EXPECT_NEAR(std::log2(divergence(1e-2) / divergence(5e-3)), 2.0, 0.05) << component_names[component];
  }
}

TEST(CuboidTest, TwoCuboidsAreReciprocal)
{
  // Integral over A of sigma(B):eps_A = integral over B of sigma(A):eps_B. The fields are smooth in the other cuboid,
  // half a side away: 12 Gauss points err by (distance ratio 1 + sqrt(3))^-24 or so, 1e-10.
  const Elastic elastic{1.0, 0.3};
  const double bx = 1.3, by = 0.4, bz = -0.9;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j)
    {
      const double over_a = test::box_integral(
          12, -0.5, 0.5, -0.4, 0.4, -0.3, 0.3,
          [&](double x, double y, double z)
          {
            return double_contraction(cuboid_stress(x - bx, y - by, z - bz, 0.6, 0.4, 0.8, unit_tensor(j), elastic),
                                      unit_tensor(i));
          });
      const double over_b = test::box_integral(
          12, bx - 0.3, bx + 0.3, by - 0.2, by + 0.2, bz - 0.4, bz + 0.4,
          [&](double x, double y, double z) {
            return double_contraction(cuboid_stress(x, y, z, 1.0, 0.8, 0.6, unit_tensor(i), elastic), unit_tensor(j));
          });
      EXPECT_NEAR(over_a, over_b, 1e-10) << component_names[i] << ' ' << component_names[j];
    }
}

/// Share of the cube of side h around a point that lies in the ball of radius 1, by 12^3 samples where it matters.
double ball_share(double x, double y, double z, double h)
{
  const double r = std::sqrt(x * x + y * y + z * z), reach = 0.5 * std::sqrt(3.0) * h;
  if (r + reach <= 1.0 || r - reach >= 1.0)
    return r < 1.0 ? 1.0 : 0.0;
  constexpr int n = 12;
  int inside = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k)
      {
        const double u = x + h * ((i + 0.5) / n - 0.5), v = y + h * ((j + 0.5) / n - 0.5),
                     w = z + h * ((k + 0.5) / n - 0.5);
        inside += u * u + v * v + w * w < 1.0;
      }
  return static_cast<double>(inside) / (n * n * n);
}

/// Stress near the centre of a ball of n^3 cuboids.
SymTensor ball_stress(int n, double x, double y, double z, const SymTensor& strain, const Elastic& elastic)
{
  const double h = 2.0 / n;
  SymTensor sum{};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k)
      {
        const double u = -1.0 + (i + 0.5) * h, v = -1.0 + (j + 0.5) * h, w = -1.0 + (k + 0.5) * h;
        const double share = ball_share(u, v, w, h);
        if (share == 0.0)
          continue;
        const SymTensor part = cuboid_stress(x - u, y - v, z - w, h, h, h, strain, elastic);
        for (std::size_t c = 0; c < 6; ++c)
          sum[c] += share * part[c];
      }
  return sum;
}

TEST(CuboidTest, BallOfCuboidsTendsToEshelby)
{
  // Eshelby 1957: uniform inside; for a dilatation -2 E e/(3 (1 - nu)), for shear -2 mu (7 - 5 nu)/(15 (1 - nu)) eps.
  // Shares of cut cuboids keep the ball's volume to second order in h, so the error falls at least as h^2 and is below
  // h^2 times the stress (the cuts' errors also cancel along the surface, which makes it much smaller inside).
  const Elastic elastic{1.0, 0.3};
  const SymTensor strain{0.1, 0.1, 0.1, 0.0, 0.2, 1.0};
  const double shear = -2.0 * elastic.shear_modulus() * (7.0 - 1.5) / (15.0 * 0.7);
  const SymTensor expected{-0.2 / 2.1, -0.2 / 2.1, -0.2 / 2.1, 0.0, 0.2 * shear, shear};
  std::array<double, 3> error{};
  const std::array sizes{6, 12, 24};
  for (std::size_t i = 0; i < 3; ++i)
  {
    const SymTensor s = ball_stress(sizes[i], 0.21, -0.14, 0.08, strain, elastic);
    for (std::size_t c = 0; c < 6; ++c)
      error[i] = std::max(error[i], std::abs(s[c] - expected[c]));
    std::printf("%2d cuboids a diameter: error %.2e of %.3f\n", sizes[i], error[i], shear);
  }
  EXPECT_GT(std::log2(error[0] / error[2]) / 2.0, 2.0);
  EXPECT_LT(error[2], -shear / (12.0 * 12.0));
}

} // namespace
} // namespace brinell::green::cuboid_test
