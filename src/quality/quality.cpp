// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/quality/quality.hpp"

#include "brinell/simulation/first_yield.hpp"
#include "foundation/nan.hpp"
#include "judgement_fatigue.hpp"
#include "judgement_parts.hpp"
#include "simulation/plan/footprint.hpp"
#include "simulation/plan/heat.hpp"
#include "simulation/plan/roughness.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <utility>

namespace brinell::quality
{

using namespace simulation;

namespace
{

// Limits of the warnings.
constexpr double hopeless_cells = 2.0;     ///< with fewer, a third of the energy is missing
constexpr int fewest_layers = 4;           ///< through the plastic zone
constexpr double smallest_approach = 1e-9; ///< [m], a few atoms, below which materials are no continuum
constexpr double part_of_profile =
    0.1; ///< largest part of a profile, over the yield stress, that layers of cells may miss
constexpr double loose_yield = 1e-2, loose_displacement = 1e-2, loose_contact = 1e-3;

/// Length of a contact, straight along y, that plane ends of one roller or both limit [m].
std::optional<double> length_between_ends(const Shape& lower, const Shape& upper, const Domain& domain)
{
  const auto curvature = relative_curvature(lower, upper);
  if (domain.y.is_periodic() || !curvature || (*curvature)[1] != 0.0)
    return std::nullopt;
  double length = std::numeric_limits<double>::infinity();
  for (const Shape* shape : {&lower, &upper})
    if (const auto* roller = std::get_if<Roller>(shape))
      length = std::min(length, roller->length);
  return std::isfinite(length) ? std::optional(length) : std::nullopt;
}

/// @param measured  which of them
std::string errors_text(const std::vector<ExpectedError>& errors, bool measured)
{
  std::string text;
  for (const ExpectedError& e : errors)
    if (e.measured.has_value() == measured)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", e.best() > 1.0 ? ">100 %" : percent_text(e.best()),
                          e.quantity);
  return text;
}

/// Collects the warnings about a run.
class Judge
{
public:
  Judge(const Facts& facts, Resolution resolution) : f_(facts) { result_.resolution = std::move(resolution); }

  void of_cells()
  {
    const Resolution& r = result_.resolution;
    if (std::isnan(r.cells))
      return;
    const double deciding = deciding_cells(f_, r);
    if (deciding >= fewest_cells)
      return;
    const std::string errors = errors_text(r.expected_errors, false);
    add("coarse_contact",
        fmt::format("the contact has only {:.2g} x {:.2g} cells per radius, along x and y; at least {} are needed for "
                    "errors of a few percent{}{}. Use a finer grid.resolution or grid.spacing, or --accuracy",
                    r.cells_x, r.cells_y,
                    f_.moves ? fmt::format("{:g} x {:g}", fewest_cells, fewest_cells_across)
                             : fmt::format("{0:g} x {0:g}", fewest_cells),
                    errors.empty() ? "" : "; expected errors: " + errors,
                    deciding < hopeless_cells ? "; with so few cells no number of this result is reliable" : ""));
  }

  void of_depth()
  {
    const std::optional<int> layers = result_.resolution.plastic_layers;
    if (layers && *layers > 0 && *layers < fewest_layers)
      add("coarse_depth", fmt::format("the plastic zone is only {} layer{} of cells deep; at least {} are needed: use "
                                      "thinner cells (grid.spacing) or a finer grid.resolution",
                                      *layers, *layers == 1 ? "" : "s", fewest_layers));
  }

  /// Warns of a contact that ends at the plane ends of a roller, where the pressure of a half space is singular.
  void of_ends()
  {
    add("sharp_end",
        fmt::format("the contact ends at the plane ends of a roller, {} apart: there the pressure grows without limit "
                    "as the cells become smaller, and with it the largest pressure and plastic strain and the deepest "
                    "dents and highest pile-up, for which no errors are given; the middle is hardly affected. A height "
                    "map as lower.texture or upper.texture can round the ends",
                    length_text(*f_.between_ends)));
  }

