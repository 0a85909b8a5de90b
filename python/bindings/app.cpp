// SPDX-License-Identifier: BSD-3-Clause
#include "arrays.hpp"
#include "module.hpp"
#include "python_calls.hpp"
#include "python_ranks.hpp"

#include "brinell/command_line.hpp"
#include "brinell/foundation/error.hpp"
#include "brinell/foundation/fork.hpp"
#include "brinell/io/citations.hpp"
#include "brinell/io/feasibility.hpp"
#include "brinell/io/forecast.hpp"
#include "brinell/io/history_csv.hpp"
#include "brinell/io/printable.hpp"
#include "brinell/io/schema.hpp"
#include "brinell/io/versions.hpp"
#include "brinell/options.hpp"
#include "brinell/run_case.hpp"
#include "brinell/simulation/surface_fields.hpp"

#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/vector.h>

#include <cstdio>
#include <fmt/format.h>
#include <functional>
#include <map>

namespace nb = nanobind;
using namespace nb::literals;

namespace brinell::python
{

namespace
{

/// Runs without the interpreter's lock, but takes it to tell of a step and to hear of Ctrl-C.
/// @param compute  takes the monitor
/// @param on_replaced  called before the first step if an earlier result was removed; None: not called
std::string monitored(const nb::object& on_step, const nb::object& on_replaced,
                      const std::function<std::string(const app::RunMonitor&)>& compute)
{
  PythonCalls python;
  app::RunMonitor monitor;
  if (!on_step.is_none())
    monitor.on_step = [&](int step, int count, const std::string& where, int evaluations)
    { python.call([&] { on_step(step, count, where, evaluations); }); };
  if (!on_replaced.is_none())
    monitor.on_start = [&](bool replaced, int)
    {
      if (replaced)
        python.call([&] { on_replaced(); });
    };
  monitor.wants_stop = [&] { return python.wants_stop(); };
  std::string result;
  try
  {
    const nb::gil_scoped_release release;
    result = compute(monitor);
  }
  catch (const Interrupted&) // by what Python raised, here or in another process that computes with this one
  {
    python.rethrow();
    PyErr_SetNone(PyExc_KeyboardInterrupt);
    nb::raise_python_error();
  }
  python.rethrow();
  return result;
}

std::string run(const io::Case& c, const std::filesystem::path& folder, io::ResultDirectory::Mode mode, int threads,
                const nb::object& on_step, const nb::object& on_replaced, const nb::object& comm)
{
  const app::RunOptions options{folder, mode, threads, ranks_of(comm)};
  return monitored(on_step, on_replaced,
                   [&](const app::RunMonitor& monitor)
                   {
                     if (!options.ranks)
                       return app::run_case(c, io::plan_case(c), options, monitor).text;
                     app::require_shareable(c, options.ranks->size());
                     const io::ScenarioPlan plan = io::plan_case(c, app::memory_of_machines(*options.ranks));
                     return app::run_case(c, plan, options, monitor).text;
                   });
}

/// The bytes of a result file.
nb::bytes run_in_memory(const io::Case& c, int threads, const nb::object& on_step)
{
  const std::string image = monitored(
      on_step, nb::none(), [&](const app::RunMonitor& monitor) { return app::run_in_memory(c, threads, monitor); });
  return nb::bytes(image.data(), image.size());
}

/// Runs a command; the output of the C library is flushed before Python prints again.
int command_line(const std::vector<std::string>& arguments)
{
  int code = 0;
  {
    const nb::gil_scoped_release release;
    code = app::command_line(arguments);
    std::fflush(stdout);
  }
  return code;
}

/// For the completion of shells.
void bind_commands(nb::module_& m)
{
  nb::class_<app::OptionInfo>(m, "OptionInfo")
      .def_ro("flags", &app::OptionInfo::flags)
      .def_ro("value", &app::OptionInfo::value)
      .def_ro("help", &app::OptionInfo::help);
  nb::class_<app::CommandInfo>(m, "CommandInfo")
      .def_ro("name", &app::CommandInfo::name)
      .def_ro("help", &app::CommandInfo::help)
      .def_ro("options", &app::CommandInfo::options);
  nb::class_<io::Entry>(m, "SchemaKey")
      .def_ro("key", &io::Entry::key)
      .def_ro("choices", &io::Entry::choices)
      .def_prop_ro("kind", [](const io::Entry& e) { return io::type_names.at(static_cast<std::size_t>(e.of.type)); })
      .def_prop_ro("is_list",
                   [](const io::Entry& e) { return e.of.type == io::Type::numbers || e.of.type == io::Type::words; })
      .def_ro("per_axis", &io::Entry::per_axis)
      .def_prop_ro("unit", [](const io::Entry& e) { return io::unit_of(e.of); })
      .def_prop_ro("has_unit", [](const io::Entry& e)
                   { return e.of.notation != io::Notation::plain || !io::unit_of(e.of).empty(); })
      .def_prop_ro("range", [](const io::Entry& e) { return e.of.range.text(); })
      .def_ro("required", &io::Entry::required)
      .def_prop_ro("default", &io::default_text)
      .def_prop_ro("when", [](const io::Entry& e) { return std::pair(e.when.key, e.when.values); })
      .def_ro("excludes", &io::Entry::excludes)
      .def_ro("one_of", &io::Entry::one_of)
      .def_ro("pure_if", &io::Entry::pure_if)
      .def_ro("list", &io::Entry::list)
      .def_ro("text", &io::Entry::text);
  m.def("commands", &app::commands);
  m.def("schema_keys", &io::case_schema, nb::rv_policy::copy);
  m.def("command_line", &command_line, "arguments"_a);
}

/// The columns of the histories by scenario, and of the lists of the summary by their key.
void bind_columns(nb::module_& m)
{
  nb::class_<io::NamedNumber>(m, "Column")
      .def_ro("name", &io::NamedNumber::name)
      .def_ro("unit", &io::NamedNumber::unit)
      .def_ro("text", &io::NamedNumber::text)
      .def_prop_ro("is_integer", [](const io::NamedNumber& n) { return std::holds_alternative<int>(n.value); });
  m.def("columns", &io::all_columns);
  nb::class_<elastoplastic::EffectColumn>(m, "EffectColumn")
      .def_ro("effect", &elastoplastic::EffectColumn::effect)
      .def_prop_ro("name", [](const elastoplastic::EffectColumn& total) { return total.column.name; })
      .def_prop_ro("may_be_infinite",
                   [](const elastoplastic::EffectColumn& total) { return total.traits.may_be_infinite; });
  m.def("effect_columns",
        [] { return std::vector(elastoplastic::effect_columns.begin(), elastoplastic::effect_columns.end()); });
  using simulation::SurfaceField;
  nb::class_<SurfaceField>(m, "SurfaceField")
      .def_ro("name", &SurfaceField::name)
      .def_ro("unit", &SurfaceField::unit)
      .def_ro("text", &SurfaceField::text)
      .def_ro("needs", &SurfaceField::needs)
      .def_ro("elsewhere", &SurfaceField::elsewhere)
      .def_ro("lowers_surface", &SurfaceField::lowers_surface);
  m.def("contact_fields",
        []
        {
          const simulation::Snapshot none;
          const auto fields = simulation::surface_fields(none);
          return std::vector<SurfaceField>(fields.begin(), fields.end());
        });
  m.def("body_surface_fields",
        []
        {
          const simulation::BodySnapshot none;
          const auto fields = simulation::surface_fields(none);
          return std::vector<SurfaceField>(fields.begin(), fields.end());
        });
}

/// Height maps of Python, [y, x].
io::HeightTables height_tables(const std::map<std::string, Input>& maps)
{
  io::HeightTables tables;
  for (const auto& [name, map] : maps)
  {
    if (map.ndim() != 2)
      throw InputError(fmt::format("{} has {} axes; a height map has two, [y, x]", name, map.ndim()));
    tables[name] = {{map.data(), map.data() + map.size()}, map.shape(1)};
  }
  return tables;
}

/// For bench/forecast.py.
nb::dict workload(const io::Case& c)
{
  const simulation::Workload work = io::workload(c, io::plan_case(c));
  const auto text = [](std::string_view name) { return nb::str(name.data(), name.size()); };
  nb::dict factors, of_run, of_evaluation, result;
  for (const simulation::Factor& factor : work.factors)
    factors[text(factor.name)] = factor.value;
  for (const simulation::Amount& amount : work.amounts)
  {
    of_run[text(amount.name)] = amount.of_run;
    of_evaluation[text(amount.name)] = amount.of_evaluation;
  }
  result["steps"] = work.steps;
  result["factors"] = factors;
  result["of_run"] = of_run;
  result["of_evaluation"] = of_evaluation;
  result["certainty"] = static_cast<int>(work.certainty);
  return result;
}

/// Key and text of each.
std::vector<std::pair<std::string, std::string>> pairs(const std::vector<io::Warning>& warnings)
{
  std::vector<std::pair<std::string, std::string>> result;
  for (const io::Warning& warning : warnings)
    result.emplace_back(warning.key, io::printable(warning.text));
  return result;
}

} // namespace

void bind_app(nb::module_& m)
{
  nb::class_<io::Forecast>(m, "Forecast")
      .def_ro("seconds", &io::Forecast::seconds)
      .def_ro("shortest", &io::Forecast::shortest)
      .def_ro("longest", &io::Forecast::longest)
      .def_ro("evaluations", &io::Forecast::evaluations)
      .def_ro("memory", &io::Forecast::memory)
      .def_prop_ro("text", [](const io::Forecast& f) { return io::forecast_text(f); });
  bind_commands(m);
  bind_columns(m);
  nb::enum_<io::ResultDirectory::Mode>(m, "Mode")
      .value("replace", io::ResultDirectory::Mode::replace)
      .value("keep", io::ResultDirectory::Mode::keep)
      .value("resume", io::ResultDirectory::Mode::resume);
  nb::class_<io::Case>(m, "Case")
      .def_prop_ro("name", [](const io::Case& c) { return io::printable(c.name); })
      .def_ro("title", &io::Case::title)
      .def_prop_ro("warnings", [](const io::Case& c) { return pairs(c.warnings); })
      .def_prop_ro("expected_warnings",
                   [](const io::Case& c) { return pairs(io::expected_warnings(c, io::plan_case(c))); })
      .def_prop_ro("scenario", [](const io::Case& c) { return c.values.get<std::string>("scenario"); })
      .def_prop_ro("default_folder", [](const io::Case& c) { return app::default_folder(c); })
      .def("resolved_text", [](const io::Case& c) { return io::resolved_text(c.values); })
      .def(
          "write_resolved",
          [](const io::Case& c, const std::filesystem::path& file) { io::write_resolved(file, c.values); }, "file"_a)
      .def_prop_ro("result_bytes", [](const io::Case& c) { return io::result_bytes(c, io::plan_case(c)); })
      .def_prop_ro("result_warnings", [](const io::Case& c) { return pairs(io::result_warnings(c, io::plan_case(c))); })
      .def("citation_lines", [](const io::Case& c) { return io::citation_lines(c); })
      .def("check_report", [](const io::Case& c) { return io::printable(io::check_report(c, io::plan_case(c))); })
      .def("workload", &workload)
      .def_prop_ro("forecast", [](const io::Case& c) { return io::forecast(c, io::plan_case(c)); })
      .def("run", &run, "folder"_a, "mode"_a, "threads"_a, "on_step"_a.none(), "on_replaced"_a.none(),
           "comm"_a.none() = nb::none())
      .def("run_in_memory", &run_in_memory, "threads"_a, "on_step"_a.none());
  m.def(
      "parse_case",
      [](const std::string& text, const std::filesystem::path& file, const std::vector<std::string>& overrides,
         const std::map<std::string, Input>& maps, bool names_lines)
      {
        const auto places = names_lines ? io::Places::lines : io::Places::none;
        return io::parse_case(text, file, overrides, places, height_tables(maps));
      },
      "text"_a, "file"_a, "overrides"_a, "maps"_a, "names_lines"_a = true);
  m.def(
      "read_case",
      [](const std::filesystem::path& file, const std::vector<std::string>& overrides)
      { return io::read_case(file, overrides); },
      "file"_a, "overrides"_a);
  m.def("case_file_text", &io::case_file_text, "file"_a);
  m.def("machine_memory", &io::machine_memory);
  m.def("before_fork", &before_fork);
  m.attr("FORMAT_VERSION") = io::format_version;
  m.def("library_versions",
        []
        {
          const io::Versions v = io::library_versions();
          nb::dict result;
          result["brinell"] = v.brinell;
          result["git_hash"] = v.git_hash;
          result["hdf5"] = v.hdf5;
          result["processor"] = v.processor;
          return result;
        });
}

} // namespace brinell::python
