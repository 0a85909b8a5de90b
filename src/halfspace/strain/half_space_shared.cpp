// SPDX-License-Identifier: BSD-3-Clause
#include "half_space_operators.hpp"

#include <algorithm>
#include <omp.h>

/// The parts of an evaluation that differ if several ranks share the half space: docs/theory/ranks.md. Rows pass between the transforms
/// along x, which the ranks of the layers do, and those along y, which the ranks of the wavenumbers do.
namespace brinell::halfspace
{

namespace
{

constexpr std::size_t numbers = sizeof(ComplexLanes) / sizeof(double);

/// One thread of the team passes the rows while the others wait.
template <typename Pass>
void by_one_thread(const Pass& pass)
{
#pragma omp master
  pass();
#pragma omp barrier
}

} // namespace

Exchange HalfSpace::Operators::exchange(int units) const
{
  static_assert(Share::layers_together == MirroredFft::layers_of_group);
  return {*ranks,
          share,
          is_mirrored() ? Dealt(share.ranks(), 1) : share.layers(),
          units,
          surface_fft.blocks(),
          is_mirrored() ? mirrored_fft.rows() : grid.surface.independent_rows()};
}

/// Counterpart of transform_strain. To be called by all threads.
void HalfSpace::Operators::transform_strain_shared(std::span<const double> plastic_strain, int layers,
                                                   Work::Buffers& work, Work::Buffers::Scratch& scratch) const
{
  const bool halves = is_mirrored();
  const int units = halves ? MirroredFft::groups(layers) : layers;
  const int planes = halves ? MirroredFft::planes_of_group : Deviator::size; // of a unit
  const int planes_of_all = halves ? planes * MirroredFft::groups(grid.nz) : volume_fft.planes();
  const std::ptrdiff_t rows = halves ? mirrored_fft.rows() : grid.surface.independent_rows();
  ComplexLanes* const strain_rows = rows_of_strain(halves ? mirrored_fft.rows_size() : volume_fft.rows_size(), work);
  for (int first = 0; first < units; first += units_at_a_time)
  {
    const Exchange passed = exchange(std::min(units_at_a_time, units - first));
    for (int plane = 0; plane < planes; ++plane)
    {
#pragma omp for schedule(static)
      for (int own_unit = 0; own_unit < passed.own_units(); ++own_unit)
        transform_rows_shared(plastic_strain, layers, plane, first / share.ranks() + own_unit,
                              passing.of_planes.data() + own_unit * rows, {passed.apart(), false}, work, scratch);
      by_one_thread([&] { passed.to_blocks(passing.of_planes.data(), passing.of_blocks.data()); });
#pragma omp for schedule(static)
      for (int block = blocks.first; block < blocks.end; ++block)
        for (int unit = 0; unit < passed.units(); ++unit)
          std::copy_n(passing.of_blocks.data() + passed.place(unit, block), rows,
                      strain_rows + (static_cast<std::ptrdiff_t>(block - blocks.first) * planes_of_all +
                                     planes * (first + unit) + plane) *
                                        rows);
    }
  }
}

/// Transforms one plane of an own layer, or of an own pair of layers, along x.
void HalfSpace::Operators::transform_rows_shared(std::span<const double> plastic_strain, int layers, int plane,
                                                 int own_unit, ComplexLanes* out, const RowFft::Spectra& apart,
                                                 Work::Buffers& work, Work::Buffers::Scratch& scratch) const
{
  if (is_mirrored())
  {
    constexpr int planes = MirroredFft::planes_of_group;
    const int pair = Dealt(share.ranks(), 1).item(share.rank(), own_unit);
    const MirroredFft::Plane parts = MirroredFft::plane(planes * pair + plane, layers);
    const std::array<int, 2> first_rows{prepare_part(parts.first, {}, plastic_strain, work),
                                        prepare_part(parts.second, {}, plastic_strain, work)};
    if (!parts.is_empty())
      own_mirrored_fft.rows_forward_to(plastic_strain.data(), planes * own_unit + plane, share.count(layers),
                                       first_rows, out, apart, scratch.mirrored);
    return;
  }
  const int layer = share.layer(own_unit);
  const double* strain = plastic_strain.data() + field_at(plane, layer);
  const CellRectangle used = used_cells(strain, grid.surface.nx, grid.surface.ny);
  work.used[static_cast<std::size_t>(Deviator::size * layer + plane)] = used;
  image_correction.find_moments_of_layer(strain, used, plane, layer, work.images);
  volume_fft.rows_forward_to(strain, out, apart, scratch.fft);
}

/// Completes values [component][layer][...] of which each rank knows those of its layers.
void HalfSpace::Operators::join_layers(int layers, std::vector<double>& values) const
{
  if (values.empty())
    return;
  const std::size_t each = values.size() / static_cast<std::size_t>(Deviator::size * grid.nz);
  const auto at = [&](int component, int layer) {
    return values.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(component * grid.nz + layer) * each);
  };
  std::vector<double> own_values;
  for (int own_layer = 0; own_layer < share.count(layers); ++own_layer)
    for (int component = 0; component < Deviator::size; ++component)
      own_values.insert(own_values.end(), at(component, share.layer(own_layer)),
                        at(component, share.layer(own_layer)) + static_cast<std::ptrdiff_t>(each));
  const std::vector<double> all = ranks->joined(own_values);
  auto from = all.begin();
  for (int rank = 0; rank < share.ranks(); ++rank)
    for (int place = 0; place < share.layers().count(rank, layers); ++place)
      for (int component = 0; component < Deviator::size; ++component, from += static_cast<std::ptrdiff_t>(each))
        std::copy_n(from, each, at(component, share.layers().item(rank, place)));
}

