// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace brinell::io
{

/// Number of insertions, deletions, replacements and swaps of neighbours that turn one word into the other.
[[nodiscard]] int edit_distance(std::string_view a, std::string_view b);

/// "did you mean lower.shape.radius?" for a key or table that the schema does not have; the keys that may stand in that
/// place if none is near.
[[nodiscard]] std::string suggestion(std::string_view unknown_key);

/// Keys and tables that may stand in the table `parent` ("" is the root), separated by commas.
[[nodiscard]] std::string known_keys(std::string_view parent);

} // namespace brinell::io
