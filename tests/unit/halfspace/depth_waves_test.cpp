// SPDX-License-Identifier: BSD-3-Clause
#include "halfspace/transform/depth_waves.hpp"

#include "halfspace/heat/heat_memory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

/// The waves in depth, of which all that heat does is a sum.
namespace brinell::halfspace::depth_waves_test
{
namespace
{

constexpr double pi = std::numbers::pi;

TEST(DepthWaves, SumToTheDecayOfHeatAtAllTimes)
{
  const double kappa = 0.3;
  for (const double longest : {1.0, 20.0, 5000.0})
  {
    const std::vector<DepthWave> waves = depth_waves(kappa, {1.0, longest}, 10.0).waves;
    EXPECT_LT(waves.size(), 45U);
    for (double t = 1.0; t <= longest; t *= 1.17)
    {
      double sum = 0.0;
      for (const DepthWave& wave : waves)
        sum += wave.weight * std::exp(-kappa * wave.number * wave.number * t);
      // The trapezoidal rule leaves some e^{-pi^2/(2 * 0.4)} = 4.4e-6, times a factor of order one.
      EXPECT_NEAR(sum * std::sqrt(pi * kappa * t), 1.0, 2e-5) << t << " of " << longest;
    }
  }
}

/// A sum over all waves at one depth, a time after a unit of heat has entered.
struct Sums
{
  double temperature = 0.0, potential = 0.0, slope = 0.0; ///< the potential times k
};

Sums sums_of(const DepthWaves& waves, const DepthFactors& factors, double k, double heat_length)
{
  Sums sums;
  for (std::size_t w = 0; w + 1 < waves.waves.size(); ++w)
  {
    const double s = waves.waves[w].number, left = std::exp(-std::pow(s * heat_length, 2));
    sums.temperature += left * factors.temperature[w];
    sums.potential += left * factors.potential[w] * k / (k * k + s * s);
    sums.slope += left * factors.slope[w] / (k * k + s * s);
  }
  const double weight = waves.waves.back().weight, share = waves.slow_share(k);
  return {sums.temperature + weight, sums.potential + share, sums.slope - factors.depth * (weight - k * share)};
}

TEST(DepthWaves, SumsHoldAtAnyDepth)
{
  // The integrals over s of cos(s z) e^{-s^2 a^2}, the same over k^2 + s^2, and its slope (Gradshteyn and Ryzhik, 3.954).
  const double kappa = 0.3, finest = 10.0;
  const DepthWaves waves = depth_waves(kappa, {1.0, 100.0, 30.0}, finest);
  for (const double z : {0.3, 1.0, 2.0, 5.0, 10.0, 30.0})
  {
    const DepthFactors factors = depth_factors(waves, {&z, 1}).front();
    double error = 0.0;
    for (double t = 1.0; t <= 100.0; t *= 1.5)
      for (const double k : {0.0, 1e-3, 0.02, 0.3, 2.0})
      {
        const double a = std::sqrt(kappa * t), b = 0.5 * z / a, grown = std::exp(std::min(k * k * a * a, 300.0));
        if (k * a > 4.0)
          continue; // e^{k^2 a^2} and what it is multiplied with are out of proportion
        const double from = std::exp(-k * z) * std::erfc(k * a - b), back = std::exp(k * z) * std::erfc(k * a + b);
        const Sums sums = sums_of(waves, factors, k, a);
        const double T = std::exp(-b * b) / std::sqrt(pi);
        error =
            std::max({error, std::abs(a * sums.temperature - T), std::abs(sums.potential / grown - 0.5 * (from + back)),
                      std::abs(sums.slope / grown - 0.5 * (back - from))});
      }
    std::printf("waves in depth, z = %g: %.1e\n", z, error);
    // What the kernel of (turned) leaves beside the band: some e^{-pi^2/(4 * 0.22)} = 1.3e-5 of a term of order one.
    EXPECT_LT(error, 1e-4);
  }
}

} // namespace
} // namespace brinell::halfspace::depth_waves_test
