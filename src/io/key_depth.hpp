// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string_view>

namespace brinell::io
{

/// Parts that a key may have, as a.b.c has three. Those of a case have four at most; toml++ recurses into each of them, and
/// tens of thousands are more than a stack holds.
inline constexpr int deepest_key = 30;

/// The line of the first key of TOML that has more parts, counted from 1; none if there is none.
[[nodiscard]] std::optional<int> line_of_deep_key(std::string_view toml);

} // namespace brinell::io
