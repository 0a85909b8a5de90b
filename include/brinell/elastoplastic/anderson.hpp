// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// Anderson acceleration of a fixed point x <- g(x) (Anderson 1965; Walker, Ni 2011): the next x is that combination of the last
/// evaluations whose residual f = g(x) - x is orthogonal to the differences of a y(x) between them. With y = f it is the smallest
/// one in the least-squares sense (type II); where f is minus the gradient of an energy by y it is that at which the energy is
/// stationary, as in conjugate gradients.
class Anderson
{
public:
  /// @param depth  earlier evaluations kept; 0 gives the plain fixed point.
  explicit Anderson(int depth);

  /// Replaces x by the next iterate, given g(x) and y(x). All may be longer than last time: unknowns that came in at the end
  /// have no history, as if they had always been converged.
  void advance(std::span<double> x, std::span<const double> g, std::span<const double> y);
  /// Residual of the combination that `advance` went to last, from whose x it leads to g; depth > 0.
  [[nodiscard]] std::vector<double> residual() const;
  /// Tells before `advance` that its g is that of a map which differs a little from the one before: what the history has learnt
  /// still holds, but the difference between these two evaluations tells nothing.
  void change_map() { changes_map_ = true; }
  /// Forgets the history.
  void reset() { count_ = 0; }

private:
  void grow(std::span<const double> x, std::span<const double> g, std::span<const double> y);
  void remember(std::span<const double> x, std::span<const double> g, std::span<const double> y, bool compare);
  [[nodiscard]] std::vector<double> weights(std::size_t used) const;

  std::size_t depth_;
  std::size_t count_ = 0;    ///< evaluations since the last reset, of maps that have not changed after them
  bool changes_map_ = false; ///< with the next evaluation
  std::vector<double> previous_g_, previous_f_, previous_y_;
  std::vector<std::vector<double>> dg_, df_, dy_; ///< ring buffers of differences
  std::vector<double> products_;                  ///< dy . df, [of dy][of df]
  std::vector<double> right_;                     ///< dy . f
  std::vector<double> weight_;                    ///< of the differences in the last combination
};

} // namespace brinell::elastoplastic
