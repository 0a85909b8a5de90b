// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "foundation/matrix.hpp"
#include "inclusion_fields.hpp"

#include <cstddef>
#include <span>

namespace brinell::halfspace
{

/// The equations of few cells (contrast-system) as a factorised matrix. What acts between two cells depends on their layers and on their distance along x
/// and y alone, so that a cell of each layer at the corner of the grid tells all of it.
class InclusionMatrix
{
public:
  /// Whether the unknowns are few enough, and the cells away from the edges of the grid, where means over cells are others.
  [[nodiscard]] static bool is_possible(const InclusionCells& cells);
  /// @param fields  of a body with these layers or more, on a mirrored grid one without the knowledge that it is
  InclusionMatrix(InclusionFields& fields, const InclusionCells& cells) : factors_(matrix(fields, cells)) {}
  /// Replaces a right side by the unknown w.
  void solve(std::span<double> values) const { factors_.solve(values); }

private:
  [[nodiscard]] static Matrix matrix(InclusionFields& fields, const InclusionCells& cells);
  Factorised factors_;
};

} // namespace brinell::halfspace
