// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace brinell::io
{

/// Number of insertions, deletions, replacements and swaps of neighbours that turn one word into the other.
[[nodiscard]] int edit_distance(std::string_view a, std::string_view b);

/// "did you mean lower.shape.radius?" for a key or table that the schema does not have; the keys that may stand in that
/// place if none is near.
/// @param scenario  whose keys are preferred to those of others; empty if it is not known
[[nodiscard]] std::string suggestion(std::string_view unknown_key, std::string_view scenario = "");

/// Names of the keys and tables in the table `parent`, of all scenarios or without those of others.
[[nodiscard]] std::vector<std::string> children(std::string_view parent, std::string_view scenario = "");

/// Keys and tables that may stand in the table `parent` ("" is the root), separated by commas.
[[nodiscard]] std::string known_keys(std::string_view parent);

} // namespace brinell::io
