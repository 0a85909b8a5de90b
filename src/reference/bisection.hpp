// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace brinell::reference
{

/// Root of f between `positive`, where f >= 0, and `negative`, where f <= 0, to the last bit that the interval
/// resolves.
template <class F>
double bisected_root(F f, double positive, double negative)
{
  for (int i = 0; i < 200; ++i)
  {
    const double middle = 0.5 * (positive + negative);
    if (middle == positive || middle == negative)
      break;
    (f(middle) >= 0.0 ? positive : negative) = middle;
  }
  return 0.5 * (positive + negative);
}

} // namespace brinell::reference