void HalfSpace::Operators::join_shared(const OfTraction<const TractionStress*>& kernels, int strained,
                                       Work::Buffers& work) const
{
  if (work.layers > 0)
  {
    join_layers(strained, work.images.of_layers);
    join_layers(strained, work.images.crosswise.of_layers);
  }
  const auto rows = static_cast<std::size_t>(grid.surface.independent_rows());
  std::vector<std::size_t> counts;
  counts.reserve(static_cast<std::size_t>(share.ranks()));
  for (int rank = 0; rank < share.ranks(); ++rank)
    counts.push_back(numbers * rows * static_cast<std::size_t>(share.blocks(rank, surface_fft.blocks()).count()));
  for (std::size_t t = 0; t < tractions.size() && kernels[t] != nullptr; ++t)
  {
    auto* const all = reinterpret_cast<double*>(work.displacement_rows[t].data());
    const double* const own_rows = all + numbers * rows * static_cast<std::size_t>(blocks.first);
    const std::vector<double> sent(own_rows, own_rows + counts[static_cast<std::size_t>(share.rank())]);
    ranks->all_gather(sent, counts, {all, numbers * work.displacement_rows[t].size()});
  }
}

/// One component of the stress, or its trace, in the own layers among [0, layers), from the spectra of all ranks.
/// @param planes_of_layer  planes of the spectra per layer: the component counts if there are several
void HalfSpace::Operators::invert_shared(int component, int layers, const OfTraction<const TractionStress*>& kernels,
                                         const BlockedFft& fft, const ComplexLanes* spectra, int planes_of_layer,
                                         Work::Buffers& work, double* fields) const
{
  const std::ptrdiff_t rows = grid.surface.independent_rows();
  const int place = planes_of_layer == 1 ? 0 : component;
  const bool is_odd = component < Deviator::size && is_odd_in_y(component);
  const bool is_loaded =
      std::any_of(kernels.begin(), kernels.end(), [](const auto* kernel) { return kernel != nullptr; });
  const auto threads = static_cast<int>(work.threads.size());
  for (int first = 0; first < layers; first += layers_at_a_time)
  {
    const Exchange passed(*ranks, share, share.layers(), std::min(layers_at_a_time, layers - first), fft.blocks(),
                          grid.surface.independent_rows());
#pragma omp parallel for num_threads(threads) schedule(static) collapse(2)
    for (int block = blocks.first; block < blocks.end; ++block)
      for (int unit = 0; unit < passed.units(); ++unit)
      {
        const int layer = first + unit;
        Work::Buffers::Scratch& scratch = work.threads[static_cast<std::size_t>(omp_get_thread_num())];
        const ComplexLanes* column = spectra + plane_at(fft, block, planes_of_layer * layer + place);
        if (is_loaded)
        {
          ComplexLanes* const sum = scratch.fft.column.data();
          TractionStress::add(kernels, block, component, layer, surface_fft.waves_along_y(),
                              surface_spectra(block, work), column, next_block(fft, block, column), sum);
          column = sum;
        }
        surface_fft.columns_inverse(column, 0, 0, passing.of_blocks.data() + passed.place(unit, block), scratch.fft,
                                    is_odd);
      }
    passed.to_planes(passing.of_blocks.data(), passing.of_planes.data());
    const int own_first = first / share.ranks();
#pragma omp parallel for num_threads(threads) schedule(static)
    for (int own_unit = 0; own_unit < passed.own_units(); ++own_unit)
      surface_fft.rows_inverse_from(passing.of_planes.data() + own_unit * rows, {passed.apart(), false},
                                    fields + static_cast<std::size_t>(place * own.nz + own_first + own_unit) *
                                                 grid.surface.size(),
                                    work.threads[static_cast<std::size_t>(omp_get_thread_num())].fft);
  }
}

