// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/effects.hpp"

namespace brinell::elastoplastic
{

std::vector<std::string_view> names_of(const Effects& settings, const Current::Materials& materials)
{
  std::vector<std::string_view> names;
  if (settings.wear.wears())
    names.emplace_back("wear");
  if (Current::flows(materials))
    names.emplace_back("current");
  return names;
}

std::vector<std::unique_ptr<Effect>> make_effects(const Effects& settings,
                                                  const halfspace::SurfaceCompliance& compliance,
                                                  const SurfaceGrid& lower, const SurfaceGrid& upper, double modulus,
                                                  const Current::Materials& materials)
{
  std::vector<std::unique_ptr<Effect>> effects;
  if (settings.wear.wears())
    effects.push_back(std::make_unique<Wear>(compliance.grid(), lower, upper, settings.wear, modulus));
  if (Current::flows(materials))
    effects.push_back(std::make_unique<Current>(compliance, modulus, materials, settings.current));
  return effects;
}

} // namespace brinell::elastoplastic
