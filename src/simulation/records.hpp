// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/columns.hpp"

#include <limits>
#include <string>
#include <variant>

namespace brinell::simulation
{

/// Puts the state of the last step into a summary; what was worked but neither dissipated nor is stored is an error.
/// @param largest_work  reached in the run [J]
void take_totals(const StepRecord& last, double largest_work, RunTotals& totals);

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

/// Everything of a row.
template <typename Record>
void exchange_row(Record& record, Archive& archive)
{
  exchange_columns(record, archive);
  archive("coverage", record.coverage);
}

} // namespace brinell::simulation
