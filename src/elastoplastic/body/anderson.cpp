// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/anderson.hpp"

#include "foundation/matrix.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace brinell::elastoplastic
{

namespace
{

/// a . b over the unknowns [first, last).
double product(const std::vector<double>& a, const std::vector<double>& b, std::size_t first, std::size_t last)
{
  return scalar_product({a.data() + first, last - first}, {b.data() + first, last - first});
}

/// Products of a piece, or of all pieces.
struct Products
{
  std::vector<AndersonWeights::Products> of;

  Products& operator+=(const Products& other)
  {
    for (std::size_t d = 0; d < of.size(); ++d)
    {
      of[d].newest_flow += other.of[d].newest_flow;
      of[d].newest_residual += other.of[d].newest_residual;
      of[d].residual += other.of[d].residual;
    }
    if (of.empty())
      of = other.of;
    return *this;
  }
};

/// Sum of part(first, last) over the pieces of all ranks in their order.
/// @param size   number of own unknowns
/// @param known  number of differences
template <typename Part>
Products sum_of_all_pieces(const Communicator& ranks, std::size_t size, std::size_t known, const Part& part)
{
  constexpr std::size_t numbers = 3;
  const std::size_t pieces = (size + piece_size - 1) / piece_size;
  std::vector<double> sums(pieces * known * numbers);
  for_pieces(size,
             [&](std::size_t first, std::size_t last)
             {
               const Products own = part(first, last);
               double* to = sums.data() + first / piece_size * known * numbers;
               for (const AndersonWeights::Products& d : own.of)
                 for (const double number : {d.newest_flow, d.newest_residual, d.residual})
                   *to++ = number;
             });
  const std::vector<double> all = ranks.joined(sums);
  const std::vector<std::size_t> counts = ranks.all_counts(pieces);
  std::vector<std::size_t> next(counts.size());
  for (std::size_t rank = 1; rank < next.size(); ++rank)
    next[rank] = next[rank - 1] + counts[rank - 1];
  Products total{};
  for (std::size_t piece = 0, rank = 0; piece < std::accumulate(counts.begin(), counts.end(), std::size_t{0});
       ++piece, rank = (rank + 1) % counts.size())
  {
    const double* from = all.data() + next[rank]++ * known * numbers;
    Products of_piece{std::vector<AndersonWeights::Products>(known)};
    for (std::size_t d = 0; d < known; ++d, from += numbers)
      of_piece.of[d] = {from[0], from[1], from[2]};
    total += of_piece;
  }
  return total;
}

} // namespace

AndersonWeights::Entry AndersonWeights::next()
{
  Entry entry{.compares = !std::exchange(changes_map_, false) && count_ > 0};
  if (depth_ == 0)
    return entry;
  entry.slot = count_ > 0 ? (count_ - 1) % depth_ : 0;
  entry.known = std::min(count_, depth_);
  if (entry.compares || count_ == 0)
    ++count_;
  return entry;
}

void AndersonWeights::add(const Entry& entry, std::span<const Products> of_differences)
{
  for (std::size_t d = 0; d < entry.known; ++d)
  {
    if (entry.compares)
    {
      products_[entry.slot * depth_ + d] = of_differences[d].newest_flow;
      products_[d * depth_ + entry.slot] = of_differences[d].newest_residual;
    }
    if (entry.compares && d != entry.slot) // f has changed by the newest df
      right_[d] += products_[d * depth_ + entry.slot];
    else
      right_[d] = of_differences[d].residual;
  }
}

std::vector<double> AndersonWeights::weights() const
{
  const std::size_t used = count_ > 0 ? std::min(count_ - 1, depth_) : 0;
  if (used == 0)
    return {};
  const int m = static_cast<int>(used);
  Matrix products(m, m);
  for (int a = 0; a < m; ++a)
    for (int b = 0; b < m; ++b)
      products(a, b) = products_[static_cast<std::size_t>(a) * depth_ + static_cast<std::size_t>(b)];
  for (int a = 0; a < m; ++a)
    products(a, a) *= 1.0 + damping_;
  std::vector<double> weight = solve(products, {right_.data(), used});
  const bool is_finite = std::all_of(weight.begin(), weight.end(), [](double w) { return std::isfinite(w); });
  return is_finite ? weight : std::vector<double>();
}

AndersonWeights::Moved AndersonWeights::deepen(int depth, double damping)
{
  damping_ = damping;
  const auto deeper = static_cast<std::size_t>(std::max(depth, 0));
  if (depth_ == 0 || deeper <= depth_)
    return {0, depth_};
  const std::size_t known = count_ > 0 ? std::min(count_ - 1, depth_) : 0;
  const std::size_t oldest = known == depth_ ? (count_ - 1) % depth_ : 0;
  const auto slot = [&](std::size_t age) { return (oldest + age) % depth_; };
  std::vector<double> products(deeper * deeper), right(deeper);
  for (std::size_t a = 0; a < known; ++a)
  {
    right[a] = right_[slot(a)];
    for (std::size_t b = 0; b < known; ++b)
      products[a * deeper + b] = products_[slot(a) * depth_ + slot(b)];
  }
  products_.swap(products);
  right_.swap(right);
  count_ = count_ > 0 ? known + 1 : 0;
  depth_ = deeper;
  return {oldest, depth_};
}

Anderson::Anderson(int depth, const Communicator* ranks)
    : weights_(static_cast<std::size_t>(std::max(depth, 0))), ranks_(ranks), dg_(weights_.depth()),
      df_(weights_.depth()), dy_(weights_.depth())
{
}

void Anderson::advance(std::span<double> x, std::span<const double> g, std::span<const double> y)
{
  const AndersonWeights::Entry entry = weights_.next();
  if (weights_.depth() > 0)
    record(x, g, y, entry);
  if (gives_up_ && entry.compares && weights_.depth() > 0 && stands_still(entry.slot))
    weights_.keep_last();
  weight_ = weights_.weights();
  for_pieces(x.size(),
             [&](std::size_t first, std::size_t last)
             {
               std::copy(g.begin() + first, g.begin() + last, x.begin() + first);
               for (std::size_t a = 0; a < weight_.size(); ++a)
                 for (std::size_t i = first; i < last; ++i)
                   x[i] -= weight_[a] * dg_[a][i];
             });
}

/// Whether the last evaluation has told nothing: its residual is that of the one before. The same step would follow again and again where something undoes
/// it, such as a trial that is put back on the yield surface, after g has changed for another reason than x.
bool Anderson::stands_still(std::size_t slot) const
{
  constexpr double nothing = 1e-5; // of the largest residual
  double residual = 0.0, change = 0.0;
  for (std::size_t i = 0; i < previous_f_.size(); ++i)
  {
    residual = std::max(residual, std::abs(previous_f_[i]));
    change = std::max(change, std::abs(df_[slot][i]));
  }
  if (ranks_ != nullptr)
  {
    residual = ranks_->largest(residual);
    change = ranks_->largest(change);
  }
  return change <= nothing * residual;
}

std::vector<double> Anderson::residual() const
{
  std::vector<double> f(previous_f_);
  for_pieces(f.size(),
             [&](std::size_t first, std::size_t last)
             {
               for (std::size_t a = 0; a < weight_.size(); ++a)
                 for (std::size_t i = first; i < last; ++i)
                   f[i] -= weight_[a] * df_[a][i];
             });
  return f;
}

void Anderson::deepen(int depth, double damping)
{
  const AndersonWeights::Moved moved = weights_.deepen(depth, damping);
  if (moved.depth == dg_.size())
    return;
  for (std::vector<std::vector<double>>* differences : {&dg_, &df_, &dy_})
  {
    std::rotate(differences->begin(), differences->begin() + static_cast<std::ptrdiff_t>(moved.first),
                differences->end());
    differences->resize(moved.depth, std::vector<double>(previous_g_.size()));
  }
}

/// Makes room for new unknowns; their differences to the previous evaluation are zero.
void Anderson::grow(std::span<const double> x, std::span<const double> g, std::span<const double> y)
{
  for (std::size_t i = previous_g_.size(); i < x.size(); ++i)
  {
    previous_g_.push_back(g[i]);
    previous_f_.push_back(g[i] - x[i]);
    previous_y_.push_back(y[i]);
  }
  for (std::vector<std::vector<double>>* differences : {&dg_, &df_, &dy_})
    for (std::vector<double>& d : *differences)
      d.resize(x.size(), 0.0);
}

/// Adds the differences from the previous evaluation to the history, and stores this evaluation as the previous one.
void Anderson::record(std::span<const double> x, std::span<const double> g, std::span<const double> y,
                      const AndersonWeights::Entry& entry)
{
  grow(x, g, y);
  const auto [compares, slot, known] = entry;
  const auto update_piece = [&, compares = compares, slot = slot, known = known](std::size_t first, std::size_t last)
  {
    for (std::size_t i = first; i < last; ++i)
    {
      const double f = g[i] - x[i];
      if (compares)
      {
        dg_[slot][i] = g[i] - previous_g_[i];
        df_[slot][i] = f - previous_f_[i];
        dy_[slot][i] = y[i] - previous_y_[i];
      }
      previous_g_[i] = g[i];
      previous_f_[i] = f;
      previous_y_[i] = y[i];
    }
    Products sums{std::vector<AndersonWeights::Products>(known)};
    for (std::size_t d = 0; d < known; ++d)
    {
      if (compares)
      {
        sums.of[d].newest_flow = product(dy_[slot], df_[d], first, last);
        sums.of[d].newest_residual = product(dy_[d], df_[slot], first, last);
      }
      if (!compares || d == slot)
        sums.of[d].residual = product(dy_[d], previous_f_, first, last);
    }
    return sums;
  };
  Products sums = ranks_ == nullptr ? sum_of_pieces(x.size(), update_piece)
                                    : sum_of_all_pieces(*ranks_, x.size(), known, update_piece);
  if (sums.of.empty())
    sums.of.resize(known);
  weights_.add(entry, sums.of);
}

} // namespace brinell::elastoplastic
