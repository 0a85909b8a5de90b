// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/anderson.hpp"

#include "foundation/sharing.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <utility>

namespace brinell::elastoplastic
{

namespace
{

/// a . b over the unknowns [first, last).
double product(const std::vector<double>& a, const std::vector<double>& b, std::size_t first, std::size_t last)
{
  using Vector = Eigen::Map<const Eigen::VectorXd>;
  const auto size = static_cast<Eigen::Index>(last - first);
  return Vector(a.data() + first, size).dot(Vector(b.data() + first, size));
}

/// Scalar products for each difference d (one row each): newest dy with df of d, dy of d with the newest df, dy of d with f.
struct Products
{
  enum : Eigen::Index
  {
    newest_flow,
    newest_residual,
    residual,
    count
  };
  Eigen::Array<double, Eigen::Dynamic, count> rows;

  Products& operator+=(const Products& other)
  {
    if (rows.size() == 0)
      rows = other.rows;
    else
      rows += other.rows;
    return *this;
  }
};

} // namespace

Anderson::Anderson(int depth)
    : depth_(static_cast<std::size_t>(std::max(depth, 0))), dg_(depth_), df_(depth_), dy_(depth_),
      products_(depth_ * depth_), right_(depth_)
{
}

void Anderson::advance(std::span<double> x, std::span<const double> g, std::span<const double> y)
{
  const bool compares = !std::exchange(changes_map_, false) && count_ > 0;
  if (depth_ > 0)
    record(x, g, y, compares);
  if (depth_ > 0 && (compares || count_ == 0))
    ++count_;
  weight_ = weights(count_ > 0 ? std::min(count_ - 1, depth_) : 0);
  for_pieces(x.size(),
             [&](std::size_t first, std::size_t last)
             {
               std::copy(g.begin() + first, g.begin() + last, x.begin() + first);
               for (std::size_t a = 0; a < weight_.size(); ++a)
                 for (std::size_t i = first; i < last; ++i)
                   x[i] -= weight_[a] * dg_[a][i];
             });
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

/// Weights of the differences dg in the next x; empty if the system has no finite solution.
std::vector<double> Anderson::weights(std::size_t used) const
{
  if (used == 0)
    return {};
  const auto m = static_cast<Eigen::Index>(used);
  Eigen::MatrixXd products(m, m);
  for (std::size_t a = 0; a < used; ++a)
    for (std::size_t b = 0; b < used; ++b)
      products(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) = products_[a * depth_ + b];
  // Differences that have become parallel carry no information: damp them relative to the size of the system.
  products.diagonal() *= 1.0 + 1e-12;
  const Eigen::VectorXd weight = products.partialPivLu().solve(Eigen::Map<const Eigen::VectorXd>(right_.data(), m));
  return weight.allFinite() ? std::vector<double>(weight.begin(), weight.end()) : std::vector<double>();
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
/// @param compare  false: no differences are added
void Anderson::record(std::span<const double> x, std::span<const double> g, std::span<const double> y, bool compare)
{
  grow(x, g, y);
  const std::size_t slot = count_ > 0 ? (count_ - 1) % depth_ : 0;
  const std::size_t known = std::min(count_, depth_); // differences in the history, including a new one
  const auto update_piece = [&](std::size_t first, std::size_t last)
  {
    for (std::size_t i = first; i < last; ++i)
    {
      const double f = g[i] - x[i];
      if (compare)
      {
        dg_[slot][i] = g[i] - previous_g_[i];
        df_[slot][i] = f - previous_f_[i];
        dy_[slot][i] = y[i] - previous_y_[i];
      }
      previous_g_[i] = g[i];
      previous_f_[i] = f;
      previous_y_[i] = y[i];
    }
    Products sums{Eigen::Array<double, Eigen::Dynamic, Products::count>::Zero(static_cast<Eigen::Index>(known), 3)};
    for (std::size_t d = 0; d < known; ++d)
    {
      const auto row = static_cast<Eigen::Index>(d);
      if (compare)
      {
        sums.rows(row, Products::newest_flow) = product(dy_[slot], df_[d], first, last);
        sums.rows(row, Products::newest_residual) = product(dy_[d], df_[slot], first, last);
      }
      if (!compare || d == slot)
        sums.rows(row, Products::residual) = product(dy_[d], previous_f_, first, last);
    }
    return sums;
  };
  Products sums = sum_of_pieces(x.size(), update_piece);
  if (x.empty())
    sums.rows.setZero(static_cast<Eigen::Index>(known), Products::count);
  for (std::size_t d = 0; d < known; ++d)
  {
    const auto row = static_cast<Eigen::Index>(d);
    if (compare)
    {
      products_[slot * depth_ + d] = sums.rows(row, Products::newest_flow);
      products_[d * depth_ + slot] = sums.rows(row, Products::newest_residual);
    }
    if (compare && d != slot) // f has changed by the newest df
      right_[d] += products_[d * depth_ + slot];
    else
      right_[d] = sums.rows(row, Products::residual);
  }
}

} // namespace brinell::elastoplastic
