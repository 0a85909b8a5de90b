// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/surface_compliance.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/foundation/symmetry.hpp"
#include "brinell/green/surface_terms.hpp"
#include "grid_fields.hpp"
#include "mirrored_grid.hpp"
#include "order.hpp"
#include "random_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace brinell::halfspace::tractions_test
{
namespace
{

constexpr double pi = std::numbers::pi;
constexpr auto open = Boundary::open;
constexpr auto periodic = Boundary::periodic;
const Elastic rigid{std::numeric_limits<double>::infinity(), 0.0};
const Elastic soft{1.3, 0.28}, stiff{4.0, 0.1};

using test::Field;
using test::hertz;
using test::largest_difference;
using test::sampled;

/// z, x, y: of a load (pressure, shears) or of a displacement.
struct Fields
{
  Field z, x, y;
};

Fields displacement(const SurfaceCompliance& compliance, const Fields& load)
{
  const std::size_t cells = compliance.grid().size();
  Fields u{Field(cells), Field(cells), Field(cells)};
  compliance.apply({load.z, load.x, load.y}, {u.z, u.x, u.y});
  return u;
}

Fields random_load(std::size_t cells, unsigned seed)
{
  return {test::random_field(cells, seed), test::random_field(cells, seed + 1), test::random_field(cells, seed + 2)};
}

double dot(const Fields& a, const Fields& b)
{
  return test::dot(a.z, b.z) + test::dot(a.x, b.x) + test::dot(a.y, b.y);
}

class TractionsTest : public testing::TestWithParam<SurfaceGrid>
{
};

INSTANTIATE_TEST_SUITE_P(
    Grids, TractionsTest,
    testing::Values(SurfaceGrid{9, 4, 0.5, 1.5}, SurfaceGrid{1, 5, 1.0, 1.0},
                    SurfaceGrid{8, 6, 0.7, 0.9, periodic, periodic}, SurfaceGrid{7, 5, 0.7, 0.9, periodic, periodic},
                    SurfaceGrid{6, 1, 1.0, 1.0, periodic, periodic}, SurfaceGrid{8, 6, 0.7, 0.9, open, periodic},
                    SurfaceGrid{7, 5, 0.7, 0.9, periodic, open}, SurfaceGrid{9, 1, 0.7, 0.9, open, periodic}));

/// From one side of the plane y = 0, by both operators and their approximate inverses.
TEST_P(TractionsTest, OneSideOfMirrorImagesTellsBoth)
{
  const SurfaceGrid& grid = GetParam();
  const SurfaceGrid half = test::mirrored(grid);
  const SurfaceCompliance compliance(grid, soft, stiff, 50.0), of_half = compliance.on(half);
  const SurfaceCompliance normal(grid, 1.3, 50.0), normal_of_half = normal.on(half);
  Fields load = random_load(grid.size(), 3);
  if (grid.ny % 2 == 1)
    std::fill_n(load.y.begin() + static_cast<std::ptrdiff_t>(grid.index(0, grid.ny / 2)), grid.nx, 0.0);
  for (Field* field : {&load.z, &load.x, &load.y})
    complete_in_y(grid, field == &load.y ? -1.0 : 1.0, field->data(), field->size());
  const auto expect_alike = [&](const Field& one_side, const Field& both, double scale = 0.0)
  {
    const auto end = static_cast<std::ptrdiff_t>(half.independent_cells());
    EXPECT_LE(largest_difference({one_side.begin(), one_side.begin() + end}, {both.begin(), both.begin() + end}),
              1e-13 * std::max(test::largest(both), scale)); // rounding
  };
  const Fields expected = displacement(compliance, load), found = displacement(of_half, load);
  expect_alike(found.z, expected.z);
  expect_alike(found.x, expected.x);
  expect_alike(found.y, expected.y, test::largest(expected.x));
  Fields back = load, back_of_half = load;
  SurfaceCompliance::Scratch scratch = compliance.make_scratch(), own = of_half.make_scratch();
  compliance.apply_inverse({load.x, load.y}, {back.x, back.y}, scratch);
  of_half.apply_inverse({load.x, load.y}, {back_of_half.x, back_of_half.y}, own);
  expect_alike(back_of_half.x, back.x);
  expect_alike(back_of_half.y, back.y, test::largest(back.x));
  SurfaceCompliance::Scratch both = normal.make_scratch(), one = normal_of_half.make_scratch();
  normal.apply({.pressure = load.z}, {.z = back.z}, both);
  normal_of_half.apply({.pressure = load.z}, {.z = back_of_half.z}, one);
  expect_alike(back_of_half.z, back.z);
  normal.apply_inverse(load.z, back.z, both);
  normal_of_half.apply_inverse(load.z, back_of_half.z, one);
  expect_alike(back_of_half.z, back.z);
}

TEST_P(TractionsTest, IsSymmetricAndPositive)
{
  // The work of one load on the displacement of another; the pressure's displacement along x is against that of the shear
  // along z (odd kernels of opposite signs).
  const SurfaceCompliance compliance(GetParam(), soft, stiff, 50.0);
  const std::size_t cells = GetParam().size();
  const Fields a = random_load(cells, 1), b = random_load(cells, 4);
  const Fields of_a = displacement(compliance, a), of_b = displacement(compliance, b);
  const double energy = std::sqrt(dot(a, of_a) * dot(b, of_b));
  EXPECT_GT(dot(a, of_a), 0.0);
  EXPECT_GT(dot(b, of_b), 0.0);
  EXPECT_NEAR(dot(a, of_b), dot(b, of_a), 1e-13 * energy);
}

/// Beside another displacement it is a product of three fields.
TEST_P(TractionsTest, OfPressureAlongZIsThatOfPressureAlone)
{
  const SurfaceGrid& g = GetParam();
  const Field p = test::random_field(g.size(), 7);
  Field u(g.size()), along(g.size()), expected(g.size());
  SurfaceCompliance(g, soft, stiff, 50.0).apply({.pressure = p}, {.z = u, .x = along});
  const SurfaceCompliance normal(g, contact_modulus(soft, stiff), 50.0);
  SurfaceCompliance::Scratch scratch = normal.make_scratch();
  normal.apply({.pressure = p}, {.z = expected}, scratch);
  EXPECT_LT(largest_difference(u, expected), 1e-13 * normal.largest());
  EXPECT_THROW(normal.apply({.pressure = p, .shear_x = p}, {.z = u}, scratch), InternalError);
}

TEST_P(TractionsTest, PartsAddUpAndEmptyOnesAreZero)
{
  const SurfaceCompliance compliance(GetParam(), soft, stiff, 50.0);
  const std::size_t cells = GetParam().size();
  const Fields load = random_load(cells, 8);
  const Fields whole = displacement(compliance, load);
  const Fields of_p = displacement(compliance, {load.z, {}, {}});
  const Fields of_x = displacement(compliance, {{}, load.x, {}});
  const Fields of_y = displacement(compliance, {{}, {}, load.y});
  Field alone(cells);
  compliance.apply({load.z, load.x, load.y}, {.y = alone});
  for (std::size_t n = 0; n < cells; ++n)
  {
    EXPECT_NEAR(whole.z[n], of_p.z[n] + of_x.z[n] + of_y.z[n], 1e-12);
    EXPECT_NEAR(whole.x[n], of_p.x[n] + of_x.x[n] + of_y.x[n], 1e-12);
    EXPECT_EQ(whole.y[n], alone[n]);
  }
  const Fields none = displacement(compliance, Fields{});
  EXPECT_EQ(none.x, Field(cells));
}

TEST_P(TractionsTest, AxesCanBeExchanged)
{
  const SurfaceGrid& g = GetParam();
  const SurfaceGrid h{g.ny, g.nx, g.dy, g.dx, g.boundary_y, g.boundary_x};
  const auto exchanged = [&](const Field& f) { return sampled(h, [&](int i, int j) { return f[g.index(j, i)]; }); };
  const Fields load = random_load(g.size(), 11);
  const Fields a = displacement(SurfaceCompliance(g, soft, rigid, 50.0), load);
  const Fields b =
      displacement(SurfaceCompliance(h, soft, rigid, 50.0), {exchanged(load.z), exchanged(load.y), exchanged(load.x)});
  EXPECT_LT(largest_difference(exchanged(a.z), b.z), 1e-12);
  EXPECT_LT(largest_difference(exchanged(a.x), b.y), 1e-12);
  EXPECT_LT(largest_difference(exchanged(a.y), b.x), 1e-12);
}

TEST_P(TractionsTest, EqualBodiesDoNotCouple)
{
  const SurfaceCompliance compliance(GetParam(), soft, soft, 50.0);
  const Fields load = random_load(GetParam().size(), 14);
  EXPECT_EQ(displacement(compliance, {{}, load.x, load.y}).z, Field(load.x.size()));
  EXPECT_EQ(displacement(compliance, {load.z, {}, {}}).x, Field(load.x.size()));
}

TEST_P(TractionsTest, AScratchMayServeAgain)
{
  const SurfaceCompliance compliance(GetParam(), soft, stiff, 50.0);
  const std::size_t cells = GetParam().size();
  SurfaceCompliance::Scratch scratch = compliance.make_scratch();
  for (const unsigned seed : {1U, 2U})
  {
    const Fields load = random_load(cells, seed);
    const Fields expected = displacement(compliance, load);
    Fields u{Field(cells), Field(cells), Field(cells)};
    compliance.apply({load.z, load.x, load.y}, {u.z, u.x, u.y}, scratch);
    EXPECT_EQ(u.x, expected.x);
    EXPECT_EQ(u.z, expected.z);
  }
}

TEST_P(TractionsTest, NoShearDisplacesMoreThanTheLargestResponse)
{
  const SurfaceCompliance compliance(GetParam(), soft, stiff, 50.0);
  Fields load = random_load(GetParam().size(), 3);
  load.z.clear();
  double ratio = 0.0;
  for (int power = 0; power < 50; ++power) // of the operator on the shear
  {
    const Fields u = displacement(compliance, load);
    const double size = std::sqrt(test::dot(load.x, load.x) + test::dot(load.y, load.y));
    ratio = std::sqrt(test::dot(u.x, u.x) + test::dot(u.y, u.y)) / size;
    for (std::size_t i = 0; i < u.x.size(); ++i)
    {
      load.x[i] = u.x[i] / (ratio * size);
      load.y[i] = u.y[i] / (ratio * size);
    }
  }
  EXPECT_LT(ratio, compliance.largest_of_shear() * (1.0 + 1e-12));
  EXPECT_GT(ratio, 0.3 * compliance.largest_of_shear()); // that of the padded grid, which is about twice as wide
}

TEST_P(TractionsTest, TheInverseIsSymmetricAndPositiveAndNearlyInverts)
{
  const SurfaceGrid& g = GetParam();
  const SurfaceCompliance compliance(g, soft, stiff, 50.0);
  SurfaceCompliance::Scratch scratch = compliance.make_scratch();
  const double cell = 1.0 / compliance.stiffness_of_cell();
  for (const double added : {0.0, 3.0 * cell})
  {
    const auto inverted = [&](const Fields& u)
    {
      Fields q{{}, u.x, u.y};
      compliance.apply_inverse({q.x, q.y}, {q.x, q.y}, scratch, added);
      return q;
    };
    Fields a = random_load(g.size(), 5), b = random_load(g.size(), 9);
    a.z.clear();
    b.z.clear();
    const Fields of_a = inverted(a), of_b = inverted(b);
    const double energy = std::sqrt(dot(a, of_a) * dot(b, of_b));
    EXPECT_GT(dot(a, of_a), 0.0);
    EXPECT_NEAR(dot(a, of_b), dot(b, of_a), 1e-13 * energy);
    // What is shared with the compliance: its displacement, and that of each cell by its own shear.
    Fields u = displacement(compliance, a);
    for (std::size_t i = 0; i < u.x.size(); ++i)
    {
      u.x[i] += added * a.x[i];
      u.y[i] += added * a.y[i];
    }
    const Fields again = inverted(u);
    const double length = dot(a, again) / dot(a, a);
    EXPECT_NEAR(length, 1.0, g.is_periodic() ? 0.1 : 0.3); // the mean shear of a periodic surface is lost
  }
}

TEST(TractionsPeriodicTest, TheInverseOfWavesIsExact)
{
  for (const SurfaceGrid& g :
       {SurfaceGrid{8, 6, 0.7, 0.9, periodic, periodic}, SurfaceGrid{7, 5, 0.7, 0.9, periodic, periodic}})
  {
    const SurfaceCompliance compliance(g, soft, stiff);
    SurfaceCompliance::Scratch scratch = compliance.make_scratch();
    Fields q = random_load(g.size(), 5);
    for (Field* part : {&q.x, &q.y})
    {
      double sum = 0.0;
      for (const double value : *part)
        sum += value;
      for (double& value : *part)
        value -= sum / static_cast<double>(g.size());
    }
    Fields u = displacement(compliance, {{}, q.x, q.y});
    compliance.apply_inverse({u.x, u.y}, {u.x, u.y}, scratch);
    EXPECT_LT(largest_difference(u.x, q.x), 1e-13);
    EXPECT_LT(largest_difference(u.y, q.y), 1e-13);
  }
}

TEST(TractionsHertzTest, DisplacementsAreMindlinsAndHertzs)
{
  // Inside the circle, of a shear sqrt(1 - r^2) along x (Johnson 1985, Eqs. 3.91) and of such a pressure (Eqs. 3.41):
  //   u_x = pi/(32 mu) (4 (2 - nu) - (4 - 3 nu) x^2 - (4 - nu) y^2)    u_y = pi/(32 mu) 2 nu x y
  //   u_r = -(1 - 2 nu)/(6 mu r) (1 - (1 - r^2)^(3/2))
  // Second order in the cell.
  const double nu = soft.poisson_ratio, mu = soft.shear_modulus();
  Field errors;
  for (const int cells : {8, 16, 32})
  {
    const int n = 2 * cells + 3, middle = n / 2;
    const double h = 1.0 / cells;
    const SurfaceGrid g{n, n, h, h};
    const Field load = hertz(g);
    const SurfaceCompliance compliance(g, soft, rigid);
    const Fields of_shear = displacement(compliance, {{}, load, {}}),
                 of_pressure = displacement(compliance, {load, {}, {}});
    double largest = 0.0;
    for (const int i : {-cells / 2, 0, cells / 4})
      for (const int j : {cells / 4, cells / 2})
      {
        const double x = i * h, y = j * h, r2 = x * x + y * y;
        const std::size_t at = g.index(middle + i, middle + j);
        const double radial = -(1.0 - 2.0 * nu) / (6.0 * mu * r2) * (1.0 - std::pow(1.0 - r2, 1.5)); // u_r / r
        largest =
            std::max({largest,
                      std::abs(of_shear.x[at] -
                               pi / (32.0 * mu) * (4.0 * (2.0 - nu) - (4.0 - 3.0 * nu) * x * x - (4.0 - nu) * y * y)),
                      std::abs(of_shear.y[at] - pi / (16.0 * mu) * nu * x * y),
                      std::abs(of_pressure.x[at] - radial * x), std::abs(of_pressure.y[at] - radial * y)});
      }
    errors.push_back(largest);
  }
  EXPECT_GT(test::Orders("Mindlin's and Hertz's displacements", errors).last, 1.8);
  EXPECT_LT(errors.back(), 1e-3);
}

TEST(TractionsPeriodicTest, WavesHaveTheClosedForm)
{
  // Of a wave with wavenumber k: u_l = (1 - nu)/(mu k) q_l, u_t = q_t/(mu k) across it, and a quarter of a wave off
  // u_z = (1 - 2 nu)/(2 mu k) q_l. A uniform shear displaces nothing.
  const SurfaceGrid g{12, 10, 0.5, 0.7, periodic, periodic};
  const double nu = soft.poisson_ratio, mu = soft.shear_modulus();
  const double m = 2.0 * pi * 2 / (g.nx * g.dx), n = 2.0 * pi * 1 / (g.ny * g.dy), k = std::hypot(m, n);
  const double q_l = 0.7, q_t = -1.3, c = m / k, s = n / k;
  const auto wave = [&](double factor, double phase, double level)
  { return sampled(g, [&](int i, int j) { return level + factor * std::cos(m * i * g.dx + n * j * g.dy - phase); }); };
  const Fields load{{}, wave(q_l * c - q_t * s, 0.0, 2.0), wave(q_l * s + q_t * c, 0.0, -3.0)};
  const Fields u = displacement(SurfaceCompliance(g, soft, rigid), load);
  const double u_l = (1.0 - nu) / (mu * k) * q_l, u_t = q_t / (mu * k);
  EXPECT_LT(largest_difference(u.x, wave(u_l * c - u_t * s, 0.0, 0.0)), 1e-13);
  EXPECT_LT(largest_difference(u.y, wave(u_l * s + u_t * c, 0.0, 0.0)), 1e-13);
  EXPECT_LT(largest_difference(u.z, wave((1.0 - 2.0 * nu) / (2.0 * mu * k) * q_l, 0.5 * pi, 0.0)), 1e-13);
}

TEST(TractionsPeriodicTest, OneRowIsPlaneAndAntiplaneStrain)
{
  // A line force Q per length on x = 0 (Johnson 1985, section 2.3): u_x = -2 (1 - nu)/(2 pi mu) Q ln(x/l) of one across the
  // line, u_y = -Q/(pi mu) ln(x/l) of one along it, and u_z = (1 - 2 nu)/(4 mu) Q in front of the first one. Ten cells away
  // a cell is a line to the order (1/10)^2/24.
  const SurfaceGrid g{21, 1, 0.1, 3.0, open, periodic};
  const double nu = soft.poisson_ratio, mu = soft.shear_modulus(), reference = 20.0, force = 0.1;
  Field one(g.size());
  one[10] = 1.0;
  const SurfaceCompliance compliance(g, soft, rigid, reference);
  const Fields across = displacement(compliance, {{}, one, {}}), along = displacement(compliance, {{}, {}, one});
  const double far = std::log(1.0 / reference);
  EXPECT_NEAR(across.x[20] / (-(1.0 - nu) / (pi * mu) * force * far), 1.0, 5e-4);
  EXPECT_NEAR(along.y[20] / (-1.0 / (pi * mu) * force * far), 1.0, 5e-4);
  EXPECT_NEAR(across.z[20], (1.0 - 2.0 * nu) / (4.0 * mu) * force, 1e-14);
  EXPECT_NEAR(across.z[0], -across.z[20], 1e-14);
  EXPECT_NEAR(across.y[20], 0.0, 1e-14);
}

TEST(TractionsPeriodicTest, WithOnePeriodicAxisIsTheMiddleOfARowOfCopies)
{
  // Of loads whose sums are zero, so that there is nothing without end. What is missing beyond `count` copies on either side
  // falls as the sum of 1/r^2, the derivative of x/r^2: of first order.
  const SurfaceGrid g{6, 8, 1.0, 1.2, open, periodic};
  const auto balanced = [&](unsigned seed)
  {
    Field f = test::random_field(g.size(), seed);
    double sum = 0.0;
    for (const double value : f)
      sum += value;
    for (double& value : f)
      value -= sum / static_cast<double>(f.size());
    return f;
  };
  const Fields load{balanced(1), balanced(2), balanced(3)};
  const Fields exact = displacement(SurfaceCompliance(g, soft, rigid, 50.0), load);
  Field errors;
  for (const int count : {4, 8, 16})
  {
    SurfaceGrid row = g;
    row.boundary_y = open;
    row.ny *= 2 * count + 1;
    const auto copied = [&](const Field& f)
    { return sampled(row, [&](int i, int j) { return f[g.index(i, j % g.ny)]; }); };
    const Fields found =
        displacement(SurfaceCompliance(row, soft, rigid), {copied(load.z), copied(load.x), copied(load.y)});
    const auto middle = [&](const Field& f)
    { return sampled(g, [&](int i, int j) { return f[row.index(i, j + count * g.ny)]; }); };
    errors.push_back(
        std::max({largest_difference(middle(found.z), exact.z), largest_difference(middle(found.x), exact.x),
                  largest_difference(middle(found.y), exact.y)}));
  }
  EXPECT_GT(test::Orders("row of copies of a traction, copies doubled", errors).last, 0.95);
}

TEST(TractionsDoorTest, RefusesWhatItCannotDo)
{
  const SurfaceGrid g{4, 3, 1.0, 1.0};
  const SurfaceCompliance compliance(g, soft, rigid);
  Field twelve(12), eleven(11);
  EXPECT_THROW(compliance.apply({.heat = twelve}, {.z = twelve}), InputError);
  EXPECT_THROW(compliance.apply({.shear_x = eleven}, {.z = twelve}), InternalError);
  EXPECT_THROW(compliance.apply({.shear_x = twelve}, {.x = eleven}), InternalError);
  EXPECT_THROW(SurfaceCompliance({4, 3, 1.0, 1.0, open, periodic}, soft, rigid), InternalError);
  const SurfaceCompliance other({3, 3, 1.0, 1.0}, soft, rigid);
  SurfaceCompliance::Scratch of_other = other.make_scratch();
  EXPECT_THROW(compliance.apply({.pressure = twelve}, {.z = twelve}, of_other), InternalError);
}

} // namespace
} // namespace brinell::halfspace::tractions_test
