// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "brinell/foundation/sym_tensor.hpp"
#include "brinell/green/elastic.hpp"

#include <functional>

namespace brinell::direct
{

/// Plastic strain [-] that is smooth in x and y [m] and constant in each layer; x = y = 0 is the centre of cell (0, 0).
using LayeredStrain = std::function<SymTensor(double x, double y, int layer)>;

/// Residual stress [Pa] of such a strain at the middle of cell (i, j) in x and y, mean over layer k (three-point Gauss),
/// under a free surface without images: the closed form of the cuboid, summed over parts^2 sub-cells of each cell, each
/// with the strain at its centre. Error of second order in the sub-cell.
/// @param parts  odd, so that the point lies in the middle of a sub-cell.
[[nodiscard]] SymTensor layered_strain_stress(const VolumeGrid& grid, const LayeredStrain& strain, int i, int j, int k,
                                              int parts, const Elastic& elastic);

/// The same, with the second order removed by a sum with two parts fewer (Richardson).
[[nodiscard]] SymTensor extrapolated_strain_stress(const VolumeGrid& grid, const LayeredStrain& strain, int i, int j,
                                                   int k, int parts, const Elastic& elastic);

} // namespace brinell::direct
