// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/first_yield.hpp"

#include "brinell/reference/critical.hpp"

#include <algorithm>

namespace brinell::simulation
{

namespace
{

using constitutive::Material;

/// Of one body; empty if it stays elastic.
std::optional<PairYield> yield_of(const Material& material, double factor, YieldsFirst body)
{
  if (!material.is_plastic())
    return std::nullopt;
  return PairYield{reference::critical_pressure_ratio(material.elastic.poisson_ratio),
                   factor * constitutive::initial_yield_stress(*material.hardening), body};
}

std::optional<PairYield> weaker(const std::optional<PairYield>& lower, const std::optional<PairYield>& upper)
{
  if (!lower || !upper)
    return lower ? lower : upper;
  PairYield weaker = lower->peak_pressure() <= upper->peak_pressure() ? *lower : *upper;
  if (lower->peak_pressure() == upper->peak_pressure())
    weaker.body = YieldsFirst::both;
  return weaker;
}

} // namespace

std::optional<PairYield> nominal_yield(const Material& lower, const Material& upper)
{
  return weaker(yield_of(lower, 1.0, YieldsFirst::lower), yield_of(upper, 1.0, YieldsFirst::upper));
}

std::optional<PairYield> earliest_yield(const Material& lower, const Material& upper)
{
  return weaker(yield_of(lower, smallest_yield_factor(lower), YieldsFirst::lower),
                yield_of(upper, smallest_yield_factor(upper), YieldsFirst::upper));
}

double smallest_yield_factor(const Material& material)
{
  // Linear between its points and constant beyond them, a profile is smallest at one of them.
  const constitutive::DepthProfile& profile = material.yield_factor;
  double smallest = profile.depth().empty() ? 1.0 : profile.at(profile.depth().front(), 1.0);
  for (const double z : profile.depth())
    smallest = std::min(smallest, profile.at(z, 1.0));
  return smallest;
}

} // namespace brinell::simulation
