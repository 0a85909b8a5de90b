// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/history_csv.hpp"

#include "brinell/foundation/error.hpp"
#include "replace_file.hpp"

#include <cerrno>
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

/// The header and the rows of the first steps.
std::string first_lines(const std::filesystem::path& path, const std::string& header, int rows)
{
  std::ifstream stream(path, std::ios::binary);
  std::string text;
  std::string line;
  for (int i = 0; i <= rows; ++i)
  {
    if (!std::getline(stream, line) || (i == 0 && line != header))
      throw IoError(fmt::format("{}: is not the history that the checkpoint belongs to", path.string()));
    text += line + '\n';
  }
  return text;
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

HistoryWriter::HistoryWriter(std::filesystem::path path, const std::string& header, int kept) : m_path(std::move(path))
{
  replace_file(m_path, kept > 0 ? first_lines(m_path, header, kept) : header + '\n');
  m_file.reset(std::fopen(m_path.c_str(), "a"));
  if (!m_file)
    throw failure(m_path, "cannot be written");
}

void HistoryWriter::add(const std::string& row)
{
  if (std::fputs((row + '\n').c_str(), m_file.get()) < 0 || std::fflush(m_file.get()) != 0)
    throw failure(m_path, "cannot be written");
}

} // namespace brinell::io
