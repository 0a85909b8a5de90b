// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/sym_tensor.hpp"
#include "enclosing_ball.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

/// Search for the plane on which shear amplitude and normal stress of a cycle are worst.
namespace brinell::constitutive
{

using Vector3 = std::array<double, 3>;

inline Vector3 cross(const Vector3& a, const Vector3& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double dot3(const Vector3& a, const Vector3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector3 unit(const Vector3& a)
{
  const double length = std::sqrt(dot3(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}
/// Traction of a stress on the plane with a unit normal.
inline Vector3 traction(const SymTensor& s, const Vector3& n)
{
  return {s[0] * n[0] + s[5] * n[1] + s[4] * n[2], s[5] * n[0] + s[1] * n[1] + s[3] * n[2],
          s[4] * n[0] + s[3] * n[1] + s[2] * n[2]};
}

/// A unit normal with two directions in its plane.
struct PlaneAxes
{
  explicit PlaneAxes(const Vector3& normal) : n(unit(normal))
  {
    const Vector3 other = std::abs(n[0]) < 0.6 ? Vector3{1.0, 0.0, 0.0} : Vector3{0.0, 1.0, 0.0};
    a = unit(cross(n, other));
    b = cross(n, a);
  }
  Vector3 n, a, b;
};

/// Points evenly spread over half of the unit sphere (Fibonacci lattice), some 14 degrees apart.
inline const std::array<Vector3, 100>& half_sphere()
{
  static const std::array<Vector3, 100> points = []
  {
    std::array<Vector3, 100> result{};
    for (std::size_t i = 0; i < result.size(); ++i)
    {
      const double z = (static_cast<double>(i) + 0.5) / static_cast<double>(result.size());
      const double angle = 2.0 * std::numbers::pi * 0.6180339887498949 * static_cast<double>(i);
      const double r = std::sqrt(1.0 - z * z);
      result[i] = {r * std::cos(angle), r * std::sin(angle), z};
    }
    return result;
  }();
  return points;
}

/// The largest value of `damage(shear amplitude, largest normal stress)` over all planes, to about 1e-4. The amplitude is the
/// radius of the smallest circle around the path of the shear (Papadopoulos 1998). A search over half of the sphere, with half of the
/// largest range of the shear along eight directions instead, finds three planes near which steps are halved.
template <typename Damage>
double largest_over_planes(std::span<const SymTensor> stress, std::span<const SymTensor> shear, const Damage& damage)
{
  std::vector<Point<2>> path(shear.size());
  const auto largest_normal = [&](const Vector3& n)
  {
    double largest = -std::numeric_limits<double>::infinity();
    for (const SymTensor& s : stress)
      largest = std::max(largest, dot3(traction(s, n), n));
    return largest;
  };
  const auto set_path = [&](const PlaneAxes& axes)
  {
    for (std::size_t i = 0; i < shear.size(); ++i)
    {
      const Vector3 t = traction(shear[i], axes.n);
      path[i] = {dot3(t, axes.a), dot3(t, axes.b)};
    }
  };
  const auto coarse = [&](const Vector3& normal)
  {
    constexpr int directions = 8;
    set_path(PlaneAxes(normal));
    double widest = 0.0;
    for (int d = 0; d < directions; ++d)
    {
      const double angle = std::numbers::pi * d / directions, c = std::cos(angle), s = std::sin(angle);
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (const Point<2>& p : path)
      {
        const double along = c * p[0] + s * p[1];
        low = std::min(low, along);
        high = std::max(high, along);
      }
      widest = std::max(widest, 0.5 * (high - low));
    }
    return damage(widest, largest_normal(normal));
  };
  const auto fine = [&](const Vector3& normal)
  {
    const PlaneAxes axes(normal);
    set_path(axes);
    return damage(smallest_ball<2>(path).radius, largest_normal(axes.n));
  };

  const auto& normals = half_sphere();
  std::array<std::pair<double, std::size_t>, std::tuple_size_v<std::remove_cvref_t<decltype(normals)>>> found;
  for (std::size_t i = 0; i < normals.size(); ++i)
    found[i] = {coarse(normals[i]), i};
  constexpr std::size_t starts = 3;
  std::partial_sort(found.begin(), found.begin() + starts, found.end(), std::greater<>());
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < starts; ++i)
  {
    Vector3 best = normals[found[i].second];
    double value = fine(best);
    for (double step = 0.12; step > 0.004;)
    {
      const PlaneAxes axes(best);
      bool improved = false;
      for (const auto& [p, q] : {std::pair{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}})
      {
        const Vector3 next = unit({axes.n[0] + step * (p * axes.a[0] + q * axes.b[0]),
                                   axes.n[1] + step * (p * axes.a[1] + q * axes.b[1]),
                                   axes.n[2] + step * (p * axes.a[2] + q * axes.b[2])});
        if (const double there = fine(next); there > value)
          value = there, best = next, improved = true;
      }
      if (!improved)
        step *= 0.5;
    }
    largest = std::max(largest, value);
  }
  return largest;
}

} // namespace brinell::constitutive
