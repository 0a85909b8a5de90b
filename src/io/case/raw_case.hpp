// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/case_file.hpp"
#include "problems.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace brinell::io
{

/// A value as written in the file, before it is compared with the schema.
struct Raw
{
  /// A TOML type that no key accepts: a date, or a table inside a list.
  struct Other
  {
    std::string type;
    bool operator==(const Other&) const = default;
  };
  std::variant<bool, std::int64_t, double, std::string, std::vector<Raw>, Other> value;
  bool operator==(const Raw&) const = default;
};

/// "a string", "an integer", ...
[[nodiscard]] std::string type_name(const Raw& raw);

/// The value as TOML on one line, shortened if it is long.
[[nodiscard]] std::string shown(const Raw& raw);

/// The value of a key and its place.
struct Given
{
  Raw raw;
  std::string place; ///< "file:line" or "--set key=value"; empty as in RawCase::file
  bool from_command_line = false;
};

/// The keys of a case file that the schema knows, with the overrides applied. Tables of a list are numbered from 0:
/// lower.texture[0].type.
struct RawCase
{
  std::string file;             ///< name used in messages; empty if a program has made the text (Places::none)
  std::filesystem::path folder; ///< folder that paths in the case are relative to
  std::map<std::string, Given, std::less<>> values;
  std::map<std::string, std::string, std::less<>> tables; ///< places of the tables, for messages about missing keys

  const HeightTables* height_tables = nullptr; ///< tables in memory to which texture.file may refer

  std::map<std::string, int, std::less<>> lists; ///< repeated tables with the number of their instances

  [[nodiscard]] const Given* find(std::string_view key) const;
  /// The table itself, or, if it is repeated, all its numbered instances.
  [[nodiscard]] std::vector<std::string> tables_of(const std::string& table) const;
  /// Place for a message about a missing key: the innermost existing table around the key, or the file.
  [[nodiscard]] std::string place_for(std::string_view missing_key) const;
};

/// Reads TOML, flattens it into dotted keys, applies the overrides and reports unknown keys.
/// @throws InputError on a syntax error, after which nothing can be read
[[nodiscard]] RawCase read_raw_case(std::string_view text, const std::filesystem::path& file,
                                    const std::vector<std::string>& overrides, Places places, Problems& problems);

} // namespace brinell::io
