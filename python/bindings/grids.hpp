// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "arrays.hpp"

#include "brinell/foundation/grid.hpp"

/// Shapes of the arrays on a grid.
namespace brinell::python
{

/// [y, x]
inline Shape shape(const SurfaceGrid& g)
{
  return {static_cast<std::size_t>(g.ny), static_cast<std::size_t>(g.nx)};
}

/// [z, y, x]
inline Shape shape(const VolumeGrid& g)
{
  return {static_cast<std::size_t>(g.nz), static_cast<std::size_t>(g.surface.ny),
          static_cast<std::size_t>(g.surface.nx)};
}

/// [component, z, y, x]
inline Shape tensor_shape(const VolumeGrid& g)
{
  Shape s = shape(g);
  s.insert(s.begin(), 6);
  return s;
}

} // namespace brinell::python
