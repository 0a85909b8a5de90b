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
                       const DepthFactors& surface, const std::shared_ptr<const LayeredConduction>& layers,
                       std::shared_ptr<const HeatCoat> coat)
    : waves_(grid, px, py, thermal, std::move(waves), surface, std::move(coat)),
      heat_{AlignedVector<ComplexLanes>(waves_.block_of(waves_.fft.rows()) * waves_.in_depth.waves.size())}
{
  if (layers)
    buried_.emplace(layers, waves_.along, waves_.columns(), waves_.diffusivity);
}

/// Decay factor e^{-kappa k^2 t} of neighbouring waves along the surface after the time t = `duration`.
Lanes HeatMemory::left_along(std::size_t block, double duration) const
{
  if (duration == 0.0)
    return Lanes{} + 1.0;
  if (step_ && step_->motion.duration == duration)
    return step_->blocks[block].left;
  Lanes left = waves_.diffusivity * waves_.k[block] * waves_.k[block] * duration;
  for (std::size_t lane = 0; lane < lane_count; ++lane)
    left[lane] = std::exp(-left[lane]);
  return left;
}

void HeatMemory::add_remaining(double duration, double factor, const SurfaceGrid& heated,
                               std::span<double> temperature) const
{
  AlignedVector<Complex> sum =
      sums_ && sums_->duration == duration ? sums_->temperature : find_sums(duration).temperature;
  std::vector<double> mean_x(waves_.columns());
  for (std::size_t i = 0; i < waves_.columns(); ++i)
    mean_x[i] = cell_mean(waves_.along[i].kx * heated.dx);
  for (int row = 0; row < waves_.fft.rows(); ++row)
  {
    const double of_row = factor * cell_mean(waves_.row_of_waves(row).front().ky * heated.dy);
    for (std::size_t block = 0; block < waves_.blocks(); ++block)
    {
      const Lanes left = left_along(waves_.block_of(row) + block, duration);
      for (std::size_t i = block * lane_count; i < std::min(waves_.columns(), (block + 1) * lane_count); ++i)
        sum[waves_.begin_of(row) + i] *= left[i % lane_count] * mean_x[i] * of_row;
    }
  }
  const PaddedFft::Spectrum rows{sum.data(), waves_.fft.kx()};
  waves_.fft.inverse({&rows, 1}, {false}, true, {temperature});
}

namespace
{

std::span<Complex> complex_values(AlignedVector<double>& parts, std::size_t first, std::size_t count)
{
  return parts.empty() ? std::span<Complex>{} : std::span(reinterpret_cast<Complex*>(parts.data() + first), count);
}

/// Number of columns that are not negligible in any row: those of the first row, which has the longest waves.
std::vector<int> significant_columns(const HeatWaves& waves, std::span<const DepthFactors> depths, bool has_buried)
{
  std::vector<int> columns_of_depths;
  columns_of_depths.reserve(depths.size());
  for (const DepthFactors& factors : depths)
    columns_of_depths.push_back(
        static_cast<int>(has_buried ? waves.columns() : columns_that_reach(factors.depth, waves.row_of_waves(0))));
  return columns_of_depths;
}

} // namespace

/// Sums of a row, for the heat that entered at the surface and for the heat generated in the body.
struct HeatMemory::Row
{
  DepthSums::Row of_surface;
  DecayInDepth decay;
  AlignedVector<Lanes> left{}; ///< decay of each wave along the surface, times the factor: [block]
  std::vector<Complex*> out{}; ///< fields at a depth
  BuriedHeat::Row buried{};
  RowOfHeat heat{}; ///< with what was amended
};

/// Task of `fields`, the same for every row.
struct HeatMemory::RowOfFields
{
  const HeatMemory& memory;
  double duration, factor;
  bool has_buried;                     ///< whether there is heat in the body
  const DepthSums* in_depth;           ///< nullptr if only the surface is wanted
  const Complex *at_surface, *slowest; ///< as in `SurfaceSums`; used if `in_depth` is nullptr
  std::span<const DepthFactors> depths;
  const FieldsOfHeat& fields_of_heat;
  Complex* spectra;                 ///< [depth][field][plane]
  std::span<const int> significant; ///< for each depth, the number of columns that are not negligible in any row

  [[nodiscard]] Row make_row() const;
  void add_row(int row, Row& sums) const;

private:
  [[nodiscard]] const HeatWaves& waves() const { return memory.waves_; }
  void find_surface_potential(int row, Row& sums) const;
  void add_buried_row(double depth, std::size_t columns, std::size_t number, Row& sums) const;
  void write_fields(int row, std::size_t number, std::size_t columns, Row& sums) const;
};

