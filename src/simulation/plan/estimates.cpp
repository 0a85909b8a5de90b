// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/estimates.hpp"

#include "brinell/reference/hertz.hpp"

#include <cmath>
#include <numbers>

namespace brinell::simulation
{

double state_bytes(const Plan& plan, const constitutive::Material& lower, const constitutive::Material& upper)
{
  constexpr double fields_per_cell = 14.0;
  double numbers = 2.0 * static_cast<double>(plan.contact.size());
  for (const auto& [body, grid] : {std::pair{&lower, &plan.lower}, std::pair{&upper, &plan.upper}})
    if (!body->elastic.is_rigid())
      numbers += fields_per_cell * static_cast<double>(grid->size()) + static_cast<double>(grid->surface.size());
  return numbers * sizeof(double);
}

std::optional<double> load_of_peak_pressure(const Shape& lower, const Shape& upper, const Domain& domain,
                                            double contact_modulus, double peak_pressure)
{
  const auto k = relative_curvature(lower, upper);
  if (!k || !((*k)[0] > 0.0))
    return std::nullopt;
  const double length = line_length(lower, upper, domain);
  if ((*k)[1] == 0.0 && std::isfinite(length))
    return peak_pressure * peak_pressure * std::numbers::pi * length / ((*k)[0] * contact_modulus);
  if (!((*k)[1] > 0.0))
    return std::nullopt;
  const double of_one_newton =
      reference::elliptical_contact_at_load(1.0 / (*k)[0], 1.0 / (*k)[1], contact_modulus, 1.0).peak_pressure;
  return std::pow(peak_pressure / of_one_newton, 3);
}

} // namespace brinell::simulation
