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
                       const DepthFactors& surface, Symmetry symmetry, const std::shared_ptr<const LayeredConduction>& layers)
    : fft_(grid, px, py, symmetry), diffusivity_(thermal.diffusivity()), conductivity_(thermal.conductivity),
      waves_(std::move(waves)), at_surface_(surface.at_surface.end() - static_cast<std::ptrdiff_t>(waves_.waves.size()),
                                          surface.at_surface.end() - 1),
      heat_(block_of(fft_.rows()) * waves_.waves.size())
{
  const PlaneOfWaves& all = fft_.all();
  for (int row = 0; row < fft_.rows(); ++row)
    for (int i = 0; i < all.kx(); ++i)
    {
      const double kx = all.wavenumber_x(i), ky = all.wavenumber_y(row);
      along_.push_back({kx, ky, std::hypot(kx, ky), 2 * i == px ? 0.0 : kx, 2 * row == py ? 0.0 : ky});
    }
  for (int row = 0; row < fft_.rows(); ++row)
    for (std::size_t block = 0; block < blocks(); ++block)
    {
      Lanes& k2 = k2_.emplace_back();
      for (std::size_t lane = 0; lane < lane_count; ++lane)
        k2[lane] = std::pow(row_of_waves(row)[std::min(block * lane_count + lane, columns() - 1)].k, 2);
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

/// Of each wave in depth after a while.
std::vector<double> HeatMemory::left_in_depth(double duration) const
{
  std::vector<double> left;
  left.reserve(waves_.waves.size());
  for (const DepthWave& wave : waves_.waves)
    left.push_back(std::exp(-diffusivity_ * wave.number * wave.number * duration));
  return left;
}

double HeatMemory::left_along(int row, std::size_t column, double duration) const
{
  if (duration == 0.0)
    return 1.0;
  if (step_ && step_->motion.duration == duration)
    return step_->blocks[block_of(row) + column / lane_count].left[column % lane_count];
  const double k = row_of_waves(row)[column].k;
  return std::exp(-(diffusivity_ * k * k * duration));
}

void HeatMemory::add_remaining(double duration, double factor, const SurfaceGrid& heated,
                               std::span<double> temperature) const
{
  AlignedVector<Complex> sum =
      sums_ && sums_->duration == duration ? sums_->temperature : find_sums(duration).temperature;
  std::vector<double> mean_x(columns());
  for (std::size_t i = 0; i < columns(); ++i)
    mean_x[i] = cell_mean(along_[i].kx * heated.dx);
  for (int row = 0; row < fft_.rows(); ++row)
  {
    const double of_row = factor * cell_mean(row_of_waves(row).front().ky * heated.dy);
    for (std::size_t i = 0; i < columns(); ++i)
      sum[begin_of(row) + i] *= left_along(row, i, duration) * mean_x[i] * of_row;
  }
  const ToldRowsFft::Told told{sum.data(), fft_.all().kx()};
  fft_.inverse({&told, 1}, {false}, true, {temperature});
}

void HeatMemory::find_row_end(int row, double duration, double factor, RowEnd& end) const
{
  end.left.resize(columns());
  end.slowest.resize(columns());
  end.slow_share = std::span(slow_share_).subspan(begin_of(row), columns());
  for (std::size_t i = 0; i < columns(); ++i)
  {
    const ComplexLanes& slowest = heat_of_block(block_of(row) + i / lane_count)[waves_.waves.size() - 1];
    end.left[i] = factor * left_along(row, i, duration);
    end.slowest[i] = {slowest.re[i % lane_count], slowest.im[i % lane_count]};
  }
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
  find_row_end(row, wanted.duration, wanted.factor, sums.end);
  DepthSums::Row& of_surface = sums.of_surface;
  if (wanted.sums != nullptr)
    wanted.sums->gather({heat_of_block(block_of(row)), k2_.data() + block_of(row)}, of_surface);
  else
    std::copy_n(wanted.at_surface + begin_of(row), columns(), complex_values(of_surface.at_surface, 0, columns()).data());
  finish_surface(along, sums.end, of_surface);
  if (wanted.has_buried)
  {
    if (wanted.sums != nullptr)
      buried_->gather(begin_of(row), along.size(), sums.buried);
    buried_->add_potential_at_surface(begin_of(row), along.size(), wanted.factor,
                                      complex_values(of_surface.at_surface, 0, along.size()).data());
  }
  sums.decay.begin();
  for (std::size_t first = 0; first < wanted.depths.size(); first += DepthSums::together)
  {
    const auto group = wanted.depths.subspan(first, std::min(DepthSums::together, wanted.depths.size() - first));
    const auto by_depth = [](const DepthFactors& a, const DepthFactors& b) { return a.depth < b.depth; };
    if (wanted.sums != nullptr) // depths may be in any order
      wanted.sums->sum(first, columns_that_reach(std::min_element(group.begin(), group.end(), by_depth)->depth, along),
                      of_surface);
    for (std::size_t d = first; d < first + group.size(); ++d)
    {
      const double depth = wanted.depths[d].depth;
      std::size_t columns = columns_that_reach(depth, along);
      if (wanted.sums != nullptr)
        finish(depth, along.first(columns), sums.end, d - first, of_surface);
      if (wanted.sums != nullptr && wanted.has_buried)
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
  const auto decay = wanted.sums != nullptr ? sums.decay.at(depth, along) : std::span<const double>{};
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

HeatMemory::Row HeatMemory::make_row(const RowOfFields& wanted) const
{
  Row row{wanted.sums != nullptr ? wanted.sums->make_row(columns()) : DepthSums::Row{}, DecayInDepth(columns())};
  if (wanted.sums == nullptr)
    row.of_surface.at_surface.resize(2 * columns());
  if (wanted.has_buried)
    row.buried = buried_->make_row(columns());
  return row;
}

void HeatMemory::fields(double duration, double factor, std::span<const DepthFactors> depths,
                        const FieldsOfHeat& fields_of_heat, const std::vector<std::span<double>>& out, bool adds) const
{
  // All that counts is written, so that nothing needs to be there before.
  const auto spectra = std::make_unique_for_overwrite<double[]>(2 * (out.size() * fft_.plane() + ToldRowsFft::slack));
  auto* const waves = reinterpret_cast<Complex*>(spectra.get());
  const bool has_buried = buried_ && !buried_->is_cold();
  const bool is_deep = !depths.front().temperature.empty();
  std::optional<DepthSums> sums;
  std::optional<SurfaceSums> found;
  const Complex* at_surface = nullptr;
  if (is_deep)
    sums.emplace(waves_.waves, depths, left_in_depth(duration));
  else if (sums_ && (duration == 0.0 || duration == sums_->duration))
    at_surface = (duration == 0.0 ? sums_->potential_now : sums_->potential).data();
  else
    at_surface = found.emplace(find_sums(duration)).potential.data();
  const RowOfFields wanted{duration, factor,         has_buried, sums ? &*sums : nullptr, at_surface,
                           depths,   fields_of_heat, waves};
  if (!is_shared(fft_.plane()))
  {
    Row of_row = make_row(wanted);
    for (int row = 0; row < fft_.rows(); ++row)
      add_row(row, wanted, of_row);
  }
  else
  {
#pragma omp parallel
    {
      Row of_row = make_row(wanted);
#pragma omp for schedule(static)
      for (int row = 0; row < fft_.rows(); ++row)
        add_row(row, wanted, of_row);
    }
  }
  std::vector<ToldRowsFft::Told> told;
  told.reserve(out.size());
  for (std::size_t f = 0; f < out.size(); ++f)
    told.push_back({waves + f * fft_.plane(),
                    static_cast<int>(told_columns(depths[f / fields_of_heat.is_odd.size()].depth, has_buried))});
  fft_.inverse(told, fields_of_heat.is_odd, adds, out);
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

} // namespace brinell::halfspace