/// Adds factor k, decay and the slowest wave in depth to the sum for the potential at the surface, if nothing else is summed.
void HeatMemory::RowOfFields::find_surface_potential(int row, Row& sums) const
{
  const Complex *potential = at_surface + waves().begin_of(row), *slowest_wave = slowest + waves().begin_of(row);
  auto* out = reinterpret_cast<Complex*>(sums.of_surface.at_surface.data());
  for (std::size_t i = 0; i < waves().columns(); ++i)
  {
    const std::size_t block = waves().block_of(row) + i / lane_count, lane = i % lane_count;
    out[i] = sums.left[i / lane_count][lane] *
             (waves().k[block][lane] * potential[i] + waves().slow_share[block][lane] * slowest_wave[i]);
  }
}

/// Adds the heat generated in the body to the sums at one depth.
/// @param columns  number of columns for which the sums have been computed; the others are first set to zero
void HeatMemory::RowOfFields::add_buried_row(double depth, std::size_t columns, std::size_t number, Row& sums) const
{
  DepthSums::Row& row = sums.of_surface;
  const std::size_t first = number * row.pitch;
  for (AlignedVector<double>* sum : {&row.temperature, &row.potential, &row.slope})
    std::fill(sum->begin() + static_cast<std::ptrdiff_t>(first + 2 * columns),
              sum->begin() + static_cast<std::ptrdiff_t>(first + row.pitch), 0.0);
  memory.buried_->add(depth, factor, sums.buried,
                      {row.temperature.data() + first, row.potential.data() + first, row.slope.data() + first});
}

void HeatMemory::RowOfFields::add_row(int row, Row& sums) const
{
  const std::span<const SurfaceWave> along = waves().row_of_waves(row);
  DepthSums::Row& of_surface = sums.of_surface;
  const std::size_t block = waves().block_of(row);
  for (std::size_t n = 0; n < waves().blocks(); ++n)
    sums.left[n] = factor * memory.left_along(block + n, duration);
  if (in_depth != nullptr)
    in_depth->gather(
        {&waves().k[block], &waves().slow_share[block], sums.left.data(), memory.heat_of_row(row, sums.heat)},
        of_surface);
  else
    find_surface_potential(row, sums);
  if (has_buried)
  {
    if (in_depth != nullptr)
      memory.buried_->gather(static_cast<std::size_t>(row), sums.buried);
    memory.buried_->add_potential_at_surface(static_cast<std::size_t>(row), factor,
                                             reinterpret_cast<Complex*>(of_surface.at_surface.data()));
  }
  sums.decay.begin();
  for (std::size_t first = 0; first < depths.size(); first += DepthSums::together)
  {
    const auto group = depths.subspan(first, std::min(DepthSums::together, depths.size() - first));
    std::array<std::size_t, DepthSums::together> reach{}; // depths may be in any order
    for (std::size_t d = 0; d < group.size(); ++d)
      reach[d] = columns_that_reach(group[d].depth, along);
    if (in_depth != nullptr)
      in_depth->sum(first, *std::max_element(reach.begin(), reach.end()), of_surface);
    for (std::size_t d = first; d < first + group.size(); ++d)
    {
      const double depth = depths[d].depth;
      std::size_t columns = reach[d - first];
      if (in_depth != nullptr && has_buried)
      {
        add_buried_row(depth, columns, d - first, sums);
        columns = along.size();
      }
      write_fields(row, d, columns, sums);
    }
  }
}

/// Computes the fields of a row at one depth from its sums and writes them to their spectra.
void HeatMemory::RowOfFields::write_fields(int row, std::size_t number, std::size_t columns, Row& sums) const
{
  const std::span<const SurfaceWave> along = waves().row_of_waves(row).first(columns);
  const double depth = depths[number].depth;
  DepthSums::Row& of_surface = sums.of_surface;
  const std::size_t at = (number % DepthSums::together) * of_surface.pitch;
  const std::size_t count = fields_of_heat.is_odd.size();
  std::vector<Complex*>& out = sums.out;
  out.resize(count);
  for (std::size_t f = 0; f < count; ++f)
    out[f] = spectra + (number * count + f) * waves().fft.plane() + waves().begin_of(row);
  const auto decay = in_depth != nullptr ? sums.decay.at(depth, along) : std::span<const double>{};
  fields_of_heat.waves({depth, along, decay, complex_values(of_surface.temperature, at, columns),
                        complex_values(of_surface.potential, at, columns),
                        complex_values(of_surface.slope, at, columns),
                        complex_values(of_surface.at_surface, 0, columns)},
                       out);
  const auto kept = static_cast<std::size_t>(significant[number]);
  for (Complex* field : out)
    std::fill(field + columns, field + std::max(columns, kept), Complex{});
}

