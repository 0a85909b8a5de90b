// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/quality/convergence.hpp"

#include "brinell/foundation/error.hpp"
#include "foundation/nan.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace brinell::quality
{

using namespace simulation;

namespace
{

constexpr double believed_order =
    2.2; ///< a higher observed order is accidental (Roache: a tenth above the theoretical order)
constexpr double theoretical_order = 2.0; ///< of steps and cells
constexpr double lowest_order = 0.5;      ///< a lower observed order is not extrapolated
constexpr double safety = 1.25;           ///< Roache's factor for three grids with an observed order
constexpr double wide_safety = 3.0;       ///< Roache's factor without an observed order
constexpr double solver_share = 1e-4;     ///< relative convergence of steps, below which runs do not agree

/// The observed order p from d32 / d21 = r21^p (r32^p - 1) / (r21^p - 1) by bisection; for equal ratios the right side is r^p.
double observed_order(double d21, double d32, double r21, double r32)
{
  const double quotient = d32 / d21;
  const auto model = [&](double p) { return std::pow(r21, p) * (std::pow(r32, p) - 1.0) / (std::pow(r21, p) - 1.0); };
  double low = 1e-3, high = 20.0;
  if (!(quotient > model(low)))
    return 0.0;
  for (int i = 0; i < 60; ++i)
    (model(0.5 * (low + high)) < quotient ? low : high) = 0.5 * (low + high);
  return high;
}

/// Cells in a period once their size has been multiplied. A single cell stays one, because nothing varies along that axis.
double rescaled(double cells, double size)
{
  constexpr double fewest = 4.0; // with fewer, two cell sizes of a series fall together
  cells = std::round(cells);
  if (cells == 1.0)
    return cells;
  if (cells < fewest)
    throw GridError(fmt::format("{:g} cells in a period; allowed in a series of cell sizes (solver.accuracy): at least "
                                "{:g}, or 1 along y where nothing varies",
                                cells, fewest));
  return std::round(cells / size);
}

struct Half
{
  double width, order, extrapolated;
};

/// @param highest_order  order of the method for such numbers
Half half_interval(std::span<const double> h, std::span<const double> f, double highest_order)
{
  const std::size_t n = f.size();
  const double r21 = h[n - 2] / h[n - 1];
  const double d21 = f[n - 2] - f[n - 1];
  if (n == 2)
    return {wide_safety * std::abs(d21) / (r21 - 1.0), nan, nan};
  const double r32 = h[n - 3] / h[n - 2];
  const double d32 = f[n - 3] - f[n - 2];
  const double largest = std::max(std::abs(d21), std::abs(d32));
  if (!(d21 * d32 > 0.0)) // oscillating, or no difference at all
    return {wide_safety * largest, nan, largest == 0.0 ? f[n - 1] : nan};
  const double p = observed_order(d21, d32, r21, r32);
  if (p < lowest_order)
    return {std::max(wide_safety * largest, safety * std::abs(d21) / (std::pow(r21, lowest_order) - 1.0)), nan, nan};
  const double q = std::min(p, highest_order);
  const double limit = f[n - 1] - d21 / (std::pow(r21, q) - 1.0);
  if (p <= believed_order)
    return {safety * std::abs(d21) / (std::pow(r21, q) - 1.0), p, limit};
  // The difference may be small by accident: use at least the one that second order would give from the previous difference.
  const double second = std::abs(d32) * (std::pow(r21, 2.0) - 1.0) / (std::pow(r32, 2.0) - 1.0) / std::pow(r21, 2.0);
  return {wide_safety * std::max(std::abs(d21), second) / (std::pow(r21, q) - 1.0), p, limit};
}

} // namespace

Convergence convergence(std::span<const double> cells, std::span<const double> values, double scale, double known_error,
                        double known_order)
{
  if (cells.size() != values.size() || values.size() < 2)
    throw InputError(
        fmt::format("an estimate from {} values at {} cell sizes; allowed: as many values as cell sizes, two or more",
                    values.size(), cells.size()));
  for (std::size_t i = 1; i < cells.size(); ++i)
    if (!(cells[i] > 0.0 && cells[i] < cells[i - 1]))
      throw InputError("the sizes of cells must fall and be > 0");
  const Half half = half_interval(cells, values, std::clamp(known_order, lowest_order, theoretical_order));
  const double value = values.back();
  const double size = std::max(std::abs(value), scale);
  const bool shows_a_limit = !std::isnan(half.extrapolated);
  const double least = shows_a_limit ? solver_share : std::max(known_error, solver_share);
  const double width = std::max(half.width, least * size);
  return {value, half.order, half.extrapolated, value - width, value + width, size > 0.0 ? width / size : 0.0};
}

void scale_cells(Numerics& numerics, const Shape& lower, const Shape& upper, double size)
{
  Domain& domain = numerics.domain;
  domain.layer *= size;
  for (Domain::Axis* axis : {&domain.x, &domain.y})
    if (axis->cells > 0)
      axis->cells = static_cast<int>(rescaled(axis->cells, size));
  if (!numerics.spacing)
  {
    numerics.resolution /= size;
    return;
  }
  auto& [dx, dy, dz] = *numerics.spacing;
  for (const auto& [axis, side] : {std::pair{&domain.x, &dx}, std::pair{&domain.y, &dy}})
    *side = axis->is_periodic() ? axis->size / rescaled(axis->size / *side, size) : *side * size;
  dz *= size;
  if (const double length = roller_length(lower, upper); size != 1.0 && std::isfinite(length))
    dy = length / (2.0 * std::max(0.0, std::round(0.5 * (length / dy - 1.0))) + 1.0);
}

} // namespace brinell::quality
