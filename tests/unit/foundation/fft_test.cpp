// SPDX-License-Identifier: BSD-3-Clause
#include "foundation/fft.hpp"

#include "brinell/foundation/error.hpp"
#include "random_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

namespace brinell::fft_test
{
namespace
{

// A transform of N values errs by a few epsilon * log2(N) of the largest value it can reach (Higham 2002, Section 24.1);
// N < 2^11 here.
constexpr double rounding = 50.0 * std::numeric_limits<double>::epsilon();

std::vector<double> inverse(const PaddedFft& fft, const AlignedVector<Complex>& spectrum)
{
  std::vector<double> field(fft.grid().size());
  fft.inverse(spectrum.data(), field);
  return field;
}

class PaddedFftTest : public testing::TestWithParam<SurfaceGrid>
{
};

INSTANTIATE_TEST_SUITE_P(Grids, PaddedFftTest,
                         testing::Values(SurfaceGrid{1, 1, 1.0, 1.0}, SurfaceGrid{2, 3, 1.0, 1.0},
                                         SurfaceGrid{7, 4, 0.5, 2.0}, SurfaceGrid{16, 9, 1.0, 0.3},
                                         SurfaceGrid{1, 12, 1.0, 1.0}, SurfaceGrid{11, 1, 2.0, 1.0}),
                         [](const auto& p) { return std::to_string(p.param.nx) + "x" + std::to_string(p.param.ny); });

TEST(FastLengthTest, IsTheSmallestEvenProductOfSmallPrimes)
{
  const auto good = [](int n)
  {
    if (n % 2 != 0)
      return false;
    for (const int prime : {2, 3, 5, 7})
      while (n % prime == 0)
        n /= prime;
    return n == 1;
  };
  for (int n = 1; n <= 3000; ++n)
  {
    const int length = fast_length(n);
    ASSERT_GE(length, n);
    ASSERT_TRUE(good(length)) << length;
    for (int shorter = std::max(n, 2); shorter < length; ++shorter)
      ASSERT_FALSE(good(shorter)) << "for " << n;
  }
}

TEST_P(PaddedFftTest, PadsForALinearConvolution)
{
  const PaddedFft fft(GetParam());
  EXPECT_GE(fft.px(), 2 * GetParam().nx - 1);
  EXPECT_GE(fft.py(), 2 * GetParam().ny - 1);
  EXPECT_GE(fft.plane(), static_cast<std::size_t>(fft.kx() * fft.py()));
}

TEST_P(PaddedFftTest, InverseOfForwardIsTheField)
{
  const PaddedFft fft(GetParam());
  const std::vector<double> field = test::random_field(GetParam().size(), 1);
  const std::vector<double> back = inverse(fft, fft.forward(field));
  for (std::size_t i = 0; i < field.size(); ++i)
    EXPECT_NEAR(back[i], field[i], rounding);
}

TEST_P(PaddedFftTest, ProductOfSpectraIsTheDirectSum)
{
  const SurfaceGrid& grid = GetParam();
  const PaddedFft fft(grid);
  const int px = fft.px(), py = fft.py(), nx = grid.nx, ny = grid.ny;
  // A kernel without any symmetry, known at every offset between two cells.
  const auto width = static_cast<std::size_t>(2 * nx - 1);
  const std::vector<double> kernel = test::random_field(width * static_cast<std::size_t>(2 * ny - 1), 2);
  const auto kernel_at = [&](int di, int dj)
  { return kernel[static_cast<std::size_t>(di + nx - 1) + width * static_cast<std::size_t>(dj + ny - 1)]; };
  AlignedVector<double> wrapped(static_cast<std::size_t>(px * py), 0.0);
  for (int dj = 1 - ny; dj < ny; ++dj)
    for (int di = 1 - nx; di < nx; ++di)
      wrapped[static_cast<std::size_t>((dj + py) % py * px + (di + px) % px)] = kernel_at(di, dj);

  const std::vector<double> field = test::random_field(grid.size(), 3);
  const AlignedVector<Complex> a = fft.forward_padded(wrapped);
  AlignedVector<Complex> b = fft.forward(field);
  for (int k = 0; k < fft.kx() * py; ++k)
    b[static_cast<std::size_t>(k)] *= a[static_cast<std::size_t>(k)];
  const std::vector<double> result = inverse(fft, b);

  const double bound = rounding * static_cast<double>(px * py); // terms of the sum are at most 1
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i)
    {
      double sum = 0.0;
      for (int m = 0; m < ny; ++m)
        for (int l = 0; l < nx; ++l)
          sum += kernel_at(i - l, j - m) * field[static_cast<std::size_t>(l + nx * m)];
      EXPECT_NEAR(result[static_cast<std::size_t>(i + nx * j)], sum, bound) << i << ' ' << j;
    }
}

TEST_P(PaddedFftTest, PaddedInputIsTheGridWithZeros)
{
  const SurfaceGrid& grid = GetParam();
  const PaddedFft fft(grid);
  const std::vector<double> field = test::random_field(grid.size(), 4);
  AlignedVector<double> padded(static_cast<std::size_t>(fft.px() * fft.py()), 0.0);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      padded[static_cast<std::size_t>(i + fft.px() * j)] = field[grid.index(i, j)];
  const AlignedVector<Complex> a = fft.forward(field), b = fft.forward_padded(padded);
  for (int k = 0; k < fft.kx() * fft.py(); ++k)
    EXPECT_LE(std::abs(a[static_cast<std::size_t>(k)] - b[static_cast<std::size_t>(k)]),
              rounding * static_cast<double>(grid.size()));
}

TEST_P(PaddedFftTest, SpectrumOfOneCellIsAWaveOfThoseWavenumbers)
{
  // Sum of f e^{-i k x}: a unit value in cell (i0, j0) gives e^{-i (k_x x + k_y y)}, signs and wrapping included.
  const SurfaceGrid& grid = GetParam();
  const PaddedFft fft(grid);
  const int i0 = grid.nx - 1, j0 = grid.ny / 2;
  std::vector<double> field(grid.size(), 0.0);
  field[grid.index(i0, j0)] = 1.0;
  const AlignedVector<Complex> spectrum = fft.forward(field);
  for (int j = 0; j < fft.py(); ++j)
    for (int i = 0; i < fft.kx(); ++i)
    {
      const double phase = fft.wavenumber_x(i) * i0 * grid.dx + fft.wavenumber_y(j) * j0 * grid.dy;
      const Complex expected = std::polar(1.0, -phase);
      EXPECT_LE(std::abs(spectrum[static_cast<std::size_t>(i + fft.kx() * j)] - expected), rounding) << i << ' ' << j;
    }
  for (int j = 0; j < fft.py(); ++j)
    EXPECT_EQ(fft.wavenumber_y(j) < 0.0, j > fft.py() / 2);
}

TEST(FftPlanTest, RefusesALengthThatIsTooShort)
{
  EXPECT_THROW(PaddedFft(SurfaceGrid{4, 4, 1.0, 1.0}, 3, 8), InternalError);
  EXPECT_THROW(PaddedFft(SurfaceGrid{4, 4, 1.0, 1.0}, 8, 2), InternalError);
  EXPECT_THROW(PaddedFft(SurfaceGrid{0, 4, 1.0, 1.0}, 8, 8), InternalError);
}

TEST(FftPlanTest, OnePlanServesSeveralThreads)
{
  const SurfaceGrid grid{13, 6, 1.0, 1.0};
  const PaddedFft fft(grid);
  constexpr int fields = 16;
  std::vector<std::vector<double>> back(fields, std::vector<double>(grid.size()));
#pragma omp parallel for num_threads(4)
  for (int n = 0; n < fields; ++n)
  {
    const std::vector<double> field = test::random_field(grid.size(), static_cast<unsigned>(n));
    back[static_cast<std::size_t>(n)] = inverse(fft, fft.forward(field));
  }
  for (int n = 0; n < fields; ++n)
  {
    const std::vector<double> field = test::random_field(grid.size(), static_cast<unsigned>(n));
    for (std::size_t i = 0; i < field.size(); ++i)
      EXPECT_NEAR(back[static_cast<std::size_t>(n)][i], field[i], rounding);
  }
}

} // namespace
} // namespace brinell::fft_test
