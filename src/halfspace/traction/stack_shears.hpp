// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "brinell/green/stack.hpp"
#include "halfspace/transform/cell_response.hpp"

#include <array>
#include <vector>

/// Displacement of the surface of a layered body by pressure and shears, less that of a homogeneous body of its top material:
/// docs/theory/stacks.md (stack-shears).
namespace brinell::halfspace
{

/// A layered body of a pair. Its shear is that on body 1 times `sign`, and so is its part of the displacement along the surface.
struct LayeredBody
{
  ElasticStack stack;
  double sign = 1.0; ///< 1 for body 1, -1 for body 2
};

/// Order of the terms of `SurfaceExcess`.
namespace excess
{
enum Term : std::size_t
{
  zz, ///< along z by a pressure
  xx,
  yy,
  xy, ///< along x by a shear along y, and along y by one along x
  x,  ///< along z by a shear along x; along x by a pressure with the opposite sign
  y,  ///< along z by a shear along y; along y by a pressure with the opposite sign
  count
};
} // namespace excess

/// Displacement by a unit traction on one cell [m/Pa].
using SurfaceExcess = std::array<double, excess::count>;

/// @param surface    open along x or y at least
/// @param reference  as for cell_displacement, in all directions
/// @param of         displacement in place of that along z by a pressure: that across a shear, only with Poisson's ratios of 0,
///                   where a homogeneous body has the same of both
[[nodiscard]] Quadrant<SurfaceExcess>
excess_surface(const SurfaceGrid& surface, const ElasticStack& stack, double reference,
               double green::WaveCompliance::*of = &green::WaveCompliance::normal);
[[nodiscard]] Quadrant<SurfaceExcess> excess_surface(const SurfaceGrid& surface, const std::vector<LayeredBody>& bodies,
                                                     double reference);

/// Displacement by a wave of unit traction with the wavevector (m, n), not zero [m/Pa]; x and y must be multiplied by i.
[[nodiscard]] SurfaceExcess excess_wave(const ElasticStack& stack, double m, double n);
[[nodiscard]] SurfaceExcess excess_wave(const std::vector<LayeredBody>& bodies, double m, double n);

} // namespace brinell::halfspace
