// SPDX-License-Identifier: BSD-3-Clause
#include "description.hpp"

#include <cmath>
#include <limits>

/// Keys, texts and results of the scenario indentation.
namespace brinell::io
{

namespace
{

using contact::Drive;
using simulation::Indent;
using simulation::IndentationCase;
using simulation::IndentationPlan;
using simulation::IndentationRecord;
using simulation::IndentationSummary;

constexpr const char* indentation_drive = "indentation drive";

/// A key with a list of numbers, which is the sequence of the drive.
/// @param other  the key that may be given instead; both may be normalised. Empty for a mean over a period
Entry drive(const std::string& key, const ValueKind& of, Drive::Kind kind, const std::string& other, const char* text)
{
  const std::string table = "indentation.";
  return {.key = table + key,
          .of = of.list(),
          .unset = other.empty() ? "indentation.load or indentation.approach" : table + other,
          .text = text,
          .excludes = other.empty() ? "" : table + other,
          .one_of = indentation_drive,
          .pure_if = other.empty() ? "" : "indentation.normalised",
          .fill = [kind](Case& c, const Value& value)
          {
            for (const double number : std::get<std::vector<double>>(value))
              std::get<IndentationCase>(c.scenario).sequence.push_back({kind, number});
          }};
}

std::vector<Entry> indentation_keys()
{
  return {
      {.key = "indentation.normalised",
       .of = kind::boolean,
       .fallback = false,
       .text = "Whether load and approach are given in units of their values at first yield, P_c and alpha_c; needs "
               "round bodies, or cylinders in plane strain, at least one of which can yield."},
      drive("load", kind::force.at_least(0.0), Drive::Kind::load, "approach",
            "Sequence of loads, starting from zero: [\"10 N\", 0] presses and lifts off."),
      drive("approach", kind::length.at_least(0.0), Drive::Kind::approach, "load",
            "Sequence of approaches, counted from the first touch of the undeformed bodies without their textures, "
            "instead of loads."),
      drive("pressure", kind::pressure.at_least(0.0), Drive::Kind::load, "",
            "Sequence of mean pressures over the period, instead of loads; with grid.boundary = \"periodic\"."),
      drive("mean_gap", kind::length.above(0.0), Drive::Kind::mean_gap, "",
            "Sequence of mean gaps of the deformed surfaces over the period, instead of loads; with grid.boundary = "
            "\"periodic\". The mean gap decreases as the bodies are pressed together; a gap larger than that of first "
            "touch lifts off: [\"0.1 um\", \"5 um\"] presses and lifts off."),
      bound({.key = "indentation.steps",
             .of = kind::number.between(1, 100000),
             .text = "Number of steps from one entry of the list to the next, with equal increments of approach or "
                     "mean gap, or of load^(2/3) if the load is imposed."},
            &IndentationCase::steps),
      bound({.key = "indentation.cycles",
             .of = kind::number.between(1, 10000),
             .text = "Number of times that the list is applied at each place."},
            &IndentationCase::cycles),
      bound({.key = "indentation.places",
             .of = kind::length,
             .text = "Places along x on the lower body that are indented one after the other."},
            &IndentationCase::places),
  };
}

/// Unit of the numbers of a key [N] or [m]. If the key is not allowed in this case, a problem is added and the result is none.
std::optional<double> unit_of_drive(const CaseReader& reader, const Case& c, const IndentationCase& indentation,
                                    const std::string& key)
{
  const simulation::Domain& domain = indentation.domain;
  const bool is_gap = key == "indentation.mean_gap";
  if (is_gap || key == "indentation.pressure")
  {
    if (reader.get<bool>("indentation.normalised"))
      reader.add("indentation.normalised", "goes with a load or an approach, and not with {}", key);
    if (domain.is_periodic())
      return is_gap ? 1.0 : domain.x.size * domain.y.size;
    reader.add(key, "is the mean over a period; allowed with grid.boundary = \"periodic\"; otherwise {}",
               is_gap ? "indentation.approach" : "indentation.load");
    return std::nullopt;
  }
  if (!reader.get<bool>("indentation.normalised"))
    return 1.0;
  if (c.first_yield)
    return key == "indentation.load" ? c.first_yield->critical.load : c.first_yield->critical.interference;
  reader.add(key, "is in units of first yield, but {}; allowed: indentation.normalised = false with units{}",
             reason_against_first_yield(indentation.lower, indentation.upper, domain).value(),
             can_yield(indentation) ? "" : ", or a yield stress for a body");
  return std::nullopt;
}

std::string read(const CaseReader& reader, Case& c, IndentationCase& i)
{
  std::string key = reader.only_one_of(indentation_drive,
                                       ", as a list: [\"10 N\", 0], [\"2 um\", 0], [\"50 MPa\", 0] or [\"0.1 um\"]");
  const auto unit = key.empty() ? std::nullopt : unit_of_drive(reader, c, i, key);
  if (!unit)
    return key;
  for (Drive& drive : i.sequence)
    drive.value *= *unit;
  if (i.sequence.front().kind ==
      Drive::Kind::mean_gap) // the plan checks whether there is contact, and whether it ends without
    return key;
  if (std::none_of(i.sequence.begin(), i.sequence.end(), [](const Drive& d) { return d.value > 0.0; }))
    reader.add(key, "never presses the bodies together; allowed: a list with a number > 0");
  if ((i.cycles > 1 || i.places.size() > 1) && i.sequence.back().value != 0.0)
    reader.add(key, "must end with 0 if there are several cycles or places");
  return key;
}

std::string motion(const IndentationCase& i, const IndentationPlan& plan)
{
  std::string text = fmt::format("# Indentation: {} steps at {}; largest contact radius about {:.4e} m\n", plan.steps,
                                 count_text(static_cast<int>(i.places.size()), "place", "places"), plan.contact_radius);
  if (!std::isnan(plan.touching_gap))
    text += fmt::format("# The surfaces first touch at a mean gap of {:.4e} m\n", plan.touching_gap);
  return text;
}

std::string place(const Case&, const IndentationRecord& record)
{
  if (!std::isnan(record.contact_fraction)) // a period
    return fmt::format("mean gap {:.3e} m  pressure {:.3e} Pa  contact {:.3g} %", record.mean_gap,
                       record.nominal_pressure, 100.0 * record.contact_fraction);
  return fmt::format("approach {:.3e} m  load {:.3e} N", record.approach, record.F_n);
}

std::string results(const Case&, const IndentationSummary& s)
{
  std::string text = table_text(
      "place cycle      load [N]  approach [m] hardness [Pa] unloading [N/m] residual [m]  pile-up [m]\n", s.indents,
      [](const Indent& i)
      {
        const std::string unloading =
            std::isnan(i.unloading_stiffness) ? "-" : fmt::format("{:.6e}", i.unloading_stiffness);
        return fmt::format("{:5} {:5} {:13.6e} {:13.6e} {:13.6e}   {:>13} {:12.5e} {:12.5e}\n", i.place, i.cycle,
                           i.max_load, i.max_approach, i.hardness, unloading, i.residual_depth, i.pile_up);
      });
  if (std::any_of(s.indents.begin(), s.indents.end(), [](const Indent& i) { return i.max_approach < 0.0; }))
    text += "approach: from where the mean planes meet; negative while peaks hold them apart\n";
  return text;
}

Json normalised_indent_json(const Case& c, const Indent& i)
{
  const reference::CriticalValues scale = scale_of(c);
  return {{"max_load", i.max_load / scale.load},
          {"max_approach", i.max_approach / scale.interference},
          {"contact_area", i.contact_area / scale.contact_area},
          {"final_approach", i.final_approach / scale.interference},
          {"residual_depth", i.residual_depth / scale.interference},
          {"work", i.work / scale.energy}};
}

void summarise(Json& json, const Case& c, const IndentationCase& /*i*/, const IndentationPlan& plan,
               const IndentationSummary& s)
{
  json["geometry"] = geometry_json(c);
  json["geometry"]["estimated_contact_radius_m"] = plan.contact_radius;
  json["geometry"]["touching_gap_m"] = plan.touching_gap;
  json["geometry"]["rms_height_m"] = s.rms_height;
  json["geometry"]["rms_slope"] = s.rms_slope;
  json["indents"] = rows_json(s.indents);
  json["normalised"] = Json::array();
  for (const Indent& indent : s.indents)
    json["normalised"].push_back(normalised_indent_json(c, indent));
}

simulation::Course course(const IndentationCase& i, const IndentationPlan& plan)
{
  const Drive::Kind kind = i.sequence.front().kind;
  const auto pressed = [&](double value) { return kind == Drive::Kind::mean_gap ? -value : value; };
  simulation::Course course{.kind = simulation::RunKind::indentation};
  const auto places = static_cast<double>(i.places.size());
  double before = kind == Drive::Kind::mean_gap ? -std::numeric_limits<double>::infinity() : 0.0;
  for (const Drive& drive : i.sequence)
  {
    (pressed(drive.value) > before ? course.loading : course.unloading) += places * i.steps;
    before = pressed(drive.value);
  }
  course.again = plan.steps - course.loading - course.unloading;
  return course;
}

} // namespace

template <>
ScenarioIo<IndentationCase> description()
{
  return {
      .name = "indentation",
      .text = "the upper body is pressed into the lower one and lifted off again, at one place or at several",
      .keys = indentation_keys,
      .read = read,
      .half_x = &IndentationPlan::contact_radius,
      .half_y = &IndentationPlan::contact_radius_y,
      .moves = false,
      .motion = motion,
      .course = course,
      .is_key_step = [](const IndentationCase& i, const IndentationRecord& record, NearestToMiddle&)
      { return (record.step + 1) % i.steps == 0; },
      .key_steps = [](const IndentationCase& i, const IndentationPlan& plan) { return plan.steps / double(i.steps); },
      .aligned = "in an indentation the steps that reach an entry of the list",
      .place = place,
      .results = results,
      .summarise = summarise,
      .lists = {{"indents", columns(Indent())}},
      .key_numbers = [](const IndentationCase& i) -> std::vector<std::string>
      {
        const bool by_load = i.sequence.front().kind == Drive::Kind::load;
        return {by_load ? "indents[].max_approach_m" : "indents[].max_load_N", "indents[].hardness_Pa",
                "indents[].residual_depth_m"};
      },
      .steps = "indentation.steps",
      .enough_steps = 4, // docs/verification/accuracy.md (few steps)
  };
}

template const ScenarioIo<IndentationCase>& scenario_io<IndentationCase>();

} // namespace brinell::io
