// SPDX-License-Identifier: BSD-3-Clause
#include "heat_memory.hpp"

#include "foundation/lane_functions.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace brinell::halfspace
{

namespace
{

/// Fourier factor of a field that is uniform in each cell, for a wave whose phase changes by `angle` over a cell: sinc(angle/2).
double cell_mean(double angle)
{
  return angle == 0.0 ? 1.0 : std::sin(0.5 * angle) / (0.5 * angle);
}

} // namespace

HeatMemory::HeatMemory(const SurfaceGrid& grid, int px, int py, const Thermal& thermal, DepthWaves waves,
                       const DepthFactors& surface, const std::shared_ptr<const LayeredConduction>& layers)
    : fft_(grid, px, py), diffusivity_(thermal.diffusivity()), conductivity_(thermal.conductivity),
      waves_(std::move(waves)), at_surface_(surface.at_surface.end() - static_cast<std::ptrdiff_t>(waves_.waves.size()),
                                            surface.at_surface.end() - 1),
      heat_{AlignedVector<ComplexLanes>(block_of(fft_.rows()) * waves_.waves.size())}
{
  for (int row = 0; row < fft_.rows(); ++row)
    for (int i = 0; i < fft_.kx(); ++i)
    {
      const double kx = fft_.wavenumber_x(i), ky = fft_.wavenumber_y(row);
      along_.push_back({kx, ky, std::hypot(kx, ky), 2 * i == px ? 0.0 : kx, 2 * row == py ? 0.0 : ky});
    }
  for (int row = 0; row < fft_.rows(); ++row)
    for (std::size_t i = 0; i < lane_count * blocks(); ++i)
    {
      if (i % lane_count == 0)
        k_.emplace_back();
      k_.back()[i % lane_count] = row_of_waves(row)[std::min(i, columns() - 1)].k;
    }
  for (std::size_t n = 0; waves_.has_fields && n < k_.size(); ++n)
  {
    Lanes& share = slow_share_.emplace_back();
    for (std::size_t lane = 0; lane < lane_count; ++lane)
      share[lane] = waves_.slow_share(k_[n][lane]);
  }
  if (layers)
    buried_.emplace(layers, along_, columns(), diffusivity_);
}

std::span<const SurfaceWave> HeatMemory::row_of_waves(int row) const
{
  return std::span(along_).subspan(begin_of(row), columns());
}

/// Decay factor e^{-kappa s^2 t} of each wave in depth after the time t = `duration`.
std::vector<double> HeatMemory::left_in_depth(double duration) const
{
  std::vector<double> left;
  left.reserve(waves_.waves.size());
  for (const DepthWave& wave : waves_.waves)
    left.push_back(std::exp(-diffusivity_ * wave.number * wave.number * duration));
  return left;
}

/// Decay factor e^{-kappa k^2 t} of neighbouring waves along the surface after the time t = `duration`.
Lanes HeatMemory::left_along(std::size_t block, double duration) const
{
  if (duration == 0.0)
    return Lanes{} + 1.0;
  if (step_ && step_->motion.duration == duration)
    return step_->blocks[block].left;
  Lanes left = diffusivity_ * k_[block] * k_[block] * duration;
  for (std::size_t lane = 0; lane < lane_count; ++lane)
    left[lane] = std::exp(-left[lane]);
  return left;
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
    for (std::size_t block = 0; block < blocks(); ++block)
    {
      const Lanes left = left_along(block_of(row) + block, duration);
      for (std::size_t i = block * lane_count; i < std::min(columns(), (block + 1) * lane_count); ++i)
        sum[begin_of(row) + i] *= left[i % lane_count] * mean_x[i] * of_row;
    }
  }
  const PaddedFft::Spectrum rows{sum.data(), fft_.kx()};
  fft_.inverse({&rows, 1}, {false}, true, {temperature});
}

namespace
{

std::span<Complex> complex_values(AlignedVector<double>& parts, std::size_t first, std::size_t count)
{
  return parts.empty() ? std::span<Complex>{} : std::span(reinterpret_cast<Complex*>(parts.data() + first), count);
}

} // namespace

