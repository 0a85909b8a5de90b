// SPDX-License-Identifier: BSD-3-Clause
#include "commands.hpp"
#include "brinell/foundation/error.hpp"
#include "brinell/io/case_template.hpp"
#include "brinell/io/citations.hpp"
#include "brinell/io/feasibility.hpp"
#include "brinell/io/forecast.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "run_case.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <limits>
#include <optional>

namespace brinell::app
{

namespace
{

void print_warnings(const io::Case& c, const std::vector<io::Warning>& warnings)
{
  for (const io::Warning& warning : warnings)
    fmt::print(stderr, "brinell: warning: {}: {}\n", c.file.string(), warning.text);
}

/// Warnings that have not been printed yet.
std::vector<io::Warning> new_warnings(const std::vector<io::Warning>& printed, const std::vector<io::Warning>& all)
{
  std::vector<io::Warning> warnings;
  for (const io::Warning& warning : all)
    if (std::find(printed.begin(), printed.end(), warning) == printed.end())
      warnings.push_back(warning);
  return warnings;
}

/// Overrides of the case, including those from options.
std::vector<std::string> overrides_of(const RunArguments& arguments)
{
  std::vector<std::string> overrides = arguments.input.overrides;
  if (!arguments.accuracy.empty())
    overrides.push_back("solver.accuracy=" + arguments.accuracy);
  if (!arguments.device.empty())
    overrides.push_back("solver.device=" + arguments.device);
  return overrides;
}

/// Reads the case. Messages about keys that were given as options, like solver.accuracy, are changed to name the option, --accuracy.
io::Case case_of(const RunArguments& arguments)
try
{
  return io::read_case(arguments.input.file, overrides_of(arguments));
}
catch (const InputError& error)
{
  std::string text = error.what();
  for (const auto& [name, value] : {std::pair{"accuracy", &arguments.accuracy}, {"device", &arguments.device}})
  {
    const std::string as_key = fmt::format("--set solver.{}={}", name, *value),
                      as_option = fmt::format("--{} {}", name, *value);
    for (auto at = text.find(as_key); !value->empty() && at != text.npos; at = text.find(as_key, at + 1))
      text.replace(at, as_key.size(), as_option);
  }
  throw InputError(text);
}

/// Tells time and memory of a run that is long or large.
void print_forecast(const io::Case& c, const io::ScenarioPlan& plan)
{
  constexpr double is_long = 10.0, is_large = 1e9; // [s], [bytes]
  const io::Forecast forecast = io::forecast(c, plan);
  if (forecast.seconds > is_long || forecast.memory > is_large)
    fmt::print(stderr, "brinell: {}{}\n", io::forecast_text(forecast),
               c.accuracy ? ", for the run with the given cells alone" : "");
}

} // namespace

int run_command(const RunArguments& arguments, const std::shared_ptr<const Communicator>& ranks)
{
  const io::Case c = case_of(arguments);
  require_shareable(c, ranks->size());
  const io::ScenarioPlan plan =
      io::plan_case(c, memory_of_machines(*ranks)); // throws before anything is written if the case cannot be computed
  std::vector<io::Warning> printed = c.warnings;
  for (io::Warning& warning : io::result_warnings(c, plan))
    printed.push_back(std::move(warning));
  print_warnings(c, printed);
  if (!arguments.quiet)
    print_forecast(c, plan);
  using Mode = io::ResultDirectory::Mode;
  const RunOptions options{arguments.directory.empty() ? default_folder(c) : std::filesystem::path(arguments.directory),
                           arguments.resume ? Mode::resume
                           : arguments.keep ? Mode::keep
                                            : Mode::replace,
                           arguments.threads, ranks};
  const std::string folder = options.folder.string();
  const InterruptGuard guard;
  std::optional<Progress> progress;
  RunMonitor monitor;
  monitor.on_start = [&](bool replaced, int finished_steps)
  {
    progress.emplace(arguments.quiet, finished_steps);
    if (replaced && !arguments.quiet)
      fmt::print(stderr, "brinell: replacing the earlier result in {}\n", folder);
    if (arguments.resume && !arguments.quiet)
      fmt::print(stderr, "brinell: resuming after {} finished steps\n", finished_steps);
  };
  monitor.on_step = [&](int step, int count, const std::string& where, int evaluations)
  { progress->step(step, count, where, evaluations); };
  monitor.on_remark = [&](const std::string& remark) { progress->remark(remark); };
  monitor.on_level = [&](int number, double cells, bool taken_over)
  {
    progress.reset();
    if (!arguments.quiet)
      fmt::print(stderr, "brinell: run {} for the accuracy, cells of {:.3g} times the size{}\n", number, cells,
                 taken_over ? ": reused, because it was finished before" : "");
  };
  monitor.wants_stop = [] { return InterruptGuard::signal() != 0; };
  try
  {
    const RunReport report = run_case(c, plan, options, monitor);
    progress.reset();
    if (!arguments.quiet)
      fmt::print("{}results in {}\n", report.text, folder);
    std::fflush(stdout); // so that the warnings come last
    print_warnings(c, new_warnings(printed, report.warnings));
  }
  catch (const Interrupted&)
  {
    progress.reset();
    fmt::print(stderr, "brinell: interrupted; the finished steps are in {}, and --resume continues the run\n", folder);
    // All ranks end alike, also those that have got no signal themselves.
    return 128 + static_cast<int>(ranks->largest(InterruptGuard::signal()));
  }
  catch (const std::runtime_error&) // such as no convergence, a grid that is too small, a full disk
  {
    if (progress) // otherwise nothing has been written
    {
      progress.reset();
      fmt::print(stderr, "brinell: the finished steps are in {}\n", folder);
    }
    throw;
  }
  return exit_ok;
}

int check_command(const CheckArguments& arguments)
{
  const io::Case c = io::read_case(arguments.input.file, arguments.input.overrides);
  print_warnings(c, c.warnings); // printed first, because they may explain why the plan fails
  require_shareable(c, arguments.ranks);
  const bool is_shared = arguments.ranks > 1;
  const io::ScenarioPlan plan =
      is_shared ? io::plan_case(c, std::numeric_limits<double>::infinity()) : io::plan_case(c);
  const std::string of_ranks =
      is_shared ? io::ranks_report(c, plan, arguments.ranks, arguments.machines) : std::string();
  print_warnings(c, new_warnings(c.warnings, io::expected_warnings(c, plan)));
  fmt::print("{}{}", io::check_report(c, plan), of_ranks);
  return exit_ok;
}

int schema_command(const SchemaArguments& arguments)
{
  if (!arguments.key.empty() && (arguments.markdown || arguments.json))
    throw InputError(fmt::format(
        "a key, {}, cannot be combined with --markdown or --json, which describe all keys; allowed: one of them",
        arguments.key));
  fmt::print("{}", arguments.markdown ? io::schema_markdown()
                   : arguments.json   ? io::schema_json()
                                      : io::schema_text(arguments.key));
  return exit_ok;
}

int new_command(const NewArguments& arguments)
{
  if (arguments.file.empty())
    fmt::print("{}", io::case_template(arguments.scenario));
  else
  {
    io::write_case_template(arguments.scenario, arguments.file, arguments.force);
    fmt::print("{} is written; `brinell check {}` shows its grid, memory and time\n", arguments.file, arguments.file);
  }
  return exit_ok;
}

int cite_command(const CiteArguments& arguments)
{
  const io::Case c = io::read_case(arguments.input.file, arguments.input.overrides);
  print_warnings(c, c.warnings);
  if (arguments.bibtex)
  {
    fmt::print("{}", io::brinell_reference().bibtex);
    for (const io::Citation& citation : io::citations(c))
      fmt::print("\n% {}\n{}", citation.use, citation.reference.bibtex);
    return exit_ok;
  }
  fmt::print("If you publish results of this case, please cite brinell\n\n{}\n\n"
             "and the papers behind the models that it uses:\n",
             io::reference_text(io::brinell_reference()));
  for (const io::Citation& citation : io::citations(c))
    fmt::print("\n{}\n    for: {}\n", io::reference_text(citation.reference), citation.use);
  return exit_ok;
}

} // namespace brinell::app
