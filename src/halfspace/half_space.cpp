// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/half_space.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/foundation/fft.hpp"
#include "foundation/require_size.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <omp.h>

namespace brinell::halfspace
{

namespace
{

/// In a spectrum of one block, or of all blocks one after the other: the row of one wavenumber along y.
std::ptrdiff_t row_at(const BlockedFft& fft, int block, int row)
{
  return (static_cast<std::ptrdiff_t>(block) * fft.py() + row) * fft.pitch() * lane_count;
}

/// A group of planes that are transformed together holds whole layers.
constexpr int layers_of_a_group = BlockedFft::group_planes / Deviator::size;
static_assert(BlockedFft::group_planes % Deviator::size == 0);

int padded(int cells)
{
  return fast_length(2 * cells - 1);
}

} // namespace

HalfSpace::HalfSpace(const VolumeGrid& grid, const Elastic& elastic)
    : grid_(grid), elastic_(elastic), surface_fft_(grid.surface, padded(grid.surface.nx), padded(grid.surface.ny), 1),
      volume_fft_(grid.surface, surface_fft_.px(), surface_fft_.py(), Deviator::size * grid.nz),
      trace_fft_(grid.surface, surface_fft_.px(), surface_fft_.py(), grid.nz),
      pressure_stress_(grid, elastic.poisson_ratio, surface_fft_), eigenstrain_stress_(grid, elastic, surface_fft_),
      image_correction_(grid, elastic, surface_fft_)
{
}

/// Place of one component in one layer of a field.
std::size_t HalfSpace::field_at(int component, int layer) const
{
  return static_cast<std::size_t>(component * grid_.nz + layer) * grid_.surface.size();
}

HalfSpace::Work HalfSpace::make_work() const
{
  const auto blocks = static_cast<std::size_t>(volume_fft_.blocks());
  Work work;
  for (int thread = 0; thread < omp_get_max_threads(); ++thread)
    work.threads_.push_back({volume_fft_.make_scratch(), eigenstrain_stress_.make_scratch()});
  work.rows_.resize(volume_fft_.rows_size());
  work.strain_.resize(volume_fft_.block_size());
  work.stress_.resize(volume_fft_.block_size() * blocks);
  work.surface_rows_.resize(surface_fft_.rows_size());
  work.surface_.resize(surface_fft_.block_size() * blocks);
  work.images_ = image_correction_.make_response();
  return work;
}

void HalfSpace::load_strain(std::span<const double> plastic_strain, int layers, Work& work,
                            std::span<double> displacement) const
{
  load_strain(plastic_strain, layers, work, displacement, nullptr);
}

void HalfSpace::load_strain(std::span<const double> plastic_strain, int layers, Work& work,
                            std::span<double> displacement, Complex* trace) const
{
  require_size("HalfSpace::load_strain: the plastic strain", plastic_strain, Deviator::size * grid_.size());
  require_size("HalfSpace::load_strain: the displacement", displacement, grid_.surface.size());
  if (layers < 0 || layers > grid_.nz)
    throw InternalError(fmt::format("HalfSpace::load_strain: {} layers are wanted, the grid has {}", layers, grid_.nz));
  const auto has_strain = [&](int layer)
  {
    for (int c = 0; c < Deviator::size; ++c)
    {
      const auto field = plastic_strain.subspan(field_at(c, layer), grid_.surface.size());
      if (std::any_of(field.begin(), field.end(), [](double e) { return e != 0.0; }))
        return true;
    }
    return false;
  };
  int strained = grid_.nz;
  while (strained > 0 && !has_strain(strained - 1))
    --strained;
  work.layers_ = layers;
  image_correction_.respond(plastic_strain, strained, work.images_);
  const int planes = Deviator::size * strained;
  const auto threads = static_cast<int>(work.threads_.size());

#pragma omp parallel num_threads(threads)
  {
    Work::Scratch& scratch = work.threads_[static_cast<std::size_t>(omp_get_thread_num())];
#pragma omp for schedule(static)
    for (int plane = 0; plane < planes; ++plane)
      volume_fft_.rows_forward(plastic_strain.data() + field_at(plane % Deviator::size, plane / Deviator::size), plane,
                               work.rows_.data(), scratch.fft);
    for (int block = 0; block < volume_fft_.blocks(); ++block)
    {
#pragma omp for schedule(static)
      for (int group = 0; group < BlockedFft::groups(planes); ++group)
      {
        volume_fft_.columns_forward(work.rows_.data(), block, group, planes, scratch.fft);
        volume_fft_.scatter(scratch.fft, group, planes, work.strain_.data());
      }
      const auto pass_row = [&](int row)
      {
        const Complex* strain = work.strain_.data() + row_at(volume_fft_, 0, row);
        pressure_stress_.displacement(block, row, strain, work.surface_.data() + row_at(surface_fft_, block, row),
                                      strained);
        eigenstrain_stress_.apply(block, row, strain, strained, work.stress_.data() + row_at(volume_fft_, block, row),
                                  layers, scratch.layers,
                                  trace == nullptr ? nullptr : trace + row_at(trace_fft_, block, row));
      };
#pragma omp for schedule(static)
      for (int row = 0; row <= volume_fft_.py() / 2; ++row)
      {
        pass_row(row);
        if (const int mirrored = volume_fft_.mirrored(row); mirrored != row)
          pass_row(mirrored); // while the kernels of both are in the cache
      }
    }
#pragma omp for schedule(static)
    for (int block = 0; block < surface_fft_.blocks(); ++block)
    {
      surface_fft_.gather(work.surface_.data() + row_at(surface_fft_, block, 0), 0, 1, scratch.fft);
      surface_fft_.columns_inverse(scratch.fft, block, 0, 1, work.surface_rows_.data());
    }
  }
  surface_fft_.rows_inverse(work.surface_rows_.data(), 0, displacement.data(), work.threads_.front().fft);
}

void HalfSpace::load_pressure(std::span<const double> pressure, Work& work) const
{
  BlockedFft::Scratch& scratch = work.threads_.front().fft;
  surface_fft_.rows_forward(pressure.data(), 0, work.surface_rows_.data(), scratch);
  for (int block = 0; block < surface_fft_.blocks(); ++block)
  {
    surface_fft_.columns_forward(work.surface_rows_.data(), block, 0, 1, scratch);
    surface_fft_.scatter(scratch, 0, 1, work.surface_.data() + row_at(surface_fft_, block, 0));
  }
}

void HalfSpace::deviatoric_stress(std::span<const double> pressure, std::span<const double> plastic_strain, Work& work,
                                  std::span<double> stress) const
{
  require_size("HalfSpace::deviatoric_stress: the pressure", pressure, grid_.surface.size());
  require_size("HalfSpace::deviatoric_stress: the plastic strain", plastic_strain, Deviator::size * grid_.size());
  require_size("HalfSpace::deviatoric_stress: the stress", stress, Deviator::size * grid_.size());
  load_pressure(pressure, work);
  const int planes = Deviator::size * work.layers_;
  const auto threads = static_cast<int>(work.threads_.size());
#pragma omp parallel num_threads(threads)
  {
    Work::Scratch& scratch = work.threads_[static_cast<std::size_t>(omp_get_thread_num())];
    for (int block = 0; block < volume_fft_.blocks(); ++block)
    {
#pragma omp for schedule(static)
      for (int group = 0; group < BlockedFft::groups(planes); ++group)
      {
        volume_fft_.gather(work.stress_.data() + row_at(volume_fft_, block, 0), group, planes, scratch.fft);
        const int first = group * layers_of_a_group;
        pressure_stress_.add_deviator(block, first, std::min(layers_of_a_group, work.layers_ - first),
                                      work.surface_.data() + row_at(surface_fft_, block, 0),
                                      scratch.fft.columns.data());
        volume_fft_.columns_inverse(scratch.fft, block, group, planes, work.rows_.data());
      }
    }
#pragma omp for schedule(static)
    for (int plane = 0; plane < planes; ++plane)
    {
      const int component = plane % Deviator::size;
      const int layer = plane / Deviator::size;
      double* field = stress.data() + field_at(component, layer);
      volume_fft_.rows_inverse(work.rows_.data(), plane, field, scratch.fft);
      finish(component, layer, plastic_strain, work, field);
    }
  }
}

/// Adds the local part of the residual stress and takes off the stress of the periodic images.
void HalfSpace::finish(int component, int layer, std::span<const double> plastic_strain, const Work& work,
                       double* field) const
{
  std::array<const double*, Deviator::size> strain{};
  for (int c = 0; c < Deviator::size; ++c)
    strain[static_cast<std::size_t>(c)] = plastic_strain.data() + field_at(c, layer);
  eigenstrain_stress_.add_local(component, strain, grid_.surface.size(), field);
  image_correction_.subtract(work.images_, component, layer, field);
}

void HalfSpace::full_stress(std::span<const double> pressure, std::span<const double> plastic_strain, Work& work,
                            std::span<double> deviator, std::span<double> trace) const
{
  require_size("HalfSpace::full_stress: the pressure", pressure, grid_.surface.size());
  require_size("HalfSpace::full_stress: the plastic strain", plastic_strain, Deviator::size * grid_.size());
  require_size("HalfSpace::full_stress: the deviator", deviator, Deviator::size * grid_.size());
  require_size("HalfSpace::full_stress: the trace", trace, grid_.size());
  const BlockedFft& fft = trace_fft_;
  AlignedVector<Complex> spectra(fft.block_size() * static_cast<std::size_t>(fft.blocks()));
  AlignedVector<Complex> rows(fft.rows_size());
  std::vector<double> displacement(grid_.surface.size());
  load_strain(plastic_strain, grid_.nz, work, displacement, spectra.data());
  deviatoric_stress(pressure, plastic_strain, work, deviator);
  BlockedFft::Scratch& scratch = work.threads_.front().fft;
  for (int block = 0; block < fft.blocks(); ++block)
  {
    Complex* spectrum = spectra.data() + row_at(fft, block, 0);
    for (int row = 0; row < fft.py(); ++row)
      pressure_stress_.add_trace(block, row, work.surface_.data() + row_at(surface_fft_, block, row),
                                 spectrum + row_at(fft, 0, row));
    for (int group = 0; group < BlockedFft::groups(grid_.nz); ++group)
    {
      fft.gather(spectrum, group, grid_.nz, scratch);
      fft.columns_inverse(scratch, block, group, grid_.nz, rows.data());
    }
  }
  for (int layer = 0; layer < grid_.nz; ++layer)
  {
    double* field = trace.data() + field_at(0, layer);
    fft.rows_inverse(rows.data(), layer, field, scratch);
    finish(ImageCorrection::trace, layer, plastic_strain, work, field);
  }
}

} // namespace brinell::halfspace
