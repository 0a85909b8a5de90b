// SPDX-License-Identifier: BSD-3-Clause
#include "depth_waves.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace brinell::halfspace
{

namespace
{

/// Steps of the trapezoidal rule in ln s. The integrand is analytic for |Im ln s| < pi/4, so the error is proportional to
/// e^{-pi^2/(2 step)}; it is 1.3e-5 at the surface. At depth it is proportional to the square root of this factor, and about as
/// large with the finer step.
constexpr double step_of_surface = 0.4, step_of_fields = 0.22;
constexpr double fastest = 4.5; ///< s sqrt(kappa t) of the fastest wave, which has decayed to e^{-20}
constexpr double slowest = 0.02;
constexpr double normal = 2.0 * std::numbers::inv_pi;

} // namespace

DepthWaves depth_waves(double diffusivity, const DepthRange& range, double finest)
{
  const bool has_fields = range.deepest >= 0.0;
  DepthWaves result;
  result.has_fields = has_fields;
  result.step = has_fields ? step_of_fields : step_of_surface;
  // For s far above every k, the contributions of faster waves are a geometric series.
  constexpr double far = 20.0;
  const double lasting = fastest / std::sqrt(diffusivity * range.shortest);
  const double first = has_fields ? far * std::max(finest, 0.1 * lasting) : lasting;
  const double last = slowest / std::max(std::sqrt(diffusivity * range.longest), range.deepest);
  const int count = std::max(1, 1 + static_cast<int>(std::ceil(std::log(first / last) / result.step)));
  for (int n = 0; n < count; ++n)
  {
    const double number = first * std::exp(-result.step * n);
    result.waves.push_back({number, normal * result.step * number});
  }
  // Slower waves do not decay during the longest time: their weights are a geometric series.
  result.waves.push_back({0.0, result.waves.back().weight / std::expm1(result.step)});
  return result;
}

DepthWaves DepthWaves::slower_than(double number) const
{
  // At least one wave with s > 0 remains, from which the sum over the slowest waves continues.
  const auto first = std::find_if(waves.begin(), std::prev(waves.end(), 2),
                                  [&](const DepthWave& wave) { return wave.number < number; });
  return {{first, waves.end()}, step, has_fields};
}

double DepthWaves::slow_share(double k) const
{
  if (k == 0.0)
    return 1.0;
  constexpr double negligible = 1e-3; // s/k below which (s/k)^2 is neglected
  double sum = 0.0, number = std::prev(waves.end(), 2)->number;
  do
  {
    number *= std::exp(-step);
    sum += normal * step * number * k / (k * k + number * number);
  } while (number > negligible * k);
  return sum + normal * step * number / (k * std::expm1(step));
}

double DepthWaves::beyond(int power) const
{
  return 1.0 / std::expm1((power - 1) * step);
}

namespace
{

// Off the real axis, along u + i angle, e^{ix} decays and the integral ends.
constexpr double angle = 0.3;

} // namespace

TurnedWaves::TurnedWaves(double step) : spacing_(step / points_per_step)
{
  // The mean with a kernel K(u) over u = ln x. Its transform is 1 up to frequencies somewhat below pi/step and 0 beyond: only
  // frequencies that samples at intervals of `step` can resolve are retained.
  constexpr double softness = 0.2, widths = 10.0;
  const double band = std::numbers::pi / step, width = 1.0 / (softness * band);
  first_ = -widths * width;
  for (double u = first_; u <= -first_; u += spacing_)
  {
    const std::complex<double> shifted{u, angle};
    const std::complex<double> stretch = std::exp(shifted);
    const std::complex<double> kernel =
        std::sin(band * shifted) / (std::numbers::pi * shifted) * std::exp(-0.25 * shifted * shifted / (width * width));
    points_.push_back({spacing_ * kernel * stretch, spacing_ * kernel * stretch * stretch});
  }
}

std::vector<TurnedWave> TurnedWaves::operator()(double largest, std::size_t count) const
{
  if (largest == 0.0)
    return std::vector<TurnedWave>(count, {1.0, 0.0});
  constexpr double too_often = 300.0; // the mean is below 1e-10
  constexpr double nothing = 40.0;
  // e^{ix} at the points of the path for all n, on one common row of points: those for the n-th value of x begin
  // `points_per_step` * n points before those for the first one.
  const std::size_t before = points_per_step * (count - 1);
  std::vector<std::complex<double>> turned;
  for (std::size_t m = 0; m < before + points_.size(); ++m)
  {
    const double x = largest * std::exp(first_ + spacing_ * (static_cast<double>(m) - static_cast<double>(before)));
    if (x * std::sin(angle) > nothing)
      break;
    turned.push_back(std::polar(std::exp(-x * std::sin(angle)), x * std::cos(angle)));
  }
  std::vector<TurnedWave> means(count, {0.0, 0.0});
  for (std::size_t n = 0; n < count; ++n)
  {
    if (largest * std::exp(-spacing_ * static_cast<double>(points_per_step * n)) > too_often)
      continue;
    const std::size_t first = before - points_per_step * n;
    for (std::size_t j = 0; j < points_.size() && first + j < turned.size(); ++j)
    {
      const std::complex<double>&of_cosine = points_[j].of_cosine, &of_sine = points_[j].of_sine;
      const std::complex<double>& value = turned[first + j];
      means[n].cosine += value.real() * of_cosine.real() - value.imag() * of_cosine.imag();
      means[n].sine += value.real() * of_sine.imag() + value.imag() * of_sine.real();
    }
  }
  return means;
}

} // namespace brinell::halfspace
