// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace brinell::io
{

/// Keys that differ between the cases of an earlier run and of this one, with both values: "grid.resolution = 5.0 there, 6.0
/// here". A few of them are named, and how many more there are.
/// @param there, here  as resolved.toml has them
/// @returns empty if they are the same but for grid.extent, which only decides with which grids a run begins
[[nodiscard]] std::string case_difference(std::string_view there, std::string_view here);

} // namespace brinell::io
