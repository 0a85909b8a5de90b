// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/constitutive/fatigue.hpp"

#include "brinell/foundation/error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace brinell::constitutive::fatigue_test
{
namespace
{

using Criterion = Fatigue::Criterion;
using Path = std::vector<SymTensor>;

constexpr double t = 300e6, b = 450e6;
constexpr std::array criteria{Criterion::dang_van, Criterion::crossland, Criterion::findley, Criterion::fatemi_socie};

FatigueCriterion criterion_of(Criterion kind)
{
  return FatigueCriterion({.criterion = kind, .torsion_limit = t, .bending_limit = b});
}

/// A cycle of a stress between its negative and itself, in `steps` steps.
Path reversed(const SymTensor& amplitude, int steps = 16)
{
  Path path;
  for (int i = 0; i <= steps; ++i)
  {
    SymTensor s = amplitude;
    for (double& component : s)
      component *= std::cos(2.0 * std::numbers::pi * i / steps);
    path.push_back(s);
  }
  return path;
}

using Matrix = std::array<std::array<double, 3>, 3>;

Matrix random_rotation(std::mt19937& random)
{
  std::normal_distribution<double> normal;
  std::array<double, 4> q{normal(random), normal(random), normal(random), normal(random)};
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (double& c : q)
    c /= length;
  const auto& [w, x, y, z] = q;
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
           {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
           {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

SymTensor rotated(const SymTensor& s, const Matrix& r)
{
  const Matrix full{{{s[0], s[5], s[4]}, {s[5], s[1], s[3]}, {s[4], s[3], s[2]}}};
  Matrix result{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t l = 0; l < 3; ++l)
          result[i][j] += r[i][k] * full[k][l] * r[j][l];
  return {result[0][0], result[1][1], result[2][2], result[1][2], result[0][2], result[0][1]};
}

/// A path that is neither proportional nor symmetric.
Path winding_path()
{
  Path path;
  for (int i = 0; i < 30; ++i)
  {
    const double a = 2.0 * std::numbers::pi * i / 30;
    path.push_back({200e6 * std::sin(a), -150e6 + 90e6 * std::cos(a), -300e6 * std::cos(2 * a), 40e6 * std::sin(2 * a),
                    180e6 * std::cos(a + 0.4), 70e6 * std::cos(a) * std::sin(a)});
  }
  return path;
}

// The two tests that define the constants of a material are at its limit.
TEST(Fatigue, ReversedTorsionAndBendingAtTheirLimitsAreAtTheLimit)
{
  for (const Criterion kind : criteria)
  {
    const FatigueCriterion criterion = criterion_of(kind);
    EXPECT_NEAR(criterion.utilisation({reversed({0, 0, 0, 0, 0, t})}), 1.0, 2e-4) << static_cast<int>(kind);
    EXPECT_NEAR(criterion.utilisation({reversed({b, 0, 0, 0, 0, 0})}), 1.0, 2e-4) << static_cast<int>(kind);
  }
}

TEST(Fatigue, WeightsOfTheCriteriaByTheirFormulas)
{
  EXPECT_NEAR(criterion_of(Criterion::dang_van).sensitivity(), 3.0 * (t / b - 0.5), 1e-12);
  EXPECT_NEAR(criterion_of(Criterion::crossland).sensitivity(), 3.0 * t / b - std::sqrt(3.0), 1e-12);
  const double k = criterion_of(Criterion::findley).sensitivity();
  EXPECT_NEAR((k + std::sqrt(1 + k * k)) / (2.0 * std::sqrt(1 + k * k)), t / b, 1e-12);
}

// A static tension makes a cycle worse, a static pressure better: the sign of hydrostatic and normal stress.
TEST(Fatigue, TensionDamagesAndPressureProtects)
{
  for (const Criterion kind : criteria)
  {
    const FatigueCriterion criterion = criterion_of(kind);
    const auto under = [&](double mean)
    {
      Path path = reversed({0, 0, 0, 0, 0.8 * t, 0});
      for (SymTensor& s : path)
        for (std::size_t c = 0; c < 3; ++c)
          s[c] += mean;
      return criterion.utilisation({path});
    };
    EXPECT_GT(under(100e6), under(0.0) + 0.05) << static_cast<int>(kind);
    EXPECT_LT(under(-100e6), under(0.0) - 0.05) << static_cast<int>(kind);
  }
  // Of Dang Van and Crossland by the weight times the static stress, exactly.
  const FatigueCriterion dang_van = criterion_of(Criterion::dang_van);
  Path path = reversed({0, 0, 0, 0, 0.8 * t, 0});
  for (SymTensor& s : path)
    s[0] += 60e6, s[1] += 60e6, s[2] += 60e6;
  EXPECT_NEAR(dang_van.utilisation({path}), 0.8 + dang_van.sensitivity() * 60e6 / t, 1e-4);
}

TEST(Fatigue, AStaticShearDoesNotCount)
{
  for (const Criterion kind : {Criterion::dang_van, Criterion::crossland})
  {
    Path path = reversed({0, 0, 0, 0, 0.7 * t, 0});
    for (SymTensor& s : path)
      s[4] += 2.0 * t, s[0] += 50e6, s[1] -= 50e6;
    EXPECT_NEAR(criterion_of(kind).utilisation({path}), 0.7, 1e-4);
  }
}

TEST(Fatigue, DoesNotDependOnTheAxes)
{
  std::mt19937 random(3);
  const Path path = winding_path();
  for (const Criterion kind : criteria)
  {
    const FatigueCriterion criterion = criterion_of(kind);
    const double expected = criterion.utilisation({path});
    for (int i = 0; i < 20; ++i)
    {
      const Matrix rotation = random_rotation(random);
      Path turned;
      for (const SymTensor& s : path)
        turned.push_back(rotated(s, rotation));
      EXPECT_NEAR(criterion.utilisation({turned}), expected, 5e-4 * expected) << static_cast<int>(kind);
    }
  }
}

// The search over planes against all planes on a fine lattice.
TEST(Fatigue, FindsTheWorstOfAllPlanes)
{
  const Path path = winding_path();
  const FatigueCriterion findley = criterion_of(Criterion::findley);
  const double k = findley.sensitivity();
  double worst = 0.0;
  constexpr int lines = 120;
  for (int i = 0; i <= lines; ++i)
    for (int j = 0; j < 2 * lines; ++j)
    {
      const double theta = 0.5 * std::numbers::pi * i / lines, phi = std::numbers::pi * j / lines;
      const std::array<double, 3> n{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)},
          a{std::cos(theta) * std::cos(phi), std::cos(theta) * std::sin(phi), -std::sin(theta)},
          c{-std::sin(phi), std::cos(phi), 0.0};
      double normal = -1e300;
      std::vector<std::array<double, 2>> shears;
      for (const SymTensor& s : path)
      {
        const std::array<double, 3> f{s[0] * n[0] + s[5] * n[1] + s[4] * n[2], s[5] * n[0] + s[1] * n[1] + s[3] * n[2],
                                      s[4] * n[0] + s[3] * n[1] + s[2] * n[2]};
        const auto along = [&](const std::array<double, 3>& d) { return f[0] * d[0] + f[1] * d[1] + f[2] * d[2]; };
        normal = std::max(normal, along(n));
        shears.push_back({along(a), along(c)});
      }
      // The smallest circle through two or three of the points that holds all of them.
      double radius = std::numeric_limits<double>::infinity();
      const auto consider = [&](double x, double y, double r)
      {
        for (const auto& p : shears)
          if (std::hypot(p[0] - x, p[1] - y) > r * (1 + 1e-9))
            return;
        radius = std::min(radius, r);
      };
      if (i % 4 != 0 || j % 4 != 0) // the circle is searched on a sixteenth of the planes
        continue;
      for (std::size_t p = 0; p < shears.size(); ++p)
        for (std::size_t q = p + 1; q < shears.size(); ++q)
        {
          const auto& [px, py] = shears[p];
          const auto& [qx, qy] = shears[q];
          consider(0.5 * (px + qx), 0.5 * (py + qy), 0.5 * std::hypot(px - qx, py - qy));
          for (std::size_t r = q + 1; r < shears.size(); ++r)
          {
            const auto& [rx, ry] = shears[r];
            const double d = 2 * (px * (qy - ry) + qx * (ry - py) + rx * (py - qy));
            if (std::abs(d) < 1e-3)
              continue;
            const double p2 = px * px + py * py, q2 = qx * qx + qy * qy, r2 = rx * rx + ry * ry;
            const double x = (p2 * (qy - ry) + q2 * (ry - py) + r2 * (py - qy)) / d,
                         y = (p2 * (rx - qx) + q2 * (px - rx) + r2 * (qx - px)) / d;
            consider(x, y, std::hypot(px - x, py - y));
          }
        }
      worst = std::max(worst, radius + k * normal);
    }
  const double found = findley.utilisation({path}) * t * std::sqrt(1 + k * k);
  EXPECT_GE(found, worst * (1 - 2e-4));
  EXPECT_LE(found, worst * 1.01); // between the planes of the lattice
}

TEST(Fatigue, TheBallOfARegularFigureIsItsCircle)
{
  Path triangle;
  for (int i = 0; i < 3; ++i)
  {
    const double a = 2.0 * std::numbers::pi * i / 3;
    triangle.push_back({0, 0, 0, 5e6 + 10e6 * std::cos(a), 10e6 * std::sin(a), 0});
  }
  const DeviatorBall ball = enclosing_ball(triangle);
  EXPECT_NEAR(ball.radius, std::sqrt(2.0) * 10e6, 1e-5 * 15e6);
  EXPECT_NEAR(ball.centre[3], 5e6, 1e3);
  EXPECT_NEAR(ball.centre[4], 0.0, 1e3);
}

double distance(const SymTensor& one, const SymTensor& other)
{
  SymTensor d;
  for (std::size_t c = 0; c < d.size(); ++c)
    d[c] = one[c] - other[c];
  return std::sqrt(double_contraction(d, d));
}

// The largest distance is a convex function of the centre: where no small move makes it smaller, the ball is the smallest one.
TEST(Fatigue, TheBallIsTheSmallestOneAroundAnyPath)
{
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  const auto any = [&]
  {
    SymTensor s{normal(random), normal(random), 0.0, normal(random), normal(random), normal(random)};
    s[2] = -s[0] - s[1];
    return s;
  };
  const auto from = [](const SymTensor& start, double way, const SymTensor& along)
  {
    SymTensor s = start;
    for (std::size_t c = 0; c < s.size(); ++c)
      s[c] += way * along[c];
    return s;
  };
  for (int kind = 0; kind < 40; ++kind)
  {
    const SymTensor first = any(), second = any(), third = any();
    const int points = 1 + 3 * (kind / 4);
    Path path;
    for (int i = 0; i < points; ++i)
      if (kind % 4 == 0) // anywhere
        path.push_back(any());
      else if (kind % 4 == 1) // on a line
        path.push_back(from(first, normal(random), second));
      else if (kind % 4 == 2) // on a plane, each point twice
        path.insert(path.end(), 2, from(from(first, normal(random), second), normal(random), third));
      else // on a sphere
        path.push_back([&](const SymTensor& s)
                       { return from(first, 1.0 / std::sqrt(double_contraction(s, s)), s); }(any()));
    const DeviatorBall ball = enclosing_ball(path);
    const auto farthest = [&](const SymTensor& centre)
    {
      double most = 0.0;
      for (const SymTensor& s : path)
        most = std::max(most, distance(s, centre));
      return most;
    };
    EXPECT_NEAR(farthest(ball.centre), ball.radius, 1e-9) << kind;
    for (int i = 0; i < 500; ++i)
      EXPECT_GE(farthest(from(ball.centre, std::pow(10.0, -0.01 * i), any())), ball.radius * (1.0 - 5e-6)) << kind;
  }
}

TEST(Fatigue, PrincipalShear)
{
  EXPECT_NEAR(principal_shear({100e6, 0, 0, 0, 0, 0}), 50e6, 1.0);
  EXPECT_NEAR(principal_shear({7e6, 7e6, 7e6, 0, 30e6, 0}), 30e6, 1.0);
  EXPECT_NEAR(principal_shear({-10e6, 20e6, 50e6, 0, 0, 0}), 30e6, 1.0);
  EXPECT_EQ(principal_shear({3e6, 3e6, 3e6, 0, 0, 0}), 0.0);
}

TEST(Fatigue, PlasticShearCountsForFatemiAndSocie)
{
  const FatigueCriterion criterion = criterion_of(Criterion::fatemi_socie);
  const Path stress = reversed({0, 0, 0, 0, 0, 0.5 * t});
  Path strain = reversed({0, 0, 0, 0, 0, t});
  EXPECT_GT(criterion.utilisation({stress, strain}), 1.5 * criterion.utilisation({stress}));
}

TEST(Fatigue, RefusesLimitsWithoutACalibration)
{
  const auto reason = [](Criterion kind, double ratio)
  { return reason_against({.criterion = kind, .torsion_limit = ratio * b, .bending_limit = b}); };
  EXPECT_EQ(reason(Criterion::dang_van, 0.5), "");
  EXPECT_NE(reason(Criterion::dang_van, 0.49), "");
  EXPECT_NE(reason(Criterion::crossland, 0.57), "");
  EXPECT_EQ(reason(Criterion::crossland, 0.58), "");
  EXPECT_NE(reason(Criterion::fatemi_socie, 0.81), "");
  EXPECT_NE(reason(Criterion::findley, 1.0), "");
  EXPECT_EQ(reason(Criterion::none, 7.0), "");
  EXPECT_THROW(FatigueCriterion({.criterion = Criterion::findley, .torsion_limit = 2 * b, .bending_limit = b}),
               InternalError);
}

} // namespace
} // namespace brinell::constitutive::fatigue_test
