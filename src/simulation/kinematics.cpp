// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/kinematics.hpp"

#include <cmath>

namespace brinell::simulation
{

Passing::Passing(double radius_lower, double radius_upper, double interference, double relative_shift,
                 Kinematics kinematics)
    : r1_(radius_lower), r2_(radius_upper), omega_(r1_ + r2_ - interference), shift_(relative_shift),
      d0_(std::sqrt((r1_ + r2_) * (r1_ + r2_) - omega_ * omega_)), theta0_(std::atan2(d0_, omega_)),
      kinematics_(kinematics)
{
  if (kinematics_ == Kinematics::exact)
  {
    // The tiny reduction keeps a step that lands on first touch by rounding from being doubled.
    first_ = -static_cast<int>(std::ceil((1.0 - 1e-12) * theta0_ * (r1_ + r2_) / shift_));
    count_ = -2 * first_;
    return;
  }
  for (Position p = start(0); p.X < d0_; p = next(p))
    ++count_;
}

Position Passing::at(int index, double X, double arc) const
{
  const double local_separation = std::hypot(omega_, X);
  Position p;
  p.index = index;
  p.X = X;
  p.theta = std::atan2(X, omega_);
  p.interference = r1_ + r2_ - local_separation;
  p.arc_lower = arc * r1_ / (r1_ + r2_);
  p.arc_upper = -arc * r2_ / (r1_ + r2_);
  return p;
}

Position Passing::start(int steps_before) const
{
  if (kinematics_ == Kinematics::exact)
  {
    const int index = first_ - steps_before;
    const double arc = index * shift_;
    return at(index, omega_ * std::tan(arc / (r1_ + r2_)), arc);
  }
  double X = -d0_;
  for (int i = 0; i < steps_before; ++i)
    X -= omega_ * std::atan(shift_ / std::hypot(omega_, X));
  return at(-steps_before, X, -theta0_ * (r1_ + r2_) - steps_before * shift_);
}

Position Passing::next(const Position& p) const
{
  const int index = p.index + 1;
  if (kinematics_ == Kinematics::exact)
  {
    const double arc = index * shift_;
    return at(index, omega_ * std::tan(arc / (r1_ + r2_)), arc);
  }
  // Eq. 9 with 2 Delta the arc moved on both bodies together.
  const double X = p.X + omega_ * std::atan(shift_ / std::hypot(omega_, p.X));
  return at(index, X, -theta0_ * (r1_ + r2_) + index * shift_);
}

} // namespace brinell::simulation
