// SPDX-License-Identifier: BSD-3-Clause
// Inclusions::update against Inclusions::solve and add, by a matrix, in a box and in the whole body.
#include "brinell/foundation/symmetry.hpp"
#include "brinell/halfspace/inclusions.hpp"
#include "mirrored_grid.hpp"
#include "periodic_grids.hpp"
#include "random_field.hpp"
#include "volume_fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

namespace brinell::halfspace::inclusion_update_test
{
namespace
{

const Elastic body_material{1.0, 0.3};
constexpr double rigid = std::numeric_limits<double>::infinity();

/// Cells of a block [i0, i1) x [j0, j1) x [k0, k1).
std::vector<std::size_t> block(const VolumeGrid& g, int i0, int i1, int j0, int j1, int k0, int k1)
{
  std::vector<std::size_t> cells;
  for (int k = k0; k < k1; ++k)
    for (int j = j0; j < j1; ++j)
      for (int i = i0; i < i1; ++i)
        cells.push_back(g.index(i, j, k));
  return cells;
}

std::vector<double> random_pressure(const VolumeGrid& grid, unsigned seed)
{
  std::vector<double> pressure = test::random_field(grid.surface.size(), seed, 0.0, 1.0);
  if (grid.surface.is_mirrored_y)
    complete_in_y(grid.surface, 1.0, pressure.data(), pressure.size());
  return pressure;
}

struct Fields
{
  std::vector<double> deviator, trace, x, y, z;
  explicit Fields(const VolumeGrid& g)
      : deviator(Deviator::size * g.size()), trace(g.size()), x(g.surface.size()), y(x.size()), z(x.size())
  {
  }
  HalfSpace::Dilated to() { return {deviator, trace, {.z = z, .x = x, .y = y}}; }
};

double largest(const std::vector<double>& a)
{
  double most = 0.0;
  for (const double value : a)
    most = std::max(most, std::abs(value));
  return most;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b)
{
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    most = std::max(most, std::abs(a[i] - b[i]));
  return most / largest(b);
}

struct Way
{
  const char* name;
  VolumeGrid grid;
  std::vector<int> block; ///< first and end along x, y and z
  bool iterates;          ///< without a matrix
  int most_corrections;   ///< the box leaves some percent
};

std::vector<Way> ways()
{
  const VolumeGrid open{{24, 22, 1.0, 1.1}, 7, 0.8};
  return {{"open", open, {8, 12, 9, 13, 2, 6}, false, 2},
          {"over the surface", open, {8, 12, 9, 13, 0, 3}, false, 2},
          {"periodic", {periodic(24, 22, 1.0, 1.1), 7, 0.8}, {0, 4, 9, 13, 2, 6}, false, 2},
          {"periodic in y", {periodic_in_y(24, 22, 1.0, 1.1), 7, 0.8}, {8, 12, 18, 22, 2, 6}, false, 2},
          {"at the edge", open, {0, 4, 9, 13, 2, 6}, true, 7},
          {"mirrored", test::mirrored(open), {8, 12, 9, 13, 2, 6}, false, 2},
          {"mirrored, odd", test::mirrored({{24, 21, 1.0, 1.1}, 7, 0.8}), {8, 12, 8, 13, 2, 6}, false, 2},
          {"mirrored, many cells", test::mirrored({{34, 46, 1.0, 1.1}, 8, 0.8}), {10, 22, 12, 34, 1, 7}, true, 7},
          {"many cells", {{34, 32, 1.0, 1.1}, 8, 0.8}, {10, 21, 11, 22, 1, 7}, true, 7},
          {"filling the grid", {{12, 11, 1.0, 1.1}, 7, 0.8}, {0, 11, 1, 10, 0, 7}, true, 1}};
}

InclusionField stress_of(const HalfSpace& body, const Inclusions& inclusions, unsigned seed)
{
  const test::StressField load(body, random_pressure(body.grid(), seed), {});
  InclusionField given = inclusions.make_field();
  inclusions.gather(load.deviator, load.trace, given);
  return given;
}

class UpdateOfInclusions : public testing::TestWithParam<double>
{
};

// The tolerance is that of the equation, 1e-9 of the stress; fields follow it but for the strain within a void or the stress within a rigid inclusion,
// of which the fields notice little.
TEST_P(UpdateOfInclusions, GivesTheFieldsOfSolveAndAdd)
{
  constexpr double tolerance = 1e-9;
  for (const Way& way : ways())
  {
    SCOPED_TRACE(way.name);
    const HalfSpace body(way.grid, body_material);
    const auto& b = way.block;
    Inclusions inclusions(body, {{{GetParam(), 0.25}, block(way.grid, b[0], b[1], b[2], b[3], b[4], b[5])}});
    Inclusions::Solution solution = inclusions.make_solution();
    for (const unsigned seed : {1U, 2U}) // from nothing, and from another solution
    {
      const InclusionField given = stress_of(body, inclusions, seed);
      Fields found(way.grid), expected(way.grid);
      const Inclusions::Report report = inclusions.update(given, solution, tolerance, 400, way.grid.nz, found.to());
      std::printf("%-18s %3zu cells: %d corrections, %d iterations, residual %.1e\n", way.name,
                  inclusions.cells().size(), report.corrections, report.iterations, report.residual);
      EXPECT_LE(report.residual, tolerance);
      EXPECT_LE(report.corrections, way.most_corrections);
      EXPECT_EQ(report.iterations > 0, way.iterates);
      InclusionField equivalent = inclusions.make_field();
      (void)inclusions.solve(given, equivalent, 1e-11, 2000);
      inclusions.add(equivalent, way.grid.nz, expected.to());
      EXPECT_LT(largest_difference(found.deviator, expected.deviator), 1e-6);
      EXPECT_LT(largest_difference(found.trace, expected.trace), 1e-6);
      EXPECT_LT(largest_difference(found.z, expected.z), 1e-7);
      EXPECT_LT(largest_difference(found.x, expected.x), 1e-7);
      EXPECT_LT(largest_difference(found.y, expected.y), 1e-7);
      // The stress that is kept with the strain is that of the body, whatever the correction took.
      InclusionField caused = inclusions.make_field();
      inclusions.stress(solution.equivalent, caused);
      EXPECT_LT(largest_difference(solution.caused.deviator, caused.deviator), 1e-10);
      EXPECT_LT(largest_difference(solution.caused.volumetric, caused.volumetric), 1e-10);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Contrasts, UpdateOfInclusions, testing::Values(0.0, 0.3, 5.0, rigid),
                         [](const auto& p)
                         {
                           return p.param == 0.0    ? std::string("void")
                                  : p.param < 1.0   ? std::string("soft")
                                  : p.param < rigid ? std::string("stiff")
                                                    : std::string("rigid");
                         });

// At the limit of the matrix both ways are open; here it is one cell beyond.
TEST(UpdateOfInclusions, TakesNoMatrixBeyondItsLimit)
{
  const VolumeGrid grid{{40, 16, 1.0, 1.0}, 12, 1.0};
  const HalfSpace body(grid, body_material);
  const std::vector<std::size_t> all = block(grid, 1, 39, 1, 15, 1, 12);
  for (const std::size_t count : {Inclusions::most_of_matrix / 6, Inclusions::most_of_matrix / 6 + 1})
  {
    Inclusions inclusions(body, {{{0.9, 0.3}, {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)}}});
    Inclusions::Solution solution = inclusions.make_solution();
    const Inclusions::Report report =
        inclusions.update(stress_of(body, inclusions, 3), solution, 1e-6, 400, grid.nz, {});
    EXPECT_EQ(report.iterations > 0, 6 * count > Inclusions::most_of_matrix) << count;
    EXPECT_LE(report.residual, 1e-6);
  }
}

TEST(UpdateOfInclusions, OfNoStressIsNothing)
{
  const VolumeGrid grid{{12, 11, 1.0, 1.0}, 5, 1.0};
  const HalfSpace body(grid, body_material);
  Inclusions inclusions(body, {{{0.0, 0.3}, block(grid, 4, 7, 4, 7, 1, 4)}});
  Inclusions::Solution solution = inclusions.make_solution();
  (void)inclusions.update(stress_of(body, inclusions, 1), solution, 1e-6, 400, grid.nz, {});
  EXPECT_GT(largest(solution.equivalent.deviator), 0.0);
  Fields fields(grid);
  EXPECT_EQ(inclusions.update(inclusions.make_field(), solution, 1e-6, 400, grid.nz, fields.to()).residual, 0.0);
  EXPECT_EQ(largest(solution.equivalent.deviator) + largest(solution.caused.deviator) + largest(fields.deviator), 0.0);
}

} // namespace
} // namespace brinell::halfspace::inclusion_update_test
