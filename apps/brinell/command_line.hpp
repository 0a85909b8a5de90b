// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace brinell::app
{

/// The program: runs a command, prints its output, and turns errors into messages.
/// @param words  command-line arguments, without the program's name
/// @returns the exit code
[[nodiscard]] int command_line(std::vector<std::string> words);

} // namespace brinell::app
