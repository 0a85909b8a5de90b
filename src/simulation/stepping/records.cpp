// SPDX-License-Identifier: BSD-3-Clause
#include "records.hpp"

#include <array>
#include <fmt/format.h>
#include <string>

namespace brinell::simulation
{

void take_totals(const StepRecord& last, double largest_work, RunTotals& totals)
{
  static_cast<RunningTotals&>(totals) = last;
  if (largest_work > 0.0)
    totals.energy_balance_error =
        (last.work + last.work_of_expansion - last.dissipation_lower - last.dissipation_upper -
         last.dissipation_friction - last.work_of_effects() - last.energy_residual - last.energy_elastic) /
        largest_work;
}

void Coverage::exchange(Archive& archive)
{
  archive("contact_columns", contact_columns);
  archive("contact_rows", contact_rows);
  archive("plastic_layers", plastic_layers);
  archive("largest_contact", largest_contact);
  archive("patch_cells", patch_cells);
  archive("largest_pressure", largest_pressure);
  archive("peak_cells", peak_cells);
}

void GridChange::exchange(Archive& archive)
{
  archive("step", step);
  int code = static_cast<int>(extent);
  archive("extent", code, 0, static_cast<int>(Extent::upper_layers));
  extent = static_cast<Extent>(code);
  archive("before", before);
  archive("after", after);
}

namespace
{

struct ExtentText
{
  const char *name, *grows, *unit;
};

/// In the order of GridChange::Extent.
constexpr std::array extents{
    ExtentText{"contact_columns", "the grid of the contact grows", "columns"},
    ExtentText{"rows", "all grids grow", "rows"},
    ExtentText{"lower_columns", "the grid of the lower body grows", "columns"},
    ExtentText{"upper_columns", "the grid of the upper body grows", "columns"},
    ExtentText{"lower_layers", "the grid of the lower body grows", "layers"},
    ExtentText{"upper_layers", "the grid of the upper body grows", "layers"},
};

} // namespace

const char* extent_name(GridChange::Extent extent)
{
  return extents.at(static_cast<std::size_t>(extent)).name;
}

std::string text(const GridChange& change)
{
  const ExtentText& e = extents.at(static_cast<std::size_t>(change.extent));
  return fmt::format("step {}: {} from {} to {} {}", change.step, e.grows, change.before, change.after, e.unit);
}

} // namespace brinell::simulation
