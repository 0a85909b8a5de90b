// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/conduction.hpp"

#include "brinell/elastoplastic/effects.hpp"

#include <algorithm>
#include <utility>

namespace brinell::elastoplastic
{

Conduction::Conduction(const halfspace::SurfaceCompliance& compliance, double modulus,
                       const Current::Materials& materials, const Current* current)
    : constriction_(compliance, modulus), spreading_(0.0), current_(current)
{
  for (const constitutive::Material* material : materials)
    spreading_ += 1.0 / (material->thermal ? material->thermal->conductivity
                                           : conductor(*material).conductivity_at(material->temperature));
}

bool Conduction::is_known(const Current::Materials& materials)
{
  return std::all_of(materials.begin(), materials.end(),
                     [](const constitutive::Material* material)
                     { return material->layers.empty() && (material->thermal || material->electrical); });
}

void Conduction::commit(const Interaction& found, const Placement& /*placement*/)
{
  if (const auto clean = current_ ? current_->clean_conductance() : std::nullopt)
  {
    state_.conductance = *clean / spreading_;
    return;
  }
  contact::Flow flow = constriction_.flow({found.pressure(), found.gap()}, spreading_, {}, std::move(state_.density));
  state_.conductance = flow.conductance;
  state_.density = std::move(flow.density);
}

void Conduction::report(EffectTotals& totals) const
{
  totals.thermal_contact_conductance = state_.conductance;
}

void Conduction::embed(const Effect& smaller_grids)
{
  state_ = dynamic_cast<const Conduction&>(smaller_grids).state_;
  state_.density.clear(); // found anew by the increment that follows
}

} // namespace brinell::elastoplastic
