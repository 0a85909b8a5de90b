// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/schema.hpp"

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace brinell::io
{

/// The first kinds of a SnapshotRule, in their order.
inline constexpr std::array rule_words{"none", "aligned", "all"};

/// A TOML string literal.
[[nodiscard]] std::string toml_string(std::string_view text);

/// A value as it stands behind "key = " in a case file; numbers in the shortest form that reads back the same.
[[nodiscard]] std::string toml_text(const Value& value);

[[nodiscard]] nlohmann::ordered_json json_value(const Value& value);

} // namespace brinell::io
