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

/// Values of the options of all commands.
struct Arguments
{
  RunArguments run;
  CheckArguments check;
  SchemaArguments schema;
  NewArguments create;
  CiteArguments cite;
};

/// Declares all commands with their options, those of the Python package by name only.
void declare_commands(CLI::App& app, Arguments& arguments);

[[nodiscard]] std::vector<std::string> command_names(const CLI::App& app);

/// Whether a command belongs to the Python package; this library does not run it.
[[nodiscard]] bool is_python_command(const std::string& name);

/// An option, or a positional argument.
struct OptionInfo
{
  std::vector<std::string> flags; ///< "-o", "--output"; empty: a positional argument
  std::string value;              ///< name of the option's value, "DIR"; empty: it has none
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
