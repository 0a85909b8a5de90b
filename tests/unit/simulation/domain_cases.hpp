// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/indentation.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

/// Bodies in a period, and how their plans are refused.
namespace brinell::simulation::test
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

/// The key that a plan is refused for, and a part of the message.
template <typename ScenarioCase>
void expect_refused(const ScenarioCase& c, const std::string& key, const std::string& part)
{
  try
  {
    static_cast<void>(plan(c));
    ADD_FAILURE() << "not refused: " << part;
  }
  catch (const KeyError& error)
  {
    EXPECT_EQ(error.key(), key);
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << part << "\n  in: " << error.what();
  }
}

} // namespace brinell::simulation::test
