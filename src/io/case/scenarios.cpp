// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/reference/hertz.hpp"
#include "case_reader.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

/// What of the scenarios takes judgement: bodies that go together, drives in several units, grids that fit them.
namespace brinell::io
{

namespace
{

using contact::Drive;
using simulation::IndentationCase;
using simulation::RollingCase;
using simulation::ShapedBody;
using simulation::TuggingCase;

/// What can be computed, but is seldom meant.
void warn_of_material(const std::string& name, const constitutive::Material& material, Case& c)
{
  constexpr double softest = 1e5;   // a gel
  constexpr double stiffest = 1e15; // a thousand times diamond; far beyond it small numbers of the fields are lost
  const double E = material.elastic.young_modulus;
  if (E < softest)
    c.warnings.push_back(
        {"soft_material",
         fmt::format(
             "{}.material.young_modulus is {:.4g} Pa, softer than any solid; is a unit missing, as in \"{:.4g} GPa\"?",
             name, E, E)});
  if (std::isfinite(E) && E > stiffest)
    c.warnings.push_back(
        {"stiff_material",
         fmt::format(
             "{}.material.young_modulus is {:.4g} Pa, stiffer than any solid (diamond has 1.1e12 Pa); is the unit "
             "right? What is not meant to deform has rigid = true",
             name, E)});
  if (!material.hardening)
    return;
  constexpr double lowest_yield = 1e5; // a pure metal in single crystals; a gel may have less, but of a small modulus
  const double yield_stress = constitutive::initial_yield_stress(*material.hardening);
  if (yield_stress < std::min(lowest_yield, 1e-3 * E))
    c.warnings.push_back(
        {"low_yield",
         fmt::format("{}.material.hardening: the yield stress is {:.4g} Pa, lower than that of any metal; is a unit "
                     "missing, as in \"{:.4g} MPa\"? That of a file is hardening.stress_unit",
                     name, yield_stress, yield_stress)});
  if (yield_stress > 0.1 * E)
    c.warnings.push_back(
        {"hard_material",
         fmt::format("{}: the yield stress is above a tenth of Young's modulus; strains will not be small", name)});
}

/// Strains in percent make a material that hardly hardens.
void warn_of_table(const CaseReader& reader, const std::string& name, Case& c)
{
  constexpr double largest_strain = 1.0; // that a tension or compression test reaches
  const std::string key = name + ".material.hardening.plastic_strain";
  if (!reader.has(key))
    return;
  if (const double last = reader.get<std::vector<double>>(key).back(); last > largest_strain)
    c.warnings.push_back(
        {"large_table_strain",
         fmt::format("{} goes up to {:.4g}, which is {:.4g} %; is it in percent? That of a file may be "
                     "told by hardening.strain_unit = \"%\"",
                     key, last, 100.0 * last)});
}

void set_first_yield(const ShapedBody& lower, const ShapedBody& upper, const simulation::Domain& domain, Case& c)
{
  c.contact_modulus = contact_modulus(lower.material.elastic, upper.material.elastic);
  c.equivalent_radius = equivalent_radius(lower.shape, upper.shape);
  if (contact_kind(lower.shape, upper.shape, domain) == simulation::ContactKind::line)
    c.equivalent_radius = 1.0 / (*simulation::relative_curvature(lower.shape, upper.shape))[0];
  c.first_yield = simulation::nominal_first_yield(lower, upper, domain);
}

/// Both bodies, and what follows from them alone.
/// @param passing  each must be a circle in the plane of motion, as passing another one takes
void read_pair(const CaseReader& reader, Case& c, ShapedBody& lower, ShapedBody& upper, simulation::Domain& domain,
               bool passing = false)
{
  const bool domain_is_known = reader.problems.empty(); // else its sizes are defaults that nobody has given
  for (const auto& [name, body] : {std::pair{"lower", &lower}, {"upper", &upper}})
  {
    *body = read_body(reader, name);
    if (passing && !simulation::passing_radius(body->shape))
      reader.add(fmt::format("{}.shape.type", name), "cannot pass another body; allowed with scenario = \"tugging\": "
                                                     "\"sphere\", \"ellipsoid\" or \"cylinder\"");
    const auto* roller = std::get_if<simulation::Roller>(&body->shape);
    const std::string length = fmt::format("{}.shape.length", name);
    if (roller && std::isinf(roller->length) && !domain.y.is_periodic())
      reader.problems.add(reader.place(length),
                          fmt::format("{} is missing; allowed: length > 0, in m or with a unit; none with "
                                      "grid.boundary = [\"open\", \"periodic\"]",
                                      length));
  }
  for (const auto& [name, body] : {std::pair{"lower", &lower}, {"upper", &upper}})
    if (const auto reason = domain_is_known ? simulation::reason_against_texture(body->texture, domain) : std::nullopt)
      reader.problems.add(reader.place(fmt::format("{}.texture.type", name)),
                          fmt::format("{}.texture does not fit the period: {}", name, *reason));
  reader.problems.throw_if_any();
  warn_of_material("lower", lower.material, c);
  warn_of_material("upper", upper.material, c);
  for (const char* name : {"lower", "upper"})
    warn_of_table(reader, name, c);
  if (lower.material.elastic.is_rigid() && upper.material.elastic.is_rigid())
    reader.add("upper.material.rigid", "leaves no body that deforms; allowed: one rigid body");
  if (const auto reason = simulation::reason_against_contact(lower, upper, domain))
    reader.add("upper.shape.type", "and the lower body " + *reason);
  set_first_yield(lower, upper, domain, c);
}

double smallest_radius(const ShapedBody& body)
{
  const auto k = simulation::curvature(body.shape);
  const double largest = k ? std::max(std::abs((*k)[0]), std::abs((*k)[1])) : 0.0;
  return largest > 0.0 ? 1.0 / largest : std::numeric_limits<double>::infinity();
}

/// Does what may find that the case cannot be computed; that is a problem at the key it names, at the source of the grid, or at
/// `key`.
template <typename Action>
void at_its_key(const CaseReader& reader, const Case& c, const std::string& key, const Action& action)
try
{
  action();
}
catch (const simulation::KeyError& error)
{
  reader.problems.add(reader.place(error.key()), error.what());
}
catch (const GridError& error)
{
  reader.problems.add(c.grid_source, error.what());
}
catch (const InputError& error)
{
  reader.add(key, fmt::format("does not fit: {}", error.what()));
}

/// The plan tells apart grids beyond all measure, and lengths that do not go together: these stand at `key`. Then the size of
/// the contact is known: the bodies are computed as half spaces, and neither cells nor steps may be larger than it.
template <typename ScenarioCase>
void check_plan(const CaseReader& reader, Case& c, const ScenarioCase& scenario, double ScenarioCase::Plan::*half_x,
                double ScenarioCase::Plan::*half_y)
{
  constexpr double large = 0.3;
  const auto plan = simulation::plan(scenario);
  const double radius = std::min(smallest_radius(scenario.lower), smallest_radius(scenario.upper));
  if (plan.*half_x > large * radius)
    c.warnings.push_back(
        {"large_contact",
         fmt::format(
             "the contact radius, {:.3g} m, is large beside the bodies (radius {:.3g} m), which are computed as "
             "half spaces",
             plan.*half_x, radius)});
  const double rows = simulation::is_plane(plan.contact) ? plan.contact.dy : plan.*half_y; // any length is as good
  if (scenario.spacing)
    if (const auto reason = simulation::reason_against_cells(*scenario.spacing, plan.*half_x, rows))
      reader.problems.add(c.grid_source, *reason);
  if constexpr (requires { scenario.shift; })
    if (scenario.shift)
      if (const auto reason = simulation::reason_against_shift(*scenario.shift, plan.*half_x))
        reader.add(reader.get<std::string>("scenario") + ".shift", *reason);
}

template <typename ScenarioCase>
bool can_yield(const ScenarioCase& c)
{
  return c.lower.material.is_plastic() || c.upper.material.is_plastic();
}

/// Interference or load, whichever is given; of a load, the approach that elastic bodies would have.
void set_drive(const CaseReader& reader, const Case& c, TuggingCase& tugging)
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
               fmt::format(
                   "is in units of the critical {}, but {}, so there is none; allowed: tugging.normalised = false with "
                   "a {}{}",
                   by_load ? "load P_c" : "interference alpha_c",
                   reason_against_first_yield(tugging.lower, tugging.upper, tugging.domain).value(),
                   by_load ? "force" : "length", can_yield(tugging) ? "" : ", or a yield stress for a body"));
    return;
  }
  const double given = reader.get<double>(key);
  if (by_load)
  {
    tugging.load = normalised ? given * c.first_yield->critical.load : given;
    at_its_key(reader, c, key,
               [&] {
                 tugging.interference =
                     simulation::elastic_approach(tugging.lower, tugging.upper, *tugging.load, tugging.domain);
               });
    if (tugging.kinematics == simulation::Kinematics::paper)
      reader.add("tugging.kinematics", "goes with a constant height only; allowed with tugging.load: \"exact\"");
  }
  else
    tugging.interference = normalised ? given * c.first_yield->critical.interference : given;
  const double limit =
      std::min(*simulation::passing_radius(tugging.lower.shape), *simulation::passing_radius(tugging.upper.shape));
  if (!(tugging.interference < limit))
    reader.add(key, fmt::format("makes {:.4g} m, more than the radius of a body; allowed: < {:.4g} m{}",
                                tugging.interference, limit,
                                normalised && !by_load
                                    ? fmt::format(" = {:.4g} alpha_c", limit / c.first_yield->critical.interference)
                                    : ""));
}

