// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/history_csv.hpp"

#include "brinell/foundation/error.hpp"
#include "io/files.hpp"
#include "io/scenarios/scenario_io.hpp"

#include <cerrno>
#include <cstring>
#include <fmt/format.h>

namespace brinell::io
{

namespace
{

IoError failure(const std::filesystem::path& path, const char* problem)
{
  return IoError(fmt::format("{}: {}: {}", path.string(), problem, std::strerror(errno)));
}

/// The columns of a history without rows.
std::vector<HistoryColumn> columns_of(const std::vector<NamedNumber>& record)
{
  std::vector<HistoryColumn> columns;
  columns.reserve(record.size());
  for (const auto& [name, unit, text, value] : record)
    columns.push_back({name, unit, text, std::holds_alternative<int>(value), {}});
  return columns;
}

} // namespace

std::string history_header(const std::vector<NamedNumber>& columns)
{
  std::string text;
  for (const NamedNumber& column : columns)
    text += fmt::format("{}{}", text.empty() ? "" : ",", column.name);
  return text;
}

std::string history_row(const std::vector<NamedNumber>& columns)
{
  std::string text;
  for (const NamedNumber& column : columns)
    std::visit([&](auto number) { text += fmt::format("{}{}", text.empty() ? "" : ",", number); }, column.value);
  return text;
}

void add_row(std::vector<HistoryColumn>& table, const std::vector<NamedNumber>& row)
{
  if (table.empty())
    table = columns_of(row);
  for (std::size_t c = 0; c < table.size(); ++c)
    table[c].values.push_back(std::visit([](auto number) { return static_cast<double>(number); }, row[c].value));
}

HistoryWriter::HistoryWriter(std::filesystem::path path, const std::vector<NamedNumber>& record,
                             const Archive::Fields* checkpoint, std::string_view name)
    : path_(std::move(path)), columns_(columns_of(record))
{
  if (checkpoint)
  {
    Archive archive(*checkpoint);
    archive(std::string(name), *this);
  }
  std::string text = history_header(record) + '\n';
  std::vector<NamedNumber> row = record;
  for (std::size_t i = 0; i < rows(); ++i)
  {
    auto column = columns_.begin();
    for (NamedNumber& cell : row)
      std::visit([value = (column++)->values[i]](auto& number)
                 { number = static_cast<std::decay_t<decltype(number)>>(value); },
                 cell.value);
    text += history_row(row) + '\n';
  }
  replace_file(path_, text);
  file_.reset(std::fopen(path_.c_str(), "a"));
  if (!file_)
    throw failure(path_, "cannot be written");
}

void HistoryWriter::exchange(Archive& archive)
{
  for (HistoryColumn& column : columns_)
  {
    archive.list(std::string(column.name), column.values);
    if (column.values.size() != rows())
      throw InputError(
          fmt::format("the stored history has {} rows, but {} of {}", rows(), column.values.size(), column.name));
  }
}

void HistoryWriter::add(const std::vector<NamedNumber>& row)
{
  const std::string line = history_row(row) + '\n';
  if (std::fputs(line.c_str(), file_.get()) < 0 || std::fflush(file_.get()) != 0)
    throw failure(path_, "cannot be written");
  add_row(columns_, row);
}

std::map<std::string, std::vector<NamedNumber>> all_columns()
{
  std::map<std::string, std::vector<NamedNumber>> all;
  for_each_scenario(
      [&]<typename ScenarioCase>(const ScenarioIo<ScenarioCase>& io)
      {
        all.emplace(io.name, columns(typename ScenarioCase::Record()));
        all.insert(io.lists.begin(), io.lists.end());
      });
  return all;
}

} // namespace brinell::io
