// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace brinell::io
{

/// A line of a text file of numbers.
struct NumberLine
{
  int number = 0; ///< counts from 1
  std::string text;
  std::optional<std::vector<double>> values; ///< none if something there is no number
};

/// The lines of a file with numbers between blanks, commas, semicolons or tabs; empty lines and those that begin with # are
/// left out. @throws as `read_blocks`; the text continues a sentence that begins with the key.
[[nodiscard]] std::vector<NumberLine> number_lines(const std::filesystem::path& file);

} // namespace brinell::io