void HalfSpace::Operators::invert_traces_shared(const OfTraction<const TractionStress*>& kernels, int layers,
                                                const ComplexLanes* spectra, Work::Buffers& work, double* trace) const
{
  invert_shared(TractionStress::trace, layers, kernels, trace_fft, spectra, 1, work, trace);
}

void HalfSpace::Operators::add_load_and_invert_shared(const SurfaceLoad& load, std::span<const double> plastic_strain,
                                                      Work::Buffers& work, std::span<double> stress) const
{
  const auto kernels = kernels_of(parts_of(load));
  if (is_mirrored())
    return add_load_and_invert_mirrored_shared(kernels, plastic_strain, work, stress);
  const auto threads = static_cast<int>(work.threads.size());
  for (int component = 0; component < Deviator::size; ++component)
  {
    invert_shared(component, work.layers, kernels, volume_fft, work.stress.data(), Deviator::size, work, stress.data());
#pragma omp parallel for num_threads(threads) schedule(static)
    for (int own_layer = 0; own_layer < share.count(work.layers); ++own_layer)
    {
      const int layer = share.layer(own_layer);
      finish(component, layer, plastic_strain, work, stress.data() + field_at(component, layer));
    }
  }
}

void HalfSpace::Operators::add_load_and_invert_mirrored_shared(const OfTraction<const TractionStress*>& kernels,
                                                               std::span<const double> plastic_strain,
                                                               Work::Buffers& work, std::span<double> stress) const
{
  constexpr int planes = MirroredFft::planes_of_group;
  const auto threads = static_cast<int>(work.threads.size());
  const int groups = MirroredFft::groups(work.layers);
  for (int first = 0; first < groups; first += units_at_a_time)
  {
    const Exchange passed = exchange(std::min(units_at_a_time, groups - first));
    for (int place = 0; place < planes; ++place)
    {
#pragma omp parallel for num_threads(threads) schedule(static) collapse(2)
      for (int block = blocks.first; block < blocks.end; ++block)
        for (int unit = 0; unit < passed.units(); ++unit)
        {
          const MirroredFft::Plane plane = MirroredFft::plane(planes * (first + unit) + place, work.layers);
          if (plane.is_empty())
            continue;
          MirroredFft::Scratch& scratch = work.threads[static_cast<std::size_t>(omp_get_thread_num())].mirrored;
          const ComplexLanes* one = total_stress(block, plane.first, kernels, work, scratch.of_parts[0].data());
          const ComplexLanes* other = plane.second.is_there()
                                          ? total_stress(block, plane.second, kernels, work, scratch.of_parts[1].data())
                                          : nullptr;
          mirrored_fft.columns_inverse_to(plane, one, other, passing.of_blocks.data() + passed.place(unit, block),
                                          scratch);
        }
      passed.to_planes(passing.of_blocks.data(), passing.of_planes.data());
      const int own_first = first / share.ranks();
#pragma omp parallel for num_threads(threads) schedule(static)
      for (int own_unit = 0; own_unit < passed.own_units(); ++own_unit)
        invert_rows_mirrored_shared(
            MirroredFft::plane(planes * (own_first + own_unit) + place, share.count(work.layers)),
            passing.of_planes.data() + static_cast<std::ptrdiff_t>(own_unit) * mirrored_fft.rows(),
            {passed.apart(), false}, plastic_strain, work, stress);
    }
  }
}

/// Stress of the layers of a plane of spectra along x. To be called by one thread.
void HalfSpace::Operators::invert_rows_mirrored_shared(const MirroredFft::Plane& plane, const ComplexLanes* rows,
                                                       const RowFft::Spectra& apart,
                                                       std::span<const double> plastic_strain, Work::Buffers& work,
                                                       std::span<double> stress) const
{
  if (plane.is_empty())
    return;
  own_mirrored_fft.rows_inverse_from(plane, rows, apart, stress.data(),
                                     work.threads[static_cast<std::size_t>(omp_get_thread_num())].mirrored);
  for (const MirroredFft::Part& part : {plane.first, plane.second})
    if (part.is_there())
    {
      const int layer = share.layer(part.layer);
      finish(part.component, layer, plastic_strain, work, stress.data() + field_at(part.component, layer));
    }
}

} // namespace brinell::halfspace