  /// Warns of layers of the material that contain no centre of a cell and therefore have no effect.
  void of_profiles()
  {
    for (std::size_t side = 0; side < 2; ++side)
    {
      const constitutive::Material& material = *f_.materials[side];
      if (!material.is_plastic())
        continue;
      const double yield = constitutive::initial_yield_stress(material.law());
      const bool is_lost = is_lost_in_layers(material.yield_factor, 1.0, part_of_profile) ||
                           is_lost_in_layers(material.initial_stress, 0.0, part_of_profile * yield);
      if (is_lost)
        add("coarse_profile", fmt::format("the yield_profile or the initial_stress of the {} body has a layer that is "
                                          "thinner than the layers of cells, {}, and contains no centre of a cell: "
                                          "part of the profile is lost; use thinner cells (grid.spacing)",
                                          side == 0 ? "lower" : "upper", length_text(f_.cell[2])));
    }
  }

  void of_step()
  {
    if (!f_.shift || !(*f_.shift > longest_share_of_radius * f_.half_x) || !(*f_.shift > 1.01 * f_.cell[0]))
      return;
    add("long_step",
        fmt::format("the contact moves by {} per step, {:.2g} contact radii; steps of more than {:g} radii leave gaps "
                    "in the history, with a further error of about {} of the plastic work: use a smaller shift",
                    length_text(*f_.shift), *f_.shift / f_.half_x, longest_share_of_radius,
                    percent_text(std::min(1.0, error_of_steps(f_)))));
  }

  void of_size()
  {
    if (f_.approach < smallest_approach)
      add("small_size", fmt::format("the bodies approach by only {}, less than a few atoms, where materials are not a "
                                    "continuum; are the load and the size as intended?",
                                    length_text(f_.approach)));
  }

  void of_scenario()
  {
    if (f_.warning)
      add(*f_.warning);
    of_tolerances();
    for (const Warning& warning : f_.further_warnings)
      add(warning);
  }

  void of_tolerances()
  {
    const elastoplastic::Settings& s = f_.solver;
    for (const auto& [key, value, limit] : {std::tuple{"yield_tolerance", s.yield_tolerance, loose_yield},
                                            {"displacement_tolerance", s.displacement_tolerance, loose_displacement},
                                            {"contact_tolerance", s.contact_tolerance, loose_contact}})
      if (value > limit)
        add("loose_tolerance", fmt::format("solver.{} = {:g} is loose: steps end before they have converged; with up "
                                           "to {:g} this error stays below that of usual cells",
                                           key, value, limit));
  }

  void of_expected_yield()
  {
    if (f_.can_yield && f_.first_yield && *f_.first_yield >= f_.approach)
      add("no_yield", fmt::format("nothing will yield, by estimate: the bodies approach by about {} and stay elastic, "
                                  "although a yield stress is given; is a unit missing?",
                                  length_text(f_.approach)));
  }

  /// Warns of a bulk temperature at which the yield stress is already reduced.
  void of_warm_bulk()
  {
    for (std::size_t side = 0; side < 2; ++side)
    {
      const constitutive::Material& material = *f_.materials[side];
      const double left = material.softening && material.is_plastic()
                              ? constitutive::softening_factor(*material.softening, material.temperature)
                              : 1.0;
      if (left < 1.0)
        add("softened_yield",
            fmt::format("at its bulk temperature of {:g} degC the {} body has only {} of its yield stress; {}",
                        material.temperature, side == 0 ? "lower" : "upper", percent_text(left),
                        f_.is_heated ? "first yield, and the normalised quantities, initial grids and tolerances that "
                                       "depend on it, use the full yield stress"
                                     : "but the full yield stress is used: softening acts only if the heat of friction "
                                       "is computed, which needs friction, a speed and thermal constants"));
    }
  }

  [[nodiscard]] std::vector<Warning>& warnings() { return result_.warnings; }
  void add(Warning warning) { result_.warnings.push_back(std::move(warning)); }

  [[nodiscard]] Quality result() && { return std::move(result_); }

private:
  void add(const char* key, std::string text) { add({key, std::move(text)}); }

  /// Whether the extreme values of a profile exceed those at the centres of all layers of cells by more than `most`.
  [[nodiscard]] bool is_lost_in_layers(const constitutive::DepthProfile& profile, double without, double most) const
  {
    if (profile.empty())
      return false;
    const double dz = f_.cell[2];
    const auto count = static_cast<std::size_t>(std::min(profile.depth().back() / dz, 1e6)) + 2;
    std::vector<double> sampled, given;
    for (std::size_t layer = 0; layer < count; ++layer)
      sampled.push_back(profile.at((static_cast<double>(layer) + 0.5) * dz, without));
    for (const double z : profile.depth())
      given.push_back(profile.at(z, without));
    const auto [least_sampled, most_sampled] = std::minmax_element(sampled.begin(), sampled.end());
    const auto [least_given, most_given] = std::minmax_element(given.begin(), given.end());
    return *most_given - *most_sampled > most || *least_sampled - *least_given > most;
  }

