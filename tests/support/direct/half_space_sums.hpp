// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "brinell/foundation/sym_tensor.hpp"
#include "brinell/green/elastic.hpp"

#include <span>
#include <vector>

/// The slow, obvious twins of the half-space operators: sums of closed forms over all pairs of cells, O(N^2), no FFT.
/// Values belong to cell centres; pressure is constant on a rectangle, eigenstrain in a cuboid.
namespace brinell::direct
{

/// Surface displacement [m] at the centres under a pressure [Pa]; compliance = sum of (1 - nu^2)/E [1/Pa].
[[nodiscard]] std::vector<double> pressure_to_displacement(const SurfaceGrid& grid, std::span<const double> pressure,
                                                           double compliance);

/// Stress [Pa] at the centres of the volume's cells under a pressure [Pa] on its surface.
[[nodiscard]] std::vector<SymTensor> pressure_to_stress(const VolumeGrid& grid, std::span<const double> pressure,
                                                        double poisson_ratio);

/// Residual stress [Pa] at the centres, the surface being free of traction.
[[nodiscard]] std::vector<SymTensor>
eigenstrain_to_stress(const VolumeGrid& grid, std::span<const SymTensor> eigenstrain, const Elastic& elastic);

/// Normal displacement of the free surface [m] at the centres, into the body positive.
[[nodiscard]] std::vector<double>
eigenstrain_to_displacement(const VolumeGrid& grid, std::span<const SymTensor> eigenstrain, double poisson_ratio);

} // namespace brinell::direct
