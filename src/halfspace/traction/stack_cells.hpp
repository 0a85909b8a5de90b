// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "brinell/foundation/sym_tensor.hpp"
#include "brinell/green/stack.hpp"
#include "brinell/green/traction.hpp"
#include "halfspace/transform/cell_response.hpp"
#include "radial_fields.hpp"

#include <optional>
#include <vector>

/// Stress under the cells of a layered body by a unit traction on one cell: that of a homogeneous body in closed form, and an
/// excess, a smooth function of the distance that follows from its waves: docs/theory/stacks.md (stack-cells).
namespace brinell::halfspace
{

/// Stress under a unit traction on a cell of a layered body, as the mean over a layer of cells, less that of homogeneous bodies
/// with Poisson's ratios of the materials in these cells [-].
class ExcessStress
{
public:
  /// @param grid      open along x or y at least
  /// @param traction  pressure, or shear along x
  ExcessStress(const VolumeGrid& grid, const ElasticStack& stack, Traction traction);
  [[nodiscard]] Quadrant<SymTensor> of_layer(int layer) const;

private:
  SurfaceGrid grid_;
  Traction traction_;
  WaveScales scales_;
  std::vector<RadialFields::Table> waves_; ///< [layer]
  std::optional<RadialFields> open_;       ///< if both axes are
};

/// Stress of a wave of unit traction in the axes x, y, z, as the mean over a layer of cells [-], without the factor i in those
/// amplitudes that are odd in x and even in y, or the other way round.
/// @param k       wavenumber [rad/m], > 0, and its direction
[[nodiscard]] SymTensor stack_wave_stress(const ElasticStack& stack, Traction traction, double k, double lx, double ly,
                                          double from, double to);

} // namespace brinell::halfspace
