// SPDX-License-Identifier: BSD-3-Clause
#include "description.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

/// Keys, texts and results of the scenario fretting.
namespace brinell::io
{

namespace
{

using contact::Drive;
using simulation::FrettingCase;
using simulation::FrettingCycle;
using simulation::FrettingPlan;
using simulation::FrettingRecord;
using simulation::FrettingSummary;

constexpr const char *fretting_press = "fretting press", *fretting_motion = "fretting motion";

std::vector<Entry> fretting_keys()
{
  const auto press = [](const char* key, const char* other, const ValueKind& of, Drive::Kind kind, const char* text)
  {
    Entry entry =
        drive_key(std::string("fretting.") + key, of.above(0.0), text, fretting_press, &FrettingCase::press, kind);
    entry.unset = entry.excludes = std::string("fretting.") + other;
    return entry;
  };
  const auto amplitude =
      [](const char* key, const char* other, const ValueKind& of, FrettingCase::Kind kind, const char* text)
  {
    return Entry{.key = std::string("fretting.") + key,
                 .of = of.at_least(0.0),
                 .unset = std::string("fretting.") + other,
                 .text = text,
                 .excludes = std::string("fretting.") + other,
                 .one_of = fretting_motion,
                 .fill = [kind](Case& c, const Value& value)
                 {
                   auto& fretting = std::get<FrettingCase>(c.scenario);
                   fretting.kind = kind;
                   fretting.amplitude = std::get<double>(value);
                 }};
  };
  return {
      press("load", "approach", kind::force, Drive::Kind::load, "Load that is applied first and then kept."),
      press("approach", "load", kind::length, Drive::Kind::approach,
            "Approach of the bodies that is imposed first and then kept, instead of a load."),
      drive_key("fretting.pressure", kind::pressure.above(0.0),
                "Mean pressure over the period, instead of a load; with grid.boundary = \"periodic\".", fretting_press,
                &FrettingCase::press, Drive::Kind::load),
      amplitude("displacement", "force", kind::length, FrettingCase::Kind::shift,
                "Amplitude of the displacement of distant points of the upper body relative to those of the lower one; "
                "each cycle goes from the middle to the amplitude, to its opposite and back to the middle. Up to the "
                "radius of the contact."),
      amplitude(
          "force", "displacement", kind::force, FrettingCase::Kind::force,
          "Amplitude of the tangential force, instead of a displacement; it must be less than friction times load."),
      Entry{.key = "fretting.direction",
            .of = kind::angle.between(-360.0, 360.0),
            .fallback = 0.0,
            .text = "Direction of the motion, from x towards y, in degrees.",
            .fill =
                [](Case& c, const Value& value)
            {
              constexpr double degree = std::numbers::pi / 180.0;
              std::get<FrettingCase>(c.scenario).direction = std::get<double>(value) * degree;
            }},
      bound({.key = "fretting.cycles",
             .of = kind::number.between(0, 100000),
             .text = "Number of cycles of the oscillation."},
            &FrettingCase::cycles),
      bound({.key = "fretting.steps_per_cycle",
             .of = kind::number.between(4, 100000),
             .text =
                 "Number of steps in a cycle, a multiple of 4, so that steps end at the middle and at both reversals."},
            &FrettingCase::steps_per_cycle),
      bound({.key = "fretting.press_steps",
             .of = kind::number.between(1, 100000),
             .text = "Number of steps in which load or approach is applied."},
            &FrettingCase::press_steps),
      bound({.key = "fretting.frequency",
             .of = kind::frequency.above(0.0),
             .unset = "none; needed where friction heats",
             .text = "Cycles per second, on which the heat of friction depends. Each step of pressing takes as long as "
                     "one of a cycle."},
            &FrettingCase::frequency),
  };
}

std::string read(const CaseReader& reader, Case& /*c*/, FrettingCase& f)
{
  if (const std::string key = reader.only_one_of(fretting_press); key == "fretting.pressure")
  {
    if (f.domain.is_periodic())
      f.press.value *= f.domain.x.size * f.domain.y.size;
    else
      reader.add(key, "is the mean over a period; allowed with grid.boundary = \"periodic\"; otherwise fretting.load");
  }
  return reader.only_one_of(fretting_motion);
}

std::string amplitude_text(const FrettingCase& f)
{
  const bool by_force = f.kind == FrettingCase::Kind::force;
  return fmt::format("{} = {:.6e} {}", by_force ? "force" : "displacement", f.amplitude, by_force ? "N" : "m");
}

std::string motion(const FrettingCase& f, const FrettingPlan& plan)
{
  std::string text = fmt::format("# Fretting: {}, then {} of {} steps, {}\n"
                                 "# Contact radius about {:.4e} m",
                                 text_of(f.press), count_text(f.cycles, "cycle", "cycles"), f.steps_per_cycle,
                                 amplitude_text(f), plan.contact_radius);
  if (plan.sliding_displacement > 0.0)
    text +=
        fmt::format("; an elastic one slides everywhere from a displacement of {:.4e} m on", plan.sliding_displacement);
  return text + "\n";
}

std::string place(const Case&, const FrettingRecord& record)
{
  if (record.cycle == 0)
    return fmt::format("pressing  approach {:.3e} m  load {:.3e} N", record.approach, record.F_n);
  return fmt::format("cycle {}  displacement {:+.3e} m  force {:+.3e} N  sticks {:.0f} %", record.cycle,
                     record.displacement, record.force, 100.0 * record.stick_share);
}

std::string results(const Case&, const FrettingSummary& s)
{
  return table_text("cycle  energy [J]  friction [J]   plastic [J]     force [N]      slip [m]  sticks\n", s.cycles,
                    [](const FrettingCycle& c)
                    {
                      return fmt::format("{:5} {:11.4e} {:13.6e} {:13.6e} {:13.6e} {:13.6e} {:5.0f} %\n", c.cycle,
                                         c.work, c.dissipation_friction, c.dissipation_plastic, c.max_force,
                                         c.slip_amplitude, 100.0 * c.stick_share);
                    });
}

void summarise(Json& json, const Case& c, const FrettingCase& f, const FrettingPlan& plan, const FrettingSummary& s)
{
  json["geometry"] = geometry_json(c);
  json["geometry"]["estimated_contact_radius_m"] = plan.contact_radius;
  json["geometry"]["estimated_sliding_displacement_m"] = plan.sliding_displacement;
  json["drive"] = drive_json(f.press);
  json["drive"][f.kind == FrettingCase::Kind::force ? "force_N" : "displacement_m"] = f.amplitude;
  json["max_share_at_shear_limit"] = s.max_share_at_shear_limit;
  json["cycles"] = rows_json(s.cycles);
}

/// Whether a step ends at a reversal, at the end of pressing or at the end of a cycle.
bool is_key_step(const FrettingCase& f, const FrettingRecord& record, NearestToMiddle& /*middle*/)
{
  const int moved = record.step + 1 - f.press_steps, quarter = f.steps_per_cycle / 4;
  return moved >= 0 && moved % quarter == 0 && moved / quarter % 4 != 2;
}

void cite(Sources& sources, const FrettingCase&)
{
  sources.add("mindlin1953", "fretting: stick and slip under an oscillating force, and the energy of a cycle");
  sources.add("johnson1985", "contacts that stick in places");
}

simulation::Course course(const FrettingCase& f, const FrettingPlan& plan)
{
  const auto cycle = static_cast<double>(f.steps_per_cycle);
  double mobilised = f.friction.coefficient > 0.0 ? 1.0 : 0.0;
  if (f.kind == FrettingCase::Kind::force && f.press.kind == Drive::Kind::load)
    mobilised = f.amplitude / (f.friction.coefficient * f.press.value);
  else if (f.kind == FrettingCase::Kind::shift && plan.sliding_displacement > 0.0)
    mobilised = std::min(1.0, f.amplitude / plan.sliding_displacement);
  return {.kind = simulation::RunKind::fretting,
          .loading = static_cast<double>(f.press_steps),
          .moving = f.cycles > 0 ? cycle : 0.0,
          .again = std::max(0.0, (f.cycles - 1.0) * cycle),
          .mobilised = mobilised,
          .sticks = true};
}

} // namespace

template <>
ScenarioIo<FrettingCase> description()
{
  return {
      .name = "fretting",
      .text = "the upper body is pressed on the lower one and oscillates along the surface, on which it sticks in "
              "places",
      .keys = fretting_keys,
      .read = read,
      .half_x = &FrettingPlan::contact_radius,
      .half_y = &FrettingPlan::contact_radius_y,
      .moves = false,
      .speed = "frequency",
      .motion = motion,
      .course = course,
      .is_key_step = is_key_step,
      .key_steps = [](const FrettingCase& f, const FrettingPlan&) { return 1.0 + 3.0 * f.cycles; },
      .aligned = "in fretting the turns and the ends of the cycles",
      .place = place,
      .results = results,
      .summarise = summarise,
      .lists = {{"cycles", columns(FrettingCycle())}},
      .key_numbers = [](const FrettingCase& f) -> std::vector<std::string>
      {
        return {f.kind == FrettingCase::Kind::force ? "cycles[].max_displacement_m" : "cycles[].max_force_N",
                "cycles[].dissipation_friction_J", "cycles[].slip_amplitude_m"};
      },
      .steps = "fretting.steps_per_cycle",
      .enough_steps = 32, // docs/verification/accuracy.md (fretting): 0.5 % of the heat
      .drive_kept = &FrettingCase::press,
      .cite = cite,
  };
}

template const ScenarioIo<FrettingCase>& scenario_io<FrettingCase>();

} // namespace brinell::io
