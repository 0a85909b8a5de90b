// SPDX-License-Identifier: BSD-3-Clause
// What must not matter to an increment: place, unit of length, number of threads.
#include "sphere_press.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <omp.h>
#include <vector>

namespace brinell::elastoplastic::invariance_test
{
namespace
{

/// Results of a press in two steps, as plain numbers. To the tight tolerance, 1e-9 of the yield stress; strain follows
/// with the factor yield strain over plastic strain, 5, and that of the softest plastic response, some ten.
struct Outcome
{
  std::vector<double> pressure, strain, displacement;
  double dissipation = 0.0;
};

Outcome results(const SpherePress& press)
{
  const BodyState& state = press.contact().lower().state();
  const auto p = press.contact().pressure();
  return {{p.begin(), p.end()}, state.plastic_strain, state.residual_displacement, state.dissipation};
}

Outcome outcome(PressOptions options = {}, int offset = 0)
{
  options.settings = tight_settings();
  SpherePress press(options);
  EXPECT_TRUE(press.press(3.0, Integration::path, offset).converged);
  EXPECT_TRUE(press.press(6.0, Integration::path, offset).converged);
  return results(press);
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

TEST(InvarianceTest, NumberOfThreadsDoesNotMatterToTheLastBit)
{
  // Each thread writes to its own cells, and sums have a fixed order. One body and a small press: two threads on a busy
  // machine wait for each other at every loop.
  const auto pressed = []
  {
    PressOptions options;
    options.upper_plastic = false;
    SpherePress press(options);
    EXPECT_TRUE(press.press(1.6).converged);
    return results(press);
  };
  const Outcome one = with_threads(1, pressed), two = with_threads(2, pressed);
  EXPECT_GT(one.dissipation, 0.0);
  EXPECT_EQ(one.pressure, two.pressure);
  EXPECT_EQ(one.strain, two.strain);
  EXPECT_EQ(one.displacement, two.displacement);
  EXPECT_EQ(one.dissipation, two.dissipation);
}

TEST(InvarianceTest, AThreadForEachBodyChangesNothing)
{
  // Two threads take one body each, four share each body.
  const auto pressed = []
  {
    SpherePress press(PressOptions{});
    EXPECT_TRUE(press.press(1.6).converged);
    EXPECT_TRUE(press.press(1.8).converged);
    Outcome both = results(press);
    const BodyState& upper = press.contact().upper().state();
    both.strain.insert(both.strain.end(), upper.plastic_strain.begin(), upper.plastic_strain.end());
    both.dissipation += upper.dissipation;
    return both;
  };
  const Outcome one = with_threads(1, pressed);
  EXPECT_GT(one.dissipation, 0.0);
  for (const int threads : {2, 4})
  {
    const Outcome several = with_threads(threads, pressed);
    EXPECT_EQ(one.pressure, several.pressure) << threads;
    EXPECT_EQ(one.strain, several.strain) << threads;
    EXPECT_EQ(one.displacement, several.displacement) << threads;
    EXPECT_EQ(one.dissipation, several.dissipation) << threads;
  }
}

TEST(InvarianceTest, UnitOfLengthDoesNotMatter)
{
  // Micrometres: 1e6 is no power of two, so every number is rounded anew, and the acceleration makes round-off visible to
  // the tolerance.
  PressOptions micro;
  micro.unit = 1e-6;
  const Outcome a = outcome(), b = outcome(micro);
  EXPECT_LE(difference(a.strain, b.strain), 1e-7);
  EXPECT_LE(difference(a.pressure, b.pressure, 1e-12), 1e-8);
  EXPECT_LE(difference(a.displacement, b.displacement, 1e6), 1e-8);
  EXPECT_NEAR(a.dissipation * 1e6, b.dissipation, 1e-8 * b.dissipation);
}

TEST(InvarianceTest, PlaceOnTheBodyDoesNotMatter)
{
  // Three cells further on the same body: the strain is three cells further, to what the operator leaves of the
  // periodic images, and to its round-off.
  PressOptions options;
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
} // namespace brinell::elastoplastic::invariance_test
