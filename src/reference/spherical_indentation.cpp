// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/reference/spherical_indentation.hpp"

#include "reference/require.hpp"

#include <cmath>
#include <numbers>

namespace brinell::reference
{
namespace
{

constexpr double jackson_green_limit = 1.9; ///< below it, the contact follows Hertz

/// S_y/E' with E' = E/(1 - nu^2), because the flat is rigid.
double yield_strain(const IndentedSphere& sphere)
{
  return sphere.yield_stress * sphere.elastic.contact_compliance();
}

void require_valid(double interference_ratio, const IndentedSphere& sphere)
{
  require_not_negative(interference_ratio, "interference over its critical value");
  require_positive(sphere.yield_stress, "yield stress");
  require_positive(sphere.elastic.young_modulus, "Young's modulus");
  require_within(sphere.elastic.poisson_ratio, -1.0, 0.5, "Poisson's ratio");
}

/// H/S_y at a contact area over the critical one; a/R = a_c/R sqrt(A/A_c), a_c/R = pi C S_y/(2 E').
double hardness_ratio(double area_ratio, const IndentedSphere& sphere)
{
  const double C = jackson_green_pressure_ratio(sphere.elastic.poisson_ratio);
  const double critical = 0.5 * std::numbers::pi * C * yield_strain(sphere);
  return 2.84 - 0.92 * (1.0 - std::cos(std::numbers::pi * critical * std::sqrt(area_ratio)));
}

} // namespace

double jackson_green_pressure_ratio(double poisson_ratio)
{
  return 1.295 * std::exp(0.736 * poisson_ratio);
}

double jackson_green_area(double interference_ratio, const IndentedSphere& sphere)
{
  require_valid(interference_ratio, sphere);
  if (interference_ratio < jackson_green_limit)
    return interference_ratio;
  const double B = 0.14 * std::exp(23.0 * yield_strain(sphere));
  return interference_ratio * std::pow(interference_ratio / jackson_green_limit, B);
}

double jackson_green_load(double interference_ratio, const IndentedSphere& sphere)
{
  const double w = interference_ratio;
  const double area_ratio = jackson_green_area(w, sphere);
  if (w < jackson_green_limit)
    return w * std::sqrt(w);
  const double C = jackson_green_pressure_ratio(sphere.elastic.poisson_ratio);
  const double elastic = std::exp(-0.25 * std::pow(w, 5.0 / 12.0)) * w * std::sqrt(w);
  const double fully_plastic_share = -std::expm1(-std::pow(w, 5.0 / 9.0) / 25.0);
  return elastic + 4.0 * hardness_ratio(area_ratio, sphere) / C * fully_plastic_share * w;
}

double kogut_etsion_load(double interference_ratio)
{
  require_within(interference_ratio, 0.0, 110.0, "interference over its critical value");
  const double w = interference_ratio;
  if (w <= 1.0)
    return w * std::sqrt(w);
  return w <= 6.0 ? 1.03 * std::pow(w, 1.425) : 1.40 * std::pow(w, 1.263);
}

} // namespace brinell::reference
