// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/anderson.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

namespace brinell::elastoplastic
{

Anderson::Anderson(int depth) : depth_(static_cast<std::size_t>(std::max(depth, 0))), dx_(depth_), df_(depth_) {}

void Anderson::advance(std::span<double> x, std::span<const double> g)
{
  const auto as_vector = [](const std::vector<double>& v)
  { return Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Eigen::Index>(v.size())); };
  if (depth_ == 0)
  {
    std::copy(g.begin(), g.end(), x.begin());
    return;
  }
  const std::size_t size = x.size();
  for (std::size_t i = previous_x_.size(); i < size; ++i)
  {
    previous_x_.push_back(x[i]);
    previous_f_.push_back(g[i] - x[i]);
  }
  for (std::size_t d = 0; d < depth_; ++d)
  {
    dx_[d].resize(size, 0.0);
    df_[d].resize(size, 0.0);
  }
  std::vector<double>& f = previous_f_; // overwritten by this residual below
  if (count_ > 0)
  {
    const std::size_t slot = (count_ - 1) % depth_;
    for (std::size_t i = 0; i < size; ++i)
    {
      dx_[slot][i] = x[i] - previous_x_[i];
      df_[slot][i] = (g[i] - x[i]) - previous_f_[i];
    }
  }
  for (std::size_t i = 0; i < size; ++i)
  {
    previous_x_[i] = x[i];
    f[i] = g[i] - x[i];
  }
  const std::size_t used = std::min(count_, depth_);
  ++count_;
  std::copy(g.begin(), g.end(), x.begin());
  if (used == 0)
    return;

  const auto m = static_cast<Eigen::Index>(used);
  Eigen::MatrixXd gram(m, m);
  Eigen::VectorXd right(m);
  for (Eigen::Index a = 0; a < m; ++a)
  {
    const auto fa = as_vector(df_[static_cast<std::size_t>(a)]);
    right(a) = fa.dot(as_vector(f));
    for (Eigen::Index b = 0; b <= a; ++b)
      gram(a, b) = gram(b, a) = fa.dot(as_vector(df_[static_cast<std::size_t>(b)]));
  }
  // Differences that have become parallel carry no information: damp them relative to the size of the system.
  gram.diagonal() *= 1.0 + 1e-12;
  const Eigen::VectorXd weight = gram.ldlt().solve(right);
  if (!weight.allFinite())
    return;
  for (std::size_t a = 0; a < used; ++a)
  {
    const double w = weight(static_cast<Eigen::Index>(a));
    for (std::size_t i = 0; i < size; ++i)
      x[i] -= w * (dx_[a][i] + df_[a][i]);
  }
}

} // namespace brinell::elastoplastic
