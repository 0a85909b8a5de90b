// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/increment.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>

/// Effects between the surfaces in an increment: docs/theory/elastoplastic.md (wear).
namespace brinell::elastoplastic
{

/// Pressure, shear and slip of the present trial.
Interaction CoupledContact::interaction() const
{
  return {interface_.get(), pressure_, slid_};
}

const Wear* CoupledContact::wear() const
{
  for (const std::unique_ptr<Effect>& one : effects_)
    if (const auto* found = dynamic_cast<const Wear*>(one.get()))
      return found;
  return nullptr;
}

void CoupledContact::begin_effects()
{
  const Interaction before = interaction();
  for (const std::unique_ptr<Effect>& effect : effects_)
    effect->begin(before);
  find_compliance();
}

/// Lets the effects follow the trial.
/// @returns the largest change of the gap by one of them [m]
double CoupledContact::evaluate_effects()
{
  const Interaction trial = interaction();
  double change = 0.0;
  for (const std::unique_ptr<Effect>& effect : effects_)
    change = larger(change, effect->evaluate(trial));
  find_compliance();
  return change;
}

/// Sums the compliances of the effects.
void CoupledContact::find_compliance()
{
  const auto has = [](const std::unique_ptr<Effect>& effect) { return !effect->compliance().empty(); };
  if (std::none_of(effects_.begin(), effects_.end(), has))
    return;
  compliance_of_effects_.assign(pressure_.size(), 0.0);
  for (const std::unique_ptr<Effect>& effect : effects_)
    for (std::size_t i = 0; i < effect->compliance().size(); ++i)
      compliance_of_effects_[i] += effect->compliance()[i];
}

double CoupledContact::largest_depth_of_effects() const
{
  double depth = 0.0;
  for (const std::unique_ptr<Effect>& effect : effects_)
    depth = std::max(depth, effect->largest_depth());
  return depth;
}

} // namespace brinell::elastoplastic
