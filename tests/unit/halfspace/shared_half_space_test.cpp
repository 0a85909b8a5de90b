// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/half_space.hpp"

#include "brinell/foundation/deviator.hpp"
#include "brinell/foundation/symmetry.hpp"
#include "halfspace/strain/half_space_memory.hpp"
#include "random_field.hpp"
#include "ranks_as_threads.hpp"

#include <gtest/gtest.h>
#include <omp.h>

/// A half space that several ranks share has the digits of one that one process has.
namespace brinell::halfspace
{
namespace
{

constexpr Elastic steel{.young_modulus = 210e9, .poisson_ratio = 0.3};
const ElasticStack coated{{{1.4e-6, {400e9, 0.2}}, {0.7e-6, {70e9, 0.35}}}, steel};

/// What is computed for a strain and a load.
struct Result
{
  std::array<std::vector<double>, 3> displacement;
  std::vector<double> stress, again, deviator, trace;
  bool operator==(const Result&) const = default;
};

struct Given
{
  VolumeGrid grid;
  int layers; ///< whose stress is computed
  std::vector<double> strain, pressure, shear_x, shear_y;
};

Given given(const SurfaceGrid& surface, int nz, int layers, int strained)
{
  const VolumeGrid grid{surface, nz, 0.7e-6};
  Given g{grid,
          layers,
          test::random_field(Deviator::size * grid.size(), 1),
          test::random_field(surface.size(), 2),
          test::random_field(surface.size(), 3),
          test::random_field(surface.size(), 4)};
  for (std::size_t i = 0; i < g.strain.size(); ++i)
    if (static_cast<int>(i % grid.size() / surface.size()) >= strained)
      g.strain[i] = 0.0;
  if (!surface.is_mirrored_y)
    return g;
  const auto complete = [&](std::vector<double>& field, double sign)
  { complete_in_y(surface, sign, field.data(), field.size()); };
  complete(g.pressure, 1.0);
  complete(g.shear_x, 1.0);
  complete(g.shear_y, -1.0);
  return g;
}

/// The layers of a rank of fields [component][layer][cell].
std::vector<double> part_of(const std::vector<double>& whole, const VolumeGrid& grid, const Share& share)
{
  std::vector<double> part;
  for (std::size_t field = 0; field < whole.size() / grid.size(); ++field)
    for (int own = 0; own < share.count(grid.nz); ++own)
    {
      const auto first =
          whole.begin() + static_cast<std::ptrdiff_t>(field * grid.size() + grid.index(0, 0, share.layer(own)));
      part.insert(part.end(), first, first + static_cast<std::ptrdiff_t>(grid.surface.size()));
    }
  return part;
}

/// Components of the stress in the layers that are computed, in the independent rows.
std::vector<double> computed(const std::vector<double>& field, const VolumeGrid& own, int layers)
{
  std::vector<double> values;
  for (std::size_t c = 0; c < field.size() / std::max<std::size_t>(own.size(), 1); ++c)
    for (int k = 0; k < layers; ++k)
    {
      const auto first = field.begin() + static_cast<std::ptrdiff_t>(c * own.size() + own.index(0, 0, k));
      values.insert(values.end(), first, first + static_cast<std::ptrdiff_t>(own.surface.independent_cells()));
    }
  return values;
}

Result result_of(const Given& g, const HalfSpace& body)
{
  const VolumeGrid own = body.own_grid();
  const std::vector<double> strain = part_of(g.strain, g.grid, body.share());
  const std::size_t cells = g.grid.surface.size();
  const int layers = body.share().count(g.layers);
  Result r;
  for (std::vector<double>& field : r.displacement)
    field.resize(cells);
  r.stress.resize(strain.size());
  r.deviator.resize(strain.size());
  r.trace.resize(own.size());
  HalfSpace::Work work = body.make_work();
  const auto loaded = body.load(strain, g.layers, work, Displacements::all);
  loaded.displacement({.z = r.displacement[0], .x = r.displacement[1], .y = r.displacement[2]});
  loaded.stress({.pressure = g.pressure, .shear_x = {}, .shear_y = {}}, r.stress);
  r.again = r.stress;
  r.stress = computed(r.stress, own, layers);
  loaded.stress({.pressure = g.pressure, .shear_x = g.shear_x, .shear_y = g.shear_y}, r.again);
  r.again = computed(r.again, own, layers);
  body.full_stress({.pressure = g.pressure, .shear_x = {}, .shear_y = g.shear_y}, strain, work, r.deviator, r.trace);
  return r;
}

void expect_alike(const Given& g, int ranks, const ElasticStack& stack = {{}, steel})
{
  const HalfSpace alone(g.grid, stack);
  const Result whole = result_of(g, alone);
  VolumeGrid computed_grid = g.grid;
  computed_grid.surface.ny = g.grid.surface.independent_rows();
  computed_grid.surface.is_mirrored_y = false;
  computed_grid.nz = g.layers;
  test::RanksAsThreads::run(ranks,
                            [&](const std::shared_ptr<const Communicator>& rank)
                            {
                              omp_set_num_threads(rank->rank() == 1 ? 2 : 1);
                              const HalfSpace shared(g.grid, stack, rank);
                              const Share& share = shared.share();
                              const Result own = result_of(g, shared);
                              EXPECT_EQ(own.displacement, whole.displacement);
                              EXPECT_EQ(own.stress, part_of(whole.stress, computed_grid, share));
                              EXPECT_EQ(own.again, part_of(whole.again, computed_grid, share));
                              EXPECT_EQ(own.deviator, part_of(whole.deviator, g.grid, share));
                              EXPECT_EQ(own.trace, part_of(whole.trace, g.grid, share));
                            });
}

constexpr SurfaceGrid open{.nx = 24, .ny = 20, .dx = 1e-6, .dy = 1.2e-6};

SurfaceGrid with(SurfaceGrid grid, Boundary x, Boundary y, bool mirrored = false)
{
  grid.boundary_x = x;
  grid.boundary_y = y;
  grid.is_mirrored_y = mirrored;
  return grid;
}

TEST(SharedHalfSpace, HasTheDigitsOfOneThatIsNotShared)
{
  for (const int ranks : {2, 3})
  {
    expect_alike(given(open, 9, 6, 7), ranks);
    expect_alike(given(open, 6, 6, 0), ranks);
  }
}

TEST(SharedHalfSpace, PeriodicHasTheDigitsOfOneThatIsNotShared)
{
  expect_alike(given(with(open, Boundary::periodic, Boundary::periodic), 7, 7, 6), 3);
  expect_alike(given(with(open, Boundary::open, Boundary::periodic), 5, 4, 5), 2);
}

TEST(SharedHalfSpace, MirroredHasTheDigitsOfOneThatIsNotShared)
{
  SurfaceGrid odd = with(open, Boundary::open, Boundary::open, true);
  expect_alike(given(odd, 9, 7, 8), 3);
  odd.ny = 21;
  expect_alike(given(odd, 10, 9, 5), 2);
  expect_alike(given(with(open, Boundary::periodic, Boundary::periodic, true), 7, 7, 6), 2);
}

/// A rank tabulates the interfaces for its own blocks of wavenumbers alone.
TEST(SharedHalfSpace, LayersHaveTheDigitsOfABodyThatIsNotShared)
{
  expect_alike(given(open, 9, 6, 7), 3, coated);
  expect_alike(given(with(open, Boundary::periodic, Boundary::periodic), 7, 7, 6), 2, coated);
  expect_alike(given(with(open, Boundary::open, Boundary::periodic), 5, 4, 5), 2, coated);
  expect_alike(given(with(open, Boundary::open, Boundary::open, true), 9, 7, 8), 3, coated);
}

/// A long grid also has images beside it, in waves.
TEST(SharedHalfSpace, LongHasTheDigitsOfOneThatIsNotShared)
{
  SurfaceGrid grid = open;
  grid.nx = 96;
  grid.ny = 12;
  expect_alike(given(grid, 6, 5, 6), 2);
  std::swap(grid.nx, grid.ny);
  expect_alike(given(grid, 6, 5, 6), 2);
}

/// Layers of many cells are passed in several parts, the last of which has fewer layers.
TEST(SharedHalfSpace, PartsOfTheLayersHaveTheDigitsOfOneThatIsNotShared)
{
  constexpr int ranks = 2, threads = 2;
  const SurfaceGrid wide{.nx = 128, .ny = 128, .dx = 1e-6, .dy = 1.2e-6};
  for (const bool mirrored : {false, true})
  {
    const SurfaceGrid grid = with(wide, Boundary::open, Boundary::open, mirrored);
    const int nz = mirrored ? 19 : 11;
    ASSERT_LT(layers_at_a_time(grid, ranks, threads), nz - 2);
    expect_alike(given(grid, nz, nz - 1, nz), ranks);
  }
}

TEST(SharedHalfSpace, MoreRanksThanPairsOfLayers)
{
  expect_alike(given(open, 3, 3, 2), 4);
}

/// The last rank has layers, but no wavenumbers: it knows of the images of the trace nevertheless.
TEST(SharedHalfSpace, MoreRanksThanBlocksOfWavenumbers)
{
  SurfaceGrid narrow = open;
  narrow.nx = 4;
  expect_alike(given(narrow, 6, 6, 6), 3);
}

/// Per cell and evaluation of an open body: five components of the strain and of the stress as rows of spectra with twice as many
/// columns, 16 bytes a wavenumber, of which the part (ranks - 1)/ranks leaves its rank.
TEST(SharedHalfSpace, PassesWhatWasComputed)
{
  const SurfaceGrid grid{.nx = 60, .ny = 32, .dx = 1e-6, .dy = 1e-6};
  const Given g = given(grid, 8, 8, 8);
  const long numbers = test::RanksAsThreads::run(
      2,
      [&](const std::shared_ptr<const Communicator>& rank)
      {
        omp_set_num_threads(1);
        const HalfSpace shared(g.grid, steel, rank);
        HalfSpace::Work work = shared.make_work();
        const std::vector<double> strain = part_of(g.strain, g.grid, shared.share());
        std::vector<double> stress(strain.size());
        shared.load(strain, 8, work).stress({.pressure = g.pressure, .shear_x = {}, .shear_y = {}}, stress);
      });
  const double per_cell = 8.0 * static_cast<double>(numbers) / static_cast<double>(g.grid.size());
  EXPECT_NEAR(per_cell, 160.0 * 0.5, 0.1 * 160.0 * 0.5);
}

} // namespace
} // namespace brinell::halfspace
