// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/anderson.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <utility>

namespace brinell::elastoplastic
{

namespace
{

double product(const std::vector<double>& a, const std::vector<double>& b)
{
  using Vector = Eigen::Map<const Eigen::VectorXd>;
  const auto size = static_cast<Eigen::Index>(a.size());
  return Vector(a.data(), size).dot(Vector(b.data(), size));
}

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
    remember(x, g, y, compares);
  std::copy(g.begin(), g.end(), x.begin());
  if (depth_ > 0 && (compares || count_ == 0))
    ++count_;
  const std::size_t used = count_ > 0 ? std::min(count_ - 1, depth_) : 0;
  if (used == 0)
    return;

  const auto m = static_cast<Eigen::Index>(used);
  Eigen::MatrixXd products(m, m);
  for (std::size_t a = 0; a < used; ++a)
    for (std::size_t b = 0; b < used; ++b)
      products(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) = products_[a * depth_ + b];
  // Differences that have become parallel carry no information: damp them relative to the size of the system.
  products.diagonal() *= 1.0 + 1e-12;
  const Eigen::VectorXd weight = products.partialPivLu().solve(Eigen::Map<const Eigen::VectorXd>(right_.data(), m));
  if (!weight.allFinite())
    return;
  for (std::size_t a = 0; a < used; ++a)
  {
    const double w = weight(static_cast<Eigen::Index>(a));
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] -= w * dg_[a][i];
  }
}

/// Unknowns that have come in have no differences to the evaluation before.
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

/// Adds the differences to the last evaluation to the history, and makes this evaluation the last.
/// @param compare  false: without the differences
void Anderson::remember(std::span<const double> x, std::span<const double> g, std::span<const double> y, bool compare)
{
  grow(x, g, y);
  const std::size_t slot = count_ > 0 ? (count_ - 1) % depth_ : 0;
  for (std::size_t i = 0; i < x.size(); ++i)
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
  const std::size_t known = std::min(count_, depth_); // the new one included, if there is
  for (std::size_t d = 0; compare && d < known; ++d)
  {
    products_[slot * depth_ + d] = product(dy_[slot], df_[d]);
    products_[d * depth_ + slot] = d == slot ? products_[slot * depth_ + d] : product(dy_[d], df_[slot]);
  }
  for (std::size_t d = 0; d < known; ++d)
    if (compare && d != slot) // the residual has changed by df
      right_[d] += products_[d * depth_ + slot];
    else
      right_[d] = product(dy_[d], previous_f_);
}

} // namespace brinell::elastoplastic
