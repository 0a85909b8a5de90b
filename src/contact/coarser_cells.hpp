// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"

#include <array>
#include <span>
#include <vector>

namespace brinell::contact
{

/// Assignment of the cells along one axis to larger cells.
struct CoarserAxis
{
  /// For a finer cell: the larger cell that contains its middle, the nearest neighbour of that cell, and the neighbour's weight.
  struct Place
  {
    int own = 0, beside = 0;
    double share = 0.0;
  };
  int cells = 0; ///< number of larger cells
  std::vector<Place> places;

  /// Each larger cell covers two finer ones; along an open axis the last may extend beyond the grid by one finer cell, along a
  /// periodic axis the larger cells cover exactly the period. An axis with few cells is not coarsened.
  CoarserAxis(int fine, Boundary boundary);
};

/// A grid of cells twice as large, on which a contact is solved for a guess.
class CoarserCells
{
public:
  /// Whether a guess from larger cells saves more than it costs.
  [[nodiscard]] static bool helps(const SurfaceGrid& fine);

  explicit CoarserCells(const SurfaceGrid& fine);

  [[nodiscard]] const SurfaceGrid& fine() const { return fine_; }
  [[nodiscard]] const SurfaceGrid& coarse() const { return coarse_; } ///< with the same boundaries

  /// A field on the larger cells: its mean over the finer ones on each.
  void average(std::span<const double> fine, std::span<double> coarse) const;

  /// A larger cell near a finer one, and how much it counts.
  struct Neighbour
  {
    std::size_t cell = 0;
    double weight = 0.0;
  };
  /// The larger cells around a finer cell, whose middles enclose its middle; the first one contains the finer cell. A neighbour
  /// beyond the grid has the weight zero and the index of the first one.
  [[nodiscard]] std::array<Neighbour, 4> around(int i, int j) const;

private:
  SurfaceGrid fine_;
  CoarserAxis x_, y_;
  SurfaceGrid coarse_;
  std::vector<double> share_; ///< of each finer cell in the mean over its larger cell
};

} // namespace brinell::contact
