// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/reference/hertz.hpp"
#include "case_material.hpp"
#include "case_reader.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::io
{

namespace
{

simulation::Asperity asperity(const CaseReader& reader, const std::string& body)
{
  const std::string shape = body + ".shape.type";
  const std::string texture = body + ".texture.type";
  if (reader.get<std::string>(shape) != "sphere")
    reader.add(shape, "cannot pass another body; allowed with scenario = \"tugging\": \"sphere\"");
  if (reader.get<std::string>(texture) != "smooth")
    reader.add(texture, "is not possible with scenario = \"tugging\"; allowed: \"smooth\"");
  reader.problems.throw_if_any();
  return {reader.get<double>(body + ".shape.radius"), material(reader.values, reader.raw, body, reader.problems)};
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
    reader.add(key,
               fmt::format("is in units of the critical {}, but neither body can yield, so there is none; allowed: "
                           "tugging.normalised = false with a {}, or a yield stress for a body",
                           by_load ? "load P_c" : "interference alpha_c", by_load ? "force" : "length"));
    return;
  }
  const double given = reader.get<double>(key);
  if (by_load)
  {
    tugging.load = normalised ? given * c.first_yield->critical.load : given;
    tugging.interference =
        reference::point_contact_at_load(*c.equivalent_radius, c.contact_modulus, *tugging.load).approach;
    if (tugging.kinematics == simulation::Kinematics::paper)
      reader.add("tugging.kinematics", "goes with a constant height only; allowed with tugging.load: \"exact\"");
  }
  else
    tugging.interference = normalised ? given * c.first_yield->critical.interference : given;
  const double limit = std::min(tugging.lower.radius, tugging.upper.radius);
  if (!(tugging.interference < limit))
    reader.add(key, fmt::format("makes {:.4g} m, more than the radius of a sphere; allowed: < {:.4g} m{}",
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
  t.lower = asperity(reader, "lower");
  t.upper = asperity(reader, "upper");
  reader.problems.throw_if_any();
  static_cast<simulation::Numerics&>(t) = draft.numerics;
  warn_of_material("lower", t.lower.material, c);
  warn_of_material("upper", t.upper.material, c);
  if (t.lower.material.elastic.is_rigid() && t.upper.material.elastic.is_rigid())
    reader.add("upper.material.rigid", "leaves no body that deforms; allowed: one rigid body");
  set_first_yield(t.lower.material, t.upper.material, 1.0 / (1.0 / t.lower.radius + 1.0 / t.upper.radius), c);
  set_drive(reader, c, t);
  if (!reader.problems.empty())
    return;
  const double contact_radius = std::sqrt(*c.equivalent_radius * t.interference);
  warn_of_size(contact_radius, std::min(t.lower.radius, t.upper.radius), c);
  refuse_cells_and_shift(reader, t, t.shift, contact_radius, contact_radius, c);
  c.scenario = t;
}

} // namespace brinell::io
