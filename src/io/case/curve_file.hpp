// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace brinell::io
{

/// Points of a measured hardening curve, in SI.
struct Curve
{
  std::vector<double> plastic_strain, stress;
};

/// Reads a text file with a point per line, plastic strain and stress. Between them stand blanks, a tab, a semicolon or a comma;
/// where something else than a comma does, a comma is a decimal one. Lines of titles may come first, comments begin with #.
/// @param strain_unit  "1" or "%"
/// @param stress_unit  as "MPa"
/// @throws InputError; its text continues a sentence that begins with the key ("has in line 3 ..."). IoError.
[[nodiscard]] Curve read_curve(const std::filesystem::path& file, std::string_view strain_unit,
                               std::string_view stress_unit);

/// @throws InputError unless it is a unit of pressure; its text continues a sentence that begins with the unit.
void require_unit_of_stress(const std::string& unit);

/// Lines of a text file that are no comments and not empty, with their numbers, which count from 1.
struct TextLine
{
  int number = 0;
  std::string text;
};
/// @throws InputError, IoError as `read_curve`.
[[nodiscard]] std::vector<TextLine> text_lines(const std::filesystem::path& file);

} // namespace brinell::io
