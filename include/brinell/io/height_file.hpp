// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/error.hpp"
#include "brinell/io/case_file.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

/// Files of measured heights: text, and .npy files of NumPy. Case files, the command line and Python read text by the same code.
namespace brinell::io
{

/// Meaning of the lines of a text.
enum class HeightLayout
{
  automatic, ///< points if the first two of three columns form a grid
  rows,      ///< the heights of one row along x per line
  points     ///< x, y and height of one point per line
};

/// @throws InputError if the word is neither "rows" nor "points"
[[nodiscard]] HeightLayout height_layout(std::string_view word);

/// Properties of the heights that the file may not state itself.
struct HeightFileOptions
{
  std::optional<std::string> unit{}; ///< of the heights; of points also of x and y
  HeightLayout layout = HeightLayout::automatic;
  bool fill = false; ///< whether a smooth surface replaces gaps; read by who uses the heights
};

/// A map, and what its file says about it.
struct HeightFile
{
  HeightTable table;                            ///< [m]; NaN where nothing was measured
  std::optional<std::array<double, 2>> spacing; ///< distances along x and y [m]
  std::optional<double> x, y;                   ///< centre on the body's surface [m]
  std::optional<bool> periodic;
  std::size_t gaps = 0;  ///< points without a height
  std::string first_gap; ///< "in line 3, column 2 no height"
};

/// The content is not text that begins with numbers, or holds several maps: perhaps an instrument's format.
class NoHeightText : public InputError
{
  using InputError::InputError;
};

/// Reads text (any ending): a line per row along x, or a line x, y, height per point. Numbers are separated by blanks, tabs,
/// semicolons or commas; an empty cell is a gap. If something other than commas separates the numbers, commas are decimal commas.
/// Comments begin with #; among them are the headers of brinell's own files, of Gwyddion and of SPIP.
/// @throws NoHeightText; InputError; IoError. Their texts continue a sentence that begins with the file's name
[[nodiscard]] HeightFile read_height_text(const std::filesystem::path& path, const HeightFileOptions& options);

/// Reads text or, recognised by its first bytes, a .npy file, whose numbers are in `unit` or m.
/// @throws as read_height_text
[[nodiscard]] HeightFile read_height_file(const std::filesystem::path& path, const HeightFileOptions& options);

/// The error for gaps: where the first one is, their number and a remedy.
[[nodiscard]] std::string gap_text(const HeightFile& file);

} // namespace brinell::io
