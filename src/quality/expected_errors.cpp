// SPDX-License-Identifier: BSD-3-Clause
#include "judgement_parts.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <optional>
#include <string>

/// Errors to expect of a run, from the tables of docs/verification/accuracy.md: with its cells, with its steps, and of its dents.
namespace brinell::quality
{

using namespace simulation;

double deciding_cells(const Facts& f, const Resolution& r)
{
  return f.moves ? std::min(r.cells_x, r.cells_y * fewest_cells / fewest_cells_across) : r.cells;
}

double error_of_steps(const Facts& f)
{
  if (f.steps)
    return std::pow(*f.steps, -2.0);
  if (!f.shift || !(*f.shift > 1.01 * f.cell[0]))
    return 0.0;
  // docs/verification/accuracy.md (few steps)
  const auto of_share = [](double share) { return 0.06 * std::pow(share / longest_share_of_radius, 1.8); };
  return of_share(*f.shift / f.half_x) - of_share(f.cell[0] / f.half_x);
}

namespace
{

/// Factor on the relative error of the dents of the lower body, which may be much smaller than those of the upper one.
/// @return none if they are so small that a relative error says nothing
std::optional<double> growth_of_lower(const RunTotals& seen)
{
  constexpr double least = 0.02; // over the dents of the upper body
  const double lower = seen.max_residual_lower, upper = seen.max_residual_upper;
  if (!(lower > least * upper))
    return std::nullopt;
  return std::sqrt(std::max(1.0, upper / lower)); // docs/verification/accuracy.md (expected error)
}

/// All that the tables know about the quantities of the run.
std::vector<Documented> all_documented(const Facts& f)
{
  std::vector<Documented> all = f.documented;
  if (f.is_heated && !f.has_source)
    all.push_back(f.temperature_rise);
  for (const std::string_view effect : f.effects)
    if (const std::optional<Documented> documented = documented_of_effect(effect, f))
      all.push_back(*documented);
  return all;
}

/// The lengths in cells that decide about errors: of the contact, and of what yields.
struct Lengths
{
  double contact, zone;
  const char* shortest; ///< name of the shorter one
};

/// @param contact  cells per contact radius; NaN for flats over a period
/// @param seen     by the run; null before it
Lengths lengths_of(const Facts& f, double contact, const RunTotals* seen)
{
  // The plastic zone of the tables is 2.5 contact radii deep in layers of cells; near first yield it is much shallower.
  constexpr double layers_per_cell = 2.5;
  // docs/verification/accuracy.md (dents and roughness)
  constexpr double before = 0.25, after = 0.5; // of a wave: its crest, and what yields under it
  constexpr double per_peak = 2.0;
  Lengths l{std::isnan(contact) ? std::numeric_limits<double>::infinity() : contact, 0.0, "the contact radius"};
  const auto shorten = [](double& length, double to, const char*& name, const char* what)
  {
    if (to > 0.0 && to < length) // 0: not seen
      length = to, name = what;
  };
  if (f.cells_per_texture)
    shorten(l.contact, (seen ? after : before) * *f.cells_per_texture, l.shortest,
            seen ? "half of the shortest wave" : "a quarter of the shortest wave");
  if (f.cells_per_texture && seen)
  {
    shorten(l.contact, seen->coverage.patch_cells, l.shortest, "the radius of the patches in contact");
    shorten(l.contact, per_peak * seen->coverage.peak_cells, l.shortest, "the width of the largest peak of pressure");
  }
  l.zone = l.contact;
  if (seen && seen->coverage.plastic_layers > 0)
    shorten(l.zone, seen->coverage.plastic_layers / layers_per_cell, l.shortest,
            "0.4 of the depth of the plastic zone");
  return l;
}

/// @param contact  cells per contact radius; NaN for flats over a period
/// @param seen     by the run; null before it
std::vector<ExpectedError> expected_errors(const Facts& f, double contact, const RunTotals* seen)
{
  const Lengths lengths = lengths_of(f, contact, seen);
  const bool yields =
      seen ? seen->coverage.plastic_layers > 0 : f.can_yield && (!f.first_yield || *f.first_yield < f.approach);
  const std::optional<double> of_lower = seen ? growth_of_lower(*seen) : 1.0;
  const double of_steps = !yields && f.forgets_if_elastic ? 0.0 : error_of_steps(f);
  const bool is_textured = f.cells_per_texture.has_value();
  const bool is_coated = std::ranges::any_of(f.materials, [](const constitutive::Material* material)
                                             { return material->is_plastic() && !material->layers.empty(); });
  std::vector<ExpectedError> errors;
  for (const Documented& d : all_documented(f))
    if ((yields || d.of == Documented::Of::elastic_contact) && (of_lower || !d.is_of_lower))
    {
      const bool by_zone =
          d.of == Documented::Of::plastic_zone || (is_textured && d.of != Documented::Of::elastic_contact);
      const double from_cells = (is_textured ? d.on_textures : 1.0) * (is_coated ? d.on_coats : 1.0) * d.error *
                                std::pow(d.cells / (by_zone ? lengths.zone : lengths.contact), d.order);
      const double growth = d.is_of_lower ? *of_lower : 1.0;
      errors.push_back(
          {d.quantity, d.name, std::min(1.0, growth * (from_cells + d.of_steps * of_steps) + d.further), d.order});
    }
  return errors;
}

} // namespace

void withhold_errors(const Facts& f, const RunTotals* seen, Resolution& r, std::vector<Warning>& warnings)
{
  constexpr double most = 0.5;          // larger ones say nothing
  constexpr double fewest_of_all = 1.5; // in fewer cells a patch or a peak of pressure may be anything
  if (!f.cells_per_texture || r.expected_errors.empty())
    return;
  const double contact = f.cells_per_wave ? std::numeric_limits<double>::quiet_NaN() : deciding_cells(f, r);
  const Lengths lengths = lengths_of(f, contact, seen);
  std::string names;
  std::erase_if(r.expected_errors,
                [&](const ExpectedError& e)
                {
                  if (e.relative <= most && lengths.contact >= fewest_of_all)
                    return false;
                  names += fmt::format("{}{}", names.empty() ? "" : ", ", e.quantity);
                  return true;
                });
  if (names.empty())
    return;
  const std::string text = fmt::format(
      "no error is stated of {}, which may be off by {} and more: the shortest length that matters, {}, has "
      "only {:.2g} cells; use a finer grid.resolution or grid.spacing, or --accuracy",
      names, percent_text(most), lengths.shortest, lengths.zone);
  if (warnings.empty())
    warnings.push_back({"coarse_texture", text});
  else
    warnings.back().text += "; " + text;
}

namespace
{

void set_lengths(Resolution& r, const RunTotals* seen)
{
  if (!seen)
    return;
  r.patch_cells = seen->coverage.patch_cells;
  r.peak_cells = seen->coverage.peak_cells;
}

} // namespace

Resolution resolution_of(const Facts& f, double cells_x, double cells_y, const RunTotals* seen)
{
  const std::optional<int> layers = seen ? std::optional(seen->coverage.plastic_layers) : std::nullopt;
  if (f.is_plane)
    cells_y = cells_x;
  if (f.cells_per_wave && !std::isnan(cells_x))
  {
    Resolution of_patches;
    of_patches.plastic_layers = layers;
    of_patches.cells_per_wave = f.cells_per_wave;
    of_patches.expected_errors = expected_errors(f, std::numeric_limits<double>::quiet_NaN(), seen);
    set_lengths(of_patches, seen);
    return of_patches;
  }
  Resolution r{cells_x, cells_y, std::min(cells_x, cells_y), layers, {}};
  if (!std::isnan(r.cells))
  {
    r.expected_errors = expected_errors(f, deciding_cells(f, r), seen);
    set_lengths(r, seen);
  }
  return r;
}

} // namespace brinell::quality
