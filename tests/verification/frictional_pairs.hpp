// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/frictional_contact.hpp"
#include "grid_fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

/// Elastic bodies that touch with friction.
namespace brinell::verification
{

using contact::Drive;
using contact::FrictionReport;
using contact::FrictionState;
using contact::TangentialDrive;
using test::Field;

inline constexpr double pi = std::numbers::pi;
inline const Elastic rigid{std::numeric_limits<double>::infinity(), 0.0};

inline TangentialDrive::Axis force(double value)
{
  return {TangentialDrive::Kind::force, value};
}
inline TangentialDrive::Axis shift(double value)
{
  return {TangentialDrive::Kind::shift, value};
}

/// Two bodies, the shape between them, and how they are pressed together.
struct Pair
{
  SurfaceGrid grid;
  Elastic body1, body2;
  double friction;
  double relative = 1e-8; ///< tolerances, over displacements
  halfspace::SurfaceCompliance compliance;
  contact::FrictionalContact contact;
  Field distance, gap, slip_x, slip_y;
  double scale; ///< of the approach [m]

  Pair(const SurfaceGrid& g, const Elastic& one, const Elastic& two, double coefficient, Field shape, double length,
       double reference = 0.0)
      : grid(g), body1(one), body2(two), friction(coefficient), compliance(g, one, two, reference), contact(compliance),
        distance(std::move(shape)), gap(g.size()), slip_x(g.size()), slip_y(g.size()), scale(length)
  {
  }

  FrictionReport step(const Drive& drive, const TangentialDrive& tangential, FrictionState& state,
                      const std::array<int, 2>& carried = {})
  {
    contact::FrictionTolerances tolerances;
    tolerances.gap = relative * scale;
    tolerances.slip = relative * std::min(friction, 1.0) * scale;
    FrictionReport report =
        contact.step(distance, drive, tangential, friction, tolerances, state, gap, {slip_x, slip_y}, {}, carried);
    EXPECT_TRUE(report.converged) << report.alternations << " alternations, " << report.tangential.iterations;
    return report;
  }
  [[nodiscard]] FrictionState untouched() const { return FrictionState(grid.size()); }
  /// How many cells stick.
  [[nodiscard]] double sticking_area(const FrictionState& s) const
  {
    double count = 0.0;
    for (std::size_t i = 0; i < grid.size(); ++i)
      count += s.pressure[i] > 0.0 &&
               std::hypot(s.shear_x[i], s.shear_y[i]) < contact::slip_threshold * friction * s.pressure[i];
    return count * grid.cell_area();
  }
};

inline Field paraboloid(const SurfaceGrid& g, double radius)
{
  return test::sampled(g, [&](int i, int j) { return (std::pow(g.x(i), 2) + std::pow(g.y(j), 2)) / (2.0 * radius); });
}

/// Two equal balls of 2 R each, R = 100, that touch on a circle of radius 1; shear modulus 1.
struct Balls : Pair
{
  static constexpr double R = 100.0, mu = 0.3;
  double nu, P;

  Balls(int cells, double poisson_ratio)
      : Pair(square(cells), {2.0 * (1.0 + poisson_ratio), poisson_ratio}, {2.0 * (1.0 + poisson_ratio), poisson_ratio},
             mu, paraboloid(square(cells), R), 1.0 / R),
        nu(poisson_ratio), P(4.0 / 3.0 / R / (1.0 - poisson_ratio))
  {
  }
  static SurfaceGrid square(int cells)
  {
    const int n = 2 * cells + 5;
    return {n, n, 1.0 / cells, 1.0 / cells};
  }
  /// Shift at which all slides (Mindlin 1949), G = a = 1.
  [[nodiscard]] double sliding_shift() const { return 3.0 * mu * P * (2.0 - nu) / 8.0; }
  /// Hertz's pressure at radius r on a contact of radius c.
  [[nodiscard]] double pressure(double r, double c) const
  {
    return r < c ? 1.5 * P / pi * std::sqrt(c * c - r * r) : 0.0;
  }
  FrictionReport push(const TangentialDrive& tangential, FrictionState& state)
  {
    return step({Drive::Kind::load, P}, tangential, state);
  }
  FrictionReport push(double share, FrictionState& state) { return push({force(share * mu * P), shift(0.0)}, state); }
};

} // namespace brinell::verification
