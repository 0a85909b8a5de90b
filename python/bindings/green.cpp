// SPDX-License-Identifier: BSD-3-Clause
#include "arrays.hpp"
#include "module.hpp"

#include "brinell/green/cuboid.hpp"
#include "brinell/green/rectangle.hpp"

using namespace nanobind::literals;

namespace brinell::python
{

namespace
{

SymTensor tensor(const Input& array, const char* name)
{
  return tensor_at(values(array, {6}, name), 1, 0);
}

/// A number at each point of the surface.
template <typename Function>
Output scalars(const Input& x, const Input& y, const Function& function)
{
  const std::size_t n = x.size();
  const auto xs = values(x, {n}, "x");
  const auto ys = values(y, {n}, "y");
  std::vector<double> result(n);
  without_lock(
      [&]
      {
        for (std::size_t i = 0; i < n; ++i)
          result[i] = function(xs[i], ys[i]);
      });
  return array(std::move(result), {n});
}

/// A tensor at each point.
template <typename Function>
Output tensors(const Input& x, const Input& y, const Input& z, const Function& function)
{
  const std::size_t n = x.size();
  const auto xs = values(x, {n}, "x");
  const auto ys = values(y, {n}, "y");
  const auto zs = values(z, {n}, "z");
  std::vector<double> result(6 * n);
  without_lock(
      [&]
      {
        for (std::size_t i = 0; i < n; ++i)
          store(function(xs[i], ys[i], zs[i]), result, n, i);
      });
  return array(std::move(result), {6, n});
}

} // namespace

void bind_green(nb::module_& m)
{
  m.def(
      "rectangle_displacement",
      [](const Input& x, const Input& y, double dx, double dy)
      { return scalars(x, y, [&](double X, double Y) { return green::rectangle_displacement(X, Y, dx, dy); }); },
      "x"_a, "y"_a, "dx"_a, "dy"_a);
  nb::enum_<Traction>(m, "Traction")
      .value("pressure", Traction::pressure)
      .value("shear_x", Traction::shear_x)
      .value("shear_y", Traction::shear_y);
  m.def(
      "rectangle_stress",
      [](const Input& x, const Input& y, const Input& z, double dx, double dy, double nu, Traction traction)
      {
        return tensors(x, y, z,
                       [&](double X, double Y, double Z)
                       { return green::rectangle_stress(X, Y, Z, dx, dy, nu, traction); });
      },
      "x"_a, "y"_a, "z"_a, "dx"_a, "dy"_a, "nu"_a, "traction"_a);
  m.def(
      "cuboid_stress",
      [](const Input& x, const Input& y, const Input& z, double dx, double dy, double dz, const Input& eigenstrain,
         double young_modulus, double poisson_ratio)
      {
        const SymTensor strain = tensor(eigenstrain, "eigenstrain");
        const Elastic elastic{young_modulus, poisson_ratio};
        return tensors(x, y, z,
                       [&](double X, double Y, double Z)
                       { return green::cuboid_stress(X, Y, Z, dx, dy, dz, strain, elastic); });
      },
      "x"_a, "y"_a, "z"_a, "dx"_a, "dy"_a, "dz"_a, "eigenstrain"_a, "young_modulus"_a, "poisson_ratio"_a);
  m.def(
      "cuboid_stress_half_space",
      [](const Input& x, const Input& y, const Input& z, double zc, double dx, double dy, double dz,
         const Input& eigenstrain, double young_modulus, double poisson_ratio)
      {
        const SymTensor strain = tensor(eigenstrain, "eigenstrain");
        const Elastic elastic{young_modulus, poisson_ratio};
        return tensors(x, y, z,
                       [&](double X, double Y, double Z)
                       { return green::cuboid_stress_half_space(X, Y, Z, zc, dx, dy, dz, strain, elastic); });
      },
      "x"_a, "y"_a, "z"_a, "zc"_a, "dx"_a, "dy"_a, "dz"_a, "eigenstrain"_a, "young_modulus"_a, "poisson_ratio"_a);
  m.def(
      "cuboid_surface_displacement",
      [](const Input& x, const Input& y, double zc, double dx, double dy, double dz, const Input& eigenstrain,
         double poisson_ratio)
      {
        const SymTensor strain = tensor(eigenstrain, "eigenstrain");
        return scalars(x, y,
                       [&](double X, double Y)
                       { return green::cuboid_surface_displacement(X, Y, zc, dx, dy, dz, strain, poisson_ratio); });
      },
      "x"_a, "y"_a, "zc"_a, "dx"_a, "dy"_a, "dz"_a, "eigenstrain"_a, "poisson_ratio"_a);
}

} // namespace brinell::python
