// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenarios/scenario_io.hpp"
#include "schema_parts.hpp"

#include <algorithm>
#include <concepts>

/// Keys of what is between the surfaces: friction, its heat, wear.
namespace brinell::io
{

namespace
{

/// Scenarios whose rows tell of something.
template <typename Part>
std::vector<std::string> scenarios_that_tell_of()
{
  return scenarios_with([]<typename ScenarioCase>(const ScenarioIo<ScenarioCase>&)
                        { return std::derived_from<typename ScenarioCase::Record, Part>; });
}

/// A key of one part of what all scenarios have.
template <typename Part, typename Member>
Entry of_part(Entry given, const std::vector<std::string>& scenarios, Part part, Member member)
{
  given.when = {"scenario", scenarios};
  return bound(std::move(given), part, member);
}

std::vector<Entry> friction_entries()
{
  using elastoplastic::Friction;
  const auto entry = [all = scenarios_that_tell_of<simulation::FrictionRecord>()](Entry given, auto member)
  { return of_part(std::move(given), all, &simulation::Numerics::friction, member); };
  return {
      entry({.key = "interface.friction",
             .of = kind::number.at_least(0.0),
             .text = "Coefficient of Coulomb friction where the surfaces slide on each other: shear = friction x "
                     "pressure on each of them, against its motion over the other, as far as it can carry it. In "
                     "rolling only with a slide_to_roll other than 0, and not while the upper body is pressed on and "
                     "lifted off. In fretting the surfaces stick where less shear is enough."},
            &Friction::coefficient),
      entry({.key = "interface.shear_limit",
             .of = kind::pressure.above(0.0),
             .unset = "the shear yield stress of the softer surface as it is, hardening included",
             .text = "Largest shear that a surface can carry."},
            &Friction::shear_limit),
      entry({.key = "interface.coupling",
             .text = "Whether the shear moves the surfaces apart or together where the two materials differ. false: as "
                     "if both moved alike under it."},
            &Friction::coupling),
  };
}

/// A key of the heat of friction.
template <typename Member>
Entry of_heat(Entry given, Member member)
{
  return of_part(std::move(given), scenarios_that_tell_of<simulation::HeatedRecord>(), &simulation::Numerics::heat,
                 member);
}

/// Wear, in scenarios whose rows tell of it.
std::vector<Entry> wear_entries()
{
  using elastoplastic::WearLaw;
  const auto wears = []<typename ScenarioCase>(const ScenarioIo<ScenarioCase>&)
  {
    const auto& all = simulation::columns<typename ScenarioCase::Record>;
    return std::any_of(all.begin(), all.end(), [](const auto& column) { return column.name == "worn_volume_lower"; });
  };
  const auto entry = [all = scenarios_with(wears)](Entry given, auto member)
  { return of_part(std::move(given), all, &simulation::Numerics::wear, member); };
  const auto coefficient = [&](const char* key, const char* text, auto member)
  {
    return entry({.key = std::string("interface.wear.") + key,
                  .of = kind::wear.at_least(0.0),
                  .text = text,
                  .hint = "dry steel on steel has 1e-9 to 1e-4 mm^3/(N m), which is 1e-18 to 1e-13 1/Pa"},
                 member);
  };
  return {
      coefficient(
          "lower",
          "Wear coefficient of the lower surface: the depth that it loses, per pressure and length slipped; in 1/Pa, "
          "or as text in mm^3/(N m). A rigid body may wear, too. In rolling only with a slide_to_roll other than 0.",
          &WearLaw::lower),
      coefficient("upper", "The same of the upper surface.", &WearLaw::upper),
      entry({.key = "interface.wear.law",
             .choices = {"archard", "energy"},
             .text = "What wears. archard: worn depth = coefficient x pressure x length slipped; energy: coefficient x "
                     "friction work per area, shear x length slipped."},
            &WearLaw::kind),
  };
}

} // namespace

std::vector<Entry> interface_entries()
{
  return joined({friction_entries(),
                 {of_heat({.key = "interface.heat_fraction",
                           .of = kind::number.between(0.0, 1.0),
                           .text = "Share of the friction power that warms the two bodies, where they have thermal "
                                   "constants."},
                          &elastoplastic::HeatSettings::fraction)},
                 wear_entries()});
}

std::vector<Entry> heat_entries()
{
  using elastoplastic::HeatSettings;
  return {
      of_heat({.key = "thermal.partition",
               .of = kind::number.between(0.0, 1.0),
               .unset = "both surfaces have one temperature where they touch",
               .text = "Share of the lower body in the heat of friction, everywhere in the contact, before any passes "
                       "from one surface to the other by the conductance. Between two bodies that conduct."},
              &HeatSettings::partition),
      of_heat({.key = "thermal.conductance",
               .of = kind::conductance.at_least(0.0),
               .unset = "nothing resists the heat, and both surfaces have one temperature where they touch; with a "
                        "partition nothing passes",
               .text = "Thermal conductance of the contact: heat per area and time that passes from one surface to the "
                       "other where they touch, per difference of their temperatures. The heat of friction arises on "
                       "both sides of it, in the shares of the partition, or in halves.",
               .hint = "metals that are pressed on each other have 1e3 to 1e6 W/(m^2 K)"},
              &HeatSettings::conductance),
      of_heat({.key = "thermal.regime",
               .choices = {"transient", "steady"},
               .text = "What makes a surface warm. transient: all heat since the start. steady: the heat of a step as "
                       "if it had always been there and moved as it does now, at any speed; on grids that are open "
                       "along x, and of bodies that yield without heat_of_plastic_work."},
              &HeatSettings::regime),
      of_heat({.key = "thermal.reference",
               .of = kind::length.above(0.0),
               .unset = "a steady flux that rests on a body, which swells, is refused",
               .text = "Distance from the contact at which the surface of a body that rests under a steady flux counts "
                       "as not displaced: what it swells by grows with the logarithm of the distance. An imposed "
                       "approach counts from there; under a given load it changes the approach alone.",
               .hint = "the size of the body: some radius of its surface"},
              &HeatSettings::reference),
      of_heat({.key = "thermal.heat_of_plastic_work",
               .of = kind::number.between(0.0, 1.0),
               .text = "Share of the plastic work that becomes heat, in the cells in which it is done, where the heat "
                       "of friction is computed. 0: plastic work does not heat. Of metals some 0.9; the rest stays in "
                       "the material."},
              &HeatSettings::of_plastic_work),
      of_heat(
          {.key = "thermal.displacement",
           .text =
               "Whether the surfaces swell into the gap as they grow warm. false: as if they had no expansion there."},
          &HeatSettings::displacement),
      of_heat(
          {.key = "thermal.stress",
           .text = "Whether thermal stress counts when the material yields. false: as if it had no expansion there."},
          &HeatSettings::stress),
  };
}

} // namespace brinell::io
