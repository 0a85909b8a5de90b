// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/communicator.hpp"
#include "brinell/foundation/grid.hpp"
#include "brinell/foundation/share.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace brinell
{

/// Evenly spaced items of a row of them, such as the cells along an axis that a result stores.
struct Spaced
{
  int first = 0, count = 0, stride = 1;

  [[nodiscard]] int item(int n) const { return first + n * stride; }
};

/// Some neighbouring layers of a field, and of these some neighbouring rows.
struct Slab
{
  int first_layer = 0, layers = 0, first_row = 0, rows = 0;
};

/// Fields on the cells of a body, of which each of the ranks that share the body has the layers that are its own. The first rank
/// receives them in parts, so that no rank needs memory for a whole field.
class LayeredFields
{
public:
  /// Fields of a process alone, [z][y][x] each.
  LayeredFields(const VolumeGrid& grid, std::vector<std::vector<double>> fields);
  /// @param whole  grid of the body
  /// @param own    the own layers of each field
  LayeredFields(const VolumeGrid& whole, std::shared_ptr<const Communicator> ranks, const Share& share,
                std::vector<std::vector<double>> own);

  [[nodiscard]] std::size_t count() const { return own_.size(); }
  /// Numbers of layers, rows, and cells of a row.
  [[nodiscard]] std::array<std::size_t, 3> shape() const;
  /// Leaves only some cells of the fields to be read.
  [[nodiscard]] LayeredFields selected(const Spaced& z, const Spaced& y, const Spaced& x) &&;

  /// Values of a part of a field, [z][y][x]. All ranks call it; all but the first receive an empty list.
  [[nodiscard]] std::vector<double> part(std::size_t field, const Slab& slab) const;
  /// The whole field: `part` with all layers and rows.
  [[nodiscard]] std::vector<double> whole(std::size_t field = 0) const;
  /// A field of which each value is a function of the values of all fields in its cell.
  [[nodiscard]] LayeredFields combined(const std::function<double(std::size_t own_cell)>& value) const;
  /// Values in the own layers.
  [[nodiscard]] const std::vector<double>& own(std::size_t field) const { return own_[field]; }

private:
  [[nodiscard]] std::vector<double> own_part(std::size_t field, const Slab& slab) const;

  VolumeGrid grid_; ///< of the whole body
  std::shared_ptr<const Communicator> ranks_;
  Share share_;
  std::vector<std::vector<double>> own_;
  Spaced z_, y_, x_; ///< selected
};

} // namespace brinell
