// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/green/eigenstrain_sheet.hpp"
#include "brinell/green/rectangle.hpp"
#include "brinell/green/strip.hpp"
#include "brinell/halfspace/half_space.hpp"
#include "brinell/halfspace/surface_compliance.hpp"
#include "order.hpp"
#include "random_field.hpp"
#include "volume_fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

namespace brinell::halfspace
{
namespace
{

using test::StressField;
using test::unit_deviator;

constexpr double pi = std::numbers::pi;
constexpr double modulus = 1.7; // E'
const Elastic elastic{1.3, 0.28};

SurfaceGrid periodic(int nx, int ny, double dx, double dy)
{
  return {nx, ny, dx, dy, Boundary::periodic, Boundary::periodic};
}

SurfaceGrid periodic_in_y(int nx, int ny, double dx, double dy)
{
  return {nx, ny, dx, dy, Boundary::open, Boundary::periodic};
}

SurfaceGrid swapped(const SurfaceGrid& g)
{
  return {g.ny, g.nx, g.dy, g.dx, g.boundary_y, g.boundary_x};
}

/// f(i, j) at all cells.
template <typename Function>
std::vector<double> sampled(const SurfaceGrid& g, Function f)
{
  std::vector<double> field(g.size());
  for (int j = 0; j < g.ny; ++j)
    for (int i = 0; i < g.nx; ++i)
      field[g.index(i, j)] = f(i, j);
  return field;
}

std::vector<double> displacement(const SurfaceCompliance& compliance, const std::vector<double>& pressure)
{
  std::vector<double> u(pressure.size());
  SurfaceCompliance::Scratch scratch = compliance.make_scratch();
  compliance.apply({.pressure = pressure}, {.z = u}, scratch);
  return u;
}

double largest(const std::vector<double>& field)
{
  double value = 0.0;
  for (const double f : field)
    value = std::max(value, std::abs(f));
  return value;
}

// --- displacement -------------------------------------------------------------------------------------------------

class PeriodicWaveTest : public testing::TestWithParam<std::tuple<int, int>>
{
};

INSTANTIATE_TEST_SUITE_P(Cells, PeriodicWaveTest,
                         testing::Values(std::tuple{16, 12}, std::tuple{15, 9}, std::tuple{32, 1}, std::tuple{1, 20},
                                         std::tuple{7, 10}));

TEST_P(PeriodicWaveTest, GivesADisplacementOfTwoOverModulusAndWavenumber)
{
  const auto [nx, ny] = GetParam();
  const SurfaceGrid g = periodic(nx, ny, 0.5, 0.7);
  const SurfaceCompliance compliance(g, modulus);
  for (const auto& [a, b] : {std::pair{1, 0}, {0, 1}, {1, 1}, {3, 2}})
  {
    if (2 * a >= nx + (a == 0) || 2 * b >= ny + (b == 0))
      continue; // not told from a longer one by these cells
    const auto wave = sampled(g, [&, nx = nx, ny = ny, a = a, b = b](int i, int j)
                              { return 3.0 + std::cos(2.0 * pi * (a * i / double(nx) + b * j / double(ny)) + 0.3); });
    const auto u = displacement(compliance, wave);
    const double k = 2.0 * pi * std::hypot(a / (nx * g.dx), b / (ny * g.dy));
    for (std::size_t n = 0; n < u.size(); ++n) // the uniform part counts as nothing
      EXPECT_NEAR(u[n], 2.0 / (modulus * k) * (wave[n] - 3.0), 1e-13 / k) << a << ' ' << b;
  }
}

TEST(PeriodicSurfaceTest, OneCellHasNoResponseAndFewOnesAFiniteOne)
{
  EXPECT_THROW(SurfaceCompliance(periodic(1, 1, 0.5, 0.7), modulus), InputError);
  for (const auto& [nx, ny] : {std::pair{2, 1}, {1, 2}, {2, 2}, {3, 1}, {1, 3}})
  {
    const SurfaceGrid g = periodic(nx, ny, 0.5, 0.7);
    const SurfaceCompliance compliance(g, modulus);
    SurfaceCompliance::Scratch scratch = compliance.make_scratch();
    std::vector<double> p(g.size(), 0.0), u(g.size()), back(g.size());
    p[0] = 1.0;
    compliance.apply({.pressure = p}, {.z = u}, scratch);
    compliance.apply_inverse(u, back, scratch);
    const double mean = 1.0 / static_cast<double>(g.size());
    for (std::size_t n = 0; n < p.size(); ++n) // the displacement has no uniform part
      EXPECT_NEAR(back[n], p[n] - mean, 1e-12) << nx << ' ' << ny;
  }
}

TEST(StripTest, IsALongRectangleButForAConstant)
{
  const double dx = 0.4;
  const double length = 1e6;
  const auto strip = [&](double x)
  { return green::strip_displacement_edge(x + 0.5 * dx, 5.0) - green::strip_displacement_edge(x - 0.5 * dx, 5.0); };
  const double constant = strip(0.0) - green::rectangle_displacement(0.0, 0.0, dx, length);
  for (const double x : {0.1, 0.2, 0.9, 7.0}) // a finite length leaves (x / length)^2 of it; rounding of its logarithm
    EXPECT_NEAR(strip(x) - green::rectangle_displacement(x, 0.0, dx, length), constant, 1e-5 * dx);
  for (const double x : {0.0, 0.15, 0.2, 1.0})
    for (const double z : {0.0, 0.05, 0.3, 2.0})
    {
      if (x == 0.2 && z == 0.0)
        continue; // on the edge
      const SymTensor left = green::strip_stress_edge(x - 0.5 * dx, z, 0.3);
      const SymTensor right = green::strip_stress_edge(x + 0.5 * dx, z, 0.3);
      const SymTensor rectangle = green::rectangle_stress(x, 0.0, z, dx, length, 0.3);
      for (std::size_t c = 0; c < 6; ++c)
        EXPECT_NEAR(right[c] - left[c], rectangle[c], dx / length) << "component " << c << " at " << x << ' ' << z;
    }
}

TEST(OnePeriodicAxisTest, OneRowIsAStrip)
{
  const SurfaceGrid g = periodic_in_y(9, 1, 0.5, 3.0);
  const auto p = test::random_field(g.size(), 1);
  const auto u = displacement(SurfaceCompliance(g, modulus, 20.0), p);
  for (int i = 0; i < g.nx; ++i)
  {
    double sum = 0.0;
    for (int m = 0; m < g.nx; ++m)
      sum += p[g.index(m, 0)] * (green::strip_displacement_edge((i - m + 0.5) * g.dx, 20.0) -
                                 green::strip_displacement_edge((i - m - 0.5) * g.dx, 20.0));
    EXPECT_NEAR(u[g.index(i, 0)], sum / (pi * modulus), 1e-12);
  }
}

/// Copies of a pressure, `count` to each side along y, on a grid that is open.
std::vector<double> with_copies(const SurfaceGrid& g, const std::vector<double>& pressure, int count)
{
  std::vector<double> copies;
  for (int copy = -count; copy <= count; ++copy)
    copies.insert(copies.end(), pressure.begin(), pressure.end());
  EXPECT_EQ(copies.size(), g.size() * static_cast<std::size_t>(2 * count + 1));
  return copies;
}

TEST(OnePeriodicAxisTest, IsTheMiddleOfALongRowOfCopies)
{
  // Differences of displacements, as a row of copies sinks by a constant that grows with its logarithm. What the copies that
  // are missing add varies over the period as 1 / count^2.
  const SurfaceGrid g = periodic_in_y(6, 5, 0.5, 0.8);
  const auto p = test::random_field(g.size(), 2);
  const auto u = displacement(SurfaceCompliance(g, modulus, 50.0), p);
  std::vector<double> errors;
  for (const int count : {10, 20, 40})
  {
    SurfaceGrid row = g;
    row.boundary_y = Boundary::open;
    row.ny = g.ny * (2 * count + 1);
    const auto of_row = displacement(SurfaceCompliance(row, modulus), with_copies(g, p, count));
    const std::size_t middle = row.index(0, g.ny * count);
    double error = 0.0;
    for (std::size_t n = 0; n < u.size(); ++n)
      error = std::max(error, std::abs(u[n] - u[0] - of_row[middle + n] + of_row[middle]));
    errors.push_back(error / largest(u));
  }
  EXPECT_GT(test::Orders("row of copies, displacement, copies doubled", errors).overall, 1.8);
  EXPECT_LT(errors.back(), 1e-4);
  // The exact limit: what is left is the sum over the near copies and the strip for the far ones.
  EXPECT_LT(std::abs(4.0 * errors[2] - errors[1]) / 3.0, 2e-6);
}

TEST(OnePeriodicAxisTest, WavesAlongItThatTheOtherDoesNotChangeAreThoseOfTheWholePlane)
{
  // Rows so wide that their ends are many wavelengths away: the middle sees a wave without ends, but for the cells, which
  // sample the closed form of the rectangle where the periodic operator has waves: second order.
  std::vector<double> errors;
  for (const int ny : {16, 32, 64})
  {
    const SurfaceGrid g = periodic_in_y(8 * ny + 1, ny, 1.0 / ny, 1.0 / ny);
    const auto p = sampled(g, [&](int, int j) { return std::cos(2.0 * pi * j / ny); });
    const auto u = displacement(SurfaceCompliance(g, modulus, 50.0), p);
    errors.push_back(std::abs(u[g.index(4 * ny, 0)] * modulus * pi - 1.0));
  }
  EXPECT_GT(test::Orders("wave along the periodic axis, cells halved", errors).last, 1.9);
}

class BoundaryPairTest : public testing::TestWithParam<SurfaceGrid>
{
};

INSTANTIATE_TEST_SUITE_P(Grids, BoundaryPairTest,
                         testing::Values(periodic(8, 6, 0.7, 0.9), periodic(7, 5, 0.7, 0.9), periodic(6, 1, 1.0, 1.0),
                                         periodic_in_y(8, 6, 0.7, 0.9), periodic_in_y(7, 5, 0.7, 0.9),
                                         periodic_in_y(9, 1, 0.7, 0.9)));

TEST_P(BoundaryPairTest, AxesCanBeExchanged)
{
  const VolumeGrid g{GetParam(), 4, 0.6};
  const VolumeGrid h{swapped(GetParam()), 4, 0.6};
  const auto at = [&](const SurfaceGrid& grid, unsigned seed)
  {
    const auto f = test::random_field(GetParam().size(), seed);
    return sampled(grid, [&](int i, int j) { return f[grid == GetParam() ? grid.index(i, j) : grid.ny * i + j]; });
  };
  const auto p = at(g.surface, 3);
  const auto q = sampled(h.surface, [&](int i, int j) { return p[g.surface.index(j, i)]; });
  const auto u = displacement(SurfaceCompliance(g.surface, modulus, 30.0), p);
  const auto v = displacement(SurfaceCompliance(h.surface, modulus, 30.0), q);
  for (int j = 0; j < g.surface.ny; ++j)
    for (int i = 0; i < g.surface.nx; ++i)
      EXPECT_NEAR(u[g.surface.index(i, j)], v[h.surface.index(j, i)], 1e-12);

  const auto strain = test::random_field(Deviator::size * g.size(), 4);
  std::vector<double> exchanged(strain.size());
  constexpr std::array<int, Deviator::size> of{Deviator::yy, Deviator::xx, Deviator::xz, Deviator::yz, Deviator::xy};
  for (int c = 0; c < Deviator::size; ++c)
    for (int k = 0; k < g.nz; ++k)
      for (int j = 0; j < g.surface.ny; ++j)
        for (int i = 0; i < g.surface.nx; ++i)
          exchanged[static_cast<std::size_t>(c) * g.size() + h.index(j, i, k)] =
              strain[static_cast<std::size_t>(of[static_cast<std::size_t>(c)]) * g.size() + g.index(i, j, k)];
  const auto residual = [](const VolumeGrid& grid, const std::vector<double>& plastic)
  {
    const HalfSpace half_space(grid, elastic);
    HalfSpace::Work work = half_space.make_work();
    std::vector<double> displaced(grid.surface.size());
    half_space.load(plastic, grid.nz, work).displacement({.z = displaced});
    return displaced;
  };
  const auto a = residual(g, strain);
  const auto b = residual(h, exchanged);
  for (int j = 0; j < g.surface.ny; ++j)
    for (int i = 0; i < g.surface.nx; ++i)
      EXPECT_NEAR(a[g.surface.index(i, j)], b[h.surface.index(j, i)], 1e-11 * largest(a));
  const StressField s(HalfSpace(g, elastic), p, strain);
  const StressField t(HalfSpace(h, elastic), q, exchanged);
  for (int k = 0; k < g.nz; ++k)
    for (int j = 0; j < g.surface.ny; ++j)
      for (int i = 0; i < g.surface.nx; ++i)
      {
        const SymTensor here = s.at(g.index(i, j, k));
        const SymTensor there = t.at(h.index(j, i, k));
        constexpr std::array<std::size_t, 6> other{1, 0, 2, 4, 3, 5};
        for (std::size_t c = 0; c < 6; ++c)
          EXPECT_NEAR(here[c], there[other[c]], 1e-11) << "component " << c;
      }
}

TEST_P(BoundaryPairTest, OperatorsAreReciprocalAndNegative)
{
  const VolumeGrid g{GetParam(), 4, 0.6};
  const HalfSpace half_space(g, elastic);
  HalfSpace::Work work = half_space.make_work();
  const auto p = test::random_field(g.surface.size(), 5);
  const auto a = test::random_field(Deviator::size * g.size(), 6);
  const auto b = test::random_field(Deviator::size * g.size(), 7);
  std::vector<double> u(g.surface.size()), none(a.size(), 0.0), of_p(a.size()), of_a(a.size()), of_b(a.size());
  half_space.load(a, g.nz, work).displacement({.z = u});
  half_space.load(none, g.nz, work).stress({.pressure = p}, of_p);
  half_space.load(a, g.nz, work).stress({}, of_a);
  half_space.load(b, g.nz, work).stress({}, of_b);
  // Betti: pressure times residual displacement, and stress of the pressure times strain.
  const double by_pressure = test::dot(p, u) * g.surface.cell_area();
  const double by_stress = test::contracted(of_p, a) * g.cell_volume();
  const double scale = std::sqrt(test::dot(p, p) * test::dot(u, u)) * g.surface.cell_area();
  EXPECT_NEAR(by_pressure, by_stress, 1e-12 * scale);
  const double energy = std::sqrt(test::contracted(of_a, a) * test::contracted(of_b, b));
  EXPECT_NEAR(test::contracted(of_a, b), test::contracted(of_b, a), 1e-12 * energy);
  EXPECT_LT(test::contracted(of_a, a), 0.0); // strain locks energy in
}

TEST_P(BoundaryPairTest, NothingChangesWhenAllMovesAroundThePeriod)
{
  const VolumeGrid g{GetParam(), 4, 0.6};
  const int di = g.surface.is_periodic_x() ? 2 : 0;
  const int dj = g.surface.is_periodic_y() && g.surface.ny > 1 ? 2 : 0;
  const auto moved = [&](const std::vector<double>& field)
  {
    std::vector<double> out(field.size());
    const std::size_t cells = g.surface.size();
    for (std::size_t plane = 0; plane < field.size() / cells; ++plane)
      for (int j = 0; j < g.surface.ny; ++j)
        for (int i = 0; i < g.surface.nx; ++i)
          out[plane * cells + g.surface.index((i + di) % g.surface.nx, (j + dj) % g.surface.ny)] =
              field[plane * cells + g.surface.index(i, j)];
    return out;
  };
  const HalfSpace half_space(g, elastic);
  const auto p = test::random_field(g.surface.size(), 8);
  const auto strain = test::random_field(Deviator::size * g.size(), 9);
  const StressField here(half_space, p, strain);
  const StressField there(half_space, moved(p), moved(strain));
  const auto expected = moved(here.deviator);
  for (std::size_t n = 0; n < expected.size(); ++n)
    ASSERT_NEAR(there.deviator[n], expected[n], 1e-12);
}

// --- stress -------------------------------------------------------------------------------------------------------

/// Five-point Gauss rule on [-1/2, 1/2].
constexpr std::array<double, 5> gauss_point{-0.4530899229693320, -0.2692346550528415, 0.0, 0.2692346550528415,
                                            0.4530899229693320};
constexpr std::array<double, 5> gauss_weight{0.1184634425280945, 0.2393143352496833, 0.2844444444444444,
                                             0.2393143352496833, 0.1184634425280945};

TEST(PeriodicStressTest, OfAPressureWaveIsTheClosedForm)
{
  const VolumeGrid g{periodic(12, 10, 0.5, 0.6), 5, 0.4};
  const double m = 2.0 * pi * 2 / (g.surface.nx * g.surface.dx);
  const double n = 2.0 * pi * 1 / (g.surface.ny * g.surface.dy);
  const double k = std::hypot(m, n);
  const double nu = elastic.poisson_ratio;
  const auto phase = [&](int i, int j) { return m * i * g.surface.dx + n * j * g.surface.dy; };
  const auto p = sampled(g.surface, [&](int i, int j) { return 0.5 + std::cos(phase(i, j)); });
  const StressField stress(HalfSpace(g, elastic), p, {});
  for (int layer = 0; layer < g.nz; ++layer)
    for (const auto& [i, j] : {std::pair{0, 0}, {3, 1}, {7, 8}})
    {
      // Airy's function in the plane of the wavevector, (1 + k z) e^{-kz} cos: mean over the layer by quadrature.
      double ll = 0.0, zz = 0.0, tt = 0.0, lz = 0.0;
      for (std::size_t q = 0; q < gauss_point.size(); ++q)
      {
        const double z = (layer + 0.5 + gauss_point[q]) * g.dz;
        const double w = gauss_weight[q] * std::exp(-k * z);
        ll -= w * (1.0 - k * z) * std::cos(phase(i, j));
        zz -= w * (1.0 + k * z) * std::cos(phase(i, j));
        lz -= w * k * z * std::sin(phase(i, j));
      }
      tt = nu * (ll + zz);
      const double lx = m / k, ly = n / k;
      const double held = -0.5 * nu / (1.0 - nu); // of the uniform part
      const SymTensor expected{lx * lx * ll + ly * ly * tt + held,
                               ly * ly * ll + lx * lx * tt + held,
                               zz - 0.5,
                               ly * lz,
                               lx * lz,
                               lx * ly * (ll - tt)};
      const SymTensor found = stress.at(g.index(i, j, layer));
      for (std::size_t c = 0; c < 6; ++c)
        EXPECT_NEAR(found[c], expected[c], 1e-9) << "component " << c << " in layer " << layer; // of the quadrature
    }
}

class PeriodicStrainTest : public testing::TestWithParam<int>
{
};

INSTANTIATE_TEST_SUITE_P(Strains, PeriodicStrainTest, testing::Range(0, Deviator::size),
                         [](const auto& p) { return test::deviator_names[static_cast<std::size_t>(p.param)]; });

TEST_P(PeriodicStrainTest, StressOfAWaveIsTheClosedFormOfSheets)
{
  // One layer of strain, cos(m x + n y): the means over the other layers of the sheets in it, by quadrature in both depths.
  const VolumeGrid g{periodic(12, 10, 0.5, 0.6), 6, 0.4};
  constexpr int source = 2;
  const double m = 2.0 * pi * 1 / (g.surface.nx * g.surface.dx);
  const double n = 2.0 * pi * 2 / (g.surface.ny * g.surface.dy);
  const Deviator unit = unit_deviator(GetParam());
  const auto strain =
      test::sampled_strain(g, unit,
                           [&](double x, double y, double z) {
                             return std::abs(z - (source + 0.5) * g.dz) < 0.1 * g.dz ? std::cos(m * x + n * y) : 0.0;
                           });
  const StressField stress(HalfSpace(g, elastic), {}, strain);
  for (int layer = 0; layer < g.nz; ++layer)
  {
    if (layer == source)
      continue; // there the sheets' own stress comes in, which the tests of the free half space cover
    std::array<std::complex<double>, Deviator::size + 1> sum{};
    for (std::size_t q = 0; q < gauss_point.size(); ++q)
      for (std::size_t r = 0; r < gauss_point.size(); ++r)
      {
        const auto s = green::eigenstrain_sheet_stress(m, n, (layer + 0.5 + gauss_point[q]) * g.dz,
                                                       (source + 0.5 + gauss_point[r]) * g.dz, unit, elastic);
        const double w = gauss_weight[q] * gauss_weight[r] * g.dz;
        for (std::size_t c = 0; c < Deviator::size; ++c)
          sum[c] += w * s.deviator[c];
        sum[Deviator::size] += w * s.trace;
      }
    for (const auto& [i, j] : {std::pair{0, 0}, {5, 3}})
    {
      const std::complex<double> wave = std::polar(1.0, m * i * g.surface.dx + n * j * g.surface.dy);
      const std::size_t cell = g.index(i, j, layer);
      for (std::size_t c = 0; c < Deviator::size; ++c)
        EXPECT_NEAR(stress.deviator[c * g.size() + cell], (sum[c] * wave).real(), 1e-8) << "component " << c;
      EXPECT_NEAR(stress.trace[cell], (sum[Deviator::size] * wave).real(), 1e-8);
    }
  }
}

TEST_P(PeriodicStrainTest, UniformLayerIsHeldInItsPlane)
{
  const VolumeGrid g{periodic(4, 6, 0.5, 0.6), 4, 0.4};
  const Deviator unit = unit_deviator(GetParam());
  const auto strain =
      test::sampled_strain(g, unit, [&](double, double, double z) { return z < 2.0 * g.dz ? 1.0 : 0.0; });
  const StressField stress(HalfSpace(g, elastic), {}, strain);
  // Plane stress across the layer, no strain in its plane: sigma_ab = -2 mu (eps_ab + nu/(1 - nu) tr eps delta_ab).
  const SymTensor e = test::as_tensor(unit);
  const double nu = elastic.poisson_ratio;
  const double mu2 = 2.0 * elastic.shear_modulus();
  const double in_plane = nu / (1.0 - nu) * (e[0] + e[1]);
  const SymTensor held{-mu2 * (e[0] + in_plane), -mu2 * (e[1] + in_plane), 0.0, 0.0, 0.0, -mu2 * e[5]};
  for (int k = 0; k < g.nz; ++k)
    for (std::size_t c = 0; c < 6; ++c)
      EXPECT_NEAR(stress.at(g.index(1, 2, k))[c], k < 2 ? held[c] : 0.0, 1e-12) << "component " << c;
}

TEST_P(PeriodicStrainTest, WithOneOpenAxisOtherCopiesAreNotFelt)
{
  // A blob on a grid that is periodic in y, and the same on one four times as wide in x: what is left of the copies in x, by
  // the polynomial for what is uniform along y, and by the distance for waves along y.
  const VolumeGrid grid{periodic_in_y(24, 10, 1.0, 1.2), 8, 1.0};
  VolumeGrid wide = grid;
  wide.surface.nx *= 4;
  const auto blob = [&](double x, double y, double z)
  {
    const double u = (x - 11.5) / 2.0;
    const double v = std::sin(pi * (y - 4.5 * 1.2) / (10 * 1.2)) * 2.5;
    return x < 23.5 ? std::exp(-0.5 * (u * u + v * v)) * (1.0 - z / 10.0) : 0.0;
  };
  const Deviator strain = unit_deviator(GetParam());
  const StressField narrow_stress(HalfSpace(grid, elastic), {}, test::sampled_strain(grid, strain, blob));
  const StressField wide_stress(HalfSpace(wide, elastic), {}, test::sampled_strain(wide, strain, blob));
  const double scale = 2.0 * elastic.shear_modulus();
  double everywhere = 0.0;
  for (int k = 0; k < grid.nz; ++k)
    for (int j = 0; j < grid.surface.ny; ++j)
      for (int i = 0; i < grid.surface.nx; ++i)
        for (std::size_t c = 0; c < 6; ++c)
          everywhere = std::max(
              everywhere,
              std::abs(narrow_stress.at(grid.index(i, j, k))[c] - wide_stress.at(wide.index(i, j, k))[c]) / scale);
  std::printf("strain %s: copies in x leave %.2e of 2 mu max|eps|\n",
              test::deviator_names[static_cast<std::size_t>(GetParam())], everywhere);
  EXPECT_LE(everywhere, 5e-4);
}

TEST_P(PeriodicStrainTest, WithOnePeriodicAxisIsTheMiddleOfARowOfCopies)
{
  // The stress of a copy decays as 1/r^3, that of those which are missing beyond `count` as 1 / count^2.
  const VolumeGrid grid{periodic_in_y(48, 8, 1.0, 1.2), 6, 1.0}; // wide, so that no row is much longer
  const auto field_of = [&](const VolumeGrid& g)
  {
    // Smooth, and zero where the row ends, so that the cells tell the same strain on both grids.
    const auto blobs = [&](double x, double y, double z)
    {
      const double in_x = std::abs(x - 23.5) < 6.0 ? std::cos(pi * (x - 23.5) / 12.0) : 0.0;
      const double in_y = std::cos(pi * (y - 3.5 * 1.2) / (8 * 1.2));
      return std::pow(in_x, 6) * std::pow(in_y, 6) * std::exp(-0.3 * z);
    };
    return test::sampled_strain(g, unit_deviator(GetParam()), blobs);
  };
  const StressField exact(HalfSpace(grid, elastic), {}, field_of(grid));
  std::vector<double> errors;
  for (const int count : {2, 4, 8})
  {
    VolumeGrid row = grid;
    row.surface.boundary_y = Boundary::open;
    row.surface.ny *= 2 * count + 1;
    const StressField found(HalfSpace(row, elastic), {}, field_of(row));
    double error = 0.0;
    for (int k = 0; k < grid.nz; ++k)
      for (int j = 0; j < grid.surface.ny; ++j)
        for (int i = 0; i < grid.surface.nx; ++i)
          for (std::size_t c = 0; c < 6; ++c)
            error = std::max(error, std::abs(exact.at(grid.index(i, j, k))[c] -
                                             found.at(row.index(i, j + count * grid.surface.ny, k))[c]));
    errors.push_back(error / (2.0 * elastic.shear_modulus()));
  }
  const test::Orders orders("row of copies of strain, copies doubled", errors);
  EXPECT_GT(orders.overall, 1.5);
  EXPECT_LT(errors.back(), 2e-3);
}

} // namespace
} // namespace brinell::halfspace
