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
  /// A TOML type no key has: a date, a table inside a list.
  struct Other
  {
    std::string type;
  };
  std::variant<bool, std::int64_t, double, std::string, std::vector<Raw>, Other> value;
};

/// "a string", "an integer", ...
[[nodiscard]] std::string type_name(const Raw& raw);

/// The value as TOML on one line, shortened if it is long.
[[nodiscard]] std::string shown(const Raw& raw);

/// A key's value and where it stands.
struct Given
{
  Raw raw;
  std::string place; ///< "file:line" or "--set key=value"; empty as in RawCase::file
  bool from_command_line = false;
  std::string_view old_name{}; ///< old name under which it was given; empty if given by its present name
};

/// The keys of a case file that the schema knows, with the overrides applied. Those of a list of tables are numbered from 0:
/// lower.texture[0].type.
struct RawCase
{
  std::string file;             ///< as messages name it; empty if they do not, of a text that nobody sees
  std::filesystem::path folder; ///< where the paths in the case begin
  std::map<std::string, Given, std::less<>> values;
  std::map<std::string, std::string, std::less<>> tables; ///< places of the tables, for keys that are missing in them

  const HeightTables* height_tables = nullptr; ///< tables in memory that texture.file may name

  std::map<std::string, int, std::less<>> lists; ///< repeated tables with their numbers

  std::vector<simulation::Warning> warnings; ///< about old names

  [[nodiscard]] const Given* find(std::string_view key) const;
  /// The table itself, or each one of its list.
  [[nodiscard]] std::vector<std::string> tables_of(const std::string& table) const;
  /// Where a missing key is missed: the innermost table that exists, or the file.
  [[nodiscard]] std::string place_for(std::string_view missing_key) const;
};

/// Reads TOML, flattens it into dotted keys, applies the overrides and reports unknown keys.
/// @throws InputError on a syntax error, which leaves nothing to go on with
[[nodiscard]] RawCase read_raw_case(std::string_view text, const std::filesystem::path& file,
                                    const std::vector<std::string>& overrides, Places places, Problems& problems);

} // namespace brinell::io
