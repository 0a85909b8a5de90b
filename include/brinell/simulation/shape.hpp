// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <variant>

/// Surfaces of bodies before they are loaded: their shape on the scale of the contact. What lies on it: texture.hpp.
namespace brinell::simulation
{

/// A half space without curvature.
struct Plane
{
  bool operator==(const Plane&) const = default;
};

/// x^2/(2 radius_x) + y^2/(2 radius_y): a sphere, a crowned roller or an ellipsoid near its apex (Hertz). A radius may be
/// infinite, and negative for a groove, as long as the two bodies together are convex.
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

/// Distance of the surface from the plane that touches it at its apex, at (x, y) from there [m].
[[nodiscard]] double height(const Shape& shape, double x, double y);

/// Curvature along x and y at the apex [1/m]; none for tips.
[[nodiscard]] std::optional<std::array<double, 2>> curvature(const Shape& shape);
/// Sum of those of two bodies.
[[nodiscard]] std::optional<std::array<double, 2>> relative_curvature(const Shape& lower, const Shape& upper);
/// Radius of a sphere that would touch a plane as the bodies touch each other, 1/(1/R1 + 1/R2) [m]; none unless their relative
/// curvature is the same, and > 0, in all directions.
[[nodiscard]] std::optional<double> equivalent_radius(const Shape& lower, const Shape& upper);
/// Whether the bodies touch in a point, or in a line that a roller ends, so that their contact is finite.
[[nodiscard]] bool contact_is_finite(const Shape& lower, const Shape& upper);
/// Length of the shorter roller; infinite without one [m].
[[nodiscard]] double roller_length(const Shape& lower, const Shape& upper);

} // namespace brinell::simulation
