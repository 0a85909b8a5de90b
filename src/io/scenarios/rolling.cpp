// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/reference/hertz.hpp"
#include "description.hpp"

#include <cmath>
#include <numbers>

/// The rolling in files and messages.
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

std::vector<Entry> keys()
{
  const auto drive = [](const char* key, Dimension dimension, Drive::Kind kind, const char* text)
  {
    return Entry{.key = std::string("rolling.") + key,
                 .type = Type::number,
                 .dimension = dimension,
                 .range = above(0.0),
                 .unset = "not imposed",
                 .text = text,
                 .hint = "one of rolling.load, rolling.hertz_pressure and rolling.approach",
                 .fill = [kind](Case& c, const Value& value) {
                   std::get<RollingCase>(c.scenario).drive = {kind, std::get<double>(value)};
                 }};
  };
  return {
      drive("load", dimension::force, Drive::Kind::load, "Load kept while rolling."),
      drive("hertz_pressure", dimension::pressure, Drive::Kind::load,
            "The load instead by the peak pressure that it would have in elastic contact (Hertz)."),
      drive("approach", dimension::length, Drive::Kind::approach, "Approach kept while rolling, instead of a load."),
      bound({.key = "rolling.distance",
             .dimension = dimension::length,
             .range = above(0.0),
             .required = true,
             .text =
                 "Length of the track on the lower body, from -distance/2 to distance/2; in an even number of steps."},
            &RollingCase::distance),
      bound({.key = "rolling.shift",
             .dimension = dimension::length,
             .range = above(0.0),
             .unset = "one cell, dx",
             .text = "By which the contact moves on the lower body per step."},
            &RollingCase::shift),
      bound({.key = "rolling.slide_to_roll",
             .range = up_to(-2.0, 2.0),
             .text = "Difference over mean of the speeds at which the surfaces of lower and upper body pass the "
                     "contact. 0: pure "
                     "rolling; 2: the upper body slides without turning. Without friction unless interface.friction "
                     "says otherwise."},
            &RollingCase::slide_to_roll),
      bound({.key = "rolling.passes",
             .range = between(1, 100000),
             .text = "How often the track is rolled over. Each pass begins on the same spots of both bodies."},
            &RollingCase::passes),
      bound({.key = "rolling.load_steps",
             .range = between(1, 100000),
             .text = "Steps in which the upper body is pressed on before a pass and lifted off after it."},
            &RollingCase::load_steps),
  };
}

/// Load whose elastic contact has that peak pressure.
double load_of_hertz_pressure(const CaseReader& reader, const Case& c, const RollingCase& rolling)
{
  const std::string key = "rolling.hertz_pressure";
  const double pressure = reader.get<double>(key);
  const auto k = simulation::relative_curvature(rolling.lower.shape, rolling.upper.shape);
  const double length = simulation::line_length(rolling.lower.shape, rolling.upper.shape, rolling.domain);
  if (k && (*k)[0] > 0.0 && (*k)[1] == 0.0 && std::isfinite(length))
    return pressure * pressure * std::numbers::pi * length / ((*k)[0] * c.contact_modulus);
  if (k && (*k)[0] > 0.0 && (*k)[1] > 0.0)
  {
    const double of_one_newton =
        reference::elliptical_contact_at_load(1.0 / (*k)[0], 1.0 / (*k)[1], c.contact_modulus, 1.0).peak_pressure;
    return std::pow(pressure / of_one_newton, 3);
  }
  reader.add(key, "has no meaning for these shapes; allowed: rolling.load or rolling.approach");
  return 1.0;
}

std::string read(const CaseReader& reader, Case& c, RollingCase& r)
{
  const auto given = reader.given({"rolling.load", "rolling.hertz_pressure", "rolling.approach"});
  if (given.size() != 1)
    reader.problems.add(reader.place(given.empty() ? "rolling.load" : given[1]),
                        fmt::format("{} of rolling.load, rolling.hertz_pressure and rolling.approach {}; one is needed",
                                    given.empty() ? "none" : "more than one",
                                    given.size() > 1 ? "are given" : "is given"));
  else if (given.front() == "rolling.hertz_pressure")
    r.drive.value = load_of_hertz_pressure(reader, c, r);
  return "rolling.distance";
}

