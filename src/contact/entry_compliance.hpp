// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "brinell/halfspace/surface_compliance.hpp"

#include <array>
#include <span>
#include <vector>

namespace brinell::contact
{

/// Free motion of points before they come into a rolling contact: docs/theory/contact.md (entry).
///
/// A point that comes into the contact in a step has moved freely until it touched. Ahead of the edge both surfaces part along
/// each other as they part in height: by the gap at the previous place of the point, times shear over pressure at its new place.
class EntryCompliance
{
public:
  explicit EntryCompliance(const halfspace::SurfaceCompliance& pair);

  /// @param carried          as for TangentialStep
  /// @param pressure_before  before the step, of the surface points that now lie in each cell [Pa]
  /// @param pressure, gap    now [Pa], [m]
  void find(const std::array<int, 2>& carried, std::span<const double> pressure_before,
            std::span<const double> pressure, std::span<const double> gap);
  /// Displacement per shear in each cell, a symmetric matrix: xx, yy, xy [m/Pa]; empty where nothing rolls.
  [[nodiscard]] std::array<std::span<const double>, 3> fields() const { return {field_[0], field_[1], field_[2]}; }

private:
  [[nodiscard]] std::array<double, 2> across_edge(std::span<const double> pressure, int column, int row) const;

  SurfaceGrid grid_;
  double along_edge_; ///< compliance of shear along the edge over that of shear across it
  std::array<std::vector<double>, 3> field_;
};

} // namespace brinell::contact
