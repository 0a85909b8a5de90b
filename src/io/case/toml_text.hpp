// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <toml++/toml.h>

/// Text that is to be TOML, and what is told where it is none.
namespace brinell::io
{

/// Parts that a key may have, as a.b.c has three. Those of a case have four at most; toml++ recurses into each of them, and
/// tens of thousands are more than a stack holds.
inline constexpr int deepest_key = 30;

/// The line of the first key of TOML that has more parts, counted from 1; none if there is none. Behind the first syntax error
/// it may go astray, but there the parser does not go.
[[nodiscard]] std::optional<int> line_of_deep_key(std::string_view toml);
[[nodiscard]] std::string too_deep();

/// @param file  as messages name it
/// @throws InputError with line and column, and what may have been meant
[[nodiscard]] toml::table parse_toml(std::string_view text, const std::string& file);

} // namespace brinell::io
