// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/quality/quality.hpp"
#include "case_reader.hpp"
#include "io/scenarios/scenario_io.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <variant>

/// Checks of all scenarios that need more than the schema: whether the bodies can be in contact, whether the grid fits them, and
/// suspicious values.
namespace brinell::io
{

namespace
{

using simulation::ShapedBody;

/// Warns of values that can be computed but are rarely intended.
void warn_of_material(const std::string& name, const constitutive::Material& material, Case& c)
{
  constexpr double softest = 1e5;   // [Pa], a gel
  constexpr double stiffest = 1e15; // [Pa], a thousand times diamond; far above it small numbers in the fields are lost
  constexpr double stiffest_gigapascal = 1300.0; // diamond has 1100 GPa
  const double E = material.elastic.young_modulus;
  if (E < softest)
    warn(c, "soft_material",
         "{}.material.young_modulus is {:.4g} Pa, softer than any solid; is a unit missing, as in \"{:.4g} {}\"?", name,
         E, E, E < stiffest_gigapascal ? "GPa" : "MPa");
  if (std::isfinite(E) && E > stiffest)
    warn(c, "stiff_material",
         "{}.material.young_modulus is {:.4g} Pa, stiffer than any solid (diamond has 1.1e12 Pa); is the unit right? "
         "For a body that is not meant to deform, set rigid = true",
         name, E);
  if (!material.hardening)
    return;
  constexpr double lowest_yield = 1e5; // a pure metal in single crystals; a gel may have less, but of a small modulus
  const double yield_stress = constitutive::initial_yield_stress(material.law());
  if (yield_stress < std::min(lowest_yield, 1e-3 * E))
    warn(c, "low_yield",
         "{}.material.hardening: the yield stress is {:.4g} Pa, lower than that of any metal; is a unit missing, as in "
         "\"{:.4g} MPa\"? The unit of a file is set by hardening.stress_unit",
         name, yield_stress, yield_stress);
  if (yield_stress > 0.1 * E)
    warn(c, "hard_material", "{}: the yield stress is above a tenth of Young's modulus; strains will not be small",
         name);
}

/// Warns of strains that were probably given in percent, which makes a material that hardly hardens.
void warn_of_table(const CaseReader& reader, const std::string& name, Case& c)
{
  constexpr double largest_strain = 1.0; // reached in a tension or compression test
  const std::string key = name + ".material.hardening.plastic_strain";
  if (!reader.has(key))
    return;
  if (const double last = reader.get<std::vector<double>>(key).back(); last > largest_strain)
    warn(c, "large_table_strain",
         "{} goes up to {:.4g}, which is {:.4g} %; is it in percent? For strains of a file in percent, set "
         "hardening.strain_unit = \"%\"",
         key, last, 100.0 * last);
}

/// Root mean square slope of a part of a texture that is given by numbers; of a dent the ratio of depth to edge radius,
/// which is the slope of its flank to 20 %.
double steepness(const simulation::Dent& dent)
{
  return std::abs(dent.depth) / dent.edge_radius;
}
double steepness(const simulation::Sinusoid& waves)
{
  return std::numbers::pi * std::numbers::sqrt2 * std::abs(waves.amplitude) *
         std::hypot(1.0 / waves.wavelength_x, 1.0 / waves.wavelength_y);
}
double steepness(const simulation::RandomSurface& surface)
{
  return surface.rms_slope();
}

/// Warns of heights that were probably given in nm or um without a unit, which makes extremely steep surfaces. The
/// limit for height maps is also that of Python (brinell/surfaces/heightmap.py).
class OfHeights
{
public:
  OfHeights(const CaseReader& reader, std::string table, Case& c) : reader_(reader), table_(std::move(table)), case_(c)
  {
  }

