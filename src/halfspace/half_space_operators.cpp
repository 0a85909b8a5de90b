// SPDX-License-Identifier: BSD-3-Clause
#include "half_space_operators.hpp"

#include "foundation/fft.hpp"

#include <algorithm>
#include <array>
#include <omp.h>

namespace brinell::halfspace
{

namespace
{

/// A group of planes that are transformed together holds whole layers.
constexpr int layers_of_a_group = BlockedFft::group_planes / Deviator::size;
static_assert(BlockedFft::group_planes % Deviator::size == 0);

} // namespace

HalfSpace::Operators::Operators(const VolumeGrid& volume, const Elastic& constants)
    : grid(volume), elastic(constants),
      surface_fft(volume.surface, padded_lengths(volume.surface).x, padded_lengths(volume.surface).y, 1),
      volume_fft(volume.surface, surface_fft.px(), surface_fft.py(), Deviator::size * volume.nz),
      trace_fft(volume.surface, surface_fft.px(), surface_fft.py(), volume.nz),
      eigenstrain_stress(volume, constants, surface_fft), image_correction(volume, constants, surface_fft)
{
  static_cast<void>(kernels_of({true, false, false}));
}

OfTraction<const TractionStress*> HalfSpace::Operators::kernels_of(const OfTraction<bool>& wanted) const
{
  OfTraction<const TractionStress*> result{};
  for (const Traction traction : tractions)
    if (wanted[index(traction)])
    {
      Kernels& kernels = kernels_[index(traction)];
      std::call_once(
          kernels.tabulated, [&]
          { kernels.stress = std::make_unique<TractionStress>(grid, elastic.poisson_ratio, surface_fft, traction); });
      result[index(traction)] = kernels.stress.get();
    }
  return result;
}

std::unique_ptr<HalfSpace::Work::Buffers> HalfSpace::Operators::make_buffers() const
{
  const auto blocks = static_cast<std::size_t>(volume_fft.blocks());
  auto work = std::make_unique<Work::Buffers>();
  for (int thread = 0; thread < omp_get_max_threads(); ++thread)
    work->threads.push_back({volume_fft.make_scratch(), eigenstrain_stress.make_scratch()});
  work->rows.resize(volume_fft.rows_size());
  work->strain.resize(volume_fft.block_size());
  work->stress.resize(volume_fft.block_size() * blocks);
  work->displacement_rows.front().resize(surface_fft.rows_size());
  work->surface_rows.resize(surface_fft.rows_size());
  work->surface.front().resize(surface_fft.block_size() * blocks);
  work->images = image_correction.make_response();
  return work;
}

int HalfSpace::Operators::strained_layers(std::span<const double> plastic_strain) const
{
  const auto has_strain = [&](int layer)
  {
    for (int c = 0; c < Deviator::size; ++c)
    {
      const auto field = plastic_strain.subspan(field_at(c, layer), grid.surface.size());
      if (std::any_of(field.begin(), field.end(), [](double e) { return e != 0.0; }))
        return true;
    }
    return false;
  };
  int strained = grid.nz;
  while (strained > 0 && !has_strain(strained - 1))
    --strained;
  return strained;
}

void HalfSpace::Operators::load_strain(std::span<const double> plastic_strain, int layers, Displacements displacements,
                                       Work::Buffers& work, Complex* trace) const
{
  const int strained = strained_layers(plastic_strain);
  const auto kernels = kernels_of({true, displacements != Displacements::normal, displacements == Displacements::all});
  work.layers = layers;
  work.displacements = displacements;
  for (std::size_t t = 1; t < tractions.size() && kernels[t] != nullptr; ++t)
  {
    work.surface[t].resize(work.surface.front().size());
    work.displacement_rows[t].resize(work.displacement_rows.front().size());
  }
  ++work.number;
  image_correction.respond(plastic_strain, strained, work.images);
  const int planes = Deviator::size * strained;
  const auto threads = static_cast<int>(work.threads.size());

#pragma omp parallel num_threads(threads)
  {
    Work::Buffers::Scratch& scratch = work.threads[static_cast<std::size_t>(omp_get_thread_num())];
#pragma omp for schedule(static)
    for (int plane = 0; plane < planes; ++plane)
      volume_fft.rows_forward(plastic_strain.data() + field_at(plane % Deviator::size, plane / Deviator::size), plane,
                              work.rows.data(), scratch.fft);
    for (int block = 0; block < volume_fft.blocks(); ++block)
    {
#pragma omp for schedule(static)
      for (int group = 0; group < BlockedFft::groups(planes); ++group)
      {
        volume_fft.columns_forward(work.rows.data(), block, group, planes, scratch.fft);
        volume_fft.scatter(scratch.fft, group, planes, work.strain.data());
      }
      const auto pass_row = [&](int row)
      {
        const Complex* strain = work.strain.data() + row_at(volume_fft, 0, row);
        for (std::size_t t = 0; t < tractions.size() && kernels[t] != nullptr; ++t)
          kernels[t]->displacement(block, row, strain, work.surface[t].data() + row_at(surface_fft, block, row),
                                   strained);
        eigenstrain_stress.apply(block, row, strain, strained, work.stress.data() + row_at(volume_fft, block, row),
                                 layers, scratch.layers,
                                 trace == nullptr ? nullptr : trace + row_at(trace_fft, block, row));
      };
#pragma omp for schedule(static)
      for (int row = 0; row <= volume_fft.py() / 2; ++row)
      {
        pass_row(row);
        if (const int mirrored = volume_fft.mirrored(row); mirrored != row)
          pass_row(mirrored); // while the kernels of both are in the cache
      }
    }
#pragma omp for schedule(static)
    for (int block = 0; block < surface_fft.blocks(); ++block)
      for (std::size_t t = 0; t < tractions.size() && kernels[t] != nullptr; ++t)
      {
        surface_fft.gather(work.surface[t].data() + row_at(surface_fft, block, 0), 0, 1, scratch.fft);
        surface_fft.columns_inverse(scratch.fft, block, 0, 1, work.displacement_rows[t].data());
      }
  }
}

void HalfSpace::Operators::load_surface(const SurfaceLoad& load, Work::Buffers& work) const
{
  BlockedFft::Scratch& scratch = work.threads.front().fft;
  for (const Traction traction : tractions)
  {
    const std::span<const double> part = part_of(load, traction);
    if (part.empty())
      continue;
    AlignedVector<Complex>& spectrum = work.surface[index(traction)];
    spectrum.resize(work.surface.front().size());
    surface_fft.rows_forward(part.data(), 0, work.surface_rows.data(), scratch);
    for (int block = 0; block < surface_fft.blocks(); ++block)
    {
      surface_fft.columns_forward(work.surface_rows.data(), block, 0, 1, scratch);
      surface_fft.scatter(scratch, 0, 1, spectrum.data() + row_at(surface_fft, block, 0));
    }
  }
}

void HalfSpace::Operators::add_load_and_invert(const SurfaceLoad& load, std::span<const double> plastic_strain,
                                               Work::Buffers& work, std::span<double> stress) const
{
  const auto kernels = kernels_of(parts_of(load));
  const int planes = Deviator::size * work.layers;
  const auto threads = static_cast<int>(work.threads.size());
#pragma omp parallel num_threads(threads)
  {
    Work::Buffers::Scratch& scratch = work.threads[static_cast<std::size_t>(omp_get_thread_num())];
    for (int block = 0; block < volume_fft.blocks(); ++block)
    {
#pragma omp for schedule(static)
      for (int group = 0; group < BlockedFft::groups(planes); ++group)
      {
        volume_fft.gather(work.stress.data() + row_at(volume_fft, block, 0), group, planes, scratch.fft);
        const int first = group * layers_of_a_group;
        for (std::size_t t = 0; t < tractions.size(); ++t)
          if (kernels[t] != nullptr)
            kernels[t]->add_deviator(block, first, std::min(layers_of_a_group, work.layers - first),
                                     work.surface[t].data() + row_at(surface_fft, block, 0),
                                     scratch.fft.columns.data());
        volume_fft.columns_inverse(scratch.fft, block, group, planes, work.rows.data());
      }
    }
#pragma omp for schedule(static)
    for (int plane = 0; plane < planes; ++plane)
    {
      const int component = plane % Deviator::size;
      const int layer = plane / Deviator::size;
      double* field = stress.data() + field_at(component, layer);
      volume_fft.rows_inverse(work.rows.data(), plane, field, scratch.fft);
      finish(component, layer, plastic_strain, work, field);
    }
  }
}

/// Adds the local part of the residual stress and takes off the stress of the periodic images.
void HalfSpace::Operators::finish(int component, int layer, std::span<const double> plastic_strain,
                                  const Work::Buffers& work, double* field) const
{
  std::array<const double*, Deviator::size> strain{};
  for (int c = 0; c < Deviator::size; ++c)
    strain[static_cast<std::size_t>(c)] = plastic_strain.data() + field_at(c, layer);
  eigenstrain_stress.add_local(component, strain, grid.surface.size(), field);
  image_correction.subtract(work.images, component, layer, field);
}

} // namespace brinell::halfspace
