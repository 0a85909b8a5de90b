// SPDX-License-Identifier: BSD-3-Clause
#include "records.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/simulation/columns.hpp"

#include <array>
#include <fmt/format.h>
#include <limits>
#include <string>
#include <variant>

namespace brinell::simulation
{

void take_totals(const StepRecord& last, double largest_work, RunTotals& totals)
{
  static_cast<RunningTotals&>(totals) = last;
  if (largest_work > 0.0)
    totals.energy_balance_error = (last.work - last.dissipation_lower - last.dissipation_upper -
                                   last.dissipation_friction - last.energy_residual - last.energy_elastic) /
                                  largest_work;
}

void Coverage::exchange(Archive& archive)
{
  archive("contact_columns", contact_columns);
  archive("contact_rows", contact_rows);
  archive("plastic_layers", plastic_layers);
}

namespace
{

/// Whole numbers of a record count something, from 0; one more must be possible.
template <typename Record>
void exchange_columns(Record& record, Archive& archive)
{
  for (const Column<Record>& column : columns<Record>)
    if (const auto* member = std::get_if<int Record::*>(&column.member))
      archive(std::string(column.name), record.**member, 0, std::numeric_limits<int>::max() - 1);
    else
      archive(std::string(column.name), record.*std::get<double Record::*>(column.member));
}

template <typename Record>
void exchange_row(Record& record, Archive& archive)
{
  exchange_columns(record, archive);
  archive("coverage", record.coverage);
}

} // namespace

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

void TuggingRecord::exchange(Archive& archive)
{
  exchange_row(*this, archive);
  archive("F_X_lower", F_X_lower); // no column of the history
  archive("F_X_upper", F_X_upper);
  archive("F_X_friction", F_X_friction);
  archive("F_Z_friction", F_Z_friction);
}

void TuggingPeaks::exchange(Archive& archive)
{
  archive("peak_F_X", peak_F_X);
  archive("X_at_peak_F_X", X_at_peak_F_X);
  archive("min_F_X", min_F_X);
  archive("peak_F_Z", peak_F_Z);
  archive("F_X_aligned", F_X_aligned);
  archive("F_Z_aligned", F_Z_aligned);
  archive("load_ratio_aligned", load_ratio_aligned);
  archive("load_ratio_end", load_ratio_end);
  archive("work_to_alignment", work_to_alignment);
}

void IndentationRecord::exchange(Archive& archive)
{
  exchange_row(*this, archive);
}

void RollingRecord::exchange(Archive& archive)
{
  exchange_row(*this, archive);
}

void Indent::exchange(Archive& archive)
{
  exchange_columns(*this, archive);
}

void RollingPass::exchange(Archive& archive)
{
  exchange_columns(*this, archive);
}

} // namespace brinell::simulation
