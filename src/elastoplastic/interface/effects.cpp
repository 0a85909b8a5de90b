// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/effects.hpp"

namespace brinell::elastoplastic
{

namespace
{

/// Where an effect acts.
struct Site
{
  const halfspace::SurfaceCompliance& compliance;
  const VolumeGrid &lower, &upper;
  double modulus;
  const Current::Materials& materials;
  std::span<const std::unique_ptr<Effect>> before; ///< effects that have been made

  /// An effect made before; nullptr if it does not act.
  template <typename Kind>
  [[nodiscard]] const Kind* other() const
  {
    for (const std::unique_ptr<Effect>& one : before)
      if (const auto* found = dynamic_cast<const Kind*>(one.get()))
        return found;
    return nullptr;
  }
};

/// An effect: its name, when it acts, and how it is made.
struct Kind
{
  std::string_view name;
  bool (*acts)(const Effects&, const Current::Materials&);
  std::unique_ptr<Effect> (*make)(const Effects&, const Site&);
};

constexpr std::array kinds{
    Kind{"wear", [](const Effects& s, const Current::Materials&) { return s.wear.wears(); },
         [](const Effects& s, const Site& b) -> std::unique_ptr<Effect>
         { return std::make_unique<Wear>(b.compliance.grid(), b.lower.surface, b.upper.surface, s.wear, b.modulus); }},
    Kind{"current", [](const Effects&, const Current::Materials& materials) { return Current::flows(materials); },
         [](const Effects& s, const Site& b) -> std::unique_ptr<Effect>
         {
           return std::make_unique<Current>(b.compliance, b.lower, b.upper, b.modulus, b.materials, s.current,
                                            b.other<Wear>());
         }},
    Kind{"conduction",
         [](const Effects&, const Current::Materials& materials) { return Conduction::is_known(materials); },
         [](const Effects&, const Site& b) -> std::unique_ptr<Effect>
         { return std::make_unique<Conduction>(b.compliance, b.modulus, b.materials, b.other<Current>()); }},
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
                                                  const VolumeGrid& lower, const VolumeGrid& upper, double modulus,
                                                  const Current::Materials& materials)
{
  std::vector<std::unique_ptr<Effect>> effects;
  for (const Kind& kind : kinds)
    if (kind.acts(settings, materials))
      effects.push_back(kind.make(settings, {compliance, lower, upper, modulus, materials, effects}));
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
