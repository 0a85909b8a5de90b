// SPDX-License-Identifier: BSD-3-Clause
#include "arrays.hpp"
#include "grids.hpp"
#include "module.hpp"

#include "brinell/constitutive/material.hpp"
#include "brinell/halfspace/thermal_field.hpp"

#include <nanobind/stl/vector.h>

using namespace nanobind::literals;

namespace brinell::python
{

namespace
{

using halfspace::HeatMotion;
using halfspace::HeatResponse;
using halfspace::SurfaceTemperature;
using halfspace::ThermalField;

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

void take_up(SurfaceTemperature& memory, const Input& flux, const HeatMotion& motion)
{
  const auto q = values(flux, shape(memory.grid()), "flux");
  without_lock([&] { memory.take_up(q, motion); });
}

Shape layers_of(const ThermalField& field)
{
  Shape layers = shape(field.grid());
  layers.insert(layers.begin(), field.depths().size());
  return layers;
}

Output displacement(const ThermalField& field, char axis, double later)
{
  std::vector<double> u(field.grid().size());
  const auto part = [&](char of) { return axis == of ? std::span<double>(u) : std::span<double>{}; };
  without_lock([&] { field.displacement({part('z'), part('x'), part('y')}, later); });
  return array(std::move(u), shape(field.grid()));
}

Output temperature_in_body(const ThermalField& field, double later)
{
  const std::size_t cells = field.grid().size(), count = field.depths().size();
  std::vector<double> rise(count * cells);
  without_lock(
      [&]
      {
        for (std::size_t n = 0; n < count; ++n)
          field.layer(n, {.temperature = std::span(rise).subspan(n * cells, cells)}, later);
      });
  return array(std::move(rise), layers_of(field));
}

Output stress(const ThermalField& field, double later)
{
  const std::size_t cells = field.grid().size(), count = field.depths().size();
  std::vector<double> all(6 * count * cells);
  without_lock(
      [&]
      {
        std::vector<double> deviator(Deviator::size * cells), trace(cells);
        for (std::size_t n = 0; n < count; ++n)
        {
          field.layer(n, {.deviator = deviator, .trace = trace}, later);
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
          [](HeatResponse* self, const SurfaceGrid& grid, const Thermal& thermal, const HeatMotion& motion)
          { without_lock([&] { return new (self) HeatResponse(grid, thermal, motion); }); },
          "grid"_a, "thermal"_a, "motion"_a)
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
      .def("take_up", &take_up, "flux"_a, "motion"_a);
  nb::class_<ThermalField>(m, "ThermalField")
      .def(
          "__init__",
          [](ThermalField* self, const SurfaceGrid& grid, const Thermal& thermal,
             const constitutive::Material& material, double shortest_step, double duration, std::vector<double> depths)
          {
            without_lock(
                [&] {
                  return new (self)
                      ThermalField(grid, thermal, material.elastic, {shortest_step, duration}, std::move(depths));
                });
          },
          "grid"_a, "thermal"_a, "material"_a, "shortest_step"_a, "duration"_a, "depths"_a)
      .def_prop_ro("time", &ThermalField::time)
      .def(
          "take_up",
          [](ThermalField& field, const Input& flux, const HeatMotion& motion)
          {
            const auto q = values(flux, shape(field.grid()), "flux");
            without_lock([&] { field.take_up(q, motion); });
          },
          "flux"_a, "motion"_a)
      .def("displacement", &displacement, "axis"_a, "later"_a)
      .def("temperature", &temperature_in_body, "later"_a)
      .def("stress", &stress, "later"_a);
}

} // namespace brinell::python
