// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/units.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// The case file, declared once. Reading, checking, defaults, the resolved case, `brinell schema` and docs/reference/case-file.md
/// all come from the table `case_schema()`. A new key is a new entry there (src/io/case/schema_*.cpp; those of a scenario:
/// src/io/scenarios), which also says which member it fills; only keys that need more than the schema are read by functions.
namespace brinell::io
{

/// Steps whose fields are stored.
struct SnapshotRule
{
  enum class Kind
  {
    none,
    aligned, ///< the step nearest to the middle of each pass; indentation: where the imposed load or approach turns
    all,
    every, ///< every n-th step, from step 0
    listed
  };
  Kind kind = Kind::aligned;
  int every = 1;
  std::vector<int> steps{}; ///< ascending

  /// @param is_key_step  whether "aligned" selects this step
  [[nodiscard]] bool stores(int step, bool is_key_step) const;
  bool operator==(const SnapshotRule&) const = default;
};

using Vector3 = std::array<double, 3>;

/// A value of the case in SI.
using Value = std::variant<bool, std::int64_t, double, std::string, Vector3, std::vector<double>, SnapshotRule,
                           std::vector<std::string>>;

enum class Type
{
  text,
  choice,  ///< one of Entry::choices
  boolean, ///< true, false
  integer,
  number,
  vector3,   ///< three numbers, x y z
  numbers,   ///< a list of at least one number
  snapshots, ///< SnapshotRule
  words      ///< a list of Entry::choices, at least one
};

/// Names of the types, in the order of `Type`.
inline constexpr std::array<std::string_view, 9> type_names{"text",    "choice",  "boolean",   "integer", "number",
                                                            "vector3", "numbers", "snapshots", "words"};

/// Allowed interval of a number (of each component of a vector or list).
struct Range
{
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool min_allowed = true, max_allowed = true;
  bool zero_allowed = true;

  /// Whether a value is allowed; false for NaN and infinities.
  [[nodiscard]] bool contains(double x) const;
  /// "> 0", "in [1, 20]"; empty if everything is allowed.
  [[nodiscard]] std::string text() const;
};

/// Further notations allowed for a number without dimension.
enum class Notation
{
  plain,
  share,      ///< "1 %"
  angle,      ///< in degrees: "1.2 rad"
  temperature ///< in degC: "293.15 K"
};

/// The kind of values of a key, and which of them are allowed.
struct ValueKind
{
  Type type = Type::number;
  Dimension dimension{};
  Notation notation = Notation::plain;
  Range range{};

  [[nodiscard]] constexpr ValueKind list() const { return {Type::numbers, dimension, notation, range}; }
  [[nodiscard]] constexpr ValueKind in(const Range& allowed) const { return {type, dimension, notation, allowed}; }
  [[nodiscard]] constexpr ValueKind above(double min) const { return in({.min = min, .min_allowed = false}); }
  [[nodiscard]] constexpr ValueKind at_least(double min) const { return in({.min = min}); }
  [[nodiscard]] constexpr ValueKind between(double min, double max) const { return in({.min = min, .max = max}); }
  /// Interval (min, max].
  [[nodiscard]] constexpr ValueKind up_to(double min, double max) const
  {
    return in({.min = min, .max = max, .min_allowed = false});
  }
  [[nodiscard]] constexpr ValueKind inside(double min, double max) const
  {
    return in({.min = min, .max = max, .min_allowed = false, .max_allowed = false});
  }
  [[nodiscard]] constexpr ValueKind nonzero() const { return in({.zero_allowed = false}); }
};

/// The unit of a bare number: "m", "degrees", "degC"; empty for a number without dimension.
[[nodiscard]] std::string unit_of(const ValueKind& kind);

/// The entry applies if another key has one of these values ("true", "false" for a boolean). No key: always.
struct Condition
{
  std::string key;
  std::vector<std::string> values;
  std::string instead{}; ///< keys to give where the entry does not apply, for the message; may be empty
};

struct Case;

/// Range of a number over all that exists; a value outside has probably a wrong unit.
struct Usual
{
  const char* warning = nullptr; ///< name of the warning; nullptr: no range
  double min = 0.0, max = 0.0;
  const char* doubt = nullptr; ///< "which no solid has"
};

/// One key of the case file.
struct Entry
{
  std::string key; ///< dotted, from the root of the file
  ValueKind of{};
  std::vector<std::string> choices{}; ///< if there are any, the value is one of them, or a list of them
  bool per_axis = false;              ///< a choice that may also be given as a list, along x and along y
  bool required = false;              ///< if the condition holds
  std::optional<Value> fallback{};    ///< default; a key without one and not required may stay unset
  std::vector<std::pair<std::string, Value>> fallback_in{}; ///< other defaults in some scenarios
  std::string unset{};                                      ///< effect of leaving the key unset
  std::string text;                                         ///< meaning
  std::string hint{};                                       ///< usual values, for messages
  Usual usual{};                                            ///< of SI values
  Condition when{};
  std::string excludes{}; ///< a key that cannot stand beside this one
  std::string
      one_of{}; ///< group of keys of which exactly one is given; one on the command line overrides one in the file
  std::string list{};    ///< name of its table, if the table may be repeated, as in [[lower.texture]]
  std::string pure_if{}; ///< boolean key: if true the value is a pure number, not a quantity
  std::string member{};  ///< the member that it fills as messages name it, "CurrentDrive::film"; see member_keys.hpp
  std::function<void(Case&, const Value&)> fill{}; ///< stores the value in the case; empty: a separate reader does so
};

/// The default of a key in a scenario.
[[nodiscard]] std::optional<Value> fallback_of(const Entry& entry, std::string_view scenario);

/// Whether a key may be given in a scenario, by its condition and those of the keys that this condition names.
[[nodiscard]] bool belongs_to(const Entry& entry, std::string_view scenario);

/// All keys: parents before children, and keys before those that depend on them.
[[nodiscard]] const std::vector<Entry>& case_schema();

/// Key or table without its number in a list of tables: lower.texture.type for lower.texture[0].type.
[[nodiscard]] std::string plain_key(std::string_view key);

/// Entry of a key, also of a key in a list of tables; nullptr if there is none.
[[nodiscard]] const Entry* find_entry(std::string_view key);

/// Whether some entry lies in the table `key`.
[[nodiscard]] bool is_table(std::string_view key);

/// Whether a table may be repeated; its instances are numbered from 0: lower.texture[0].type.
[[nodiscard]] bool is_list_of_tables(std::string_view key);

/// Allowed values of a key as text: "length > 0, in m or with a unit as in \"3.85 mm\"".
[[nodiscard]] std::string allowed_values(const Entry& entry);

/// The default of a key as text, `12.0, in tugging 15.0`, or the effect of leaving it unset; "required" for a required key.
[[nodiscard]] std::string default_text(const Entry& entry);

/// The table for a terminal.
/// @param part  a key, or a table, whose keys are all described; empty: everything
/// @throws InputError if there is no such key
[[nodiscard]] std::string schema_text(std::string_view part = {});

/// The table as a JSON Schema, with which editors check and complete TOML files.
[[nodiscard]] std::string schema_json();

/// The page docs/reference/case-file.md.
[[nodiscard]] std::string schema_markdown();

} // namespace brinell::io
