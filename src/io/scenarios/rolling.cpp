// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/estimates.hpp"
#include "description.hpp"

/// Keys, texts and results of the scenario rolling.
namespace brinell::io
{

namespace
{

using contact::Drive;
using simulation::RollingCase;
using simulation::RollingPass;
using simulation::RollingPlan;
using simulation::RollingRecord;
using simulation::RollingSummary;

using simulation::Creepage;
using simulation::largest_creepage;

Creepage& creepage_of(Case& c)
{
  std::optional<Creepage>& creepage = std::get<RollingCase>(c.scenario).creepage;
  return creepage ? *creepage : creepage.emplace();
}

/// Keys of creepage and spin, with which surfaces stick and slip.
std::vector<Entry> creep_keys()
{
  return {
      Entry{.key = "rolling.creepage",
            .of = kind::share.list().between(-largest_creepage, largest_creepage),
            .unset = "no stick: the surfaces slide everywhere, by slide_to_roll",
            .text = "Creepages [longitudinal, lateral], or the longitudinal one alone: velocities of the upper surface "
                    "relative to the lower one, towards +x and +y, over the mean speed at which the surfaces pass the "
                    "contact. With creepage the surfaces stick in places and slip in others, and rolling develops from "
                    "rest to the steady state. Needs interface.friction, and slide_to_roll = 0, which is for surfaces "
                    "that slide everywhere.",
            .fill =
                [](Case& c, const Value& value)
            {
              const auto& list = std::get<std::vector<double>>(value);
              Creepage& creepage = creepage_of(c);
              creepage.longitudinal = list.front();
              creepage.lateral = list.size() > 1 ? list[1] : 0.0;
            }},
      Entry{.key = "rolling.spin",
            .of = kind::per_length,
            .unset = "none",
            .text = "Spin creepage: rotation of the upper body relative to the lower one about the normal of the "
                    "contact, from x to y, per distance rolled. With stick and slip, like creepage.",
            .fill = [](Case& c, const Value& value) { creepage_of(c).spin = std::get<double>(value); }},
  };
}

constexpr const char* rolling_drive = "rolling drive";

std::vector<Entry> motion_keys()
{
  const auto drive = [](const char* key, const ValueKind& of, Drive::Kind kind, const char* text)
  { return drive_key(std::string("rolling.") + key, of.above(0.0), text, rolling_drive, &RollingCase::drive, kind); };
  return {
      drive("load", kind::force, Drive::Kind::load, "Load kept while rolling."),
      drive("hertz_pressure", kind::pressure, Drive::Kind::load,
            "Peak pressure of the elastic contact (Hertz) that defines the load, instead of a load."),
      drive("approach", kind::length, Drive::Kind::approach, "Approach kept while rolling, instead of a load."),
      bound(
          {.key = "rolling.distance",
           .of = kind::length.above(0.0),
           .required = true,
           .text =
               "Length of the track on the lower body, from -distance/2 to distance/2, in an even number of steps that "
               "dx is made to fit. Where cells or a shift that the case gives do not fit, a warning names the length "
               "that is rolled."},
          &RollingCase::distance),
      bound({.key = "rolling.shift",
             .of = kind::length.above(0.0),
             .unset = "one cell, dx",
             .text =
                 "Distance that the contact moves on the lower body per step. With creepage a whole number of cells: "
                 "dx is made to fit it, unless the case gives the cells or it is less than half of one."},
            &RollingCase::shift),
      bound({.key = "rolling.slide_to_roll",
             .of = kind::number.up_to(-2.0, 2.0),
             .text = "Slide-to-roll ratio: difference (lower minus upper) over mean of the speeds at which the "
                     "surfaces pass the contact. 0: pure rolling; 2: the upper body slides without rotation. Friction "
                     "acts only if interface.friction is given."},
            &RollingCase::slide_to_roll),
      bound({.key = "rolling.passes",
             .of = kind::number.between(1, 100000),
             .text = "Number of passes over the track. Each pass begins at the same place on both bodies."},
            &RollingCase::passes),
      bound({.key = "rolling.load_steps",
             .of = kind::number.between(1, 100000),
             .text = "Steps in which the upper body is pressed on before a pass and lifted off after it."},
            &RollingCase::load_steps),
      bound({.key = "rolling.speed",
             .of = kind::velocity.above(0.0),
             .unset = "none; needed where friction heats",
             .text = "Speed of the contact over the lower body, on which the heat of friction depends; with "
                     "slide_to_roll it determines the sliding speed. A step of pressing on or lifting off takes as "
                     "long as one of rolling, with creepage all of them at least as long as the contact takes to roll "
                     "over its own length; the way back from pass to pass takes as long as a pass."},
            &RollingCase::speed),
  };
}

std::vector<Entry> rolling_keys()
{
  std::vector<Entry> all = motion_keys();
  const std::vector<Entry> creep = creep_keys();
  const auto after =
      std::find_if(all.begin(), all.end(), [](const Entry& e) { return e.key == "rolling.slide_to_roll"; });
  all.insert(after + 1, creep.begin(), creep.end());
  return all;
}

/// Load whose elastic contact has the given peak pressure.
double load_of_hertz_pressure(const CaseReader& reader, Case& c, const RollingCase& rolling)
{
  const std::string key = "rolling.hertz_pressure";
  const double pressure = reader.get<double>(key);
  constexpr double lowest = 1e-7; // relative to the contact modulus: a contact of a few nm under a ball of a centimetre
  if (pressure < lowest * c.contact_modulus)
    warn(c, "low_pressure",
         "{} = {:g} Pa is next to nothing for these materials; is a unit missing, as in \"{:g} {}\"?", key, pressure,
         pressure, pressure < 100.0 ? "GPa" : "MPa");
  const auto load = simulation::load_of_peak_pressure(rolling.lower.shape, rolling.upper.shape, rolling.domain,
                                                      c.contact_modulus, pressure);
  if (!load)
    reader.add(key, "has no meaning for these shapes; allowed: rolling.load or rolling.approach");
  return load.value_or(1.0);
}

std::string read(const CaseReader& reader, Case& c, RollingCase& r)
{
  if (reader.only_one_of(rolling_drive) == "rolling.hertz_pressure")
    r.drive.value = load_of_hertz_pressure(reader, c, r);
  if (reader.has("rolling.creepage") && reader.get<std::vector<double>>("rolling.creepage").size() > 2)
    reader.add("rolling.creepage", "has more than two numbers; allowed: [longitudinal, lateral], or the first of them");
  return "rolling.distance";
}

std::string creepage_text(const RollingCase& r)
{
  if (!r.creepage)
    return "";
  return fmt::format("# Creepage: {:g} along, {:g} across, spin {:g} rad/m; friction {:g}\n", r.creepage->longitudinal,
                     r.creepage->lateral, r.creepage->spin, r.friction.coefficient);
}

std::string motion(const RollingCase& r, const RollingPlan& plan)
{
  return fmt::format("# Motion: {} steps of {:.6e} m, {}; {}\n"
                     "# Contact: about {:.4e} x {:.4e} m wide\n",
                     plan.rolling_steps, plan.shift, count_text(r.passes, "pass", "passes"), text_of(r.drive),
                     2.0 * plan.half_width_x, 2.0 * plan.half_width_y) +
         creepage_text(r);
}

std::string place(const Case& c, const RollingRecord& record)
{
  std::string where = fmt::format("pass {}  x {:+.3e} m", record.pass, record.x);
  if (!std::get<RollingCase>(c.scenario).creepage)
    return where;
  return fmt::format("{}  along it {:+.3e} N, {:+.3e} N  sticks {:.0f} %", where, record.F_x, record.F_y,
                     100.0 * record.stick_share);
}

std::string creep_results(const RollingSummary& s)
{
  return table_text("pass      F_x [N]       F_y [N]     M_z [N m]  sticks  steady\n", s.passes,
                    [](const RollingPass& p)
                    {
                      return fmt::format("{:4} {:12.5e} {:13.6e} {:13.6e} {:5.0f} %  {}\n", p.pass, p.F_x, p.F_y, p.M_z,
                                         100.0 * p.stick_share, p.creeps_steadily() ? "yes" : "no");
                    });
}

std::string pass_results(const RollingSummary& s)
{
  return table_text("pass      rut [m]  shoulder [m]  plastic strain     increment  dissipated [J]  resistance [N]\n",
                    s.passes,
                    [](const RollingPass& p)
                    {
                      return fmt::format("{:4} {:12.5e} {:13.6e} {:15.6e} {:13.6e} {:15.6e} {:15.6e}\n", p.pass,
                                         p.rut_depth, p.shoulder_height, p.track_plastic_strain,
                                         p.track_plastic_increment, p.dissipation, p.resistance);
                    });
}

std::string results(const Case& c, const RollingSummary& s)
{
  return pass_results(s) + (std::get<RollingCase>(c.scenario).creepage ? creep_results(s) : "");
}

Json pass_json(const RollingPass& pass)
{
  Json json;
  for (const auto& column : simulation::columns<RollingPass>)
  {
    if (column.name == "unsteadiness")
      json["steady"] = pass.is_steady(); // next to the number from which it follows
    if (column.name == "creep_unsteadiness")
      json["creep_steady"] = pass.creeps_steadily();
    put(json, column, pass);
  }
  return json;
}

void summarise(Json& json, const Case& c, const RollingCase& r, const RollingPlan& plan, const RollingSummary& s)
{
  json["geometry"] = geometry_json(c);
  json["geometry"]["estimated_half_width_x_m"] = plan.half_width_x;
  json["geometry"]["estimated_half_width_y_m"] = plan.half_width_y;
  json["drive"] = drive_json(r.drive);
  json["max_share_at_shear_limit"] = s.max_share_at_shear_limit;
  json["passes"] = Json::array();
  for (const RollingPass& pass : s.passes)
    json["passes"].push_back(pass_json(pass));
  json["profile"] = {{"depth_m", s.profile.depth},
                     {"residual_xx_Pa", s.profile.residual_xx},
                     {"residual_yy_Pa", s.profile.residual_yy},
                     {"equivalent_plastic_strain", s.profile.equivalent_plastic_strain}};
}

void cite(Sources& sources, const RollingCase& r)
{
  sources.add("boucly2006", "rolling: both surfaces and their strain are carried past the contact");
  if (can_yield(r) && r.passes > 1)
    sources.add("johnson1985", "shakedown under repeated passes");
  if (r.creepage)
    sources.add("kalker1967", "rolling with creepage and spin: stick and slip");
}

simulation::Course course(const RollingCase& r, const RollingPlan& plan)
{
  const bool slides = r.friction.coefficient > 0.0 && r.slide_to_roll != 0.0;
  return {.kind = simulation::RunKind::rolling,
          .loading = static_cast<double>(r.load_steps),
          .unloading = static_cast<double>(r.load_steps),
          .moving = static_cast<double>(plan.rolling_steps),
          .again = (r.passes - 1.0) * (plan.rolling_steps + 2.0 * r.load_steps),
          .turns = slides ? static_cast<double>(r.passes) : 0.0,
          .sticks = r.creepage.has_value()};
}

} // namespace

template <>
ScenarioIo<RollingCase> description()
{
  return {
      .name = "rolling",
      .text = "the upper body is pressed on the lower one and rolls over it along x, pass after pass",
      .keys = rolling_keys,
      .read = read,
      .half_x = &RollingPlan::half_width_x,
      .half_y = &RollingPlan::half_width_y,
      .motion = motion,
      .course = course,
      .is_key_step = [](const RollingCase&, const RollingRecord& record, NearestToMiddle& middle)
      { return middle(record.pass, record.x); },
      .key_steps = [](const RollingCase& r, const RollingPlan&) { return double(r.passes); },
      .place = place,
      .results = results,
      .summarise = summarise,
      .lists = {{"passes", columns(RollingPass())}},
      .key_numbers = [](const RollingCase& r) -> std::vector<std::string>
      {
        std::vector<std::string> names{"passes[].rut_depth_m", "passes[].resistance_N", "passes[].dissipation_J"};
        if (r.creepage)
          names.insert(names.end(), {"passes[].F_x_N", "passes[].F_y_N"});
        return names;
      },
      .steps = "rolling.shift",
      .drive_kept = &RollingCase::drive,
      .cite = cite,
  };
}

template const ScenarioIo<RollingCase>& scenario_io<RollingCase>();

} // namespace brinell::io
