// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/increment.hpp"
#include "brinell/foundation/archive.hpp"

#include <utility>

namespace brinell::simulation
{

/// Work of the drive from step to step, by the trapezoidal rule.
class DriveMeter
{
public:
  /// The drive at the end of a step; forces along x are signed.
  struct State
  {
    double x = 0.0, approach = 0.0, F_n = 0.0, F_x = 0.0; ///< [m], [m], [N], [N]
    double shear = 0.0;                                   ///< share of the shear in F_x [N]

    void exchange(Archive& archive)
    {
      archive("x", x);
      archive("approach", approach);
      archive("F_n", F_n);
      archive("F_x", F_x);
      archive("shear", shear);
    }
  };
  /// Work of a step [J]: of the drive, and of the shear in it.
  struct Work
  {
    double drive, shear;
  };

  [[nodiscard]] const State& last() const { return last_; }
  /// Begins anew, without forces.
  void begin(double x, double approach) { last_ = {.x = x, .approach = approach}; }
  /// At the beginning and at a reversal of the motion the shear is that of the motion before the bodies move.
  void start_with_shear(double shear)
  {
    last_.F_x += shear - last_.shear;
    last_.shear = shear;
  }
  /// Takes over the forces under which the contact begins to slide, when friction has been raised at rest.
  /// @param along_x  force along x as a function of the force of the shear on the sliding surfaces
  template <typename Along>
  void read_onset(const elastoplastic::CoupledContact& pair, const Along& along_x)
  {
    const double load = pair.load(), approach = pair.approach();
    work_at_rest_ = 0.5 * (load + last_.F_n) * (approach - last_.approach);
    const auto [F_x, shear] = along_x(pair.sliding()->forces()[0]);
    last_ = {last_.x, approach, load, F_x, shear};
  }
  /// The work up to the end of a step, from which the next one begins.
  [[nodiscard]] Work to(const State& now)
  {
    const double moved = now.x - last_.x;
    const Work work{std::exchange(work_at_rest_, 0.0) + 0.5 * (now.F_n + last_.F_n) * (now.approach - last_.approach) +
                        0.5 * (now.F_x + last_.F_x) * moved,
                    0.5 * (now.shear + last_.shear) * moved};
    last_ = now;
    return work;
  }

  void exchange(Archive& archive) { archive("last", last_); }

private:
  State last_;
  double work_at_rest_ = 0.0; ///< of the load in the current step, while friction was raised [J]
};

} // namespace brinell::simulation
