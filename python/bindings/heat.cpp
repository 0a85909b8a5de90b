// SPDX-License-Identifier: BSD-3-Clause
#include "arrays.hpp"
#include "grids.hpp"
#include "module.hpp"

#include "brinell/constitutive/material.hpp"
#include "brinell/halfspace/steady_field.hpp"
#include "brinell/halfspace/thermal_field.hpp"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <optional>
#include <tuple>
#include <vector>

using namespace nanobind::literals;

namespace brinell::python
{

namespace
{

using halfspace::HeatMotion;
using halfspace::HeatResponse;
using halfspace::SteadyField;
using halfspace::SurfaceTemperature;
using halfspace::ThermalField;
using halfspace::ThermalLayer;

/// Thickness, Young's modulus, Poisson's ratio and thermal constants of layers, from the surface down.
using HotLayers = std::vector<std::tuple<double, double, double, Thermal>>;

ThermalStack thermal_stack(const HotLayers& layers, const Thermal& substrate)
{
  ThermalStack stack{{}, substrate};
  for (const auto& [thickness, young_modulus, poisson_ratio, thermal] : layers)
    stack.layers.push_back({thickness, thermal});
  return stack;
}

ElasticStack elastic_stack(const HotLayers& layers, const Elastic& substrate)
{
  ElasticStack stack{{}, substrate};
  for (const auto& [thickness, young_modulus, poisson_ratio, thermal] : layers)
    stack.layers.push_back({thickness, {young_modulus, poisson_ratio}});
  return stack;
}

Output temperature(const HeatResponse& response, const Input& flux)
{
  const auto q = values(flux, shape(response.grid()), "flux");
  std::vector<double> rise(q.size());
  without_lock(
      [&]
      {
        HeatResponse::Scratch scratch = response.make_scratch();
        response.apply(q, rise, scratch);
      });
  return array(std::move(rise), shape(response.grid()));
}

Output remaining(const SurfaceTemperature& memory, double duration)
{
  std::vector<double> rise(memory.grid().size());
  without_lock([&] { memory.remaining(duration, rise); });
  return array(std::move(rise), shape(memory.grid()));
}

void add_step(SurfaceTemperature& memory, const Input& flux, const HeatMotion& motion)
{
  const auto q = values(flux, shape(memory.grid()), "flux");
  without_lock([&] { memory.add_step(q, motion); });
}

template <typename Field>
Shape layers_of(const Field& field)
{
  Shape layers = shape(field.grid());
  layers.insert(layers.begin(), field.depths().size());
  return layers;
}

Output thermal_displacement(const ThermalField& field, char axis, double later)
{
  std::vector<double> u(field.grid().size());
  const auto part = [&](char of) { return axis == of ? std::span<double>(u) : std::span<double>{}; };
  without_lock([&] { field.displacement({part('z'), part('x'), part('y')}, later); });
  return array(std::move(u), shape(field.grid()));
}

template <typename Field>
Output temperature_in_body(const Field& field, const auto& layer)
{
  const std::size_t cells = field.grid().size(), count = field.depths().size();
  std::vector<double> rise(count * cells);
  without_lock(
      [&]
      {
        for (std::size_t n = 0; n < count; ++n)
          layer(n, {.temperature = std::span(rise).subspan(n * cells, cells)});
      });
  return array(std::move(rise), layers_of(field));
}

template <typename Field>
Output stress(const Field& field, const auto& layer)
{
  const std::size_t cells = field.grid().size(), count = field.depths().size();
  std::vector<double> all(6 * count * cells);
  without_lock(
      [&]
      {
        std::vector<double> deviator(Deviator::size * cells), trace(cells);
        for (std::size_t n = 0; n < count; ++n)
        {
          layer(n, {.deviator = deviator, .trace = trace});
          const std::vector<double> six = six_fields(deviator, trace);
          for (std::size_t c = 0; c < 6; ++c)
            std::copy_n(six.begin() + static_cast<std::ptrdiff_t>(c * cells), cells,
                        all.begin() + static_cast<std::ptrdiff_t>((c * count + n) * cells));
        }
      });
  Shape six = layers_of(field);
  six.insert(six.begin(), 6);
  return array(std::move(all), six);
}

void bind_steady_field(nb::module_& m)
{
  const auto layer_of = [](const SteadyField& field, std::span<const double> flux) {
    return [&field, flux](std::size_t n, const ThermalLayer& to) { field.layers(flux, n, {&to, 1}); };
  };
  nb::class_<SteadyField>(m, "SteadyField")
      .def(
          "__init__",
          [](SteadyField* self, const SurfaceGrid& grid, const Thermal& thermal, const constitutive::Material& material,
             double velocity, std::optional<double> reference, std::vector<double> depths)
          {
            without_lock(
                [&] {
                  return new (self)
                      SteadyField(grid, thermal, material.elastic, {velocity, reference}, std::move(depths));
                });
          },
          "grid"_a, "thermal"_a, "material"_a, "velocity"_a, "reference"_a, "depths"_a)
      .def(
          "displacement",
          [](const SteadyField& field, const Input& flux)
          {
            const auto q = values(flux, shape(field.grid()), "flux");
            std::vector<double> u(field.grid().size());
            without_lock([&] { field.displacement(q, u); });
            return array(std::move(u), shape(field.grid()));
          },
          "flux"_a)
      .def(
          "temperature",
          [=](const SteadyField& field, const Input& flux)
          { return temperature_in_body(field, layer_of(field, values(flux, shape(field.grid()), "flux"))); },
          "flux"_a)
      .def(
          "stress",
          [=](const SteadyField& field, const Input& flux)
          { return stress(field, layer_of(field, values(flux, shape(field.grid()), "flux"))); },
          "flux"_a);
}

} // namespace

void bind_heat(nb::module_& m)
{
  nb::class_<Thermal>(m, "Thermal")
      .def(
          "__init__",
          [](Thermal* self, double conductivity, double density, double specific_heat, double expansion) {
            new (self) Thermal{conductivity, density, specific_heat, expansion};
          },
          "conductivity"_a, "density"_a, "specific_heat"_a, "expansion"_a)
      .def_prop_ro("diffusivity", &Thermal::diffusivity);
  nb::class_<HeatMotion>(m, "HeatMotion")
      .def(
          "__init__",
          [](HeatMotion* self, double duration, double velocity_x, double velocity_y) {
            new (self) HeatMotion{duration, velocity_x, velocity_y};
          },
          "duration"_a, "velocity_x"_a, "velocity_y"_a);
  nb::class_<HeatResponse>(m, "HeatResponse")
      .def(
          "__init__",
          [](HeatResponse* self, const SurfaceGrid& grid, const Thermal& thermal, const HeatMotion& motion,
             const HotLayers& layers)
          { without_lock([&] { return new (self) HeatResponse(grid, thermal_stack(layers, thermal), motion); }); },
          "grid"_a, "thermal"_a, "motion"_a, "layers"_a = HotLayers())
      .def("temperature", &temperature, "flux"_a);
  nb::class_<SurfaceTemperature>(m, "SurfaceTemperature")
      .def(
          "__init__",
          [](SurfaceTemperature* self, const SurfaceGrid& grid, const Thermal& thermal, double shortest_step,
             double duration) {
            without_lock([&] { return new (self) SurfaceTemperature(grid, thermal, {shortest_step, duration}); });
          },
          "grid"_a, "thermal"_a, "shortest_step"_a, "duration"_a)
      .def_prop_ro("time", &SurfaceTemperature::time)
      .def("remaining", &remaining, "duration"_a)
      .def("add_step", &add_step, "flux"_a, "motion"_a);
  nb::class_<ThermalField>(m, "ThermalField")
      .def(
          "__init__",
          [](ThermalField* self, const SurfaceGrid& grid, const Thermal& thermal,
             const constitutive::Material& material, double shortest_step, double duration, std::vector<double> depths,
             const HotLayers& layers)
          {
            without_lock(
                [&]
                {
                  return new (self)
                      ThermalField(grid, thermal_stack(layers, thermal), elastic_stack(layers, material.elastic),
                                   {shortest_step, duration}, std::move(depths));
                });
          },
          "grid"_a, "thermal"_a, "material"_a, "shortest_step"_a, "duration"_a, "depths"_a, "layers"_a = HotLayers())
      .def_prop_ro("time", &ThermalField::time)
      .def(
          "add_step",
          [](ThermalField& field, const Input& flux, const HeatMotion& motion)
          {
            const auto q = values(flux, shape(field.grid()), "flux");
            without_lock([&] { field.add_step(q, motion); });
          },
          "flux"_a, "motion"_a)
      .def("displacement", &thermal_displacement, "axis"_a, "later"_a)
      .def(
          "temperature",
          [](const ThermalField& field, double later) {
            return temperature_in_body(field,
                                       [&](std::size_t n, const ThermalLayer& to) { field.layer(n, to, later); });
          },
          "later"_a)
      .def(
          "stress",
          [](const ThermalField& field, double later)
          { return stress(field, [&](std::size_t n, const ThermalLayer& to) { field.layer(n, to, later); }); },
          "later"_a);
  bind_steady_field(m);
}

} // namespace brinell::python
