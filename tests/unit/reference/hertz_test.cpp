// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/reference/hertz.hpp"

#include "gauss.hpp"
#include "oracle_table.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace brinell::reference::hertz_test
{
namespace
{

using std::numbers::pi;
constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr std::array component_names{"xx", "yy", "zz", "yz", "xz", "xy"};

TEST(PointContactTest, LoadAndApproachAreInverse)
{
  const PointContact by_load = point_contact_at_load(0.01, 1.1e11, 25.0);
  const PointContact by_approach = point_contact_at_approach(0.01, 1.1e11, by_load.approach);
  EXPECT_NEAR(by_approach.load / 25.0, 1.0, 16.0 * epsilon);
  EXPECT_NEAR(by_load.load / 25.0, 1.0, 16.0 * epsilon);
  EXPECT_NEAR(by_load.peak_pressure, 1.5 * 25.0 / (pi * by_load.contact_radius * by_load.contact_radius),
              16.0 * epsilon * by_load.peak_pressure);
}

TEST(PointContactTest, KnownExample)
{
  // CONTACT's Cattaneo example: two equal materials, G = 200 MPa, nu = 0.42, relative curvature 1/(50 mm), P = 9.1954
  // N: a = 1 mm, p0 = 4.390481 MPa, approach 0.02 mm. The load has five digits.
  const double E = 2.0 * 1.42 * 200e6, contact_modulus = 0.5 * E / (1.0 - 0.42 * 0.42);
  const PointContact c = point_contact_at_load(0.05, contact_modulus, 9.1954);
  EXPECT_NEAR(c.contact_radius, 1e-3, 1e-8);
  EXPECT_NEAR(c.peak_pressure, 4.390481e6, 50.0);
  EXPECT_NEAR(c.approach, 0.02e-3, 2e-10);
}

TEST(PointContactTest, NoLoadIsNoContact)
{
  const PointContact c = point_contact_at_load(1.0, 1e11, 0.0);
  EXPECT_EQ(c.contact_radius, 0.0);
  EXPECT_EQ(c.peak_pressure, 0.0);
  EXPECT_THROW((void)point_contact_at_load(1.0, 1e11, -1.0), InputError);
  EXPECT_THROW((void)point_contact_at_approach(0.0, 1e11, 1e-6), InputError);
}

/// pi E' times the sum of both surfaces' displacements at (x, y) inside the ellipse, by integrating p/r over chords:
/// along a chord p^2 is a parabola of the arc length, so its integral is pi/2 of a half ellipse's, and the trapezium
/// rule over the direction is exact to rounding.
double displacement_from_pressure(const EllipticalContact& c, double x, double y)
{
  const int directions = 4000;
  const double a = c.semi_axis_x, b = c.semi_axis_y;
  const double alpha = 1.0 - x * x / (a * a) - y * y / (b * b);
  double sum = 0.0;
  for (int i = 0; i < directions; ++i)
  {
    const double angle = pi * i / directions, cosine = std::cos(angle), sine = std::sin(angle);
    const double beta = x * cosine / (a * a) + y * sine / (b * b);
    const double gamma = cosine * cosine / (a * a) + sine * sine / (b * b);
    sum += 0.5 * pi * (alpha + beta * beta / gamma) / std::sqrt(gamma);
  }
  return c.peak_pressure * sum * pi / directions;
}

TEST(EllipticalContactTest, PressureClosesTheGap)
{
  // u(x, y) = approach - x^2/(2 R_x) - y^2/(2 R_y) over the whole area.
  const double E = 1.1e11, load = 340.0;
  for (const auto& [rx, ry] :
       {std::array{0.02, 0.02}, std::array{0.02, 0.021}, std::array{0.3, 0.01}, std::array{0.004, 0.5}})
  {
    const EllipticalContact c = elliptical_contact_at_load(rx, ry, E, load);
    EXPECT_NEAR(2.0 / 3.0 * pi * c.semi_axis_x * c.semi_axis_y * c.peak_pressure, load, 32.0 * epsilon * load);
    for (const auto& [s, t] : {std::array{0.0, 0.0}, std::array{0.7, 0.0}, std::array{0.0, -0.8}, std::array{0.4, 0.6}})
    {
      const double x = s * c.semi_axis_x, y = t * c.semi_axis_y;
      const double expected = c.approach - x * x / (2.0 * rx) - y * y / (2.0 * ry);
      // Rounding of 4000 terms, and of exp(log k') in the shape: 1e-13.
      EXPECT_NEAR(displacement_from_pressure(c, x, y) / (pi * E), expected, 1e-12 * c.approach) << rx << ' ' << ry;
    }
  }
}

TEST(EllipticalContactTest, AgreesWithStandardEllipticIntegrals)
{
  // Johnson 1985, Eq. 4.28; K - E cancels 1/k^2-fold, so moderate shapes only.
  const EllipticalContact c = elliptical_contact_at_load(0.05, 0.01, 1.1e11, 100.0);
  const double ratio = c.semi_axis_x / c.semi_axis_y, k = std::sqrt(1.0 - 1.0 / (ratio * ratio));
  const double K = std::comp_ellint_1(k), E = std::comp_ellint_2(k);
  EXPECT_NEAR((ratio * ratio * E - K) / (K - E), 5.0, 1e-12);
  EXPECT_NEAR(c.approach, c.peak_pressure * c.semi_axis_y * K / 1.1e11, 1e-13 * c.approach);
}

TEST(EllipticalContactTest, EqualRadiiGiveThePointContact)
{
  const EllipticalContact e = elliptical_contact_at_load(0.02, 0.02, 1.1e11, 340.0);
  const PointContact p = point_contact_at_load(0.02, 1.1e11, 340.0);
  EXPECT_NEAR(e.semi_axis_x / p.contact_radius, 1.0, 8.0 * epsilon);
  EXPECT_NEAR(e.semi_axis_y / p.contact_radius, 1.0, 8.0 * epsilon);
  EXPECT_NEAR(e.approach / p.approach, 1.0, 8.0 * epsilon);
  EXPECT_NEAR(e.peak_pressure / p.peak_pressure, 1.0, 8.0 * epsilon);
}

TEST(EllipticalContactTest, AxesSwapWithTheRadii)
{
  const EllipticalContact e = elliptical_contact_at_load(0.02, 0.05, 1.1e11, 340.0);
  const EllipticalContact f = elliptical_contact_at_load(0.05, 0.02, 1.1e11, 340.0);
  EXPECT_EQ(e.semi_axis_x, f.semi_axis_y);
  EXPECT_EQ(e.semi_axis_y, f.semi_axis_x);
  EXPECT_LT(e.semi_axis_x, e.semi_axis_y) << "long where the surfaces are flat";
}

TEST(EllipticalContactTest, LoadAndApproachAreInverse)
{
  const EllipticalContact e = elliptical_contact_at_load(0.02, 0.07, 1.1e11, 340.0);
  EXPECT_NEAR(elliptical_contact_at_approach(0.02, 0.07, 1.1e11, e.approach).load, 340.0, 32.0 * epsilon * 340.0);
}

TEST(HertzStressTest, EqualsIntegratedPointLoads)
{
  // Sums of a few terms of order one: some eps of p0.
  const test::OracleTable oracle("hertz_oracle.csv");
  EXPECT_EQ(oracle.size(), 8U);
  for (std::size_t row = 0; row < oracle.size(); ++row)
  {
    const auto at = [&](const char* column) { return oracle.number(row, column); };
    const SymTensor stress = point_contact_stress(at("x"), at("y"), at("z"), 1.0, 1.0, at("nu"));
    for (std::size_t c = 0; c < 6; ++c)
      EXPECT_NEAR(stress[c], at(component_names[c]), 16.0 * epsilon) << "row " << row + 2 << ' ' << component_names[c];
  }
}

TEST(HertzStressTest, SurfaceValues)
{
  // Johnson 1985, Eqs. 3.42, 3.43: inside, on the rim, outside.
  const double nu = 0.3, a = 2e-3, p0 = 1e9;
  for (const double s : {0.0, 0.3, 0.9, 1.0, 1.5})
  {
    const SymTensor stress = point_contact_stress(0.0, s * a, 0.0, a, p0, nu);
    const double p = s < 1.0 ? std::sqrt(1.0 - s * s) : 0.0;
    const double q = s > 0.0 ? (1.0 - 2.0 * nu) / (3.0 * s * s) * (1.0 - p * p * p) : 0.5 * (1.0 - 2.0 * nu);
    EXPECT_NEAR(stress[1] / p0, q - p, 16.0 * epsilon) << s;             // radial
    EXPECT_NEAR(stress[0] / p0, -q - 2.0 * nu * p, 16.0 * epsilon) << s; // hoop
    EXPECT_NEAR(stress[2] / p0, -p, 16.0 * epsilon) << s;
    EXPECT_EQ(std::abs(stress[3]), 0.0);
  }
}

TEST(HertzStressTest, OnTheAxis)
{
  // Johnson 1985, Eq. 3.45.
  const double nu = 0.25;
  for (const double s : {0.01, 0.5, 1.0, 5.0})
  {
    const SymTensor stress = point_contact_stress(0.0, 0.0, s, 1.0, 1.0, nu);
    const double radial = -(1.0 + nu) * (1.0 - s * std::atan(1.0 / s)) + 0.5 / (1.0 + s * s);
    EXPECT_NEAR(stress[0], radial, 16.0 * epsilon);
    EXPECT_NEAR(stress[1], radial, 16.0 * epsilon);
    EXPECT_NEAR(stress[2], -1.0 / (1.0 + s * s), 16.0 * epsilon);
  }
}

TEST(LineContactTest, CarriesItsLoadAndIsThatOfALongEllipse)
{
  const double R = 0.01, E = 1.1e11, W = 2e4;
  const LineContact line = line_contact_at_load(R, E, W);
  EXPECT_NEAR(0.5 * std::numbers::pi * line.half_width * line.peak_pressure, W, 8.0 * epsilon * W);
  // Johnson 1985, Section 4.2 (d): in the middle of a long ellipse the load per length is 3/4 P/b.
  const EllipticalContact ellipse = elliptical_contact_at_load(R, 1e8 * R, E, 1.0);
  const LineContact middle = line_contact_at_load(R, E, 0.75 / ellipse.semi_axis_y);
  EXPECT_NEAR(ellipse.semi_axis_x / middle.half_width, 1.0, 1e-6); // order (a/b)^2 ln(b/a)
  EXPECT_NEAR(ellipse.peak_pressure / middle.peak_pressure, 1.0, 1e-6);
  EXPECT_THROW((void)line_contact_at_load(R, E, -1.0), InputError);
}

TEST(LineContactTest, ApproachIsThatOfTheSumOfLineLoads)
{
  // Both surfaces together move by 2/(pi E') times the integral of p ln(l/|x - t|), here at x = 0 and at half the half-width,
  // where the gap of the undeformed bodies is x^2/(2R). Each side of x by t = x +- r, r = s^3 to soften the logarithm; the edge,
  // where p has a root, by the sine.
  const double R = 0.01, E = 1.1e11, l = 0.3;
  const LineContact line = line_contact_at_load(R, E, 2e4);
  const double a = line.half_width;
  const auto displacement = [&](double x)
  {
    const test::Gauss rule(60, 0.0, 1.0);
    double sum = 0.0;
    for (const double side : {-1.0, 1.0})
      for (std::size_t i = 0; i < rule.point.size(); ++i)
      {
        const double s = rule.point[i];
        const double r = (a - side * x) * std::sin(0.5 * pi * s * s * s);
        const double weight = (a - side * x) * std::cos(0.5 * pi * s * s * s) * 1.5 * pi * s * s;
        const double t = x + side * r;
        sum += rule.weight[i] * weight * line.peak_pressure * std::sqrt(1.0 - t * t / (a * a)) * std::log(l / r);
      }
    return 2.0 / (pi * E) * sum;
  };
  const double approach = line_contact_approach(line, E, l);
  EXPECT_NEAR(displacement(0.0) / approach, 1.0, 1e-9);
  EXPECT_NEAR((displacement(0.5 * a) + 0.125 * a * a / R) / approach, 1.0, 1e-9);
}

TEST(LineContactTest, LoadAndApproachAreInverse)
{
  const double R = 0.01, E = 1.1e11, l = 2.0 * R / std::numbers::e;
  const LineContact by_load = line_contact_at_load(R, E, 2e4);
  const double approach = line_contact_approach(by_load, E, l);
  // Johnson (1985), Eq. 5.56: the axis of a cylinder and a rigid flat.
  EXPECT_NEAR(approach / (2e4 / (pi * E) * (2.0 * std::log(4.0 * R / by_load.half_width) - 1.0)), 1.0, 16.0 * epsilon);
  const LineContact by_approach = line_contact_at_approach(R, E, approach, l);
  EXPECT_NEAR(by_approach.load_per_length / 2e4, 1.0, 64.0 * epsilon);
  EXPECT_NEAR(by_approach.half_width / by_load.half_width, 1.0, 64.0 * epsilon);
  EXPECT_NEAR(by_approach.peak_pressure / by_load.peak_pressure, 1.0, 64.0 * epsilon);
  EXPECT_EQ(line_contact_at_approach(R, E, 0.0, l).load_per_length, 0.0);
  EXPECT_THROW((void)line_contact_at_approach(R, E, 1.01 * l * l / R, l), InputError);
  EXPECT_THROW((void)line_contact_at_approach(R, E, -1e-9, l), InputError);
  EXPECT_THROW((void)line_contact_approach(by_load, E, 0.49 * by_load.half_width), InputError);
}

TEST(LineContactTest, FirstYieldIsAtTheLargestStressAnywhere)
{
  for (const double nu : {-0.5, 0.0, 0.1, 0.13, 0.19, 0.1938, 0.194, 0.25, 0.32, 0.45, 0.5})
  {
    const FirstYield yield = line_contact_first_yield(nu);
    const double at_yield = von_mises(line_contact_stress(0.0, yield.depth_ratio, 1.0, yield.pressure_ratio, nu));
    EXPECT_NEAR(at_yield, 1.0, 1e-14) << nu;
    double largest = 0.0;
    for (int i = 0; i <= 300; ++i)
      for (int j = 0; j <= 400; ++j)
        largest =
            std::max(largest, von_mises(line_contact_stress(0.005 * i, 0.005 * j, 1.0, yield.pressure_ratio, nu)));
    EXPECT_LE(largest, 1.0 + 1e-14) << nu;
    EXPECT_GT(largest, 1.0 - 1e-4)
        << nu << ": the points are so dense"; // square of half their distance, 6e-6, times the curvature
  }
  EXPECT_NEAR(line_contact_first_yield(0.3).depth_ratio, 0.704,
              5e-4); // of shear stress alone it is 0.786 (Johnson, 4.2)
  EXPECT_NEAR(line_contact_first_yield(0.5).depth_ratio, 0.786, 5e-4);
  EXPECT_THROW((void)line_contact_first_yield(0.51), InputError);
  EXPECT_THROW((void)line_contact_first_yield(-1.0), InputError);
}

TEST(LineContactTest, GreensFitsAreNearTheExactFirstYield)
{
  for (int i = 0; i <= 500; ++i)
  {
    const double nu = 0.001 * i;
    const double fit = nu <= 0.1938 ? 1.0 / std::sqrt(1.0 + 4.0 * (nu - 1.0) * nu) : 1.164 + nu * (2.975 - 2.906 * nu);
    EXPECT_NEAR(fit / line_contact_first_yield(nu).pressure_ratio, 1.0, 1.5e-3) << nu << ": stated accuracy";
  }
}

TEST(LineContactTest, StressIsTheSumOfLineLoads)
{
  // Flamant's line loads of x = a sin t (Johnson 1985, Eq. 2.21), a smooth periodic integrand away from the surface.
  const double a = 2.0, p0 = 3.0, nu = 0.3;
  for (const auto& [x, z] : {std::array{0.0, 1.5}, {0.7, 0.9}, {-2.0, 1.0}, {3.0, 2.0}, {-40.0, 30.0}})
  {
    SymTensor sum{};
    constexpr int points = 400;
    for (int i = 0; i < points; ++i)
    {
      const double t = 2.0 * std::numbers::pi * (i + 0.5) / points;
      const double X = x - a * std::sin(t), r2 = X * X + z * z;
      const double load = p0 * a * std::cos(t) * std::cos(t) * std::numbers::pi / points; // each place comes twice
      const double radial = -2.0 * load * z / (std::numbers::pi * r2 * r2);
      sum[0] += radial * X * X;
      sum[2] += radial * z * z;
      sum[4] += radial * X * z;
    }
    sum[1] = nu * (sum[0] + sum[2]);
    const SymTensor stress = line_contact_stress(x, z, a, p0, nu);
    for (std::size_t c = 0; c < 6; ++c)
      EXPECT_NEAR(stress[c], sum[c], 100.0 * epsilon * p0) << c << " at " << x << ' ' << z;
  }
}

TEST(LineContactTest, SurfaceCarriesThePressureAlone)
{
  for (const double x : {0.0, 0.5, -0.9, 1.0, 1.7})
  {
    const SymTensor stress = line_contact_stress(x, 0.0, 1.0, 1.0, 0.3);
    const double p = std::sqrt(std::max(0.0, 1.0 - x * x));
    EXPECT_NEAR(stress[2], -p, 8.0 * epsilon) << x;
    EXPECT_NEAR(stress[0], -p, 8.0 * epsilon) << x;
    EXPECT_EQ(std::abs(stress[4]), 0.0) << x;
  }
}

TEST(FirstYieldTest, Table)
{
  // Five digits given. The value at nu = 0 is 1.299305 at 0.381936 (mpmath).
  const std::array<std::array<double, 3>, 5> table{{{0.0, 1.29931, 0.38194},
                                                    {0.25, 1.55435, 0.46431},
                                                    {0.30, 1.61280, 0.48086},
                                                    {0.32, 1.63697, 0.48750},
                                                    {0.50, 1.87724, 0.54787}}};
  for (const auto& [nu, C, depth] : table)
  {
    EXPECT_NEAR(first_yield(nu).pressure_ratio, C, 6e-6) << nu;
    EXPECT_NEAR(first_yield(nu).depth_ratio, depth, 6e-6) << nu;
  }
}

TEST(FirstYieldTest, IsTheLargestStressOfTheWholeField)
{
  for (const double nu : {-0.9, -0.5, -0.32, -0.3, 0.0, 0.3, 0.5})
  {
    const FirstYield f = first_yield(nu);
    const double x = f.depth_ratio > 0.0 ? 0.0 : 1.0; // on the axis or at the edge
    const double largest = von_mises(point_contact_stress(x, 0.0, f.depth_ratio, 1.0, 1.0, nu));
    EXPECT_NEAR(largest * f.pressure_ratio, 1.0, 16.0 * epsilon);
    for (int i = 0; i < 40; ++i)
      for (int j = 0; j < 40; ++j)
        EXPECT_LE(von_mises(point_contact_stress(0.05 * i, 0.0, 0.05 * j, 1.0, 1.0, nu)),
                  largest * (1.0 + 16.0 * epsilon));
  }
  EXPECT_THROW((void)first_yield(-1.0), InputError);
  EXPECT_THROW((void)first_yield(0.6), InputError);
}

} // namespace
} // namespace brinell::reference::hertz_test
