// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/anderson.hpp"
#include "growing.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

/// The history of the acceleration of one body: what elastoplastic::Anderson keeps of its unknowns.
namespace brinell::device
{

/// Unknowns of an evaluation and of the one before, and the differences in a ring, [slot][unknown].
struct HistoryArrays
{
  double *dg = nullptr, *df = nullptr, *dy = nullptr;
  double *g = nullptr, *f = nullptr, *y = nullptr; ///< of the last evaluation
  std::size_t capacity = 0;                        ///< unknowns of a slot
};

/// Adds an unknown of an evaluation. One that was not there before has no difference.
struct RecordUnknown
{
  HistoryArrays of;
  bool compares;
  std::size_t slot, known;
  const double *x, *g, *y;

  BRINELL_HOST_DEVICE void operator()(std::size_t i) const
  {
    const double f = g[i] - x[i];
    const std::size_t to = slot * of.capacity + i;
    if (compares)
    {
      of.dg[to] = i < known ? g[i] - of.g[i] : 0.0;
      of.df[to] = i < known ? f - of.f[i] : 0.0;
      of.dy[to] = i < known ? y[i] - of.y[i] : 0.0;
    }
    of.g[i] = g[i];
    of.f[i] = f;
    of.y[i] = y[i];
  }
};

/// Sets what is new in a slot to zero.
struct ClearNew
{
  HistoryArrays of;
  std::size_t known, added;
  BRINELL_HOST_DEVICE void operator()(std::size_t n) const
  {
    const std::size_t to = n / added * of.capacity + known + n % added;
    of.dg[to] = of.df[to] = of.dy[to] = 0.0;
  }
};

/// Copies slots of a ring into a longer one.
struct MoveSlots
{
  const double* from;
  std::size_t of_from, slots, first; ///< values of a slot, slots, the slot that becomes the first one
  double* to;
  std::size_t of_to;
  BRINELL_HOST_DEVICE void operator()(std::size_t n) const
  {
    const std::size_t slot = n / of_from;
    to[slot * of_to + n % of_from] = from[(slot + first) % slots * of_from + n % of_from];
  }
};

using AndersonProducts = elastoplastic::AndersonWeights::Products;

/// Scalar products over every `pieces`-th unknown, for each difference.
struct ProductsOfPiece
{
  HistoryArrays of;
  std::size_t unknowns, pieces, slot;
  bool compares;
  AndersonProducts* sums; ///< [difference][piece]

  BRINELL_HOST_DEVICE void operator()(std::size_t n) const
  {
    const std::size_t d = n / pieces;
    const double *dy = of.dy + d * of.capacity, *df = of.df + d * of.capacity;
    const double *newest_dy = of.dy + slot * of.capacity, *newest_df = of.df + slot * of.capacity;
    AndersonProducts sum{};
    for (std::size_t i = n % pieces; i < unknowns; i += pieces)
    {
      if (compares)
      {
        sum.newest_flow += newest_dy[i] * df[i];
        sum.newest_residual += dy[i] * newest_df[i];
      }
      if (!compares || d == slot)
        sum.residual += dy[i] * of.f[i];
    }
    sums[n] = sum;
  }
};

inline constexpr std::size_t most_pieces_of_products = 8192,
                             last_pieces_of_products = 64; ///< enough threads, little to copy

/// Sums of pieces over every `last`-th piece.
struct ProductsOfPieces
{
  const AndersonProducts* of_pieces;
  std::size_t pieces, last;
  AndersonProducts* sums; ///< [difference][last piece]

  BRINELL_HOST_DEVICE void operator()(std::size_t n) const
  {
    AndersonProducts sum{};
    for (std::size_t piece = n % last; piece < pieces; piece += last)
    {
      const AndersonProducts& one = of_pieces[n / last * pieces + piece];
      sum.newest_flow += one.newest_flow;
      sum.newest_residual += one.newest_residual;
      sum.residual += one.residual;
    }
    sums[n] = sum;
  }
};

/// A value of the last evaluation less its weighted differences.
struct CombineUnknown
{
  const double *values, *differences, *weights;
  std::size_t count, capacity;
  double* out;
  BRINELL_HOST_DEVICE void operator()(std::size_t i) const
  {
    double value = values[i];
    for (std::size_t a = 0; a < count; ++a)
      value -= weights[a] * differences[a * capacity + i];
    out[i] = value;
  }
};

template <typename Executor>
class History
{
public:
  explicit History(const Executor& executor)
      : executor_(&executor), previous_g_(executor), previous_f_(executor), previous_y_(executor), scratch_(executor),
        weights_(executor), pieces_(executor), last_(executor)
  {
  }

