// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/communicator.hpp"

#include <memory>
#include <string>
#include <vector>

namespace brinell::app
{

/// The program: runs a command, prints its output, and turns errors into messages.
/// @param words  command-line arguments, without the program's name
/// @param ranks  processes that were started together with these words; each calls this function
/// @returns the exit code
[[nodiscard]] int
command_line(std::vector<std::string> words,
             const std::shared_ptr<const Communicator>& ranks = std::make_shared<const Communicator>());

} // namespace brinell::app
