// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/history_csv.hpp"

#include "brinell/foundation/error.hpp"
#include "io/files.hpp"
#include "io/scenarios/scenario_io.hpp"

#include <cerrno>
#include <charconv>
#include <cstring>
#include <fmt/format.h>
#include <fstream>

namespace brinell::io
{

namespace
{

IoError failure(const std::filesystem::path& path, const char* problem)
{
  return IoError(fmt::format("{}: {}: {}", path.string(), problem, std::strerror(errno)));
}

/// The numbers of a row. @throws IoError
std::vector<double> parsed_row(const std::string& line, std::size_t count, const std::filesystem::path& path)
{
  std::vector<double> values;
  const char* place = line.data();
  const char* end = line.data() + line.size();
  for (double value = 0.0; values.size() < count; ++place)
  {
    const auto [after, error] = std::from_chars(place, end, value);
    if (error != std::errc{} || (values.size() + 1 < count ? after == end || *after != ',' : after != end))
      throw IoError(fmt::format("{}: is damaged at \"{}\"; begin the run anew, without --resume", path.string(), line));
    values.push_back(value);
    place = after;
  }
  return values;
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

HistoryWriter::HistoryWriter(std::filesystem::path path, const std::vector<NamedNumber>& record, int kept,
                             std::string_view sum)
    : path_(std::move(path)), sum_(std::make_unique<Checksum>())
{
  columns_ = columns_of(record);
  const std::string header = history_header(record) + '\n';
  if (kept > 0)
    keep_rows(header, kept, sum);
  else
  {
    sum_->add(header);
    replace_file(path_, header);
  }
  file_.reset(std::fopen(path_.c_str(), "a"));
  if (!file_)
    throw failure(path_, "cannot be written");
}

HistoryWriter::~HistoryWriter() = default;

std::string HistoryWriter::checksum() const
{
  return sum_->text();
}

/// Keeps the rows of the first steps and removes the following ones.
void HistoryWriter::keep_rows(const std::string& header, int count, std::string_view sum)
{
  std::ifstream stream(path_, std::ios::binary);
  std::string text;
  std::string line;
  for (int i = 0; i <= count; ++i)
  {
    if (!std::getline(stream, line) || (i == 0 && line + '\n' != header))
      throw IoError(fmt::format("{}: is not the history that the checkpoint belongs to", path_.string()));
    text += line + '\n';
    if (i == 0)
      continue;
    const std::vector<double> values = parsed_row(line, columns_.size(), path_);
    for (std::size_t c = 0; c < values.size(); ++c)
      columns_[c].values.push_back(values[c]);
  }
  stream.close();
  sum_->add(text);
  if (!sum.empty() && sum_->text() != sum)
    throw IoError(fmt::format("{}: is damaged; begin the run anew, without --resume", path_.string()));
  replace_file(path_, text);
}

void HistoryWriter::add(const std::vector<NamedNumber>& row)
{
  const std::string line = history_row(row) + '\n';
  if (std::fputs(line.c_str(), file_.get()) < 0 || std::fflush(file_.get()) != 0)
    throw failure(path_, "cannot be written");
  sum_->add(line);
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
