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
  DepthFactors factors{depth, {}, {}, {}, {}};
  for (const DepthWave& wave : waves.waves)
  {
    const TurnedWave turned = turned_wave(wave.number * depth, waves.step);
    factors.temperature.push_back(wave.weight * turned.cosine);
    factors.potential.push_back(wave.weight * turned.cosine);
    factors.slope.push_back(-wave.weight * wave.number * turned.sine);
    factors.at_surface.push_back(wave.weight);
  }
  // Of a flux that they are at rest in, waves faster than the first have 1/s^2; the potential, 1/s^4. Only at the surface they count.
  const double more = 1.0 + waves.beyond(4);
  factors.at_surface.front() *= more;
  if (depth == 0.0)
  {
    factors.temperature.front() *= 1.0 + waves.beyond(2);
    factors.potential.front() *= more;
  }
  return factors;
}

/// What the waves in depth add up to at one depth in one row, column by column; real and imaginary parts in turn.
struct HeatMemory::Sums
{
  std::vector<double> temperature, potential, slope; ///< the potential without its factor k

  explicit Sums(std::size_t parts) : temperature(parts), potential(parts), slope(parts) {}
  /// One wave in depth.
  /// @param heat, integrated  of the wave, and divided by k^2 + s^2
  void add(const double* heat, const double* integrated, double of_temperature, double of_potential, double of_slope)
  {
#pragma omp simd
    for (std::size_t n = 0; n < temperature.size(); ++n)
    {
      temperature[n] += of_temperature * heat[n];
      potential[n] += of_potential * integrated[n];
      slope[n] += of_slope * integrated[n];
    }
  }
};

/// One row of waves, and their sums at some depths.
struct HeatMemory::Row
{
  std::vector<SurfaceWave> waves;
  std::vector<Sums> sums;
  std::vector<double> at_surface; ///< potential without its factor k, the same for all depths

  [[nodiscard]] HeatAtDepth at(std::size_t depth, std::size_t i) const
  {
    const auto value = [i](const std::vector<double>& parts) { return Complex{parts[2 * i], parts[2 * i + 1]}; };
    const Sums& all = sums[depth];
    const double k = waves[i].k;
    return {value(all.temperature), k * value(all.potential), value(all.slope), k * value(at_surface)};
  }
};

HeatMemory::HeatMemory(const SurfaceGrid& grid, int px, int py, const Thermal& thermal, DepthWaves waves)
    : fft_(grid, px, py), diffusivity_(thermal.diffusivity()), conductivity_(thermal.conductivity),
      waves_(std::move(waves)), heat_(waves_.waves.size() * fft_.plane())
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

HeatMemory::Row HeatMemory::gather(int row, double duration, std::span<const DepthFactors> depths) const
{
  const auto columns = static_cast<std::size_t>(fft_.kx());
  Row result{{}, std::vector<Sums>(depths.size(), Sums(2 * columns)), std::vector<double>(2 * columns)};
  std::vector<double> k2(2 * columns), integrated(2 * columns);
  for (std::size_t i = 0; i < columns; ++i)
  {
    result.waves.push_back(surface_wave(row, static_cast<int>(i)));
    k2[2 * i] = k2[2 * i + 1] = std::pow(result.waves[i].k, 2);
  }
  // Factors are those of all waves, of which this memory has the last ones.
  const std::size_t skipped = depths.front().temperature.size() - waves_.waves.size();
  const std::size_t slowest = waves_.waves.size() - 1;
  constexpr double nothing = 1e-20;
  for (std::size_t w = 0; w < slowest; ++w)
  {
    const double s2 = std::pow(waves_.waves[w].number, 2), left = std::exp(-diffusivity_ * s2 * duration);
    if (left <= nothing)
      continue;
    const auto* heat = reinterpret_cast<const double*>(heat_.data() + w * fft_.plane() + index(row, 0));
    const std::size_t f = skipped + w;
    const double of_surface = left * depths.front().at_surface[f];
#pragma omp simd
    for (std::size_t n = 0; n < k2.size(); ++n)
    {
      integrated[n] = heat[n] / (k2[n] + s2);
      result.at_surface[n] += of_surface * integrated[n];
    }
    for (std::size_t d = 0; d < depths.size(); ++d)
      result.sums[d].add(heat, integrated.data(), left * depths[d].temperature[f], left * depths[d].potential[f],
                         left * depths[d].slope[f]);
  }
  return result;
}

/// Waves that hardly turn in depth: cos(s z) = 1, s sin(s z) = s^2 z.
void HeatMemory::add_slowest(std::size_t at, double k, double depth, HeatAtDepth& sum) const
{
  const double weight = waves_.waves.back().weight, share = slow_share_[at];
  const Complex heat = heat_[(waves_.waves.size() - 1) * fft_.plane() + at];
  sum.temperature += weight * heat;
  sum.slope -= depth * (weight - k * share) * heat;
  sum.potential += share * heat;
  sum.potential_at_surface += share * heat;
}

void HeatMemory::add_fields(double duration, double factor, std::span<const DepthFactors> depths,
                            const FieldsOfHeat& fields_of_heat, std::vector<std::vector<double>>& fields) const
{
  const std::size_t count = fields.size() / depths.size();
  std::vector<AlignedVector<Complex>> spectra(fields.size(), AlignedVector<Complex>(fft_.plane()));
#pragma omp parallel for schedule(static) if (is_shared(fft_.plane()))
  for (int row = 0; row < fft_.py(); ++row)
  {
    const Row gathered = gather(row, duration, depths);
    std::vector<Complex> values(count);
    for (std::size_t i = 0; i < gathered.waves.size(); ++i)
    {
      const SurfaceWave& wave = gathered.waves[i];
      const std::size_t at = index(row, static_cast<int>(i));
      const double left = factor * std::exp(-diffusivity_ * wave.k * wave.k * duration);
      for (std::size_t d = 0; d < depths.size(); ++d)
      {
        HeatAtDepth heat = gathered.at(d, i);
        add_slowest(at, wave.k, depths[d].depth, heat);
        fields_of_heat(depths[d].depth, wave, heat, values);
        for (std::size_t f = 0; f < count; ++f)
          spectra[d * count + f][at] = left * values[f];
      }
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

void HeatMemory::take_up(std::span<const double> flux, const HeatMotion& motion, bool decays)
{
  AlignedVector<Complex> spectrum(fft_.plane());
  AlignedVector<double> scratch(fft_.scratch_size());
  fft_.forward(flux.data(), spectrum.data(), scratch);
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
        const double remains = decays ? left * left_in_depth[w] : 1.0;
        heat = remains * heat + mean_decay(rates[w] + in_plane_rate, left_in_depth[w] * left_moved) * in;
      }
    }
}

} // namespace brinell::halfspace
