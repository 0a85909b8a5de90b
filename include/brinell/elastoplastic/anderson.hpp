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
  /// Forgets the history.
  void reset() { count_ = 0; }

private:
  void remember(std::span<const double> x, std::span<const double> g, std::span<const double> weights);

  std::size_t depth_;
  std::size_t count_ = 0;                       ///< evaluations seen since the last reset
  std::vector<double> previous_g_, previous_f_; ///< f = g - x, the residual
  std::vector<std::vector<double>> dg_, df_;    ///< ring buffers of differences
  std::vector<double> gram_;                    ///< their products df . df
};

} // namespace brinell::elastoplastic
