// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/sym_tensor.hpp"

namespace brinell
{

/// A component of the traction that acts on the surface of a body: a positive pressure pushes along the z of the body.
enum class Traction
{
  pressure,
  shear_x,
  shear_y
};

/// The component with x and y exchanged.
[[nodiscard]] constexpr Traction xy_exchanged(Traction traction)
{
  switch (traction)
  {
  case Traction::shear_x:
    return Traction::shear_y;
  case Traction::shear_y:
    return Traction::shear_x;
  case Traction::pressure:
    break;
  }
  return Traction::pressure;
}
[[nodiscard]] constexpr SymTensor xy_exchanged(const SymTensor& t)
{
  return {t[1], t[0], t[2], t[4], t[3], t[5]};
}

} // namespace brinell
