// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/communicator.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// The numbers of an acceleration that do not depend on how many unknowns there are: which differences between evaluations are kept, and
/// their weights in the next iterate. Who has the unknowns passes the scalar products of their differences.
class AndersonWeights
{
public:
  explicit AndersonWeights(std::size_t depth) : depth_(depth), products_(depth * depth), right_(depth) {}

  /// Place of an evaluation in the history.
  struct Entry
  {
    bool compares = false; ///< the difference to the previous evaluation is kept
    std::size_t slot = 0;  ///< of this difference in the ring of all
    std::size_t known = 0; ///< differences in the history, including a new one
  };
  /// Scalar products for each difference d: newest dy with df of d, dy of d with the newest df, dy of d with f. The first two are of an
  /// entry that compares; of such an entry the last is needed for the newest difference alone.
  struct Products
  {
    double newest_flow = 0.0, newest_residual = 0.0, residual = 0.0;
  };
  [[nodiscard]] Entry next();
  void add(const Entry& entry, std::span<const Products> of_differences);
  /// Weights of the differences dg in the next x; empty if the system has no finite solution.
  [[nodiscard]] std::vector<double> weights() const;
  /// Anderson::change_map
  void change_map() { changes_map_ = true; }
  /// Anderson::deepen
  /// @returns the slot that becomes the first one, and the new depth; the same depth: nothing moves
  struct Moved
  {
    std::size_t first, depth;
  };
  Moved deepen(int depth, double damping);
  void reset() { count_ = 0; }
  /// Forgets all differences; the next one is to the last evaluation.
  void keep_last() { count_ = 1; }
  [[nodiscard]] std::size_t depth() const { return depth_; }

private:
  std::size_t depth_;
  std::size_t count_ = 0;    ///< evaluations since the last reset, without those after which the map changed
  bool changes_map_ = false; ///< whether the next evaluation uses a changed map
  /// Relative to the size of the system. Without it, differences that have become parallel would carry no information.
  double damping_ = 1e-12;
  std::vector<double> products_; ///< dy . df, [of dy][of df]
  std::vector<double> right_;    ///< dy . f
};

/// Anderson acceleration of a fixed point x <- g(x) (Anderson 1965; Walker, Ni 2011): the next x is that combination of the last
/// evaluations whose residual f = g(x) - x is orthogonal to the differences of a quantity y(x) between them. With y = f the
/// residual of the combination is the smallest in the least-squares sense (type II). Where f is minus the gradient of an energy
/// with respect to y, the combination is the one at which the energy is stationary, as in conjugate gradients.
class Anderson
{
public:
  /// @param depth  earlier evaluations kept; 0 gives the plain fixed point.
  /// @param ranks  that share the unknowns, dealt out in pieces of those of sum_of_pieces: the first piece to the first rank, the
  ///               second to the second, and so on. nullptr: this process has all
  explicit Anderson(int depth, const Communicator* ranks = nullptr);

  /// Replaces x by the next iterate, given g(x) and y(x). The arrays may be longer than in the previous call: unknowns that were
  /// appended have no history and are treated as if they had been converged before.
  void advance(std::span<double> x, std::span<const double> g, std::span<const double> y);
  /// Residual f of the combination that the last `advance` chose: the iterate that it returned is the x of the combination plus
  /// this residual. Requires depth > 0.
  [[nodiscard]] std::vector<double> residual() const;
  /// To be called before an `advance` whose g comes from a map slightly different from the previous one: the history stays
  /// valid, but the difference between these two evaluations is not used.
  void change_map() { weights_.change_map(); }
  /// Keeps more differences from now on, and damps their weights: for maps that are far from linear. What is known stays.
  /// @param depth    differences kept; fewer than before change nothing
  /// @param damping  by which the products of a difference with itself are enlarged, relative to them
  void deepen(int depth, double damping);
  /// Forgets the history.
  void reset() { weights_.reset(); }
  /// From now on, gives up the history where an evaluation tells nothing new: for maps that change for another reason than x.
  void give_up_where_still() { gives_up_ = true; }

private:
  void grow(std::span<const double> x, std::span<const double> g, std::span<const double> y);
  void record(std::span<const double> x, std::span<const double> g, std::span<const double> y,
              const AndersonWeights::Entry& entry);
  [[nodiscard]] bool stands_still(std::size_t slot) const;

  AndersonWeights weights_;
  const Communicator* ranks_;
  bool gives_up_ = false;
  std::vector<double> previous_g_, previous_f_, previous_y_;
  std::vector<std::vector<double>> dg_, df_, dy_; ///< ring buffers of differences
  std::vector<double> weight_;                    ///< weights of the differences in the last combination
};

} // namespace brinell::elastoplastic
