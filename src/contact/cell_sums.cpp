// SPDX-License-Identifier: BSD-3-Clause
#include "cell_sums.hpp"

#include <algorithm>
#include <cmath>

/// The terms of cell_terms.hpp, written out: GCC 12 makes no lanes of loops that call them.
namespace brinell::contact
{

PressedSum sum_of_pressed(Piece piece, const double* p, const double* displacement, const double* distance)
{
  double sum = 0.0;
  double count = 0.0;
#pragma omp simd reduction(+ : sum, count)
  for (std::size_t i = piece.first; i < piece.last; ++i)
  {
    sum += p[i] > 0.0 ? displacement[i] + distance[i] : 0.0;
    count += p[i] > 0.0 ? 1.0 : 0.0;
  }
  return {sum, count};
}

Errors errors_of(Piece piece, const double* p, const double* gap)
{
  double sum = 0.0; // is NaN if any gap is
  double gap_error = 0.0;
  double penetration = 0.0;
#pragma omp simd reduction(+ : sum) reduction(max : gap_error, penetration)
  for (std::size_t i = piece.first; i < piece.last; ++i)
  {
    const double pressed = p[i] > 0.0 ? gap[i] : 0.0;
    const double outside = p[i] > 0.0 ? 0.0 : -gap[i];
    sum += gap[i];
    gap_error = std::max(gap_error, std::abs(pressed));
    penetration = std::max(penetration, outside);
  }
  const double none = std::isnan(sum) ? sum : 0.0;
  return {gap_error + none, penetration + none};
}

Slopes slopes_of(Piece piece, const double* p, const double* gap, const double* correction, const double* direction)
{
  double correction_sum = 0.0;
  double correction_descent = 0.0;
  double before = 0.0;
  double before_descent = 0.0;
  double gap_sum = 0.0;
  double count = 0.0;
#pragma omp simd reduction(+ : correction_sum, correction_descent, before, before_descent, gap_sum, count)
  for (std::size_t i = piece.first; i < piece.last; ++i)
  {
    const double free = is_free(p[i], gap[i]) ? 1.0 : 0.0;
    correction_sum += free * correction[i];
    correction_descent += free * gap[i] * correction[i];
    before += free * direction[i];
    before_descent += free * gap[i] * direction[i];
    gap_sum += free * gap[i];
    count += free;
  }
  return {correction_sum, correction_descent, before, before_descent, gap_sum, count};
}

StepSums take_step(Piece piece, double step, const double* gap, const double* direction, const double* image, double* p,
                   double* displacement)
{
  double sum = 0.0;
  double cut = 0.0; // GCC 12 counts wrongly, and reads beyond arrays, if this is an integer
#pragma omp simd reduction(+ : sum, cut)
  for (std::size_t i = piece.first; i < piece.last; ++i)
  {
    const double moved = moved_pressure(p[i], gap[i], step, direction[i]);
    cut += moved < 0.0 ? 1.0 : 0.0;
    p[i] = std::max(0.0, moved);
    sum += p[i];
    displacement[i] -= step * image[i];
  }
  return {cut, sum};
}

} // namespace brinell::contact
