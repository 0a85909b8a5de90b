// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/green/eigenstrain_sheet.hpp"
#include "brinell/halfspace/half_space.hpp"
#include "gauss.hpp"
#include "grid_fields.hpp"
#include "order.hpp"
#include "periodic_grids.hpp"
#include "volume_fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdio>
#include <numbers>
#include <vector>

/// Stress of pressure and plastic strain with one or both axes periodic.
namespace brinell::halfspace::periodic_half_space_test
{
namespace
{

using test::sampled;
using test::StressField;
using test::unit_deviator;

constexpr double pi = std::numbers::pi;
const Elastic elastic{1.3, 0.28};
/// Over the layer of a cell, from its middle in units of its thickness.
const test::Gauss layer_rule(5, -0.5, 0.5);

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
      for (std::size_t q = 0; q < layer_rule.point.size(); ++q)
      {
        const double z = (layer + 0.5 + layer_rule.point[q]) * g.dz;
        const double w = layer_rule.weight[q] * std::exp(-k * z);
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
    for (std::size_t q = 0; q < layer_rule.point.size(); ++q)
      for (std::size_t r = 0; r < layer_rule.point.size(); ++r)
      {
        const auto s = green::eigenstrain_sheet_stress(m, n, (layer + 0.5 + layer_rule.point[q]) * g.dz,
                                                       (source + 0.5 + layer_rule.point[r]) * g.dz, unit, elastic);
        const double w = layer_rule.weight[q] * layer_rule.weight[r] * g.dz;
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
  const double everywhere =
      test::largest_difference(grid, narrow_stress, wide, wide_stress, 0) / (2.0 * elastic.shear_modulus());
  std::printf("strain %s: copies in x leave %.2e of 2 mu max|eps|\n",
              test::deviator_names[static_cast<std::size_t>(GetParam())], everywhere);
  EXPECT_LE(everywhere, 1e-4); // docs/theory/half-space.md
}

TEST_P(PeriodicStrainTest, WithOneOpenAxisWavesUpToTheEdgesDoNotFeelTheirCopies)
{
  // The worst for the padding: a grid that is narrower than the period, and strain of the longest wave along y, or uniform along
  // y, in all of its columns. Two columns at either edge have less, so that there is no part of it whose sign the cells do not
  // tell (pi per cell). The same on a grid four times as wide has its copies where nothing comes from.
  const VolumeGrid grid{periodic_in_y(16, 10, 0.5, 1.2), 8, 1.0};
  VolumeGrid wide = grid;
  wide.surface.nx *= 4;
  const double n = 2.0 * pi / (grid.surface.ny * grid.surface.dy);
  for (const bool uniform : {false, true})
  {
    const auto profile = [&](double x, double y, double)
    {
      const double from_edge = std::min(x, (grid.surface.nx - 1) * grid.surface.dx - x) / grid.surface.dx; // columns
      const double share = from_edge < -0.5 ? 0.0 : from_edge < 0.5 ? 0.25 : from_edge < 1.5 ? 0.75 : 1.0;
      return uniform ? share : share * std::cos(n * y);
    };
    const Deviator strain = unit_deviator(GetParam());
    const StressField narrow_stress(HalfSpace(grid, elastic), {}, test::sampled_strain(grid, strain, profile));
    const StressField wide_stress(HalfSpace(wide, elastic), {}, test::sampled_strain(wide, strain, profile));
    const double everywhere =
        test::largest_difference(grid, narrow_stress, wide, wide_stress, 0) / (2.0 * elastic.shear_modulus());
    std::printf("strain %s, %s: copies in x leave %.2e of 2 mu max|eps|\n",
                test::deviator_names[static_cast<std::size_t>(GetParam())], uniform ? "uniform" : "a wave", everywhere);
    EXPECT_LE(everywhere, 1e-4); // docs/theory/half-space.md
  }
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
    errors.push_back(test::largest_difference(grid, exact, row, found, count * grid.surface.ny) /
                     (2.0 * elastic.shear_modulus()));
  }
  const test::Orders orders("row of copies of strain, copies doubled", errors);
  EXPECT_GT(orders.overall, 1.5);
  EXPECT_LT(errors.back(), 2e-3);
}

} // namespace
} // namespace brinell::halfspace::periodic_half_space_test
