// SPDX-License-Identifier: BSD-3-Clause
#include "stack_cells.hpp"

#include "banded_fields.hpp"
#include "brinell/foundation/error.hpp"
#include "brinell/halfspace/surface_compliance.hpp"
#include "stack_scales.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace brinell::halfspace
{

using green::WaveLoad;

void require_resolved(const SurfaceGrid& grid, const ElasticStack& stack)
{
  const ElasticStack merged = stack.merged();
  if (merged.is_homogeneous() || grid.is_periodic())
    return;
  constexpr double least = 0.25; // of a cell
  const bool is_row = grid.ny == 1 && grid.is_periodic_y(), is_column = grid.nx == 1 && grid.is_periodic_x();
  const double cell = is_row ? grid.dx : is_column ? grid.dy : std::max(grid.dx, grid.dy);
  if (const double thickness = merged.layers.front().thickness; thickness < least * cell)
    throw InputError(fmt::format("the first layer is {:.4g} m thick on cells of {:.4g} m along the surface; allowed: a "
                                 "thickness of {:.4g} m at least, or smaller cells",
                                 thickness, cell, least * cell));
}

namespace
{

/// Stress of a wave: ll, tt, zz, lz, lt, tz.
using LoadParts = std::array<double, 6>;

std::vector<WaveLoad> loads_of(Traction traction)
{
  return traction == Traction::pressure ? std::vector{WaveLoad::pressure}
                                        : std::vector{WaveLoad::along, WaveLoad::across};
}

std::vector<green::StackWave::Field> fields_of(const green::StackWave& wave, Traction traction)
{
  std::vector<green::StackWave::Field> fields;
  for (const WaveLoad load : loads_of(traction))
    fields.push_back(wave.field_of(load));
  return fields;
}

/// Adds `factor` times the mean stress in one layer of a wave.
void add_mean(const green::StackWave& wave, const std::vector<green::StackWave::Field>& fields, Traction traction,
              std::size_t layer, const MaterialRange& range, double factor, LoadParts& sum)
{
  const std::vector<WaveLoad> loads = loads_of(traction);
  for (std::size_t load = 0; load < loads.size(); ++load)
  {
    const green::WaveStress s = wave.mean_stress(loads[load], fields[load], layer, range.from, range.to);
    const LoadParts parts{s.ll, s.tt, s.zz, s.lz, s.lt, s.tz};
    for (std::size_t p = 0; p < parts.size(); ++p)
      sum[p] += factor * parts[p];
  }
}

/// Mean over a range of depths, which may contain interfaces.
LoadParts mean_parts(const ElasticStack& stack, const green::StackWave& wave,
                     const std::vector<green::StackWave::Field>& fields, Traction traction, double from, double to)
{
  LoadParts sum{};
  for (const MaterialRange& range : materials_in(stack, from, to))
    if (!stack.of_layer(range.material).is_rigid())
      add_mean(wave, fields, traction, range.material, range, (range.to - range.from) / (to - from), sum);
  return sum;
}

/// Terms of the stress by a pressure. Parts: ll + tt, ll - tt, zz, lz.
constexpr std::array<WaveTerm, 8> pressure_terms{{{0, 0, 0, false, 0.5},
                                                  {0, 1, 2, false, 0.5},
                                                  {1, 0, 0, false, 0.5},
                                                  {1, 1, 2, false, -0.5},
                                                  {2, 2, 0, false, 1.0},
                                                  {3, 3, 1, true, 1.0},
                                                  {4, 3, 1, false, 1.0},
                                                  {5, 1, 2, true, 0.5}}};
/// Terms of the stress by a shear along x, which is lx along l and -ly along t. Parts: 3 ll + tt + 2 lt, ll + 3 tt - 2 lt, zz,
/// lz - tz, lz + tz, ll - tt - 2 lt.
constexpr std::array<WaveTerm, 11> shear_terms{{{0, 0, 1, false, 0.25},
                                                {0, 5, 3, false, 0.25},
                                                {1, 1, 1, false, 0.25},
                                                {1, 5, 3, false, -0.25},
                                                {2, 2, 1, false, 1.0},
                                                {3, 3, 2, true, 0.5},
                                                {4, 4, 0, false, 0.5},
                                                {4, 3, 2, false, 0.5},
                                                {5, 0, 1, true, 0.125},
                                                {5, 1, 1, true, -0.125},
                                                {5, 5, 3, true, 0.25}}};

WaveTerms terms_of(Traction traction)
{
  return traction == Traction::pressure ? WaveTerms(pressure_terms) : WaveTerms(shear_terms);
}

WaveParts parts_of(Traction traction, const LoadParts& stress)
{
  const auto& [ll, tt, zz, lz, lt, tz] = stress;
  if (traction == Traction::pressure)
    return {ll + tt, ll - tt, zz, lz, 0.0, 0.0};
  return {3.0 * ll + tt + 2.0 * lt, ll + 3.0 * tt - 2.0 * lt, zz, lz - tz, lz + tz, ll - tt - 2.0 * lt};
}

} // namespace

SymTensor stack_wave_stress(const ElasticStack& stack, Traction traction, double k, double lx, double ly, double from,
                            double to)
{
  if (traction == Traction::shear_y)
    return xy_exchanged(stack_wave_stress(stack, Traction::shear_x, k, ly, lx, from, to));
  const green::StackWave wave(stack, k);
  return components_of(terms_of(traction),
                       parts_of(traction, mean_parts(stack, wave, fields_of(wave, traction), traction, from, to)), lx,
                       ly);
}

namespace
{

/// Parts of one wavenumber in all layers of cells, less those of homogeneous bodies.
std::vector<WaveParts> excess(const VolumeGrid& grid, const ElasticStack& stack, Traction traction, double k)
{
  const green::StackWave wave(stack, k);
  const std::vector<green::StackWave::Field> fields = fields_of(wave, traction);
  std::vector<WaveParts> parts;
  parts.reserve(static_cast<std::size_t>(grid.nz));
  for (int layer = 0; layer < grid.nz; ++layer)
  {
    const double from = layer * grid.dz, to = (layer + 1) * grid.dz;
    LoadParts stress = mean_parts(stack, wave, fields, traction, from, to);
    for (const MaterialRange& range : materials_in(stack, from, to))
    {
      const green::StackWave alone({{}, {1.0, stack.of_layer(range.material).poisson_ratio}}, k);
      add_mean(alone, fields_of(alone, traction), traction, 0, range, (range.from - range.to) / (to - from), stress);
    }
    parts.push_back(parts_of(traction, stress));
  }
  return parts;
}

/// [layer]
std::vector<RadialFields::Table> tables(const VolumeGrid& grid, const ElasticStack& stack, Traction traction,
                                        const WaveScales& scales)
{
  const std::vector<double> wavenumbers = RadialFields::Table::wavenumbers(scales.smallest(), scales.largest());
  std::vector<std::vector<WaveParts>> values(static_cast<std::size_t>(grid.nz),
                                             std::vector<WaveParts>(wavenumbers.size()));
#pragma omp parallel for schedule(static)
  for (std::size_t n = 0; n < wavenumbers.size(); ++n)
  {
    const std::vector<WaveParts> parts = excess(grid, stack, traction, wavenumbers[n]);
    for (std::size_t layer = 0; layer < parts.size(); ++layer)
      values[layer][n] = parts[layer];
  }
  std::vector<RadialFields::Table> result;
  result.reserve(values.size());
  for (const std::vector<WaveParts>& of_layer : values)
    result.emplace_back(scales.smallest(), of_layer);
  return result;
}

} // namespace

ExcessStress::ExcessStress(const VolumeGrid& grid, const ElasticStack& stack, Traction traction)
    : grid_(grid.surface.whole()), traction_(traction), scales_(stress_scales(stack)),
      waves_(tables(grid, stack, traction, scales_))
{
  if (!grid_.is_periodic_x() && !grid_.is_periodic_y())
    open_.emplace(grid_, scales_, terms_of(traction), waves_);
}

Quadrant<SymTensor> ExcessStress::of_layer(int layer) const
{
  const auto at = static_cast<std::size_t>(layer);
  return open_ ? open_->cells(at) : banded_cells(grid_, scales_, terms_of(traction_), waves_[at], 0.0);
}

} // namespace brinell::halfspace
