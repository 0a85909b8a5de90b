// SPDX-License-Identifier: BSD-3-Clause
#include "case_material.hpp"
#include "case_reader.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::io
{

namespace
{

/// A body that is a circle in the plane of motion, as passing another one takes.
simulation::ShapedBody passing_body(const CaseReader& reader, const std::string& body)
{
  simulation::ShapedBody b = read_body(reader, body);
  if (!simulation::passing_radius(b.shape))
    reader.add(body + ".shape.type", "cannot pass another body; allowed with scenario = \"tugging\": \"sphere\", "
                                     "\"ellipsoid\" or \"cylinder\"");
  return b;
}

double smaller_radius(const simulation::TuggingCase& tugging)
{
  return std::min(*simulation::passing_radius(tugging.lower.shape), *simulation::passing_radius(tugging.upper.shape));
}

/// Interference or load, whichever is given; of a load, the approach that elastic spheres would have.
void set_drive(const CaseReader& reader, Case& c, simulation::TuggingCase& tugging)
{
  const bool by_load = reader.has("tugging.load");
  const std::string key = by_load ? "tugging.load" : "tugging.interference";
  if (!reader.has(key))
  {
    reader.problems.add(reader.place(key),
                        "tugging.interference is missing; allowed: number > 0 in critical interferences, or with "
                        "tugging.normalised = false a length; or tugging.load instead");
    return;
  }
  const bool normalised = reader.get<bool>("tugging.normalised");
  if (normalised && !c.first_yield)
  {
    const bool round = equivalent_radius(tugging.lower.shape, tugging.upper.shape).has_value();
    reader.add(key, fmt::format("is in units of the critical {}, but {}, so there is none; allowed: "
                                "tugging.normalised = false with a {}{}",
                                by_load ? "load P_c" : "interference alpha_c",
                                round ? "neither body can yield" : "the bodies are not round where they touch",
                                by_load ? "force" : "length", round ? ", or a yield stress for a body" : ""));
    return;
  }
  const double given = reader.get<double>(key);
  if (by_load)
  {
    tugging.load = normalised ? given * c.first_yield->critical.load : given;
    tugging.interference = simulation::elastic_approach(tugging.lower, tugging.upper, *tugging.load);
    if (tugging.kinematics == simulation::Kinematics::paper)
      reader.add("tugging.kinematics", "goes with a constant height only; allowed with tugging.load: \"exact\"");
  }
  else
    tugging.interference = normalised ? given * c.first_yield->critical.interference : given;
  const double limit = smaller_radius(tugging);
  if (!(tugging.interference < limit))
    reader.add(key, fmt::format("makes {:.4g} m, more than the radius of a body; allowed: < {:.4g} m{}",
                                tugging.interference, limit,
                                normalised && !by_load
                                    ? fmt::format(" = {:.4g} alpha_c", limit / c.first_yield->critical.interference)
                                    : ""));
}

} // namespace

void read_tugging(const CaseReader& reader, Draft& draft)
{
  Case& c = draft.c;
  simulation::TuggingCase& t = draft.tugging;
  t.lower = passing_body(reader, "lower");
  t.upper = passing_body(reader, "upper");
  reader.problems.throw_if_any();
  require_finite_contact(reader, t.lower.shape, t.upper.shape);
  reader.problems.throw_if_any();
  static_cast<simulation::Numerics&>(t) = draft.numerics;
  warn_of_material("lower", t.lower.material, c);
  warn_of_material("upper", t.upper.material, c);
  if (t.lower.material.elastic.is_rigid() && t.upper.material.elastic.is_rigid())
    reader.add("upper.material.rigid", "leaves no body that deforms; allowed: one rigid body");
  set_first_yield(t.lower.material, t.upper.material, equivalent_radius(t.lower.shape, t.upper.shape), c);
  c.equivalent_radius = 1.0 / (*simulation::relative_curvature(t.lower.shape, t.upper.shape))[0];
  set_drive(reader, c, t);
  if (!reader.problems.empty())
    return;
  if (const auto plan = planned(reader, c, t, t.load ? "tugging.load" : "tugging.interference"))
  {
    warn_of_size(plan->elastic_contact_radius, smaller_radius(t), c);
    refuse_cells_and_shift(reader, t, t.shift, plan->elastic_contact_radius, plan->elastic_contact_radius_y, c);
  }
  c.scenario = t;
}

} // namespace brinell::io
