// SPDX-License-Identifier: BSD-3-Clause
#include "foundation/blocked_fft.hpp"

#include "brinell/foundation/error.hpp"
#include "foundation/fft.hpp"
#include "random_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace brinell
{
namespace
{

constexpr int planes = 13; ///< a group of them, and a part of the next
constexpr double rounding = 1e-14;

class BlockedFftTest : public testing::TestWithParam<SurfaceGrid>
{
protected:
  SurfaceGrid grid = GetParam();
  PaddedFft plain{grid};
  BlockedFft blocked{grid, plain.px(), plain.py(), planes};
  BlockedFft::Scratch scratch = blocked.make_scratch();
  AlignedVector<Complex> rows = AlignedVector<Complex>(blocked.rows_size());
  std::vector<std::vector<double>> fields;

  void transform_columns(int block, Complex* spectrum)
  {
    for (int group = 0; group < BlockedFft::groups(planes); ++group)
    {
      blocked.columns_forward(rows.data(), block, group, planes, scratch);
      blocked.scatter(scratch, group, planes, spectrum);
    }
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

// One lane, a full block, one more than a block, several blocks, several batches of rows.
INSTANTIATE_TEST_SUITE_P(Grids, BlockedFftTest,
                         testing::Values(SurfaceGrid{1, 1, 1.0, 1.0}, SurfaceGrid{7, 5, 1.0, 1.0},
                                         SurfaceGrid{8, 3, 1.0, 2.0}, SurfaceGrid{23, 14, 0.1, 0.3},
                                         SurfaceGrid{250, 19, 1.0, 1.0}),
                         [](const auto& p) { return std::to_string(p.param.nx) + "x" + std::to_string(p.param.ny); });

TEST_P(BlockedFftTest, SpectrumIsThatOfEveryPlaneByItself)
{
  AlignedVector<Complex> expected(plain.plane());
  AlignedVector<double> real(plain.scratch_size());
  for (int block = 0; block < blocked.blocks(); ++block)
  {
    AlignedVector<Complex> spectrum(blocked.block_size());
    transform_columns(block, spectrum.data());
    for (int plane = 0; plane < planes; ++plane)
    {
      plain.forward(fields[static_cast<std::size_t>(plane)].data(), expected.data(), real);
      for (int row = 0; row < blocked.py(); ++row)
        for (int lane = 0; lane < lane_count; ++lane)
        {
          const int i = block * lane_count + lane;
          const Complex value = spectrum[static_cast<std::size_t>((row * blocked.pitch() + plane) * lane_count + lane)];
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
    AlignedVector<Complex> spectrum(blocked.block_size());
    transform_columns(block, spectrum.data());
    for (int group = 0; group < BlockedFft::groups(planes); ++group)
    {
      blocked.gather(spectrum.data(), group, planes, scratch);
      blocked.columns_inverse(scratch, block, group, planes, rows.data());
    }
  }
  for (int plane = 0; plane < planes; ++plane)
  {
    std::vector<double> field(grid.size());
    blocked.rows_inverse(rows.data(), plane, field.data(), scratch);
    for (std::size_t i = 0; i < field.size(); ++i)
      EXPECT_NEAR(field[i], fields[static_cast<std::size_t>(plane)][i], rounding);
  }
}

TEST(BlockedFftSizeTest, RowsThatGoPastTheCachesComeBackAsWell)
{
  const SurfaceGrid grid{96, 70, 1.0, 1.0};
  const int many = 320;
  const BlockedFft fft(grid, 192, 140, many);
  ASSERT_GT(fft.rows_size() * sizeof(Complex), cached_bytes);
  BlockedFft::Scratch scratch = fft.make_scratch();
  AlignedVector<Complex> rows(fft.rows_size());
  AlignedVector<Complex> spectrum(fft.block_size());
  const std::vector<double> fields = test::random_field(grid.size() * many, 1);
  for (int plane = 0; plane < many; ++plane)
    fft.rows_forward(fields.data() + plane * static_cast<std::ptrdiff_t>(grid.size()), plane, rows.data(), scratch);
  for (int block = 0; block < fft.blocks(); ++block)
    for (int group = 0; group < BlockedFft::groups(many); ++group)
    {
      fft.columns_forward(rows.data(), block, group, many, scratch);
      fft.scatter(scratch, group, many, spectrum.data());
      fft.gather(spectrum.data(), group, many, scratch);
      fft.columns_inverse(scratch, block, group, many, rows.data());
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
} // namespace brinell
