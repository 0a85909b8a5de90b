// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"

#include <cstddef>

namespace brinell::device
{

/// Properties of a body on which its memory on a device depends, besides its grid.
struct BodyOfMemory
{
  int backstresses = 0; ///< terms of kinematic hardening
  bool with_shears = false, has_initial_stress = false, is_heated = false, is_softened = false;
  double active_cells = 0.0; ///< at most
  int history = 0;           ///< differences that the acceleration keeps
};

/// Memory of a body, or of the contact [bytes].
struct MemoryOfBody
{
  double arrays = 0.0;  ///< as BodyOnExecutor or ContactOnExecutor allocates them
  double buffers = 0.0; ///< of cuFFT beside them: up to a spectrum for each direction
};

[[nodiscard]] MemoryOfBody memory_of_contact(const SurfaceGrid& grid);
[[nodiscard]] MemoryOfBody memory_of_body(const VolumeGrid& grid, const BodyOfMemory& body);

} // namespace brinell::device
