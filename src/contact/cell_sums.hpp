// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "foundation/sharing.hpp"

#include <cstddef>

/// What the iteration of the elastic contact sums over the cells of a piece of the surface: each in one pass over the fields, in
/// loops without branches.
namespace brinell::contact
{

/// Cells [first, last) of fields: shared out by sum_of_pieces and for_pieces.
struct Piece
{
  std::size_t first, last;
};

/// Whether the iteration moves the pressure of a cell: it is pressed, or the surfaces overlap there.
[[nodiscard]] inline bool is_free(double pressure, double gap)
{
  return (pressure > 0.0) | (gap < 0.0); // without a branch, so that loops over cells need none
}

/// A sum over the cells under pressure, and how many they are.
struct Under
{
  double sum = 0.0, count = 0.0;
  Under& operator+=(const Under& other)
  {
    sum += other.sum;
    count += other.count;
    return *this;
  }
  [[nodiscard]] double mean() const { return count > 0.0 ? sum / count : 0.0; }
};

/// Of the gap at no approach.
[[nodiscard]] Under sum_under(Piece piece, const double* p, const double* displacement, const double* distance);

/// Both halves of the complementarity condition.
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
  double wanted = 0.0, wanted_descent = 0.0; ///< pressure that would close the gap; with the gap
  double before = 0.0, before_descent = 0.0; ///< direction before; with the gap
  double gap = 0.0, count = 0.0;
  Slopes& operator+=(const Slopes& other)
  {
    wanted += other.wanted;
    wanted_descent += other.wanted_descent;
    before += other.before;
    before_descent += other.before_descent;
    gap += other.gap;
    count += other.count;
    return *this;
  }
};

/// @param wanted     pressure that would close the gap
/// @param direction  of the iteration before
[[nodiscard]] Slopes slopes_of(Piece piece, const double* p, const double* gap, const double* wanted,
                               const double* direction);

/// How many cells a step cuts off, and the sum of the pressure after it.
struct Taken
{
  double cut = 0.0, pressure = 0.0;
  Taken& operator+=(const Taken& other)
  {
    cut += other.cut;
    pressure += other.pressure;
    return *this;
  }
};

/// Takes a step along a direction, and the displacement along with it by the image of the direction. What goes past zero is
/// cut.
[[nodiscard]] Taken taken(Piece piece, double step, const double* gap, const double* direction, const double* image,
                          double* p, double* displacement);

} // namespace brinell::contact
