// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

/// Keys of the case file for the members of a case that messages of the engine name (simulation/plan_error.hpp).
namespace brinell::io
{

/// The key that fills a member, or the table that does: "interface.friction" for "Friction::coefficient". A name that is not that
/// of a member is returned as it is.
[[nodiscard]] std::string key_of_member(std::string_view member);

/// A message with the keys of the case file in the place of the members that it names between backticks.
[[nodiscard]] std::string with_keys(std::string_view message);

} // namespace brinell::io