/// Adds factor k, decay and the slowest wave in depth to the sum for the potential at the surface, if nothing else is summed.
void HeatMemory::find_surface_potential(int row, const RowOfFields& wanted, Row& sums) const
{
  const Complex *potential = wanted.at_surface + begin_of(row), *slowest = wanted.slowest + begin_of(row);
  auto* out = reinterpret_cast<Complex*>(sums.of_surface.at_surface.data());
  for (std::size_t i = 0; i < columns(); ++i)
  {
    const std::size_t block = block_of(row) + i / lane_count, lane = i % lane_count;
    out[i] = sums.left[i / lane_count][lane] * (k_[block][lane] * potential[i] + slow_share_[block][lane] * slowest[i]);
  }
}

/// Adds the heat generated in the body to the sums at one depth.
/// @param columns  number of columns for which the sums have been computed; the others are first set to zero
void HeatMemory::add_buried_row(double depth, double factor, std::size_t columns, std::size_t number, Row& sums) const
{
  DepthSums::Row& row = sums.of_surface;
  const std::size_t first = number * row.pitch;
  for (AlignedVector<double>* sum : {&row.temperature, &row.potential, &row.slope})
    std::fill(sum->begin() + static_cast<std::ptrdiff_t>(first + 2 * columns),
              sum->begin() + static_cast<std::ptrdiff_t>(first + row.pitch), 0.0);
  buried_->add(depth, factor, sums.buried,
               {row.temperature.data() + first, row.potential.data() + first, row.slope.data() + first});
}

void HeatMemory::add_row(int row, const RowOfFields& wanted, Row& sums) const
{
  const std::span<const SurfaceWave> along = row_of_waves(row);
  DepthSums::Row& of_surface = sums.of_surface;
  const std::size_t block = block_of(row);
  for (std::size_t n = 0; n < blocks(); ++n)
    sums.left[n] = wanted.factor * left_along(block + n, wanted.duration);
  if (wanted.sums != nullptr)
    wanted.sums->gather({&k_[block], &slow_share_[block], sums.left.data(), heat_of_row(row, sums.heat)}, of_surface);
  else
    find_surface_potential(row, wanted, sums);
  if (wanted.has_buried)
  {
    if (wanted.sums != nullptr)
      buried_->gather(static_cast<std::size_t>(row), sums.buried);
    buried_->add_potential_at_surface(static_cast<std::size_t>(row), wanted.factor,
                                      reinterpret_cast<Complex*>(of_surface.at_surface.data()));
  }
  sums.decay.begin();
  for (std::size_t first = 0; first < wanted.depths.size(); first += DepthSums::together)
  {
    const auto group = wanted.depths.subspan(first, std::min(DepthSums::together, wanted.depths.size() - first));
    std::array<std::size_t, DepthSums::together> reach{}; // depths may be in any order
    for (std::size_t d = 0; d < group.size(); ++d)
      reach[d] = columns_that_reach(group[d].depth, along);
    if (wanted.sums != nullptr)
      wanted.sums->sum(first, *std::max_element(reach.begin(), reach.end()), of_surface);
    for (std::size_t d = first; d < first + group.size(); ++d)
    {
      const double depth = wanted.depths[d].depth;
      std::size_t columns = reach[d - first];
      if (wanted.sums != nullptr && wanted.has_buried)
      {
        add_buried_row(depth, wanted.factor, columns, d - first, sums);
        columns = along.size();
      }
      write_fields(row, d, columns, wanted, sums);
    }
  }
}

/// Computes the fields of a row at one depth from its sums and writes them to their spectra.
void HeatMemory::write_fields(int row, std::size_t number, std::size_t columns, const RowOfFields& wanted,
                              Row& sums) const
{
  const std::span<const SurfaceWave> along = row_of_waves(row).first(columns);
  const double depth = wanted.depths[number].depth;
  DepthSums::Row& of_surface = sums.of_surface;
  const std::size_t at = (number % DepthSums::together) * of_surface.pitch;
  const std::size_t count = wanted.fields_of_heat.is_odd.size();
  std::vector<Complex*>& out = sums.out;
  out.resize(count);
  for (std::size_t f = 0; f < count; ++f)
    out[f] = wanted.spectra + (number * count + f) * fft_.plane() + begin_of(row);
  const auto decay = wanted.sums != nullptr ? sums.decay.at(depth, along) : std::span<const double>{};
  wanted.fields_of_heat.waves({depth, along, decay, complex_values(of_surface.temperature, at, columns),
                               complex_values(of_surface.potential, at, columns),
                               complex_values(of_surface.slope, at, columns),
                               complex_values(of_surface.at_surface, 0, columns)},
                              out);
  const auto significant = static_cast<std::size_t>(wanted.significant[number]);
  for (Complex* field : out)
    std::fill(field + columns, field + std::max(columns, significant), Complex{});
}

