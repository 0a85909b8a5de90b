// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/green/spread_cell.hpp"

#include <cmath>
#include <numbers>

namespace brinell::green
{

namespace
{

constexpr double negligible = 6.0; ///< e^{-6^2} is below rounding

/// Fourier series, for cells that have spread over a large part of the period.
double spread_waves(double x, double half_size, double spread, double period)
{
  const double share = 2.0 * half_size / period;
  double sum = share;
  for (int n = 1; n * std::numbers::pi * spread < negligible * period; ++n)
  {
    const double angle = n * std::numbers::pi * share;
    sum += 2.0 * share * std::sin(angle) / angle * std::cos(2.0 * n * std::numbers::pi * x / period) *
           std::exp(-std::pow(n * std::numbers::pi * spread / period, 2));
  }
  return sum;
}

} // namespace

double spread_cell(double x, double half_size, double spread)
{
  // Far from the cell both terms are nearly 1 and only their difference counts.
  const double near = (std::abs(x) - half_size) / spread;
  const double far = (std::abs(x) + half_size) / spread;
  return near > 0.0 ? 0.5 * (std::erfc(near) - std::erfc(far)) : 0.5 * (std::erf(far) - std::erf(near));
}

double spread_cells(double x, double half_size, double spread, double period)
{
  if (spread > 0.5 * period)
    return spread_waves(x, half_size, spread, period);
  const double from_nearest = std::remainder(x, period);
  const int copies = static_cast<int>(std::ceil((negligible * spread + half_size) / period));
  double sum = 0.0;
  for (int n = -copies; n <= copies; ++n)
    sum += spread_cell(from_nearest + n * period, half_size, spread);
  return sum;
}

} // namespace brinell::green
