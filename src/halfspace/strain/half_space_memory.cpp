// SPDX-License-Identifier: BSD-3-Clause
#include "half_space_memory.hpp"

#include "brinell/foundation/share.hpp"
#include "foundation/fft.hpp"
#include "foundation/lanes.hpp"

#include <algorithm>
#include <cmath>
#include <omp.h>

namespace brinell::halfspace
{

int blocks_at_a_time(int blocks, int threads)
{
  constexpr double nearly_all = 0.9; // share of the threads that get a block
  const int rounds = (blocks + threads - 1) / threads;
  return blocks >= nearly_all * rounds * threads ? threads : 2;
}

int layers_at_a_time(const SurfaceGrid& grid, int ranks, int threads)
{
  // Measured on two ranks of one machine: rows that stay in the caches pass twice as fast. Over a network messages of at least
  // 64 KiB take longer than their latency.
  constexpr double in_caches = 1024.0 * 1024, of_message = 64.0 * 1024;
  const int blocks = (padded_lengths(grid).x / 2 + lane_count) / lane_count;
  const double bytes = 1.0 * blocks * grid.independent_rows() * sizeof(ComplexLanes); // of a layer
  const double wanted = std::max(in_caches, of_message * ranks) / bytes;
  constexpr int together = Share::layers_together;
  const int own = std::max(static_cast<int>(std::min(wanted, 1e6)), together * threads); // layers of a rank
  return (own + together - 1) / together * together * ranks;
}

MemoryOfHalfSpace memory_of_half_space(const VolumeGrid& grid, int shears, int ranks, int materials)
{
  // As in BlockedFft: blocks of wavenumbers along x, and rows along y with or without their padding. Rows of the strain share the
  // memory of the stress.
  const PaddedLengths padded = padded_lengths(grid.surface);
  const int along_x = padded.x / 2 + 1, along_y = padded.y / 2 + 1; // wavenumbers of half of the spectrum
  const int of_all = (along_x + lane_count - 1) / lane_count;
  const double blocks = Share(0, ranks).blocks(of_all).count();
  const double pitch = padded.y | 1;
  const double rows = grid.surface.ny;
  const double tractions = 1.0 + shears;
  const double deviators = 5.0 * grid.nz; // planes
  const double kernels = 6.0 * grid.nz * along_y;

  // Numbers of StackStress: directions and decays, those at the surface, and the interfaces.
  const double of_layers = materials > 1 ? (16.0 + 5.0 + 22.0 * materials) * along_y : 0.0;

  // The memory of ImageCorrection is almost independent of the grid.
  constexpr double images = 2.5e6;
  const double strained_blocks = std::max(2, blocks_at_a_time(static_cast<int>(blocks), omp_get_max_threads()));
  const double strain_and_stress = deviators * (blocks + strained_blocks) * pitch;
  const int together = std::min(grid.nz, layers_at_a_time(grid.surface, ranks, omp_get_max_threads()));
  const double passed =
      ranks > 1 ? rows * (Share(0, ranks).count(together) * of_all + together * blocks) : 0.0; // Exchange
  const double surface = tractions * blocks * (rows + pitch) + 1.5 * grid.nz * pitch;
  return {.operators =
              (tractions * kernels + of_layers) * blocks * sizeof(Lanes) + images + passed * sizeof(ComplexLanes),
          .work = (strain_and_stress + surface) * sizeof(ComplexLanes),
          .trace = grid.nz * blocks * pitch * sizeof(ComplexLanes)};
}

} // namespace brinell::halfspace
