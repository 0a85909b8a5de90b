// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"

namespace brinell::halfspace
{

/// Layers of which ranks pass one component at a time: whole turns of dealing them out, at least a pair for each thread.
/// @param threads  of the rank that has most
[[nodiscard]] int layers_at_a_time(const SurfaceGrid& grid, int ranks, int threads);

/// Memory of a HalfSpace on a grid [bytes].
struct MemoryOfHalfSpace
{
  double operators; ///< kernels and image correction
  double work;      ///< of an evaluation (HalfSpace::Work)
  double trace;     ///< in addition to `work`, while the stress is computed for output
};

/// Number of blocks of wavenumbers whose strain is stored at a time. If the blocks divide evenly among the threads, it is one per
/// thread: the values that a thread has written then stay in its cache until it reads them. Otherwise the threads share each
/// block, and one block is transformed while others still work on the block before.
[[nodiscard]] int blocks_at_a_time(int blocks, int threads);

/// For as many threads as OpenMP may use, and at least two, so that a prediction does not differ between one and two threads.
/// @param shears  number of components of the shear on the surface, 0 to 2
/// @param ranks   that share it: memory of the first of them, which needs most
/// @param materials  of the layers of cells
[[nodiscard]] MemoryOfHalfSpace memory_of_half_space(const VolumeGrid& grid, int shears, int ranks = 1,
                                                     int materials = 1);

} // namespace brinell::halfspace
