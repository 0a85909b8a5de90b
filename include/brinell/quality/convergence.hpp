// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

#include <limits>
#include <span>

/// Discretization error of a number, estimated from runs with successively finer cells.
namespace brinell::quality
{

struct Convergence
{
  double value = 0.0;                                             ///< value with the finest cells
  double order = std::numeric_limits<double>::quiet_NaN();        ///< observed order; NaN if the values show none
  double extrapolated = std::numeric_limits<double>::quiet_NaN(); ///< limit by Richardson; NaN without an order
  double low = 0.0, high = 0.0;                                   ///< interval in which the limit is to be expected
  double relative_error = 0.0;                                    ///< half the interval over max(|value|, scale)
};

/// Grid Convergence Index (Roache 1994; procedure of Celik et al. 2008), for values of methods of at most second order:
/// docs/theory/simulation.md (error of the cells).
///
/// With differences d21, d32 of the three finest runs and r the ratio of their cells, the order p solves d32/d21 = r^p; half of
/// the interval is 1.25 |d21| / (r^p - 1), with p at most the known order of such numbers, because a higher one is accidental;
/// above 2.2 the factor is 3 instead of 1.25. If the values do not approach a limit monotonically there is no order: half of the
/// interval is then three times the largest difference. With two runs first order is assumed, with the factor 3. Without an order
/// the interval is never narrower than the known error of such numbers, because three oscillating values may lie close together
/// by accident.
/// @param cells   cell sizes, coarsest first, in any unit; two or more
/// @param values  the number with each cell size
/// @param scale   typical size of such a number, >= 0; for smaller values the error is relative to this scale
/// @param known_error  relative error of such numbers with the finest of these cells; 0: not known
/// @param known_order  order of such numbers, at most 2
[[nodiscard]] Convergence convergence(std::span<const double> cells, std::span<const double> values, double scale,
                                      double known_error = 0.0, double known_order = 2.0);

/// Multiplies the cell sizes of a case by a factor. The length of a cylinder stays an odd number of cells, a period a
/// whole number.
/// @throws GridError if a period has so few cells that two sizes of a series would be the same
void scale_cells(simulation::Numerics& numerics, const simulation::Shape& lower, const simulation::Shape& upper,
                 double size);

} // namespace brinell::quality
