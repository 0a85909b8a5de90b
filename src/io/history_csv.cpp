// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/history_csv.hpp"

#include "brinell/foundation/error.hpp"
#include "checksum.hpp"
#include "replace_file.hpp"

#include <cerrno>
#include <charconv>
#include <cstring>
#include <fmt/format.h>
#include <fstream>

namespace brinell::io
{

namespace
{

IoError failure(const std::filesystem::path& path, const char* what)
{
  return IoError(fmt::format("{}: {}: {}", path.string(), what, std::strerror(errno)));
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
      throw IoError(fmt::format("{}: is damaged at \"{}\"; run without --resume", path.string(), line));
    values.push_back(value);
    place = after;
  }
  return values;
}

void append(std::vector<NamedNumber>& columns, std::vector<NamedNumber> more)
{
  columns.insert(columns.end(), more.begin(), more.end());
}

/// Energies and strains, which end the rows of all scenarios.
std::vector<NamedNumber> common_columns(const simulation::StepRecord& r)
{
  return {{"work", r.work},
          {"dissipation_lower", r.dissipation_lower},
          {"dissipation_upper", r.dissipation_upper},
          {"energy_residual", r.energy_residual},
          {"energy_elastic", r.energy_elastic},
          {"max_residual_lower", r.max_residual_lower},
          {"max_residual_upper", r.max_residual_upper},
          {"max_equivalent_plastic_strain", r.max_equivalent_plastic_strain},
          {"iterations", r.iterations}};
}

} // namespace

std::vector<NamedNumber> columns(const simulation::TuggingRecord& r)
{
  std::vector<NamedNumber> result{{"step", r.step},
                                  {"pass", r.pass},
                                  {"X", r.X},
                                  {"theta", r.theta},
                                  {"interference", r.interference},
                                  {"height", r.height},
                                  {"contact_area", r.contact_area},
                                  {"max_pressure", r.max_pressure},
                                  {"F_n", r.F_n},
                                  {"F_X", r.F_X},
                                  {"F_Y", r.F_Y},
                                  {"F_Z", r.F_Z},
                                  {"F_X_macro", r.F_X_macro},
                                  {"F_Z_macro", r.F_Z_macro}};
  append(result, common_columns(r));
  return result;
}

std::vector<NamedNumber> columns(const simulation::IndentationRecord& r)
{
  std::vector<NamedNumber> result{{"step", r.step},
                                  {"pass", r.pass},
                                  {"place", r.place},
                                  {"x", r.x},
                                  {"approach", r.approach},
                                  {"F_n", r.F_n},
                                  {"contact_area", r.contact_area},
                                  {"contact_radius", r.contact_radius},
                                  {"max_pressure", r.max_pressure},
                                  {"mean_pressure", r.mean_pressure},
                                  {"residual_depth", r.residual_depth},
                                  {"pile_up", r.pile_up}};
  append(result, common_columns(r));
  return result;
}

std::vector<NamedNumber> columns(const simulation::RollingRecord& r)
{
  std::vector<NamedNumber> result{{"step", r.step},
                                  {"pass", r.pass},
                                  {"x", r.x},
                                  {"approach", r.approach},
                                  {"F_n", r.F_n},
                                  {"F_X", r.F_X},
                                  {"contact_area", r.contact_area},
                                  {"max_pressure", r.max_pressure}};
  append(result, common_columns(r));
  return result;
}

std::string history_header(const std::vector<NamedNumber>& columns)
{
  std::string text;
  for (const auto& [name, value] : columns)
    text += fmt::format("{}{}", text.empty() ? "" : ",", name);
  return text;
}

std::string history_row(const std::vector<NamedNumber>& columns)
{
  std::string text;
  for (const auto& [name, value] : columns)
    std::visit([&](auto number) { text += fmt::format("{}{}", text.empty() ? "" : ",", number); }, value);
  return text;
}

HistoryWriter::HistoryWriter(std::filesystem::path path, const std::vector<NamedNumber>& record, int kept,
                             std::string_view sum)
    : path_(std::move(path)), sum_(std::make_unique<Checksum>())
{
  for (const auto& [name, value] : record)
    columns_.push_back({name, std::holds_alternative<int>(value), {}});
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

/// The rows of the first steps stay, what comes after them goes.
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
    throw IoError(fmt::format("{}: is damaged; run without --resume", path_.string()));
  replace_file(path_, text);
}

void HistoryWriter::add(const std::vector<NamedNumber>& row)
{
  const std::string line = history_row(row) + '\n';
  if (std::fputs(line.c_str(), file_.get()) < 0 || std::fflush(file_.get()) != 0)
    throw failure(path_, "cannot be written");
  sum_->add(line);
  for (std::size_t c = 0; c < columns_.size(); ++c)
    columns_[c].values.push_back(std::visit([](auto number) { return static_cast<double>(number); }, row[c].second));
}

} // namespace brinell::io
