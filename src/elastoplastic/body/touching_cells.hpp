// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// Cells in which heat passes between the surfaces in one increment: those that touch, and undecided ones. At the edge of the
/// contact a cell may open because of the heat that it receives while it touches, and close again without this heat, so that
/// neither state is consistent. After `max_partings` openings in one increment such a cell is held in contact until the increment
/// ends; its gap is then less than its thermal displacement.
class TouchingCells
{
public:
  void begin(std::size_t cells)
  {
    was_touching_.assign(cells, false);
    partings_.assign(cells, 0);
  }
  [[nodiscard]] std::vector<bool> find(std::span<const double> heat, std::span<const double> pressure)
  {
    std::vector<bool> touching(heat.size());
    for (std::size_t i = 0; i < touching.size(); ++i)
    {
      const bool touches =
          pressure[i] > 0.0 || heat[i] != 0.0; // heat without pressure: touched at the beginning of the increment
      partings_[i] += was_touching_[i] && !touches ? 1 : 0;
      was_touching_[i] = touches;
      touching[i] = touches || partings_[i] >= max_partings;
    }
    return touching;
  }
  /// Whether heat passes in a cell that is open, because it is held in contact.
  [[nodiscard]] bool is_held_open(std::size_t cell) const
  {
    return partings_[cell] >= max_partings && !was_touching_[cell];
  }
  /// Number of cells held in contact in this increment.
  [[nodiscard]] int held() const
  {
    return static_cast<int>(
        std::count_if(partings_.begin(), partings_.end(), [](int partings) { return partings >= max_partings; }));
  }

private:
  static constexpr int max_partings = 3;
  std::vector<bool> was_touching_;
  std::vector<int> partings_; ///< openings of each cell in the increment
};

} // namespace brinell::elastoplastic
