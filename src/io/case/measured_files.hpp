// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/units.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// Reading of measured curves. A line that begins with # is a comment. Numbers are separated by blanks, tabs, semicolons or
/// commas. If something other than a comma separates the numbers of a line, a comma is a decimal comma.
/// @throws InputError; its text continues a sentence that begins with the key ("has in line 3 ..."); IoError. (all of this
/// header)
namespace brinell::io
{

/// Points of a measured hardening curve, in SI.
struct Curve
{
  std::vector<double> plastic_strain, stress;
};

/// Reads a text file with one point per line, plastic strain and stress. Title lines may precede the points.
/// @param strain_unit  "1" or "%"
/// @param stress_unit  such as "MPa"
[[nodiscard]] Curve read_curve(const std::filesystem::path& file, std::string_view strain_unit,
                               std::string_view stress_unit);

/// Size of a unit in SI.
/// @param allowed  for the error text: "stress, such as \"MPa\""
/// @throws InputError if the unit is unknown or has another dimension
[[nodiscard]] double size_of_unit(const std::string& unit, Dimension dimension, std::string_view allowed);

} // namespace brinell::io
