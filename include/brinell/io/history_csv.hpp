// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/tugging.hpp"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

namespace brinell::io
{

/// Header line of history.csv, without the end of line.
[[nodiscard]] std::string history_header();
/// One row, without the end of line; numbers in the shortest form that reads back the same.
[[nodiscard]] std::string history_row(const simulation::StepRecord& record);

/// Writes history.csv row by row; each row is with the operating system when `add` returns.
class HistoryWriter
{
public:
  /// Replaces the file.
  /// @throws IoError
  explicit HistoryWriter(std::filesystem::path path);

  /// @throws IoError
  void add(const simulation::StepRecord& record) { write_line(history_row(record)); }

private:
  void write_line(const std::string& line);

  struct Closer
  {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::filesystem::path m_path;
  std::unique_ptr<std::FILE, Closer> m_file;
};

} // namespace brinell::io
