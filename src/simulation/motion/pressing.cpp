// SPDX-License-Identifier: BSD-3-Clause
#include "pressing.hpp"

#include "brinell/foundation/error.hpp"

#include <cmath>

namespace brinell::simulation
{

double pressed_between(contact::Drive::Kind kind, double from, double to, double share)
{
  if (kind != contact::Drive::Kind::load)
    return from + (to - from) * share;
  const double root = std::pow(from, 2.0 / 3.0);
  return share == 1.0 ? to : std::pow(root + (std::pow(to, 2.0 / 3.0) - root) * share, 1.5);
}

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
