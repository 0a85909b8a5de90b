// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/archive.hpp"
#include "brinell/simulation/columns.hpp"

#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace brinell::io
{

/// A number of a history with the description of its column in files.
struct NamedNumber
{
  std::string_view name, unit, text; ///< from static storage
  std::variant<int, double> value;
};

/// The columns of history.csv, in order, with the values of one step. All records of a scenario have the same columns.
template <typename Record>
[[nodiscard]] std::vector<NamedNumber> columns(const Record& record)
{
  std::vector<NamedNumber> row;
  row.reserve(simulation::columns<Record>.size());
  for (const auto& column : simulation::columns<Record>)
    row.push_back({column.name, column.unit, column.text, column.value(record)});
  return row;
}

/// All columns: of the histories by the names of the scenarios, and of the lists in summary.json by their keys.
[[nodiscard]] std::map<std::string, std::vector<NamedNumber>> all_columns();

/// Header line of history.csv, without the end of line.
[[nodiscard]] std::string history_header(const std::vector<NamedNumber>& columns);
/// One row, without the end of line; numbers in the shortest form that reads back the same.
[[nodiscard]] std::string history_row(const std::vector<NamedNumber>& columns);

/// A column of the history with its values so far.
struct HistoryColumn
{
  std::string_view name, unit, text; ///< from static storage
  bool is_integer;
  std::vector<double> values;
};

/// Appends a row; in an empty table the columns are created first.
void add_row(std::vector<HistoryColumn>& table, const std::vector<NamedNumber>& row);

/// Writes history.csv row by row; each row has been handed to the operating system when `add` returns.
class HistoryWriter
{
public:
  /// Replaces the file by one with the rows of a checkpoint.
  /// @param record      of any step, for the names of the columns
  /// @param checkpoint  nullptr: no rows
  /// @param name        under which the checkpoint has the rows
  /// @throws IoError; InputError if the checkpoint does not contain these columns
  HistoryWriter(std::filesystem::path path, const std::vector<NamedNumber>& record,
                const Archive::Fields* checkpoint = nullptr, std::string_view name = "history");

  /// @throws IoError
  void add(const std::vector<NamedNumber>& row);

  /// The columns, with all rows in the file.
  [[nodiscard]] const std::vector<HistoryColumn>& columns() const { return columns_; }
  [[nodiscard]] std::size_t rows() const { return columns_.front().values.size(); }

  /// Saves or restores the rows.
  void exchange(Archive& archive);

private:
  struct Closer
  {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  std::filesystem::path path_;
  std::vector<HistoryColumn> columns_;
  std::unique_ptr<std::FILE, Closer> file_;
};

} // namespace brinell::io
