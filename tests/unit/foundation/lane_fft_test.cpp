// SPDX-License-Identifier: BSD-3-Clause
#include "foundation/lane_fft.hpp"

#include "foundation/aligned.hpp"
#include "random_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

namespace brinell::lane_fft_test
{
namespace
{

using Series = AlignedVector<ComplexLanes>;

/// In every lane a series of its own.
Series random_series(int length)
{
  const auto values = test::random_field(static_cast<std::size_t>(length) * 2 * lane_count, 7);
  Series series(static_cast<std::size_t>(length));
  for (std::size_t i = 0; i < series.size(); ++i)
    for (std::size_t lane = 0; lane < lane_count; ++lane)
    {
      series[i].re[lane] = values[2 * (i * lane_count + lane)];
      series[i].im[lane] = values[2 * (i * lane_count + lane) + 1];
    }
  return series;
}

/// Term by term, in higher precision.
std::complex<long double> direct_sum(const Series& from, int given, int k, int sign, std::size_t lane)
{
  const auto length = static_cast<long double>(from.size());
  std::complex<long double> sum;
  for (int j = 0; j < given; ++j)
  {
    const auto turns = static_cast<long double>(static_cast<long long>(j) * k % static_cast<long long>(from.size()));
    const long double angle = sign * 2.0L * std::numbers::pi_v<long double> * turns / length;
    const ComplexLanes& value = from[static_cast<std::size_t>(j)];
    sum += std::complex<long double>(value.re[lane], value.im[lane]) *
           std::complex<long double>(std::cos(angle), std::sin(angle));
  }
  return sum;
}

void expect_transform(const Series& to, const Series& from, int given, int wanted, int sign)
{
  // Each value is a sum of `length` numbers of order 1; its error grows as the root of their number, times log n at most.
  const double tolerance =
      4e-16 * std::sqrt(static_cast<double>(from.size())) * (2.0 + std::log2(static_cast<double>(from.size())));
  for (int k = 0; k < wanted; ++k)
    for (std::size_t lane = 0; lane < lane_count; lane += 3)
    {
      const auto expected = direct_sum(from, given, k, sign, lane);
      const ComplexLanes& value = to[static_cast<std::size_t>(k)];
      ASSERT_NEAR(value.re[lane], static_cast<double>(expected.real()), tolerance)
          << "value " << k << ", lane " << lane;
      ASSERT_NEAR(value.im[lane], static_cast<double>(expected.imag()), tolerance)
          << "value " << k << ", lane " << lane;
    }
}

class LaneFftTest : public testing::TestWithParam<int>
{
protected:
  int length = GetParam();
  LaneFft fft{length};
  Series from = random_series(length);
  Series to = Series(static_cast<std::size_t>(length));
  Series work = Series(fft.work_size());
};

// Every radix alone, first, between others and last; powers of two in all their orders; prime factors beyond the radices.
INSTANTIATE_TEST_SUITE_P(Lengths, LaneFftTest,
                         testing::Values(1, 2, 3, 4, 5, 7, 8, 11, 13, 14, 15, 16, 17, 28, 30, 32, 34, 64, 77, 90, 97,
                                         105, 128, 143, 169, 210, 256, 286, 360, 500, 512),
                         [](const auto& p) { return std::to_string(p.param); });

TEST_P(LaneFftTest, ForwardIsTheSumOverWhatIsGiven)
{
  for (const int given : {length, (length + 1) / 2, std::max(1, length / 3)})
  {
    fft.forward(from.data(), given, to.data(), work.data());
    expect_transform(to, from, given, length, -1);
  }
}

TEST_P(LaneFftTest, InverseIsTheSumWithTheOppositeSign)
{
  fft.inverse(from.data(), to.data(), length, work.data());
  expect_transform(to, from, length, length, 1);
}

TEST_P(LaneFftTest, InverseWritesOnlyWhatIsWanted)
{
  const int wanted = (length + 1) / 2;
  for (ComplexLanes& value : to)
    value.re[0] = 1e3;
  fft.inverse(from.data(), to.data(), wanted, work.data());
  expect_transform(to, from, length, wanted, 1);
  for (int j = wanted; j < length; ++j)
    EXPECT_EQ(to[static_cast<std::size_t>(j)].re[0], 1e3);
}

TEST_P(LaneFftTest, LanesDoNotMeet)
{
  fft.forward(from.data(), length, to.data(), work.data());
  const Series before = to;
  constexpr std::size_t changed = lane_count / 2;
  for (ComplexLanes& value : from)
    value.re[changed] += 1.0;
  fft.forward(from.data(), length, to.data(), work.data());
  for (std::size_t k = 0; k < to.size(); ++k)
    for (std::size_t lane = 0; lane < lane_count; ++lane)
      if (lane != changed)
      {
        ASSERT_EQ(to[k].re[lane], before[k].re[lane]);
        ASSERT_EQ(to[k].im[lane], before[k].im[lane]);
      }
}

} // namespace
} // namespace brinell::lane_fft_test
