// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

/// Shears of bounded magnitude in each cell: parts of the iteration of `TangentialContact`.
namespace brinell::contact
{

/// A vector along the surface.
struct Along
{
  double x = 0.0, y = 0.0;

  [[nodiscard]] double size() const { return std::sqrt(x * x + y * y); }
  Along& operator+=(const Along& other)
  {
    x += other.x;
    y += other.y;
    return *this;
  }
};
[[nodiscard]] inline Along operator+(const Along& a, const Along& b)
{
  return {a.x + b.x, a.y + b.y};
}
[[nodiscard]] inline Along operator-(const Along& a, const Along& b)
{
  return {a.x - b.x, a.y - b.y};
}
[[nodiscard]] inline Along operator*(double factor, const Along& a)
{
  return {factor * a.x, factor * a.y};
}
[[nodiscard]] inline double dot(const Along& a, const Along& b)
{
  return a.x * b.x + a.y * b.y;
}

/// A field of vectors along the surface: x and y in separate arrays, as the operators need them.
struct AlongField
{
  std::vector<double> x, y;

  explicit AlongField(std::size_t cells = 0) : x(cells), y(cells) {}
  void resize(std::size_t cells)
  {
    x.resize(cells);
    y.resize(cells);
  }
  void clear() ///< to zero
  {
    std::fill(x.begin(), x.end(), 0.0);
    std::fill(y.begin(), y.end(), 0.0);
  }
  [[nodiscard]] Along at(std::size_t cell) const { return {x[cell], y[cell]}; }
  void set(std::size_t cell, const Along& value)
  {
    x[cell] = value.x;
    y[cell] = value.y;
  }
};

/// A symmetric matrix along the surface.
struct AlongMatrix
{
  double xx = 0.0, yy = 0.0, xy = 0.0;

  AlongMatrix& operator+=(const AlongMatrix& other)
  {
    xx += other.xx;
    yy += other.yy;
    xy += other.xy;
    return *this;
  }
};
[[nodiscard]] inline Along operator*(const AlongMatrix& m, const Along& a)
{
  return {m.xx * a.x + m.xy * a.y, m.xy * a.x + m.yy * a.y};
}

/// Directions in which a force is imposed.
struct Forced
{
  bool x = false, y = false;

  [[nodiscard]] bool any() const { return x || y; }
  [[nodiscard]] Along part(const Along& a) const { return {x ? a.x : 0.0, y ? a.y : 0.0}; }
  /// Solution u of m u = right in these directions, zero in the others; approximately zero along null directions of m.
  [[nodiscard]] Along solution(const AlongMatrix& m, const Along& right) const;
};

/// Whether a cell moves with the other surface or slips past it.
enum class Zone : unsigned char
{
  stick,
  slip
};

/// Projection of a shear on the disc of its bound.
[[nodiscard]] inline Along bounded(const Along& q, double bound)
{
  const double size = q.size();
  return size > bound ? (bound / size) * q : q;
}

/// Adds the same vector to the shears of all cells and projects them on their bounds, such that they have a given sum: this gives
/// the nearest shears with this sum.
/// @param of_slip  whether slipping cells are changed, too; the sum of all bounds must then exceed the sum
/// @param sum      prescribed sum over all cells in the directions with an imposed force [Pa]
/// @returns whether the sum could be reached
bool balance(const Forced& forced, const Along& sum, bool of_slip, std::span<const double> bound,
             std::span<const Zone> zone, std::span<double> x, std::span<double> y);

} // namespace brinell::contact
