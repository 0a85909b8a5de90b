// SPDX-License-Identifier: BSD-3-Clause
#include "arrays.hpp"
#include "grids.hpp"
#include "module.hpp"

#include "brinell/halfspace/surface_temperature.hpp"

using namespace nanobind::literals;

namespace brinell::python
{

namespace
{

using halfspace::HeatMotion;
using halfspace::HeatResponse;
using halfspace::SurfaceTemperature;

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
}

} // namespace brinell::python
