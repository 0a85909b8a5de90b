// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/host_device.hpp"

#include <cstddef>

/// Kernels that remove the periodic images of the plastic strain, by functions of x and of y (BoundaryParts). Sums have a fixed order,
/// whatever runs the kernels.
namespace brinell::device
{

/// Planes of nx times ny values, and functions of x and y.
struct Planes
{
  std::size_t nx, ny, of_x, of_y; ///< columns, rows, functions of x, functions of y
  const double *x, *y;            ///< functions, [function][column], [function][row]

  [[nodiscard]] BRINELL_HOST_DEVICE std::size_t cells() const { return nx * ny; }
};

/// Sum over y of a field times a function of y: [plane][function of y][column].
struct SumOverRows
{
  Planes planes;
  const double* field; ///< [plane][row][column]
  double* sums;

  BRINELL_HOST_DEVICE void operator()(std::size_t n) const
  {
    const std::size_t column = n % planes.nx, function = n / planes.nx % planes.of_y,
                      plane = n / planes.nx / planes.of_y;
    const double* from = field + plane * planes.cells() + column;
    const double* y = planes.y + function * planes.ny;
    double sum = 0.0;
    for (std::size_t j = 0; j < planes.ny; ++j)
      sum += y[j] * from[j * planes.nx];
    sums[n] = sum;
  }
};

/// Sum over x of these sums times a function of x: [plane][function of y][function of x].
struct SumOverColumns
{
  Planes planes;
  const double* sums;
  double* moments;

  BRINELL_HOST_DEVICE void operator()(std::size_t n) const
  {
    const double* from = sums + n / planes.of_x * planes.nx;
    const double* x = planes.x + n % planes.of_x * planes.nx;
    double sum = 0.0;
    for (std::size_t i = 0; i < planes.nx; ++i)
      sum += x[i] * from[i];
    moments[n] = sum;
  }
};

/// Coefficients of the functions of y in one column: [plane][function of y][column].
struct CoefficientsOfColumn
{
  Planes planes;
  const double* coefficients; ///< [plane][function of y][function of x]
  double* sums;

  BRINELL_HOST_DEVICE void operator()(std::size_t n) const
  {
    const double* from = coefficients + n / planes.nx * planes.of_x;
    double sum = 0.0;
    for (std::size_t a = 0; a < planes.of_x; ++a)
      sum += from[a] * planes.x[a * planes.nx + n % planes.nx];
    sums[n] = sum;
  }
};

/// Subtracts the sum of functions of y with the coefficients of its column from a value.
struct SubtractFunctions
{
  Planes planes;
  const double* sums;
  double* field;

  BRINELL_HOST_DEVICE void operator()(std::size_t n) const
  {
    const std::size_t column = n % planes.nx, row = n / planes.nx % planes.ny, plane = n / planes.cells();
    const double* from = sums + plane * planes.of_y * planes.nx + column;
    double sum = 0.0;
    for (std::size_t b = 0; b < planes.of_y; ++b)
      sum += from[b * planes.nx] * planes.y[b * planes.ny + row];
    field[n] -= sum;
  }
};

} // namespace brinell::device
