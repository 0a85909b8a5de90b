// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// Anderson acceleration of a fixed point x <- g(x) (Anderson 1965; Walker, Ni 2011, type II): the next x is that
/// combination of the last evaluations whose residual is smallest in the least-squares sense.
class Anderson
{
public:
  /// @param depth  earlier evaluations kept; 0 gives the plain fixed point.
  explicit Anderson(int depth);

  /// Replaces x by the next iterate, given g(x). Both may be longer than last time: unknowns that came in at the end
  /// have no history, as if they had always been converged.
  /// @param weights  of the unknowns in the sum of squares that is smallest; empty: all the same
  void advance(std::span<double> x, std::span<const double> g, std::span<const double> weights = {});
  /// Tells before `advance` that its g is that of a map which differs a little from the one before: what the history has learnt
  /// still holds, but the difference between these two evaluations tells nothing.
  void change_map() { changes_map_ = true; }
  /// Forgets the history.
  void reset() { count_ = 0; }

private:
  void remember(std::span<const double> x, std::span<const double> g, std::span<const double> weights, bool compare);

  std::size_t depth_;
  std::size_t count_ = 0;    ///< evaluations since the last reset, of maps that have not changed after them
  bool changes_map_ = false; ///< with the next evaluation
  std::vector<double> previous_g_, previous_f_; ///< f = g - x, the residual
  std::vector<std::vector<double>> dg_, df_;    ///< ring buffers of differences
  std::vector<double> gram_;                    ///< their products df . df
};

} // namespace brinell::elastoplastic
