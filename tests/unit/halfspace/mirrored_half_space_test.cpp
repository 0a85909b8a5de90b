// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "brinell/foundation/symmetry.hpp"
#include "brinell/halfspace/half_space.hpp"
#include "grid_fields.hpp"
#include "mirrored_grid.hpp"
#include "periodic_grids.hpp"
#include "random_field.hpp"
#include "volume_fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

/// An evaluation that is told of the symmetry in y against one that is not: docs/theory/half-space.md (symmetry).
namespace brinell::halfspace::mirrored_half_space_test
{
namespace
{

using test::largest;
using Field = std::vector<double>;
using test::largest_difference;

const Elastic elastic{1.3, 0.28};

/// Random in the independent rows, mirrored in the others; an odd field is zero on the plane y = 0.
Field mirrored_field(const VolumeGrid& grid, unsigned seed, bool is_odd)
{
  const SurfaceGrid& s = grid.surface;
  Field field = test::random_field(grid.size(), seed);
  for (int k = 0; k < grid.nz; ++k)
    for (int i = 0; is_odd && s.ny % 2 == 1 && i < s.nx; ++i)
      field[grid.index(i, s.ny / 2, k)] = 0.0;
  complete_in_y(s, is_odd ? -1.0 : 1.0, field.data(), field.size());
  return field;
}

Field mirrored_strain(const VolumeGrid& grid, int layers)
{
  Field strain;
  for (int c = 0; c < Deviator::size; ++c)
  {
    Field component = mirrored_field(grid, 10U + static_cast<unsigned>(c), is_odd_in_y(c));
    for (std::size_t i = grid.surface.size() * static_cast<std::size_t>(layers); i < component.size(); ++i)
      component[i] = 0.0;
    strain.insert(strain.end(), component.begin(), component.end());
  }
  return strain;
}

/// The independent rows stay, the others become `value`.
Field without_other_rows(const VolumeGrid& grid, Field field, double value)
{
  const SurfaceGrid& s = grid.surface;
  for (std::size_t cell = 0; cell < field.size(); ++cell)
    if (static_cast<int>(cell / static_cast<std::size_t>(s.nx)) % s.ny >= test::mirrored(s).independent_rows())
      field[cell] = value;
  return field;
}

struct Answer
{
  Field stress, z, x, y;
  Field trace{}; ///< in all prepared layers
};

Answer answer(const HalfSpace& half_space, const Field& strain, const SurfaceLoad& load, int layers)
{
  const VolumeGrid& grid = half_space.grid();
  HalfSpace::Work work = half_space.make_work();
  const std::size_t cells = grid.surface.size();
  Answer result{Field(Deviator::size * grid.size()), Field(cells), Field(cells), Field(cells)};
  for (int turn = 0; turn < 2; ++turn) // the second time the buffers are not new
  {
    const HalfSpace::Loaded loaded = half_space.load(strain, layers, work, Displacements::all, true);
    loaded.displacement({.z = result.z, .x = result.x, .y = result.y});
    loaded.stress(load, result.stress);
    result.trace.resize(grid.size());
    for (int layer = 0; layer < layers; ++layer)
      loaded.trace(load, layer, std::span(result.trace).subspan(grid.index(0, 0, layer), cells));
  }
  if (grid.surface.is_mirrored_y)
  {
    result.stress = without_other_rows(grid, result.stress, 0.0);
    complete_in_y(grid, result.stress);
    result.trace = without_other_rows(grid, result.trace, 0.0);
    complete_in_y(grid.surface, 1.0, result.trace.data(), result.trace.size());
  }
  return result;
}

class MirroredHalfSpaceTest : public testing::TestWithParam<VolumeGrid>
{
};

INSTANTIATE_TEST_SUITE_P(
    Grids, MirroredHalfSpaceTest,
    testing::Values(VolumeGrid{{33, 13, 0.5, 1.0}, 7, 0.25}, VolumeGrid{{20, 12, 0.7, 0.9}, 6, 0.4},
                    VolumeGrid{{9, 40, 0.7, 0.9}, 4, 0.4}, // long in y
                    VolumeGrid{{60, 7, 0.7, 0.9}, 3, 0.4}, // long in x
                    VolumeGrid{{5, 1, 0.7, 0.9}, 3, 0.4}, VolumeGrid{{4, 2, 0.7, 0.9}, 1, 0.4},
                    VolumeGrid{periodic(17, 11, 0.7, 0.9), 4, 0.6}, VolumeGrid{periodic(16, 10, 0.7, 0.9), 5, 0.6},
                    VolumeGrid{periodic(8, 8, 1.0, 1.0), 4, 0.5}, VolumeGrid{periodic_in_y(12, 9, 0.7, 0.9), 4, 0.6},
                    VolumeGrid{periodic_in_y(12, 34, 0.7, 0.9), 4, 0.6}, // 2 * 17: no fast length along y
                    VolumeGrid{{12, 9, 0.7, 0.9, Boundary::periodic, Boundary::open}, 4, 0.6}));

TEST_P(MirroredHalfSpaceTest, AnswersAsWithoutSymmetry)
{
  const VolumeGrid& grid = GetParam();
  const HalfSpace half_space(grid, elastic), one_side(test::mirrored(grid), elastic);
  const VolumeGrid surface{grid.surface, 1, grid.dz};
  const Field pressure = mirrored_field(surface, 1, false);
  const Field shear_x = mirrored_field(surface, 2, false);
  const Field shear_y = mirrored_field(surface, 3, true);
  const SurfaceLoad load{.pressure = pressure, .shear_x = shear_x, .shear_y = shear_y};
  for (const int strained : {0, grid.nz / 2, grid.nz})
    for (const int layers : {grid.nz, (grid.nz + 1) / 2})
    {
      const Field strain = mirrored_strain(grid, strained);
      const Answer full = answer(half_space, strain, load, layers);
      // What is not to be read is no number.
      const Field half_strain = without_other_rows(grid, strain, std::numeric_limits<double>::quiet_NaN());
      const Answer half = answer(one_side, half_strain, load, layers);
      // Rounding of transforms of this length, over numbers of order one, and no more.
      constexpr double rounding = 1e-13;
      EXPECT_LE(largest_difference(full.stress, half.stress), rounding * largest(full.stress));
      EXPECT_LE(largest_difference(full.z, half.z), rounding * largest(full.z));
      EXPECT_LE(largest_difference(full.x, half.x), rounding * largest(full.x));
      EXPECT_LE(largest_difference(full.y, half.y), rounding * largest(full.y));
      EXPECT_LE(largest_difference(full.trace, half.trace), rounding * std::max(largest(full.stress), 1.0));
    }
}

/// Layer by layer, against the stress of the whole body.
TEST_P(MirroredHalfSpaceTest, OneLayerIsThatOfTheWholeStress)
{
  const VolumeGrid& grid = GetParam();
  const HalfSpace half_space(grid, elastic);
  const std::size_t cells = grid.surface.size();
  const Field pressure = test::random_field(cells, 4), shear = test::random_field(cells, 5);
  const Field strain = test::random_field(Deviator::size * grid.size(), 6);
  const SurfaceLoad load{.pressure = pressure, .shear_x = shear};
  const test::StressField whole = test::StressField::of(half_space, load, strain);
  EXPECT_EQ(answer(half_space, strain, load, grid.nz).trace, whole.trace);
  const test::StressField of_load = test::StressField::of(half_space, load);
  HalfSpace::Work work = half_space.make_guest();
  Field layer((Deviator::size + 1) * cells);
  half_space.stress_of_load(load, grid.nz - 1, work, layer);
  const std::size_t first = grid.index(0, 0, grid.nz - 1);
  const double rounding = 1e-13 * largest(of_load.deviator); // the images of no strain are subtracted there
  for (std::size_t cell = 0; cell < cells; ++cell)
  {
    for (std::size_t c = 0; c < Deviator::size; ++c)
      ASSERT_NEAR(layer[c * cells + cell], of_load.deviator[c * grid.size() + first + cell], rounding);
    ASSERT_NEAR(layer[Deviator::size * cells + cell], of_load.trace[first + cell], rounding);
  }
}

TEST(HalfSpaceOneLayer, IsRefusedWhereItWasNotAskedFor)
{
  const VolumeGrid grid{{9, 6, 0.7, 0.9}, 3, 0.4};
  const HalfSpace half_space(grid, elastic);
  HalfSpace::Work work = half_space.make_work();
  const Field strain(Deviator::size * grid.size());
  Field stress(strain.size()), trace(grid.surface.size());
  const HalfSpace::Loaded without = half_space.load(strain, 3, work);
  without.stress({}, stress);
  EXPECT_THROW(without.trace({}, 0, trace), InternalError);
  const HalfSpace::Loaded loaded = half_space.load(strain, 2, work, Displacements::normal, true);
  loaded.stress({}, stress);
  loaded.trace({}, 1, trace);
  EXPECT_THROW(loaded.trace({}, 2, trace), InternalError);
}

TEST(MirroredHalfSpace, AsymmetricStrainIsNotTakenForItsHalf)
{
  const VolumeGrid grid{{9, 6, 0.7, 0.9}, 3, 0.4};
  const HalfSpace half_space(grid, elastic);
  const Field strain = test::random_field(Deviator::size * grid.size(), 5);
  const Answer full = answer(half_space, strain, {}, grid.nz);
  const Answer half = answer(HalfSpace(test::mirrored(grid), elastic), strain, {}, grid.nz);
  EXPECT_GT(largest_difference(full.stress, half.stress), 0.1 * largest(full.stress));
}

} // namespace
} // namespace brinell::halfspace::mirrored_half_space_test
