// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/run.hpp"
#include "brinell/simulation/sliding.hpp"

#include <vector>

/// Sliding cases of several tests.
namespace brinell::simulation::cases
{

inline const constitutive::Material hard_steel{{210e9, 0.3}, constitutive::LinearHardening{1e9, 10e9}};
inline const constitutive::Material soft_steel{{120e9, 0.34}, constitutive::LinearHardening{0.4e9, 5e9}};

inline constexpr double period = 33e-6;
inline constexpr double cell = 1e-6; ///< of 33 in a period

/// Waves on both of two steels, in a period.
/// @param cells  along each axis of the period
/// @param steps  length of the stroke in cells
inline SlidingCase waves(int cells = 33, int steps = 6)
{
  SlidingCase c;
  c.lower = {Plane{}, soft_steel};
  c.upper = {Plane{}, hard_steel};
  c.lower.texture = Sinusoid{0.2e-6, period, period, 3e-6, -2e-6};
  c.upper.texture = Sinusoid{0.1e-6, period, 0.5 * period, -5e-6, 1e-6};
  c.domain.x = c.domain.y = {Boundary::periodic, period, cells};
  c.press = {contact::Drive::Kind::load, 0.2};
  c.press_steps = 2;
  c.distance = steps * period / cells;
  return c;
}

/// A ball on a flat with a dent.
inline SlidingCase ball()
{
  SlidingCase c;
  c.lower = {Plane{}, soft_steel};
  c.lower.texture = Dent{10e-6, 0.0, 0.1e-6, 7.5e-6};
  c.upper = {Paraboloid{1e-3, 1e-3}, hard_steel};
  c.press = {contact::Drive::Kind::load, 2.0};
  c.press_steps = 1;
  c.distance = 60e-6;
  c.resolution = 4.0;
  return c;
}

/// What a whole run gives.
struct SlidingResult
{
  std::vector<SlidingRecord> history;
  SlidingSummary summary;
};

inline SlidingResult computed(const SlidingCase& c)
{
  SlidingResult result;
  Run run(c);
  while (!run.is_done())
    result.history.push_back(run.step());
  result.summary = run.summary();
  return result;
}

} // namespace brinell::simulation::cases
