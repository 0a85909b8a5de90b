// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace brinell::io
{

/// Keys that differ between the cases of an earlier run and of this one, with both values: "grid.resolution = 5.0 there, 6.0
/// here". The first few are named, and the number of the others is given.
/// @param there, here  contents of resolved.toml
/// @throws InputError if one of them is not valid TOML
/// @returns empty if the cases have the same results: grid.extent, output.checkpoint_interval, solver.symmetry and solver.device are ignored
[[nodiscard]] std::string case_difference(std::string_view there, std::string_view here);

} // namespace brinell::io
