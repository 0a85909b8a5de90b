// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <variant>
#include <vector>

/// Surfaces of bodies before they are loaded: their shape on the scale of the contact, and what lies on it.
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

/// No texture.
struct Smooth
{
  bool operator==(const Smooth&) const = default;
};

/// A round dent with a shoulder, depth * 10^(-10 (r/radius)^2) cos(2 pi r/radius), as often used for rolling over dents
/// (Lubrecht, Venner; Ville and Nelias 1999). Negative depth: a bump.
struct Dent
{
  double x = 0.0, y = 0.0; ///< centre on the body's surface [m]
  double depth = 0.0;      ///< [m]
  double radius = 0.0;     ///< [m], > 0; the dent itself reaches to a quarter of it
  bool operator==(const Dent&) const = default;
};

/// Heights on a grid, linear between its points, zero outside.
struct HeightMap
{
  int nx = 0, ny = 0;            ///< points, x runs fastest
  double dx = 0.0, dy = 0.0;     ///< [m]
  double x = 0.0, y = 0.0;       ///< centre on the body's surface [m]
  std::vector<double> heights{}; ///< out of the body positive [m]
  bool operator==(const HeightMap&) const = default;
};

/// Fixed to the material, where the shape stays with the contact.
using Texture = std::variant<Smooth, Dent, HeightMap>;

/// Depth into the body of its surface at (x, y) [m].
[[nodiscard]] double depth(const Texture& texture, double x, double y);
/// What a cell of dx by dy around (x, y) has of it [m]: the depth at its centre, or the mean over it if the texture is finer
/// than the cells, so that nothing falls between their centres.
[[nodiscard]] double cell_depth(const Texture& texture, double x, double y, double dx, double dy);

/// What a texture can add to its body at most.
struct TextureReach
{
  double height = 0.0;       ///< above the smooth surface [m]
  double half_width_y = 0.0; ///< from the middle of the body's surface [m]
};
[[nodiscard]] TextureReach reach(const Texture& texture);

/// A texture from a function of x and y: its heights on a grid of points, out of the body positive. A function itself could be
/// neither stored with a result nor compared nor taken up by another process; its heights can, and so can the run.
/// @param height  at a place on the body's surface [m].
/// @param nx, ny  points; dx, dy their distances [m]: as fine as the cells, or finer.
/// @param x, y  centre of the map on the body's surface [m]; outside it the surface is smooth.
/// @throws InputError without points, or if the function gives a height that is not finite
[[nodiscard]] HeightMap sampled(const std::function<double(double x, double y)>& height, int nx, int ny, double dx,
                                double dy, double x = 0.0, double y = 0.0);

} // namespace brinell::simulation
