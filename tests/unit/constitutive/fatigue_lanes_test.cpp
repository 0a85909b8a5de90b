// SPDX-License-Identifier: BSD-3-Clause
#include "constitutive/fatigue_lanes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace brinell::constitutive::fatigue_lanes_test
{
namespace
{

using Criterion = Fatigue::Criterion;

FatigueCriterion criterion_of(Criterion kind)
{
  return FatigueCriterion({.criterion = kind, .torsion_limit = 300e6, .bending_limit = 450e6});
}

/// Paths as under a contact, one per lane: a pulse of random directions.
LaneCycles pulses(unsigned seed, std::size_t points)
{
  std::mt19937 random(seed);
  std::normal_distribution<float> normal;
  LaneCycles cycles;
  cycles.stress.resize(points);
  cycles.strain.resize(points);
  for (std::size_t l = 0; l < fatigue_lanes; ++l)
    for (std::size_t n = 0; n < 6; ++n)
    {
      const float even = 300e6F * normal(random), odd = 300e6F * normal(random), plastic = 50e6F * normal(random);
      for (std::size_t i = 0; i < points; ++i)
      {
        const float x = 6.0F * (static_cast<float>(i) / static_cast<float>(points - 1) - 0.5F);
        cycles.stress[i][n][l] = (even + odd * x) * std::exp(-x * x) - (n == 5 ? 400e6F * std::exp(-x * x) : 0.0F);
        cycles.strain[i][n][l] = n == 5 ? 0.0F : cycles.stress[i][n][l] + (x > 0.0F ? plastic : 0.0F);
      }
    }
  return cycles;
}

struct Scalar
{
  std::vector<SymTensor> stress, strain;
};

Scalar lane_of(const LaneCycles& cycles, int lane)
{
  Scalar result;
  for (std::size_t n = 0; n < cycles.stress.size(); ++n)
  {
    result.stress.push_back(cycles.stress_at(n, lane));
    result.strain.push_back(cycles.strain_at(n, lane));
  }
  return result;
}

TEST(FatigueLanes, AgreeWithTheCriteriaOfSinglePoints)
{
  LaneScratch scratch;
  for (const Criterion kind : {Criterion::dang_van, Criterion::crossland})
    for (unsigned seed = 0; seed < 5; ++seed)
    {
      const FatigueCriterion criterion = criterion_of(kind);
      const LaneCycles cycles = pulses(seed, 41);
      const LaneFatigue found = fatigue_of(cycles, criterion, scratch);
      for (int l = 0; l < fatigue_lanes; ++l)
      {
        const Scalar one = lane_of(cycles, l);
        const double radius = enclosing_ball(one.stress).radius;
        // The lanes stop after few steps: docs/theory/fatigue.md says how close they are then.
        const double shear = radius / std::numbers::sqrt2;
        EXPECT_NEAR(found.utilisation[static_cast<std::size_t>(l)], criterion.utilisation({one.stress, {}}),
                    0.02 * shear / criterion.limit());
      }
    }
}

TEST(FatigueLanes, AmplitudesAreThoseOfSinglePoints)
{
  LaneScratch scratch;
  const LaneCycles cycles = pulses(11, 33);
  const LaneFatigue found = fatigue_of(cycles, criterion_of(Criterion::none), scratch);
  for (int l = 0; l < fatigue_lanes; ++l)
  {
    const auto lane = static_cast<std::size_t>(l);
    double principal = 0.0, least = 1e300, most = -1e300, least_xz = 1e300, most_xz = -1e300, least_yz = 1e300,
           most_yz = -1e300;
    for (const SymTensor& s : lane_of(cycles, l).stress)
    {
      principal = std::max(principal, principal_shear(s));
      least = std::min(least, trace(s) / 3.0);
      most = std::max(most, trace(s) / 3.0);
      least_yz = std::min(least_yz, s[3]);
      most_yz = std::max(most_yz, s[3]);
      least_xz = std::min(least_xz, s[4]);
      most_xz = std::max(most_xz, s[4]);
    }
    EXPECT_NEAR(found.principal[lane], principal, 1e-5 * principal);
    EXPECT_NEAR(found.most_mean[lane], most, 1e2);
    EXPECT_NEAR(found.least_mean[lane], least, 1e2);
    EXPECT_NEAR(found.orthogonal[lane], 0.5 * std::max(most_xz - least_xz, most_yz - least_yz), 1e2);
  }
}

TEST(FatigueLanes, BoundCriteriaOfCriticalPlanesFromAbove)
{
  LaneScratch scratch;
  for (const Criterion kind : {Criterion::findley, Criterion::fatemi_socie})
    for (unsigned seed = 0; seed < 4; ++seed)
    {
      const FatigueCriterion criterion = criterion_of(kind);
      const LaneCycles cycles = pulses(seed, 31);
      const LaneFatigue found = fatigue_of(cycles, criterion, scratch);
      for (int l = 0; l < fatigue_lanes; ++l)
      {
        const Scalar one = lane_of(cycles, l);
        const double exact = criterion.utilisation({one.stress, one.strain});
        EXPECT_GE(found.utilisation[static_cast<std::size_t>(l)], exact * (1.0 - 1e-4));
        EXPECT_LE(found.utilisation[static_cast<std::size_t>(l)], 3.0 * std::abs(exact) + 1.0); // of some use
      }
    }
}

} // namespace
} // namespace brinell::constitutive::fatigue_lanes_test
