// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Conduction along one axis: spreading of the heat of one cell.
namespace brinell::green
{

/// Temperature at a point due to a cell of initially unit temperature, after spreading along one axis for the time t (Carslaw
/// and Jaeger 1959, section 2.2): (erf((x + h)/w) - erf((x - h)/w))/2, w = sqrt(4 kappa t). Its integral over x is the width 2h
/// of the cell.
/// @param x          point minus centre of the cell [m]
/// @param half_size  h [m]
/// @param spread     w [m], > 0
[[nodiscard]] double spread_cell(double x, double half_size, double spread);

/// Sum of spread_cell over cells that repeat periodically.
/// @param period  [m], >= 2h
[[nodiscard]] double spread_cells(double x, double half_size, double spread, double period);

} // namespace brinell::green
