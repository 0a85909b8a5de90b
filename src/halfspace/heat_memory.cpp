// SPDX-License-Identifier: BSD-3-Clause
#include "heat_memory.hpp"

#include "foundation/sharing.hpp"

#include <cmath>
#include <numbers>

namespace brinell::halfspace
{

namespace
{

/// Step of the trapezoidal rule in ln s. The integrand is analytic as far as |Im ln s| < pi/4: the error goes with
/// e^{-pi^2/(2 step)}, and is 1.3e-5 here.
constexpr double step = 0.4;
constexpr double fastest = 4.5; ///< s sqrt(kappa t): e^{-20} of it is left
constexpr double slowest = 0.02;

/// (1 - e^{-x})/x
/// @param left  e^{-x}
Complex mean_decay(Complex x, Complex left)
{
  if (std::norm(x) < 1e-6)
    return 1.0 - x * (0.5 - x * (1.0 / 6.0 - x / 24.0));
  return (1.0 - left) * std::conj(x) / std::norm(x);
}

/// Share of a wave in what is uniform in a cell, over which its phase changes by `angle`.
double cell_mean(double angle)
{
  return angle == 0.0 ? 1.0 : std::sin(0.5 * angle) / (0.5 * angle);
}

} // namespace

std::vector<DepthWave> depth_waves(double diffusivity, double shortest, double longest)
{
  const double first = fastest / std::sqrt(diffusivity * shortest);
  const double last = slowest / std::sqrt(diffusivity * longest);
  const int count = 1 + static_cast<int>(std::ceil(std::log(first / last) / step));
  constexpr double normal = 2.0 * std::numbers::inv_pi;
  std::vector<DepthWave> waves;
  for (int n = 0; n < count; ++n)
  {
    const double number = first * std::exp(-step * n);
    waves.push_back({number, normal * step * number});
  }
  // What follows does not decay over all these times: a geometric series.
  waves.push_back({0.0, waves.back().weight / std::expm1(step)});
  return waves;
}

HeatMemory::HeatMemory(const SurfaceGrid& grid, int px, int py, const SurfaceGrid& heated, const Thermal& thermal,
                       std::vector<DepthWave> waves)
    : fft_(grid, px, py), cell_x_(heated.dx), cell_y_(heated.dy), diffusivity_(thermal.diffusivity()),
      conductivity_(thermal.conductivity), waves_(std::move(waves)), heat_(waves_.size() * fft_.plane())
{
}

std::size_t HeatMemory::index(int row, int column) const
{
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(fft_.kx()) + static_cast<std::size_t>(column);
}

double HeatMemory::in_plane(int row, int column) const
{
  return diffusivity_ * (std::pow(fft_.wavenumber_x(column), 2) + std::pow(fft_.wavenumber_y(row), 2));
}

void HeatMemory::add_remaining(double duration, double factor, std::span<double> temperature) const
{
  AlignedVector<Complex> sum(fft_.plane());
  std::vector<double> left;
  left.reserve(waves_.size());
  for (const DepthWave& wave : waves_)
    left.push_back(factor * wave.weight * std::exp(-diffusivity_ * wave.number * wave.number * duration));
#pragma omp parallel for schedule(static) if (is_shared(fft_.plane()))
  for (int row = 0; row < fft_.py(); ++row)
    for (int i = 0; i < fft_.kx(); ++i)
    {
      const std::size_t at = index(row, i);
      Complex all{};
      for (std::size_t w = 0; w < waves_.size(); ++w)
        all += left[w] * heat_[w * fft_.plane() + at];
      sum[at] = std::exp(-in_plane(row, i) * duration) * all;
    }
  AlignedVector<double> scratch(fft_.scratch_size());
  std::vector<double> field(grid().size());
  fft_.inverse(sum.data(), field.data(), scratch);
  for (std::size_t n = 0; n < field.size(); ++n)
    temperature[n] += field[n];
}

void HeatMemory::take_up(std::span<const double> flux, const HeatMotion& motion)
{
  AlignedVector<Complex> spectrum(fft_.plane());
  AlignedVector<double> scratch(fft_.scratch_size());
  fft_.forward(flux.data(), spectrum.data(), scratch);
  const double duration = motion.duration;
  const double scale = diffusivity_ / conductivity_ * duration;
  std::vector<double> rates, left_in_depth;
  for (const DepthWave& wave : waves_)
  {
    rates.push_back(diffusivity_ * wave.number * wave.number * duration);
    left_in_depth.push_back(std::exp(-rates.back()));
  }
#pragma omp parallel for schedule(static) if (is_shared(fft_.plane()))
  for (int row = 0; row < fft_.py(); ++row)
    for (int i = 0; i < fft_.kx(); ++i)
    {
      // The shortest wave of an even number of cells cannot tell where it goes.
      const double way_x = 2 * i == fft_.px() ? 0.0 : fft_.wavenumber_x(i) * motion.velocity_x;
      const double way_y = 2 * row == fft_.py() ? 0.0 : fft_.wavenumber_y(row) * motion.velocity_y;
      const Complex in_plane_rate{in_plane(row, i) * duration, -(way_x + way_y) * duration};
      const double left = std::exp(-in_plane_rate.real());
      const Complex left_moved = left * Complex{std::cos(in_plane_rate.imag()), -std::sin(in_plane_rate.imag())};
      const std::size_t at = index(row, i);
      const Complex in = scale * cell_mean(fft_.wavenumber_x(i) * cell_x_) *
                         cell_mean(fft_.wavenumber_y(row) * cell_y_) * spectrum[at];
      for (std::size_t w = 0; w < waves_.size(); ++w)
      {
        Complex& heat = heat_[w * fft_.plane() + at];
        heat =
            left * left_in_depth[w] * heat + mean_decay(rates[w] + in_plane_rate, left_in_depth[w] * left_moved) * in;
      }
    }
}

} // namespace brinell::halfspace
