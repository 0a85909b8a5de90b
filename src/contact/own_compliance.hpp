// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/tangential_contact.hpp"
#include "friction_discs.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace brinell::contact
{

/// Compliance of cells to their own shear, in addition to that of the bodies: TangentialStep::entry, of the cells that can carry
/// shear. Zero if the step has none.
class OwnCompliance
{
public:
  /// @param cells  those that can carry shear
  /// @param bound  of their shear [Pa]
  void read(const TangentialStep& step, std::span<const std::size_t> cells, std::span<const double> bound)
  {
    const auto& [xx, yy, xy] = step.entry;
    matrices_.clear();
    largest_ = largest_displacement_ = 0.0;
    if (xx.empty())
      return;
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      const std::size_t cell = cells[i];
      matrices_.push_back({xx[cell], yy[cell], xy[cell]});
      const double trace = xx[cell] + yy[cell];
      largest_ = std::max(largest_, trace);
      largest_displacement_ = std::max(largest_displacement_, trace * bound[i]);
    }
  }

  /// Displacement of a cell by its shear [m].
  [[nodiscard]] Along displacement(std::size_t i, const Along& shear) const
  {
    return matrices_.empty() ? Along{} : matrices_[i] * shear;
  }
  /// Mean of both directions [m/Pa].
  [[nodiscard]] double mean(std::size_t i) const
  {
    return matrices_.empty() ? 0.0 : 0.5 * (matrices_[i].xx + matrices_[i].yy);
  }
  [[nodiscard]] double largest() const { return largest_; } ///< bound of the norm of the matrices [m/Pa]
  /// Bound of the displacement by shears that are nowhere larger than their bound [m].
  [[nodiscard]] double largest_displacement() const { return largest_displacement_; }

private:
  std::vector<AlongMatrix> matrices_; ///< empty: none
  double largest_ = 0.0, largest_displacement_ = 0.0;
};

} // namespace brinell::contact
