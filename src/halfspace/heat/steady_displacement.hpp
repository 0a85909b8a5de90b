// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/halfspace/steady_field.hpp"
#include "foundation/aligned.hpp"
#include "foundation/fft.hpp"
#include "steady_lattices.hpp"

namespace brinell::halfspace
{

/// Checks that a steady state exists and that the constants are valid.
/// @throws InputError as SteadyField does
void require_steady(const char* function_name, const SurfaceGrid& grid, const Thermal& thermal,
                    const SteadyMotion& motion);

/// Displacement into the body by a unit flux through one cell, at all offsets of the lattices [m per W/m^2].
[[nodiscard]] std::vector<double> steady_displacement(const SteadyLattices& lattices, const Thermal& thermal,
                                                      const Elastic& elastic, const SteadyMotion& motion);

/// Spectrum of the kernel of a convolution on a grid, from a table of its values at all offsets.
[[nodiscard]] AlignedVector<Complex> spectrum_of_offsets(const PaddedFft& fft, std::span<const double> table);

} // namespace brinell::halfspace
