// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenarios/scenario_io.hpp"
#include "schema_parts.hpp"

#include <algorithm>
#include <concepts>

/// Keys of the interface: friction, its heat, wear, electric current.
namespace brinell::io
{

namespace
{

/// Scenarios whose history contains the columns of a record `Part`.
template <typename Part>
std::vector<std::string> scenarios_with_record()
{
  return scenarios_with([]<typename ScenarioCase>(const ScenarioIo<ScenarioCase>&)
                        { return std::derived_from<typename ScenarioCase::Record, Part>; });
}

/// A key that fills a member of a part of `simulation::Numerics`.
template <typename Part, typename Member>
Entry of_part(Entry given, const std::vector<std::string>& scenarios, Part part, Member member)
{
  given.when = {"scenario", scenarios};
  return bound(std::move(given), part, member);
}

std::vector<Entry> friction_entries()
{
  using elastoplastic::Friction;
  const auto entry = [all = scenarios_with_record<simulation::FrictionRecord>()](Entry given, auto member)
  { return of_part(std::move(given), all, &simulation::Numerics::friction, member); };
  return {
      entry({.key = "interface.friction",
             .of = kind::number.at_least(0.0),
             .text =
                 "Coefficient of Coulomb friction: where the surfaces slide, the shear is friction x pressure, "
                 "limited by shear_limit, and opposes the relative motion. In rolling friction needs a slide_to_roll "
                 "other than 0 or creepage, and it does not act while the upper body is pressed on or lifted off. In "
                 "fretting, and in rolling with creepage, the surfaces stick where less shear is enough.",
             .member = "Friction::coefficient"},
            &Friction::coefficient),
      entry(
          {.key = "interface.shear_limit",
           .of = kind::pressure.above(0.0),
           .unset = "the current shear yield stress of the softer surface, including hardening",
           .text =
               "Largest shear of the interface, for instance of a film. A surface never carries more than its current "
               "shear yield stress."},
          &Friction::shear_limit),
      entry({.key = "interface.coupling",
             .text = "Whether the shear changes the gap, as it does if the elastic constants of the two materials "
                     "differ. false: this effect is neglected, as if both surfaces moved equally."},
            &Friction::coupling),
  };
}

/// A key of the heat of friction.
template <typename Member>
Entry of_heat(Entry given, Member member)
{
  return of_part(std::move(given), scenarios_with_record<simulation::HeatedRecord>(), &simulation::Numerics::heat,
                 member);
}

/// Keys of wear, for scenarios whose history contains it.
std::vector<Entry> wear_entries()
{
  using elastoplastic::WearLaw;
  const auto wears = []<typename ScenarioCase>(const ScenarioIo<ScenarioCase>&)
  {
    const auto& all = simulation::columns<typename ScenarioCase::Record>;
    return std::any_of(all.begin(), all.end(), [](const auto& column) { return column.name == "worn_volume_lower"; });
  };
  constexpr WearLaw simulation::Numerics::*law = &simulation::Numerics::wear;
  const auto entry = [all = scenarios_with(wears)](Entry given, auto member)
  { return of_part(std::move(given), all, law, member); };
  const auto coefficient = [&](const char* key, const char* text, auto member)
  {
    return entry({.key = std::string("interface.wear.") + key,
                  .of = kind::wear.at_least(0.0),
                  .text = text,
                  .hint = "dry steel on steel has 1e-9 to 1e-4 mm^3/(N m), which is 1e-18 to 1e-13 1/Pa",
                  .usual = {"unusual_wear", 0.0, 1e-9, "more than any solid loses"}, // 1000 times that of soft metals
                  .member = std::string("WearLaw::") + key},
                 member);
  };
  return {
      coefficient("lower",
                  "Wear coefficient of the lower surface: worn depth per pressure and slip length, in 1/Pa, or as text "
                  "in mm^3/(N m). A rigid body may wear, too. In rolling wear needs a slide_to_roll other than 0, or a "
                  "creepage.",
                  &WearLaw::lower),
      coefficient("upper", "Wear coefficient of the upper surface.", &WearLaw::upper),
      entry({.key = "interface.wear.law",
             .choices = {"archard", "energy"},
             .text = "Wear law. archard: worn depth = coefficient x pressure x slip length; energy: worn depth = "
                     "coefficient x friction work per area (shear x slip length).",
             .member = "WearLaw::kind"},
            &WearLaw::kind),
  };
}

/// Keys of the electric current, for all scenarios.
std::vector<Entry> current_entries()
{
  using elastoplastic::CurrentDrive;
  using elastoplastic::FilmLaw;
  constexpr CurrentDrive simulation::Numerics::*drive = &simulation::Numerics::current;
  const auto entry = [](Entry given, auto member) { return bound(std::move(given), drive, member); };
  // Films change where surfaces slide.
  const auto film = [](Entry given, auto member)
  { return bound(std::move(given), drive, &CurrentDrive::film, member); };
  const auto sliding = [&, all = scenarios_with_record<simulation::FrictionRecord>()](Entry given, auto member)
  {
    given.when = {"scenario", all};
    return film(std::move(given), member);
  };
  return {
      entry({.key = "interface.current",
             .of = kind::current.at_least(0.0).list(),
             .unset = "no current",
             .text = "Electric current between bodies that both have an electrical resistivity; over a period, that "
                     "of one period. A list: the values at the ends of the steps 0, 1, 2, ..., or of those of "
                     "current_steps; the last one is kept.",
             .excludes = "interface.voltage",
             .member = "CurrentDrive::current"},
            &CurrentDrive::current),
      entry({.key = "interface.voltage",
             .of = kind::voltage.at_least(0.0).list(),
             .unset = "no current",
             .text = "Voltage between points of the two bodies far from the contact, in place of a current; or a list, "
                     "as for a current.",
             .excludes = "interface.current",
             .member = "CurrentDrive::voltage"},
            &CurrentDrive::voltage),
      entry({.key = "interface.current_steps",
             .of = kind::number.at_least(0.0).list(),
             .unset = "0, 1, 2 and so on",
             .text = "Steps at whose ends the values of a list of currents or voltages hold, ascending; step 0 is the "
                     "first row of the history. In between the drive is linear, before and after them constant.",
             .member = "CurrentDrive::steps"},
            &CurrentDrive::steps),
      film({.key = "interface.film_resistance",
            .of = kind::area_resistance.at_least(0.0),
            .text = "Resistance times area of a film between the surfaces, such as an oxide. 0: no film.",
            .member = "FilmLaw::resistance"},
           &FilmLaw::resistance),
      film({.key = "interface.film_resistivity",
            .of = kind::resistivity.at_least(0.0),
            .text = "Resistivity of the films whose thickness is given by lower.film and upper.film.",
            .member = "FilmLaw::resistivity"},
           &FilmLaw::resistivity),
      sliding({.key = "interface.film_growth",
               .of = kind::resistivity.at_least(0.0),
               .text = "Growth of the film where the surfaces slip under pressure: film_resistance gained per slip "
                       "path, half of it on each surface.",
               .member = "FilmLaw::growth"},
              &FilmLaw::growth),
      sliding({.key = "interface.film_limit",
               .of = kind::area_resistance.above(0.0),
               .unset = "no limit",
               .text = "Resistance times area that a film does not exceed by growing.",
               .member = "FilmLaw::limit"},
              &FilmLaw::limit),
      sliding({.key = "interface.film_wear",
               .of = kind::resistivity.at_least(0.0),
               .text = "Film that wear takes away: film_resistance lost by a surface per worn depth, which is the "
                       "resistivity of the film if it wears like its surface.",
               .member = "FilmLaw::wear"},
              &FilmLaw::wear),
  };
}

} // namespace

std::vector<Entry> interface_entries()
{
  return joined(
      {friction_entries(),
       current_entries(),
       {of_heat({.key = "interface.heat_fraction",
                 .of = kind::number.between(0.0, 1.0),
                 .text = "Share of the friction power that heats the two bodies, if they have thermal constants.",
                 .member = "HeatSettings::fraction"},
                &elastoplastic::HeatSettings::fraction)},
       wear_entries()});
}

namespace
{

/// Keys of a heat source from outside.
std::vector<Entry> source_entries()
{
  using elastoplastic::HeatSettings;
  using elastoplastic::HeatSource;
  const auto entry = [](Entry given, std::vector<std::string> shapes, auto member)
  {
    given.when = {"thermal.source.shape", std::move(shapes)};
    return bound(std::move(given), &simulation::Numerics::heat, &HeatSettings::source, member);
  };
  Entry shape{.key = "thermal.source.shape",
              .choices = {"none", "disc", "rectangle", "contact"},
              .text = "Heat that is supplied from outside at a constant power, also without friction, and moves with "
                      "the contact. disc, rectangle: uniform flux into the surface of one body, as by a laser or a "
                      "heater; contact: heat that arises between the surfaces in proportion to the pressure, as by an "
                      "electric current, and is shared as the heat of friction. It acts from the first step on, except "
                      "on the way back between passes. Needs thermal constants and a speed."};
  shape.when = {"scenario", scenarios_with_record<simulation::HeatedRecord>()};
  const std::vector<std::string> on_body{"disc", "rectangle"}, all{"disc", "rectangle", "contact"};
  return {
      bound(std::move(shape), &simulation::Numerics::heat, &HeatSettings::source, &HeatSource::shape),
      entry({.key = "thermal.source.on", .choices = {"lower", "upper"}, .text = "Body whose surface the source heats."},
            on_body, &HeatSource::on),
      entry({.key = "thermal.source.power",
             .of = kind::power.above(0.0),
             .unset = "the flux is given",
             .text = "Power of the source; over a period or in plane strain, that of one period.",
             .excludes = "thermal.source.flux"},
            all, &HeatSource::power),
      entry({.key = "thermal.source.flux",
             .of = kind::heat_flux.above(0.0),
             .unset = "the power is given",
             .text = "Flux of the source, instead of its power.",
             .excludes = "thermal.source.power"},
            on_body, &HeatSource::flux),
      entry({.key = "thermal.source.radius",
             .of = kind::length.above(0.0),
             .required = true,
             .text = "Radius of the disc."},
            {"disc"}, &HeatSource::radius),
      entry({.key = "thermal.source.length",
             .of = kind::length.above(0.0),
             .required = true,
             .text = "Length of the rectangle along x."},
            {"rectangle"}, &HeatSource::length),
      entry({.key = "thermal.source.width",
             .of = kind::length.above(0.0),
             .unset = "along a periodic axis the whole period; otherwise it has to be given",
             .text = "Width of the rectangle along y."},
            {"rectangle"}, &HeatSource::width),
      entry({.key = "thermal.source.offset",
             .of = kind::length,
             .text = "Distance of the middle of the source from the middle of the contact grid, along x."},
            on_body, &HeatSource::offset),
  };
}

/// Keys of how heat is shared, spreads and acts.
std::vector<Entry> effect_entries()
{
  using elastoplastic::HeatSettings;
  return {
      of_heat({.key = "thermal.partition",
               .of = kind::number.between(0.0, 1.0),
               .unset = "both surfaces have the same temperature where they touch",
               .text = "Share of the heat of friction that enters the lower body, everywhere in the contact, before "
                       "heat passes between the surfaces by the conductance. For two bodies that conduct heat."},
              &HeatSettings::partition),
      of_heat({.key = "thermal.conductance",
               .of = kind::conductance.at_least(0.0),
               .unset = "no thermal resistance, so that both surfaces have the same temperature where they touch; with "
                        "a partition no heat passes",
               .text = "Thermal contact conductance: heat flux from one surface to the other where they touch, per "
                       "difference of their temperatures. The heat of friction is released on both surfaces, by the "
                       "partition, or in halves.",
               .hint = "metals that are pressed on each other have 1e3 to 1e6 W/(m^2 K)"},
              &HeatSettings::conductance),
      of_heat({.key = "thermal.regime",
               .choices = {"transient", "steady"},
               .text = "Heat that determines the temperatures. transient: all heat since the start. steady: steady "
                       "state, as if the heat of the present step had always acted and moved with the present speed; "
                       "needs grids that are open along x; bodies that yield need heat_of_plastic_work = 0."},
              &HeatSettings::regime),
      of_heat(
          {.key = "thermal.reference",
           .of = kind::length.above(0.0),
           .unset = "none: a steady flux at rest on a body that expands is refused",
           .text =
               "Distance from the contact at which the thermal displacement is taken as zero, for a body at rest under "
               "a steady flux; its thermal displacement has no limit but varies with the logarithm of the distance. An "
               "imposed approach counts from there; under a given load only the approach depends on it.",
           .hint = "the size of the body: some radius of its surface"},
          &HeatSettings::reference),
      of_heat({.key = "thermal.heat_of_plastic_work",
               .of = kind::number.between(0.0, 1.0),
               .text = "Share of the plastic work that becomes heat, in the cells in which it is done. It acts only if "
                       "the heat of friction is computed. 0: plastic work does not heat. Metals have about 0.9; the "
                       "rest stays in the material.",
               .member = "HeatSettings::of_plastic_work"},
              &HeatSettings::of_plastic_work),
      of_heat({.key = "thermal.displacement",
               .text = "Whether thermal expansion of the surfaces changes the gap. false: this effect is neglected."},
              &HeatSettings::displacement),
      of_heat({.key = "thermal.stress",
               .text = "Whether thermal stress contributes to yielding. false: this effect is neglected."},
              &HeatSettings::stress),
      of_heat({.key = "thermal.at_melting",
               .choices = {"go_on", "stop"},
               .text = "What the run does when a surface reaches the melting temperature of its softening. go_on: the "
                       "melt counts as a solid with a hundredth of its yield stress, and the run warns at its end; "
                       "stop: the run ends with an error and keeps the steps before."},
              &HeatSettings::at_melting),
  };
}

} // namespace

std::vector<Entry> heat_entries()
{
  return joined({effect_entries(), source_entries()});
}

} // namespace brinell::io
