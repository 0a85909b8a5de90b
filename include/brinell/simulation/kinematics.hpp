// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/archive.hpp"

namespace brinell::simulation
{

/// Relation between the arc rolled on each body and the sliding distance.
enum class Kinematics
{
  exact, ///< X = omega tan(theta)
  paper  ///< Eqs. 9-13 of the paper: increments omega atan(2 Delta / omega')
};

/// Position of two bodies that are circles in the plane of motion, while one passes the other at constant height.
struct Position
{
  int index = 0;             ///< step index: 0 at alignment (exact) or at first touch (paper)
  double columns = 0.0;      ///< cells that the bodies have moved relative to each other since index 0
  double X = 0.0;            ///< sliding coordinate, 0 at alignment [m]
  double theta = 0.0;        ///< angle of the line of centres to Z, sign of X
  double interference = 0.0; ///< alpha = R1 + R2 - omega'; negative before first touch [m]
  double arc_lower = 0.0;    ///< contact centre on the lower body, from its top [m]
  double arc_upper = 0.0;    ///< contact centre on the upper body, from its bottom [m]; moves against x'

  void exchange(Archive& archive);
};

/// Passing of two spheres (paper, Eqs. 1-14), or of any two bodies that are circles in the plane of motion. Bodies do not
/// rotate: while theta grows by d_theta the contact moves by R1 d_theta along the lower and by -R2 d_theta along the upper
/// body, whatever the radii.
class Passing
{
public:
  /// @param cells  cells of size dx that the bodies move relative to each other per step: (R1 + R2) d_theta / dx.
  Passing(double radius_lower, double radius_upper, double interference, double cells, double dx,
          Kinematics kinematics);

  [[nodiscard]] Position start(int steps_before) const; ///< first touch or just before it, minus some steps
  [[nodiscard]] Position next(const Position& position) const;
  /// Position `columns` cells after `position`, less than one step ahead of it.
  [[nodiscard]] Position within_step(const Position& position, double columns) const;
  /// Index of the first position at or before first touch, and steps from there to the last touch of rigid spheres.
  [[nodiscard]] int first_index() const { return first_; }
  [[nodiscard]] int step_count() const { return count_; }
  [[nodiscard]] double radius_lower() const { return r1_; }
  [[nodiscard]] double radius_upper() const { return r2_; }
  [[nodiscard]] double start_distance() const { return d0_; } ///< Eq. 2 [m]
  [[nodiscard]] double separation() const { return omega_; }  ///< constant height omega of the centres [m]
  [[nodiscard]] double angle_at_touch() const { return theta0_; }

private:
  [[nodiscard]] Position at(int index, double columns, double X) const;

  double r1_, r2_, omega_, dx_, d0_, theta0_, cells_;
  Kinematics kinematics_;
  int first_ = 0, count_ = 0;
};

} // namespace brinell::simulation
