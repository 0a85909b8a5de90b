// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace brinell::io
{

/// What a column of the history is, for files that say it beside the numbers.
struct ColumnMeaning
{
  std::string_view units; ///< "1" for a pure number
  std::string_view long_name;
};

/// @throws InternalError if no scenario has such a column
[[nodiscard]] ColumnMeaning column_meaning(std::string_view name);

} // namespace brinell::io
