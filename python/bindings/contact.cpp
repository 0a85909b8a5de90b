// SPDX-License-Identifier: BSD-3-Clause
#include "arrays.hpp"
#include "grids.hpp"
#include "module.hpp"
#include "python_calls.hpp"

#include "brinell/contact/contact_area.hpp"
#include "brinell/contact/contact_stiffness.hpp"
#include "brinell/contact/elastic_contact.hpp"
#include "brinell/contact/frictional_contact.hpp"

#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <tuple>

using namespace nanobind::literals;

namespace brinell::python
{

namespace
{

using halfspace::SurfaceCompliance;
using Kind = contact::Drive::Kind;
using Along = std::array<std::vector<double>, 2>; ///< fields along x and y
using AlongInput = std::array<Input, 2>;

contact::Drive drive(Kind kind, const char* name, double value)
{
  if (!std::isfinite(value) || (kind != Kind::approach && value < 0.0))
    throw InputError(fmt::format("{} = {:g}; allowed: finite{}", name, value,
                                 kind == Kind::load       ? ", not below 0: there is no adhesion"
                                 : kind == Kind::mean_gap ? ", not below 0"
                                                          : ""));
  return {kind, value};
}

/// Runs a computation that asks Python now and then whether to stop.
template <typename Computation>
void watched(const Computation& computation)
{
  PythonCalls python;
  try
  {
    without_lock([&] { computation([&] { return python.wants_stop(); }); });
  }
  catch (const Interrupted&) // by what Python raised
  {
  }
  python.rethrow();
}

/// The solver's buffers belong to this call: a compliance serves several threads.
auto solve_contact(const SurfaceCompliance& compliance, const Input& distance, const contact::Drive& drive,
                   double tolerance, int max_iterations, const std::optional<Input>& guess)
{
  const Shape on_grid = shape(compliance.grid());
  const auto d = values(distance, on_grid, "distance");
  std::vector<double> pressure(d.size(), 0.0);
  if (guess)
    std::ranges::copy(values(*guess, on_grid, "guess"), pressure.begin());
  std::vector<double> gap(d.size());
  contact::Report report;
  watched(
      [&](const std::function<bool()>& wants_stop)
      {
        contact::ElasticContact solver(compliance);
        report = solver.solve(d, drive, tolerance, max_iterations, pressure, gap, wants_stop);
      });
  return std::tuple{array(std::move(pressure), on_grid), array(std::move(gap), on_grid), report};
}

contact::TangentialDrive tangential_drive(bool is_force_x, double value_x, bool is_force_y, double value_y, double spin)
{
  const auto axis = [](bool is_force, double value)
  {
    using Way = contact::TangentialDrive::Kind;
    return contact::TangentialDrive::Axis{is_force ? Way::force : Way::shift, value};
  };
  return {axis(is_force_x, value_x), axis(is_force_y, value_y), spin};
}

Along copied(const AlongInput& given, const Shape& on_grid, const char* name_x, const char* name_y)
{
  const auto x = values(given[0], on_grid, name_x);
  const auto y = values(given[1], on_grid, name_y);
  return {std::vector(x.begin(), x.end()), std::vector(y.begin(), y.end())};
}

/// Shears along x and y, slips along x and y, report.
auto solve_tangential(const SurfaceCompliance& compliance, const Input& bound, const contact::TangentialDrive& drive,
                      const std::optional<AlongInput>& before, const std::optional<AlongInput>& change,
                      const std::array<int, 2>& carried, double tolerance, int max_iterations)
{
  const Shape on_grid = shape(compliance.grid());
  const std::size_t cells = compliance.grid().size();
  contact::TangentialStep step{values(bound, on_grid, "bound"), {}, {}, drive, carried};
  Along shear{std::vector<double>(cells), std::vector<double>(cells)};
  Along slip = shear;
  Along last;
  Along changed;
  if (before)
  {
    last = copied(*before, on_grid, "shear_x before", "shear_y before");
    shear = last;
    step.before = {last[0], last[1]};
  }
  if (change)
  {
    changed = copied(*change, on_grid, "change_x", "change_y");
    step.change = {changed[0], changed[1]};
  }
  contact::TangentialReport report;
  watched(
      [&](const std::function<bool()>& wants_stop)
      {
        contact::TangentialContact solver(compliance);
        report = solver.solve(step, tolerance, max_iterations, {shear[0], shear[1]}, {slip[0], slip[1]}, wants_stop);
      });
  return std::tuple{array(std::move(shear[0]), on_grid), array(std::move(shear[1]), on_grid),
                    array(std::move(slip[0]), on_grid), array(std::move(slip[1]), on_grid), report};
}

/// Pressure, gap, shears, slips, report.
auto solve_friction(const SurfaceCompliance& compliance, const Input& distance, const contact::Drive& drive,
                    const contact::TangentialDrive& tangential, double friction, double gap_tolerance,
                    double slip_tolerance, int max_iterations, const std::optional<std::array<Input, 3>>& before,
                    const std::array<int, 2>& carried)
{
  const Shape on_grid = shape(compliance.grid());
  const std::size_t cells = compliance.grid().size();
  const auto d = values(distance, on_grid, "distance");
  contact::FrictionState state(cells);
  if (before)
  {
    std::ranges::copy(values((*before)[0], on_grid, "pressure before"), state.pressure.begin());
    std::ranges::copy(values((*before)[1], on_grid, "shear_x before"), state.shear_x.begin());
    std::ranges::copy(values((*before)[2], on_grid, "shear_y before"), state.shear_y.begin());
  }
  std::vector<double> gap(cells);
  Along slip{std::vector<double>(cells), std::vector<double>(cells)};
  contact::FrictionTolerances tolerances;
  tolerances.gap = gap_tolerance;
  tolerances.slip = slip_tolerance;
  tolerances.max_iterations = max_iterations;
  contact::FrictionReport report;
  watched(
      [&](const std::function<bool()>& wants_stop)
      {
        contact::FrictionalContact solver(compliance);
        report = solver.step(d, drive, tangential, friction, tolerances, state, gap, {slip[0], slip[1]}, wants_stop,
                             carried);
      });
  return std::tuple{array(std::move(state.pressure), on_grid),
                    array(std::move(gap), on_grid),
                    array(std::move(state.shear_x), on_grid),
                    array(std::move(state.shear_y), on_grid),
                    array(std::move(slip[0]), on_grid),
                    array(std::move(slip[1]), on_grid),
                    report};
}

double area(const SurfaceGrid& grid, const Input& pressure, const Input& gap, double contact_modulus)
{
  const Shape on_grid = shape(grid);
  return contact::contact_area(grid, values(pressure, on_grid, "pressure"), values(gap, on_grid, "gap"),
                               contact_modulus);
}

/// Labels of the cells, and the area of each patch.
auto patches(const SurfaceGrid& grid, const Input& pressure, const Input& gap, double contact_modulus)
{
  const Shape on_grid = shape(grid);
  contact::Patches found =
      contact::patches(grid, values(pressure, on_grid, "pressure"), values(gap, on_grid, "gap"), contact_modulus);
  const Shape count{found.area.size()};
  return std::tuple{array(std::vector<double>(found.label.begin(), found.label.end()), on_grid),
                    array(std::move(found.area), count)};
}

double stiffness(const SurfaceCompliance& compliance, const Input& pressure)
{
  const auto p = values(pressure, shape(compliance.grid()), "pressure");
  return without_lock([&] { return contact::stiffness(compliance, p); });
}

} // namespace

void bind_contact(nb::module_& m)
{
  nb::class_<contact::Drive>(m, "Drive")
      .def_static(
          "of_load", [](double load) { return drive(Kind::load, "load", load); }, "load"_a)
      .def_static(
          "of_approach", [](double approach) { return drive(Kind::approach, "approach", approach); }, "approach"_a)
      .def_static(
          "of_mean_gap", [](double gap) { return drive(Kind::mean_gap, "mean_gap", gap); }, "mean_gap"_a);
  nb::class_<contact::Report>(m, "ContactReport")
      .def_ro("converged", &contact::Report::converged)
      .def_ro("iterations", &contact::Report::iterations)
      .def_ro("approach", &contact::Report::approach)
      .def_ro("gap_error", &contact::Report::gap_error)
      .def_ro("penetration", &contact::Report::penetration);
  m.def("solve_contact", &solve_contact, "compliance"_a, "distance"_a, "drive"_a, "tolerance"_a, "max_iterations"_a,
        "guess"_a.none());
  nb::class_<contact::TangentialDrive>(m, "TangentialDrive")
      .def_static("of", &tangential_drive, "is_force_x"_a, "value_x"_a, "is_force_y"_a, "value_y"_a, "spin"_a);
  nb::class_<contact::TangentialReport>(m, "TangentialReport")
      .def_ro("converged", &contact::TangentialReport::converged)
      .def_ro("iterations", &contact::TangentialReport::iterations)
      .def_ro("shift", &contact::TangentialReport::shift)
      .def_ro("force", &contact::TangentialReport::force)
      .def_ro("slip_error", &contact::TangentialReport::slip_error)
      .def_ro("dissipated", &contact::TangentialReport::dissipated);
  nb::class_<contact::FrictionReport>(m, "FrictionReport")
      .def_ro("converged", &contact::FrictionReport::converged)
      .def_ro("alternations", &contact::FrictionReport::alternations)
      .def_ro("normal", &contact::FrictionReport::normal)
      .def_ro("tangential", &contact::FrictionReport::tangential)
      .def_ro("gap_change", &contact::FrictionReport::gap_change);
  m.attr("slip_threshold") = contact::slip_threshold;
  m.def("solve_tangential", &solve_tangential, "compliance"_a, "bound"_a, "drive"_a, "before"_a.none(),
        "change"_a.none(), "carried"_a, "tolerance"_a, "max_iterations"_a);
  m.def("solve_friction", &solve_friction, "compliance"_a, "distance"_a, "drive"_a, "tangential"_a, "friction"_a,
        "gap_tolerance"_a, "slip_tolerance"_a, "max_iterations"_a, "before"_a.none(), "carried"_a);
  m.def("contact_stiffness", &stiffness, "compliance"_a, "pressure"_a);
  m.def("contact_area", &area, "grid"_a, "pressure"_a, "gap"_a, "contact_modulus"_a);
  m.def("patches", &patches, "grid"_a, "pressure"_a, "gap"_a, "contact_modulus"_a);
}

} // namespace brinell::python
