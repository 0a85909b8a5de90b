// SPDX-License-Identifier: BSD-3-Clause
#include "description.hpp"

#include <cmath>

/// Keys, texts and results of the scenario sliding.
namespace brinell::io
{

namespace
{

using contact::Drive;
using simulation::SlidingCase;
using simulation::SlidingPlan;
using simulation::SlidingRecord;
using simulation::SlidingStroke;
using simulation::SlidingSummary;

constexpr const char* sliding_drive = "sliding drive";

std::vector<Entry> sliding_keys()
{
  const auto press = [](const char* key, const ValueKind& of, Drive::Kind kind, const char* text)
  { return drive_key(std::string("sliding.") + key, of, text, sliding_drive, &SlidingCase::press, kind); };
  return {
      press("load", kind::force.above(0.0), Drive::Kind::load, "Load that is applied first and kept while sliding."),
      press("pressure", kind::pressure.above(0.0), Drive::Kind::load,
            "Mean pressure over the period, instead of a load; with grid.boundary = \"periodic\"."),
      press("mean_gap", kind::length.above(0.0), Drive::Kind::mean_gap,
            "Mean gap of the deformed surfaces over the period, instead of a load; with grid.boundary = \"periodic\"."),
      press("approach", kind::length, Drive::Kind::approach,
            "Approach of the bodies, instead of a load. It may be negative if peaks meet on the way."),
      bound({.key = "sliding.press_steps",
             .of = kind::number.between(1, 100000),
             .text =
                 "Number of steps in which the bodies are pressed together before sliding, and lifted off afterwards."},
            &SlidingCase::press_steps),
      bound({.key = "sliding.distance",
             .of = kind::length.above(0.0),
             .required = true,
             .text =
                 "Sliding distance of the upper body along x over the lower one in each stroke, in whole steps that dx "
                 "is made to fit. Where a period, or cells or a shift that the case gives do not fit, a warning names "
                 "the distance that is slid."},
            &SlidingCase::distance),
      bound({.key = "sliding.shift",
             .of = kind::length.above(0.0),
             .unset = "one cell, dx",
             .text = "Sliding distance in a step."},
            &SlidingCase::shift),
      bound({.key = "sliding.strokes", .of = kind::number.between(1, 100000), .text = "Number of strokes."},
            &SlidingCase::strokes),
      bound({.key = "sliding.to_and_fro",
             .text = "Whether every second stroke goes back. Otherwise each stroke continues where the previous one "
                     "ended, which needs a period along x."},
            &SlidingCase::to_and_fro),
      bound({.key = "sliding.speed",
             .of = kind::velocity.above(0.0),
             .unset = "none; needed where friction heats",
             .text = "Speed of the upper body over the lower one, on which the heat of friction depends. A step of "
                     "pressing or lifting off takes as long as one of sliding."},
            &SlidingCase::speed),
  };
}

std::string read(const CaseReader& reader, Case& /*c*/, SlidingCase& s)
{
  std::string key = reader.only_one_of(sliding_drive);
  if (key != "sliding.pressure" && key != "sliding.mean_gap")
    return key;
  if (!s.domain.is_periodic())
    reader.add(key, "is the mean over a period; allowed with grid.boundary = \"periodic\"; otherwise {}",
               key == "sliding.pressure" ? "sliding.load" : "sliding.approach");
  else if (key == "sliding.pressure")
    s.press.value *= s.domain.x.size * s.domain.y.size;
  return key;
}

std::string motion(const SlidingCase& s, const SlidingPlan& plan)
{
  std::string text =
      fmt::format("# Sliding: {}, then {} steps of {:.6e} m, {}{}\n", text_of(s.press), plan.sliding_steps, plan.shift,
                  count_text(s.strokes, "stroke", "strokes"), s.to_and_fro ? ", to and fro" : "");
  if (!std::isnan(plan.touching_gap))
    return text + fmt::format("# The surfaces first touch at a mean gap of {:.4e} m\n", plan.touching_gap);
  return text +
         fmt::format("# Contact: about {:.4e} x {:.4e} m wide\n", 2.0 * plan.half_width_x, 2.0 * plan.half_width_y);
}

std::string place(const Case&, const SlidingRecord& record)
{
  std::string text =
      fmt::format("stroke {}  slid {:+.3e} m  friction {:.4f}", record.pass, record.slid, record.friction);
  if (!std::isnan(record.contact_fraction)) // a period
    text += fmt::format("  contact {:.3g} %", 100.0 * record.contact_fraction);
  return text;
}

std::string results(const Case&, const SlidingSummary& s)
{
  return table_text(
      "stroke  friction  ploughing  interface   area [m^2]   plastic [J]  friction [J]  rms lower [m]  rms upper [m]\n",
      s.strokes,
      [](const SlidingStroke& p)
      {
        return fmt::format("{:6} {:9.6f} {:10.6f} {:10.6f} {:12.5e} {:13.6e} {:13.6e} {:14.7e} {:14.7e}\n", p.stroke,
                           p.friction, p.friction_ploughing, p.friction_interfacial, p.contact_area,
                           p.dissipation_plastic, p.dissipation_friction, p.rms_height_lower, p.rms_height_upper);
      });
}

void summarise(Json& json, const Case& c, const SlidingCase& s, const SlidingPlan& plan, const SlidingSummary& summary)
{
  json["geometry"] = geometry_json(c);
  json["geometry"]["estimated_half_width_x_m"] = plan.half_width_x;
  json["geometry"]["estimated_half_width_y_m"] = plan.half_width_y;
  json["geometry"]["touching_gap_m"] = plan.touching_gap;
  json["geometry"]["rms_height_m"] = summary.rms_height;
  json["geometry"]["rms_slope"] = summary.rms_slope;
  json["drive"] = drive_json(s.press);
  json["max_share_at_shear_limit"] = summary.max_share_at_shear_limit;
  json["strokes"] = rows_json(summary.strokes);
}

/// Whether a step is the last of pressing, or nearest to the middle of a stroke.
bool is_key_step(const SlidingCase& s, const SlidingRecord& record, NearestToMiddle& middle)
{
  return record.step + 1 == s.press_steps ||
         middle(record.pass, record.slid - (s.to_and_fro ? 0.5 : record.pass - 0.5) * s.distance);
}

void cite(Sources& sources, const SlidingCase&)
{
  sources.add("boucly2006", "sliding: both surfaces and their strain are carried past each other");
}

simulation::Course course(const SlidingCase& s, const SlidingPlan& plan)
{
  const bool repeats = s.to_and_fro || s.domain.x.is_periodic();
  const double first = repeats ? plan.sliding_steps : static_cast<double>(s.strokes) * plan.sliding_steps;
  return {.kind = simulation::RunKind::sliding,
          .loading = static_cast<double>(s.press_steps),
          .unloading = static_cast<double>(s.press_steps),
          .moving = first,
          .again = static_cast<double>(s.strokes) * plan.sliding_steps - first,
          .turns = s.friction.coefficient > 0.0 ? (s.to_and_fro ? static_cast<double>(s.strokes) : 1.0) : 0.0};
}

} // namespace

template <>
ScenarioIo<SlidingCase> description()
{
  return {
      .name = "sliding",
      .text = "the upper body is pressed on the lower one and slides over it along x, in strokes or to and fro",
      .keys = sliding_keys,
      .read = read,
      .half_x = &SlidingPlan::half_width_x,
      .half_y = &SlidingPlan::half_width_y,
      .moves = false,
      .motion = motion,
      .course = course,
      .is_key_step = is_key_step,
      .key_steps = [](const SlidingCase& s, const SlidingPlan&) { return 1.0 + s.strokes; },
      .aligned = "in sliding when the bodies are pressed together, and in the middle of each stroke",
      .place = place,
      .results = results,
      .summarise = summarise,
      .lists = {{"strokes", columns(SlidingStroke())}},
      .key_numbers = [](const SlidingCase&) -> std::vector<std::string> {
        return {"strokes[].friction", "strokes[].contact_area_m2", "strokes[].dissipation_plastic_J"};
      },
      .steps = "sliding.shift",
      .drive_kept = &SlidingCase::press,
      .cite = cite,
  };
}

template const ScenarioIo<SlidingCase>& scenario_io<SlidingCase>();

} // namespace brinell::io
