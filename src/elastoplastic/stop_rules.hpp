// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

/// When an increment is given up before it has converged.
namespace brinell::elastoplastic
{

/// Notices when an accelerated iteration runs in circles.
class StallRule
{
public:
  /// @returns whether the error has not halved within the last evaluations with the same active cells.
  bool stalls(double error, bool grew)
  {
    if (grew)
      *this = {};
    else if (error < 0.5 * best_)
    {
      best_ = error;
      since_ = 0;
    }
    else
      ++since_;
    return since_ > patience;
  }

private:
  static constexpr int patience = 20;
  double best_ = 1e300;
  int since_ = 0;
};

/// Notices when the energy of a plain iteration rises.
class EnergyWatch
{
public:
  /// @param evaluation  that the energy comes after, counted from 1: the first one has no earlier one to compare with.
  /// @param grew        cells have joined: the energy may rise.
  bool rises(double energy, int evaluation, bool grew)
  {
    constexpr double rounding = 1e-10;
    const bool rose = evaluation > comparable_ && !grew && energy > last_ + rounding * std::abs(last_);
    last_ = energy;
    return rose;
  }
  /// From `evaluation` on, the energy is another function.
  void begin_anew(int evaluation) { comparable_ = evaluation + 1; }

private:
  int comparable_ = 2; ///< evaluation after which energies can be compared
  double last_ = 0.0;
};

} // namespace brinell::elastoplastic
