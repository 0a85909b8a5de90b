// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "foundation/sharing.hpp"

#include <cstddef>

/// Sums over the cells of a piece of the surface in the iteration of the elastic contact: each in one pass over the fields, in
/// loops without branches.
namespace brinell::contact
{

/// Cells [first, last) of the fields, as assigned by sum_of_pieces and for_pieces.
struct Piece
{
  std::size_t first, last;
};

/// Whether the iteration changes the pressure of a cell: the cell is under pressure, or the surfaces overlap there.
[[nodiscard]] inline bool is_free(double pressure, double gap)
{
  return (pressure > 0.0) | (gap < 0.0); // without a branch, so that loops over cells need none
}

/// A sum over the cells under pressure, and their number.
struct PressedSum
{
  double sum = 0.0, count = 0.0;
  PressedSum& operator+=(const PressedSum& other)
  {
    sum += other.sum;
    count += other.count;
    return *this;
  }
  [[nodiscard]] double mean() const { return count > 0.0 ? sum / count : 0.0; }
};

/// Sum of the gap at zero approach over the cells under pressure.
[[nodiscard]] PressedSum sum_of_pressed(Piece piece, const double* p, const double* displacement,
                                        const double* distance);

/// Errors of both parts of the complementarity condition: largest |gap| under pressure, and largest penetration elsewhere [m].
struct Errors
{
  double gap = 0.0, penetration = 0.0;
  Errors& operator+=(const Errors& other)
  {
    gap = larger(gap, other.gap);
    penetration = larger(penetration, other.penetration);
    return *this;
  }
};

[[nodiscard]] Errors errors_of(Piece piece, const double* p, const double* gap);

/// Sums over the free cells, from which the next direction follows.
struct Slopes
{
  double correction = 0.0, correction_descent = 0.0; ///< sum of the pressure that would close the gap; with the gap
  double before = 0.0, before_descent = 0.0;         ///< sum of the previous direction; with the gap
  double gap = 0.0, count = 0.0;
  Slopes& operator+=(const Slopes& other)
  {
    correction += other.correction;
    correction_descent += other.correction_descent;
    before += other.before;
    before_descent += other.before_descent;
    gap += other.gap;
    count += other.count;
    return *this;
  }
};

/// @param correction pressure that would close the gap
/// @param direction  of the previous iteration
[[nodiscard]] Slopes slopes_of(Piece piece, const double* p, const double* gap, const double* correction,
                               const double* direction);

/// Number of cells whose pressure a step cuts off at zero, and the sum of the pressure after the step.
struct StepSums
{
  double cut = 0.0, pressure = 0.0;
  StepSums& operator+=(const StepSums& other)
  {
    cut += other.cut;
    pressure += other.pressure;
    return *this;
  }
};

/// Takes a step along a direction and updates the displacement by the image of the direction. Pressures below zero are cut off.
[[nodiscard]] StepSums take_step(Piece piece, double step, const double* gap, const double* direction,
                                 const double* image, double* p, double* displacement);

} // namespace brinell::contact