std::string motion(const RollingCase& r, const RollingPlan& plan)
{
  return fmt::format("# Motion: {} steps of {:.6e} m, {}; {} = {:.6e} {}\n"
                     "# Contact: about {:.4e} x {:.4e} m wide\n",
                     plan.rolling_steps, plan.shift, passes_text(r.passes),
                     r.drive.kind == contact::Drive::Kind::load ? "load" : "approach", r.drive.value,
                     r.drive.kind == contact::Drive::Kind::load ? "N" : "m", 2.0 * plan.half_width_x,
                     2.0 * plan.half_width_y);
}

std::string place(const Case&, const RollingRecord& record)
{
  return fmt::format("pass {}  x {:+.3e} m", record.pass, record.x);
}

std::string results(const Case&, const RollingSummary& s)
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

Json pass_json(const RollingPass& pass)
{
  Json json;
  for (const auto& column : simulation::columns<RollingPass>)
  {
    if (column.name == "unsteadiness")
      json["steady"] = pass.is_steady(); // beside what it follows from
    put(json, column, pass);
  }
  return json;
}

void summarise(Json& json, const Case& c, const RollingCase& r, const RollingPlan& plan, const RollingSummary& s)
{
  json["geometry"] = geometry_json(c);
  json["geometry"]["estimated_half_width_x_m"] = plan.half_width_x;
  json["geometry"]["estimated_half_width_y_m"] = plan.half_width_y;
  json["drive"] = {{r.drive.kind == contact::Drive::Kind::load ? "load_N" : "approach_m", r.drive.value}};
  json["max_share_at_shear_limit"] = s.max_share_at_shear_limit;
  json["passes"] = Json::array();
  for (const RollingPass& pass : s.passes)
    json["passes"].push_back(pass_json(pass));
  json["profile"] = {{"depth_m", s.profile.depth},
                     {"residual_xx_Pa", s.profile.residual_xx},
                     {"residual_yy_Pa", s.profile.residual_yy},
                     {"equivalent_plastic_strain", s.profile.equivalent_plastic_strain}};
  json["energy"] = energy_json(s);
  json["residual"] = residual_json(s);
  json["grid"]["shift_m"] = plan.shift;
}

void cite(Sources& sources, const RollingCase& r)
{
  sources.add("boucly2006", "rolling: both surfaces and their strain are carried past the contact");
  if (can_yield(r) && r.passes > 1)
    sources.add("johnson1985", "shakedown under repeated passes");
}

} // namespace

template <>
struct DescriptionOf<RollingCase>
{
  static ScenarioIo<RollingCase> make()
  {
    return {
        .name = "rolling",
        .text = "it rolls over it along x under load",
        .keys = keys,
        .read = read,
        .half_x = &RollingPlan::half_width_x,
        .half_y = &RollingPlan::half_width_y,
        .motion = motion,
        .is_key_step = [](const RollingCase&, const RollingRecord& record, NearestToMiddle& middle)
        { return middle(record.pass, record.x); },
        .key_steps = [](const RollingCase& r, const RollingPlan&) { return double(r.passes); },
        .place = place,
        .results = results,
        .summarise = summarise,
        .lists = {{"passes", columns(RollingPass())}},
        .key_numbers = [](const RollingCase&) -> std::vector<std::string> {
          return {"passes[].rut_depth_m", "passes[].resistance_N", "passes[].dissipation_J"};
        },
        .steps = "rolling.shift",
        .imposed_load = [](const RollingCase& r) { return r.drive.kind == Drive::Kind::load ? r.drive.value : 0.0; },
        .cite = cite,
    };
  }
};

template const ScenarioIo<RollingCase>& scenario_io<RollingCase>();

} // namespace brinell::io
