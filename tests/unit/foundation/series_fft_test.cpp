// SPDX-License-Identifier: BSD-3-Clause
#include "foundation/series_fft.hpp"

#include "random_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <vector>

namespace brinell::series_fft_test
{
namespace
{

class SeriesFftTest : public testing::TestWithParam<int>
{
};

// Every number of parts with every number of lanes, values beyond a tile, a prime number.
INSTANTIATE_TEST_SUITE_P(Lengths, SeriesFftTest,
                         testing::Values(1, 2, 3, 4, 5, 6, 7, 8, 11, 21, 24, 25, 30, 49, 56, 64, 97, 121, 250, 256),
                         [](const auto& p) { return std::to_string(p.param); });

TEST_P(SeriesFftTest, IsTheSumAndComesBack)
{
  const int length = GetParam();
  const auto size = static_cast<std::size_t>(length);
  const SeriesFft fft(length);
  ASSERT_EQ(fft.length(), length);
  SeriesFft::Work work = fft.make_work();
  const std::vector<double> series = test::random_field(2 * size, 1);
  AlignedVector<double> re(size + lane_count), im(size + lane_count);
  fft.forward(series.data(), 2 * length, re.data(), im.data(), work);
  // Sums of `length` numbers of order 1: their error grows as the root of their number, times log n at most.
  const double tolerance = 4e-16 * std::sqrt(length) * (2.0 + std::log2(length));
  for (int k = 0; k < length; ++k)
  {
    std::complex<long double> sum;
    for (int j = 0; j < length; ++j)
      sum += std::complex<long double>(series[static_cast<std::size_t>(2 * j)],
                                       series[static_cast<std::size_t>(2 * j + 1)]) *
             std::polar(1.0L, -2.0L * std::numbers::pi_v<long double> *
                                  static_cast<long double>(static_cast<long long>(j) * k % length) /
                                  static_cast<long double>(length));
    const auto at = static_cast<std::size_t>(k);
    ASSERT_NEAR(re[at], static_cast<double>(sum.real()), tolerance) << k;
    ASSERT_NEAR(im[at], static_cast<double>(sum.imag()), tolerance) << k;
  }
  std::vector<double> back(2 * size);
  fft.inverse(re.data(), im.data(), 1.0 / length, back.data(), 2 * length, work);
  for (std::size_t i = 0; i < back.size(); ++i)
    ASSERT_NEAR(back[i], series[i], tolerance);
}

} // namespace
} // namespace brinell::series_fft_test
