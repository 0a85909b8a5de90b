// SPDX-License-Identifier: BSD-3-Clause
#include "arrays.hpp"
#include "grids.hpp"
#include "module.hpp"
#include "python_calls.hpp"

#include "brinell/contact/contact_area.hpp"
#include "brinell/contact/contact_stiffness.hpp"
#include "brinell/contact/elastic_contact.hpp"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

using namespace nanobind::literals;

namespace brinell::python
{

namespace
{

using halfspace::SurfaceCompliance;
using Kind = contact::Drive::Kind;

contact::Drive drive(Kind kind, const char* name, double value)
{
  if (!std::isfinite(value) || (kind != Kind::approach && value < 0.0))
    throw InputError(fmt::format("{} = {:g}; allowed: finite{}", name, value,
                                 kind == Kind::load       ? ", not below 0: there is no adhesion"
                                 : kind == Kind::mean_gap ? ", not below 0"
                                                          : ""));
  return {kind, value};
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
  PythonCalls python;
  contact::Report report;
  try
  {
    report = without_lock(
        [&]
        {
          contact::ElasticContact solver(compliance);
          return solver.solve(d, drive, tolerance, max_iterations, pressure, gap, [&] { return python.wants_stop(); });
        });
  }
  catch (const Interrupted&) // by what Python raised
  {
  }
  python.rethrow();
  return std::tuple{array(std::move(pressure), on_grid), array(std::move(gap), on_grid), report};
}

double area(const SurfaceGrid& grid, const Input& pressure, const Input& gap, double contact_modulus)
{
  const Shape on_grid = shape(grid);
  return contact::contact_area(grid, values(pressure, on_grid, "pressure"), values(gap, on_grid, "gap"),
                               contact_modulus);
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
  m.def("contact_stiffness", &stiffness, "compliance"_a, "pressure"_a);
  m.def("contact_area", &area, "grid"_a, "pressure"_a, "gap"_a, "contact_modulus"_a);
}

} // namespace brinell::python
