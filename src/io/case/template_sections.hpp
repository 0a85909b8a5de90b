// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Case files as lines, table by table, of which `brinell new` makes its cases.
namespace brinell::io
{

using Lines = std::vector<std::string>;

/// Lines that give one key, in use or as a comment.
struct KeyLines
{
  std::string key;
  Lines lines;
};

struct Section
{
  std::string table; ///< empty: the root
  Lines head;        ///< a ruler, and the line with its name
  Lines added;       ///< keys that have no line of their own: "#   key such as ...:"
  std::vector<KeyLines> keys;

  [[nodiscard]] const KeyLines* find(std::string_view key) const;
};

/// @param text  TOML of which each key takes one line; "#   " goes on with the key before it. Other comments are left out: the
///              schema tells what a key means
[[nodiscard]] std::vector<Section> sections_of(std::string_view text);

[[nodiscard]] const Section* find_section(const std::vector<Section>& sections, std::string_view table);

/// "cone" of `shape = { type = "cone", ... }`; empty if the line chooses nothing.
[[nodiscard]] std::string choice_of(const std::string& line);

} // namespace brinell::io
