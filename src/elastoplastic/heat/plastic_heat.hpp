// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/field_table.hpp"
#include "brinell/foundation/grid.hpp"

#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// Heat of the plastic work of one body, step by step, on the thermal grid of the body.
///
/// While a step is solved, an expected heat is used: that of the previous step, moved along with the contact, and scaled down in
/// a shorter step. The difference from the actual heat of the step is applied in the next step, so that no heat is lost in total:
/// docs/theory/heat.md (heat-of-plastic-work).
class PlasticHeat
{
public:
  /// @param grid   thermal grid of the body
  /// @param share  share of the plastic work that becomes heat, [0, 1]
  PlasticHeat(const SurfaceGrid& grid, double share) : grid_(grid), share_(share) {}

  /// Heat to be applied in the step that begins [J/m^3], [layer][cell]: the expected heat and the difference from earlier steps.
  /// @param columns   by which the contact moves on the body
  /// @param duration  [s], > 0
  [[nodiscard]] std::vector<double> source(double columns, double duration);
  /// Checks that all plastic work of a step lies above or below the thermal grid.
  /// @throws GridError
  void require_room(std::span<const double> work, const VolumeGrid& body) const;
  /// Ends the step.
  /// @param work      plastic work in the step [J/m^3] per cell of the material grid
  /// @param duration  [s]; 0: the heat arises at once, and `source` was not called for the step
  void settle(std::span<const double> work, const VolumeGrid& body, double duration);
  [[nodiscard]] double total() const { return state_.total; } ///< since the start [J]

  void exchange(Archive& archive);

private:
  [[nodiscard]] std::vector<double> fitted(std::span<const double> work, const VolumeGrid& body) const;

  SurfaceGrid grid_;
  double share_;
  std::vector<double> expected_; ///< expected heat of the current step [J/m^3]
  struct State
  {
    std::vector<double> last;    ///< actual heat of the last step [J/m^3]
    double duration = 0.0;       ///< of the last step [s]
    std::vector<double> pending; ///< actual minus applied heat, still to be applied [J/m^3]
    double total = 0.0;          ///< [J]

    static constexpr auto table()
    {
      return std::tuple{listed(&State::last, {"last"}, {.is_sized = true}), listed(&State::duration, {"duration"}),
                        listed(&State::pending, {"lacking"}, {.is_sized = true}), listed(&State::total, {"total"})};
    }
  };
  State state_;
};

} // namespace brinell::elastoplastic
