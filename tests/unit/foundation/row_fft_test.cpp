// SPDX-License-Identifier: BSD-3-Clause
#include "foundation/row_fft.hpp"

#include "random_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <vector>

namespace brinell::row_fft_test
{
namespace
{

/// Each value is a sum of `length` numbers of order 1; its error grows as the root of their number, times log n at most.
double tolerance(int length)
{
  return 4e-16 * std::sqrt(static_cast<double>(length)) * (2.0 + std::log2(static_cast<double>(length)));
}

/// e^{-2 pi i turns / length} in higher precision, for turns < length.
std::vector<std::complex<long double>> roots_of_one(int length)
{
  std::vector<std::complex<long double>> roots;
  for (int turns = 0; turns < length; ++turns)
    roots.push_back(std::polar(1.0L, -2.0L * std::numbers::pi_v<long double> * static_cast<long double>(turns) /
                                         static_cast<long double>(length)));
  return roots;
}

/// Rows and their spectra, [block][row] between values that must not be written.
class RowFftTest : public testing::TestWithParam<int>
{
protected:
  static constexpr int apart = RowFft::most_rows + 1;
  static constexpr double untouched = 1e3;

  int length = GetParam();
  std::vector<std::complex<long double>> roots = roots_of_one(length);

  [[nodiscard]] std::complex<long double> root(int j, int k) const
  {
    return roots[static_cast<std::size_t>(static_cast<long long>(j) * k % length)];
  }
  static Complex value(const AlignedVector<ComplexLanes>& spectra, int row, int k)
  {
    const ComplexLanes& block = spectra[static_cast<std::size_t>(k / lane_count * apart + row)];
    return {block.re[k % lane_count], block.im[k % lane_count]};
  }

  static AlignedVector<ComplexLanes> forward(const RowFft& fft, const std::vector<double>& field, int count)
  {
    ComplexLanes nothing;
    nothing.re += untouched;
    AlignedVector<ComplexLanes> spectra(static_cast<std::size_t>(fft.blocks() * apart), nothing);
    RowFft::Work work = fft.make_work();
    fft.forward(field.data(), count, spectra.data(), {apart, false}, work);
    return spectra;
  }
};

std::vector<int> lengths()
{
  std::vector<int> all{90,  97,  101, 125, 128, 180,  202,  210,  243,  250,  256,
                       343, 360, 500, 512, 686, 1000, 1023, 1024, 1999, 2310, 4096};
  for (int length = 1; length <= 64; ++length)
    all.push_back(length);
  return all;
}
INSTANTIATE_TEST_SUITE_P(Lengths, RowFftTest, testing::ValuesIn(lengths()),
                         [](const auto& p) { return std::to_string(p.param); });

TEST_P(RowFftTest, SpectrumIsTheSumOverWhatIsGiven)
{
  for (const int given : {length, (length + 1) / 2, std::max(1, length / 3)})
    for (const int count : {1, RowFft::most_rows})
    {
      const RowFft fft(given, length);
      const std::vector<double> field = test::random_field(static_cast<std::size_t>(given * count), 1);
      const AlignedVector<ComplexLanes> spectra = forward(fft, field, count);
      const int step = std::max(1, length / 64), row = count - 1;
      for (int k = 0; k < fft.wavenumbers(); k += step)
      {
        std::complex<long double> sum;
        for (int j = 0; j < given; ++j)
          sum += static_cast<long double>(field[static_cast<std::size_t>(row * given + j)]) * root(j, k);
        ASSERT_LE(std::abs(std::complex<long double>(value(spectra, row, k)) - sum), tolerance(length))
            << "wavenumber " << k << ", " << given << " given, " << count << " rows";
      }
    }
}

TEST_P(RowFftTest, ConstantAndAlternatingPartsAreReal)
{
  const RowFft fft(length, length);
  for (const int count : {1, RowFft::most_rows})
  {
    const auto spectra = forward(fft, test::random_field(static_cast<std::size_t>(length * count), 2), count);
    for (int row = 0; row < count; ++row)
    {
      EXPECT_EQ(value(spectra, row, 0).imag(), 0.0);
      if (length % 2 == 0)
      {
        EXPECT_EQ(value(spectra, row, length / 2).imag(), 0.0);
      }
    }
  }
}

TEST_P(RowFftTest, LanesBeyondAreZeroAndOtherRowsUntouched)
{
  const RowFft fft(length, length);
  const auto spectra = forward(fft, test::random_field(static_cast<std::size_t>(length), 3), 1);
  for (int k = fft.wavenumbers(); k < fft.blocks() * lane_count; ++k)
    EXPECT_EQ(value(spectra, 0, k), 0.0);
  for (int block = 0; block < fft.blocks(); ++block)
    EXPECT_EQ(value(spectra, 1, block * lane_count), untouched);
}

/// For the imaginary parts of the constant and of the alternating wave, which no real row has, and beyond the wavenumbers there
/// may be anything.
TEST_P(RowFftTest, InverseIsTheSumOverBothSignsOfTheWavenumber)
{
  const double scale = 0.7;
  for (const int wanted : {length, (length + 1) / 2})
    for (const int count : {1, RowFft::most_rows})
    {
      const RowFft fft(wanted, length);
      AlignedVector<ComplexLanes> spectra(static_cast<std::size_t>(fft.blocks() * apart));
      const auto parts = test::random_field(spectra.size() * 2 * lane_count, 4);
      for (std::size_t i = 0; i < spectra.size(); ++i)
        for (std::size_t lane = 0; lane < lane_count; ++lane)
        {
          spectra[i].re[lane] = parts[2 * (i * lane_count + lane)];
          spectra[i].im[lane] = parts[2 * (i * lane_count + lane) + 1];
        }
      std::vector<double> field(static_cast<std::size_t>(wanted * count + 1), untouched);
      RowFft::Work work = fft.make_work();
      fft.inverse(spectra.data(), {apart, false}, count, scale, field.data(), work);
      EXPECT_EQ(field.back(), untouched);
      const int step = std::max(1, length / 64), row = count - 1;
      for (int j = 0; j < wanted; j += step)
      {
        long double sum = 0.0L;
        for (int k = 0; k < fft.wavenumbers(); ++k)
        {
          const std::complex<long double> part(value(spectra, row, k));
          const bool is_alone = k == 0 || 2 * k == length;
          sum += is_alone ? (part.real() * root(j, k)).real() : 2.0L * (part * std::conj(root(j, k))).real();
        }
        ASSERT_NEAR(field[static_cast<std::size_t>(row * wanted + j)], static_cast<double>(scale * sum),
                    2.0 * tolerance(length))
            << "value " << j << ", " << wanted << " wanted, " << count << " rows";
      }
    }
}

TEST(RowFftCountTest, RowsDoNotDependOnTheirNumber)
{
  const int given = 45, length = 90;
  const RowFft fft(given, length);
  const std::vector<double> field = test::random_field(static_cast<std::size_t>(given * RowFft::most_rows), 5);
  RowFft::Work work = fft.make_work();
  for (int count = 1; count <= RowFft::most_rows; ++count)
  {
    AlignedVector<ComplexLanes> spectra(static_cast<std::size_t>(fft.blocks() * count));
    std::vector<double> back(static_cast<std::size_t>(given * count));
    fft.forward(field.data(), count, spectra.data(), {count, false}, work);
    fft.inverse(spectra.data(), {count, false}, count, 1.0 / length, back.data(), work);
    for (std::size_t i = 0; i < back.size(); ++i)
      ASSERT_NEAR(back[i], field[i], tolerance(length)) << count << " rows";
  }
}

} // namespace
} // namespace brinell::row_fft_test
