// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/archive.hpp"
#include "brinell/foundation/grid.hpp"

#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// The heat of the plastic work of one body, step by step, on the grid of its heat.
///
/// While a step is solved, it has the heat that is expected: that of the step before, moved along with the contact, and less of
/// it in a shorter step. What the work of
/// the step differs from it by comes with the next step, so that in all nothing is lost: docs/theory/heat.md (heat-of-plastic-work).
class PlasticHeat
{
public:
  /// @param grid   of the heat of the body
  /// @param share  of the plastic work, [0, 1]
  PlasticHeat(const SurfaceGrid& grid, double share) : grid_(grid), share_(share) {}

  /// What arises in the step that begins [J/m^3], [layer][cell].
  /// @param columns   by which the contact moves on the body
  /// @param duration  [s], > 0
  [[nodiscard]] std::vector<double> arising(double columns, double duration);
  /// Ends the step.
  /// @param work      plastic work in it [J/m^3] per cell of the body
  /// @param duration  [s]; 0: it arises at once, and the step had no `arising`
  void settle(std::span<const double> work, const VolumeGrid& body, double duration);
  [[nodiscard]] double total() const { return total_; } ///< since the start [J]

  void exchange(Archive& archive);

private:
  SurfaceGrid grid_;
  double share_;
  std::vector<double> expected_; ///< in the step at hand [J/m^3]
  std::vector<double> last_;     ///< in the last one [J/m^3]
  double last_duration_ = 0.0;   ///< [s]
  std::vector<double> lacking_;  ///< that has not come into the body yet [J/m^3]
  double total_ = 0.0;
};

} // namespace brinell::elastoplastic
