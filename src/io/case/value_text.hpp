// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/schema.hpp"

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace brinell::io
{

/// Words of the first kinds of a SnapshotRule, in the order of the enumeration.
inline constexpr std::array rule_words{"none", "aligned", "all"};

/// A TOML string literal.
[[nodiscard]] std::string toml_string(std::string_view text);

/// A value as written after "key = " in a case file; numbers in the shortest form that reads back the same.
[[nodiscard]] std::string toml_text(const Value& value);

[[nodiscard]] nlohmann::ordered_json json_value(const Value& value);

} // namespace brinell::io
