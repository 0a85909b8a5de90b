// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenarios.hpp"
#include "random_field.hpp"

#include <algorithm>
#include <cmath>
#include <random>

/// Random but possible cases of each scenario.
namespace brinell::verification
{

/// Random numbers that depend on a seed only.
class Draw
{
public:
  explicit Draw(unsigned seed) : engine_(seed) {}
  double between(double a, double b) { return test::uniform(engine_, a, b); }
  double power_of_ten(double a, double b) { return std::pow(10.0, between(a, b)); }
  bool chance(double p) { return between(0.0, 1.0) < p; }
  /// 0 ... n - 1
  int below(int n) { return std::min(n - 1, static_cast<int>(between(0.0, n))); }

private:
  std::mt19937_64 engine_;
};

/// Interferences of 0.5 to 20 times first yield, as long as the contact is small beside the bodies.
[[nodiscard]] simulation::TuggingCase random_tugging(Draw& draw);
[[nodiscard]] simulation::IndentationCase random_indentation(Draw& draw);
[[nodiscard]] simulation::RollingCase random_rolling(Draw& draw);
/// Tugging with friction.
[[nodiscard]] simulation::TuggingCase random_rubbing(Draw& draw);
/// Rolling with friction and slip everywhere.
[[nodiscard]] simulation::RollingCase random_skidding(Draw& draw);
/// Stick and slip with creepages from small ones to those at which all slips, in steps of one or two cells.
[[nodiscard]] simulation::RollingCase random_creeping(Draw& draw);
/// With the heat of friction: tugging, and rolling with slip everywhere or with creepage.
[[nodiscard]] simulation::TuggingCase random_hot_rubbing(Draw& draw);
[[nodiscard]] simulation::RollingCase random_hot_skidding(Draw& draw);
[[nodiscard]] simulation::RollingCase random_hot_creeping(Draw& draw);
/// Stick and slip to and fro along any direction, from displacements far below that at which all slides to several times that,
/// or by forces up to nearly that; some with a given limit of the shear.
[[nodiscard]] simulation::FrettingCase random_fretting(Draw& draw);
[[nodiscard]] simulation::FrettingCase random_hot_fretting(Draw& draw); ///< with the heat of friction
/// With wear of one or both surfaces, from a thousandth of the approach to three times as much in a pass or a cycle; half of the
/// cases with the heat of friction, too.
[[nodiscard]] simulation::TuggingCase random_worn_rubbing(Draw& draw);
[[nodiscard]] simulation::RollingCase random_worn_skidding(Draw& draw);
[[nodiscard]] simulation::RollingCase random_worn_creeping(Draw& draw);
[[nodiscard]] simulation::FrettingCase random_worn_fretting(Draw& draw);

/// Gives both bodies resistivities, which may grow with temperature, and drives a current by a voltage or as such, or none; half of
/// the cases have a film between the surfaces, which may grow. Drives may vary with the steps, and soften the bodies around the spots.
void add_current(Draw& draw, simulation::Numerics& numerics, constitutive::Material& lower,
                 constitutive::Material& upper);

} // namespace brinell::verification
