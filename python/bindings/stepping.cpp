// SPDX-License-Identifier: BSD-3-Clause
#include "arrays.hpp"
#include "module.hpp"
#include "python_calls.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/io/case_file.hpp"
#include "brinell/io/feasibility.hpp"
#include "brinell/io/history_csv.hpp"
#include "brinell/io/summary_json.hpp"
#include "brinell/quality/quality.hpp"
#include "brinell/simulation/run.hpp"
#include "brinell/simulation/surface_fields.hpp"

#include <nanobind/stl/string.h>

#include <memory>
#include <omp.h>

namespace nb = nanobind;
using namespace nb::literals;

namespace brinell::python
{

namespace
{

template <typename... ScenarioCase>
using RunsOf = std::variant<simulation::Run<ScenarioCase>...>;
using AnyRun = simulation::Scenarios<RunsOf>;

/// Number of threads of what the calling thread computes, for as long as this lives; 0: as OpenMP decides.
class ThreadsHere
{
public:
  explicit ThreadsHere(int count) : before_(omp_get_max_threads())
  {
    if (count > 0)
      omp_set_num_threads(count);
  }
  ~ThreadsHere() { omp_set_num_threads(before_); }
  ThreadsHere(const ThreadsHere&) = delete;
  ThreadsHere& operator=(const ThreadsHere&) = delete;

private:
  int before_;
};

/// Result of a function that is called without the interpreter's lock.
/// @param threads  number of threads; 0: as OpenMP decides
template <typename Function>
auto computed(int threads, const Function& function)
{
  return without_lock(
      [&]
      {
        const ThreadsHere here(threads);
        return function();
      });
}

/// A run that Python steps. Nothing is written. Several runs may be stepped at once, each by a thread of its own.
class Stepping
{
public:
  Stepping(io::Case c, int threads)
      : case_(std::move(c)), threads_(threads), run_(computed(threads_, [&] { return start(case_, calls_); }))
  {
  }
  Stepping(const Stepping&) = delete; // the run calls `calls_`
  Stepping& operator=(const Stepping&) = delete;

  [[nodiscard]] bool is_done() const
  {
    return std::visit([](const auto& run) { return run.is_done(); }, run_);
  }
  [[nodiscard]] int step_count() const
  {
    return std::visit([](const auto& run) { return run.step_count(); }, run_);
  }

  /// @returns the row of the history by the names of its columns.
  nb::dict step()
  {
    std::vector<io::NamedNumber> row;
    try
    {
      row = computed(threads_, [&] { return std::visit([](auto& run) { return io::columns(run.step()); }, run_); });
    }
    catch (const Interrupted&) // by what Python raised
    {
    }
    calls_.rethrow();
    nb::dict result;
    for (const io::NamedNumber& number : row)
      std::visit([&](auto value) { result[nb::str(number.name.data(), number.name.size())] = value; }, number.value);
    return result;
  }

  [[nodiscard]] nb::dict fields() const
  {
    simulation::Snapshot s =
        computed(threads_, [&] { return std::visit([](const auto& run) { return run.snapshot(); }, run_); });
    const Shape shape{static_cast<std::size_t>(s.contact.ny), static_cast<std::size_t>(s.contact.nx)};
    nb::dict result;
    result["x"] = line(s.x0, s.contact.dx, s.contact.nx);
    result["y"] = line(s.y0, s.contact.dy, s.contact.ny);
    for (const auto& field : simulation::surface_fields(s))
      if (!field.values->empty())
        result[field.name] = array(std::move(*field.values), shape);
    result["lower"] = body(std::move(s.lower));
    result["upper"] = body(std::move(s.upper));
    return result;
  }

  [[nodiscard]] std::string summary_text() const
  {
    return computed(threads_, [&] { return std::visit([&](const auto& run) { return text_of(run); }, run_); });
  }

private:
  static AnyRun start(const io::Case& c, PythonCalls& calls)
  {
    static_cast<void>(io::plan_case(c)); // refuses what does not fit this machine
    return std::visit(
        [&](const auto& scenario) -> AnyRun
        {
          using Scenario = std::decay_t<decltype(scenario)>;
          return simulation::Run<Scenario>(scenario,
                                           {{}, io::machine_memory(), [&calls] { return calls.wants_stop(); }});
        },
        c.scenario);
  }

  template <typename ScenarioCase>
  [[nodiscard]] std::string text_of(const simulation::Run<ScenarioCase>& run) const
  {
    const auto& scenario = std::get<ScenarioCase>(case_.scenario);
    const auto plan = simulation::plan(scenario);
    const auto summary = run.totals();
    io::RunInfo info{
        .wall_time = 0.0, .threads = omp_get_max_threads(), .quality = quality::judged(scenario, plan, summary)};
    info.quality.warnings.insert(info.quality.warnings.begin(), case_.warnings.begin(), case_.warnings.end());
    return io::summary_text(case_, plan, summary, info);
  }

  static Output line(double first, double step, int count)
  {
    std::vector<double> places;
    for (int i = 0; i < count; ++i)
      places.push_back(first + i * step);
    return array(std::move(places), {static_cast<std::size_t>(count)});
  }

  static nb::dict body(simulation::BodySnapshot&& b)
  {
    const auto nx = static_cast<std::size_t>(b.grid.surface.nx);
    const auto ny = static_cast<std::size_t>(b.grid.surface.ny);
    const auto nz = static_cast<std::size_t>(b.grid.nz);
    nb::dict result;
    result["x"] = line(b.x0, b.grid.surface.dx, b.grid.surface.nx);
    result["y"] = line(b.y0, b.grid.surface.dy, b.grid.surface.ny);
    result["z"] = line(0.5 * b.grid.dz, b.grid.dz, b.grid.nz);
    result["contact_x"] = b.contact_x;
    const auto add = [&result](const char* name, std::vector<double>&& values, const Shape& shape)
    {
      if (!values.empty()) // a rigid body has none
        result[name] = array(std::move(values), shape);
    };
    for (const auto& field : simulation::surface_fields(b))
      add(field.name, std::move(*field.values), {ny, nx});
    add("equivalent_plastic_strain", std::move(b.equivalent_plastic_strain), {nz, ny, nx});
    add("inclusion", std::move(b.inclusion), {nz, ny, nx});
    add("plastic_strain", joined(b.plastic_strain), {6, nz, ny, nx});
    add("stress", joined(b.stress), {6, nz, ny, nx});
    return result;
  }

  static std::vector<double> joined(const std::array<std::vector<double>, 6>& components)
  {
    std::vector<double> all;
    for (const std::vector<double>& c : components)
      all.insert(all.end(), c.begin(), c.end());
    return all;
  }

  io::Case case_;
  int threads_;
  PythonCalls calls_;
  AnyRun run_;
};

} // namespace

void bind_stepping(nb::module_& m)
{
  nb::class_<Stepping>(m, "Stepping")
      .def(nb::init<io::Case, int>(), "case"_a, "threads"_a = 0)
      .def_prop_ro("is_done", &Stepping::is_done)
      .def_prop_ro("step_count", &Stepping::step_count)
      .def("step", &Stepping::step)
      .def("fields", &Stepping::fields)
      .def("summary_text", &Stepping::summary_text);
}

} // namespace brinell::python
