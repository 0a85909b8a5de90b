// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/communicator.hpp"
#include "brinell/foundation/share.hpp"
#include "foundation/aligned.hpp"
#include "foundation/lanes.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace brinell::halfspace
{

/// Passes rows of planes, transformed along x, from the ranks that have the planes to those that have the blocks of wavenumbers, and
/// back. One plane of some layers, or of some pairs of layers ("units"), is passed at a time: the buffers are small, and the caches
/// still have the rows when they are read again.
///   of planes  [block][own unit][row]                   what the ranks that have the planes send or receive
///   of blocks  [rank][own block][unit of the rank][row] what the ranks that have the blocks receive or send
/// of ComplexLanes: nothing is packed on the side of the planes.
class Exchange
{
public:
  /// @param units     by whom they are dealt
  /// @param of_units  how many there are, from the first one
  Exchange(const Communicator& ranks, const Share& share, const Dealt& units, int of_units, int blocks, int rows);

  [[nodiscard]] int units() const { return of_units_; }
  [[nodiscard]] int own_units() const { return own_units_; }
  /// Values from one block to the next on the side of the planes.
  [[nodiscard]] std::ptrdiff_t apart() const { return static_cast<std::ptrdiff_t>(own_units_) * rows_; }
  [[nodiscard]] std::size_t size_of_planes() const;
  [[nodiscard]] std::size_t size_of_blocks() const;
  /// Place of a unit in an own block on the side of the blocks.
  [[nodiscard]] std::ptrdiff_t place(int unit, int block) const;

  void to_blocks(const ComplexLanes* planes, ComplexLanes* blocks) const;
  void to_planes(const ComplexLanes* blocks, ComplexLanes* planes) const;

private:
  const Communicator& ranks_;
  Dealt units_;
  int of_units_, rows_, own_units_;
  Portion own_blocks_;
  std::vector<int> units_of_;                      ///< by rank
  std::vector<std::ptrdiff_t> first_of_;           ///< place of the values of a rank on the side of the blocks
  std::vector<std::size_t> of_planes_, of_blocks_; ///< numbers passed to and from each rank
};

} // namespace brinell::halfspace
