// SPDX-License-Identifier: BSD-3-Clause
#include "description.hpp"
#include "foundation/nan.hpp"

/// Keys, texts and results of the scenario tugging.
namespace brinell::io
{

namespace
{

using simulation::TuggingCase;
using simulation::TuggingPlan;
using simulation::TuggingRecord;
using simulation::TuggingSummary;

std::vector<Entry> tugging_keys()
{
  return {
      {.key = "tugging.normalised",
       .of = kind::boolean,
       .fallback = true,
       .text = "Whether the interference is given in units of the critical interference alpha_c at first yield, and "
               "the load in units of the critical load P_c; needs a body that can yield, and bodies whose relative "
               "curvature is the same along x and y, or cylinders in plane strain."},
      bound({.key = "tugging.interference",
             .of = kind::length.above(0.0),
             .unset = "tugging.load",
             .text = "Overlap in height of the undeformed bodies, without textures, when their centres are aligned "
                     "along x; the height of the centres is constant. Without an offset this is the largest overlap.",
             .excludes = "tugging.load",
             .pure_if = "tugging.normalised"},
            &TuggingCase::interference),
      bound({.key = "tugging.offset",
             .of = kind::length,
             .text =
                 "Offset of the upper centre from the lower one along y, so that the bodies pass beside each other. "
                 "It reduces the overlap along the line of centres by offset^2 / (2 (R1 + R2)), to second order. If "
                 "normalised, in units of the contact radius a_c at first yield. Not allowed with a load.",
             .pure_if = "tugging.normalised"},
            &TuggingCase::offset),
      bound({.key = "tugging.load",
             .of = kind::force.above(0.0),
             .unset = "tugging.interference",
             .text = "Normal force that is kept constant while the upper body rides over the lower one, instead of an "
                     "interference; in units of the critical load P_c if normalised. It is applied in the first eighth "
                     "of a pass and removed in the last. Only with exact kinematics.",
             .excludes = "tugging.interference",
             .pure_if = "tugging.normalised"},
            &TuggingCase::load),
      bound({.key = "tugging.shift",
             .of = kind::length.above(0.0),
             .unset = "one cell, dx",
             .text = "Arc by which the contact moves on each body per step (mean of both bodies). Preferably a whole "
                     "multiple of dx / 2; otherwise the surfaces are interpolated between cells. Under a load dx, or a "
                     "shift that is not a multiple of it, is made to fit the way on which the bodies touch."},
            &TuggingCase::shift),
      bound({.key = "tugging.kinematics",
             .choices = {"exact", "paper"},
             .text = "Relation of arc and sliding distance. exact: X = omega tan(theta); paper: Eqs. 9-13 of Boucly, "
                     "Nelias, Green (2006)."},
            &TuggingCase::kinematics),
      bound({.key = "tugging.passes",
             .of = kind::number.between(1, 10000),
             .text = "Number of passes of the upper body; after each pass it returns to the start, and both bodies "
                     "keep their deformation."},
            &TuggingCase::passes),
      bound({.key = "tugging.speed",
             .of = kind::velocity.above(0.0),
             .unset = "none; needed where friction heats",
             .text = "Speed of the upper surface over the lower one, taken as the sum of the speeds at which the "
                     "contact moves over both bodies. The heat of friction depends on it. The way back from pass to "
                     "pass takes as long as a pass."},
            &TuggingCase::speed),
  };
}

/// Each body must be a circle in the plane of motion, which passing another body requires.
std::string_view against_shape(const simulation::Shape& shape)
{
  return simulation::passing_radius(shape) ? ""
                                           : "cannot pass another body; allowed with scenario = \"tugging\": "
                                             "\"sphere\", \"ellipsoid\" or \"cylinder\"";
}

/// Sets interference or load, whichever is given. With a load, the interference is set to the approach of elastic bodies.
void set_drive(const CaseReader& reader, const Case& c, TuggingCase& tugging)
{
  const bool by_load = tugging.load.has_value();
  const std::string key = by_load ? "tugging.load" : "tugging.interference";
  if (!reader.has(key))
  {
    reader.missing(
        "tugging.interference",
        "number > 0 in critical interferences, or with tugging.normalised = false a length; or tugging.load instead");
    return;
  }
  const bool normalised = reader.get<bool>("tugging.normalised");
  if (normalised && !c.first_yield)
  {
    reader.add(
        key,
        "is in units of the critical {}, but {}, so there is none; allowed: tugging.normalised = false with a {}{}",
        by_load ? "load P_c" : "interference alpha_c",
        reason_against_first_yield(tugging.lower, tugging.upper, tugging.domain).value(), by_load ? "force" : "length",
        can_yield(tugging) ? "" : ", or a yield stress for a body");
    return;
  }
  if (normalised && by_load)
    *tugging.load *= c.first_yield->critical.load;
  else if (normalised)
    tugging.interference *= c.first_yield->critical.interference;
  if (by_load)
  {
    at_its_key(reader, c, key,
               [&] {
                 tugging.interference =
                     simulation::elastic_approach(tugging.lower, tugging.upper, *tugging.load, tugging.domain);
               });
    if (tugging.kinematics == simulation::Kinematics::paper)
      reader.add("tugging.kinematics", "goes with a constant height only; allowed with tugging.load: \"exact\"");
  }
  const double limit =
      std::min(*simulation::passing_radius(tugging.lower.shape), *simulation::passing_radius(tugging.upper.shape));
  if (!(tugging.interference < limit))
    reader.add(
        key, "makes {:.4g} m, more than the radius of a body; allowed: < {:.4g} m{}", tugging.interference, limit,
        normalised && !by_load ? fmt::format(" = {:.4g} alpha_c", limit / c.first_yield->critical.interference) : "");
}

/// Sets the offset. Whether the bodies touch at this offset is checked by the plan.
void set_offset(const CaseReader& reader, const Case& c, TuggingCase& tugging)
{
  const std::string key = "tugging.offset";
  if (tugging.offset == 0.0)
    return;
  if (tugging.load)
  {
    reader.add(key, "goes with a constant height only; allowed with tugging.load: 0");
    return;
  }
  if (reader.get<bool>("tugging.normalised") && c.first_yield) // otherwise the interference has been refused already
    tugging.offset *= c.first_yield->critical.contact_radius;
}

std::string read(const CaseReader& reader, Case& c, TuggingCase& t)
{
  reader.problems.throw_if_any();
  c.equivalent_radius = 1.0 / (*simulation::relative_curvature(t.lower.shape, t.upper.shape))[0];
  set_drive(reader, c, t);
  set_offset(reader, c, t);
  return t.load ? "tugging.load" : "tugging.interference";
}

std::string motion(const TuggingCase& t, const TuggingPlan& plan)
{
  return fmt::format("# Motion: from X = -{:.6e} m, {} steps per pass of {:.6e} m, {}\n"
                     "# Contact: elastic contact radius {:.4e} m{}\n",
                     plan.start_distance, plan.steps_per_pass, plan.shift, count_text(t.passes, "pass", "passes"),
                     plan.elastic_contact_radius,
                     plan.elastic_contact_radius == plan.elastic_contact_radius_y
                         ? ""
                         : fmt::format(" along x, {:.4e} m along y", plan.elastic_contact_radius_y));
}

std::string drive(const TuggingCase& t)
{
  return t.load ? fmt::format(", load = {:.6e} N, about {:.6e} m of approach", *t.load, t.interference)
                : fmt::format(", interference = {:.6e} m{}", t.interference,
                              t.offset == 0.0 ? "" : fmt::format(", offset = {:.6e} m", t.offset));
}

std::string drive_at_yield(const TuggingCase& t, const reference::CriticalValues& critical)
{
  return fmt::format("#   interference / alpha_c = {:.6g}\n", t.interference / critical.interference);
}

std::string place(const Case& c, const TuggingRecord& record)
{
  return fmt::format("X/R {:+.4f}", record.X / c.equivalent_radius.value_or(1.0));
}

std::string results(const Case& c, const TuggingSummary& s)
{
  const double X = s.X_at_peak_F_X / c.equivalent_radius.value_or(1.0);
  if (!c.first_yield)
    return fmt::format(
        "peak F_X  {:>13.6e} N at X/R = {:+.5f}\nmin F_X   {:>13.6e} N\npeak F_Z  {:>13.6e} N\nnet work  {:>13.6e} J\n",
        s.peak_F_X, X, s.min_F_X, s.peak_F_Z, s.work);
  const auto& critical = c.first_yield->critical;
  return fmt::format("peak F_X  {:>11.5f} P_c at X/R = {:+.5f}\nmin F_X   {:>11.5f} P_c\npeak F_Z  {:>11.5f} P_c\n"
                     "net work  {:>11.5f} U_c\n",
                     s.peak_F_X / critical.load, X, s.min_F_X / critical.load, s.peak_F_Z / critical.load,
                     s.work / critical.energy);
}

Json tugging_geometry_json(const Case& c, const TuggingCase& t, const TuggingPlan& plan)
{
  Json json = {{"lower_radius_m", simulation::passing_radius(t.lower.shape).value_or(nan)},
               {"upper_radius_m", simulation::passing_radius(t.upper.shape).value_or(nan)}};
  json.update(geometry_json(c));
  json["interference_m"] = t.interference;
  json["offset_m"] = t.offset;
  json["closest_interference_m"] = plan.closest.interference;
  json["start_distance_m"] = plan.start_distance;
  return json;
}

Json normalised_json(const Case& c, const TuggingCase& t, const TuggingSummary& s)
{
  const reference::CriticalValues scale = scale_of(c);
  return {{"interference", t.interference / scale.interference},
          {"peak_F_X", s.peak_F_X / scale.load},
          {"X_over_R_at_peak_F_X", s.X_at_peak_F_X / c.equivalent_radius.value_or(nan)},
          {"min_F_X", s.min_F_X / scale.load},
          {"peak_F_Z", s.peak_F_Z / scale.load},
          {"F_X_aligned", s.F_X_aligned / scale.load},
          {"F_Z_aligned", s.F_Z_aligned / scale.load},
          {"work_to_alignment", s.work_to_alignment / scale.energy},
          {"net_energy", s.work / scale.energy},
          {"dissipation_lower", s.dissipation_lower / scale.energy},
          {"dissipation_upper", s.dissipation_upper / scale.energy},
          {"energy_residual", s.energy_residual / scale.energy},
          {"max_residual_lower", s.max_residual_lower / scale.interference},
          {"max_residual_upper", s.max_residual_upper / scale.interference}};
}

Json forces_json(const TuggingCase& t, const TuggingSummary& s)
{
  Json json = {{"peak_F_X_N", s.peak_F_X}, {"X_at_peak_F_X_m", s.X_at_peak_F_X}, {"min_F_X_N", s.min_F_X},
               {"peak_F_Z_N", s.peak_F_Z}, {"F_X_aligned_N", s.F_X_aligned},     {"F_Z_aligned_N", s.F_Z_aligned}};
  if (t.offset != 0.0) // otherwise the force is a rounding error
    json["peak_F_Y_N"] = s.peak_F_Y;
  return json;
}

void summarise(Json& json, const Case& c, const TuggingCase& t, const TuggingPlan& plan, const TuggingSummary& s)
{
  json["geometry"] = tugging_geometry_json(c, t, plan);
  if (t.load)
    json["drive"] = {{"load_N", *t.load}};
  json["normalised"] = normalised_json(c, t, s);
  json["max_share_at_shear_limit"] = s.max_share_at_shear_limit;
  json["load_ratio"] = {{"aligned", s.load_ratio_aligned}, {"end", s.load_ratio_end}};
  json["forces"] = forces_json(t, s);
  json["energy"]["work_to_alignment_J"] = s.work_to_alignment;
}

void cite(Sources& sources, const TuggingCase& t)
{
  sources.add("boucly2006", "tugging of two asperities, their motion and forces");
  if (t.kinematics == simulation::Kinematics::paper)
    sources.add("boucly2006", "kinematics of Eqs. 9 to 13");
}

simulation::Course course(const TuggingCase& t, const TuggingPlan& plan)
{
  const double pass = plan.steps_per_pass + 1.0;
  return {.kind = simulation::RunKind::tugging, .moving = pass, .again = (t.passes - 1.0) * pass};
}

} // namespace

template <>
ScenarioIo<TuggingCase> description()
{
  return {
      .name = "tugging",
      .text = "the upper body is carried along x past the lower one at constant height or under a load",
      .keys = tugging_keys,
      .read = read,
      .half_x = &TuggingPlan::elastic_contact_radius,
      .half_y = &TuggingPlan::elastic_contact_radius_y,
      .against_shape = against_shape,
      .motion = motion,
      .drive = drive,
      .drive_at_yield = drive_at_yield,
      .course = course,
      .is_key_step = [](const TuggingCase&, const TuggingRecord& record, NearestToMiddle& middle)
      { return middle(record.pass, record.X); },
      .key_steps = [](const TuggingCase& t, const TuggingPlan&) { return double(t.passes); },
      .place = place,
      .results = results,
      .summarise = summarise,
      .result_parts = {"load_ratio", "forces", "heat"},
      .key_numbers = [](const TuggingCase&) -> std::vector<std::string> {
        return {"forces.peak_F_X_N", "forces.peak_F_Z_N", "energy.net_J", "residual.max_lower_m",
                "residual.max_upper_m"};
      },
      .steps = "tugging.shift",
      .cite = cite,
  };
}

template const ScenarioIo<TuggingCase>& scenario_io<TuggingCase>();

} // namespace brinell::io
