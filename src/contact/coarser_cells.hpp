// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"

#include <array>
#include <span>
#include <vector>

namespace brinell::contact
{

/// How the cells along one axis lie on larger ones.
struct CoarserAxis
{
  /// A finer cell: the larger one that its middle lies on, the nearest one beside, and how much that one counts.
  struct Place
  {
    int own = 0, beside = 0;
    double share = 0.0;
  };
  int cells = 0; ///< larger ones
  std::vector<Place> places;

  /// Larger cells cover two finer ones each, of which the last may stand out by one; those of a period, all of it. Few cells stay as
  /// they are.
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
  /// Those around a finer cell, between whose middles its own one lies; the first is that on which it lies. Beyond the grid a cell
  /// weighs nothing and is the first one.
  [[nodiscard]] std::array<Neighbour, 4> around(int i, int j) const;

private:
  SurfaceGrid fine_;
  CoarserAxis x_, y_;
  SurfaceGrid coarse_;
  std::vector<double> share_; ///< of a larger cell that each finer one on it has
};

} // namespace brinell::contact
