// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/quality/quality.hpp"
#include "brinell/simulation/estimates.hpp"
#include "brinell/simulation/scenarios.hpp"

#include <string>
#include <vector>

/// A case whose quality is judged, before and after a run.
namespace brinell::quality
{

using namespace simulation;

/// A ball on a flat that yields; the contact is about 0.2 mm wide.
inline RollingCase ball_on_flat()
{
  RollingCase c;
  c.lower = {Plane{}, {{210e9, 0.3}, constitutive::PerfectPlasticity{1e9}}};
  c.upper = {Paraboloid{5e-3, 5e-3}, {{210e9, 0.3}, {}}};
  c.drive = {contact::Drive::Kind::load, 150.0};
  c.distance = 1e-3;
  return c;
}

/// What a run with good cells has seen.
inline RunTotals good_totals(const RollingCase& c)
{
  const RollingPlan p = plan(c);
  RunTotals t;
  t.coverage = {static_cast<int>(2.0 * p.half_width_x / p.contact.dx),
                static_cast<int>(2.0 * p.half_width_y / p.contact.dy), 20};
  t.max_equivalent_plastic_strain = 0.01;
  t.max_residual_lower = 1e-7;
  t.energy_balance_error = 1e-3;
  return t;
}

inline std::vector<std::string> keys(const Quality& quality)
{
  std::vector<std::string> result;
  for (const Warning& warning : quality.warnings)
    result.push_back(warning.key);
  return result;
}

using Keys = std::vector<std::string>;

inline Keys before(const RollingCase& c)
{
  return keys(quality::expected(c, plan(c)));
}

inline Keys after(const RollingCase& c, const RunTotals& totals)
{
  return keys(quality::judged(c, plan(c), totals));
}

} // namespace brinell::quality
