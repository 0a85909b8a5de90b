// SPDX-License-Identifier: BSD-3-Clause
#include "foundation/blocked_fft.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/foundation/symmetry.hpp"
#include "foundation/fft.hpp"
#include "mirrored_grid.hpp"
#include "random_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace brinell::blocked_fft_test
{
namespace
{

constexpr int planes = 13;
constexpr double rounding = 1e-14;

class BlockedFftTest : public testing::TestWithParam<SurfaceGrid>
{
protected:
  SurfaceGrid grid = GetParam();
  PaddedFft plain{grid};
  BlockedFft blocked{grid, plain.px(), plain.py(), planes};
  BlockedFft::Scratch scratch = blocked.make_scratch();
  AlignedVector<ComplexLanes> rows = AlignedVector<ComplexLanes>(blocked.rows_size());
  std::vector<std::vector<double>> fields;

  [[nodiscard]] AlignedVector<ComplexLanes> spectrum_of(int block)
  {
    AlignedVector<ComplexLanes> spectrum(blocked.block_size());
    for (int plane = 0; plane < planes; ++plane)
      blocked.columns_forward(rows.data(), block, plane, spectrum.data() + blocked.plane_at(0, plane), scratch);
    return spectrum;
  }

  void SetUp() override
  {
    for (int plane = 0; plane < planes; ++plane)
    {
      fields.push_back(test::random_field(grid.size(), static_cast<unsigned>(plane + 1)));
      blocked.rows_forward(fields.back().data(), plane, rows.data(), scratch);
    }
  }
};

constexpr Boundary periodic = Boundary::periodic;

// One lane, a full block, one more than a block, several blocks; rows one by one, as real parts alone, as imaginary parts too, in
// several batches; transforms of odd length, and of a prime one.
INSTANTIATE_TEST_SUITE_P(Grids, BlockedFftTest,
                         testing::Values(SurfaceGrid{1, 1, 1.0, 1.0}, SurfaceGrid{7, 5, 1.0, 1.0},
                                         SurfaceGrid{8, 3, 1.0, 2.0}, SurfaceGrid{12, 7, 1.0, 1.0},
                                         SurfaceGrid{23, 14, 0.1, 0.3}, SurfaceGrid{31, 41, 1.0, 1.0},
                                         SurfaceGrid{250, 19, 1.0, 1.0},
                                         SurfaceGrid{21, 15, 1.0, 1.0, periodic, periodic},
                                         SurfaceGrid{37, 29, 1.0, 1.0, periodic, periodic}),
                         [](const auto& p) { return std::to_string(p.param.nx) + "x" + std::to_string(p.param.ny); });

TEST_P(BlockedFftTest, SpectrumIsThatOfEveryPlaneByItself)
{
  for (int block = 0; block < blocked.blocks(); ++block)
  {
    const AlignedVector<ComplexLanes> spectrum = spectrum_of(block);
    for (int plane = 0; plane < planes; ++plane)
    {
      const AlignedVector<Complex> expected = plain.forward(fields[static_cast<std::size_t>(plane)]);
      for (int row = 0; row < blocked.py(); ++row)
        for (int lane = 0; lane < lane_count; ++lane)
        {
          const int i = block * lane_count + lane;
          const ComplexLanes& lanes = spectrum[static_cast<std::size_t>(blocked.plane_at(0, plane) + row)];
          const Complex value(lanes.re[lane], lanes.im[lane]);
          const Complex exact = i < plain.kx() ? expected[static_cast<std::size_t>(row * plain.kx() + i)] : 0.0;
          EXPECT_NEAR(std::abs(value - exact), 0.0, rounding * static_cast<double>(grid.size()));
        }
    }
  }
}

TEST_P(BlockedFftTest, ThereAndBackIsTheField)
{
  for (int block = 0; block < blocked.blocks(); ++block)
  {
    const AlignedVector<ComplexLanes> spectrum = spectrum_of(block);
    for (int plane = 0; plane < planes; ++plane)
      blocked.columns_inverse(spectrum.data() + blocked.plane_at(0, plane), block, plane, rows.data(), scratch);
  }
  for (int plane = 0; plane < planes; ++plane)
  {
    std::vector<double> field(grid.size());
    blocked.rows_inverse(rows.data(), plane, field.data(), scratch);
    for (std::size_t i = 0; i < field.size(); ++i)
      EXPECT_NEAR(field[i], fields[static_cast<std::size_t>(plane)][i], rounding);
  }
}

/// One side of an even and of an odd field; what is not to be read is no number.
TEST_P(BlockedFftTest, OneSideOfAMirroredGridTellsBoth)
{
  const SurfaceGrid half = test::mirrored(grid);
  const BlockedFft fft(half, plain.px(), plain.py(), 2);
  BlockedFft::Scratch own = fft.make_scratch();
  AlignedVector<ComplexLanes> of_half(fft.rows_size()), column(static_cast<std::size_t>(blocked.py()));
  for (int plane = 0; plane < 2; ++plane)
  {
    std::vector<double>& field = fields[static_cast<std::size_t>(plane)];
    if (plane == 1 && grid.ny % 2 == 1)
      std::fill_n(field.begin() + static_cast<std::ptrdiff_t>(grid.index(0, grid.ny / 2)), grid.nx, 0.0);
    complete_in_y(grid, plane == 0 ? 1.0 : -1.0, field.data(), field.size());
    blocked.rows_forward(field.data(), plane, rows.data(), scratch);
    std::vector<double> one_side(field.begin(), field.begin() + static_cast<std::ptrdiff_t>(half.independent_cells()));
    fft.rows_forward(one_side.data(), plane, of_half.data(), own);
    for (int block = 0; block < fft.blocks(); ++block)
    {
      blocked.columns_forward(rows.data(), block, plane, column.data(), scratch);
      fft.columns_forward(of_half.data(), block, plane, own.column.data(), own, plane == 1);
      for (int row = 0; row < fft.waves_along_y(); ++row)
        for (int lane = 0; lane < lane_count; ++lane)
        {
          const ComplexLanes &a = own.column[static_cast<std::size_t>(row)], &b = column[static_cast<std::size_t>(row)];
          EXPECT_NEAR(a.re[lane], b.re[lane], rounding * static_cast<double>(grid.size()));
          EXPECT_NEAR(a.im[lane], b.im[lane], rounding * static_cast<double>(grid.size()));
        }
      fft.columns_inverse(own.column.data(), block, plane, of_half.data(), own, plane == 1);
    }
    fft.rows_inverse(of_half.data(), plane, one_side.data(), own);
    for (std::size_t i = 0; i < one_side.size(); ++i)
      EXPECT_NEAR(one_side[i], field[i], rounding) << plane;
  }
}

TEST(BlockedFftSizeTest, RowsThatGoPastTheCachesComeBackAsWell)
{
  const SurfaceGrid grid{96, 70, 1.0, 1.0};
  const int many = 320;
  const BlockedFft fft(grid, 192, 140, many);
  ASSERT_GT(fft.rows_size() * sizeof(ComplexLanes), cached_bytes);
  BlockedFft::Scratch scratch = fft.make_scratch();
  AlignedVector<ComplexLanes> rows(fft.rows_size());
  const std::vector<double> fields = test::random_field(grid.size() * many, 1);
  for (int plane = 0; plane < many; ++plane)
    fft.rows_forward(fields.data() + plane * static_cast<std::ptrdiff_t>(grid.size()), plane, rows.data(), scratch);
  for (int block = 0; block < fft.blocks(); ++block)
    for (int plane = 0; plane < many; ++plane)
    {
      fft.columns_forward(rows.data(), block, plane, scratch.column.data(), scratch);
      fft.columns_inverse(scratch.column.data(), block, plane, rows.data(), scratch);
    }
  double largest = 0.0;
  std::vector<double> back(grid.size());
  for (int plane = 0; plane < many; ++plane)
  {
    fft.rows_inverse(rows.data(), plane, back.data(), scratch);
    for (std::size_t i = 0; i < back.size(); ++i)
      largest = std::max(largest, std::abs(back[i] - fields[static_cast<std::size_t>(plane) * grid.size() + i]));
  }
  EXPECT_LT(largest, rounding);
}

TEST(BlockedFftDoorTest, RefusesLengthsThatDoNotFit)
{
  const SurfaceGrid grid{4, 4, 1.0, 1.0};
  EXPECT_THROW(BlockedFft(grid, 3, 8, 1), InternalError);
  EXPECT_THROW(BlockedFft(grid, 8, 2, 1), InternalError);
  EXPECT_THROW(BlockedFft(grid, 8, 8, 0), InternalError);
}

} // namespace
} // namespace brinell::blocked_fft_test
