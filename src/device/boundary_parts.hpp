// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "brinell/green/elastic.hpp"

#include <array>
#include <functional>
#include <span>
#include <vector>

namespace brinell::device
{

/// Parts of a half space that depend on its boundary along x and y, as plain numbers: prepared on the processor, used by kernels.
struct BoundaryParts
{
  int px = 0, py = 0; ///< lengths of the transforms

  /// Stored numbers of the kernels of a traction, [layer][component of the deviator][wave], for the `stored` SurfaceWaves; in the order of
  /// Traction. Empty: those of waves (halfspace::wave_stress), for bodies that are periodic along both axes.
  std::array<std::vector<double>, 3> kernels;

  /// Functions of x and of y, [function][column] and [function][row], whose products represent the strain and the stress of its periodic
  /// images; empty: no images are to be removed.
  std::vector<double> x_functions, y_functions;
  /// Coefficients of the stress of the images, [component][layer][function of y][function of x], from the moments of the strain: sums of
  /// its product with the functions, in the same order.
  std::function<void(std::span<const double> moments, std::span<double> coefficients)> images;
};

/// The boundary of a homogeneous body.
/// @param with_shears  whether there are loads by shear or displacements along the surface
[[nodiscard]] BoundaryParts boundary_of(const VolumeGrid& grid, const Elastic& elastic, bool with_shears);

} // namespace brinell::device
