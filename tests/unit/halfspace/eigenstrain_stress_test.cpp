// SPDX-License-Identifier: BSD-3-Clause
// Plastic strain -> residual stress: what must hold whatever the numbers are.
#include "brinell/halfspace/half_space.hpp"

#include "brinell/foundation/error.hpp"
#include "order.hpp"
#include "random_field.hpp"
#include "refusal.hpp"
#include "volume_fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace brinell::halfspace::eigenstrain_stress_test
{
namespace
{

using test::StressField;
using test::unit_deviator;

const Elastic elastic{1.0, 0.3};

/// Deviatoric residual stress.
std::vector<double> residual_stress(const HalfSpace& half_space, const std::vector<double>& strain)
{
  return StressField(half_space, {}, strain).deviator;
}

class EigenstrainStressTest : public testing::TestWithParam<VolumeGrid>
{
};

INSTANTIATE_TEST_SUITE_P(Grids, EigenstrainStressTest,
                         testing::Values(VolumeGrid{{6, 6, 1.0, 1.0}, 5, 1.0}, VolumeGrid{{9, 4, 0.5, 1.5}, 7, 0.3},
                                         VolumeGrid{{1, 5, 1.0, 1.0}, 1, 2.0},
                                         VolumeGrid{{33, 7, 1e-6, 2e-6}, 4, 5e-7}),
                         [](const auto& p)
                         {
                           const VolumeGrid& g = p.param;
                           return std::to_string(g.surface.nx) + "x" + std::to_string(g.surface.ny) + "x" +
                                  std::to_string(g.nz);
                         });

TEST_P(EigenstrainStressTest, TwoStrainsAreReciprocal)
{
  // <f, H e> = <e, H f> to round-off: both sides are sums of the same products (Betti).
  const HalfSpace half_space(GetParam(), elastic);
  const std::vector<double> e = test::random_field(Deviator::size * GetParam().size(), 1);
  const std::vector<double> f = test::random_field(e.size(), 2);
  const double a = test::contracted(f, residual_stress(half_space, e));
  const double b = test::contracted(e, residual_stress(half_space, f));
  const double scale = std::sqrt(test::contracted(e, residual_stress(half_space, e)) *
                                 test::contracted(f, residual_stress(half_space, f)));
  EXPECT_NEAR(a, b, 1e-12 * scale);
}

TEST_P(EigenstrainStressTest, EveryStrainLocksInEnergy)
{
  // The energy -1/2 eps : s is positive, and less than that of a strain held everywhere, mu eps : eps, by which the
  // plain fixed point of an increment is certain to descend.
  const HalfSpace half_space(GetParam(), elastic);
  for (unsigned seed = 0; seed < 6; ++seed)
  {
    const std::vector<double> e = test::random_field(Deviator::size * GetParam().size(), seed);
    const double energy = -0.5 * test::contracted(e, residual_stress(half_space, e));
    EXPECT_GT(energy, 0.0);
    EXPECT_LT(energy, elastic.shear_modulus() * test::contracted(e, e) * (1.0 + 1e-12));
  }
  for (int component = 0; component < Deviator::size; ++component) // one cell; a checkerboard in x
    for (const int step : {0, 2})
    {
      const VolumeGrid& g = GetParam();
      const std::vector<double> e =
          test::sampled_strain(g, unit_deviator(component),
                               [&](double x, double y, double z)
                               {
                                 const auto i = static_cast<int>(std::lround(x / g.surface.dx));
                                 return step == 0 ? (i + y + z == 0.5 * g.dz ? 1.0 : 0.0) : (i % step ? -1.0 : 1.0);
                               });
      const double energy = -0.5 * test::contracted(e, residual_stress(half_space, e));
      EXPECT_GT(energy, 0.0);
      EXPECT_LT(energy, elastic.shear_modulus() * test::contracted(e, e) * (1.0 + 1e-12));
    }
}

TEST_P(EigenstrainStressTest, LayersWithoutStrainMayBeLeftOut)
{
  const VolumeGrid& g = GetParam();
  const int layers = (g.nz + 1) / 2;
  const HalfSpace half_space(g, elastic);
  std::vector<double> strain = test::random_field(Deviator::size * g.size(), 3);
  const auto first_zero = static_cast<std::size_t>(layers) * g.surface.size();
  for (std::size_t i = 0; i < strain.size(); ++i)
    strain[i] *= i % g.size() < first_zero ? 1.0 : 0.0;
  const std::vector<double> pressure = test::random_field(g.surface.size(), 4, 0.0, 1.0);

  HalfSpace::Work work = half_space.make_work();
  std::vector<double> all(strain.size()), some(strain.size(), 0.0), u_all(g.surface.size()), u_some(u_all);
  const HalfSpace::Loaded loaded_all = half_space.load(strain, g.nz, work);
  loaded_all.displacement({.z = u_all});
  loaded_all.stress({.pressure = pressure}, all);
  const HalfSpace::Loaded loaded_some = half_space.load(strain, layers, work);
  loaded_some.displacement({.z = u_some});
  loaded_some.stress({.pressure = pressure}, some);
  for (std::size_t i = 0; i < strain.size(); ++i)
    EXPECT_NEAR(some[i], i % g.size() < first_zero ? all[i] : 0.0, 1e-13); // stresses of order one
  for (std::size_t i = 0; i < u_all.size(); ++i)
    EXPECT_NEAR(u_some[i], u_all[i], 1e-13 * g.dz);
}

TEST_P(EigenstrainStressTest, DeviatoricAndFullStressAgree)
{
  const HalfSpace half_space(GetParam(), elastic);
  const std::vector<double> strain = test::random_field(Deviator::size * GetParam().size(), 5);
  const std::vector<double> pressure = test::random_field(GetParam().surface.size(), 6, 0.0, 1.0);
  HalfSpace::Work work = half_space.make_work();
  std::vector<double> deviator(strain.size());
  std::vector<double> displacement(pressure.size());
  const HalfSpace::Loaded loaded_deviator = half_space.load(strain, GetParam().nz, work);
  loaded_deviator.displacement({.z = displacement});
  loaded_deviator.stress({.pressure = pressure}, deviator);
  const StressField full(half_space, pressure, strain);
  for (std::size_t i = 0; i < strain.size(); ++i)
    EXPECT_NEAR(deviator[i], full.deviator[i], 1e-13);
}

TEST(EigenstrainShiftTest, StressMovesWithTheStrainByWholeCells)
{
  const VolumeGrid g{{20, 12, 1.0, 1.5}, 5, 0.7};
  const HalfSpace half_space(g, elastic);
  const int di = 5, dj = 3;
  const std::vector<double> cells = test::random_field(Deviator::size * 6 * 5 * static_cast<std::size_t>(g.nz), 7);
  const auto patch = [&](int i0, int j0)
  {
    std::vector<double> strain(Deviator::size * g.size(), 0.0);
    std::size_t n = 0;
    for (int c = 0; c < Deviator::size; ++c)
      for (int k = 0; k < g.nz; ++k)
        for (int j = 0; j < 5; ++j)
          for (int i = 0; i < 6; ++i)
            strain[static_cast<std::size_t>(c) * g.size() + g.index(i0 + i, j0 + j, k)] = cells[n++];
    return strain;
  };
  const StressField here(half_space, {}, patch(4, 2)), there(half_space, {}, patch(4 + di, 2 + dj));
  for (int k = 0; k < g.nz; ++k)
    for (int j = 0; j + dj < g.surface.ny; ++j)
      for (int i = 0; i + di < g.surface.nx; ++i)
      {
        const SymTensor a = here.at(g.index(i, j, k)), b = there.at(g.index(i + di, j + dj, k));
        for (std::size_t c = 0; c < 6; ++c)
          ASSERT_NEAR(a[c], b[c], 1e-13) << i << ' ' << j << ' ' << k;
      }
}

/// Strain that is smooth in all directions, and not small at the surface.
std::vector<double> smooth_strain(const VolumeGrid& g, const Deviator& strain, double depth)
{
  const double x0 = 0.47 * g.surface.dx * g.surface.nx, y0 = 0.5 * g.surface.dy * g.surface.ny;
  return test::sampled_strain(g, strain,
                              [&](double x, double y, double z)
                              {
                                const double u = x - x0, v = y - y0, w = z - depth;
                                return std::exp(-0.5 * (u * u + v * v + w * w));
                              });
}

class EigenstrainFieldTest : public testing::TestWithParam<int>
{
};

INSTANTIATE_TEST_SUITE_P(Strains, EigenstrainFieldTest, testing::Range(0, Deviator::size),
                         [](const auto& p) { return test::deviator_names[static_cast<std::size_t>(p.param)]; });

TEST_P(EigenstrainFieldTest, SurfaceIsFreeOfTraction)
{
  // zz, yz and xz at z = 0, on a line through the means of the two upper layers: second order in the layer.
  std::vector<double> errors;
  for (const int nz : {16, 32, 64})
  {
    const VolumeGrid g{{15, 15, 0.7, 0.7}, nz, 4.0 / nz};
    const StressField stress(HalfSpace(g, elastic), {}, smooth_strain(g, unit_deviator(GetParam()), 0.4));
    double largest = 0.0;
    for (int j = 0; j < g.surface.ny; ++j)
      for (int i = 0; i < g.surface.nx; ++i)
      {
        const SymTensor a = stress.at(g.index(i, j, 0)), b = stress.at(g.index(i, j, 1));
        for (const std::size_t c : {2, 3, 4})
          largest = std::max(largest, std::abs(1.5 * a[c] - 0.5 * b[c]));
      }
    errors.push_back(largest);
  }
  EXPECT_GT(test::Orders("traction on the surface, layers halved", errors).last, 1.75);
  EXPECT_LT(errors.back(), 2e-3); // of E max|eps|
}

TEST_P(EigenstrainFieldTest, ForcesBalanceEverywhere)
{
  // Divergence by central differences, largest over the inner cells: second order in all three cell sizes.
  constexpr std::array<std::array<std::size_t, 3>, 3> rows{{{0, 5, 4}, {5, 1, 3}, {4, 3, 2}}};
  std::vector<double> errors;
  for (const int n : {1, 2, 4})
  {
    const VolumeGrid g{{9 * n, 9 * n, 0.9 / n, 0.9 / n}, 6 * n, 0.75 / n};
    const StressField stress(HalfSpace(g, elastic), {}, smooth_strain(g, unit_deviator(GetParam()), 1.2));
    double largest = 0.0;
    for (int k = n; k < g.nz - n; ++k) // the same volume on every grid
      for (int j = n; j < g.surface.ny - n; ++j)
        for (int i = n; i < g.surface.nx - n; ++i)
        {
          const auto slope = [&](int di, int dj, int dk, std::size_t c, double h) {
            return (stress.at(g.index(i + di, j + dj, k + dk))[c] - stress.at(g.index(i - di, j - dj, k - dk))[c]) /
                   (2.0 * h);
          };
          for (const auto& row : rows)
            largest = std::max(largest, std::abs(slope(1, 0, 0, row[0], g.surface.dx) +
                                                 slope(0, 1, 0, row[1], g.surface.dy) + slope(0, 0, 1, row[2], g.dz)));
        }
    errors.push_back(largest);
  }
  EXPECT_GT(test::Orders("divergence of the stress, cells halved", errors).last, 1.8);
}

TEST(EigenstrainSizeTest, SpectraThatGoPastTheCachesGiveTheSameStress)
{
  // Twice as many layers, of which the lower half holds no strain: the spectra are stored in another way. Periodic, so that
  // there are no images to be taken off: that correction interpolates over the depth of the grid.
  const SurfaceGrid surface{144, 144, 1.0, 1.0, Boundary::periodic, Boundary::periodic};
  const VolumeGrid shallow{surface, 20, 1.0};
  const VolumeGrid deep{surface, 40, 1.0};
  const std::size_t half = shallow.size();
  const std::vector<double> strain = test::random_field(Deviator::size * half, 1);
  std::vector<double> padded(2 * strain.size());
  for (std::size_t c = 0; c < Deviator::size; ++c)
    std::copy_n(strain.begin() + static_cast<std::ptrdiff_t>(c * half), half,
                padded.begin() + static_cast<std::ptrdiff_t>(2 * c * half));
  const std::vector<double> expected = residual_stress(HalfSpace(shallow, elastic), strain);
  const std::vector<double> stress = residual_stress(HalfSpace(deep, elastic), padded);
  for (std::size_t c = 0; c < Deviator::size; ++c)
    for (std::size_t i = 0; i < half; ++i)
      ASSERT_NEAR(stress[2 * c * half + i], expected[c * half + i], 1e-12) << "component " << c << ", cell " << i;
}

TEST_P(EigenstrainStressTest, LoadedStrainServesOneLoadAfterAnother)
{
  HalfSpace planned(GetParam(), elastic);
  const HalfSpace half_space = std::move(planned); // what is planned moves along
  const std::size_t surface = GetParam().surface.size();
  const std::vector<double> strain = test::random_field(Deviator::size * GetParam().size(), 7);
  const std::vector<double> pressure = test::random_field(surface, 8, 0.0, 1.0);
  const std::vector<double> zeros(surface, 0.0);
  HalfSpace::Work work = half_space.make_work();
  std::vector<double> first(strain.size()), again(first), none(first), zero(first), u(surface), u_again(surface);
  const HalfSpace::Loaded loaded = half_space.load(strain, GetParam().nz, work);
  loaded.stress({.pressure = pressure}, first);
  loaded.displacement({.z = u});
  loaded.stress({}, none);
  loaded.stress({.pressure = zeros}, zero);
  loaded.stress({.pressure = pressure}, again);
  loaded.displacement({.z = u_again});
  EXPECT_EQ(again, first);
  EXPECT_EQ(none, zero); // an empty part is zero
  EXPECT_NE(none, first);
  EXPECT_EQ(u_again, u);

  const HalfSpace::Loaded next = half_space.load(strain, GetParam().nz, work);
  EXPECT_THROW(loaded.stress({.pressure = pressure}, again), InternalError); // its buffers are used by the next one
  EXPECT_THROW(loaded.displacement({.z = u}), InternalError);
  next.stress({.pressure = pressure}, again);
  EXPECT_EQ(again, first);
}

TEST(HalfSpaceDoorTest, RefusesFieldsOfAnotherSize)
{
  using Field = std::vector<double>;
  const HalfSpace half_space(VolumeGrid{{4, 3, 1.0, 1.0}, 2, 1.0}, elastic);
  HalfSpace::Work work = half_space.make_work();
  Field surface(12), strain(120), stress(120), trace(24), displacement(12);
  // One cell too few and one component too many: each would be read or written past an end.
  Field short_surface(11), long_deviator(144), short_trace(23);

  test::expect_refused("HalfSpace::load: the plastic strain", 144, 120,
                       [&] { (void)half_space.load(long_deviator, 2, work); });
  EXPECT_THROW((void)half_space.load(strain, 3, work), InternalError); // of two layers
  HalfSpace::Work empty;
  EXPECT_THROW((void)half_space.load(strain, 2, empty), InternalError);

  const HalfSpace::Loaded loaded = half_space.load(strain, 2, work);
  test::expect_refused("HalfSpace::Loaded::displacement: the displacement", 11, 12,
                       [&] { loaded.displacement({.z = short_surface}); });
  EXPECT_THROW(loaded.displacement({.z = displacement, .x = displacement}), InternalError); // not prepared
  test::expect_refused("HalfSpace::Loaded::stress: the pressure", 11, 12,
                       [&] { loaded.stress({.pressure = short_surface}, stress); });
  test::expect_refused("HalfSpace::Loaded::stress: the stress", 144, 120,
                       [&] { loaded.stress({.pressure = surface}, long_deviator); });
  test::expect_refused("HalfSpace::Loaded::stress: the shear along y", 11, 12,
                       [&] { loaded.stress({.pressure = surface, .shear_y = short_surface}, stress); });
  EXPECT_THROW(loaded.stress({.heat = surface}, stress), InputError);

  const auto full = [&](const Field& p, const Field& e, Field& s, Field& t)
  { half_space.full_stress({.pressure = p}, e, work, s, t); };
  test::expect_refused("HalfSpace::full_stress: the pressure", 11, 12,
                       [&] { full(short_surface, strain, stress, trace); });
  test::expect_refused("HalfSpace::full_stress: the plastic strain", 144, 120,
                       [&] { full(surface, long_deviator, stress, trace); });
  test::expect_refused("HalfSpace::full_stress: the deviator", 144, 120,
                       [&] { full(surface, strain, long_deviator, trace); });
  test::expect_refused("HalfSpace::full_stress: the trace", 23, 24,
                       [&] { full(surface, strain, stress, short_trace); });
}

} // namespace
} // namespace brinell::halfspace::eigenstrain_stress_test