  const Facts& f_;
  Quality result_;
};

} // namespace

/// "1.23 nm"
std::string length_text(double metres)
{
  constexpr std::pair<double, const char*> units[] = {{1.0, "m"}, {1e-3, "mm"}, {1e-6, "um"}};
  for (const auto& [size, name] : units)
    if (std::abs(metres) >= size)
      return fmt::format("{:.3g} {}", metres / size, name);
  return fmt::format("{:.3g} nm", metres / 1e-9);
}

std::string percent_text(double share)
{
  const double percent = 100.0 * share;
  return std::abs(percent) < 99.5 ? fmt::format("{:.2g} %", percent) : fmt::format("{:.0f} %", percent);
}

Facts facts_of(const PairCase& c, const Plan& plan, double half_x, double half_y)
{
  Facts f;
  f.cell = {plan.contact.dx, plan.contact.dy, plan.lower.dz};
  f.half_x = half_x;
  f.half_y = half_y;
  f.approach = plan.scales.gap;
  f.can_yield = c.lower.material.is_plastic() || c.upper.material.is_plastic();
  const bool stressed =
      !c.lower.material.initial_stress.depth().empty() || !c.upper.material.initial_stress.depth().empty();
  // On textures stand peaks of pressure.
  f.is_smooth = are_smooth(c.lower, c.upper);
  f.inclusions = plan.inclusions;
  // Around inclusions the body yields earlier, and under layers earlier or later.
  const bool is_uniform = f.inclusions[0].cells + f.inclusions[1].cells == 0 && c.lower.material.layers.empty() &&
                          c.upper.material.layers.empty();
  if (!stressed && f.is_smooth && is_uniform)
    f.first_yield = plan.first_yield;
  f.solver = c.solver;
  f.is_plane = is_plane(plan.contact);
  f.is_patchy = c.domain.is_periodic();
  f.between_ends = length_between_ends(c.lower.shape, c.upper.shape, c.domain);
  f.cells_per_wave = cells_per_wave(c.lower, c.upper, c.domain, f.cell[0], f.cell[1]);
  f.cells_per_texture = cells_per_shortest_wave(c.lower, c.upper, f.cell[0], f.cell[1]);
  f.textures = {&c.lower.texture, &c.upper.texture};
  f.materials = {&c.lower.material, &c.upper.material};
  f.is_heated = is_heated(c);
  f.has_source = c.heat.source.exists();
  f.effects = elastoplastic::names_of(c, f.materials);
  f.effect_settings = c;
  for (std::size_t side = 0; side < 2; ++side)
    f.is_softened_by_current[side] = elastoplastic::Current::softens(*f.materials[side], c.current, plan.contact);
  f.has_thermal_stress = c.heat.stress;
  f.friction = c.friction.coefficient;
  f.shear_limit = c.friction.shear_limit.value_or(f.shear_limit);
  f.hardens = !c.lower.material.is_perfectly_plastic() && !c.upper.material.is_perfectly_plastic();
  f.peak_pressure = plan.peak_pressure;
  f.peak_over_yield = plan.peak_over_yield;
  f.is_yield_exact = !reason_against_first_yield(c.lower, c.upper, c.domain);
  return f;
}

Quality quality_before(const Facts& f)
{
  std::vector<Warning> of_flow;
  Resolution resolution = resolution_of(f, f.half_x / f.cell[0], f.half_y / f.cell[1], nullptr);
  std::vector<Warning> of_textures;
  const bool has_lost_textures = warn_of_textures(f, of_textures);
  const bool has_sharp_ends = f.between_ends && f.is_smooth; // ends with a texture may be rounded by it
  std::vector<Warning> of_coats;
  const bool has_coarse_coats = warn_of_coats(f, of_coats);
  // The tables are for surfaces below their shear limit, whose textures and coats the cells resolve, without inclusions and without singular pressures.
  if (warn_of_expected_flow(f, of_flow) || has_lost_textures || has_sharp_ends || has_coarse_coats || has_inclusions(f))
    resolution.expected_errors.clear();
  withhold_errors(f, nullptr, resolution, of_textures);
  Judge judge(f, std::move(resolution));
  judge.of_cells();
  if (has_sharp_ends)
    judge.of_ends();
  for (std::vector<Warning>* warnings : {&of_flow, &of_textures})
    for (Warning& warning : *warnings)
      judge.add(std::move(warning));
  judge.of_profiles();
  for (Warning& warning : of_coats)
    judge.add(std::move(warning));
  warn_of_inclusions(f, judge.warnings());
  judge.of_step();
  judge.of_size();
  judge.of_warm_bulk();
  judge.of_expected_yield();
  judge.of_scenario();
  return std::move(judge).result();
}

