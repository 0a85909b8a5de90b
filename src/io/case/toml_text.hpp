// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "raw_case.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <toml++/toml.h>

/// Parsing of TOML, with hints about common mistakes.
namespace brinell::io
{

/// Largest number of parts of a key; a.b.c has three. The keys of a case have at most four. The limit exists because toml++
/// recurses into each part, and tens of thousands of them would overflow the stack.
inline constexpr int deepest_key = 30;

/// Line, counted from 1, of the first key with more parts than `deepest_key`; none if there is no such key. After a syntax error
/// the result may be wrong, but the parser stops at that error anyway.
[[nodiscard]] std::optional<int> line_of_deep_key(std::string_view toml);
/// Error text for such a key.
[[nodiscard]] std::string too_deep();

/// @param file  its name in messages
/// @throws InputError with line, column and a hint about common mistakes
[[nodiscard]] toml::table parse_toml(std::string_view text, const std::string& file);

[[nodiscard]] Raw raw_value(const toml::node& node);

} // namespace brinell::io