  void reset() { known_ = used_ = 0; }
  /// @param depth  slots that are used from now on, not fewer than before
  /// @param first  of the slots used so far, that which becomes the first one
  void set_depth(std::size_t depth, std::size_t first)
  {
    if (depth > slots_ || first > 0)
      move(std::max(depth, slots_), capacity_, first);
    used_ = depth;
  }
  [[nodiscard]] std::vector<AndersonProducts> record(const elastoplastic::AndersonWeights::Entry& entry,
                                                     std::size_t unknowns, const double* x, const double* g,
                                                     const double* y)
  {
    grow(unknowns);
    executor_->run("unknowns of the acceleration", unknowns,
                   RecordUnknown{arrays(), entry.compares, entry.slot, known_, x, g, y});
    known_ = unknowns;
    return products(entry);
  }
  /// Sets the next trials.
  void combine(std::span<const double> weights, std::size_t unknowns, const double* g, double* x)
  {
    write(weights);
    executor_->run("next trials", unknowns,
                   CombineUnknown{g, dg_.data(), weights_.data(), weights.size(), capacity_, x});
  }
  [[nodiscard]] std::vector<double> residual(std::span<const double> weights)
  {
    write(weights);
    scratch_.grow(known_);
    executor_->run(
        "residual of the combination", known_,
        CombineUnknown{previous_f_.data(), df_.data(), weights_.data(), weights.size(), capacity_, scratch_.data()});
    std::vector<double> residual(known_);
    scratch_.read(known_, residual.data());
    return residual;
  }

private:
  using Array = typename Executor::template Memory<double>;

  [[nodiscard]] HistoryArrays arrays()
  {
    return {dg_.data(), df_.data(), dy_.data(), previous_g_.data(), previous_f_.data(), previous_y_.data(), capacity_};
  }
  void write(std::span<const double> weights)
  {
    weights_.grow(weights.size());
    weights_.write(weights);
  }
  void grow(std::size_t unknowns)
  {
    for (Growing<Executor, double>* field : {&previous_g_, &previous_f_, &previous_y_})
      field->grow(unknowns);
    if (unknowns > capacity_)
      move(slots_, std::max(unknowns, capacity_ + capacity_ / 2), 0);
    if (const std::size_t added = unknowns - known_; added > 0)
      executor_->run("new unknowns", slots_ * added, ClearNew{arrays(), known_, added});
  }
  void move(std::size_t slots, std::size_t capacity, std::size_t first)
  {
    for (Array* ring : {&dg_, &df_, &dy_})
    {
      Array longer = executor_->template allocate<double>(slots * capacity);
      executor_->run("longer history", used_ * capacity_,
                     MoveSlots{ring->data(), capacity_, used_, first, longer.data(), capacity});
      *ring = std::move(longer);
    }
    slots_ = slots;
    capacity_ = capacity;
  }
  [[nodiscard]] std::vector<AndersonProducts> products(const elastoplastic::AndersonWeights::Entry& entry)
  {
    constexpr std::size_t most = most_pieces_of_products, last = last_pieces_of_products;
    std::vector<AndersonProducts> sums(entry.known);
    const std::size_t pieces = std::min(known_, most);
    if (pieces == 0 || sums.empty())
      return sums;
    pieces_.grow(entry.known * pieces);
    last_.grow(entry.known * last);
    executor_->run("products of the acceleration", entry.known * pieces,
                   ProductsOfPiece{arrays(), known_, pieces, entry.slot, entry.compares, pieces_.data()});
    executor_->run("products of the acceleration", entry.known * last,
                   ProductsOfPieces{pieces_.data(), pieces, last, last_.data()});
    std::vector<AndersonProducts> parts(entry.known * last);
    last_.read(parts.size(), parts.data());
    for (std::size_t n = 0; n < parts.size(); ++n)
    {
      sums[n / last].newest_flow += parts[n].newest_flow;
      sums[n / last].newest_residual += parts[n].newest_residual;
      sums[n / last].residual += parts[n].residual;
    }
    return sums;
  }

  const Executor* executor_;
  std::size_t slots_ = 0, used_ = 0;     ///< of the rings, of which the first ones are used
  std::size_t capacity_ = 0, known_ = 0; ///< unknowns of a slot, unknowns recorded
  Array dg_{}, df_{}, dy_{};
  Growing<Executor, double> previous_g_, previous_f_, previous_y_, scratch_, weights_;
  Growing<Executor, AndersonProducts> pieces_, last_;
};

} // namespace brinell::device
