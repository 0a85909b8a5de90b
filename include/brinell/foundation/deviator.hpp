// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/host_device.hpp"
#include "brinell/foundation/sym_tensor.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace brinell
{

/// A symmetric traceless tensor as five components; zz = -xx - yy.
/// Fields of deviators are stored component after component (SoA), each one a volume field.
struct Deviator
{
  static constexpr int size = 5;
  enum Component : int
  {
    xx,
    yy,
    yz,
    xz,
    xy
  };

  std::array<double, size> v{};

  BRINELL_HOST_DEVICE double& operator[](int i) { return v[static_cast<std::size_t>(i)]; }
  BRINELL_HOST_DEVICE double operator[](int i) const { return v[static_cast<std::size_t>(i)]; }
  bool operator==(const Deviator&) const = default;
};

[[nodiscard]] BRINELL_HOST_DEVICE inline Deviator operator+(const Deviator& a, const Deviator& b)
{
  Deviator c;
  for (int i = 0; i < Deviator::size; ++i)
    c[i] = a[i] + b[i];
  return c;
}

[[nodiscard]] BRINELL_HOST_DEVICE inline Deviator operator-(const Deviator& a, const Deviator& b)
{
  Deviator c;
  for (int i = 0; i < Deviator::size; ++i)
    c[i] = a[i] - b[i];
  return c;
}

[[nodiscard]] BRINELL_HOST_DEVICE inline Deviator operator*(double f, const Deviator& a)
{
  Deviator c;
  for (int i = 0; i < Deviator::size; ++i)
    c[i] = f * a[i];
  return c;
}

/// The deviator of one cell of a field of `cells` cells.
[[nodiscard]] inline Deviator deviator_at(std::span<const double> field, std::size_t cells, std::size_t cell)
{
  Deviator d;
  for (int c = 0; c < Deviator::size; ++c)
    d[c] = field[static_cast<std::size_t>(c) * cells + cell];
  return d;
}
inline void store(const Deviator& d, std::span<double> field, std::size_t cells, std::size_t cell)
{
  for (int c = 0; c < Deviator::size; ++c)
    field[static_cast<std::size_t>(c) * cells + cell] = d[c];
}

/// All six components: the deviator plus a third of a trace.
[[nodiscard]] inline SymTensor to_tensor(const Deviator& d, double trace = 0.0)
{
  using D = Deviator;
  const double mean = trace / 3.0;
  return {d[D::xx] + mean, d[D::yy] + mean, mean - d[D::xx] - d[D::yy], d[D::yz], d[D::xz], d[D::xy]};
}
/// The deviatoric part of a tensor.
[[nodiscard]] inline Deviator to_deviator(const SymTensor& t)
{
  const SymTensor d = deviator(t);
  return {{d[0], d[1], d[3], d[4], d[5]}};
}

/// Double contraction a : b of two deviators.
[[nodiscard]] BRINELL_HOST_DEVICE inline double contract(const Deviator& a, const Deviator& b)
{
  using D = Deviator;
  return 2.0 * (a[D::xx] * b[D::xx] + a[D::yy] * b[D::yy] + a[D::yz] * b[D::yz] + a[D::xz] * b[D::xz] +
                a[D::xy] * b[D::xy]) +
         a[D::xx] * b[D::yy] + a[D::yy] * b[D::xx];
}

/// von Mises equivalent of a deviatoric stress, sqrt(3/2 s : s).
[[nodiscard]] BRINELL_HOST_DEVICE inline double von_mises(const Deviator& s)
{
  return std::sqrt(1.5 * contract(s, s));
}

/// Whether a component changes its sign from one side of the plane y = 0 to the other where both are mirror images.
[[nodiscard]] constexpr bool is_odd_in_y(int component)
{
  return component == Deviator::yz || component == Deviator::xy;
}

/// The mirror image of a tensor: its value on the other side of y = 0.
[[nodiscard]] inline Deviator mirrored_in_y(Deviator d)
{
  for (const int c : {Deviator::yz, Deviator::xy})
    d[c] = -d[c];
  return d;
}

} // namespace brinell