/// Number of columns that are not negligible in any row: those of the first row, which has the longest waves.
std::vector<int> HeatMemory::significant_columns(std::span<const DepthFactors> depths, bool has_buried) const
{
  std::vector<int> columns_of_depths;
  columns_of_depths.reserve(depths.size());
  for (const DepthFactors& factors : depths)
    columns_of_depths.push_back(
        static_cast<int>(has_buried ? columns() : columns_that_reach(factors.depth, row_of_waves(0))));
  return columns_of_depths;
}

HeatMemory::Row HeatMemory::make_row(const RowOfFields& wanted) const
{
  Row row{wanted.sums != nullptr ? wanted.sums->make_row(columns()) : DepthSums::Row{}, DecayInDepth(columns())};
  if (wanted.sums == nullptr)
    row.of_surface.at_surface.resize(2 * lane_count * blocks());
  row.left.resize(blocks());
  if (wanted.has_buried)
    row.buried = buried_->make_row();
  return row;
}

void HeatMemory::fields(double duration, double factor, std::span<const DepthFactors> depths,
                        const FieldsOfHeat& fields_of_heat, const std::vector<std::span<double>>& out, bool adds,
                        const Window& window) const
{
  // Uninitialised memory suffices: all values that are read later are written first.
  const auto spectra = std::make_unique_for_overwrite<double[]>(2 * (out.size() * fft_.plane()));
  auto* const waves = reinterpret_cast<Complex*>(spectra.get());
  const bool has_buried = buried_ && !buried_->is_cold();
  const bool is_deep = !depths.front().temperature.empty();
  std::optional<DepthSums> sums;
  std::optional<SurfaceSums> found;
  const Complex *at_surface = nullptr, *slowest = nullptr;
  if (is_deep)
    sums.emplace(waves_.waves, depths, left_in_depth(duration));
  else
  {
    const bool is_now = duration == 0.0, is_known = sums_ && (is_now || duration == sums_->duration);
    // Sums that are not known any more are those that a step would have left, to the last digit.
    const double after = is_now && !heat_.amended.empty() ? heat_.motion.duration : duration;
    const SurfaceSums& known = is_known ? *sums_ : found.emplace(find_sums(after));
    at_surface = (is_now ? known.potential_now : known.potential).data();
    slowest = known.slowest.data();
  }
  const std::vector<int> significant = significant_columns(depths, has_buried);
  const RowOfFields wanted{duration,       factor, has_buried, sums ? &*sums : nullptr, at_surface, slowest, depths,
                           fields_of_heat, waves,  significant};
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
  std::vector<PaddedFft::Spectrum> rows;
  rows.reserve(out.size());
  for (std::size_t f = 0; f < out.size(); ++f)
    rows.push_back({waves + f * fft_.plane(), significant[f / fields_of_heat.is_odd.size()]});
  fft_.inverse(rows, fields_of_heat.is_odd, adds, out, window);
}

void HeatMemory::add_heat_in_body(const std::vector<std::vector<double>>& rise, double duration)
{
  std::vector<AlignedVector<Complex>> spectra;
  spectra.reserve(rise.size());
  for (const std::vector<double>& layer : rise)
    spectra.push_back(layer.empty() ? AlignedVector<Complex>{} : fft_.forward(layer));
  buried_->add_step(spectra, duration);
}

void HeatMemory::add_buried(double factor, std::span<double> temperature) const
{
  if (!buried_ || buried_->is_cold())
    return;
  AlignedVector<Complex> spectrum(fft_.plane());
  buried_->add_surface(spectrum.data());
  for (Complex& wave : spectrum)
    wave *= factor;
  const PaddedFft::Spectrum rows{spectrum.data(), fft_.kx()};
  fft_.inverse({&rows, 1}, {false}, true, {temperature});
}

} // namespace brinell::halfspace
