// SPDX-License-Identifier: BSD-3-Clause
// Pressure and shears on layered bodies -> displacement of the surface and stress.
#include "halfspace/traction/stack_cells.hpp"
#include "halfspace/traction/stack_shears.hpp"

#include "brinell/halfspace/half_space.hpp"
#include "brinell/halfspace/surface_compliance.hpp"
#include "gauss.hpp"
#include "random_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brinell::halfspace::stack_shears_test
{
namespace
{

using std::numbers::pi;

const ElasticStack soft_on_hard{{{1.0, {1.0, 0.4}}}, {10.0, 0.3}};
const ElasticStack hard_on_soft{{{1.0, {4.0, 0.2}}}, {1.0, 0.3}};
const ElasticStack two_layers{{{0.5, {3.0, 0.25}}, {1.0, {0.5, 0.45}}}, {2.0, 0.3}};

/// Layers whose constants differ so little that the body is homogeneous to rounding, but is computed as a stack.
ElasticStack nearly(const Elastic& body)
{
  constexpr double little = 1e-13;
  return {{{0.5, body}, {1.0, {body.young_modulus * (1.0 + little), body.poisson_ratio}}}, body};
}

const std::vector<SurfaceGrid>& grids()
{
  constexpr auto open = Boundary::open, periodic = Boundary::periodic;
  static const std::vector<SurfaceGrid> all{{14, 9, 0.4, 0.5},
                                            {14, 9, 0.4, 0.5, open, periodic},
                                            {9, 14, 0.4, 0.5, periodic, open},
                                            {12, 8, 0.4, 0.5, periodic, periodic},
                                            {16, 1, 0.4, 2.0, open, periodic}};
  return all;
}

/// Fields along z, x and y, one after the other.
std::vector<double> displaced(const SurfaceCompliance& pair, const std::vector<double>& load)
{
  const std::size_t n = load.size() / 3;
  std::vector<double> u(load.size());
  const auto part = [n](auto& field, std::size_t f) { return std::span(field).subspan(f * n, n); };
  pair.apply({part(load, 0), part(load, 1), part(load, 2)}, {part(u, 0), part(u, 1), part(u, 2)});
  return u;
}

double product(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return sum;
}

double largest(const std::vector<double>& values)
{
  double most = 0.0;
  for (const double value : values)
    most = std::max(most, std::abs(value));
  return most;
}

TEST(StackShears, LayersOfOneMaterialAreTheHalfSpace)
{
  // The long waves are extrapolated from waves of 1e-3 of the reach, with a rounding error of 1e-16 / 1e-3^2.
  const Elastic a{2.0, 0.3}, b{3.0, 0.2};
  const ElasticStack of_a = nearly(a), of_b{{}, b};
  for (const SurfaceGrid& grid : grids())
  {
    const std::vector<double> load = test::random_field(3 * grid.size(), 7);
    const std::vector<double> found = displaced({grid, of_a, of_b, 20.0}, load);
    const std::vector<double> expected = displaced({grid, a, b, 20.0}, load);
    for (std::size_t i = 0; i < found.size(); ++i)
      ASSERT_NEAR(found[i], expected[i], 1e-10 * largest(expected)) << grid.nx << " x " << grid.ny;
  }
}

TEST(StackShears, StressOfLayersOfOneMaterialIsThatOfTheHalfSpace)
{
  const Elastic a{2.0, 0.3};
  for (const SurfaceGrid& surface : grids())
  {
    const VolumeGrid grid{surface, 5, 0.5};
    const HalfSpace layered(grid, nearly(a)), alone(grid, a);
    const std::size_t n = surface.size();
    const std::vector<double> load = test::random_field(3 * n, 8);
    const SurfaceLoad on_surface{std::span(load).first(n), std::span(load).subspan(n, n), std::span(load).last(n)};
    std::vector<double> found(6 * n), expected(6 * n);
    HalfSpace::Work work = layered.make_guest(), other = alone.make_guest();
    for (int layer = 0; layer < grid.nz; ++layer)
    {
      layered.stress_of_load(on_surface, layer, work, found);
      alone.stress_of_load(on_surface, layer, other, expected);
      for (std::size_t i = 0; i < found.size(); ++i)
        ASSERT_NEAR(found[i], expected[i], 1e-9 * largest(expected)) << surface.nx << " layer " << layer;
    }
  }
}

TEST(StackShears, TheOperatorIsSymmetricAndPositive)
{
  // Along z the displacements of both bodies are added, along the surface subtracted: pressure and shear couple with opposite signs
  // within a body, and the work of any two loads is reciprocal.
  for (const SurfaceGrid& grid : grids())
  {
    const SurfaceCompliance pair(grid, soft_on_hard, two_layers, 40.0);
    EXPECT_TRUE(pair.couples());
    const std::vector<double> p = test::random_field(3 * grid.size(), 1), q = test::random_field(3 * grid.size(), 2);
    const double pq = product(p, displaced(pair, q)), qp = product(q, displaced(pair, p));
    const double pp = product(p, displaced(pair, p));
    EXPECT_NEAR(pq, qp, 1e-12 * pp) << grid.nx;
    EXPECT_GT(pp, 0.0) << grid.nx;
  }
}

TEST(StackShears, EqualBodiesDoNotCouple)
{
  const SurfaceGrid& grid = grids().front();
  const SurfaceCompliance pair(grid, soft_on_hard, soft_on_hard);
  EXPECT_FALSE(pair.couples());
  const std::vector<double> p = test::random_field(grid.size(), 1);
  std::vector<double> x(grid.size());
  pair.apply({.pressure = p}, {.x = x});
  EXPECT_EQ(largest(x), 0.0);
}

TEST(StackShears, ThePreconditionerIsTheInverseOfAPeriodicBodyAndPositive)
{
  for (const SurfaceGrid& grid : grids())
  {
    const SurfaceCompliance pair(grid, hard_on_soft, two_layers, 40.0);
    const std::size_t n = grid.size();
    const auto part = [n](auto& field, std::size_t f) { return std::span(field).subspan(f * n, n); };
    SurfaceCompliance::Scratch scratch = pair.make_scratch();
    const auto inverse = [&](const std::vector<double>& u)
    {
      std::vector<double> shear(2 * n);
      pair.apply_inverse({part(u, 0), part(u, 1)}, {part(shear, 0), part(shear, 1)}, scratch);
      return shear;
    };
    const std::vector<double> u = test::random_field(2 * n, 3), v = test::random_field(2 * n, 4);
    const double uu = product(u, inverse(u));
    EXPECT_GT(uu, 0.0);
    EXPECT_NEAR(product(u, inverse(v)), product(v, inverse(u)), 1e-12 * uu);
    if (!grid.is_periodic())
      continue;
    std::vector<double> shear(2 * n), displacement(2 * n);
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i) // waves that the cells represent, without a mean
      {
        shear[grid.index(i, j)] = std::cos(2.0 * pi * (2.0 * i / grid.nx + 1.0 * j / grid.ny));
        shear[n + grid.index(i, j)] = std::sin(2.0 * pi * (3.0 * i / grid.nx - 1.0 * j / grid.ny));
      }
    pair.apply({{}, part(shear, 0), part(shear, 1)}, {{}, part(displacement, 0), part(displacement, 1)});
    const std::vector<double> back = inverse(displacement);
    for (std::size_t i = 0; i < back.size(); ++i)
      EXPECT_NEAR(back[i], shear[i], 1e-12);
    EXPECT_GT(pair.largest_of_shear() * product(shear, shear), product(shear, displacement));
  }
}

/// The response of a point: integrals of Bessel functions, by which the waves of all directions add up.
struct Point
{
  const ElasticStack& stack;

  [[nodiscard]] SurfaceExcess operator()(double x, double y) const
  {
    const double r = std::hypot(x, y), cosine = r > 0.0 ? x / r : 0.0, sine = r > 0.0 ? y / r : 0.0;
    const double end = 18.0 / stack.layers.front().thickness; // e^{-36}
    const int panels = 20 + static_cast<int>(end * r / pi);
    const Elastic& top = stack.top();
    const double nu = top.poisson_ratio, mu = top.shear_modulus();
    SurfaceExcess sum{};
    for (int p = 0; p < panels; ++p)
    {
      const test::Gauss rule(12, end * p / panels, end * (p + 1) / panels);
      for (std::size_t g = 0; g < rule.point.size(); ++g)
      {
        const double k = rule.point[g], weight = rule.weight[g] / (2.0 * pi);
        const green::WaveCompliance c = green::StackWave(stack, k).compliance();
        const double normal = k * c.normal - (1.0 - nu) / mu, along = k * c.along - (1.0 - nu) / mu;
        const double across = k * c.across - 1.0 / mu, coupling = k * c.coupling + 0.5 * (1.0 - 2.0 * nu) / mu;
        const double J0 = std::cyl_bessel_j(0, k * r), J1 = std::cyl_bessel_j(1, k * r);
        const double J2 = std::cyl_bessel_j(2, k * r);
        const double mean = 0.5 * (along + across) * J0, turned = 0.5 * (along - across) * J2;
        const double twice = cosine * cosine - sine * sine;
        sum[excess::zz] += weight * normal * J0;
        sum[excess::xx] += weight * (mean - twice * turned);
        sum[excess::yy] += weight * (mean + twice * turned);
        sum[excess::xy] -= weight * 2.0 * cosine * sine * turned;
        sum[excess::x] -= weight * coupling * J1 * cosine;
        sum[excess::y] -= weight * coupling * J1 * sine;
      }
    }
    return sum;
  }
};

TEST(StackShears, ExcessOfACellIsTheLayeredIntegral)
{
  for (const auto& [stack, cell] :
       {std::pair{soft_on_hard, 0.25}, {hard_on_soft, 0.25}, {two_layers, 0.25}, {soft_on_hard, 1.0}})
  {
    const SurfaceGrid grid{20, 16, cell, 1.5 * cell};
    const Quadrant<SurfaceExcess> found = excess_surface(grid, stack, 0.0);
    const Point point{stack};
    const double scale = (1.0 - stack.top().poisson_ratio) / stack.top().shear_modulus() * cell;
    for (const auto& [i, j] : {std::pair{0, 0}, {1, 1}, {3, 2}, {10, 0}, {19, 15}})
    {
      SurfaceExcess expected{};
      const test::Gauss along(4, -0.5, 0.5);
      for (std::size_t a = 0; a < along.point.size(); ++a)
        for (std::size_t b = 0; b < along.point.size(); ++b)
        {
          const SurfaceExcess value = point((i - along.point[a]) * grid.dx, (j - along.point[b]) * grid.dy);
          for (std::size_t t = 0; t < excess::count; ++t)
            expected[t] += along.weight[a] * along.weight[b] * grid.cell_area() * value[t];
        }
      for (std::size_t t = 0; t < excess::count; ++t) // the rule of the test in the cell
        EXPECT_NEAR(found.at(i, j)[t], expected[t], 2e-5 * scale) << cell << " term " << t << " at " << i << ' ' << j;
    }
  }
}

/// Shear stress xz at a point under a unit shear along x at the origin, less that of a homogeneous body, as the mean over a layer.
double sheared_point(const ElasticStack& stack, double from, double to, double x, double y)
{
  const double r = std::hypot(x, y), end = 18.0 / stack.layers.front().thickness;
  const double twice = r > 0.0 ? (x * x - y * y) / (r * r) : 0.0;
  const std::size_t at = stack.layer_at(0.5 * (from + to));
  const ElasticStack alone{{}, {1.0, stack.of_layer(at).poisson_ratio}};
  const int panels = 20 + static_cast<int>(end * r / pi);
  double sum = 0.0;
  for (int p = 0; p < panels; ++p)
  {
    const test::Gauss rule(12, end * p / panels, end * (p + 1) / panels);
    for (std::size_t g = 0; g < rule.point.size(); ++g)
    {
      const double k = rule.point[g];
      const green::StackWave wave(stack, k), other(alone, k);
      const auto excess = [&](green::WaveLoad load)
      {
        const green::WaveStress a = wave.mean_stress(load, wave.field_of(load), at, from, to),
                                b = other.mean_stress(load, other.field_of(load), 0, from, to);
        return load == green::WaveLoad::along ? a.lz - b.lz : a.tz - b.tz;
      };
      const double lz = excess(green::WaveLoad::along), tz = excess(green::WaveLoad::across);
      sum += rule.weight[g] * k *
             (0.5 * (lz + tz) * std::cyl_bessel_j(0, k * r) - 0.5 * (lz - tz) * twice * std::cyl_bessel_j(2, k * r));
    }
  }
  return sum / (2.0 * pi);
}

TEST(StackShears, StressOfACellIsTheLayeredIntegral)
{
  const VolumeGrid grid{{16, 16, 0.5, 0.5}, 4, 0.5};
  for (const ElasticStack& stack : {soft_on_hard, hard_on_soft})
  {
    const ExcessStress excess(grid, stack, Traction::shear_x);
    for (const int layer : {0, 1, 2})
    {
      const Quadrant<SymTensor> found = excess.of_layer(layer);
      for (const auto& [i, j] : {std::pair{0, 0}, {2, 1}, {1, 3}, {9, 4}})
      {
        double expected = 0.0;
        const test::Gauss along(4, -0.5, 0.5);
        for (std::size_t a = 0; a < along.point.size(); ++a)
          for (std::size_t b = 0; b < along.point.size(); ++b)
            expected += along.weight[a] * along.weight[b] * 0.25 *
                        sheared_point(stack, layer * grid.dz, (layer + 1) * grid.dz, (i - along.point[a]) * 0.5,
                                      (j - along.point[b]) * 0.5);
        // The stress that a unit shear causes on the surface itself is -1; as for the pressure.
        EXPECT_NEAR(found.at(i, j)[4], expected, 1e-4) << "layer " << layer << " at " << i << ' ' << j;
      }
    }
  }
}

TEST(StackShears, ExcessOfASmallGridIsThatOfAWideOne)
{
  for (const ElasticStack& stack : {soft_on_hard, hard_on_soft, two_layers})
    for (const Boundary along_y : {Boundary::open, Boundary::periodic})
    {
      const SurfaceGrid small{12, 10, 0.5, 0.5, Boundary::open, along_y};
      SurfaceGrid wide = small;
      wide.nx = 40;
      wide.ny = along_y == Boundary::open ? 40 : 10;
      const Quadrant<SurfaceExcess> a = excess_surface(small, stack, 30.0), b = excess_surface(wide, stack, 30.0);
      const double scale = (1.0 - stack.top().poisson_ratio) / stack.top().shear_modulus() * small.dx;
      for (int j = 0; j < a.ny; ++j)
        for (int i = 0; i < a.nx; ++i)
          for (std::size_t t = 0; t < excess::count; ++t)
            EXPECT_NEAR(a.at(i, j)[t], b.at(i, j)[t], 1e-6 * scale) << "term " << t << " at " << i << ' ' << j;
    }
}

TEST(StackShears, AWaveIsThatOfTheStack)
{
  const SurfaceGrid grid{16, 8, 0.25, 0.5, Boundary::periodic, Boundary::periodic};
  const Elastic other{3.0, 0.25};
  const SurfaceCompliance pair(grid, hard_on_soft, {{}, other});
  const double m = 2.0 * pi * 2.0 / 4.0, n = 2.0 * pi / 4.0, k = std::hypot(m, n);
  std::vector<double> load(3 * grid.size());
  const auto phase = [&](int i, int j) { return m * i * grid.dx + n * j * grid.dy; };
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
    {
      load[grid.size() + grid.index(i, j)] = m / k * std::cos(phase(i, j)); // along the wavevector
      load[2 * grid.size() + grid.index(i, j)] = n / k * std::cos(phase(i, j));
    }
  const std::vector<double> u = displaced(pair, load);
  const green::WaveCompliance c = green::StackWave(hard_on_soft, k).compliance();
  const double mu = other.shear_modulus(), along = c.along + 0.75 / (mu * k), tilt = c.coupling + 0.25 / (mu * k);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
    {
      // u_z is i times the coupling: cos becomes -sin.
      EXPECT_NEAR(u[grid.index(i, j)], -tilt * std::sin(phase(i, j)), 1e-13);
      EXPECT_NEAR(u[grid.size() + grid.index(i, j)], m / k * along * std::cos(phase(i, j)), 1e-13);
      EXPECT_NEAR(u[2 * grid.size() + grid.index(i, j)], n / k * along * std::cos(phase(i, j)), 1e-13);
    }
}

} // namespace
} // namespace brinell::halfspace::stack_shears_test
