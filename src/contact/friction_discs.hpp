// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

/// Shears that are bounded in size, cell by cell: parts of the iteration of `TangentialContact`.
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

/// A field of them: x and y apart, as the operators take them.
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

/// Which directions a force is imposed in.
struct Forced
{
  bool x = false, y = false;

  [[nodiscard]] bool any() const { return x || y; }
  [[nodiscard]] Along part(const Along& a) const { return {x ? a.x : 0.0, y ? a.y : 0.0}; }
  /// Solution of m times it = right in these directions, zero in others; about zero where m says nothing.
  [[nodiscard]] Along solution(const AlongMatrix& m, const Along& right) const;
};

/// Whether a cell moves with the other surface or slips past it.
enum class Zone : unsigned char
{
  stick,
  slip
};

/// The nearest shear that the bound allows.
[[nodiscard]] inline Along bounded(const Along& q, double bound)
{
  const double size = q.size();
  return size > bound ? (bound / size) * q : q;
}

/// Adds the same to the shears of cells, and bounds them, so that they have a given sum: the nearest shears with this sum.
/// @param of_slip  whether cells that slip take part, too; the bound must then be able to carry the sum
/// @param sum      of all cells in the directions that are forced [Pa]
/// @returns whether it could be met
bool balance(const Forced& forced, const Along& sum, bool of_slip, std::span<const double> bound,
             std::span<const Zone> zone, std::span<double> x, std::span<double> y);

} // namespace brinell::contact
