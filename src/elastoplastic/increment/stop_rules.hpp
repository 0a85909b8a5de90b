// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

/// Rules that give up an increment before it has converged.
namespace brinell::elastoplastic
{

/// Evaluations in which the error of an accelerated iteration has to halve.
constexpr int usual_patience = 20;

/// Detects that an accelerated iteration makes no progress.
class StallRule
{
public:
  /// @param is_new  whether earlier errors are those of another problem, as cells have become active or a window was left: the
  ///                count starts again
  /// @param patience  evaluations in which the error has to halve
  /// @returns whether it has not
  bool stalls(double error, bool is_new, int patience = usual_patience)
  {
    if (is_new)
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
  double best_ = 1e300;
  int since_ = 0;
};

/// Detects that the energy of a plain iteration rises.
class EnergyWatch
{
public:
  /// @param evaluation  number of the evaluation that gave the energy, counts from 1; the first has no predecessor to compare
  ///                    with
  /// @param grew        whether cells have become active: the energy may then rise
  bool rises(double energy, int evaluation, bool grew)
  {
    constexpr double rounding = 1e-10;
    const bool rose = evaluation > comparable_ && !grew && energy > last_ + rounding * std::abs(last_);
    last_ = energy;
    return rose;
  }
  /// After `evaluation` the energy is a different function: earlier values are not compared with later ones.
  void begin_anew(int evaluation) { comparable_ = evaluation + 1; }

private:
  int comparable_ = 2; ///< energies of later evaluations are compared with their predecessor
  double last_ = 0.0;
};

} // namespace brinell::elastoplastic
