// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/communicator.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// The unknowns of an increment that several ranks solve: passed from the ranks of their cells to those of the pieces in which the
/// acceleration sums, and back. Pieces of all unknowns in their common order are dealt out one by one, so that the sums have the
/// digits of one process, and each rank keeps its share of the history.
class SharedUnknowns
{
public:
  explicit SharedUnknowns(const Communicator& ranks);

  [[nodiscard]] bool is_alone() const { return ranks_.is_alone(); }
  /// @param places  of the own unknowns of each body in the common order
  /// @param size    number of all unknowns
  void follow(const std::vector<std::vector<std::size_t>>& places, std::size_t size);
  [[nodiscard]] std::size_t own_unknowns() const { return order_.size(); }

  /// @param of_cells   of the own unknowns, body by body
  /// @param in_pieces  of the own pieces
  void to_pieces(const std::vector<double>& of_cells, std::vector<double>& in_pieces);
  void to_cells(const std::vector<double>& in_pieces, std::vector<double>& of_cells);

private:
  const Communicator& ranks_;
  std::vector<std::size_t> order_;           ///< own unknowns by the rank that has their piece
  std::vector<std::size_t> sent_, received_; ///< numbers by rank
  std::vector<std::size_t> arrives_;         ///< place in the own pieces of what arrives
  std::size_t in_pieces_ = 0;                ///< number of unknowns in the own pieces
  /// Values sent and received, kept from call to call: new memory for them would cost as much time as the passing.
  std::vector<double> cells_side_, pieces_side_;
};

} // namespace brinell::elastoplastic
