// SPDX-License-Identifier: BSD-3-Clause
#include "half_space_operators.hpp"

#include "foundation/lane_functions.hpp"

#include <algorithm>
#include <omp.h>

/// The parts of an evaluation that differ if both sides of the plane y = 0 are mirror images:
/// docs/theory/half-space.md (symmetry).
namespace brinell::halfspace
{

/// Finds the cells in which a part of a plane is not zero, and computes its moments.
/// @param next  the part that is processed next, which is prefetched
/// @returns the first independent row that is not zero; the number of independent rows if there is none
int HalfSpace::Operators::prepare_part(const MirroredFft::Part& part, const MirroredFft::Part& next,
                                       std::span<const double> plastic_strain, Work::Buffers& work) const
{
  const int rows = mirrored_fft.independent_rows();
  if (next.is_there())
    fetch_soon(plastic_strain.subspan(field_at(next.component, next.layer), grid.surface.index(0, rows)));
  if (!part.is_there())
    return rows;
  const double* strain = plastic_strain.data() + field_at(part.component, part.layer);
  const CellRectangle used = used_cells(strain, grid.surface.nx, rows);
  work.used[static_cast<std::size_t>(Deviator::size * part.layer + part.component)] = used;
  image_correction.find_moments_of_layer(strain, used, part.component, part.layer, work.images);
  return used.is_empty() ? rows : used.first_y;
}

/// Transforms the strain along x, and computes from each plane its used cells and moments. To be called by all threads.
void HalfSpace::Operators::transform_strain_mirrored(std::span<const double> plastic_strain, int layers,
                                                     Work::Buffers& work, MirroredFft::Scratch& scratch) const
{
  constexpr int group = MirroredFft::planes_of_group;
  const int planes = group * MirroredFft::groups(layers);
  const int others = group * (omp_get_num_threads() - 1); // planes of the other threads
#pragma omp for schedule(static, group)                   // strain is wider in layers that are not so deep
  for (int number = 0; number < planes; ++number)
  {
    const MirroredFft::Plane plane = MirroredFft::plane(number, layers);
    const MirroredFft::Plane next = MirroredFft::plane(number + ((number + 1) % group == 0 ? others : 0) + 1, layers);
    const std::array<int, 2> first_rows{prepare_part(plane.first, next.first, plastic_strain, work),
                                        prepare_part(plane.second, next.second, plastic_strain, work)};
    if (!plane.is_empty())
      mirrored_fft.rows_forward(plastic_strain.data(), number, layers, first_rows, work.rows(mirrored_fft.rows_size()),
                                scratch);
  }
}

/// One component of the stress in one layer at the wavenumbers of one block: that of the load plus that of the strain.
/// @param sum  buffer for the sum; unused if there is no load
const ComplexLanes* HalfSpace::Operators::total_stress(int block, const MirroredFft::Part& part,
                                                       const OfTraction<const TractionStress*>& kernels,
                                                       const Work::Buffers& work, ComplexLanes* sum) const
{
  const ComplexLanes* column =
      work.stress.data() + plane_at(volume_fft, block, Deviator::size * part.layer + part.component);
  if (std::all_of(kernels.begin(), kernels.end(), [](const auto* kernel) { return kernel == nullptr; }))
    return column;
  TractionStress::add(kernels, block, part.component, part.layer, surface_fft.waves_along_y(),
                      surface_spectra(block, work), column, next_block(volume_fft, block, column), sum);
  return sum;
}

void HalfSpace::Operators::add_load_and_invert_mirrored(const SurfaceLoad& load, std::span<const double> plastic_strain,
                                                        Work::Buffers& work, std::span<double> stress) const
{
  const auto kernels = kernels_of(parts_of(load));
  const int planes = MirroredFft::planes_of_group * MirroredFft::groups(work.layers);
  const auto threads = static_cast<int>(work.threads.size());
#pragma omp parallel for num_threads(threads) schedule(static)
  for (int number = 0; number < planes; ++number)
  {
    const MirroredFft::Plane plane = MirroredFft::plane(number, work.layers);
    if (plane.is_empty())
      continue;
    MirroredFft::Scratch& scratch = work.threads[static_cast<std::size_t>(omp_get_thread_num())].mirrored;
    for (int block = 0; block < volume_fft.blocks(); ++block)
    {
      const ComplexLanes* first = total_stress(block, plane.first, kernels, work, scratch.of_parts[0].data());
      const ComplexLanes* second = plane.second.is_there()
                                       ? total_stress(block, plane.second, kernels, work, scratch.of_parts[1].data())
                                       : nullptr;
      mirrored_fft.columns_inverse(plane, first, second, block, scratch);
    }
    mirrored_fft.rows_inverse(plane, stress.data(), scratch);
    for (const MirroredFft::Part& part : {plane.first, plane.second})
      if (part.is_there())
        finish(part.component, part.layer, plastic_strain, work, stress.data() + field_at(part.component, part.layer));
  }
}

} // namespace brinell::halfspace
