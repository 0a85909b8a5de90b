// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/reference/critical.hpp"

#include "brinell/reference/hertz.hpp"
#include "reference/require.hpp"

#include <cmath>
#include <numbers>

namespace brinell::reference
{

double critical_pressure_ratio(double poisson_ratio)
{
  if (poisson_ratio < 0.0) // outside of the fit
    return first_yield(poisson_ratio).pressure_ratio;
  return 1.30075 + poisson_ratio * (0.87825 + poisson_ratio * 0.54373);
}

namespace
{

void require_yield(double radius, double contact_modulus, double C, double yield_stress)
{
  require_positive(radius, "radius");
  require_positive(contact_modulus, "contact modulus");
  require_positive(C, "C = p0/S_y at first yield");
  require_positive(yield_stress, "yield stress");
}

} // namespace

CriticalValues critical_values(double radius, double contact_modulus, double C, double yield_stress)
{
  require_yield(radius, contact_modulus, C, yield_stress);
  const double peak_pressure = C * yield_stress;
  const double slope = 0.5 * std::numbers::pi * peak_pressure / contact_modulus; // a_c / R
  const double interference = slope * slope * radius;
  const double load = 4.0 / 3.0 * contact_modulus * std::sqrt(radius * interference) * interference;
  return {.C = C,
          .interference = interference,
          .load = load,
          .energy = 0.4 * load * interference,
          .contact_radius = slope * radius,
          .contact_area = std::numbers::pi * slope * slope * radius * radius,
          .peak_pressure = peak_pressure};
}

CriticalValues critical_values(double radius, double contact_modulus, double C, double yield_stress, const Line& line)
{
  require_yield(radius, contact_modulus, C, yield_stress);
  require_positive(line.length, "length");
  const double peak_pressure = C * yield_stress;
  const double load_per_length = std::numbers::pi * radius * peak_pressure * peak_pressure / contact_modulus;
  const LineContact contact = line_contact_at_load(radius, contact_modulus, load_per_length);
  return {.C = C,
          .interference = line_contact_approach(contact, contact_modulus, line.reference),
          .load = load_per_length * line.length,
          .energy = line_contact_work(contact, contact_modulus, line.reference) * line.length,
          .contact_radius = contact.half_width,
          .contact_area = 2.0 * contact.half_width * line.length,
          .peak_pressure = peak_pressure};
}

} // namespace brinell::reference
