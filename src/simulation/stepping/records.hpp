// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/columns.hpp"

#include <limits>
#include <string>
#include <variant>

namespace brinell::simulation
{

/// Copies the totals of the last step into a summary and computes the error of the energy balance.
/// @param largest_work  largest magnitude of the work in the run [J]
void take_totals(const StepRecord& last, double largest_work, RunTotals& totals);

/// Stores or restores the columns of a record. Integers are counters, which must be >= 0 and small enough to be incremented.
template <typename Record>
void exchange_columns(Record& record, Archive& archive)
{
  for (const Column<Record>& column : columns<Record>)
    if (const auto* member = std::get_if<int Record::*>(&column.member))
      archive(std::string(column.name), record.**member, 0, std::numeric_limits<int>::max() - 1);
    else
      archive(std::string(column.name), record.*std::get<double Record::*>(column.member));
}

/// Stores or restores a complete row.
template <typename Record>
void exchange_row(Record& record, Archive& archive)
{
  exchange_columns(record, archive);
  archive("coverage", record.coverage);
}

} // namespace brinell::simulation
