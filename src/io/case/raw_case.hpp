// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problems.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
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
  std::string place; ///< "file:line" or "--set key=value"
  bool from_command_line = false;
};

/// The keys of a case file that the schema knows, with the overrides applied.
struct RawCase
{
  std::string file;
  std::map<std::string, Given, std::less<>> values;
  std::map<std::string, std::string, std::less<>> tables; ///< places of the tables, for keys that are missing in them

  [[nodiscard]] const Given* find(std::string_view key) const;
  /// Where a missing key is missed: the innermost table that exists, or the file.
  [[nodiscard]] std::string place_for(std::string_view missing_key) const;
};

/// Parts that a key may have, as a.b.c has three. Those of a case have four at most; toml++ recurses into each of them, and
/// tens of thousands are more than a stack holds.
inline constexpr int deepest_key = 30;

/// The line of the first key of TOML that has more parts, counted from 1; none if there is none. Behind the first syntax error
/// it may go astray, but there the parser does not go.
[[nodiscard]] std::optional<int> line_of_deep_key(std::string_view toml);

/// Reads TOML, flattens it into dotted keys, applies the overrides and reports unknown keys.
/// @throws InputError on a syntax error, which leaves nothing to go on with
[[nodiscard]] RawCase read_raw_case(std::string_view text, const std::filesystem::path& file,
                                    const std::vector<std::string>& overrides, Problems& problems);

} // namespace brinell::io
