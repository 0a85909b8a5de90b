// SPDX-License-Identifier: BSD-3-Clause
#include "pressing.hpp"

#include "brinell/foundation/error.hpp"

namespace brinell::simulation
{

double without_contact(contact::Drive::Kind kind, const Stepper::Distances& touch)
{
  using Kind = contact::Drive::Kind;
  switch (kind)
  {
  case Kind::load:
    return 0.0;
  case Kind::approach:
    return std::min(0.0, touch.smallest);
  case Kind::mean_gap:
    return touch.mean - touch.smallest;
  }
  throw InternalError("a drive of no kind");
}

} // namespace brinell::simulation
