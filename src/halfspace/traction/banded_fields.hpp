// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "halfspace/transform/cell_response.hpp"
#include "radial_table.hpp"
#include "wave_terms.hpp"

namespace brinell::halfspace
{

/// Field of a unit traction on one cell of a surface that is open along one axis and periodic along the other one, from its waves.
/// Waves along the periodic axis decay over their length along the open one, and are summed on a lattice. The field that is uniform
/// along the periodic axis, which reaches far, is an integral.
/// @param reference  as for `cell_displacement`
[[nodiscard]] Quadrant<WaveComponents> banded_cells(const SurfaceGrid& grid, const WaveScales& scales, WaveTerms terms,
                                                    const RadialTable<std::tuple_size_v<WaveParts>>& waves,
                                                    double reference);

} // namespace brinell::halfspace
