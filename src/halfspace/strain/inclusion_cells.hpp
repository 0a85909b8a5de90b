// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "brinell/halfspace/inclusions.hpp"
#include "cell_means.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace brinell::halfspace
{

/// Range of columns and rows of a surface grid.
struct CellBox
{
  int first_x = 0, nx = 0, first_y = 0, ny = 0;
};

/// Cells of inclusions with their contrasts, and the equations between stress and equivalent strain in them: docs/theory/inclusions.md
/// (contrast-system). The unknown w has the order [component or volume][cell].
struct InclusionCells
{
  VolumeGrid grid;
  std::vector<std::size_t> cells;          ///< on a mirrored grid those in independent rows
  std::vector<double> copies;              ///< of each cell, itself included
  std::vector<double> in_shear, in_volume; ///< contrasts B
  InclusionField own;
  double poisson_ratio = 0.0;
  double root_shear = 0.0, root_volume = 0.0; ///< roots of 2 mu_0 and 9 K_0
  int layers = 0;                             ///< from the surface down to the deepest cell
  CellMeans means;

  InclusionCells() = default; ///< none
  InclusionCells(const VolumeGrid& volume, const Elastic& elastic, const std::vector<Inclusion>& inclusions);
  /// The cells on some columns and rows of the grid, and on the layers down to the deepest one.
  [[nodiscard]] InclusionCells on(const CellBox& box) const;
  /// Other cells of the same body, without contrast, on the grid without mirror images.
  [[nodiscard]] InclusionCells others(std::vector<std::size_t> numbers) const;
  /// Columns and rows that hold the cells and, within the grid, one more on each side, for the means over cells; along a periodic axis
  /// all of them, and on a mirrored grid the same on both sides.
  [[nodiscard]] CellBox box() const;

  [[nodiscard]] std::size_t size() const { return cells.size(); }
  [[nodiscard]] std::size_t unknowns() const { return (Deviator::size + 1) * size(); }
  [[nodiscard]] InclusionField make_field() const;
  /// Scalar product of vectors of the unknown.
  [[nodiscard]] double dot(std::span<const double> a, std::span<const double> b) const;
  [[nodiscard]] double contrast_of(std::size_t component, std::size_t cell) const
  {
    return component < Deviator::size ? in_shear[cell] : in_volume[cell];
  }
  /// The unknown w of an equivalent strain; zero where there is no contrast.
  void to_unknown(const InclusionField& equivalent, std::span<double> w) const;
  /// The equivalent strain of an unknown w.
  void to_strain(std::span<const double> w, InclusionField& equivalent) const;
  /// The right side of the equations, 2 sqrt|B| sigma_0.
  void to_right_side(const InclusionField& stress, std::span<double> right) const;
  /// The left side, from w and the stress that its equivalent strain causes.
  void to_left_side(std::span<const double> w, const InclusionField& caused, std::span<double> left) const;

  using Stress = std::function<void(const InclusionField& equivalent, InclusionField& caused)>;
  /// Solves the equations by minimal residuals, each iteration of which finds the stress of one equivalent strain.
  Inclusions::Report solve(const Stress& stress, std::span<const double> right, std::span<double> w, double tolerance,
                           int most_iterations) const;
};

} // namespace brinell::halfspace
