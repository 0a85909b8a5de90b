// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/green/rectangle.hpp"

#include "gauss.hpp"
#include "oracle_table.hpp"
#include "tensors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace brinell::green::rectangle_test
{
namespace
{

using std::numbers::pi;
using test::component_names;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

// Four corner terms, each at most pi/2/(2 pi) times a few operations: rounding is some eps of the unit pressure,
// however small the stress itself is.
constexpr double rounding = 8.0 * epsilon;

TEST(RectangleTest, StressEqualsIntegratedPointLoad)
{
  const test::OracleTable oracle("rectangle_oracle.csv");
  for (std::size_t row = 0; row < oracle.size(); ++row)
  {
    const auto at = [&](const char* column) { return oracle.number(row, column); };
    const SymTensor stress = rectangle_stress(at("x"), at("y"), at("z"), at("dx"), at("dy"), at("nu"));
    for (std::size_t c = 0; c < 6; ++c)
      EXPECT_NEAR(stress[c], at(component_names[c]), rounding) << "case " << row << ' ' << component_names[c];
  }
}

TEST(RectangleTest, DisplacementEqualsIntegratedPointLoad)
{
  const test::OracleTable oracle("rectangle_oracle.csv");
  int surface_points = 0;
  for (std::size_t row = 0; row < oracle.size(); ++row)
  {
    const auto at = [&](const char* column) { return oracle.number(row, column); };
    if (at("z") != 0.0)
      continue;
    ++surface_points;
    // Corner terms of size (distance) ln(2) are summed to area/distance: that ratio times eps.
    const double distance = std::hypot(at("x"), at("y"));
    EXPECT_NEAR(rectangle_displacement(at("x"), at("y"), at("dx"), at("dy")), at("integral_1_over_r"),
                8.0 * epsilon * distance);
  }
  EXPECT_EQ(surface_points, 2);
}

TEST(RectangleTest, LovesNumbers)
{
  // Unit pressure on a unit square, G = 1, nu = 0.28; eight and seven digits given.
  const double factor = (1.0 - 0.28) / (2.0 * pi);
  EXPECT_NEAR(factor * rectangle_displacement(0.0, 0.0, 1.0, 1.0), 0.40399189, 5e-9);
  EXPECT_NEAR(factor * rectangle_displacement(0.5, 0.5, 1.0, 1.0), 0.20199595, 5e-9);
  const std::array<std::pair<double, double>, 6> under_centre{
      {{0.1, -0.994294}, {0.2, -0.960398}, {0.4, -0.799721}, {0.5, -0.700886}, {1.0, -0.336108}, {2.5, -0.0716135}}};
  for (const auto& [z, expected] : under_centre)
    EXPECT_NEAR(rectangle_stress(0.0, 0.0, z, 1.0, 1.0, 0.28)[2], expected, 6e-7) << "z = " << z;
}

TEST(RectangleTest, SurfaceIsLoadedByTheUnitPressureOnly)
{
  const auto normal = [](double x, double y) { return rectangle_stress(x, y, 0.0, 2.0, 1.0, 0.3); };
  EXPECT_NEAR(normal(0.3, -0.2)[2], -1.0, rounding);
  EXPECT_NEAR(normal(1.0, 0.1)[2], -0.5, rounding) << "mean on an edge";
  EXPECT_NEAR(normal(1.0, 0.5)[2], -0.25, rounding) << "mean at a corner";
  EXPECT_NEAR(normal(1.4, 0.1)[2], 0.0, rounding);
  for (const double x : {0.3, 1.0, 1.4})
  {
    EXPECT_EQ(normal(x, 0.1)[3], 0.0);
    EXPECT_EQ(normal(x, 0.1)[4], 0.0);
  }
}

TEST(RectangleTest, ParityIsExact)
{
  // Antiderivatives that are odd or even to the last bit: kernels may be stored for one quadrant.
  const double x = 1.3, y = 0.7, z = 0.45, dx = 1.0, dy = 0.6;
  const SymTensor s = rectangle_stress(x, y, z, dx, dy, 0.3);
  const SymTensor sx = rectangle_stress(-x, y, z, dx, dy, 0.3);
  const SymTensor sy = rectangle_stress(x, -y, z, dx, dy, 0.3);
  const std::array<double, 6> odd_x{1, 1, 1, 1, -1, -1}, odd_y{1, 1, 1, -1, 1, -1};
  for (std::size_t c = 0; c < 6; ++c)
  {
    EXPECT_NEAR(sx[c], odd_x[c] * s[c], epsilon) << component_names[c];
    EXPECT_NEAR(sy[c], odd_y[c] * s[c], epsilon) << component_names[c];
  }
}

TEST(RectangleTest, FourQuartersMakeOne)
{
  const double x = 0.37, y = -0.21, z = 0.15;
  SymTensor sum{};
  double displacement = 0.0;
  for (const double a : {-0.25, 0.25})
    for (const double b : {-0.5, 0.5})
    {
      const SymTensor part = rectangle_stress(x - a, y - b, z, 0.5, 1.0, 0.3);
      for (std::size_t c = 0; c < 6; ++c)
        sum[c] += part[c];
      displacement += rectangle_displacement(x - a, y - b, 0.5, 1.0);
    }
  const SymTensor whole = rectangle_stress(x, y, z, 1.0, 2.0, 0.3);
  for (std::size_t c = 0; c < 6; ++c)
    EXPECT_NEAR(sum[c], whole[c], 4.0 * rounding) << component_names[c];
  EXPECT_NEAR(displacement, rectangle_displacement(x, y, 1.0, 2.0), 16.0 * epsilon);
}

TEST(RectangleTest, MetreAndMicrometreAgree)
{
  const SymTensor metres = rectangle_stress(0.3, -0.8, 0.4, 1.0, 0.7, 0.3);
  const SymTensor micrometres = rectangle_stress(0.3e-6, -0.8e-6, 0.4e-6, 1e-6, 0.7e-6, 0.3);
  for (std::size_t c = 0; c < 6; ++c)
    // ln(rho + z) is shifted by ln(1e-6) = -14, which costs 14 eps at each corner.
    EXPECT_NEAR(metres[c], micrometres[c], 4.0 * rounding) << component_names[c];
  EXPECT_NEAR(rectangle_displacement(0.3e-6, -0.8e-6, 1e-6, 0.7e-6) * 1e6, rectangle_displacement(0.3, -0.8, 1.0, 0.7),
              16.0 * epsilon);
}

TEST(RectangleTest, DivergenceVanishesInSecondOrder)
{
  const auto divergence = [](double h)
  {
    return test::divergence(0.42, 0.33, 0.3, h,
                            [](double x, double y, double z) { return rectangle_stress(x, y, z, 1.0, 0.8, 0.3); });
  };
  const double order = std::log2(divergence(2e-2) / divergence(1e-2));
  EXPECT_NEAR(order, 2.0, 0.05) << "central differences, h^4 terms of some (h/z)^2 = 1e-3";
}

/// zz, yz, xz and trace under a rectangle, from the transform of a unit pressure (see docs): integral over the
/// wavenumbers in polar form, trapezium rule over the angle and Gauss-Legendre panels over k up to kz = 40.
std::array<double, 4> from_wavenumbers(double x, double y, double z, double dx, double dy, double nu)
{
  const int angles = 240, panels = 40;
  std::array<double, 4> sum{};
  const auto sinc = [](double t) { return t == 0.0 ? 1.0 : std::sin(t) / t; };
  for (int panel = 0; panel < panels; ++panel)
  {
    const test::Gauss rule(16, panel / z, (panel + 1) / z);
    for (std::size_t i = 0; i < rule.point.size(); ++i)
      for (int j = 0; j < angles; ++j)
      {
        const double k = rule.point[i], angle = 2.0 * pi * j / angles;
        const double m = k * std::cos(angle), n = k * std::sin(angle);
        const double pressure = dx * dy * sinc(0.5 * m * dx) * sinc(0.5 * n * dy);
        const double f = rule.weight[i] * k * std::exp(-k * z) * pressure / (2.0 * pi * angles);
        const double phase = m * x + n * y;
        sum[0] -= f * (1.0 + k * z) * std::cos(phase);
        sum[1] -= f * n * z * std::sin(phase); // real part of i n z e^{i phase}
        sum[2] -= f * m * z * std::sin(phase);
        sum[3] -= f * 2.0 * (1.0 + nu) * std::cos(phase);
      }
  }
  return sum;
}

TEST(RectangleTest, AgreesWithTheMixedDomain)
{
  const double x = 0.7, y = -0.4, z = 0.5, nu = 0.3;
  const SymTensor s = rectangle_stress(x, y, z, 1.0, 0.6, nu);
  const auto expected = from_wavenumbers(x, y, z, 1.0, 0.6, nu);
  // The trapezium rule and the panels converge exponentially; what is left is rounding of 150 000 terms.
  EXPECT_NEAR(s[2], expected[0], 1e-12);
  EXPECT_NEAR(s[3], expected[1], 1e-12);
  EXPECT_NEAR(s[4], expected[2], 1e-12);
  EXPECT_NEAR(trace(s), expected[3], 1e-12);
}

TEST(RectangleTest, FarFieldIsThePointLoad)
{
  // Next term of the multipole series: second moments dx^2/12 times second derivatives, of relative size 6 (dx/R)^2.
  const double x = 120.0, y = -160.0, z = 150.0, R = std::sqrt(x * x + y * y + z * z);
  const double expected = -3.0 * z * z * z / (2.0 * pi * std::pow(R, 5));
  EXPECT_NEAR(rectangle_stress(x, y, z, 1.0, 1.0, 0.3)[2] / expected, 1.0, 6.0 / (R * R));
  EXPECT_NEAR(rectangle_displacement(x, y, 1.0, 1.0) * std::hypot(x, y), 1.0, 1.0 / (x * x + y * y));
}

} // namespace
} // namespace brinell::green::rectangle_test
