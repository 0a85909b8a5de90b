// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/effects.hpp"

namespace brinell::elastoplastic
{

std::vector<std::string_view> names_of(const Effects& settings)
{
  std::vector<std::string_view> names;
  if (settings.wear.wears())
    names.emplace_back("wear");
  return names;
}

std::vector<std::unique_ptr<Effect>> make_effects(const Effects& settings, const SurfaceGrid& contact,
                                                  const SurfaceGrid& lower, const SurfaceGrid& upper, double modulus)
{
  std::vector<std::unique_ptr<Effect>> effects;
  if (settings.wear.wears())
    effects.push_back(std::make_unique<Wear>(contact, lower, upper, settings.wear, modulus));
  return effects;
}

} // namespace brinell::elastoplastic
