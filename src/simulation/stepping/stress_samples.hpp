// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/archive.hpp"
#include "brinell/foundation/grid.hpp"
#include "brinell/simulation/fatigue.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace brinell::simulation
{

/// The numbers of some columns of a body at one moment, in all layers and independent rows.
struct Sample
{
  int first = 0, count = 0;  ///< columns
  std::vector<float> values; ///< [layer][row][number][column]
  float error = 0.0F;        ///< largest distance of a sample that was left out from the segment that ends here [Pa]
  float cost = -1.0F;        ///< the error if this one were left out [Pa]; negative: not known
};

/// The history of all cells of a body in a cycle, one sample after the other. If they need more memory than `fatigue_samples` of
/// the whole body, those are left out that are nearest to the chords between their neighbours. All that fatigue asks of the path
/// of a cell depends on its convex hull, which thereby changes by less than `error`: docs/theory/fatigue.md.
class StressSamples
{
public:
  StressSamples() = default;
  /// @param numbers  of a cell
  StressSamples(const VolumeGrid& grid, int numbers);

  [[nodiscard]] int strips() const { return layers_ * rows_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] int numbers() const { return numbers_; }
  [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }
  /// Numbers of one strip, a row in a layer, in one sample: [number][column].
  [[nodiscard]] const float* strip(const Sample& sample, int strip) const
  {
    return sample.values.data() + static_cast<std::size_t>(strip) * static_cast<std::size_t>(numbers_) *
                                      static_cast<std::size_t>(sample.count);
  }
  [[nodiscard]] double error() const;

  /// A further sample, to be filled.
  Sample& add(int first, int count);
  /// Makes room for the next sample.
  void thin();
  /// Begins a new cycle where the old one has ended.
  void restart();
  /// Moves to a larger grid. Cells that are new get those of the sample `untouched` of all columns of the new grid.
  /// @param columns, rows  by which old cells have moved
  void move_to(const VolumeGrid& grid, int columns, int rows, const Sample& untouched);

  void exchange(Archive& archive);

private:
  [[nodiscard]] std::size_t size(int columns) const
  {
    return static_cast<std::size_t>(strips()) * static_cast<std::size_t>(numbers_) * static_cast<std::size_t>(columns);
  }
  void find_cost(std::size_t n);
  [[nodiscard]] float off_chord(const Sample& before, const Sample& here, const Sample& after) const;

  int columns_ = 0, rows_ = 0, layers_ = 0, numbers_ = 0;
  std::vector<Sample> samples_;
  std::vector<std::vector<float>> spare_; ///< of samples that were left out, whose memory the next ones take
};

} // namespace brinell::simulation
