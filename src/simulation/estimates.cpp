// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/estimates.hpp"

#include "brinell/reference/hertz.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brinell::simulation
{

double rough_seconds(const Plan& plan, const constitutive::Material& lower, const constitutive::Material& upper,
                     const Work& work)
{
  constexpr double seconds_per_cell_level = 4e-9; // one cell, one evaluation, one level of the transforms
  constexpr double elastic_share = 0.05;          // of the contact in an evaluation
  const auto box =
      static_cast<double>(work.yields_along_the_track ? std::max(plan.lower.size(), plan.upper.size())
                                                      : plan.contact.size() * static_cast<std::size_t>(plan.lower.nz));
  const double cells = 4.0 * box; // zero padding
  const int plastic_bodies = (lower.is_plastic() ? 1 : 0) + (upper.is_plastic() ? 1 : 0);
  const double solved = plan.twin != elastoplastic::Twin::none ? 1.0 : plastic_bodies + elastic_share;
  constexpr double symmetric_share = 0.6; // of the whole in half of it
  const double half = plan.symmetry == Symmetry::none ? 1.0 : symmetric_share;
  return half * plan.steps * solved * work.evaluations * cells * std::log2(cells + 2.0) * seconds_per_cell_level;
}

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
