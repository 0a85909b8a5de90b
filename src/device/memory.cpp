// SPDX-License-Identifier: BSD-3-Clause
#include "memory.hpp"

#include "contact/cell_terms.hpp"
#include "foundation/fft.hpp"
#include "half_space.hpp"
#include "halfspace/strain/image_correction.hpp"
#include "halfspace/transform/kernel_places.hpp"
#include "history.hpp"
#include "sums.hpp"

#include <algorithm>
#include <utility>

namespace brinell::device
{

namespace
{

constexpr double of_number = sizeof(double), of_complex = sizeof(ComplexNumber), of_place = sizeof(std::size_t);

/// Operators and buffers of a HalfSpace. Of long grids the waves of the images are left out.
double half_space_bytes(const VolumeGrid& grid, const SurfaceWaves& waves, bool with_shears)
{
  const double planes = 1.0 * Deviator::size * grid.nz, spectrum = static_cast<double>(waves.size());
  const auto stored = static_cast<double>(waves.stored());
  const double buffers = of_complex * spectrum * (2.0 * planes + 4.0); // strain, stress, tractions, displacement
  const double factors = sizeof(StressOfWave::Factors) * stored;
  if (grid.surface.is_periodic())
    return buffers + factors;
  constexpr double functions = halfspace::ImageCorrection::degree + 1.0;
  const double nx = grid.surface.nx, ny = grid.surface.ny;
  const double kernels = (with_shears ? 3.0 : 1.0) * planes * stored;
  const double images = functions * (nx + ny) + planes * functions * (nx + 2.0 * functions);
  return buffers + factors + of_number * (kernels + images);
}

/// Fields, flags and sums.
double field_bytes(const VolumeGrid& grid, const BodyOfMemory& body)
{
  const auto cells = static_cast<double>(grid.size()), surface = static_cast<double>(grid.surface.size());
  const double deviators = 3.0 + body.backstresses + (body.is_heated ? 1.0 : 0.0);
  const double scalars = 1.0 + (body.is_softened ? 1.0 : 0.0);
  const double layers = (body.has_initial_stress ? 2.0 : 1.0) * grid.nz;
  const double flags = cells + static_cast<double>(grid.surface.independent_cells()) * grid.nz;
  const double pieces = static_cast<double>(std::min(grid.size(), first_pieces_of_sums)) + last_pieces_of_sums;
  return of_number * ((Deviator::size * deviators + scalars) * cells + layers +
                      (1.0 + (body.with_shears ? 3.0 : 1.0)) * surface) +
         flags + pieces * (sizeof(LargestError) + sizeof(FoundCells));
}

/// Active cells with their history; arrays that grow may be half as long again.
double trial_bytes(const VolumeGrid& grid, const BodyOfMemory& body)
{
  constexpr double growth = 1.5, packed = 5.0, evaluations = 3.0;
  const double of_cell =
      of_place +
      of_number * (2.0 + Deviator::size * (packed + evaluations + body.backstresses + evaluations * body.history));
  const double places = of_place * static_cast<double>(grid.size() / cells_of_piece + 1);
  const double products = sizeof(AndersonProducts) * body.history * (most_pieces_of_products + last_pieces_of_products);
  return body.active_cells > 0.0 ? growth * (of_cell * body.active_cells + places) + products : 0.0;
}

} // namespace

MemoryOfBody memory_of_contact(const SurfaceGrid& grid)
{
  constexpr double fields = 6.0; // ContactFields
  const PaddedLengths padded = padded_lengths(grid.whole());
  const SurfaceGrid larger = halfspace::with_fast_lengths(grid.whole());
  const auto cells = static_cast<double>(grid.size());
  const double pieces = static_cast<double>(std::min(grid.size(), first_pieces_of_sums)) + last_pieces_of_sums;
  MemoryOfBody memory{of_number * fields * cells +
                      pieces * (sizeof(contact::PressedSum) + sizeof(contact::Errors) + sizeof(contact::Slopes) +
                                sizeof(contact::StepSums) + sizeof(double))};
  for (const auto& [px, py] : {std::pair{padded.x, padded.y}, {larger.nx, larger.ny}})
  {
    const SurfaceWaves waves{px, py, grid.dx, grid.dy};
    memory.arrays += of_number * static_cast<double>(waves.stored()) + of_complex * static_cast<double>(waves.size());
    memory.buffers += 2.0 * of_complex * static_cast<double>(waves.size());
  }
  return memory;
}

MemoryOfBody memory_of_body(const VolumeGrid& grid, const BodyOfMemory& body)
{
  const PaddedLengths padded = padded_lengths(grid.surface.whole());
  const SurfaceWaves waves{padded.x, padded.y, grid.surface.dx, grid.surface.dy};
  const double spectra = of_complex * static_cast<double>(waves.size()) * Deviator::size * grid.nz;
  return {half_space_bytes(grid, waves, body.with_shears) + field_bytes(grid, body) + trial_bytes(grid, body),
          2.0 * spectra};
}

} // namespace brinell::device