  void operator()(const simulation::HeightMap& map) const
  {
    constexpr double steepest = 10.0; // of single points, which may be outliers
    const double slope = simulation::rms_slope(map);
    if (!(slope > steepest))
      return;
    const Given* const unit = reader_.raw.find(table_ + ".unit");
    warn(case_, "steep_texture",
         "{}: the height map has a root mean square slope of {:.3g} between points at {:.3g} x {:.3g} m; {}", table_,
         slope, map.dx, map.dy,
         unit ? fmt::format("is {}.unit = {} the unit of the file?", table_, shown(unit->raw))
              : fmt::format(
                    "is a unit missing? Heights of a file are in m unless {}.unit names another unit, such as \"um\"",
                    table_));
  }
  template <typename Part>
  void operator()(const Part& part) const
  {
    constexpr double steepest = 1.0; // 45 degrees
    if (const double slope = steepness(part); slope > steepest)
      warn(
          case_, "steep_texture",
          "{}: its slope is about {:.3g}, too steep for bodies that are computed as half spaces; is a unit missing, as "
          "in \"0.2 um\"? Plain numbers are in m",
          table_, slope);
  }

private:
  const CaseReader& reader_;
  std::string table_;
  Case& case_;
};

void warn_of_heights(const CaseReader& reader, const std::string& name, const simulation::Texture& texture, Case& c)
{
  const std::vector<std::string> tables = reader.raw.tables_of(name + ".texture");
  for (std::size_t i = 0; i < texture.parts.size(); ++i)
    std::visit(OfHeights(reader, texture.parts.size() == tables.size() ? tables[i] : name + ".texture", c),
               texture.parts[i]);
}

/// Warns of numbers beyond all that exists, which probably have a wrong unit.
void warn_of_unusual(const CaseReader& reader, Case& c)
{
  for (const Entry& entry : case_schema())
    if (const Usual& usual = entry.usual; usual.warning && reader.has(entry.key))
      if (const double value = reader.get<double>(entry.key); value < usual.min || value > usual.max)
        warn(c, usual.warning, "{} is {:.4g} {}, {}; is the unit right? {}", entry.key, value,
             si_unit(entry.of.dimension), usual.doubt, entry.hint);
}

void set_first_yield(const ShapedBody& lower, const ShapedBody& upper, const simulation::Domain& domain, Case& c)
{
  c.contact_modulus = contact_modulus(lower.material.elastic, upper.material.elastic);
  c.equivalent_radius = equivalent_radius(lower.shape, upper.shape);
  if (contact_kind(lower.shape, upper.shape, domain) == simulation::ContactKind::line)
    c.equivalent_radius = 1.0 / (*simulation::relative_curvature(lower.shape, upper.shape))[0];
  c.first_yield = simulation::nominal_first_yield(lower, upper, domain);
  c.coated_yield = simulation::coated_yield(lower, upper, domain);
  for (const auto& [name, body] : {std::pair{"lower", &lower}, {"upper", &upper}})
    if (!body->material.layers.empty())
      c.notes.push_back(fmt::format("{}.material.layers: {}forecast and expected errors are those of the substrate "
                                    "without layers",
                                    name, c.coated_yield ? "normalised quantities, " : "first yield, "));
}

/// Reads both bodies, and derives the quantities that depend on them alone.
/// @param against_shape  why the scenario does not allow a shape; empty if it does
void read_pair(const CaseReader& reader, Case& c, ShapedBody& lower, ShapedBody& upper, simulation::Domain& domain,
               std::string_view (*against_shape)(const simulation::Shape& shape))
{
  const bool domain_is_known = reader.problems.empty(); // otherwise its sizes may be meaningless defaults
  for (const auto& [name, body] : {std::pair{"lower", &lower}, {"upper", &upper}})
  {
    *body = read_body(reader, name, domain_is_known ? &domain : nullptr);
    if (const auto reason = against_shape(body->shape); !reason.empty())
      reader.add(fmt::format("{}.shape.type", name), reason);
    const auto* roller = std::get_if<simulation::Roller>(&body->shape);
    const std::string length = fmt::format("{}.shape.length", name);
    if (roller && std::isinf(roller->length) && !domain.y.is_periodic())
      reader.missing(length, "length > 0, in m or with a unit; none with grid.boundary = [\"open\", \"periodic\"]");
  }
  for (const auto& [name, body] : {std::pair{"lower", &lower}, {"upper", &upper}})
    if (const auto reason = domain_is_known ? simulation::reason_against_texture(body->texture, domain) : std::nullopt)
      reader.problems.add(reader.place(fmt::format("{}.texture.type", name)),
                          fmt::format("{}.texture does not fit the period: {}", name, *reason));
  reader.problems.throw_if_any();
  for (const auto& [name, body] : {std::pair{"lower", &lower}, {"upper", &upper}})
    if (!body->inclusions.empty())
      c.notes.push_back(
          fmt::format("{}.inclusion: first yield and critical values are those of the body without inclusions, and no "
                      "expected errors are stated",
                      name));
  warn_of_material("lower", lower.material, c);
  warn_of_material("upper", upper.material, c);
  for (const auto& [name, body] : {std::pair{"lower", &lower}, {"upper", &upper}})
  {
    warn_of_thermal(reader, name, body->material, c);
    warn_of_table(reader, name, c);
    warn_of_heights(reader, name, body->texture, c);
  }
  warn_of_unusual(reader, c);
  if (lower.material.elastic.is_rigid() && upper.material.elastic.is_rigid())
    reader.add("upper.material.rigid", "leaves no body that deforms; allowed: one rigid body");
  if (const auto reason = simulation::reason_against_contact(lower, upper, domain))
    reader.add("upper.shape.type", "and the lower body " + *reason);
  set_first_yield(lower, upper, domain, c);
}

/// Smallest radius of either body in the plane of an axis and the normal [m].
double smallest_radius(const ShapedBody& lower, const ShapedBody& upper, std::size_t axis)
{
  double largest = 0.0;
  for (const ShapedBody* body : {&lower, &upper})
    if (const auto k = simulation::curvature(body->shape))
      largest = std::max(largest, std::abs((*k)[axis]));
  return 1.0 / largest; // infinite without curvature
}

/// Warns of a contact so large that the bodies are no half spaces.
void warn_of_large_contact(const ShapedBody& lower, const ShapedBody& upper, const std::array<double, 2>& half, Case& c)
{
  constexpr double large = 0.3;
  for (std::size_t axis = 0; axis < half.size(); ++axis)
    if (const double radius = smallest_radius(lower, upper, axis); half[axis] > large * radius)
      warn(c, "large_contact",
           "the contact radius along {}, {:.3g} m, is large compared with the bodies (radius {:.3g} m), which are "
           "computed as half spaces",
           axis == 0 ? "x" : "y", half[axis], radius);
}

/// A stride that does not divide a period would not repeat with it.
void check_stride(const CaseReader& reader, const Case& c, const SurfaceGrid& grid)
{
  const int stride = c.output.cells.stride;
  for (const auto& [cells, is_periodic] :
       {std::pair{grid.nx, grid.is_periodic_x()}, {grid.ny, grid.is_periodic_y() && grid.ny > 1}})
    if (is_periodic && cells % stride != 0)
      reader.add("output.stride", "does not divide the {} cells of a period; allowed: a divisor", cells);
}

/// Warns of a distance that is no whole number of steps.
template <typename ScenarioCase, typename Plan>
void warn_of_other_way(Case& c, const ScenarioCase& scenario, const Plan& plan)
{
  constexpr double rounding = 1e-6;
  if (std::abs(plan.way() - scenario.distance) <= rounding * scenario.distance)
    return;
  const std::string_view name = io_of(scenario).name;
  warn(
      c, "rounded_distance",
      "{0}.distance = {1:.6g} m is no {2} number of steps of {3:.6g} m, so that {4:.6g} m are computed; {0}.distance = "
      "{4:.6g}, or cells from grid.resolution without a shift, which fit the distance, leave no difference",
      name, scenario.distance, name == "rolling" ? "even" : "whole", plan.shift, plan.way());
}

/// Makes the plan, which detects absurd grids and inconsistent lengths (reported at `key`). With the size of the contact from the
/// plan it checks that the bodies can be treated as half spaces, and that neither cells nor steps are larger than the contact.
template <typename ScenarioCase>
void check_plan(const CaseReader& reader, Case& c, const ScenarioCase& scenario)
{
  const ScenarioIo<ScenarioCase>& io = io_of(scenario);
  const auto plan = simulation::plan(scenario);
  const double half_x = plan.*io.half_x, half_y = plan.*io.half_y;
  warn_of_large_contact(scenario.lower, scenario.upper, {half_x, half_y}, c);
  const double rows =
      simulation::is_plane(plan.contact) ? plan.contact.dy : half_y; // in plane strain a row may have any length
  if (scenario.spacing)
    if (const auto reason = quality::reason_against_cells(*scenario.spacing, half_x, rows))
      reader.problems.add(c.grid_source, *reason);
  check_stride(reader, c, plan.contact);
  if constexpr (requires { plan.way(); })
    warn_of_other_way(c, scenario, plan);
  if constexpr (requires { scenario.shift; })
    if (scenario.shift)
      if (const auto reason = quality::reason_against_shift(*scenario.shift, half_x))
        reader.add(fmt::format("{}.shift", io.name), *reason);
}

/// Warns of keys about heat that differ from their defaults although heat is not computed.
void warn_of_keys_without_heat(const CaseReader& reader, Case& c, const std::string& speed)
{
  const auto differs = [&](const std::string& key)
  {
    const std::optional<Value>& fallback = find_entry(key)->fallback;
    if (!reader.has(key) || !fallback)
      return reader.has(key);
    if (std::holds_alternative<bool>(*fallback))
      return reader.get<bool>(key) != std::get<bool>(*fallback);
    return reader.get<double>(key) != std::get<double>(*fallback);
  };
  for (const std::string& key : {speed, std::string("thermal.partition"), std::string("thermal.displacement"),
                                 std::string("thermal.heat_of_plastic_work"), std::string("thermal.stress"),
                                 std::string("interface.heat_fraction")})
    if (differs(key))
      warn(c, "no_heat",
           "{} has no effect: heat is computed only with interface.friction or thermal.source, and the thermal "
           "constants "
           "of a body",
           key);
}

/// Warns of everything about heat and softening in a case that has no effect.
template <typename ScenarioCase>
void warn_of_heat(const CaseReader& reader, Case& c, const ScenarioCase& scenario)
{
  constexpr bool can_heat = std::derived_from<typename ScenarioCase::Record, simulation::HeatedRecord>;
  const bool has_source = scenario.friction.coefficient > 0.0 || scenario.heat.source.exists();
  for (const auto& [name, body] : {std::pair{"lower", &scenario.lower}, {"upper", &scenario.upper}})
    if (body->material.thermal && !(can_heat && has_source) && !body->material.electrical)
      warn(c, "no_heat", "{}.material.thermal has no effect on the contact: {}", name,
           can_heat ? "without interface.friction or thermal.source there is no heat"
                    : "no heat is computed in this scenario");
  for (const auto& [name, body] : {std::pair{"lower", &scenario.lower}, {"upper", &scenario.upper}})
    if (body->material.softening && !(can_heat && has_source && body->material.thermal) &&
        !elastoplastic::Current::softens(
            body->material, scenario.current,
            {.boundary_x = scenario.domain.x.boundary, .boundary_y = scenario.domain.y.boundary}))
      warn(c, "no_heat", "{}.material.softening has no effect: no heat is computed in this case", name);
  if constexpr (can_heat)
    if (!(has_source && (scenario.lower.material.thermal || scenario.upper.material.thermal)))
      warn_of_keys_without_heat(reader, c, fmt::format("{}.{}", io_of(scenario).name, io_of(scenario).speed));
}

/// Reads the points whose histories are recorded.
template <typename ScenarioCase>
void read_points(const CaseReader& reader, Case& c, const ScenarioCase& scenario)
{
  for (const std::string& table : reader.raw.tables_of("output.points"))
  {
    const auto key = [&](const char* name) { return fmt::format("{}.{}", table, name); };
    if (!reader.has(key("depth")))
    {
      if (reader.has(key("x")) || reader.has(key("y")) || reader.has(key("body")))
        reader.missing(key("depth"), "a length >= 0, the depth of the point");
      continue;
    }
    const bool is_upper = reader.get_or<std::string>(key("body"), "lower") == "upper";
    if ((is_upper ? scenario.upper : scenario.lower).material.elastic.is_rigid())
      reader.problems.add(reader.place(key("depth")), fmt::format("{} is a point of the {} body, which is rigid; "
                                                                  "allowed: a body that deforms",
                                                                  table, is_upper ? "upper" : "lower"));
    c.output.points.push_back({is_upper, reader.get_or<double>(key("x"), 0.0), reader.get_or<double>(key("y"), 0.0),
                               reader.get<double>(key("depth"))});
  }
}

/// Checks the part of the cells that is stored.
void check_stored_cells(const CaseReader& reader, const StoredCells& cells)
{
  for (const auto& [key, region] : {std::pair{"output.region_x", &cells.region_x},
                                    {"output.region_y", &cells.region_y},
                                    {"output.region_z", &cells.region_z}})
    if (*region && ((*region)->size() != 2 || (*region)->front() > (*region)->back()))
      reader.add(key, "is no region; allowed: the first and the last coordinate, as in [\"-1 mm\", \"1 mm\"]");
}

template <typename ScenarioCase>
void complete_scenario(const CaseReader& reader, Case& c, ScenarioCase& scenario)
{
  const ScenarioIo<ScenarioCase>& io = io_of(scenario);
  read_domain(reader, scenario.domain, !io.moves);
  read_pair(reader, c, scenario.lower, scenario.upper, scenario.domain, io.against_shape);
  const std::string key = io.read(reader, c, scenario);
  warn_of_heat(reader, c, scenario);
  check_stored_cells(reader, c.output.cells);
  read_points(reader, c, scenario);
  scenario.fields_within = asks_for_fields_within(c.output);
  if (reader.problems.empty())
    at_its_key(reader, c, key, [&] { check_plan(reader, c, scenario); });
}

} // namespace

void complete(const CaseReader& reader, Case& c)
{
  std::visit([&](auto& scenario) { complete_scenario(reader, c, scenario); }, c.scenario);
}

} // namespace brinell::io
