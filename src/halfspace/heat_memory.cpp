// SPDX-License-Identifier: BSD-3-Clause
#include "heat_memory.hpp"

#include "foundation/lane_functions.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

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
  const PlaneOfWaves& all = fft_.all();
  for (int row = 0; row < fft_.rows(); ++row)
    for (int i = 0; i < all.kx(); ++i)
    {
      const double kx = all.wavenumber_x(i), ky = all.wavenumber_y(row);
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
  AlignedVector<Complex> sum(fft_.plane() + ToldRowsFft::slack);
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
  const ToldRowsFft::Told told{sum.data(), fft_.all().kx()};
  fft_.inverse({&told, 1}, {false}, true, {temperature});
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

/// Real and imaginary parts in turn.
const double* parts_of(std::span<const Complex> values)
{
  return reinterpret_cast<const double*>(values.data());
}

} // namespace

/// The slowest waves hardly turn in depth: cos(s z) = 1, s sin(s z) = s^2 z.
void HeatMemory::finish_surface(std::span<const SurfaceWave> along, const RowEnd& end, DepthSums::Row& sums) const
{
  const double *left = end.left.data(), *share = end.slow_share.data(), *heat = parts_of(end.slowest);
  double* potential = sums.at_surface.data();
#pragma omp simd
  for (std::size_t i = 0; i < along.size(); ++i)
    for (std::size_t part = 2 * i; part < 2 * i + 2; ++part)
      potential[part] = left[i] * (along[i].k * potential[part] + share[i] * heat[part]);
}

/// @param number  of the depth among those together
void HeatMemory::finish(double depth, std::span<const SurfaceWave> along, const RowEnd& end, std::size_t number,
                        DepthSums::Row& sums) const
{
  const std::size_t first = number * sums.pitch;
  double *temperature = sums.temperature.data() + first, *potential = sums.potential.data() + first,
         *slope = sums.slope.data() + first;
  const double *left = end.left.data(), *share = end.slow_share.data(), *heat = parts_of(end.slowest);
  const double weight = waves_.waves.back().weight;
#pragma omp simd
  for (std::size_t i = 0; i < along.size(); ++i)
  {
    const double k = along[i].k, of_slope = depth * (weight - k * share[i]);
    for (std::size_t part = 2 * i; part < 2 * i + 2; ++part)
    {
      temperature[part] = left[i] * (temperature[part] + weight * heat[part]);
      potential[part] = left[i] * (k * potential[part] + share[i] * heat[part]);
      slope[part] = left[i] * (slope[part] - of_slope * heat[part]);
    }
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
  sums.decay.begin();
  for (std::size_t first = 0; first < wanted.depths.size(); first += DepthSums::together)
  {
    const auto group = wanted.depths.subspan(first, std::min(DepthSums::together, wanted.depths.size() - first));
    const auto by_depth = [](const DepthFactors& a, const DepthFactors& b) { return a.depth < b.depth; };
    if (wanted.sums.has_layers()) // depths may be in any order
      wanted.sums.sum(first, columns_that_reach(std::min_element(group.begin(), group.end(), by_depth)->depth, along),
                      of_surface);
    for (std::size_t d = first; d < first + group.size(); ++d)
    {
      const double depth = wanted.depths[d].depth;
      std::size_t columns = columns_that_reach(depth, along);
      if (wanted.sums.has_layers())
        finish(depth, along.first(columns), end, d - first, of_surface);
      if (wanted.sums.has_layers() && wanted.has_buried)
      {
        add_buried_row(depth, wanted.factor, columns, d - first, sums);
        columns = along.size();
      }
      put_fields(row, d, columns, wanted, sums);
    }
  }
}

/// The fields of a row at one depth from its sums.
void HeatMemory::put_fields(int row, std::size_t number, std::size_t columns, const RowOfFields& wanted,
                            Row& sums) const
{
  const std::span<const SurfaceWave> along = row_of_waves(row).first(columns);
  const double depth = wanted.depths[number].depth;
  DepthSums::Row& of_surface = sums.of_surface;
  const std::size_t at = (number % DepthSums::together) * of_surface.pitch;
  const std::size_t count = wanted.fields_of_heat.is_odd.size();
  std::vector<Complex*> out(count);
  for (std::size_t f = 0; f < count; ++f)
    out[f] = wanted.spectra + (number * count + f) * fft_.plane() + begin_of(row);
  const auto decay = wanted.sums.has_layers() ? sums.decay.at(depth, along) : std::span<const double>{};
  wanted.fields_of_heat.waves({depth, along, decay, complex_values(of_surface.temperature, at, columns),
                               complex_values(of_surface.potential, at, columns),
                               complex_values(of_surface.slope, at, columns),
                               complex_values(of_surface.at_surface, 0, columns)},
                              out);
  const std::size_t told = told_columns(depth, wanted.has_buried);
  for (Complex* field : out)
    std::fill(field + columns, field + std::max(columns, told), Complex{});
}

/// Columns that count in any row, of which the first has the longest waves.
std::size_t HeatMemory::told_columns(double depth, bool has_buried) const
{
  return has_buried ? columns() : columns_that_reach(depth, row_of_waves(0));
}

void HeatMemory::fields(double duration, double factor, std::span<const DepthFactors> depths,
                        const FieldsOfHeat& fields_of_heat, const std::vector<std::span<double>>& out, bool adds) const
{
  // All that counts is written, so that nothing needs to be there before.
  const auto spectra = std::make_unique_for_overwrite<double[]>(2 * (out.size() * fft_.plane() + ToldRowsFft::slack));
  auto* const waves = reinterpret_cast<Complex*>(spectra.get());
  const DepthSums sums(waves_.waves, depths, left_in_depth(duration));
  const bool has_buried = buried_ && !buried_->is_cold();
  const RowOfFields wanted{duration, factor, has_buried, sums, depths, fields_of_heat, waves};
#pragma omp parallel if (is_shared(fft_.plane()))
  {
    Row of_row{sums.make_row(columns()), DecayInDepth(columns())};
    if (has_buried)
      of_row.buried = buried_->make_row(columns());
#pragma omp for schedule(static)
    for (int row = 0; row < fft_.rows(); ++row)
      add_row(row, wanted, of_row);
  }
  std::vector<ToldRowsFft::Told> told;
  told.reserve(out.size());
  for (std::size_t f = 0; f < out.size(); ++f)
    told.push_back({waves + f * fft_.plane(),
                    static_cast<int>(told_columns(depths[f / fields_of_heat.is_odd.size()].depth, has_buried))});
  fft_.inverse(told, fields_of_heat.is_odd, adds, out);
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
  AlignedVector<Complex> spectrum(fft_.plane() + ToldRowsFft::slack);
  buried_->add_surface(0, along_.size(), spectrum.data());
  for (Complex& wave : spectrum)
    wave *= factor;
  const ToldRowsFft::Told told{spectrum.data(), fft_.all().kx()};
  fft_.inverse({&told, 1}, {false}, true, {temperature});
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
