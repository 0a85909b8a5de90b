// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/half_space.hpp"
#include "grid_fields.hpp"
#include "periodic_grids.hpp"
#include "random_field.hpp"
#include "volume_fields.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

/// What holds of all operators on any pair of boundaries.
namespace brinell::halfspace::boundary_pair_test
{
namespace
{

using test::largest;
using test::sampled;
using test::StressField;

constexpr double modulus = 1.7; // E'
const Elastic elastic{1.3, 0.28};

SurfaceGrid swapped(const SurfaceGrid& g)
{
  return {g.ny, g.nx, g.dy, g.dx, g.boundary_y, g.boundary_x};
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

} // namespace
} // namespace brinell::halfspace::boundary_pair_test