Quality quality_after(const Facts& f, const RunTotals& totals)
{
  const Coverage& seen = totals.coverage;
  const bool touched = seen.contact_columns > 0;
  const double cells_x = f.is_patchy ? f.half_x / f.cell[0] : 0.5 * seen.contact_columns;
  const double cells_y = f.is_patchy ? f.half_y / f.cell[1] : 0.5 * seen.contact_rows;
  Resolution resolution = resolution_of(f, touched ? cells_x : nan, touched ? cells_y : nan, &totals);
  std::vector<Warning> of_textures;
  const bool has_lost_textures = warn_of_textures(f, of_textures);
  // Rows that an end cuts may lie outside of the contact.
  const bool has_sharp_ends = f.between_ends && (seen.contact_rows + 2) * f.cell[1] >= *f.between_ends;
  std::vector<Warning> of_coats;
  const bool has_coarse_coats = warn_of_coats(f, of_coats);
  if (flows_at_surface(f, totals) || has_lost_textures || has_sharp_ends || has_coarse_coats ||
      has_inclusions(f)) // see quality_before
    resolution.expected_errors.clear();
  withhold_errors(f, &totals, resolution, of_textures);
  Judge judge(f, std::move(resolution));
  judge.of_cells();
  if (has_sharp_ends)
    judge.of_ends();
  judge.of_depth();
  for (Warning& warning : of_textures)
    judge.add(std::move(warning));
  judge.of_profiles();
  for (Warning& warning : of_coats)
    judge.add(std::move(warning));
  warn_of_inclusions(f, judge.warnings());
  judge.of_step();
  judge.of_size();
  judge.of_warm_bulk();
  warn_of_course(f, totals, judge.warnings());
  warn_of_heat(f, totals, judge.warnings());
  warn_of_effects(f, totals, judge.warnings());
  judge.of_scenario();
  Quality result = std::move(judge).result();
  judge_fatigue(totals, result);
  return result;
}

std::string resolution_text(const Resolution& r)
{
  if (std::isnan(r.cells) && !r.cells_per_wave)
    return "resolution: no contact";
  std::string text =
      r.cells_per_wave
          ? fmt::format("resolution: {:.3g} cells per shortest wave, for a contact of patches of various sizes",
                        *r.cells_per_wave)
          : fmt::format("resolution: {:.3g} x {:.3g} cells per contact radius", r.cells_x, r.cells_y);
  if (r.plastic_layers)
    text += *r.plastic_layers > 0 ? fmt::format(", {} layers through the plastic zone", *r.plastic_layers)
                                  : ", nothing yields";
  if (const std::string measured = errors_text(r.expected_errors, true); !measured.empty())
    text += fmt::format("; errors, measured by the series of runs: {}", measured);
  if (const std::string expected = errors_text(r.expected_errors, false); !expected.empty())
    text += fmt::format("; expected errors, estimated from the convergence tables: {}", expected);
  return text;
}

std::optional<std::string> reason_against_cells(const std::array<double, 3>& spacing, double half_x, double half_y)
{
  constexpr double rounding = 1e-9;
  if (spacing[0] <= half_x * (1.0 + rounding) && spacing[1] <= half_y * (1.0 + rounding))
    return std::nullopt;
  return fmt::format("cells of {} x {} for a contact with half-widths of about {} x {}; allowed: at least one cell per "
                     "half-width, {:g} or more for useful results",
                     length_text(spacing[0]), length_text(spacing[1]), length_text(half_x), length_text(half_y),
                     fewest_cells);
}

std::optional<std::string> reason_against_shift(double shift, double half_x)
{
  const double longest = 2.0 * half_x;
  if (shift <= longest)
    return std::nullopt;
  return fmt::format("is longer than the contact, about {}, and would skip material; allowed: up to this length, at "
                     "most {} for useful results",
                     length_text(longest), length_text(longest_share_of_radius * half_x));
}

} // namespace brinell::quality
