// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/grid.hpp"

#include "foundation/sharing.hpp"
#include "random_field.hpp"

#include <gtest/gtest.h>

#include <omp.h>

namespace brinell::grid_test
{
namespace
{

TEST(GridTest, XRunsFastestAndLayersLast)
{
  const VolumeGrid grid{{3, 4, 0.5, 2.0}, 5, 1.0};
  std::size_t place = 0;
  for (int k = 0; k < 5; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 3; ++i, ++place)
        ASSERT_EQ(grid.index(i, j, k), place);
  EXPECT_EQ(grid.surface.index(2, 3), grid.surface.size() - 1);
  EXPECT_DOUBLE_EQ(grid.surface.x(0), -0.5);
  EXPECT_DOUBLE_EQ(grid.surface.x(1), 0.0);
  EXPECT_DOUBLE_EQ(grid.surface.y(3), 3.0);
}

TEST(GridTest, CellsAreCountedInMoreThan32Bits)
{
  const SurfaceGrid grid{100000, 100000, 1.0, 1.0};
  EXPECT_EQ(grid.index(99999, 99999), 9999999999U);
  EXPECT_EQ((VolumeGrid{grid, 2, 1.0}.index(0, 0, 1)), 10000000000U);
}

TEST(SharingTest, SumsAreTheSameForAnyNumberOfThreads)
{
  const std::vector<double> a = test::random_field(100003, 1);
  const std::vector<double> b = test::random_field(a.size(), 2);
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const double alone = sum(a);
  const double product = dot(a, b);
  for (const int several : {2, 3, 7})
  {
    omp_set_num_threads(several);
    EXPECT_EQ(sum(a), alone);
    EXPECT_EQ(dot(a, b), product);
  }
  omp_set_num_threads(threads);
  double plain = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    plain += a[i] * b[i];
  EXPECT_NEAR(product, plain, 1e-9);
  EXPECT_EQ(sum({}), 0.0);
}

} // namespace
} // namespace brinell::grid_test
