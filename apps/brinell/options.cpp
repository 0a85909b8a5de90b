// SPDX-License-Identifier: BSD-3-Clause
#include "options.hpp"

#include "brinell/io/case_template.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace brinell::app
{

namespace
{

struct PythonCommand
{
  const char *name, *help;
};

constexpr PythonCommand python_commands[] = {
    {"plot", "Draw figures of results"},
    {"report", "Write an HTML page on a run, with figures to turn and zoom"},
    {"sweep", "Run a case for many values of its keys"},
    {"fit", "Find unknown keys of a case from measured curves"},
    {"app", "Open a page to work on, served on this machine only"},
    {"surface", "Make, read, inspect and write surfaces"},
    {"material", "Show what becomes of a measured curve, and materials of standards"},
    {"export", "Convert stored fields for other programs"},
    {"completion", "Print the script with which bash, zsh or fish completes commands, options and keys"},
};

void add_case_arguments(CLI::App& command, CaseArguments& arguments)
{
  command.add_option("case", arguments.file, "Case file (TOML)")->required()->type_name("CASE.toml");
  command.add_option("--set", arguments.overrides, "Replace or add a key of the case: --set tugging.interference=4")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false) // one value per --set, so that the case file may follow it
      ->take_all();
}

void declare_run(CLI::App& app, RunArguments& arguments)
{
  auto* run = app.add_subcommand("run", "Compute a case and write its results");
  add_case_arguments(*run, arguments.input);
  run->add_option("-o,--output", arguments.directory,
                  "Folder of the results; default: the case's, or results/<name of the case>")
      ->type_name("DIR");
  run->add_option("--accuracy", arguments.accuracy,
                  "Run a series from coarser to finer cells until the estimated error of the key numbers is below this "
                  "share, and report the interval of each: --accuracy 1%")
      ->type_name("SHARE");
  run->add_option(
         "--device", arguments.device,
         "Where the bodies are computed: cpu, cuda (a GPU), auto, host; default: as the case says (solver.device)")
      ->type_name("DEVICE");
  run->add_option("--threads", arguments.threads, "Number of threads; default: all cores, or OMP_NUM_THREADS")
      ->type_name("N")
      ->check(CLI::Range(1, 4096));
  CLI::Option* resume =
      run->add_flag("--resume", arguments.resume, "Continue a run of this case that was stopped in that folder");
  run->add_flag("--keep", arguments.keep,
                "Stop with an error if that folder holds an earlier result; default: replace it")
      ->excludes(resume);
  run->add_flag("-q,--quiet", arguments.quiet, "Print nothing but warnings and errors");
}

void declare_new(CLI::App& app, NewArguments& arguments)
{
  auto* create = app.add_subcommand(
      "new", "Write a template of a case file: it runs as it is, and its comments describe all keys");
  create->add_option("scenario", arguments.scenario, fmt::format("{}", fmt::join(io::scenario_names(), ", ")))
      ->required()
      ->type_name("SCENARIO");
  create->add_option("-o,--output", arguments.file, "The file; default: print it")->type_name("CASE.toml");
  create->add_flag("--force", arguments.force, "Replace the file if it exists");
}

void declare_cite(CLI::App& app, CiteArguments& arguments)
{
  auto* cite = app.add_subcommand("cite", "List the papers behind the models of a case, and how to cite brinell");
  add_case_arguments(*cite, arguments.input);
  cite->add_flag("--bibtex", arguments.bibtex, "As a BibTeX file");
}

std::vector<OptionInfo> options_of(const CLI::App& command)
{
  std::vector<OptionInfo> options;
  for (const CLI::Option* option : command.get_options())
  {
    OptionInfo info{{}, option->get_expected_max() == 0 ? "" : option->get_type_name(), option->get_description()};
    for (const std::string& name : option->get_snames())
      info.flags.push_back(fmt::format("-{}", name));
    for (const std::string& name : option->get_lnames())
      info.flags.push_back(fmt::format("--{}", name));
    options.push_back(std::move(info));
  }
  return options;
}

} // namespace

void declare_commands(CLI::App& app, Arguments& arguments)
{
  declare_run(app, arguments.run);
  auto* check =
      app.add_subcommand("check", "Show the resolved case, critical values, grids, memory and cost, without running");
  add_case_arguments(*check, arguments.check.input);
  CLI::Option* ranks =
      check
          ->add_option("--ranks", arguments.check.ranks,
                       "Also show what each of N processes needs that compute the case together with MPI")
          ->type_name("N")
          ->check(CLI::Range(1, 1 << 20));
  check
      ->add_option("--machines", arguments.check.machines,
                   "Machines like this one over which the ranks are spread; default: 1")
      ->type_name("N")
      ->check(CLI::Range(1, 1 << 20))
      ->needs(ranks);
  auto* schema = app.add_subcommand("schema", "List all keys of the case file with units, ranges and defaults");
  schema->add_option("key", arguments.schema.key, "Only this key, or the keys of this table: lower.material")
      ->type_name("KEY");
  auto* markdown = schema->add_flag("--markdown", arguments.schema.markdown, "As the page docs/reference/case-file.md");
  schema->add_flag("--json", arguments.schema.json, "As a JSON Schema, by which editors check and complete case files")
      ->excludes(markdown);
  declare_new(app, arguments.create);
  declare_cite(app, arguments.cite);
  for (const PythonCommand& command : python_commands)
  {
    auto* other = app.add_subcommand(command.name, command.help)->group("Commands of the Python package");
    other->prefix_command(); // all further arguments, also --help, belong to the Python package
    other->set_help_flag();
  }
}

bool is_python_command(const std::string& name)
{
  return std::any_of(std::begin(python_commands), std::end(python_commands),
                     [&](const PythonCommand& command) { return name == command.name; });
}

std::vector<std::string> command_names(const CLI::App& app)
{
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

std::vector<CommandInfo> commands()
{
  CLI::App app;
  Arguments arguments;
  declare_commands(app, arguments);
  std::vector<CommandInfo> result;
  for (const std::string& name : command_names(app))
  {
    const CLI::App* command = app.get_subcommand(name);
    result.push_back({name, command->get_description(), options_of(*command)});
  }
  return result;
}

} // namespace brinell::app
