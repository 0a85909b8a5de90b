// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/history_csv.hpp"

#include "brinell/foundation/error.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <variant>

namespace brinell::io
{

namespace
{

using simulation::StepRecord;

/// Name of a column and the member it shows: header and rows cannot disagree.
struct Column
{
  const char* name;
  std::variant<int StepRecord::*, double StepRecord::*> member;
};

constexpr std::array columns{
    Column{"step", &StepRecord::step},
    Column{"X", &StepRecord::X},
    Column{"theta", &StepRecord::theta},
    Column{"interference", &StepRecord::interference},
    Column{"contact_area", &StepRecord::contact_area},
    Column{"max_pressure", &StepRecord::max_pressure},
    Column{"F_n", &StepRecord::F_n},
    Column{"F_X", &StepRecord::F_X},
    Column{"F_Y", &StepRecord::F_Y},
    Column{"F_Z", &StepRecord::F_Z},
    Column{"F_X_macro", &StepRecord::F_X_macro},
    Column{"F_Z_macro", &StepRecord::F_Z_macro},
    Column{"work", &StepRecord::work},
    Column{"dissipation_lower", &StepRecord::dissipation_lower},
    Column{"dissipation_upper", &StepRecord::dissipation_upper},
    Column{"energy_residual", &StepRecord::energy_residual},
    Column{"max_residual_lower", &StepRecord::max_residual_lower},
    Column{"max_residual_upper", &StepRecord::max_residual_upper},
    Column{"max_equivalent_plastic_strain", &StepRecord::max_equivalent_plastic_strain},
    Column{"iterations", &StepRecord::iterations},
};

IoError failure(const std::filesystem::path& path, const char* what)
{
  return IoError(fmt::format("{}: {}: {}", path.string(), what, std::strerror(errno)));
}

} // namespace

std::string history_header()
{
  std::string text;
  for (const Column& column : columns)
    text += fmt::format("{}{}", text.empty() ? "" : ",", column.name);
  return text;
}

std::string history_row(const StepRecord& record)
{
  std::string text;
  for (const Column& column : columns)
    std::visit([&](auto member) { text += fmt::format("{}{}", text.empty() ? "" : ",", record.*member); },
               column.member);
  return text;
}

HistoryWriter::HistoryWriter(std::filesystem::path path)
    : m_path(std::move(path)), m_file(std::fopen(m_path.c_str(), "w"))
{
  if (!m_file)
    throw failure(m_path, "cannot be written");
  write_line(history_header());
}

void HistoryWriter::write_line(const std::string& line)
{
  if (std::fputs((line + '\n').c_str(), m_file.get()) < 0 || std::fflush(m_file.get()) != 0)
    throw failure(m_path, "cannot be written");
}

} // namespace brinell::io