/// The key that drives an indentation; empty, and a problem, if there is none or more than one.
std::string driving_key(const CaseReader& reader)
{
  std::vector<std::string> given;
  for (const char* key : {"indentation.load", "indentation.approach", "indentation.pressure", "indentation.mean_gap"})
    if (reader.has(key))
      given.emplace_back(key);
  if (given.size() == 1)
    return given.front();
  if (given.empty())
    reader.problems.add(
        reader.place("indentation.load"),
        "indentation needs one of indentation.load, indentation.approach, indentation.pressure and "
        "indentation.mean_gap, a list as [\"10 N\", 0], [\"2 um\", 0], [\"50 MPa\", 0] or [\"0.1 um\"]");
  else
    reader.add(given[1], fmt::format("cannot stand together with {}; keep one of them", given[0]));
  return {};
}

/// What a number of that key stands for [N], [m]; none, with the problem told, if it cannot stand in this case.
std::optional<double> unit_of_drive(const CaseReader& reader, const Case& c, const IndentationCase& indentation,
                                    const std::string& key)
{
  const simulation::Domain& domain = indentation.domain;
  const bool is_gap = key == "indentation.mean_gap";
  if (is_gap || key == "indentation.pressure")
  {
    if (reader.get<bool>("indentation.normalised"))
      reader.add("indentation.normalised", fmt::format("goes with a load or an approach, and not with {}", key));
    if (domain.is_periodic())
      return is_gap ? 1.0 : domain.x.size * domain.y.size;
    reader.add(key, fmt::format("is the mean over a period; allowed with grid.boundary = \"periodic\"; otherwise {}",
                                is_gap ? "indentation.approach" : "indentation.load"));
    return std::nullopt;
  }
  if (!reader.get<bool>("indentation.normalised"))
    return 1.0;
  if (c.first_yield)
    return key == "indentation.load" ? c.first_yield->critical.load : c.first_yield->critical.interference;
  reader.add(key,
             fmt::format("is in units of first yield, but {}; allowed: indentation.normalised = false with units{}",
                         reason_against_first_yield(indentation.lower, indentation.upper, domain).value(),
                         can_yield(indentation) ? "" : ", or a yield stress for a body"));
  return std::nullopt;
}

