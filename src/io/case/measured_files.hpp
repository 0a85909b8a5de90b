// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/case_file.hpp"
#include "brinell/io/units.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// What was measured, from files. Those of text have a comment behind each # at the beginning of a line. Between their numbers stand
/// blanks, tabs, semicolons or commas; where something else than commas does, a comma is a decimal one: in a curve line by line,
/// of heights in the whole file. The same holds in Python (brinell/surfaces/files.py).
/// @throws InputError; its text continues a sentence that begins with the key ("has in line 3 ..."); IoError. (all of this header)
namespace brinell::io
{

/// Points of a measured hardening curve, in SI.
struct Curve
{
  std::vector<double> plastic_strain, stress;
};

/// Reads a text file with a point per line, plastic strain and stress. Lines of titles may come first.
/// @param strain_unit  "1" or "%"
/// @param stress_unit  as "MPa"
[[nodiscard]] Curve read_curve(const std::filesystem::path& file, std::string_view strain_unit,
                               std::string_view stress_unit);

/// Heights as they stand in the file: .npy, or text, a line per row.
[[nodiscard]] HeightTable read_heights(const std::filesystem::path& file);

/// What a unit is in SI.
/// @param allowed  "stress, such as \"MPa\""
[[nodiscard]] double size_of_unit(const std::string& unit, Dimension dimension, std::string_view allowed);

} // namespace brinell::io
