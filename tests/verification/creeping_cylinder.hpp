// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scenario_runs.hpp"

#include <cstddef>
#include <limits>
#include <numbers>

/// An elastic cylinder that rolls with creepage: Carter's (1926) contact.
namespace brinell::verification
{

/// The last step in which the contact moved.
inline const simulation::RollingRecord& at_the_end(const simulation::RollingCase& c, const RollingRun& run)
{
  return run.history[run.history.size() - 1 - static_cast<std::size_t>(c.load_steps)];
}

/// A cylinder of 1 m on a flat in plane strain, both elastic and alike; a is half the width of the contact.
struct Cylinder
{
  static constexpr double R = 1.0, G = 80e9, nu = 0.3, a = 0.01;
  static double modulus() { return G / (1.0 - nu); } ///< E', of both
  static double load_per_length() { return 0.25 * std::numbers::pi * modulus() * a * a / R; }

  static simulation::RollingCase rolling(double cells, double friction, double creepage)
  {
    simulation::RollingCase c;
    c.domain.y = {Boundary::periodic, 1.0, 1};
    c.domain.reference = 2.0 * a; // the nearer, the sooner the rolling is steady
    c.lower = {simulation::Plane{}, {{2.0 * (1.0 + nu) * G, nu}, {}}};
    c.upper = {simulation::Roller{R, std::numeric_limits<double>::infinity()}, c.lower.material};
    c.drive = load(load_per_length());
    c.friction.coefficient = friction;
    c.creepage = {creepage, 0.0, 0.0};
    c.distance = 20.0 * a;             // of steps of a cell, an even number of them
    c.spacing = {{a / cells, 1.0, a}}; // nothing yields: layers mean nothing
    c.load_steps = 2;
    return c;
  }
};

} // namespace brinell::verification
