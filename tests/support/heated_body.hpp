// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/deviator.hpp"
#include "brinell/halfspace/thermal_field.hpp"
#include "gauss.hpp"
#include "grid_fields.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

/// A body that is heated, and independent integrals over what heat does to it.
namespace brinell::test
{

/// Conductivity 2, diffusivity 0.5, and other constants that do not drop out.
inline const Thermal heated_body{2.0, 4.0, 1.0, 0.7};
inline const Elastic heated_elastic{3.0, 0.3};

struct HeatedLayer
{
  Field temperature;
  std::vector<SymTensor> stress;
};

inline HeatedLayer layer_of(const halfspace::ThermalField& field, std::size_t layer, double duration = 0.0)
{
  const std::size_t n = field.grid().size();
  HeatedLayer result{Field(n), std::vector<SymTensor>(n)};
  Field deviator(Deviator::size * n), trace(n);
  field.layer(layer, {result.temperature, deviator, trace}, duration);
  for (std::size_t i = 0; i < n; ++i)
    result.stress[i] = to_tensor(brinell::deviator_at(deviator, n, i), trace[i]);
  return result;
}

inline Field displacement_of(const halfspace::ThermalField& field, double duration = 0.0)
{
  Field result(field.grid().size());
  field.displacement({result, {}, {}}, duration);
  return result;
}

/// Integral over the time since heat entered, from 0 to `duration`, of f(t): f may go like 1/sqrt(t).
template <typename Function>
double over_past(double duration, Function f)
{
  double sum = 0.0, last = 0.0;
  for (double next = 1e-4 * std::sqrt(duration); last < std::sqrt(duration); next *= 1.3)
  {
    const Gauss root(12, last, std::min(next, std::sqrt(duration)));
    for (std::size_t g = 0; g < root.point.size(); ++g)
      sum += root.weight[g] * 2.0 * root.point[g] * f(root.point[g] * root.point[g]);
    last = next;
  }
  return sum;
}

/// Integral over all wavenumbers of f(k) J_0(k r), of a flux that is smooth over `width`.
template <typename Function>
double over_wavenumbers(double width, double r, Function f)
{
  const double end = 14.0 / width, piece = std::min(0.4 / width, 2.0 / std::max(r, 1e-9));
  double sum = 0.0;
  // Close to zero on shorter and shorter pieces: heat may be spread over many widths.
  double last = 0.0;
  for (double next = 1e-7 / width; last < end; next = std::min(2.0 * next, next + piece))
  {
    const Gauss k(10, last, next);
    for (std::size_t g = 0; g < k.point.size(); ++g)
      sum += k.weight[g] * f(k.point[g]) * std::cyl_bessel_j(0.0, k.point[g] * r);
    last = next;
  }
  return sum;
}

} // namespace brinell::test
