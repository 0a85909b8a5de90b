// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.hpp"
#include "brinell/foundation/error.hpp"
#include "brinell/foundation/processor.hpp"
#include "brinell/io/case_template.hpp"
#include "brinell/io/member_keys.hpp"
#include "brinell/io/printable.hpp"
#include "brinell/io/versions.hpp"
#include "commands.hpp"
#include "devices.hpp"
#include "options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <new>

namespace brinell::app
{

namespace
{

std::string version_text()
{
  const auto versions = io::library_versions();
  return fmt::format("brinell {} ({}), HDF5 {}, compiled for {}", versions.brinell, versions.git_hash, versions.hdf5,
                     versions.processor);
}

constexpr const char* footer = R"(
Exit codes: 0 done; 1 no convergence, a grid that outgrew the memory, or a file that could not be written; 2 an error in the command line or the case;
129, 130 or 143 interrupted (finished steps stay readable; --resume goes on).

A first run:
  brinell new tugging -o first.toml
  brinell check first.toml
  brinell run first.toml --set tugging.interference=2 -o results/first)";

/// Printed if the program is called without arguments.
constexpr std::string_view usage =
    R"(brinell computes the elastic-plastic contact of bodies that are pressed, rolled or slid.

  brinell new indentation -o first.toml   write a case file to begin with; also: {}
  brinell check first.toml                show its grid, memory and time
  brinell run first.toml -o results       compute it
  brinell plot all results                draw figures of the results
  brinell schema grid                     describe the keys of a case file

brinell --help lists all commands, brinell COMMAND --help the options of one.
)";

/// Prints the lines of an error, which may name members of a case, on stderr, each with the name of the program.
int report(std::string_view message, int exit_code)
{
  const std::string text = io::printable(io::with_keys(message));
  for (std::size_t begin = 0; begin <= text.size();)
  {
    const auto end = std::min(text.find('\n', begin), text.size());
    fmt::print(stderr, "brinell: error: {}\n", std::string_view(text).substr(begin, end - begin));
    begin = end + 1;
  }
  return exit_code;
}

/// Runs a command and turns its errors into messages and exit codes.
int guarded(const std::function<int()>& command)
{
  try
  {
    return command();
  }
  catch (const GridError& error) // a grid outgrew the memory during a run: the input is valid
  {
    return report(error.what(), exit_failure);
  }
  catch (const InputError& error)
  {
    return report(error.what(), exit_input);
  }
  catch (const ConvergenceError& error)
  {
    return report(fmt::format("no convergence: {}", error.what()), exit_failure);
  }
  catch (const IoError& error)
  {
    return report(error.what(), exit_failure);
  }
  catch (const DeviceError& error)
  {
    return report(fmt::format("the GPU: {}; --device cpu computes the case without one", error.what()), exit_failure);
  }
  catch (const std::bad_alloc&)
  {
    return report("out of memory; `brinell check` shows how much a case needs", exit_failure);
  }
  catch (const std::exception& error)
  {
    return report(fmt::format("internal error, a bug of brinell, please report it: {}", error.what()), exit_failure);
  }
}

/// Reports errors of CLI11 like any other error.
/// @returns the exit code, which is success for --help and --version
int parsing_ended(const CLI::App& app, const CLI::ParseError& error)
{
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success))
    return app.exit(error);
  const auto chosen = app.get_subcommands();
  return report(fmt::format("{}; brinell {}--help lists what is allowed", error.what(),
                            chosen.empty() ? "" : chosen.front()->get_name() + " "),
                exit_input);
}

/// Reports an unknown command; CLI11 would only say that a command is missing.
int unknown_command(const std::string& word, const std::vector<std::string>& names)
{
  return report(fmt::format("unknown command {}; allowed: {}", word, fmt::join(names, ", ")), exit_input);
}

int python_command(const std::string& name)
{
  return report(fmt::format("{} is a command of brinell's Python package, which is not this program; "
                            "`pip install .` in brinell's source folder installs a brinell that has it",
                            name),
                exit_input);
}

int run_chosen(const CLI::App& app, const Arguments& arguments, const std::shared_ptr<const Communicator>& ranks)
{
  const std::string name = app.get_subcommands().front()->get_name();
  if (name != "run" && ranks->rank() > 0)
    return exit_ok; // the first rank does it
  if (is_python_command(name))
    return python_command(name);
  if (name == "run")
    return run_command(arguments.run, ranks);
  if (name == "check")
    return check_command(arguments.check);
  if (name == "schema")
    return schema_command(arguments.schema);
  return name == "new" ? new_command(arguments.create) : cite_command(arguments.cite);
}

} // namespace

int command_line(std::vector<std::string> words, const std::shared_ptr<const Communicator>& ranks)
{
  offer_devices();
  const auto require_processor = []
  {
    require_processor_choice();
    return exit_ok;
  };
  if (const int status = guarded(require_processor); status != exit_ok)
    return status;
  if (words.empty())
  {
    std::vector<std::string> others = io::scenario_names();
    std::erase(others, "indentation");
    fmt::print(stderr, usage, fmt::join(others, ", "));
    return exit_input;
  }
  CLI::App app("brinell: elastic-plastic contact of bodies that are pressed, rolled or slid (semi-analytical method)",
               "brinell");
  app.require_subcommand(1);
  app.set_version_flag("--version", version_text());
  app.add_flag_callback(
      "--licenses", [] { throw CLI::CallForVersion(io::licenses(), exit_ok); },
      "Display the licences of brinell and its libraries and exit");
  app.footer(footer);
  Arguments arguments;
  declare_commands(app, arguments);
  const std::vector<std::string> names = command_names(app);
  if (!words.empty() && !words.front().starts_with('-') &&
      std::find(names.begin(), names.end(), words.front()) == names.end())
    return unknown_command(words.front(), names);
  try
  {
    std::reverse(words.begin(), words.end()); // CLI11 expects a vector in reverse order
    app.parse(std::move(words));
  }
  catch (const CLI::ParseError& error)
  {
    return parsing_ended(app, error);
  }
  return guarded([&] { return run_chosen(app, arguments, ranks); });
}

} // namespace brinell::app
