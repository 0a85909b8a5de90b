// SPDX-License-Identifier: BSD-3-Clause
#include "order.hpp"
#include "record.hpp"
#include "scenario_runs.hpp"

#include "brinell/simulation/sliding.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

/// Rough bodies without ends that slide past each other.
namespace brinell::verification::sliding_test
{
namespace
{

using simulation::SlidingCase;
using simulation::SlidingRecord;
using simulation::SlidingStroke;
using simulation::SlidingSummary;

constexpr double wavelength = 1e-3;
constexpr double k = 2.0 * std::numbers::pi / wavelength;

using SlidingRun = Computed<SlidingCase>;

/// Elastic waves across the motion, crest on crest, pressed so that they touch everywhere.
SlidingCase flattened_waves(int cells)
{
  SlidingCase c;
  c.lower = {simulation::Plane{}, {{200e9, 0.3}, {}}};
  c.upper = {simulation::Plane{}, {{100e9, 0.2}, {}}};
  c.lower.texture = simulation::Sinusoid{.amplitude = 1e-6, .wavelength_x = wavelength};
  c.upper.texture = simulation::Sinusoid{.amplitude = 0.5e-6, .wavelength_x = wavelength};
  c.domain.x = {Boundary::periodic, wavelength, cells};
  c.domain.y = {Boundary::periodic, wavelength, 1};
  const double modulus = contact_modulus(c.lower.material.elastic, c.upper.material.elastic);
  c.press = load(1.2 * 0.5 * modulus * k * 1.5e-6 * wavelength * wavelength);
  c.press_steps = 1;
  c.distance = wavelength;
  return c;
}

TEST(Sliding, OfWavesThatTouchEverywhereHasTheClosedForm)
{
  // A wave of amplitude A that is pressed flat keeps the energy E' k A^2/8 per area (Westergaard 1939; Johnson 1985, section 13.2). Of
  // two with A1 and A2, shifted by X, A^2 = A1^2 + A2^2 + 2 A1 A2 cos kX: the force per area is E' k^2 A1 A2/4 times -sin kX. It is read with
  // central differences, and a shift of a cell per step.
  std::vector<double> errors, balances;
  for (const int cells : {16, 32, 64})
  {
    const SlidingCase c = flattened_waves(cells);
    const SlidingRun run = computed(c);
    const double modulus = contact_modulus(c.lower.material.elastic, c.upper.material.elastic);
    const double largest = 0.25 * modulus * k * k * 1e-6 * 0.5e-6 * wavelength * wavelength;
    double worst = 0.0;
    for (const SlidingRecord& r : run.history)
      if (r.way > 0.0 && r.F_n > 0.5 * c.press.value)
      {
        EXPECT_NEAR(r.contact_fraction, 1.0, 1e-9);
        worst = std::max(worst, std::abs(r.F_X / largest + std::sin(k * r.slid)));
      }
    errors.push_back(worst);
    balances.push_back(run.summary.energy_balance_error);
    EXPECT_NEAR(run.summary.strokes[0].friction, 0.0, 1e-9);
  }
  EXPECT_GT(test::Orders("waves that touch everywhere, force", errors).last, 1.9);
  test::expect_close("waves that touch everywhere, 64 cells: error of the force over the largest", errors.back(), 0.0,
                     k * k * std::pow(wavelength / 64, 2) / 5.0, "exact: Westergaard (1939); slope by differences");
}

/// Waves on both, of two steels that yield.
SlidingCase yielding_waves(int cells)
{
  SlidingCase c;
  c.lower = {simulation::Plane{}, {{200e9, 0.3}, constitutive::LinearHardening{0.6e9, 20e9}}};
  c.upper = {simulation::Plane{}, {{200e9, 0.3}, constitutive::LinearHardening{1.2e9, 20e9}}};
  c.lower.texture = simulation::Sinusoid{4e-6, wavelength, wavelength};
  c.upper.texture = simulation::Sinusoid{2e-6, 0.5 * wavelength, wavelength};
  c.domain.x = c.domain.y = {Boundary::periodic, wavelength, cells};
  c.press = load(60.0);
  c.press_steps = 4;
  c.distance = wavelength;
  return c;
}

TEST(Sliding, OfElasticWavesGivesAllWorkBack)
{
  SlidingCase c = yielding_waves(32);
  for (simulation::ShapedBody* body : {&c.lower, &c.upper})
    body->material.hardening.reset();
  const SlidingRun run = computed(c);
  double largest = 0.0;
  for (const SlidingRecord& r : run.history)
    largest = std::max(largest, std::abs(r.friction));
  ASSERT_GT(largest, 1e-4);
  // Crests are even: what is taken on the way up comes back on the way down, step by step.
  test::expect_close("elastic waves over a period: mean friction over the largest",
                     run.summary.strokes[0].friction / largest, 0.0, 1e-3, "exact; symmetry of the steps");
  c.friction.coefficient = 0.2;
  c.to_and_fro = true;
  c.strokes = 2;
  const SlidingRun rubbed = computed(c);
  const SlidingStroke& back = rubbed.summary.strokes[1];
  test::expect_close("elastic waves, to and fro with friction 0.2: friction", back.friction, 0.2, 1e-3,
                     "exact: what is left of a period");
  test::expect_close("elastic waves, to and fro with friction 0.2: error of the energy balance",
                     rubbed.summary.energy_balance_error, 0.0, 5e-3, "bound: cells and steps");
}

TEST(Sliding, ConvergesWithPlasticity)
{
  // With the cells the steps get shorter, too. The limit is where two orders lead from the last two.
  std::vector<double> balances, friction, plastic, contact;
  for (const int cells : {16, 32, 64})
  {
    if (slow_build && cells > 16)
      return;
    const SlidingRun run = computed(yielding_waves(cells));
    balances.push_back(run.summary.energy_balance_error);
    friction.push_back(run.summary.strokes[0].friction_ploughing);
    plastic.push_back(run.summary.strokes[0].dissipation_plastic);
    contact.push_back(run.summary.strokes[0].contact_fraction);
    EXPECT_EQ(run.summary.split_increments, 0);
  }
  const auto errors = [](const std::vector<double>& of)
  {
    const double limit = of[2] + (of[2] - of[1]) / 3.0;
    return std::vector{of[0] / limit - 1.0, of[1] / limit - 1.0};
  };
  EXPECT_GT(test::Orders("yielding waves: friction by ploughing", errors(friction)).overall, 1.7);
  EXPECT_GT(test::Orders("yielding waves: plastic work", errors(plastic)).overall, 1.7);
  EXPECT_GT(test::Orders("yielding waves: balance of the energies", balances).overall, 1.7);
  test::expect_close("yielding waves, 64 cells: error of the energy balance", balances.back(), 0.0, 5e-3,
                     "bound: cells and steps");
  test::expect_within("yielding waves: friction by ploughing of 32 cells, share of the limit",
                      1.0 + errors(friction)[1], 0.85, 0.95, "second order from 64 cells");
  test::expect_within("yielding waves: plastic work of 32 cells, share of the limit", 1.0 + errors(plastic)[1], 0.93,
                      0.98, "second order from 64 cells");
  EXPECT_GT(
      test::Orders("yielding waves: change of the contact fraction", {contact[1] - contact[0], contact[2] - contact[1]})
          .overall,
      1.7);
  test::expect_close("yielding waves: contact fraction of 32 cells over that of 64, less 1",
                     contact[1] / contact[2] - 1.0, 0.0, 5e-3, "an edge of the contact is known to a share of a cell");
}

TEST(Sliding, SurfacesRunIn)
{
  // What yields in a stroke hardens, and is lower in the next.
  SlidingCase c = yielding_waves(16);
  c.strokes = 4;
  const SlidingRun run = computed(c);
  const auto& strokes = run.summary.strokes;
  ASSERT_EQ(strokes.size(), 4U);
  for (std::size_t i = 1; i < strokes.size(); ++i)
  {
    EXPECT_LT(strokes[i].dissipation_plastic, strokes[i - 1].dissipation_plastic) << i;
    EXPECT_LE(strokes[i].rms_height_lower, strokes[i - 1].rms_height_lower * 1.001) << i;
  }
  test::expect_within("plastic work of the fourth stroke over that of the first",
                      strokes[3].dissipation_plastic / strokes[0].dissipation_plastic, 0.0, 0.5, "shakedown");
}

/// Two random surfaces of the two steels, the upper one half as steep.
SlidingCase yielding_random_surfaces(double rms_slope)
{
  SlidingCase c = yielding_waves(24);
  const auto surface = [](double slope, std::uint64_t seed)
  {
    return simulation::RandomSurface({.rms_slope = slope,
                                      .rolloff = 0.5 * wavelength,
                                      .cutoff = 0.25 * wavelength,
                                      .size_x = wavelength,
                                      .size_y = wavelength,
                                      .seed = seed});
  };
  c.lower.texture = surface(rms_slope, 1);
  c.upper.texture = surface(0.5 * rms_slope, 2);
  c.shift = wavelength / 12;
  c.strokes = 5;
  return c;
}

TEST(Sliding, ShakesDownWhateverTheRoughness)
{
  // Each stroke goes once round the period, so that the same peaks meet again in the next: what has yielded has hardened and is lower, and
  // each stroke finds less to do, until nothing yields. Steeper surfaces under the same load have smaller patches, and take longer.
  double before = 0.0;
  for (const double slope : {0.01, 0.02, 0.04})
  {
    const auto strokes = computed(yielding_random_surfaces(slope)).summary.strokes;
    for (std::size_t i = 1; i < strokes.size(); ++i)
      EXPECT_LT(strokes[i].dissipation_plastic, 0.3 * strokes[i - 1].dissipation_plastic) << slope << ' ' << i;
    const double left = strokes.back().dissipation_plastic / strokes.front().dissipation_plastic;
    test::expect_within("rms slope " + std::to_string(slope).substr(0, 4) +
                            ": plastic work of the fifth stroke over that of the first",
                        left, 0.0, std::pow(0.3, 4), "elastic shakedown: each stroke at most 0.3 of that before");
    EXPECT_GT(left, before) << "steeper surfaces take longer";
    before = left;
    // Peaks are lower, valleys are as they were.
    EXPECT_LT(strokes.back().peak_height_lower, strokes.front().peak_height_lower * 1.001) << slope;
  }
}

TEST(Sliding, ConvergesWithTheStep)
{
  // On the same cells; shifts of whole cells, so that nothing is interpolated. The limit is where two orders lead from the last two.
  std::vector<double> friction, plastic;
  for (const int cells_per_step : {4, 2, 1})
  {
    SlidingCase c = yielding_waves(slow_build ? 16 : 32);
    c.shift = cells_per_step * wavelength / c.domain.x.cells;
    const SlidingStroke stroke = computed(c).summary.strokes[0];
    friction.push_back(stroke.friction_ploughing);
    plastic.push_back(stroke.dissipation_plastic);
  }
  const auto changes = [](const std::vector<double>& of) { return std::vector{of[1] - of[0], of[2] - of[1]}; };
  EXPECT_GT(test::Orders("step: change of the friction by ploughing", changes(friction)).last, 1.0);
  EXPECT_GT(test::Orders("step: change of the plastic work", changes(plastic)).last, 0.8);
}

} // namespace
} // namespace brinell::verification::sliding_test
