// SPDX-License-Identifier: BSD-3-Clause
// What must not matter to an increment: place, unit of length, number of threads.
#include "sphere_press.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <omp.h>
#include <vector>

namespace brinell::elastoplastic
{
namespace
{

/// Results of a press in two steps, as plain numbers.
struct Outcome
{
  std::vector<double> pressure, strain, displacement;
  double dissipation = 0.0;
};

Outcome outcome(SpherePress& press, int offset = 0)
{
  EXPECT_TRUE(press.press(3.0, Integration::path, offset).converged);
  EXPECT_TRUE(press.press(6.0, Integration::path, offset).converged);
  const BodyState& state = press.contact().lower().state();
  const auto p = press.contact().pressure();
  return {{p.begin(), p.end()}, state.plastic_strain, state.residual_displacement, state.dissipation};
}

Outcome outcome(const PressOptions& options = {}, int offset = 0)
{
  SpherePress press(options);
  return outcome(press, offset);
}

double difference(const std::vector<double>& a, const std::vector<double>& b, double factor = 1.0)
{
  double d = 0.0, size = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    d = std::max(d, std::abs(a[i] * factor - b[i]));
    size = std::max(size, std::abs(b[i]));
  }
  return d / size;
}

/// Runs with a number of threads, and restores the one before.
template <class F>
auto with_threads(int threads, F f)
{
  const int before = omp_get_max_threads();
  omp_set_num_threads(threads);
  auto result = f();
  omp_set_num_threads(before);
  return result;
}

TEST(InvarianceTest, TheSameRunGivesTheSameBits)
{
  for (const int threads : {1, 2})
  {
    const Outcome a = with_threads(threads, [] { return outcome(); });
    const Outcome b = with_threads(threads, [] { return outcome(); });
    EXPECT_EQ(a.pressure, b.pressure);
    EXPECT_EQ(a.strain, b.strain);
    EXPECT_EQ(a.displacement, b.displacement);
    EXPECT_EQ(a.dissipation, b.dissipation);
  }
}

TEST(InvarianceTest, ThreadsDoNotMatter)
{
  // Each thread writes to its own cells and sums have a fixed order, so the bits are the same too.
  const Outcome a = with_threads(1, [] { return outcome(); });
  const Outcome b = with_threads(2, [] { return outcome(); });
  EXPECT_EQ(a.pressure, b.pressure);
  EXPECT_EQ(a.strain, b.strain);
  EXPECT_EQ(a.displacement, b.displacement);
  EXPECT_EQ(a.dissipation, b.dissipation);
}

TEST(InvarianceTest, UnitOfLengthDoesNotMatter)
{
  // Micrometres: 1e6 is no power of two, so every number is rounded anew; the iterations are the same, so that only
  // round-off remains.
  PressOptions micro;
  micro.unit = 1e-6;
  const Outcome a = outcome(), b = outcome(micro);
  EXPECT_LE(difference(a.strain, b.strain), 1e-10);
  EXPECT_LE(difference(a.pressure, b.pressure, 1e-12), 1e-10);
  EXPECT_LE(difference(a.displacement, b.displacement, 1e6), 1e-10);
  EXPECT_NEAR(a.dissipation * 1e6, b.dissipation, 1e-10 * b.dissipation);
}

TEST(InvarianceTest, PlaceOnTheBodyDoesNotMatter)
{
  // Three cells further on the same body: the strain is three cells further, to what the operator leaves of the
  // periodic images, and to its round-off.
  PressOptions options;
  options.settings = tight_settings();
  options.spare_columns = 4;
  const Outcome a = outcome(options, 0), b = outcome(options, 3);
  EXPECT_LE(difference(a.pressure, b.pressure), 1e-6);
  const int nx = SpherePress::n + options.spare_columns;
  double d = 0.0, size = 0.0;
  for (std::size_t i = 0; i < a.strain.size(); ++i)
    if (static_cast<int>(i) % nx < nx - 3)
    {
      d = std::max(d, std::abs(a.strain[i] - b.strain[i + 3]));
      size = std::max(size, std::abs(a.strain[i]));
    }
  EXPECT_LE(d, 1e-6 * size);
}

} // namespace
} // namespace brinell::elastoplastic
