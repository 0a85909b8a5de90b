// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace brinell::app
{

/// The program, but for its start: prints, and turns errors into messages.
/// @param words  its arguments, without the program's name
/// @returns the exit code
[[nodiscard]] int command_line(std::vector<std::string> words);

} // namespace brinell::app
