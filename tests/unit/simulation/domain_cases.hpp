// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/indentation.hpp"
#include "scenario_checks.hpp"

#include <limits>

/// Bodies in a period, and how their plans are refused.
namespace brinell::simulation::cases
{

constexpr double radius = 10e-3; // of the cylinder [m]
inline const Elastic steel{200e9, 0.3};

inline contact::Drive load(double newton)
{
  return {contact::Drive::Kind::load, newton};
}
inline contact::Drive approach(double metre)
{
  return {contact::Drive::Kind::approach, metre};
}

/// A cylinder of 10 mm without ends on a flat, in plane strain.
inline IndentationCase cylinder(const contact::Drive& drive, double reference = 0.0)
{
  IndentationCase c;
  c.lower = {Plane{}, {steel, {}}};
  c.upper = {Roller{radius, std::numeric_limits<double>::infinity()}, {steel, {}}};
  c.domain.y = {Boundary::periodic, 1.0, 1};
  c.domain.reference = reference;
  c.sequence = {drive};
  return c;
}

} // namespace brinell::simulation::cases
