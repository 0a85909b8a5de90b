// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/estimates.hpp"

#include "brinell/reference/hertz.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brinell::simulation
{

namespace
{

/// Time of one evaluation of a grid [s]: proportional to N log N of the padded grid, in which open axes are twice as long.
double evaluation_seconds(const SurfaceGrid& surface, std::size_t cells)
{
  constexpr double per_cell_level = 1e-9; // [s], measured: 0.4e-9 to 1.1e-9, and 2e-9 in very short runs
  const double padding = (surface.is_periodic_x() ? 1.0 : 2.0) * (surface.is_periodic_y() ? 1.0 : 2.0);
  const double points = padding * static_cast<double>(cells);
  return points * std::log2(points + 2.0) * per_cell_level;
}

} // namespace

double rough_seconds(const Plan& plan, const constitutive::Material& lower, const constitutive::Material& upper,
                     const Work& work)
{
  constexpr double of_elastic_body = 0.05, of_heat = 2.5, of_output = 4.0; // relative to an evaluation of a body
  constexpr double of_contact = 25.0;  // likewise of a layer: contact in a step in which nothing can yield
  constexpr double write_rate = 1.5e8; // [bytes/s]
  const bool can_yield = lower.is_plastic() || upper.is_plastic();
  double step = can_yield ? 0.0 : of_contact * evaluation_seconds(plan.contact, plan.contact.size()), output = 0.0;
  for (const auto& [body, grid] : {std::pair{&lower, &plan.lower}, std::pair{&upper, &plan.upper}})
  {
    if (!body->elastic.is_rigid())
      output += of_output * evaluation_seconds(grid->surface, grid->size());
    if (grid == &plan.upper && plan.twin != elastoplastic::Twin::none)
      continue;
    const std::size_t columns = work.yields_along_the_track ? grid->surface.size() : plan.contact.size();
    const double evaluations = (body->is_plastic() ? 1.0
                                : can_yield        ? of_elastic_body
                                                   : 0.0) *
                                   work.evaluations +
                               (body->thermal ? of_heat : 0.0);
    step += evaluations * evaluation_seconds(grid->surface, columns * static_cast<std::size_t>(plan.layers));
  }
  constexpr double symmetric_share = 0.6; // time for half of a body over that for the whole body
  return (plan.symmetry == Symmetry::none ? 1.0 : symmetric_share) * plan.steps * step + work.states_within * output +
         work.stored_bytes / write_rate;
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
