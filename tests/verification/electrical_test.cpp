// SPDX-License-Identifier: BSD-3-Clause
// Resistance of contacts that yield or are rough: power laws, hysteresis, bounds.
#include "brinell/foundation/column.hpp"
#include "brinell/simulation/indentation.hpp"
#include "record.hpp"
#include "scenario_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace brinell::verification::electrical_test
{
namespace
{

using namespace simulation;
using constitutive::Electrical;
using constitutive::PerfectPlasticity;
using test::expect_within;
using Kind = contact::Drive::Kind;

constexpr double pi = std::numbers::pi;
constexpr double spreading = 3e-8; // sum of both resistivities [ohm m]

/// A ball of 1 mm on a flat, elastic unless the flat has a law.
IndentationCase ball(std::optional<constitutive::HardeningLaw> law, std::vector<double> loads)
{
  IndentationCase c;
  c.lower = {Plane{}, {{120e9, 0.3}, std::move(law)}};
  c.upper = {Paraboloid{1e-3, 1e-3}, {{200e9, 0.3}, {}}};
  c.lower.material.electrical = Electrical{2e-8, 0.0};
  c.upper.material.electrical = Electrical{1e-8, 0.0};
  for (const double load : loads)
    c.sequence.push_back({Kind::load, load});
  return c;
}

/// Exponent of the resistance as a power of the load between two rows.
double exponent(const IndentationRecord& a, const IndentationRecord& b)
{
  return std::log(b.contact_resistance / a.contact_resistance) / std::log(b.F_n / a.F_n);
}

TEST(ContactResistance, OfAnElasticBallFallsWithTheCubeRootOfTheLoad)
{
  IndentationCase c = ball({}, {1.0, 8.0});
  c.steps = 1;
  c.resolution = 32.0; // at the larger load; half of that at the smaller one
  const auto rows = computed(c).history;
  expect_within("elastic ball: exponent of the resistance", exponent(rows[0], rows[1]), -0.338, -0.328,
                "analytic: -1/3 (Holm 1967, Hertz)");
}

TEST(ContactResistance, OfASoftFlatFallsWithTheRootOfTheLoad)
{
  // R = S/4 sqrt(pi H/F) with a constant hardness (Holm 1967): from 300 to 1200 times the load at first yield.
  IndentationCase c = ball(PerfectPlasticity{150e6}, {2.0, 8.0, 0.0});
  c.steps = 8;
  c.resolution = 14.0;
  const auto rows = computed(c).history;
  expect_within("ball on a soft flat: exponent of the resistance", exponent(rows[7], rows[15]), -0.53, -0.47,
                "analytic: -1/2 (Holm 1967)");
  const IndentationRecord& peak = rows[15];
  const double hardness = peak.F_n / peak.contact_area;
  expect_within("ball on a soft flat: resistance over S/4 sqrt(pi H/F)",
                peak.contact_resistance / (0.25 * spreading * std::sqrt(pi * hardness / peak.F_n)), 0.985, 1.015,
                "analytic: 1 (Holm 1967)");
  // Unloading: the contact keeps its area, and opens like that of an elastic ball of the radius of the imprint.
  for (std::size_t i = 17; i < 22; ++i)
  {
    const auto same =
        std::find_if(rows.begin(), rows.begin() + 16, [&](const auto& r) { return r.F_n >= rows[i].F_n; });
    EXPECT_LT(rows[i].contact_resistance, same->contact_resistance) << i;
  }
}

/// A flat with random waves, from a quarter of the period down to a sixteenth, on a smooth one.
IndentationCase rough(std::optional<constitutive::HardeningLaw> law, double most)
{
  IndentationCase c;
  constexpr double period = 100e-6;
  c.lower = {Plane{}, {{120e9, 0.3}, std::move(law)}};
  c.upper = {Plane{}, {{200e9, 0.3}, {}}};
  c.lower.material.electrical = Electrical{2e-8, 0.0};
  c.upper.material.electrical = Electrical{1e-8, 0.0};
  c.lower.texture = {{RandomSurface({.hurst = 0.8,
                                     .rms_slope = 0.05,
                                     .rolloff = 0.25 * period,
                                     .cutoff = 0.0625 * period,
                                     .size_x = period,
                                     .size_y = period,
                                     .seed = 5})}};
  c.domain.x = c.domain.y = {Boundary::periodic, period, 96};
  for (const double share : {0.125, 0.25, 0.5, 1.0})
    c.sequence.push_back({Kind::load, share * most});
  c.steps = 3;
  return c;
}

TEST(ContactResistance, OfRoughFlatsFallsNearlyAsOneOverTheLoad)
{
  // Spots grow in number as the load does, until they merge.
  const auto elastic = computed(rough({}, 4.0)).history;
  const auto plastic = computed(rough(PerfectPlasticity{600e6}, 4.0)).history;
  const auto slope = [](const auto& rows)
  {
    const auto first = std::find_if(rows.begin(), rows.end(), [](const auto& r) { return r.contact_fraction > 0.01; });
    const auto last = std::find_if(first, rows.end(), [](const auto& r) { return r.contact_fraction > 0.1; }) - 1;
    EXPECT_GT(last - first, 2);
    return exponent(*first, *last);
  };
  expect_within("rough elastic flat, 1 to 10 % in contact: exponent of the resistance", slope(elastic), -1.1, -0.9,
                "literature: nearly -1 (Barber 2003)");
  expect_within("rough flat that yields, 1 to 10 % in contact: exponent of the resistance", slope(plastic), -1.1, -0.9,
                "bound: about -1");
  for (std::size_t i = 0; i < elastic.size(); ++i) // at the same load the softer flat has more area
    EXPECT_LT(plastic[i].contact_resistance, 1.02 * elastic[i].contact_resistance) << i;
}

TEST(ContactResistance, OfARoughBallIsWithinTheBoundsOfBarber)
{
  // The loads of the smooth ball, moved by the largest and the smallest height, bound that of the rough one. Load is a convex
  // function of the approach, so that secants of the bounds bound its slope, and with it the conductance.
  constexpr double radius = 1e-3, period = 12e-6, depth = 8e-9;
  IndentationCase c = ball({}, {});
  c.lower.texture = {{Sinusoid{depth, period, period}}};
  c.resolution = 24.0;
  for (const double approach : {0.6e-6, 0.8e-6, 1.0e-6})
    c.sequence.push_back({Kind::approach, approach});
  c.steps = 1;
  const double modulus = contact_modulus(c.lower.material.elastic, c.upper.material.elastic);
  const auto smooth = [&](double d)
  { return d > 0.0 ? 4.0 / 3.0 * modulus * std::sqrt(radius) * std::pow(d, 1.5) : 0.0; };
  const auto rows = computed(c).history;
  for (const IndentationRecord& row : rows)
  {
    const double d = row.approach, up = depth, down = -depth; // extremes of the heights
    EXPECT_GE(row.F_n, smooth(d - depth));
    EXPECT_LE(row.F_n, smooth(d + depth));
    double least = 0.0, most = std::numeric_limits<double>::infinity();
    for (int n = 1; n <= 400; ++n)
    {
      const double by = d * n / 400.0;
      most = std::min(most, (smooth(d + by - down) - smooth(d - up)) / by);
      least = std::max(least, (smooth(d - up) - smooth(d - by - down)) / by);
    }
    const double slope = 0.5 * modulus * spreading / row.contact_resistance;
    EXPECT_GE(slope, least);
    EXPECT_LE(slope, most);
    EXPECT_LT(most / least, 2.0); // they say something
  }
}

} // namespace
} // namespace brinell::verification::electrical_test
