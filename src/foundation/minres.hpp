// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace brinell
{

/// Iterations of `minres`, and the residual they leave.
struct MinresReport
{
  int iterations = 0;
  double residual = 0.0; ///< norm of b - A x relative to that of b
};

/// Solves A x = b, with A symmetric and definite or not, by the minimal residual method (Paige and Saunders 1975). A may be singular if b
/// has no part that A cannot reach.
/// @param apply      apply(x, y) sets y = A x
/// @param dot        dot(a, b), the scalar product in which A is symmetric
/// @param x          guess, and result; zero costs no product
/// @param tolerance  of the residual relative to b
template <typename Apply, typename Dot>
MinresReport minres(const Apply& apply, const Dot& dot, std::span<const double> b, std::span<double> x,
                    double tolerance, int most_iterations)
{
  const std::size_t n = b.size();
  using Vector = std::vector<double>;
  const auto norm = [&](const Vector& v) { return std::sqrt(dot(v, v)); };
  const double of_b = std::sqrt(dot(b, b));
  if (of_b == 0.0)
  {
    std::fill(x.begin(), x.end(), 0.0);
    return {};
  }
  Vector v(n), v_before(n), w(n), w_before(n), next(n);
  if (std::any_of(x.begin(), x.end(), [](double value) { return value != 0.0; }))
    apply(std::span<const double>(x), std::span<double>(next));
  for (std::size_t i = 0; i < n; ++i)
    v[i] = b[i] - next[i];
  double beta = norm(v), left = beta;
  for (std::size_t i = 0; i < n && beta > 0.0; ++i)
    v[i] /= beta;
  beta = 0.0;                                              // of the step before the first one
  double c = 1.0, c_before = 1.0, s = 0.0, s_before = 0.0; // rotations
  MinresReport report{0, left / of_b};
  while (report.residual > tolerance && report.iterations < most_iterations)
  {
    apply(std::span<const double>(v), std::span<double>(next));
    const double alpha = dot(v, next);
    for (std::size_t i = 0; i < n; ++i)
      next[i] -= alpha * v[i] + beta * v_before[i];
    const double beta_next = norm(next);
    const double diagonal = c * alpha - c_before * s * beta;
    const double above = s * alpha + c_before * c * beta, far_above = s_before * beta;
    const double turned = std::hypot(diagonal, beta_next);
    ++report.iterations;
    if (turned == 0.0) // A cannot reach what is left
      return report;
    c_before = c;
    s_before = s;
    c = diagonal / turned;
    s = beta_next / turned;
    for (std::size_t i = 0; i < n; ++i)
    {
      const double direction = (v[i] - far_above * w_before[i] - above * w[i]) / turned;
      w_before[i] = w[i];
      w[i] = direction;
      x[i] += c * left * direction;
      v_before[i] = v[i];
      v[i] = beta_next > 0.0 ? next[i] / beta_next : 0.0;
    }
    left *= -s;
    beta = beta_next;
    report.residual = std::abs(left) / of_b;
  }
  return report;
}

} // namespace brinell
