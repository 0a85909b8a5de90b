// SPDX-License-Identifier: BSD-3-Clause
#include "arrays.hpp"
#include "layers.hpp"
#include "module.hpp"

#include "brinell/reference/coated_contact.hpp"
#include "brinell/reference/critical.hpp"
#include "brinell/reference/elastic_tugging.hpp"
#include "brinell/reference/hertz.hpp"
#include "brinell/reference/sliding_contact.hpp"
#include "brinell/reference/spherical_indentation.hpp"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <optional>
#include <tuple>
#include <utility>

using namespace nanobind::literals;

namespace brinell::python
{

namespace
{

namespace ref = brinell::reference;

auto as_tuple(const ref::PointContact& c)
{
  return std::tuple{c.load, c.approach, c.contact_radius, c.peak_pressure};
}

auto as_tuple(const ref::EllipticalContact& c)
{
  return std::tuple{c.load, c.approach, c.semi_axis_x, c.semi_axis_y, c.peak_pressure};
}

auto as_tuple(const ref::CriticalValues& c)
{
  return std::tuple{c.C, c.interference, c.load, c.energy, c.contact_radius, c.contact_area, c.peak_pressure};
}

/// With its approach.
auto as_tuple(const ref::LineContact& c, double contact_modulus, double reference)
{
  return std::tuple{c.load_per_length, c.half_width, c.peak_pressure,
                    ref::line_contact_approach(c, contact_modulus, reference)};
}

/// Of the pressure, and of the shear friction x pressure along x.
Output point_contact_stress(const Input& x, const Input& y, const Input& z, double contact_radius, double peak_pressure,
                            double poisson_ratio, double friction)
{
  const std::size_t n = x.size();
  const auto xs = values(x, {n}, "x");
  const auto ys = values(y, {n}, "y");
  const auto zs = values(z, {n}, "z");
  std::vector<double> stress(6 * n);
  without_lock(
      [&]
      {
        for (std::size_t i = 0; i < n; ++i)
          store(ref::sliding_point_contact_stress(xs[i], ys[i], zs[i], contact_radius, peak_pressure, poisson_ratio,
                                                  friction),
                stress, n, i);
      });
  return array(std::move(stress), {6, n});
}

Output line_contact_stress(const Input& x, const Input& z, double half_width, double peak_pressure,
                           double poisson_ratio, double friction)
{
  const std::size_t n = x.size();
  const auto xs = values(x, {n}, "x");
  const auto zs = values(z, {n}, "z");
  std::vector<double> stress(6 * n);
  without_lock(
      [&]
      {
        for (std::size_t i = 0; i < n; ++i)
          store(ref::sliding_line_contact_stress(xs[i], zs[i], half_width, peak_pressure, poisson_ratio, friction),
                stress, n, i);
      });
  return array(std::move(stress), {6, n});
}

/// Rows: load, F_X, F_Z, interference.
Output elastic_tugging_forces(const ref::ElasticTugging& tugging, const Input& X)
{
  const std::size_t n = X.size();
  const auto Xs = values(X, {n}, "X");
  ref::require_valid(tugging);
  std::vector<double> rows(4 * n);
  without_lock(
      [&]
      {
        for (std::size_t i = 0; i < n; ++i)
        {
          const ref::TuggingForces f = ref::elastic_tugging_forces(tugging, Xs[i]);
          rows[i] = f.load;
          rows[n + i] = f.F_X;
          rows[2 * n + i] = f.F_Z;
          rows[3 * n + i] = f.interference;
        }
      });
  return array(std::move(rows), {4, n});
}

/// A function of the ratio of the approach to that at first yield, over an array.
template <typename Function>
Output over(const Input& interference_ratio, const Function& function)
{
  const std::size_t n = interference_ratio.size();
  const auto ratio = values(interference_ratio, {n}, "interference_ratio");
  std::vector<double> result(n);
  for (std::size_t i = 0; i < n; ++i)
    result[i] = function(ratio[i]);
  return array(std::move(result), {n});
}

void bind_tugging(nb::module_& m)
{
  nb::class_<ref::ElasticTugging>(m, "ElasticTugging")
      .def(
          "__init__",
          [](ref::ElasticTugging* self, double radius_lower, double radius_upper, double contact_modulus,
             double interference, std::optional<std::pair<double, double>> line)
          {
            ref::ElasticTugging tugging{radius_lower, radius_upper, contact_modulus, interference, {}};
            if (line)
              tugging.line = {line->first, line->second};
            ref::require_valid(tugging);
            new (self) ref::ElasticTugging(tugging);
          },
          "radius_lower"_a, "radius_upper"_a, "contact_modulus"_a, "interference"_a, "line"_a.none())
      .def("half_sliding_distance", &ref::half_sliding_distance)
      .def("forces", &elastic_tugging_forces, "X"_a)
      .def("peak",
           [](const ref::ElasticTugging& t)
           {
             const ref::TuggingPeak peak = ref::elastic_tugging_peak(t);
             return std::tuple{peak.F_X, peak.X};
           })
      .def("work", &ref::elastic_tugging_work, "X1"_a, "X2"_a);
}

/// Elastic contact: size, pressure, stress.
void bind_hertz(nb::module_& m)
{
  m.def(
      "point_contact_at_load",
      [](double radius, double contact_modulus, double load)
      { return as_tuple(ref::point_contact_at_load(radius, contact_modulus, load)); },
      "radius"_a, "contact_modulus"_a, "load"_a);
  m.def(
      "point_contact_at_approach",
      [](double radius, double contact_modulus, double approach)
      { return as_tuple(ref::point_contact_at_approach(radius, contact_modulus, approach)); },
      "radius"_a, "contact_modulus"_a, "approach"_a);
  m.def(
      "elliptical_contact_at_load",
      [](double radius_x, double radius_y, double contact_modulus, double load)
      { return as_tuple(ref::elliptical_contact_at_load(radius_x, radius_y, contact_modulus, load)); },
      "radius_x"_a, "radius_y"_a, "contact_modulus"_a, "load"_a);
  m.def(
      "elliptical_contact_at_approach",
      [](double radius_x, double radius_y, double contact_modulus, double approach)
      { return as_tuple(ref::elliptical_contact_at_approach(radius_x, radius_y, contact_modulus, approach)); },
      "radius_x"_a, "radius_y"_a, "contact_modulus"_a, "approach"_a);
  m.def(
      "line_contact_at_load",
      [](double radius, double contact_modulus, double load_per_length, double reference) {
        return as_tuple(ref::line_contact_at_load(radius, contact_modulus, load_per_length), contact_modulus,
                        reference);
      },
      "radius"_a, "contact_modulus"_a, "load_per_length"_a, "reference"_a);
  m.def(
      "line_contact_at_approach",
      [](double radius, double contact_modulus, double approach, double reference)
      {
        return as_tuple(ref::line_contact_at_approach(radius, contact_modulus, approach, reference), contact_modulus,
                        reference);
      },
      "radius"_a, "contact_modulus"_a, "approach"_a, "reference"_a);
  m.def("point_contact_stress", &point_contact_stress, "x"_a, "y"_a, "z"_a, "contact_radius"_a, "peak_pressure"_a,
        "poisson_ratio"_a, "friction"_a);
  m.def("line_contact_stress", &line_contact_stress, "x"_a, "z"_a, "half_width"_a, "peak_pressure"_a, "poisson_ratio"_a,
        "friction"_a);
}

/// The contact of which `given` is a certain value.
ref::CoatedContact coated_contact(double radius, const std::string& given, double value, const ElasticStack& lower,
                                  const ElasticStack& upper)
{
  if (given == "load")
    return ref::CoatedContact::at_load(radius, value, lower, upper);
  if (given == "approach")
    return ref::CoatedContact::at_approach(radius, value, lower, upper);
  return {radius, value, lower, upper};
}

void bind_coated(nb::module_& m)
{
  nb::class_<ref::CoatedContact>(m, "CoatedContact")
      .def(
          "__init__",
          [](ref::CoatedContact* self, double radius, const std::string& given, double value,
             const constitutive::Material& lower, const constitutive::Material& upper, const Layers& lower_layers,
             const Layers& upper_layers)
          {
            new (self) ref::CoatedContact(
                coated_contact(radius, given, value, stack_of(lower_layers, lower), stack_of(upper_layers, upper)));
          },
          "radius"_a, "given"_a, "value"_a, "lower"_a, "upper"_a, "lower_layers"_a, "upper_layers"_a)
      .def_prop_ro("load", &ref::CoatedContact::load)
      .def_prop_ro("approach", &ref::CoatedContact::approach)
      .def_prop_ro("contact_radius", &ref::CoatedContact::contact_radius)
      .def_prop_ro("stiffness", &ref::CoatedContact::stiffness)
      .def(
          "pressure",
          [](const ref::CoatedContact& contact, const Input& r)
          {
            const std::size_t n = r.size();
            const auto rs = values(r, {n}, "r");
            std::vector<double> pressure(n);
            without_lock(
                [&]
                {
                  for (std::size_t i = 0; i < n; ++i)
                    pressure[i] = contact.pressure(rs[i]);
                });
            return array(std::move(pressure), {n});
          },
          "r"_a);
}

/// First yield, and what happens there.
void bind_first_yield(nb::module_& m)
{
  const auto as_tuple_of_yield = [](const ref::SlidingYield& y) {
    return std::tuple{y.pressure_ratio, y.depth_ratio, y.x_ratio};
  };
  m.def(
      "first_yield",
      [=](double poisson_ratio, double friction)
      { return as_tuple_of_yield(ref::sliding_first_yield(poisson_ratio, friction)); },
      "poisson_ratio"_a, "friction"_a);
  m.def(
      "line_contact_first_yield",
      [=](double poisson_ratio, double friction)
      { return as_tuple_of_yield(ref::line_sliding_first_yield(poisson_ratio, friction)); },
      "poisson_ratio"_a, "friction"_a);
  m.def("critical_pressure_ratio", &ref::critical_pressure_ratio, "poisson_ratio"_a);
  m.def(
      "critical_values",
      [](double radius, double contact_modulus, double C, double yield_stress)
      { return as_tuple(ref::critical_values(radius, contact_modulus, C, yield_stress)); },
      "radius"_a, "contact_modulus"_a, "C"_a, "yield_stress"_a);
  m.def(
      "critical_line_values",
      [](double radius, double contact_modulus, double C, double yield_stress, double length, double reference) {
        return as_tuple(ref::critical_values(radius, contact_modulus, C, yield_stress, {length, reference}));
      },
      "radius"_a, "contact_modulus"_a, "C"_a, "yield_stress"_a, "length"_a, "reference"_a);
}

void bind_indented_sphere(nb::module_& m)
{
  m.def("jackson_green_pressure_ratio", &ref::jackson_green_pressure_ratio, "poisson_ratio"_a);
  m.def(
      "jackson_green_area",
      [](const Input& interference_ratio, double young_modulus, double poisson_ratio, double yield_stress)
      {
        const ref::IndentedSphere sphere{{young_modulus, poisson_ratio}, yield_stress};
        return over(interference_ratio, [&](double ratio) { return ref::jackson_green_area(ratio, sphere); });
      },
      "interference_ratio"_a, "young_modulus"_a, "poisson_ratio"_a, "yield_stress"_a);
  m.def(
      "jackson_green_load",
      [](const Input& interference_ratio, double young_modulus, double poisson_ratio, double yield_stress)
      {
        const ref::IndentedSphere sphere{{young_modulus, poisson_ratio}, yield_stress};
        return over(interference_ratio, [&](double ratio) { return ref::jackson_green_load(ratio, sphere); });
      },
      "interference_ratio"_a, "young_modulus"_a, "poisson_ratio"_a, "yield_stress"_a);
  m.def(
      "kogut_etsion_load",
      [](const Input& interference_ratio)
      { return over(interference_ratio, [](double ratio) { return ref::kogut_etsion_load(ratio); }); },
      "interference_ratio"_a);
}

} // namespace

void bind_reference(nb::module_& m)
{
  bind_hertz(m);
  bind_coated(m);
  bind_first_yield(m);
  bind_indented_sphere(m);
  bind_tugging(m);
}

} // namespace brinell::python
