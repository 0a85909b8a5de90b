// SPDX-License-Identifier: BSD-3-Clause
#include "heat_memory.hpp"

#include "foundation/lane_functions.hpp"
#include "foundation/require_size.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::halfspace
{

namespace
{

/// Share of a wave in what is uniform in a cell, over which its phase changes by `angle`.
double cell_mean(double angle)
{
  return angle == 0.0 ? 1.0 : std::sin(0.5 * angle) / (0.5 * angle);
}

} // namespace

HeatMemory::HeatMemory(const SurfaceGrid& grid, int px, int py, const Thermal& thermal, DepthWaves waves,
                       Symmetry symmetry, const std::shared_ptr<const LayeredConduction>& layers)
    : fft_(grid, px, py, symmetry), diffusivity_(thermal.diffusivity()), conductivity_(thermal.conductivity),
      waves_(std::move(waves)), heat_(waves_.waves.size() * fft_.plane())
{
  const PaddedFft& fft = fft_.all();
  for (int row = 0; row < fft_.rows(); ++row)
    for (int i = 0; i < fft.kx(); ++i)
    {
      const double kx = fft.wavenumber_x(i), ky = fft.wavenumber_y(row);
      along_.push_back({kx, ky, std::hypot(kx, ky), 2 * i == px ? 0.0 : kx, 2 * row == py ? 0.0 : ky});
    }
  if (waves_.has_fields)
    for (const SurfaceWave& wave : along_)
      slow_share_.push_back(waves_.slow_share(wave.k));
  if (layers)
    buried_.emplace(layers, along_, fft_.plane(), diffusivity_);
}

std::span<const SurfaceWave> HeatMemory::row_of_waves(int row) const
{
  return std::span(along_).subspan(begin_of(row), columns());
}

std::vector<double> HeatMemory::left_in_depth(double duration) const
{
  std::vector<double> left;
  for (const DepthWave& wave : waves_.waves)
    left.push_back(std::exp(-diffusivity_ * wave.number * wave.number * duration));
  return left;
}

void HeatMemory::add_remaining(double duration, double factor, const SurfaceGrid& heated,
                               std::span<double> temperature) const
{
  std::vector<AlignedVector<Complex>> sums(1, AlignedVector<Complex>(fft_.plane()));
  AlignedVector<Complex>& sum = sums.front();
  const std::vector<double> left = left_in_depth(duration);
  constexpr double nothing = 1e-20;
#pragma omp parallel for schedule(static) if (is_shared(fft_.plane()))
  for (int row = 0; row < fft_.rows(); ++row)
  {
    const std::span<const SurfaceWave> along = row_of_waves(row);
    auto* all = reinterpret_cast<double*>(sum.data() + begin_of(row));
    for (std::size_t w = 0; w < waves_.waves.size(); ++w)
    {
      if (left[w] <= nothing)
        continue;
      const auto* heat = reinterpret_cast<const double*>(heat_.data() + w * fft_.plane() + begin_of(row));
      const double weight = factor * waves_.waves[w].weight * left[w];
#pragma omp simd
      for (std::size_t n = 0; n < 2 * along.size(); ++n)
        all[n] += weight * heat[n];
    }
    const double mean_y = cell_mean(along.front().ky * heated.dy);
    for (std::size_t i = 0; i < along.size(); ++i)
      sum[begin_of(row) + i] *=
          std::exp(-diffusivity_ * along[i].k * along[i].k * duration) * cell_mean(along[i].kx * heated.dx) * mean_y;
  }
  fft_.inverse(sums, {false}, true, {temperature});
}

HeatMemory::RowEnd HeatMemory::row_end(int row, double duration, double factor) const
{
  const std::span<const SurfaceWave> along = row_of_waves(row);
  const std::size_t at = begin_of(row);
  RowEnd end{std::vector<double>(along.size(), factor),
             std::span(heat_).subspan((waves_.waves.size() - 1) * fft_.plane() + at, along.size()),
             std::span(slow_share_).subspan(at, along.size())};
  for (std::size_t i = 0; i < along.size() && duration > 0.0; ++i)
    end.left[i] *= std::exp(-diffusivity_ * along[i].k * along[i].k * duration);
  return end;
}

namespace
{

std::span<Complex> complex_values(AlignedVector<double>& parts, std::size_t first, std::size_t count)
{
  return parts.empty() ? std::span<Complex>{} : std::span(reinterpret_cast<Complex*>(parts.data() + first), count);
}

} // namespace

/// The slowest waves hardly turn in depth: cos(s z) = 1, s sin(s z) = s^2 z.
void HeatMemory::finish_surface(std::span<const SurfaceWave> along, const RowEnd& end, DepthSums::Row& sums) const
{
  const std::span<Complex> potential = complex_values(sums.at_surface, 0, along.size());
  for (std::size_t i = 0; i < along.size(); ++i)
    potential[i] = end.left[i] * (along[i].k * potential[i] + end.slow_share[i] * end.slowest[i]);
}

/// @param number  of the depth among those together
void HeatMemory::finish(double depth, std::span<const SurfaceWave> along, const RowEnd& end, std::size_t number,
                        DepthSums::Row& sums) const
{
  const std::size_t first = number * sums.pitch;
  const std::span<Complex> temperature = complex_values(sums.temperature, first, along.size());
  const std::span<Complex> potential = complex_values(sums.potential, first, along.size());
  const std::span<Complex> slope = complex_values(sums.slope, first, along.size());
  const double weight = waves_.waves.back().weight;
  for (std::size_t i = 0; i < along.size(); ++i)
  {
    const double k = along[i].k, share = end.slow_share[i];
    const Complex heat = end.slowest[i];
    temperature[i] = end.left[i] * (temperature[i] + weight * heat);
    potential[i] = end.left[i] * (k * potential[i] + share * heat);
    slope[i] = end.left[i] * (slope[i] - (depth * (weight - k * share)) * heat);
  }
}

/// What the heat in the body adds to the sums at one depth.
/// @param columns  that the sums have so far
void HeatMemory::add_buried_row(double depth, double factor, std::size_t columns, std::size_t number, Row& sums) const
{
  DepthSums::Row& row = sums.of_surface;
  const std::size_t first = number * row.pitch, parts = sums.buried.parts;
  for (AlignedVector<double>* sum : {&row.temperature, &row.potential, &row.slope})
    std::fill(sum->begin() + static_cast<std::ptrdiff_t>(first + 2 * columns),
              sum->begin() + static_cast<std::ptrdiff_t>(first + parts), 0.0);
  buried_->add(depth, factor, sums.buried,
               {row.temperature.data() + first, row.potential.data() + first, row.slope.data() + first});
}

void HeatMemory::add_row(int row, const RowOfFields& wanted, Row& sums) const
{
  const std::span<const SurfaceWave> along = row_of_waves(row);
  const RowEnd end = row_end(row, wanted.duration, wanted.factor);
  DepthSums::Row& of_surface = sums.of_surface;
  wanted.sums.gather(along, heat_.data() + begin_of(row), fft_.plane(), of_surface);
  finish_surface(along, end, of_surface);
  if (wanted.has_buried)
  {
    if (wanted.sums.has_layers())
      buried_->gather(begin_of(row), along.size(), sums.buried);
    buried_->add_potential_at_surface(begin_of(row), along.size(), wanted.factor,
                                      complex_values(of_surface.at_surface, 0, along.size()).data());
  }
  const std::size_t count = wanted.spectra.size() / wanted.depths.size();
  std::vector<Complex*> out(count);
  for (std::size_t first = 0; first < wanted.depths.size(); first += DepthSums::together)
  {
    const double least = wanted.depths[first].depth;
    if (wanted.sums.has_layers())
      wanted.sums.sum(first, columns_that_reach(least, along), of_surface);
    for (std::size_t d = first; d < std::min(first + DepthSums::together, wanted.depths.size()); ++d)
    {
      const double depth = wanted.depths[d].depth;
      std::size_t columns = columns_that_reach(depth, along);
      const std::size_t at = (d - first) * of_surface.pitch;
      if (wanted.sums.has_layers())
        finish(depth, along.first(columns), end, d - first, of_surface);
      if (wanted.sums.has_layers() && wanted.has_buried)
      {
        add_buried_row(depth, wanted.factor, columns, d - first, sums);
        columns = along.size();
      }
      for (std::size_t f = 0; f < count; ++f)
        out[f] = wanted.spectra[d * count + f].data() + begin_of(row);
      wanted.fields_of_heat.waves({depth, along.first(columns), complex_values(of_surface.temperature, at, columns),
                                   complex_values(of_surface.potential, at, columns),
                                   complex_values(of_surface.slope, at, columns),
                                   complex_values(of_surface.at_surface, 0, columns)},
                                  out);
    }
  }
}

void HeatMemory::fields(double duration, double factor, std::span<const DepthFactors> depths,
                        const FieldsOfHeat& fields_of_heat, const std::vector<std::span<double>>& out, bool adds) const
{
  std::vector<AlignedVector<Complex>> spectra(out.size(), AlignedVector<Complex>(fft_.plane()));
  const DepthSums sums(waves_.waves, depths, left_in_depth(duration));
  const bool has_buried = buried_ && !buried_->is_cold();
  const RowOfFields wanted{duration, factor, has_buried, sums, depths, fields_of_heat, spectra};
#pragma omp parallel if (is_shared(fft_.plane()))
  {
    Row of_row{sums.make_row(columns())};
    if (has_buried)
      of_row.buried = buried_->make_row(columns());
#pragma omp for schedule(static)
    for (int row = 0; row < fft_.rows(); ++row)
      add_row(row, wanted, of_row);
  }
  fft_.inverse(spectra, fields_of_heat.is_odd, adds, out);
}

namespace
{

/// What the waves along the surface do to a flux in one step: real and imaginary parts apart, of a whole plane.
struct FluxInPlane
{
  std::vector<double> rate, turn;             ///< in the plane, z = rate + i turn, both times the duration
  std::vector<double> left, left_re, left_im; ///< e^{-rate} and e^{-z}
  std::vector<double> in_re, in_im;           ///< heat that comes in
};

/// @param scale  of the spectrum of the flux [K m]
FluxInPlane flux_in_plane(std::span<const SurfaceWave> along, const AlignedVector<Complex>& flux, double scale,
                          double diffusivity, const HeatMotion& motion)
{
  FluxInPlane plane;
  for (std::vector<double>* part :
       {&plane.rate, &plane.turn, &plane.left, &plane.left_re, &plane.left_im, &plane.in_re, &plane.in_im})
    part->resize(flux.size());
#pragma omp parallel for schedule(static) if (is_shared(flux.size()))
  for (std::size_t i = 0; i < along.size(); ++i)
  {
    const SurfaceWave& wave = along[i];
    const double way = (wave.odd_x * motion.velocity_x + wave.odd_y * motion.velocity_y) * motion.duration;
    plane.rate[i] = diffusivity * wave.k * wave.k * motion.duration;
    plane.turn[i] = -way;
    plane.left[i] = std::exp(-plane.rate[i]);
    plane.left_re[i] = plane.left[i] * std::cos(way);
    plane.left_im[i] = plane.left[i] * std::sin(way);
    plane.in_re[i] = scale * flux[i].real();
    plane.in_im[i] = scale * flux[i].imag();
  }
  return plane;
}

/// One wave in depth takes up its neighbours in the plane: remains before + (1 - e^{-x})/x in, with x = rate + z.
/// @param decays  whether what was there has decayed; otherwise all of it stays
ComplexLanes taken_up(const FluxInPlane& plane, std::size_t i, double rate, double left_in_depth, bool decays,
                      const ComplexLanes& before)
{
  const auto of = [i](const std::vector<double>& part) { return load_lanes(part.data() + i); };
  const Lanes x = rate + of(plane.rate), y = of(plane.turn), norm = x * x + y * y;
  // (1 - e^{-x})/x, by its series where x is small.
  const auto is_small = norm < 1e-6;
  const Lanes inverse = 1.0 / (is_small ? Lanes{} + 1.0 : norm);
  const Lanes a = 1.0 - left_in_depth * of(plane.left_re), b = -left_in_depth * of(plane.left_im);
  const Lanes square_re = x * x - y * y, square_im = 2.0 * x * y;
  const Lanes gain_re = is_small ? 1.0 - 0.5 * x + square_re * (1.0 / 6.0) : (a * x + b * y) * inverse;
  const Lanes gain_im = is_small ? -0.5 * y + square_im * (1.0 / 6.0) : (b * x - a * y) * inverse;
  const Lanes remains = decays ? left_in_depth * of(plane.left) : Lanes{} + 1.0;
  const Lanes in_re = of(plane.in_re), in_im = of(plane.in_im);
  return {remains * before.re + gain_re * in_re - gain_im * in_im,
          remains * before.im + gain_re * in_im + gain_im * in_re};
}

} // namespace

void HeatMemory::take_up(std::span<const double> flux, const HeatMotion& motion, AlignedVector<Complex>* before)
{
  if (before == nullptr)
    return take_up_from(heat_, flux, motion, true);
  before->resize(heat_.size());
  heat_.swap(*before);
  take_up_from(*before, flux, motion, true);
}

void HeatMemory::take_up_in_body(const std::vector<std::vector<double>>& rise, double duration)
{
  std::vector<AlignedVector<Complex>> spectra;
  spectra.reserve(rise.size());
  for (const std::vector<double>& layer : rise)
    spectra.push_back(layer.empty() ? AlignedVector<Complex>{} : fft_.forward(layer));
  buried_->take_up(spectra, duration);
}

void HeatMemory::add_buried(double factor, std::span<double> temperature) const
{
  if (!buried_ || buried_->is_cold())
    return;
  std::vector<AlignedVector<Complex>> spectra(1, AlignedVector<Complex>(fft_.plane()));
  buried_->add_surface(0, along_.size(), spectra.front().data());
  for (Complex& wave : spectra.front())
    wave *= factor;
  fft_.inverse(spectra, {false}, true, {temperature});
}

std::vector<double> HeatMemory::whole(const AlignedVector<Complex>& planes) const
{
  const std::size_t all = fft_.all().plane();
  AlignedVector<Complex> plane(all);
  std::vector<double> values;
  values.reserve(2 * planes.size() / fft_.plane() * all);
  for (std::size_t at = 0; at < planes.size(); at += fft_.plane())
  {
    fft_.complete(planes.data() + at, plane.data());
    const auto* parts = reinterpret_cast<const double*>(plane.data());
    values.insert(values.end(), parts, parts + 2 * all);
  }
  return values;
}

AlignedVector<Complex> HeatMemory::told(std::span<const double> values) const
{
  const std::size_t all = 2 * fft_.all().plane(), planes = values.size() / all;
  AlignedVector<Complex> told(planes * fft_.plane());
  for (std::size_t p = 0; p < planes; ++p)
    std::copy_n(values.data() + p * all, 2 * columns() * static_cast<std::size_t>(fft_.rows()),
                reinterpret_cast<double*>(told.data() + p * fft_.plane()));
  return told;
}

std::vector<double> HeatMemory::whole_heat() const
{
  return whole(heat_);
}

void HeatMemory::set_whole_heat(std::span<const double> values)
{
  require_size("HeatMemory::set_whole_heat: the heat", values, 2 * waves_.waves.size() * fft_.all().plane());
  heat_ = told(values);
}

std::vector<double> HeatMemory::whole_heat_in_body() const
{
  return buried_ && !buried_->is_cold() ? whole(buried_->modes()) : std::vector<double>{};
}

void HeatMemory::set_whole_heat_in_body(std::span<const double> values)
{
  if (!buried_)
    return;
  require_size("HeatMemory::set_whole_heat_in_body: the heat", values,
               values.empty() ? 0 : 2 * buried_->layers().size() * fft_.all().plane());
  buried_->set_modes(told(values));
}

void HeatMemory::amend(std::span<const double> flux, const HeatMotion& motion)
{
  take_up_from(heat_, flux, motion, false);
}

/// @param before  the heat itself, or all of it as it was
void HeatMemory::take_up_from(const AlignedVector<Complex>& before, std::span<const double> flux,
                              const HeatMotion& motion, bool decays)
{
  const AlignedVector<Complex> spectrum = fft_.forward(flux);
  const double scale = diffusivity_ / conductivity_ * motion.duration;
  const std::vector<double> left = left_in_depth(motion.duration);
  const FluxInPlane plane = flux_in_plane(along_, spectrum, scale, diffusivity_, motion);
  const std::size_t waves = waves_.waves.size();
#pragma omp parallel for schedule(static) if (is_shared(fft_.plane()))
  for (std::size_t w = 0; w < waves; ++w)
  {
    const double rate = diffusivity_ * std::pow(waves_.waves[w].number, 2) * motion.duration;
    for (std::size_t i = 0; i < fft_.plane(); i += lane_count) // a plane has whole cache lines
    {
      const std::size_t at = w * fft_.plane() + i;
      store_lanes(taken_up(plane, i, rate, left[w], decays, load_lanes(before.data() + at)), heat_.data() + at);
    }
  }
}

} // namespace brinell::halfspace
