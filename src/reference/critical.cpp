// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/reference/critical.hpp"

#include "reference/require.hpp"

#include <cmath>
#include <numbers>

namespace brinell::reference
{

double critical_pressure_ratio(double poisson_ratio)
{
  return 1.30075 + poisson_ratio * (0.87825 + poisson_ratio * 0.54373);
}

CriticalValues critical_values(double radius, double contact_modulus, double C, double yield_stress)
{
  require_positive(radius, "radius");
  require_positive(contact_modulus, "contact modulus");
  require_positive(C, "C = p0/S_y at first yield");
  require_positive(yield_stress, "yield stress");
  const double peak_pressure = C * yield_stress;
  const double slope = 0.5 * std::numbers::pi * peak_pressure / contact_modulus; // a_c / R
  const double interference = slope * slope * radius;
  const double load = 4.0 / 3.0 * contact_modulus * std::sqrt(radius * interference) * interference;
  return {.C = C,
          .interference = interference,
          .load = load,
          .energy = 0.4 * load * interference,
          .contact_radius = slope * radius,
          .peak_pressure = peak_pressure};
}

} // namespace brinell::reference
