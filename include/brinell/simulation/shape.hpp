// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <variant>

/// Shapes of the undeformed bodies on the scale of the contact. For finer details of the surfaces see texture.hpp.
namespace brinell::simulation
{

/// A half space without curvature.
struct Plane
{
  bool operator==(const Plane&) const = default;
};

/// Paraboloid x^2/(2 radius_x) + y^2/(2 radius_y): a sphere, a crowned roller or an ellipsoid near its apex (Hertz). A radius may
/// be infinite, or negative for a groove, as long as the two bodies together are convex.
struct Paraboloid
{
  double radius_x = 0.0, radius_y = 0.0; ///< [m], not zero
  bool operator==(const Paraboloid&) const = default;
};

/// A cylinder with its axis along y and plane ends.
struct Roller
{
  double radius = 0.0; ///< [m], > 0
  double length = 0.0; ///< [m], > 0
  bool operator==(const Roller&) const = default;
};

/// A cone, rounded by a ball of the tip radius that touches it from inside.
struct Cone
{
  double half_angle = 0.0; ///< between axis and flank [rad]
  double tip_radius = 0.0; ///< [m], >= 0
  bool operator==(const Cone&) const = default;
};

/// A regular pyramid, rounded in the same way at tip and edges. Vickers: four faces at 68 degrees to the axis; Berkovich:
/// three at 65.27 degrees (the modified one, with the Vickers' ratio of projected area to depth).
struct Pyramid
{
  int faces = 4;
  double face_angle = 0.0; ///< between axis and face [rad]
  double tip_radius = 0.0; ///< [m], >= 0
  bool operator==(const Pyramid&) const = default;
};

using Shape = std::variant<Plane, Paraboloid, Roller, Cone, Pyramid>;

/// Distance of the surface from the tangent plane at its apex, at (x, y) relative to the apex [m].
[[nodiscard]] double height(const Shape& shape, double x, double y);

/// Curvature along x and y at the apex [1/m]; none for tips.
[[nodiscard]] std::optional<std::array<double, 2>> curvature(const Shape& shape);
/// Sum of the curvatures of two bodies along x and y [1/m]; none for tips.
[[nodiscard]] std::optional<std::array<double, 2>> relative_curvature(const Shape& lower, const Shape& upper);
/// Equivalent radius 1/(1/R1 + 1/R2), that of a sphere on a plane with the same relative curvature [m]; none unless this
/// curvature is the same, and > 0, in all directions.
[[nodiscard]] std::optional<double> equivalent_radius(const Shape& lower, const Shape& upper);
/// Whether the contact is finite: the bodies touch in a point, or along a roller of finite length.
[[nodiscard]] bool contact_is_finite(const Shape& lower, const Shape& upper);
/// Length of the shorter roller; infinite without one [m].
[[nodiscard]] double roller_length(const Shape& lower, const Shape& upper);

} // namespace brinell::simulation
