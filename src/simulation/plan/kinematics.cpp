// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/kinematics.hpp"

#include <cmath>

namespace brinell::simulation
{

Passing::Passing(double radius_lower, double radius_upper, double interference, double cells, double dx,
                 Kinematics kinematics)
    : r1_(radius_lower), r2_(radius_upper), omega_(r1_ + r2_ - interference), dx_(dx),
      d0_(std::sqrt((r1_ + r2_) * (r1_ + r2_) - omega_ * omega_)), theta0_(std::atan2(d0_, omega_)), cells_(cells),
      kinematics_(kinematics)
{
  if (kinematics_ == Kinematics::exact)
  {
    // The tiny reduction prevents a further step when a step lands exactly on first touch up to rounding.
    first_ = -static_cast<int>(std::ceil((1.0 - 1e-12) * theta0_ * (r1_ + r2_) / (cells_ * dx_)));
    count_ = -2 * first_;
    return;
  }
  for (Position p = start(0); p.X < d0_; p = next(p))
    ++count_;
}

void Position::exchange(Archive& archive)
{
  archive("index", index);
  archive("columns", columns);
  archive("X", X);
  archive("theta", theta, -4.0, 4.0);
  archive("interference", interference);
  archive("arc_lower", arc_lower);
  archive("arc_upper", arc_upper);
}

Position Passing::at(int index, double columns, double X) const
{
  const double first_arc = kinematics_ == Kinematics::exact ? 0.0 : -theta0_ * (r1_ + r2_);
  const double arc = first_arc + columns * dx_;
  Position p;
  p.index = index;
  p.columns = columns;
  p.X = kinematics_ == Kinematics::exact ? omega_ * std::tan(arc / (r1_ + r2_)) : X;
  p.theta = std::atan2(p.X, omega_);
  p.interference = r1_ + r2_ - std::hypot(omega_, p.X);
  p.arc_lower = arc * r1_ / (r1_ + r2_);
  p.arc_upper = -arc * r2_ / (r1_ + r2_);
  return p;
}

Position Passing::start(int steps_before) const
{
  double X = -d0_;
  for (int i = 0; i < steps_before; ++i)
    X -= omega_ * std::atan(cells_ * dx_ / std::hypot(omega_, X));
  const int index = first_ - steps_before;
  return at(index, index * cells_, X);
}

Position Passing::next(const Position& p) const
{
  return within_step(p, cells_);
}

Position Passing::within_step(const Position& p, double columns) const
{
  // Eq. 9, where 2 Delta is the sum of the arcs on both bodies.
  const double X = p.X + omega_ * std::atan(columns * dx_ / std::hypot(omega_, p.X));
  return at(columns == cells_ ? p.index + 1 : p.index, p.columns + columns, X);
}

} // namespace brinell::simulation
