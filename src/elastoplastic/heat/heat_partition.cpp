// SPDX-License-Identifier: BSD-3-Clause
#include "heat_partition.hpp"

#include "foundation/sharing.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::elastoplastic
{

namespace
{

double largest(const std::vector<double>& field)
{
  double value = 0.0;
  for (const double v : field)
    value = std::max(value, std::abs(v));
  return value;
}

void zero_unpressed(const std::vector<bool>& pressed, std::vector<double>& field)
{
  for (std::size_t i = 0; i < field.size(); ++i)
    if (!pressed[i])
      field[i] = 0.0;
}

} // namespace

bool solve_in_cells(const FieldOperator& A, std::span<const double> b, const std::vector<bool>& pressed,
                    double tolerance, std::vector<double>& x)
{
  constexpr int max_iterations = 500;
  const std::size_t cells = b.size();
  std::vector<double> r(cells), p(cells), v(cells), t(cells);
  const auto apply = [&](const std::vector<double>& in, std::vector<double>& out)
  {
    A(in, out);
    zero_unpressed(pressed, out);
  };
  zero_unpressed(pressed, x);
  apply(x, r);
  for (std::size_t i = 0; i < cells; ++i)
    r[i] = pressed[i] ? b[i] - r[i] : 0.0;
  const std::vector<double> shadow = r;
  double rho = dot(shadow, r);
  p = r;
  for (int n = 0; n < max_iterations; ++n)
  {
    if (largest(r) <= tolerance)
      return true;
    apply(p, v);
    const double alpha = rho / dot(shadow, v);
    for (std::size_t i = 0; i < cells; ++i)
    {
      x[i] += alpha * p[i];
      r[i] -= alpha * v[i];
    }
    if (largest(r) <= tolerance)
      return true;
    apply(r, t);
    const double omega = dot(t, r) / dot(t, t);
    for (std::size_t i = 0; i < cells; ++i)
    {
      x[i] += omega * r[i];
      r[i] -= omega * t[i];
    }
    const double before = rho;
    rho = dot(shadow, r);
    const double beta = rho / before * (alpha / omega);
    if (!std::isfinite(beta))
      return largest(r) <= tolerance;
    for (std::size_t i = 0; i < cells; ++i)
      p[i] = r[i] + beta * (p[i] - omega * v[i]);
  }
  return false;
}

} // namespace brinell::elastoplastic
