// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace brinell::io
{

/// Number of insertions, deletions, replacements and swaps of neighbours that turn one word into the other.
[[nodiscard]] int edit_distance(std::string_view a, std::string_view b);

/// "did you mean lower.shape.radius?" for a key or table that the schema does not have; if no key is similar, the list of
/// allowed keys.
/// @param scenario  its keys are preferred to those of other scenarios; empty if it is unknown
[[nodiscard]] std::string suggestion(std::string_view unknown_key, std::string_view scenario = "");

/// Names of the keys and tables in the table `parent`.
/// @param scenario  keys of other scenarios are left out; empty: the keys of all scenarios
[[nodiscard]] std::vector<std::string> children(std::string_view parent, std::string_view scenario = "");

/// Keys and tables allowed in the table `parent` ("" is the root), separated by commas.
[[nodiscard]] std::string known_keys(std::string_view parent);

} // namespace brinell::io
