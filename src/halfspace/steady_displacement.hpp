// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/halfspace/steady_field.hpp"
#include "foundation/aligned.hpp"
#include "foundation/fft.hpp"
#include "steady_lattices.hpp"

namespace brinell::halfspace
{

/// @throws InputError as SteadyField does
void require_steady(const char* function_name, const SurfaceGrid& grid, const Thermal& thermal,
                    const SteadyMotion& motion);

/// Displacement into the body by a unit flux through one cell, at all offsets of the lattices [m^3/W].
[[nodiscard]] std::vector<double> steady_displacement(const SteadyLattices& lattices, const Thermal& thermal,
                                                      const Elastic& elastic, const SteadyMotion& motion);

/// The spectrum with which a table of offsets is convolved on a grid.
[[nodiscard]] AlignedVector<Complex> spectrum_of_offsets(const PaddedFft& fft, std::span<const double> table);

} // namespace brinell::halfspace
