// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/error.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

/// Lines of text that people, spreadsheets and instruments write, in whatever encoding.
namespace brinell::io
{

/// Characters that may stand around and between numbers; the last one ends files of DOS.
inline constexpr std::string_view white_space = " \t\r\f\v\x1a";

struct InputLine
{
  int number = 0; ///< counted from 1
  std::string_view text;
  bool is_comment = false; ///< begins with #
};

/// The lines of a file that are not blank, in UTF-8. Lines may end as those of any system. No-break and thin spaces have become
/// blanks, and the minus sign U+2212 a hyphen.
struct InputLines
{
  std::shared_ptr<const std::string> text; ///< of all lines
  std::vector<InputLine> lines;
  bool is_utf8 = true; ///< whether the file was; bytes of other files are taken as Latin-1

  /// The beginning of a line, or a part of one, for a message: in quotes, with bytes that were not UTF-8 as \xb5.
  [[nodiscard]] std::string quoted(std::string_view part) const { return '"' + shown(part) + '"'; }
  /// As `quoted`, without the quotes.
  [[nodiscard]] std::string shown(std::string_view part) const;
};

/// A file is no text. (What follows its name in a message.)
class NoText : public InputError
{
  using InputError::InputError;
};

/// @throws NoText; InputError that is meant to follow the file's name; IoError
[[nodiscard]] InputLines input_lines(const std::filesystem::path& file);

} // namespace brinell::io
