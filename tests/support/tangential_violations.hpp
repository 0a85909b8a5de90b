// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/tangential_contact.hpp"
#include "shear_fields.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::contact
{

/// What a step must meet, from products with the compliance alone.
struct Violations
{
  double bound = 0.0;    ///< of the size of the shear [Pa]
  double slip = 0.0;     ///< where it sticks, and across or against the shear elsewhere [m]
  double reported = 0.0; ///< slip of the report against that of its shears and its shift [m]
};

inline Violations violations(const halfspace::SurfaceCompliance& compliance, const TangentialStep& step,
                             const TangentialReport& report, const Fields& shear, const Fields& slip)
{
  const SurfaceGrid& g = compliance.grid();
  Fields added(g.size()), u(g.size());
  for (std::size_t i = 0; i < g.size(); ++i)
  {
    added.x[i] = shear.x[i] - (step.before[0].empty() ? 0.0 : step.before[0][i]);
    added.y[i] = shear.y[i] - (step.before[1].empty() ? 0.0 : step.before[1][i]);
  }
  compliance.apply({.shear_x = added.x, .shear_y = added.y}, {.x = u.x, .y = u.y});
  Violations worst;
  for (int j = 0; j < g.ny; ++j)
    for (int i = 0; i < g.nx; ++i)
    {
      const std::size_t c = g.index(i, j);
      const double q = std::hypot(shear.x[c], shear.y[c]);
      worst.bound = std::max(worst.bound, q - step.bound[c]);
      if (!(step.bound[c] > 0.0))
        continue;
      const double sx =
          report.shift[0] - step.drive.spin * g.y(j) - u.x[c] - (step.change[0].empty() ? 0.0 : step.change[0][c]);
      const double sy =
          report.shift[1] + step.drive.spin * g.x(i) - u.y[c] - (step.change[1].empty() ? 0.0 : step.change[1][c]);
      worst.reported = std::max(worst.reported, std::hypot(sx - slip.x[c], sy - slip.y[c]));
      const double along =
          q >= slip_threshold * step.bound[c] ? std::max(0.0, sx * shear.x[c] + sy * shear.y[c]) / (q * q) : 0.0;
      worst.slip = std::max(worst.slip, std::hypot(sx - along * shear.x[c], sy - along * shear.y[c]));
    }
  return worst;
}

} // namespace brinell::contact
