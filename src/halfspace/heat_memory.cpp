// SPDX-License-Identifier: BSD-3-Clause
#include "heat_memory.hpp"

#include "foundation/sharing.hpp"

#include <cmath>
#include <numbers>

namespace brinell::halfspace
{

namespace
{

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

DepthFactors depth_factors(const DepthWaves& waves, double depth)
{
  DepthFactors factors{depth, {}, {}};
  const auto add = [&](const DepthWave& wave)
  {
    const TurnedWave turned = turned_wave(wave.number * depth, waves.step);
    factors.temperature.push_back(wave.weight * turned.cosine);
    factors.slope.push_back(-wave.weight * wave.number * turned.sine);
  };
  for (const DepthWave& wave : waves.fast)
    add(wave);
  for (const DepthWave& wave : waves.waves)
    add(wave);
  return factors;
}

/// What the waves in depth add up to, column by column.
struct HeatMemory::Row
{
  std::vector<SurfaceWave> waves;
  std::vector<HeatAtDepth> sums;
};

HeatMemory::HeatMemory(const SurfaceGrid& grid, int px, int py, const Thermal& thermal, DepthWaves waves)
    : fft_(grid, px, py), diffusivity_(thermal.diffusivity()), conductivity_(thermal.conductivity),
      waves_(std::move(waves)), heat_(waves_.waves.size() * fft_.plane()),
      last_flux_(waves_.fast.empty() ? 0 : fft_.plane())
{
  if (!waves_.has_fields)
    return;
  slow_share_.resize(fft_.plane());
  for (int row = 0; row < fft_.py(); ++row)
    for (int i = 0; i < fft_.kx(); ++i)
      slow_share_[index(row, i)] = waves_.slow_share(surface_wave(row, i).k);
}

std::size_t HeatMemory::index(int row, int column) const
{
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(fft_.kx()) + static_cast<std::size_t>(column);
}

double HeatMemory::in_plane(int row, int column) const
{
  return diffusivity_ * (std::pow(fft_.wavenumber_x(column), 2) + std::pow(fft_.wavenumber_y(row), 2));
}

SurfaceWave HeatMemory::surface_wave(int row, int column) const
{
  const double kx = fft_.wavenumber_x(column), ky = fft_.wavenumber_y(row);
  return {kx, ky, std::hypot(kx, ky), 2 * column == fft_.px() ? 0.0 : kx, 2 * row == fft_.py() ? 0.0 : ky};
}

void HeatMemory::add_remaining(double duration, double factor, const SurfaceGrid& heated,
                               std::span<double> temperature) const
{
  AlignedVector<Complex> sum(fft_.plane());
  std::vector<double> left;
  left.reserve(waves_.waves.size());
  for (const DepthWave& wave : waves_.waves)
    left.push_back(factor * wave.weight * std::exp(-diffusivity_ * wave.number * wave.number * duration));
#pragma omp parallel for schedule(static) if (is_shared(fft_.plane()))
  for (int row = 0; row < fft_.py(); ++row)
    for (int i = 0; i < fft_.kx(); ++i)
    {
      const std::size_t at = index(row, i);
      Complex all{};
      for (std::size_t w = 0; w < waves_.waves.size(); ++w)
        all += left[w] * heat_[w * fft_.plane() + at];
      sum[at] = std::exp(-in_plane(row, i) * duration) * cell_mean(fft_.wavenumber_x(i) * heated.dx) *
                cell_mean(fft_.wavenumber_y(row) * heated.dy) * all;
    }
  AlignedVector<double> scratch(fft_.scratch_size());
  std::vector<double> field(grid().size());
  fft_.inverse(sum.data(), field.data(), scratch);
  for (std::size_t n = 0; n < field.size(); ++n)
    temperature[n] += field[n];
}

void HeatMemory::gather(int row, double duration, const DepthFactors& factors, Row& row_sums) const
{
  const auto columns = static_cast<std::size_t>(fft_.kx());
  const std::size_t at = index(row, 0), slowest = waves_.waves.size() - 1;
  // Factors are those of all waves, of which this memory has the last ones.
  const std::size_t skipped = factors.temperature.size() - waves_.waves.size();
  for (std::size_t w = 0; w < slowest; ++w)
  {
    const DepthWave& wave = waves_.waves[w];
    const double s2 = wave.number * wave.number, left = std::exp(-diffusivity_ * s2 * duration);
    const double of_temperature = left * factors.temperature[skipped + w], of_slope = left * factors.slope[skipped + w],
                 at_surface = left * wave.weight;
    const Complex* heat = heat_.data() + w * fft_.plane() + at;
    for (std::size_t i = 0; i < columns; ++i)
    {
      const double k = row_sums.waves[i].k, inverse = 1.0 / (k * k + s2);
      HeatAtDepth& sum = row_sums.sums[i];
      sum.temperature += of_temperature * heat[i];
      sum.slope += of_slope * inverse * heat[i];
      sum.potential += of_temperature * k * inverse * heat[i];
      sum.potential_at_surface += at_surface * k * inverse * heat[i];
    }
  }
  // Waves that are slower: cos(s z) = 1, s sin(s z) = s^2 z.
  const double weight = waves_.waves.back().weight;
  const Complex* heat = heat_.data() + slowest * fft_.plane() + at;
  for (std::size_t i = 0; i < columns; ++i)
  {
    const double k = row_sums.waves[i].k, share = slow_share_[at + i];
    HeatAtDepth& sum = row_sums.sums[i];
    sum.temperature += weight * heat[i];
    sum.slope -= factors.depth * (weight - k * share) * heat[i];
    sum.potential += share * heat[i];
    sum.potential_at_surface += share * heat[i];
  }
}

/// The fast waves have come to rest in the flux of the last step.
void HeatMemory::gather_fast(int row, const DepthFactors& factors, Row& row_sums) const
{
  for (std::size_t w = 0; w < waves_.fast.size(); ++w)
  {
    const DepthWave& wave = waves_.fast[w];
    const bool is_last = w + 1 == waves_.fast.size();
    const double s2 = wave.number * wave.number;
    // At the surface those beyond the last count, too: the temperature goes with 1/s^2, the potential with 1/s^4.
    const double more = is_last && factors.depth == 0.0 ? waves_.beyond(2) : 0.0;
    const double more_of_potential = is_last ? waves_.beyond(4) : 0.0;
    const double of_temperature = factors.temperature[w], of_slope = factors.slope[w];
    for (std::size_t i = 0; i < row_sums.sums.size(); ++i)
    {
      const SurfaceWave& surface = row_sums.waves[i];
      const double way = surface.odd_x * last_motion_.velocity_x + surface.odd_y * last_motion_.velocity_y;
      const double inverse = 1.0 / (surface.k * surface.k + s2);
      const Complex rate{diffusivity_ * (surface.k * surface.k + s2), -way};
      const Complex heat = diffusivity_ / conductivity_ * last_flux_[index(row, static_cast<int>(i))] *
                           std::conj(rate) / std::norm(rate);
      HeatAtDepth& sum = row_sums.sums[i];
      sum.temperature += (1.0 + more) * of_temperature * heat;
      sum.slope += of_slope * inverse * heat;
      sum.potential +=
          (1.0 + (factors.depth == 0.0 ? more_of_potential : 0.0)) * of_temperature * surface.k * inverse * heat;
      sum.potential_at_surface += (1.0 + more_of_potential) * wave.weight * surface.k * inverse * heat;
    }
  }
}

void HeatMemory::add_fields(double duration, double factor, const DepthFactors& factors,
                            const FieldsOfHeat& fields_of_heat, std::vector<std::vector<double>>& fields) const
{
  std::vector<AlignedVector<Complex>> spectra(fields.size(), AlignedVector<Complex>(fft_.plane()));
#pragma omp parallel for schedule(static) if (is_shared(fft_.plane()))
  for (int row = 0; row < fft_.py(); ++row)
  {
    Row sums;
    for (int i = 0; i < fft_.kx(); ++i)
      sums.waves.push_back(surface_wave(row, i));
    sums.sums.resize(sums.waves.size());
    gather(row, duration, factors, sums);
    if (duration == 0.0)
      gather_fast(row, factors, sums);
    std::vector<Complex> values(fields.size());
    for (std::size_t i = 0; i < sums.sums.size(); ++i)
    {
      const SurfaceWave& wave = sums.waves[i];
      const double left = factor * std::exp(-diffusivity_ * wave.k * wave.k * duration);
      fields_of_heat(wave, sums.sums[i], values);
      for (std::size_t f = 0; f < values.size(); ++f)
        spectra[f][index(row, static_cast<int>(i))] = left * values[f];
    }
  }
  AlignedVector<double> scratch(fft_.scratch_size());
  std::vector<double> field(grid().size());
  for (std::size_t f = 0; f < fields.size(); ++f)
  {
    fft_.inverse(spectra[f].data(), field.data(), scratch);
    for (std::size_t n = 0; n < field.size(); ++n)
      fields[f][n] += field[n];
  }
}

void HeatMemory::take_up(std::span<const double> flux, const HeatMotion& motion)
{
  AlignedVector<Complex> spectrum(fft_.plane());
  AlignedVector<double> scratch(fft_.scratch_size());
  fft_.forward(flux.data(), spectrum.data(), scratch);
  last_motion_ = motion;
  const double duration = motion.duration;
  const double scale = diffusivity_ / conductivity_ * duration;
  std::vector<double> rates, left_in_depth;
  for (const DepthWave& wave : waves_.waves)
  {
    rates.push_back(diffusivity_ * wave.number * wave.number * duration);
    left_in_depth.push_back(std::exp(-rates.back()));
  }
#pragma omp parallel for schedule(static) if (is_shared(fft_.plane()))
  for (int row = 0; row < fft_.py(); ++row)
    for (int i = 0; i < fft_.kx(); ++i)
    {
      const SurfaceWave wave = surface_wave(row, i);
      const double way = wave.odd_x * motion.velocity_x + wave.odd_y * motion.velocity_y;
      const Complex in_plane_rate{in_plane(row, i) * duration, -way * duration};
      const double left = std::exp(-in_plane_rate.real());
      const Complex left_moved = left * Complex{std::cos(in_plane_rate.imag()), -std::sin(in_plane_rate.imag())};
      const std::size_t at = index(row, i);
      const Complex in = scale * spectrum[at];
      for (std::size_t w = 0; w < waves_.waves.size(); ++w)
      {
        Complex& heat = heat_[w * fft_.plane() + at];
        heat =
            left * left_in_depth[w] * heat + mean_decay(rates[w] + in_plane_rate, left_in_depth[w] * left_moved) * in;
      }
    }
  if (!last_flux_.empty())
    last_flux_ = std::move(spectrum);
}

} // namespace brinell::halfspace
