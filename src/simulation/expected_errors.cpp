// SPDX-License-Identifier: BSD-3-Clause
#include "judgement_parts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

/// Errors to expect of a run, from the tables of docs/verification/accuracy.md: with its cells, with its steps, and of its dents.
namespace brinell::simulation
{

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
  if (f.wears)
    all.push_back(f.worn_depth);
  return all;
}

/// @param seen  by the run; null before it
std::vector<ExpectedError> expected_errors(const Facts& f, double of_contact, const RunTotals* seen)
{
  // The plastic zone of the tables is 2.5 contact radii deep in layers of cells; near first yield it is much shallower.
  constexpr double layers_per_cell = 2.5;
  const int layers = seen ? seen->coverage.plastic_layers : 0;
  const bool yields = seen ? layers > 0 : f.can_yield && (!f.first_yield || *f.first_yield < f.approach);
  const double of_zone = layers > 0 ? std::min(of_contact, layers / layers_per_cell) : of_contact;
  const std::optional<double> of_lower = seen ? growth_of_lower(*seen) : 1.0;
  const double of_steps = !yields && f.forgets_if_elastic ? 0.0 : error_of_steps(f);
  std::vector<ExpectedError> errors;
  for (const Documented& d : all_documented(f))
    if ((yields || d.of == Documented::Of::elastic_contact) && (of_lower || !d.is_of_lower))
    {
      const double from_cells =
          d.error * std::pow(d.cells / (d.of == Documented::Of::plastic_zone ? of_zone : of_contact), d.order);
      const double growth = d.is_of_lower ? *of_lower : 1.0;
      errors.push_back(
          {d.quantity, d.name, std::min(1.0, growth * (from_cells + d.of_steps * of_steps) + d.further), d.order});
    }
  return errors;
}

} // namespace

Resolution resolution_of(const Facts& f, double cells_x, double cells_y, const RunTotals* seen)
{
  const std::optional<int> layers = seen ? std::optional(seen->coverage.plastic_layers) : std::nullopt;
  if (f.is_plane)
    cells_y = cells_x;
  if (f.cells_per_wave && !std::isnan(cells_x))
  {
    Resolution of_patches; // without expected errors, as the tables are for single indents
    of_patches.plastic_layers = layers;
    of_patches.cells_per_wave = f.cells_per_wave;
    return of_patches;
  }
  Resolution r{cells_x, cells_y, std::min(cells_x, cells_y), layers, {}};
  if (!std::isnan(r.cells))
    r.expected_errors = expected_errors(f, deciding_cells(f, r), seen);
  return r;
}

} // namespace brinell::simulation
