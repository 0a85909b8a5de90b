// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

#include <limits>
#include <span>

/// How far a number is from its limit of fine cells, read from runs with finer and finer ones.
namespace brinell::simulation
{

struct Convergence
{
  double value = 0.0;                                             ///< with the finest cells
  double order = std::numeric_limits<double>::quiet_NaN();        ///< observed; NaN if the values do not show any
  double extrapolated = std::numeric_limits<double>::quiet_NaN(); ///< limit by Richardson; NaN without an order
  double low = 0.0, high = 0.0;                                   ///< interval in which the limit is to be expected
  double relative_error = 0.0;                                    ///< half of it over max(|value|, scale)
};

/// Grid Convergence Index (Roache 1994; procedure of Celik et al. 2008), for values of methods of at most second order:
/// docs/theory/simulation.md (error of the cells).
///
/// With differences d21, d32 of the three finest runs and r the ratio of their cells, the order p solves d32/d21 = r^p; half of
/// the interval is 1.25 |d21| / (r^p - 1), with p at most 2; an order above that is by accident, and the factor is 3. Where the values do not fall monotonically towards a limit there is no
/// order: then the largest difference counts, three times. Two runs: as of first order, three times. Without an order the interval is
/// never narrower than what such numbers are known to be off by: three values that go to and fro may lie close by accident.
/// @param cells   sizes, coarsest first, in any unit; two or more
/// @param values  with them
/// @param scale   what is large for such a number: below it the error is told relative to it, > 0 or 0
/// @param known_error  of such numbers with the finest of these cells, relative; 0: none is known
[[nodiscard]] Convergence convergence(std::span<const double> cells, std::span<const double> values, double scale,
                                      double known_error = 0.0);

/// Makes the cells of a case so many times as large. A cylinder stays an odd number of them long.
void scale_cells(Numerics& numerics, const Shape& lower, const Shape& upper, double size);

} // namespace brinell::simulation
