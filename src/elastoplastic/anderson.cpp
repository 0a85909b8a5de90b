// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/anderson.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <utility>

namespace brinell::elastoplastic
{

namespace
{

auto as_vector(const std::vector<double>& v)
{
  return Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Eigen::Index>(v.size()));
}

double product(const std::vector<double>& a, const std::vector<double>& b, std::span<const double> weights)
{
  if (weights.empty())
    return as_vector(a).dot(as_vector(b));
  const Eigen::Map<const Eigen::VectorXd> w(weights.data(), static_cast<Eigen::Index>(weights.size()));
  return as_vector(a).cwiseProduct(w).dot(as_vector(b));
}

} // namespace

Anderson::Anderson(int depth)
    : depth_(static_cast<std::size_t>(std::max(depth, 0))), dg_(depth_), df_(depth_), gram_(depth_ * depth_)
{
}

void Anderson::advance(std::span<double> x, std::span<const double> g, std::span<const double> weights)
{
  const bool compares = !std::exchange(changes_map_, false) && count_ > 0;
  if (depth_ > 0)
    remember(x, g, weights, compares);
  std::copy(g.begin(), g.end(), x.begin());
  if (depth_ > 0 && (compares || count_ == 0))
    ++count_;
  const std::size_t used = count_ > 0 ? std::min(count_ - 1, depth_) : 0;
  if (used == 0)
    return;

  const auto m = static_cast<Eigen::Index>(used);
  Eigen::MatrixXd gram(m, m);
  Eigen::VectorXd right(m);
  for (std::size_t a = 0; a < used; ++a)
  {
    const auto row = static_cast<Eigen::Index>(a);
    right(row) = product(df_[a], previous_f_, weights);
    for (std::size_t b = 0; b < used; ++b)
      gram(row, static_cast<Eigen::Index>(b)) = gram_[a * depth_ + b];
  }
  // Differences that have become parallel carry no information: damp them relative to the size of the system.
  gram.diagonal() *= 1.0 + 1e-12;
  const Eigen::VectorXd weight = gram.ldlt().solve(right);
  if (!weight.allFinite())
    return;
  for (std::size_t a = 0; a < used; ++a)
  {
    const double w = weight(static_cast<Eigen::Index>(a));
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] -= w * dg_[a][i];
  }
}

/// Adds the differences to the last evaluation to the history, and makes this evaluation the last.
/// @param compare  false: without the differences
void Anderson::remember(std::span<const double> x, std::span<const double> g, std::span<const double> weights,
                        bool compare)
{
  const std::size_t size = x.size();
  for (std::size_t i = previous_g_.size(); i < size; ++i)
  {
    previous_g_.push_back(g[i]);
    previous_f_.push_back(g[i] - x[i]);
  }
  for (std::size_t d = 0; d < depth_; ++d)
  {
    dg_[d].resize(size, 0.0);
    df_[d].resize(size, 0.0);
  }
  const std::size_t slot = count_ > 0 ? (count_ - 1) % depth_ : 0;
  for (std::size_t i = 0; i < size; ++i)
  {
    const double f = g[i] - x[i];
    if (compare)
    {
      dg_[slot][i] = g[i] - previous_g_[i];
      df_[slot][i] = f - previous_f_[i];
    }
    previous_g_[i] = g[i];
    previous_f_[i] = f;
  }
  for (std::size_t d = 0; compare && d < std::min(count_, depth_); ++d)
    gram_[slot * depth_ + d] = gram_[d * depth_ + slot] = product(df_[slot], df_[d], weights);
}

} // namespace brinell::elastoplastic
