// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

class Checksum;

/// A number of a history with what files tell of its column.
struct NamedNumber
{
  std::string_view name, unit, text; ///< from static storage
  std::variant<int, double> value;
};

/// The columns of history.csv, in order, with the values of one step. The same for each record of a scenario.
template <typename Record>
[[nodiscard]] std::vector<NamedNumber> columns(const Record& record)
{
  std::vector<NamedNumber> row;
  row.reserve(simulation::columns<Record>.size());
  for (const auto& column : simulation::columns<Record>)
    row.push_back({column.name, column.unit, column.text, column.value(record)});
  return row;
}

/// The columns of the histories by the names of the scenarios, and of the lists in summary.json by their keys.
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

/// Appends a row; the columns of an empty table are made.
void add_row(std::vector<HistoryColumn>& table, const std::vector<NamedNumber>& row);

/// Writes history.csv row by row; each row is with the operating system when `add` returns.
class HistoryWriter
{
public:
  /// Replaces the file, or goes on after the rows of its first steps.
  /// @param record  of any step, for the names of the columns
  /// @param kept    how many rows; 0: a new file.
  /// @param sum     checksum that the file had when it ended with these rows; empty: not compared
  /// @throws IoError, also if what is kept has changed since
  HistoryWriter(std::filesystem::path path, const std::vector<NamedNumber>& record, int kept,
                std::string_view sum = {});
  ~HistoryWriter();

  /// @throws IoError
  void add(const std::vector<NamedNumber>& row);

  /// All rows that are in the file.
  [[nodiscard]] const std::vector<HistoryColumn>& columns() const { return columns_; }
  /// Of the file as it is now.
  [[nodiscard]] std::string checksum() const;

private:
  struct Closer
  {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void keep_rows(const std::string& header, int count, std::string_view sum);

  std::filesystem::path path_;
  std::vector<HistoryColumn> columns_;
  std::unique_ptr<Checksum> sum_;
  std::unique_ptr<std::FILE, Closer> file_;
};

} // namespace brinell::io
