// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cell_terms.hpp"
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

/// Sum of the gap at zero approach over the cells under pressure.
[[nodiscard]] PressedSum sum_of_pressed(Piece piece, const double* p, const double* displacement,
                                        const double* distance);

[[nodiscard]] Errors errors_of(Piece piece, const double* p, const double* gap);

/// @param correction pressure that would close the gap
/// @param direction  of the previous iteration
[[nodiscard]] Slopes slopes_of(Piece piece, const double* p, const double* gap, const double* correction,
                               const double* direction);

/// Takes a step along a direction and updates the displacement by the image of the direction. Pressures below zero are cut off.
[[nodiscard]] StepSums take_step(Piece piece, double step, const double* gap, const double* direction,
                                 const double* image, double* p, double* displacement);

} // namespace brinell::contact
