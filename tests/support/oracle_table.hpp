// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace brinell::test
{

/// A comma-separated file of tests/data: a header line, then one case per line. Its generator lies in tools/oracles.
class OracleTable
{
public:
  explicit OracleTable(const std::string& name)
  {
    std::ifstream file(std::string(BRINELL_SOURCE_DIR) + "/tests/data/" + name);
    for (std::string line; std::getline(file, line);)
      (header_.empty() ? header_ : rows_.emplace_back()) = split(line);
    if (rows_.empty())
      throw std::runtime_error("no oracle in tests/data/" + name);
  }

  [[nodiscard]] std::size_t size() const { return rows_.size(); }

  [[nodiscard]] const std::string& text(std::size_t row, std::string_view column) const
  {
    const auto found = std::find(header_.begin(), header_.end(), column);
    if (found == header_.end())
      throw std::runtime_error("no such column in the oracle: " + std::string(column));
    return rows_.at(row).at(static_cast<std::size_t>(found - header_.begin()));
  }

  [[nodiscard]] double number(std::size_t row, std::string_view column) const { return std::stod(text(row, column)); }

private:
  static std::vector<std::string> split(const std::string& line)
  {
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');)
      cells.push_back(cell);
    return cells;
  }

  std::vector<std::string> header_;
  std::vector<std::vector<std::string>> rows_;
};

} // namespace brinell::test
