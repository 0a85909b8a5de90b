// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "brinell/foundation/sym_tensor.hpp"
#include "brinell/green/stack.hpp"
#include "brinell/green/traction.hpp"
#include "halfspace/transform/cell_response.hpp"
#include "stack_lattice.hpp"

#include <array>
#include <vector>

/// Response of the cells of a layered body to a unit traction on one cell: that of a homogeneous body in closed form, and an
/// excess, which is a smooth function of the distance. Of the excess, the part of the long waves is a closed form, too: that of
/// a load at some depth. The rest is short-ranged and follows from a lattice of waves: docs/theory/stacks.md (stack-cells).
namespace brinell::halfspace
{

/// Displacement along z by a unit pressure on a cell of a layered body, less that of a homogeneous body of its top material
/// [m/Pa].
/// @param reference  as for cell_displacement
[[nodiscard]] Quadrant<double> excess_displacement(const SurfaceGrid& surface, const ElasticStack& stack,
                                                   double reference);

/// Stress under a unit traction on a cell of a layered body, as the mean over a layer of cells, less that of a homogeneous body
/// with Poisson's ratio of the material in the middle of these cells [-].
class ExcessStress
{
public:
  /// @param grid      open along x or y at least
  /// @param traction  pressure, or shear along x
  ExcessStress(const VolumeGrid& grid, const ElasticStack& stack, Traction traction);
  [[nodiscard]] Quadrant<SymTensor> of_layer(int layer) const;

  static constexpr std::size_t part_count = 6; ///< ll, tt, zz, lz, lt, tz
  using Parts = std::array<double, part_count>;

private:
  /// The fields of one wavenumber.
  struct Node
  {
    green::StackWave wave;
    double k;
    std::vector<green::StackWave::Field> fields; ///< by a pressure, or by shears along and across
  };
  /// Closed forms of waves at the depth H: products of the components of the direction and e^{-kH}, and k H e^{-kH} times those.
  struct Forms
  {
    LongWaves xx, yy, xy;         ///< of lx^2, ly^2, lx ly
    LongWaves xxx, xyy, xxy, yyy; ///< of lx^3, lx ly^2, lx^2 ly, ly^3
  };
  [[nodiscard]] Node node_at(double k) const;
  [[nodiscard]] Parts excess(const Node& node, int layer) const;
  [[nodiscard]] std::array<LongWaves, part_count> long_waves_of(int layer) const;
  [[nodiscard]] Forms forms_at(int i, int j) const;

  VolumeGrid grid_;
  ElasticStack stack_;
  Traction traction_;
  double depth_; ///< H [m]
  double smallest_;
  std::vector<Node> nodes_, long_nodes_;
  /// Stress at the depth H in bodies with Poisson's ratios 0 and 1/2.
  std::array<Quadrant<SymTensor>, 2> by_pressure_, by_shear_x_, by_shear_y_;
};

/// Stress of a wave of unit traction in the axes x, y, z, as the mean over a layer of cells [-], without the factor i in those
/// amplitudes that are odd in x and even in y, or the other way round.
/// @param k       wavenumber [rad/m], > 0, and its direction
[[nodiscard]] SymTensor stack_wave_stress(const ElasticStack& stack, Traction traction, double k, double lx, double ly,
                                          double from, double to);

} // namespace brinell::halfspace
