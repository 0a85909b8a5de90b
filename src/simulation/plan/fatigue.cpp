// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/fatigue.hpp"

#include "brinell/simulation/scenario.hpp"

#include <utility>

namespace brinell::simulation
{

double memory_of_fatigue(const Plan& plan, const ShapedBody& lower, const ShapedBody& upper)
{
  // Samples of the independent rows; strain now and when the cycle began, the trace of the stress in waves and on the grid; results.
  constexpr double of_number = sizeof(float) * (fatigue_samples + 2.0), of_state = 96.0,
                   of_results = 8.0 * fatigue_fields.size();
  double bytes = 0.0;
  for (const auto& [body, grid] : {std::pair{&lower, &plan.lower}, {&upper, &plan.upper}})
    if (body->fatigue && !body->material.elastic.is_rigid())
    {
      const bool has_strain = body->fatigue->criterion == constitutive::Fatigue::Criterion::fatemi_socie;
      const double independent = static_cast<double>(grid->surface.independent_cells()) * grid->nz;
      bytes += independent * ((has_strain ? 11.0 : 6.0) * of_number + of_state) +
               static_cast<double>(grid->size()) * of_results;
    }
  return bytes;
}

} // namespace brinell::simulation
