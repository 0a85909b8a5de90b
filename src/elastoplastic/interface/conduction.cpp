// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/conduction.hpp"

#include "brinell/elastoplastic/effects.hpp"

#include <algorithm>
#include <utility>

namespace brinell::elastoplastic
{

namespace
{

/// 1/conductivity of a body and its layers [K m/W]; without thermal constants by Wiedemann and Franz.
ConductiveStack resistances_to_heat(const constitutive::Material& material)
{
  const auto by_current = [&](const constitutive::Electrical& electrical)
  {
    return 1.0 / contact::HotConductor{.resistivity = electrical.resistivity,
                                       .temperature_coefficient = electrical.temperature_coefficient}
                     .conductivity_at(material.temperature);
  };
  ConductiveStack stack{{}, material.thermal ? 1.0 / material.thermal->conductivity : by_current(*material.electrical)};
  stack.layers.reserve(material.layers.size());
  for (const constitutive::Coat& layer : material.layers)
    stack.layers.push_back(
        {layer.thickness, layer.thermal ? 1.0 / layer.thermal->conductivity : by_current(*layer.electrical)});
  return stack;
}

} // namespace

Conduction::Conduction(const halfspace::SurfaceCompliance& compliance, double modulus,
                       const Current::Materials& materials, const Current* current)
    : layered_(layered_conductors(compliance, materials, &resistances_to_heat)),
      spreading_(resistances_to_heat(*materials[0]).top() + resistances_to_heat(*materials[1]).top()),
      constriction_(layered_ ? contact::Constriction::of_layers(*layered_, spreading_, modulus)
                             : contact::Constriction(compliance, modulus)),
      current_(current)
{
}

bool Conduction::is_known(const Current::Materials& materials)
{
  return std::all_of(materials.begin(), materials.end(),
                     [](const constitutive::Material* material) { return material->electrical || material->thermal; });
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