/// Loads, approaches, mean pressures or mean gaps, whichever are given.
std::vector<Drive> sequence(const CaseReader& reader, const Case& c, const IndentationCase& indentation,
                            const std::string& key)
{
  const auto unit = unit_of_drive(reader, c, indentation, key);
  if (!unit)
    return {};
  const Drive::Kind kind = key == "indentation.approach"   ? Drive::Kind::approach
                           : key == "indentation.mean_gap" ? Drive::Kind::mean_gap
                                                           : Drive::Kind::load;
  std::vector<Drive> drives;
  for (const double value : reader.get<std::vector<double>>(key))
    drives.push_back({kind, value * *unit});
  if (kind == Drive::Kind::mean_gap) // whether it presses, and ends without contact, the plan knows
    return drives;
  if (std::none_of(drives.begin(), drives.end(), [](const Drive& d) { return d.value > 0.0; }))
    reader.add(key, "never presses the bodies together; allowed: a list with a number > 0");
  const bool repeats = indentation.cycles > 1 || indentation.places.size() > 1;
  if (repeats && drives.back().value != 0.0)
    reader.add(key, "must end with 0 if there are several cycles or places");
  return drives;
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

Drive rolling_drive(const CaseReader& reader, const Case& c, const RollingCase& rolling)
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

void complete(const CaseReader& reader, Case& c, TuggingCase& t)
{
  read_domain(reader, t.domain, false);
  read_pair(reader, c, t.lower, t.upper, t.domain, true);
  reader.problems.throw_if_any();
  c.equivalent_radius = 1.0 / (*simulation::relative_curvature(t.lower.shape, t.upper.shape))[0];
  set_drive(reader, c, t);
  if (reader.problems.empty())
    at_its_key(reader, c, t.load ? "tugging.load" : "tugging.interference",
               [&]
               {
                 check_plan(reader, c, t, &simulation::TuggingPlan::elastic_contact_radius,
                            &simulation::TuggingPlan::elastic_contact_radius_y);
               });
}

void complete(const CaseReader& reader, Case& c, IndentationCase& i)
{
  read_domain(reader, i.domain, true);
  read_pair(reader, c, i.lower, i.upper, i.domain);
  const std::string key = driving_key(reader);
  if (!key.empty())
    i.sequence = sequence(reader, c, i, key);
  if (reader.problems.empty())
    at_its_key(reader, c, key,
               [&]
               {
                 check_plan(reader, c, i, &simulation::IndentationPlan::contact_radius,
                            &simulation::IndentationPlan::contact_radius_y);
               });
}

void complete(const CaseReader& reader, Case& c, RollingCase& r)
{
  read_domain(reader, r.domain, false);
  read_pair(reader, c, r.lower, r.upper, r.domain);
  r.drive = rolling_drive(reader, c, r);
  if (reader.problems.empty())
    at_its_key(
        reader, c, "rolling.distance",
        [&]
        { check_plan(reader, c, r, &simulation::RollingPlan::half_width_x, &simulation::RollingPlan::half_width_y); });
}

} // namespace

void complete(const CaseReader& reader, Draft& draft)
{
  const auto take = [&](auto& scenario)
  {
    static_cast<simulation::Numerics&>(scenario) = draft.numerics;
    complete(reader, draft.c, scenario);
    draft.c.scenario = scenario;
  };
  const auto& name = reader.get<std::string>("scenario");
  if (name == "tugging")
    take(draft.tugging);
  else if (name == "indentation")
    take(draft.indentation);
  else if (name == "rolling")
    take(draft.rolling);
  else
    throw InternalError(fmt::format("the scenario {} is in the schema, but is not built", name));
}

} // namespace brinell::io