HeatMemory::Row HeatMemory::RowOfFields::make_row() const
{
  Row row{in_depth != nullptr ? in_depth->make_row(waves().columns()) : DepthSums::Row{},
          DecayInDepth(waves().columns())};
  if (in_depth == nullptr)
    row.of_surface.at_surface.resize(2 * lane_count * waves().blocks());
  row.left.resize(waves().blocks());
  if (has_buried)
    row.buried = memory.buried_->make_row();
  return row;
}

void HeatMemory::fields(double duration, double factor, std::span<const DepthFactors> depths,
                        const FieldsOfHeat& fields_of_heat, const std::vector<std::span<double>>& out, bool adds,
                        const Window& window) const
{
  // Uninitialised memory suffices: all values that are read later are written first.
  const auto spectra = std::make_unique_for_overwrite<double[]>(2 * (out.size() * waves_.fft.plane()));
  auto* const waves = reinterpret_cast<Complex*>(spectra.get());
  std::vector<PaddedFft::Spectrum> rows;
  rows.reserve(out.size());
  if (waves_.coat)
  {
    find_coated(duration, factor, depths, fields_of_heat, waves);
    for (std::size_t f = 0; f < out.size(); ++f)
      rows.push_back({waves + f * waves_.fft.plane(), static_cast<int>(waves_.columns())});
    return waves_.fft.inverse(rows, fields_of_heat.is_odd, adds, out, window);
  }
  const bool has_buried = buried_ && !buried_->is_cold();
  const bool is_deep = !depths.front().temperature.empty();
  std::optional<DepthSums> sums;
  std::optional<SurfaceSums> found;
  const Complex *at_surface = nullptr, *slowest = nullptr;
  if (is_deep)
    sums.emplace(waves_.in_depth.waves, depths, waves_.left_in_depth(duration));
  else
  {
    const bool is_now = duration == 0.0, is_known = sums_ && (is_now || duration == sums_->duration);
    // Sums that are not known any more are those that a step would have left, to the last digit.
    const double after = is_now && !heat_.amended.empty() ? heat_.motion.duration : duration;
    const SurfaceSums& known = is_known ? *sums_ : found.emplace(find_sums(after));
    at_surface = (is_now ? known.potential_now : known.potential).data();
    slowest = known.slowest.data();
  }
  const std::vector<int> significant = significant_columns(waves_, depths, has_buried);
  const RowOfFields wanted{*this,  duration,       factor, has_buried, sums ? &*sums : nullptr, at_surface, slowest,
                           depths, fields_of_heat, waves,  significant};
  if (!is_shared(waves_.fft.plane()))
  {
    Row of_row = wanted.make_row();
    for (int row = 0; row < waves_.fft.rows(); ++row)
      wanted.add_row(row, of_row);
  }
  else
  {
#pragma omp parallel
    {
      Row of_row = wanted.make_row();
#pragma omp for schedule(static)
      for (int row = 0; row < waves_.fft.rows(); ++row)
        wanted.add_row(row, of_row);
    }
  }
  for (std::size_t f = 0; f < out.size(); ++f)
    rows.push_back({waves + f * waves_.fft.plane(), significant[f / fields_of_heat.is_odd.size()]});
  waves_.fft.inverse(rows, fields_of_heat.is_odd, adds, out, window);
}

void HeatMemory::add_heat_in_body(const std::vector<std::vector<double>>& rise, double duration)
{
  std::vector<AlignedVector<Complex>> spectra;
  spectra.reserve(rise.size());
  for (const std::vector<double>& layer : rise)
    spectra.push_back(layer.empty() ? AlignedVector<Complex>{} : waves_.fft.forward(layer));
  buried_->add_step(spectra, duration);
}

void HeatMemory::add_buried(double factor, std::span<double> temperature) const
{
  if (!buried_ || buried_->is_cold())
    return;
  AlignedVector<Complex> spectrum(waves_.fft.plane());
  buried_->add_surface(spectrum.data());
  for (Complex& wave : spectrum)
    wave *= factor;
  const PaddedFft::Spectrum rows{spectrum.data(), waves_.fft.kx()};
  waves_.fft.inverse({&rows, 1}, {false}, true, {temperature});
}

} // namespace brinell::halfspace
