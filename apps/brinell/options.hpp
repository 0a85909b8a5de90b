// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "commands.hpp"

#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace brinell::app
{

/// What the options of all commands are written to.
struct Arguments
{
  RunArguments run;
  CaseArguments check;
  SchemaArguments schema;
  NewArguments create;
  CiteArguments cite;
};

/// Declares all commands with their options, those of the Python package by name only.
void declare_commands(CLI::App& app, Arguments& arguments);

[[nodiscard]] std::vector<std::string> command_names(const CLI::App& app);

/// Whether a command is one of the Python package, which this library does not run.
[[nodiscard]] bool is_python_command(const std::string& name);

/// An option, or a value that stands by itself.
struct OptionInfo
{
  std::vector<std::string> flags; ///< "-o", "--output"; empty: a value by itself
  std::string value;              ///< name of what follows the flag, "DIR"; empty: nothing does
  std::string help;
};

struct CommandInfo
{
  std::string name, help;
  std::vector<OptionInfo> options; ///< none if it is a command of the Python package
};

/// All commands, for the completion of shells.
[[nodiscard]] std::vector<CommandInfo> commands();

} // namespace brinell::app
