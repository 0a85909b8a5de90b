// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/sym_tensor.hpp"

namespace brinell
{

/// A component of the traction on the surface of a body, all of which act on the body: the pressure pushes along its z.
enum class Traction
{
  pressure,
  shear_x,
  shear_y
};

/// The same where x and y have changed names.
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
