// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/effects.hpp"

namespace brinell::elastoplastic
{

namespace
{

struct Between
{
  const halfspace::SurfaceCompliance& compliance;
  const SurfaceGrid &lower, &upper;
  double modulus;
  const Current::Materials& materials;
};

/// An effect: its name, when it acts, and how it is made.
struct Kind
{
  std::string_view name;
  bool (*acts)(const Effects&, const Current::Materials&);
  std::unique_ptr<Effect> (*make)(const Effects&, const Between&);
};

constexpr std::array kinds{
    Kind{"wear", [](const Effects& s, const Current::Materials&) { return s.wear.wears(); },
         [](const Effects& s, const Between& b) -> std::unique_ptr<Effect>
         { return std::make_unique<Wear>(b.compliance.grid(), b.lower, b.upper, s.wear, b.modulus); }},
    Kind{"current", [](const Effects&, const Current::Materials& materials) { return Current::flows(materials); },
         [](const Effects& s, const Between& b) -> std::unique_ptr<Effect>
         { return std::make_unique<Current>(b.compliance, b.modulus, b.materials, s.current); }},
};

} // namespace

std::vector<std::string_view> names_of(const Effects& settings, const Current::Materials& materials)
{
  std::vector<std::string_view> names;
  for (const Kind& kind : kinds)
    if (kind.acts(settings, materials))
      names.push_back(kind.name);
  return names;
}

std::vector<std::unique_ptr<Effect>> make_effects(const Effects& settings,
                                                  const halfspace::SurfaceCompliance& compliance,
                                                  const SurfaceGrid& lower, const SurfaceGrid& upper, double modulus,
                                                  const Current::Materials& materials)
{
  std::vector<std::unique_ptr<Effect>> effects;
  for (const Kind& kind : kinds)
    if (kind.acts(settings, materials))
      effects.push_back(kind.make(settings, {compliance, lower, upper, modulus, materials}));
  return effects;
}

std::span<const double> values_of(const EffectField& field, std::span<const std::unique_ptr<Effect>> effects,
                                  std::size_t side)
{
  for (const std::unique_ptr<Effect>& effect : effects)
    if (effect->name() == field.effect)
      return field.values(*effect, side);
  return {};
}

} // namespace brinell::elastoplastic
