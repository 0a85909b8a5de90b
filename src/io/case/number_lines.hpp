// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace brinell::io
{

/// A line of a text file of numbers.
struct NumberLine
{
  int number = 0; ///< counts from 1
  std::string text;
  std::vector<double> values; ///< empty if something there is no number
};

/// The lines of a file with numbers between blanks, commas, semicolons or tabs, but for comments, which begin with #. If commas
/// stand in the numbers and something else between them, in every line, these are decimal commas; the same holds in Python
/// (brinell/surfaces/files.py).
/// @throws InputError if something was not measured (NaN): where, how much, and what helps; or as `text_lines`
[[nodiscard]] std::vector<NumberLine> number_lines(const std::filesystem::path& file);

} // namespace brinell::io
