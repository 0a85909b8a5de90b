// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/measured_curve.hpp"
#include "brinell/io/units.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// Reading of measured data from files, including read_curve() of measured_curve.hpp. A line that begins with # is a comment.
/// Numbers are separated by blanks, tabs, semicolons or commas. If something other than a comma separates the numbers of a line,
/// a comma is a decimal comma.
/// @throws InputError; its text continues a sentence that begins with the key ("has in line 3 ..."); IoError. (all of this
/// header)
namespace brinell::io
{

/// Size of a unit in SI.
/// @param allowed  for the error text: "stress, such as \"MPa\""
/// @throws InputError if the unit is unknown or has another dimension
[[nodiscard]] double size_of_unit(const std::string& unit, Dimension dimension, std::string_view allowed);

} // namespace brinell::io
