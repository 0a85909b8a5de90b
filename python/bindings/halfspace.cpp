// SPDX-License-Identifier: BSD-3-Clause
#include "arrays.hpp"
#include "grids.hpp"
#include "layers.hpp"
#include "module.hpp"

#include "brinell/constitutive/material.hpp"
#include "brinell/halfspace/half_space.hpp"
#include "brinell/halfspace/surface_compliance.hpp"

#include <cmath>
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

using halfspace::HalfSpace;
using halfspace::SurfaceCompliance;
using halfspace::SurfaceLoad;

Output displacement(const SurfaceCompliance& compliance, const Input& pressure)
{
  const auto p = values(pressure, shape(compliance.grid()), "pressure");
  std::vector<double> u(p.size());
  without_lock(
      [&]
      {
        SurfaceCompliance::Scratch scratch = compliance.make_scratch();
        compliance.apply({.pressure = p}, {.z = u}, scratch);
      });
  return array(std::move(u), shape(compliance.grid()));
}

/// Load on a surface; None is zero.
SurfaceLoad surface_load(const SurfaceGrid& grid, const std::optional<Input>& pressure,
                         const std::optional<Input>& shear_x, const std::optional<Input>& shear_y)
{
  const auto part = [&](const std::optional<Input>& given, const char* name)
  { return given ? values(*given, shape(grid), name) : std::span<const double>{}; };
  return {part(pressure, "pressure"), part(shear_x, "shear_x"), part(shear_y, "shear_y")};
}

/// Along x, y and z.
Output displacements(const SurfaceCompliance& compliance, const std::optional<Input>& pressure,
                     const std::optional<Input>& shear_x, const std::optional<Input>& shear_y)
{
  const SurfaceGrid& g = compliance.grid();
  const SurfaceLoad load = surface_load(g, pressure, shear_x, shear_y);
  std::vector<double> u(3 * g.size());
  const auto part = [&](std::size_t direction) { return std::span(u).subspan(direction * g.size(), g.size()); };
  without_lock([&] { compliance.apply(load, {.z = part(2), .x = part(0), .y = part(1)}); });
  Shape three = shape(g);
  three.insert(three.begin(), 3);
  return array(std::move(u), three);
}

/// Six components -> the engine's five.
/// @throws InputError if the strain changes the volume
std::vector<double> traceless(std::span<const double> fields)
{
  constexpr double rounding = 1e-12;
  const std::size_t n = fields.size() / 6;
  std::vector<double> result(Deviator::size * n);
  for (std::size_t i = 0; i < n; ++i)
  {
    const SymTensor t = tensor_at(fields, n, i);
    if (!(std::abs(trace(t)) <= rounding * (std::abs(t[0]) + std::abs(t[1]) + std::abs(t[2]))))
      throw InputError(fmt::format(
          "eigenstrain has the trace {:g} in cell {}; it must be plastic, with xx + yy + zz = 0", trace(t), i));
    const Deviator d = to_deviator(t);
    for (int c = 0; c < Deviator::size; ++c)
      result[static_cast<std::size_t>(c) * n + i] = d[c];
  }
  return result;
}

Output stress(const HalfSpace& half_space, const std::optional<Input>& pressure,
              const std::optional<Input>& eigenstrain, const std::optional<Input>& shear_x,
              const std::optional<Input>& shear_y)
{
  const VolumeGrid& g = half_space.grid();
  const SurfaceLoad load = surface_load(g.surface, pressure, shear_x, shear_y);
  std::span<const double> given;
  if (eigenstrain)
    given = values(*eigenstrain, tensor_shape(g), "eigenstrain");
  return array(without_lock(
                   [&]
                   {
                     const std::vector<double> strain =
                         eigenstrain ? traceless(given) : std::vector<double>(Deviator::size * g.size());
                     std::vector<double> deviator(strain.size());
                     std::vector<double> trace(g.size());
                     HalfSpace::Work work = half_space.make_work();
                     half_space.full_stress(load, strain, work, deviator, trace);
                     return six_fields(deviator, trace);
                   }),
               tensor_shape(g));
}

Output residual_displacement(const HalfSpace& half_space, const Input& eigenstrain, char axis)
{
  using halfspace::Displacements;
  const VolumeGrid& g = half_space.grid();
  const auto given = values(eigenstrain, tensor_shape(g), "eigenstrain");
  std::vector<double> u(g.surface.size());
  without_lock(
      [&]
      {
        HalfSpace::Work work = half_space.make_work();
        const std::vector<double> strain = traceless(given);
        const auto wanted = axis == 'z' ? Displacements::normal : Displacements::all;
        const HalfSpace::Loaded loaded = half_space.load(strain, g.nz, work, wanted);
        if (axis == 'z')
          loaded.displacement({.z = u});
        else if (axis == 'x')
          loaded.displacement({.x = u});
        else
          loaded.displacement({.y = u});
      });
  return array(std::move(u), shape(g.surface));
}

} // namespace

void bind_halfspace(nb::module_& m)
{
  nb::class_<SurfaceGrid>(m, "SurfaceGrid")
      .def(
          "__init__",
          [](SurfaceGrid* self, int nx, int ny, double dx, double dy, bool is_periodic_x, bool is_periodic_y)
          {
            const auto boundary = [](bool is_periodic) { return is_periodic ? Boundary::periodic : Boundary::open; };
            new (self) SurfaceGrid{nx, ny, dx, dy, boundary(is_periodic_x), boundary(is_periodic_y)};
          },
          "nx"_a, "ny"_a, "dx"_a, "dy"_a, "is_periodic_x"_a = false, "is_periodic_y"_a = false);
  nb::class_<VolumeGrid>(m, "VolumeGrid")
      .def(
          "__init__",
          [](VolumeGrid* self, const SurfaceGrid& surface, int nz, double dz) {
            new (self) VolumeGrid{surface, nz, dz};
          },
          "surface"_a, "nz"_a, "dz"_a);
  nb::class_<SurfaceCompliance>(m, "SurfaceCompliance")
      .def(
          "__init__",
          [](SurfaceCompliance* self, const SurfaceGrid& grid, const constitutive::Material& lower,
             const constitutive::Material& upper, double reference, const Layers& lower_layers,
             const Layers& upper_layers)
          {
            without_lock(
                [&]
                {
                  return lower_layers.empty() && upper_layers.empty()
                             ? new (self) SurfaceCompliance(grid, lower.elastic, upper.elastic, reference)
                             : new (self) SurfaceCompliance(grid, stack_of(lower_layers, lower),
                                                            stack_of(upper_layers, upper), reference);
                });
          },
          "grid"_a, "lower"_a, "upper"_a, "reference"_a = 0.0, "lower_layers"_a = Layers(), "upper_layers"_a = Layers())
      .def("displacement", &displacement, "pressure"_a)
      .def("displacements", &displacements, "pressure"_a.none(), "shear_x"_a.none(), "shear_y"_a.none());
  nb::class_<HalfSpace>(m, "HalfSpace")
      .def(
          "__init__",
          [](HalfSpace* self, const VolumeGrid& grid, const constitutive::Material& material, const Layers& layers)
          { without_lock([&] { return new (self) HalfSpace(grid, stack_of(layers, material)); }); },
          "grid"_a, "material"_a, "layers"_a = Layers())
      .def("stress", &stress, "pressure"_a.none(), "eigenstrain"_a.none(), "shear_x"_a.none(), "shear_y"_a.none())
      .def("residual_displacement", &residual_displacement, "eigenstrain"_a, "axis"_a);
}

} // namespace brinell::python
