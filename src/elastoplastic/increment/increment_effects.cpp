// SPDX-License-Identifier: BSD-3-Clause
#include "contact_parts.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>

/// Effects between the surfaces in an increment: docs/theory/elastoplastic.md (wear).
namespace brinell::elastoplastic
{

namespace
{

/// Sums the compliances of the effects.
void find_compliance(ContactParts& c)
{
  const auto has = [](const std::unique_ptr<Effect>& effect) { return !effect->compliance().empty(); };
  if (std::none_of(c.effects.begin(), c.effects.end(), has))
    return;
  c.compliance_of_effects.assign(c.state.pressure.size(), 0.0);
  for (const std::unique_ptr<Effect>& effect : c.effects)
    for (std::size_t i = 0; i < effect->compliance().size(); ++i)
      c.compliance_of_effects[i] += effect->compliance()[i];
}

} // namespace

Interaction interaction(const ContactParts& c)
{
  return {c.interface.get(), c.state.pressure, c.slid};
}

const Wear* CoupledContact::wear() const
{
  const ContactParts& c = *parts_;
  for (const std::unique_ptr<Effect>& one : c.effects)
    if (const auto* found = dynamic_cast<const Wear*>(one.get()))
      return found;
  return nullptr;
}

void begin_effects(ContactParts& c)
{
  const Interaction before = interaction(c);
  for (const std::unique_ptr<Effect>& effect : c.effects)
    effect->begin(before);
  find_compliance(c);
}

double evaluate_effects(ContactParts& c)
{
  const Interaction trial = interaction(c);
  double change = 0.0;
  for (const std::unique_ptr<Effect>& effect : c.effects)
    change = larger(change, effect->evaluate(trial));
  find_compliance(c);
  return change;
}

double largest_depth_of_effects(const ContactParts& c)
{
  double depth = 0.0;
  for (const std::unique_ptr<Effect>& effect : c.effects)
    depth = std::max(depth, effect->largest_depth());
  return depth;
}

} // namespace brinell::elastoplastic
