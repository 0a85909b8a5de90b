// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.hpp"
#include "brinell/foundation/error.hpp"
#include "brinell/io/versions.hpp"
#include "commands.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <fmt/format.h>
#include <functional>
#include <new>

namespace brinell::app
{

namespace
{

std::string version_text()
{
  const auto versions = io::library_versions();
  return fmt::format("brinell {} ({}), FFTW {}, HDF5 {}", versions.brinell, versions.git_hash, versions.fftw,
                     versions.hdf5);
}

constexpr const char* footer = R"(
Exit codes: 0 done; 1 no convergence, or a file could not be written; 2 an error in the command line or the case;
130 or 143 interrupted (finished steps stay readable; --resume goes on).

A first run:
  brinell check cases/tugging-paper/case.toml
  brinell run cases/tugging-paper/case.toml --set tugging.interference=4 -o results/alpha-4)";

void add_case_arguments(CLI::App& command, CaseArguments& arguments)
{
  command.add_option("case", arguments.file, "Case file (TOML)")->required()->type_name("CASE.toml");
  command.add_option("--set", arguments.overrides, "Replace or add a key of the case: --set tugging.interference=4")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false) // one value per --set, so that the case file may follow it
      ->take_all();
}

/// An error's lines on stderr, each with the name of the program.
int report(std::string_view text, int exit_code)
{
  for (std::size_t begin = 0; begin <= text.size();)
  {
    const auto end = std::min(text.find('\n', begin), text.size());
    fmt::print(stderr, "brinell: error: {}\n", text.substr(begin, end - begin));
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
  catch (const std::bad_alloc&)
  {
    return report("out of memory; `brinell check` tells how much a case needs", exit_failure);
  }
  catch (const std::exception& error)
  {
    return report(fmt::format("internal error, a bug of brinell, please report it: {}", error.what()), exit_failure);
  }
}

} // namespace

int command_line(std::vector<std::string> arguments)
{
  CLI::App app("brinell: elastic-plastic contact of bodies that are pressed, rolled or slid (semi-analytical method)",
               "brinell");
  app.require_subcommand(1);
  app.set_version_flag("--version", version_text());
  app.footer(footer);

  RunArguments run_arguments;
  auto* run = app.add_subcommand("run", "Compute a case and write its results");
  add_case_arguments(*run, run_arguments.input);
  run->add_option("-o,--output", run_arguments.directory,
                  "Folder of the results; default: the case's, or results/<name of the case>")
      ->type_name("DIR");
  run->add_option("--threads", run_arguments.threads, "Number of threads; default: all cores, or OMP_NUM_THREADS")
      ->type_name("N")
      ->check(CLI::Range(1, 4096));
  run->add_flag("--resume", run_arguments.resume, "Go on with a run of this case that was stopped in that folder");
  run->add_flag("-q,--quiet", run_arguments.quiet, "Print nothing but warnings and errors");

  CaseArguments check_arguments;
  auto* check =
      app.add_subcommand("check", "Show the resolved case, critical values, grids, memory and cost, without running");
  add_case_arguments(*check, check_arguments);

  bool markdown = false;
  auto* schema = app.add_subcommand("schema", "List all keys of the case file with units, ranges and defaults");
  schema->add_flag("--markdown", markdown, "As the page docs/reference/case-file.md");

  try
  {
    std::reverse(arguments.begin(), arguments.end()); // as CLI11 takes a vector
    app.parse(std::move(arguments));
  }
  catch (const CLI::ParseError& error)
  {
    return app.exit(error) == 0 ? exit_ok : exit_input;
  }
  return guarded(
      [&]
      {
        if (*run)
          return run_command(run_arguments);
        return *check ? check_command(check_arguments) : schema_command(markdown);
      });
}

} // namespace brinell::app
