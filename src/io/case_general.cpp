// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/reference/hertz.hpp"
#include "case_reader.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

/// Indentation and rolling: two bodies of any shape.
namespace brinell::io
{

namespace
{

using contact::Drive;
using simulation::ShapedBody;

double smallest_radius(const ShapedBody& body)
{
  const auto k = simulation::curvature(body.shape);
  const double largest = k ? std::max(std::abs((*k)[0]), std::abs((*k)[1])) : 0.0;
  return largest > 0.0 ? 1.0 / largest : std::numeric_limits<double>::infinity();
}

/// Both bodies, and what follows from them alone.
void read_pair(const CaseReader& reader, Case& c, ShapedBody& lower, ShapedBody& upper)
{
  lower = read_body(reader, "lower");
  upper = read_body(reader, "upper");
  reader.problems.throw_if_any();
  warn_of_material("lower", lower.material, c);
  warn_of_material("upper", upper.material, c);
  if (lower.material.elastic.is_rigid() && upper.material.elastic.is_rigid())
    reader.add("upper.material.rigid", "leaves no body that deforms; allowed: one rigid body");
  require_finite_contact(reader, lower.shape, upper.shape);
  set_first_yield(lower.material, upper.material, equivalent_radius(lower.shape, upper.shape), c);
}

/// Loads or approaches, whichever are given.
std::vector<Drive> sequence(const CaseReader& reader, const Case& c, const simulation::IndentationCase& indentation)
{
  const std::string key = reader.has("indentation.load") ? "indentation.load" : "indentation.approach";
  if (!reader.has(key))
  {
    reader.problems.add(reader.place(key),
                        "indentation needs one of indentation.load and indentation.approach, a list as "
                        "[\"10 N\", 0] or [\"2 um\", 0]");
    return {};
  }
  const bool by_load = key == "indentation.load";
  double unit = 1.0;
  if (reader.get<bool>("indentation.normalised"))
  {
    if (!c.first_yield)
    {
      reader.add(key,
                 "is in units of first yield, which exists for round bodies only, one of which can yield; allowed: "
                 "indentation.normalised = false with units");
      return {};
    }
    unit = by_load ? c.first_yield->critical.load : c.first_yield->critical.interference;
  }
  std::vector<Drive> drives;
  for (const double value : reader.get<std::vector<double>>(key))
    drives.push_back({by_load ? Drive::Kind::load : Drive::Kind::approach, value * unit});
  if (std::none_of(drives.begin(), drives.end(), [](const Drive& d) { return d.value > 0.0; }))
    reader.add(key, "never presses the bodies together; allowed: a list with a number > 0");
  const bool repeats = indentation.cycles > 1 || indentation.places.size() > 1;
  if (repeats && drives.back().value != 0.0)
    reader.add(key, "must end with 0 if there are several cycles or places");
  return drives;
}

/// Load whose elastic contact has that peak pressure.
double load_of_hertz_pressure(const CaseReader& reader, const Case& c, const simulation::RollingCase& rolling)
{
  const std::string key = "rolling.hertz_pressure";
  const double pressure = reader.get<double>(key);
  const auto k = simulation::relative_curvature(rolling.lower.shape, rolling.upper.shape);
  const double length = simulation::roller_length(rolling.lower.shape, rolling.upper.shape);
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

Drive rolling_drive(const CaseReader& reader, const Case& c, const simulation::RollingCase& rolling)
{
  std::vector<std::string> given;
  for (const char* key : {"rolling.load", "rolling.hertz_pressure", "rolling.approach"})
    if (reader.has(key))
      given.emplace_back(key);
  if (given.size() != 1)
  {
    reader.problems.add(reader.place(given.empty() ? "rolling.load" : given[1]),
                        fmt::format("{} of rolling.load, rolling.hertz_pressure and rolling.approach {}; one is needed",
                                    given.empty() ? "none" : "more than one",
                                    given.size() > 1 ? "are given" : "is given"));
    return {};
  }
  if (given[0] == "rolling.hertz_pressure")
    return {Drive::Kind::load, load_of_hertz_pressure(reader, c, rolling)};
  return {given[0] == "rolling.load" ? Drive::Kind::load : Drive::Kind::approach, reader.get<double>(given[0])};
}

} // namespace

void require_finite_contact(const CaseReader& reader, const simulation::Shape& lower, const simulation::Shape& upper)
{
  if (!simulation::contact_is_finite(lower, upper))
    reader.add("upper.shape.type",
               "on this lower body touches neither in a point nor in a line of finite length; allowed: "
               "a sum of curvatures > 0 along x and y, a tip, or a cylinder of finite length on a flat "
               "or on another cylinder");
}

void read_indentation(const CaseReader& reader, Draft& draft)
{
  Case& c = draft.c;
  simulation::IndentationCase& i = draft.indentation;
  static_cast<simulation::Numerics&>(i) = draft.numerics;
  read_pair(reader, c, i.lower, i.upper);
  i.sequence = sequence(reader, c, i);
  if (reader.problems.empty())
    if (const auto plan = planned(reader, c, i, "indentation.steps"))
    {
      warn_of_size(plan->contact_radius, std::min(smallest_radius(i.lower), smallest_radius(i.upper)), c);
      refuse_cells_and_shift(reader, i, {}, plan->contact_radius, plan->contact_radius_y, c);
    }
  c.scenario = i;
}

void read_rolling(const CaseReader& reader, Draft& draft)
{
  Case& c = draft.c;
  simulation::RollingCase& r = draft.rolling;
  static_cast<simulation::Numerics&>(r) = draft.numerics;
  read_pair(reader, c, r.lower, r.upper);
  r.drive = rolling_drive(reader, c, r);
  if (reader.problems.empty())
    if (const auto plan = planned(reader, c, r, "rolling.distance"))
    {
      warn_of_size(plan->half_width_x, std::min(smallest_radius(r.lower), smallest_radius(r.upper)), c);
      refuse_cells_and_shift(reader, r, r.shift, plan->half_width_x, plan->half_width_y, c);
    }
  c.scenario = r;
}

} // namespace brinell::io
