// SPDX-License-Identifier: BSD-3-Clause
#include "half_space_operators.hpp"

#include "brinell/foundation/error.hpp"
#include "foundation/fft.hpp"
#include "foundation/lane_functions.hpp"
#include "foundation/sharing.hpp"
#include "half_space_memory.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <omp.h>
#include <utility>

namespace brinell::halfspace
{

namespace
{

/// A compromise: many parts to share among the threads, but little memory for their sums.
constexpr int layers_of_a_part = 2;
static_assert(layers_of_a_part == MirroredFft::layers_of_group);

int parts_for(int layers)
{
  return (layers + layers_of_a_part - 1) / layers_of_a_part;
}

} // namespace

HalfSpace::Operators::Operators(const VolumeGrid& volume, const ElasticStack& constants,
                                const layer_waves::Shortest& shortest, Ranks by)
    : grid(volume), stack(constants.merged()), ranks(by ? std::move(by) : std::make_shared<const Communicator>()),
      share(ranks->rank(), ranks->size()), own{volume.surface, share.count(volume.nz), volume.dz},
      surface_fft(volume.surface, padded_lengths(volume.surface).x, padded_lengths(volume.surface).y, 1),
      volume_fft(volume.surface, surface_fft.px(), surface_fft.py(), Deviator::size * volume.nz),
      trace_fft(volume.surface, surface_fft.px(), surface_fft.py(), volume.nz),
      mirrored_fft(volume, surface_fft.px(), surface_fft.py()),
      own_mirrored_fft(own, surface_fft.px(), surface_fft.py()), blocks(share.blocks(surface_fft.blocks())),
      image_correction(volume, stack, surface_fft), layers_at_a_time(volume.nz), units_at_a_time(volume.nz),
      shortest_waves(shortest)
{
  if (stack.is_homogeneous())
    eigenstrain_stress.emplace(volume, stack.substrate, surface_fft, shortest);
  else if (is_aligned(volume, stack))
    stack_stress.emplace(volume, stack, surface_fft, shortest, blocks);
  if (share.is_all())
    return;
  const auto threads = static_cast<int>(ranks->largest(omp_get_max_threads()));
  layers_at_a_time = halfspace::layers_at_a_time(grid.surface, share.ranks(), threads);
  units_at_a_time = is_mirrored() ? layers_at_a_time / Share::layers_together : layers_at_a_time;
  const Exchange of_layers(*ranks, share, share.layers(), std::min(layers_at_a_time, grid.nz), surface_fft.blocks(),
                           grid.surface.independent_rows());
  const Exchange of_units = exchange(std::min(units_at_a_time, is_mirrored() ? MirroredFft::groups(grid.nz) : grid.nz));
  passing.of_planes.resize(std::max(of_layers.size_of_planes(), of_units.size_of_planes()));
  passing.of_blocks.resize(std::max(of_layers.size_of_blocks(), of_units.size_of_blocks()));
}

void HalfSpace::Operators::apply_to_strain(int block, const SpectrumRows& rows,
                                           const EigenstrainStress::Spectra& spectra,
                                           Work::Buffers::Scratch& scratch) const
{
  if (eigenstrain_stress)
    eigenstrain_stress->apply(block, rows, spectra, scratch.layers);
  else if (stack_stress)
    stack_stress->apply(block, rows, spectra, scratch.stack);
  else // without strain
    for (int plane = 0; plane < Deviator::size * spectra.layers; ++plane)
      std::fill_n(spectra.stress + plane * volume_fft.pitch() + rows.first, rows.count, ComplexLanes{});
  if (!eigenstrain_stress && !stack_stress && spectra.trace != nullptr)
    for (int layer = 0; layer < spectra.layers; ++layer)
      std::fill_n(spectra.trace + layer * volume_fft.pitch() + rows.first, rows.count, ComplexLanes{});
}

OfTraction<const TractionStress*> HalfSpace::Operators::kernels_of(const OfTraction<bool>& wanted) const
{
  OfTraction<const TractionStress*> result{};
  for (const Traction traction : tractions)
    if (wanted[index(traction)])
      result[index(traction)] =
          &kernels_[index(traction)].get([&] { return TractionStress(grid, stack, surface_fft, traction, blocks); });
  return result;
}

std::unique_ptr<HalfSpace::Work::Buffers> HalfSpace::Operators::make_buffers(bool of_guest) const
{
  const auto own_blocks = static_cast<std::size_t>(blocks.count());
  auto work = std::make_unique<Work::Buffers>();
  for (int thread = 0; thread < omp_get_max_threads(); ++thread)
    work->threads.push_back({volume_fft.make_scratch(),
                             eigenstrain_stress ? eigenstrain_stress->make_scratch() : EigenstrainStress::Scratch{},
                             stack_stress ? stack_stress->make_scratch() : StackStress::Scratch{},
                             AlignedVector<ComplexLanes>(surface_fft.rows_size()), mirrored_fft.make_scratch()});
  work->blocks_at_a_time = blocks_at_a_time(blocks.count(), static_cast<int>(work->threads.size()));
  if (!of_guest)
  {
    const auto at_a_time = static_cast<std::size_t>(work->blocks_at_a_time);
    work->strain.resize(at_a_time * volume_fft.block_size());
    // Blocks and rows are those of a whole transform, but for the own blocks.
    const std::size_t rows_of_block =
        std::max(volume_fft.rows_size(), mirrored_fft.rows_size()) / static_cast<std::size_t>(volume_fft.blocks());
    work->stress.resize(own_blocks * std::max(volume_fft.block_size(), rows_of_block));
    work->displacement_parts.resize(at_a_time * static_cast<std::size_t>(parts_for(grid.nz) * surface_fft.pitch()) *
                                    tractions.size());
  }
  work->displacement_rows.front().resize(surface_fft.rows_size());
  work->surface.front().resize(surface_fft.block_size() * own_blocks);
  work->used.resize(static_cast<std::size_t>(Deviator::size * grid.nz));
  work->images = image_correction.make_response();
  return work;
}

int HalfSpace::Operators::strained_layers(std::span<const double> plastic_strain) const
{
  const int rows = grid.surface.independent_rows();
  const auto has_strain = [&](int layer)
  {
    for (int j = rows - 1; j >= 0; --j)
      for (int c = 0; c < Deviator::size; ++c)
        if (has_nonzero(plastic_strain.data() + field_at(c, layer) + grid.surface.index(0, j), grid.surface.nx))
          return true;
    return false;
  };
  int strained = own.nz;
  while (strained > 0 && !has_strain(share.layer(strained - 1)))
    --strained;
  return static_cast<int>(ranks->largest(strained > 0 ? share.layer(strained - 1) + 1 : 0));
}

void HalfSpace::Operators::load_strain(std::span<const double> plastic_strain, int layers, Displacements displacements,
                                       Work::Buffers& work, AlignedVector<ComplexLanes>* trace) const
{
  if (work.strain.size() < static_cast<std::size_t>(work.blocks_at_a_time) * volume_fft.block_size())
    throw InternalError(
        "HalfSpace::load: the buffers of the strain are too small; were they lent to another half space?");
  const int strained = strained_layers(plastic_strain);
  if (strained > 0)
  {
    require_aligned(grid, stack);
    if (stack.at((strained - 0.5) * grid.dz).is_rigid())
      throw InputError(
          fmt::format("layer {} of the cells has plastic strain but lies in the rigid base; allowed: strain in "
                      "the elastic layers",
                      strained));
  }
  const auto kernels = kernels_of({true, displacements != Displacements::normal, displacements == Displacements::all});
  work.layers = layers;
  work.has_trace = false;
  if (trace != nullptr)
    trace->resize(trace_fft.block_size() * static_cast<std::size_t>(blocks.count()));
  work.displacements = displacements;
  for (std::size_t t = 1; t < tractions.size() && kernels[t] != nullptr; ++t)
  {
    work.surface[t].resize(work.surface.front().size());
    work.displacement_rows[t].resize(work.displacement_rows.front().size());
  }
  ++work.number;
  std::fill(work.used.begin() + static_cast<std::ptrdiff_t>(Deviator::size) * strained, work.used.end(),
            CellRectangle{});
  const auto threads = static_cast<int>(work.threads.size());

  const auto load = [&](int thread)
  {
    Work::Buffers::Scratch& scratch = work.threads[static_cast<std::size_t>(thread)];
    transform_strain(plastic_strain, strained, work, scratch);
    process_blocks(thread, strained, kernels, work, trace != nullptr ? trace->data() : nullptr);
#pragma omp for schedule(static)
    for (int block = blocks.first; block < blocks.end; ++block)
      for (std::size_t t = 0; t < tractions.size() && kernels[t] != nullptr; ++t)
      {
        const ComplexLanes* spectrum = work.surface[t].data() + plane_at(surface_fft, block, 0);
        surface_fft.columns_inverse(spectrum, block, 0, work.displacement_rows[t].data(), scratch.fft,
                                    tractions[t] == Traction::shear_y);
      }
  };
  in_threads(threads, load);
  if (!share.is_all())
    join_shared(kernels, strained, work);
  if (layers > 0)
    image_correction.respond(strained, work.images, trace != nullptr);
}

/// Transforms the strain along x, and computes from each plane its used cells and moments. To be called by all threads.
void HalfSpace::Operators::transform_strain(std::span<const double> plastic_strain, int layers, Work::Buffers& work,
                                            Work::Buffers::Scratch& scratch) const
{
  if (!share.is_all())
    return transform_strain_shared(plastic_strain, layers, work, scratch);
  if (is_mirrored())
    return transform_strain_mirrored(plastic_strain, layers, work, scratch.mirrored);
#pragma omp for schedule(static)
  for (int plane = 0; plane < Deviator::size * layers; ++plane)
  {
    const int component = plane % Deviator::size;
    const int layer = plane / Deviator::size;
    const double* strain = plastic_strain.data() + field_at(component, layer);
    if (plane + 1 < Deviator::size * layers)
      fetch_soon(plastic_strain.subspan(field_at((plane + 1) % Deviator::size, (plane + 1) / Deviator::size),
                                        grid.surface.size()));
    const CellRectangle used = used_cells(strain, grid.surface.nx, grid.surface.ny);
    work.used[static_cast<std::size_t>(plane)] = used;
    image_correction.find_moments_of_layer(strain, used, component, layer, work.images);
    volume_fft.rows_forward(strain, plane, work.rows(volume_fft.rows_size()), scratch.fft);
  }
}

/// The rows of the opposite wavenumbers along y, without those that are their own opposites.
SpectrumRows HalfSpace::Operators::mirrored(const SpectrumRows& rows) const
{
  const int py = volume_fft.py();
  const int first = std::max(rows.first, 1);
  const int last = std::min(rows.first + rows.count - 1, (py - 1) / 2);
  return {py - last, last - first + 1};
}

ComplexLanes* HalfSpace::Operators::displacement_part(int block, int part, Work::Buffers& work) const
{
  const int place = (block - blocks.first) % work.blocks_at_a_time * parts_for(grid.nz) + part;
  return work.displacement_parts.data() + place * static_cast<std::ptrdiff_t>(tractions.size()) * surface_fft.pitch();
}

/// Rows of the strain are stored in the memory of the stress: all threads read the rows of a block before its stress is written,
/// and the rows of later blocks are stored behind it. One barrier between both is therefore sufficient, and a thread that has
/// finished the waves of one block begins with the transforms of its next one. To be called by all threads.
void HalfSpace::Operators::process_blocks(int thread, int strained, const OfTraction<const TractionStress*>& kernels,
                                          Work::Buffers& work, ComplexLanes* trace) const
{
  Work::Buffers::Scratch& scratch = work.threads[static_cast<std::size_t>(thread)];
  const int threads = omp_get_num_threads(); // may be fewer than there are buffers for
  const bool has_own_block = work.blocks_at_a_time == threads;
  const Team team = has_own_block ? Team{0, 1} : Team{thread, threads};
  const int step = has_own_block ? threads : 1;
  for (int first = blocks.first; first < blocks.end; first += step)
  {
    const int block = first + (has_own_block ? thread : 0);
    if (block < blocks.end)
      transform_layers(block, strained, kernels, team, work, scratch);
    if (threads > 1) // a barrier costs a system call even for a single thread
    {
#pragma omp barrier
    }
    if (block < blocks.end)
      process_waves(block, strained, kernels, team, work, trace, scratch);
  }
  if (threads > 1)
  {
#pragma omp barrier
  }
}

/// Stress of all layers at the wavenumbers of one block, and displacement of the surface by all layers. The single rows are
/// shared evenly among the threads: shared in tiles of several rows, one thread could have a tile more than the others.
void HalfSpace::Operators::process_waves(int block, int strained, const OfTraction<const TractionStress*>& kernels,
                                         const Team& team, Work::Buffers& work, ComplexLanes* trace,
                                         Work::Buffers::Scratch& scratch) const
{
  const EigenstrainStress::Spectra spectra{strain_of(block, work), strained,
                                           work.stress.data() + plane_at(volume_fft, block, 0), work.layers,
                                           trace == nullptr ? nullptr : trace + plane_at(trace_fft, block, 0)};
  const int rows = volume_fft.py() / 2 + 1;
  const int end = rows * (team.rank + 1) / team.count;
  for (int first = rows * team.rank / team.count; first < end; first += SpectrumRows::most)
  {
    const SpectrumRows stored{first, std::min(SpectrumRows::most, end - first)};
    for (const SpectrumRows& tile : {stored, is_mirrored() ? SpectrumRows{} : mirrored(stored)})
    {
      if (work.layers > 0)
        apply_to_strain(block, tile, spectra, scratch);
      sum_displacement(block, tile, parts_for(strained), kernels, work);
    }
  }
}

/// Transforms the layers along y, and adds each plane to the displacement of the surface while it is in the cache.
void HalfSpace::Operators::transform_layers(int block, int layers, const OfTraction<const TractionStress*>& kernels,
                                            const Team& team, Work::Buffers& work,
                                            Work::Buffers::Scratch& scratch) const
{
  ComplexLanes* const spectrum = strain_of(block, work);
  for (int part = team.rank; part < parts_for(layers); part += team.count) // the same assignment as along x
  {
    if (is_mirrored())
      mirrored_fft.columns_forward(rows_of_strain(mirrored_fft.rows_size(), work), block - blocks.first, part, layers,
                                   spectrum, volume_fft.pitch(), scratch.mirrored);
    ComplexLanes* sums = displacement_part(block, part, work);
    std::fill_n(sums, tractions.size() * static_cast<std::size_t>(surface_fft.pitch()), ComplexLanes{});
    for (int layer = part * layers_of_a_part; layer < std::min((part + 1) * layers_of_a_part, layers); ++layer)
    {
      ComplexLanes* strain = spectrum + volume_fft.plane_at(0, Deviator::size * layer);
      for (int component = 0; component < Deviator::size && !is_mirrored(); ++component)
        volume_fft.columns_forward(rows_of_strain(volume_fft.rows_size(), work), block - blocks.first,
                                   Deviator::size * layer + component,
                                   strain + static_cast<std::ptrdiff_t>(component) * volume_fft.pitch(), scratch.fft);
      for (std::size_t t = 0; t < tractions.size() && kernels[t] != nullptr; ++t)
        kernels[t]->add_displacement(block, layer, surface_fft.waves_along_y(), strain,
                                     sums + static_cast<std::ptrdiff_t>(t) * surface_fft.pitch());
    }
  }
}

/// Sums the parts of the displacement at some wavenumbers.
void HalfSpace::Operators::sum_displacement(int block, const SpectrumRows& rows, int parts,
                                            const OfTraction<const TractionStress*>& kernels, Work::Buffers& work) const
{
  for (std::size_t t = 0; t < tractions.size() && kernels[t] != nullptr; ++t)
    for (int row = rows.first; row < rows.first + rows.count; ++row)
    {
      ComplexLanes sum;
      for (int part = 0; part < parts; ++part)
        sum = sum + displacement_part(block, part, work)[static_cast<std::ptrdiff_t>(t) * surface_fft.pitch() + row];
      work.surface[t][static_cast<std::size_t>(plane_at(surface_fft, block, 0) + row)] = sum;
    }
}

void HalfSpace::Operators::load_surface(const SurfaceLoad& load, Work::Buffers& work) const
{
  Work::Buffers::Scratch& scratch = work.threads.front();
  for (const Traction traction : tractions)
  {
    const std::span<const double> part = part_of(load, traction);
    if (part.empty())
      continue;
    AlignedVector<ComplexLanes>& spectrum = work.surface[index(traction)];
    spectrum.resize(work.surface.front().size());
    surface_fft.rows_forward(part.data(), 0, scratch.rows.data(), scratch.fft);
    for (int block = blocks.first; block < blocks.end; ++block)
      surface_fft.columns_forward(scratch.rows.data(), block, 0, spectrum.data() + plane_at(surface_fft, block, 0),
                                  scratch.fft, traction == Traction::shear_y);
  }
}

void HalfSpace::Operators::add_load_and_invert(const SurfaceLoad& load, std::span<const double> plastic_strain,
                                               Work::Buffers& work, std::span<double> stress) const
{
  const auto kernels = kernels_of(parts_of(load));
  const int planes = Deviator::size * work.layers;
  const auto threads = static_cast<int>(work.threads.size());
#pragma omp parallel for num_threads(threads) schedule(static)
  for (int plane = 0; plane < planes; ++plane)
  {
    const int component = plane % Deviator::size;
    const int layer = plane / Deviator::size;
    double* field = stress.data() + field_at(component, layer);
    invert_plane(component, layer, kernels, volume_fft, work.stress.data(), plane, work,
                 work.threads[static_cast<std::size_t>(omp_get_thread_num())], field);
    finish(component, layer, plastic_strain, work, field);
  }
}

OfTraction<const ComplexLanes*> HalfSpace::Operators::surface_spectra(int block, const Work::Buffers& work) const
{
  OfTraction<const ComplexLanes*> spectra{};
  for (std::size_t t = 0; t < spectra.size(); ++t)
    if (!work.surface[t].empty())
      spectra[t] = work.surface[t].data() + plane_at(surface_fft, block, 0);
  return spectra;
}

void HalfSpace::Operators::invert_plane(int component, int layer, const OfTraction<const TractionStress*>& kernels,
                                        const BlockedFft& fft, const ComplexLanes* spectra, int plane,
                                        const Work::Buffers& work, Work::Buffers::Scratch& scratch, double* field) const
{
  const bool is_loaded =
      std::any_of(kernels.begin(), kernels.end(), [](const auto* kernel) { return kernel != nullptr; });
  for (int block = 0; block < fft.blocks(); ++block)
  {
    const ComplexLanes* column = spectra + fft.plane_at(block, plane);
    ComplexLanes* sum = scratch.fft.column.data();
    if (is_loaded)
    {
      TractionStress::add(kernels, block, component, layer, surface_fft.waves_along_y(), surface_spectra(block, work),
                          column, next_block(fft, block, column), sum);
      column = sum;
    }
    surface_fft.columns_inverse(column, block, 0, scratch.rows.data(), scratch.fft,
                                component < Deviator::size && is_odd_in_y(component));
  }
  surface_fft.rows_inverse(scratch.rows.data(), 0, field, scratch.fft);
}

/// The rows of a layer that contain strain, with all their columns.
CellRectangle HalfSpace::Operators::strained_rows(int layer, const Work::Buffers& work) const
{
  CellRectangle rows;
  for (int c = 0; c < Deviator::size; ++c)
  {
    const CellRectangle& used = work.used[static_cast<std::size_t>(Deviator::size * layer + c)];
    if (used.is_empty())
      continue;
    rows = {0, grid.surface.nx, rows.is_empty() ? used.first_y : std::min(rows.first_y, used.first_y),
            std::max(rows.end_y, used.end_y)};
  }
  return rows;
}

/// Adds the local part of the residual stress and subtracts the stress of the periodic images.
void HalfSpace::Operators::finish(int component, int layer, std::span<const double> plastic_strain,
                                  const Work::Buffers& work, double* field) const
{
  std::array<const double*, Deviator::size> strain{};
  const CellRectangle rows = strained_rows(layer, work);
  const std::size_t begin = grid.surface.index(0, rows.first_y);
  for (int c = 0; c < Deviator::size; ++c)
    strain[static_cast<std::size_t>(c)] = plastic_strain.data() + field_at(c, layer) + begin;
  layer_waves::add_local(stack.at((layer + 0.5) * grid.dz), component, strain,
                         grid.surface.index(0, rows.end_y) - begin, field + begin);
  image_correction.subtract(work.images, component, layer, field);
}

} // namespace brinell::halfspace
