// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/host_device.hpp"

#include <cstddef>

/// Kernels that take fields into padded planes and out of them. A padded plane has the place of its spectrum: py rows of
/// 2 (px / 2 + 1) numbers, so that a transform needs no other memory.
namespace brinell::device
{

struct Padding
{
  std::size_t nx, ny, px, py;

  [[nodiscard]] BRINELL_HOST_DEVICE std::size_t pitch() const { return 2 * (px / 2 + 1); }
  [[nodiscard]] BRINELL_HOST_DEVICE std::size_t cells() const { return nx * ny; }
  [[nodiscard]] BRINELL_HOST_DEVICE std::size_t padded() const { return py * pitch(); }
};

/// A number of the padded planes: that of the field, or zero.
struct Embed
{
  Padding padding;
  const double* fields;
  double* padded;

  BRINELL_HOST_DEVICE void operator()(std::size_t n) const
  {
    const std::size_t column = n % padding.pitch(), row = n / padding.pitch() % padding.py,
                      plane = n / padding.padded();
    const bool is_inside = column < padding.nx && row < padding.ny;
    padded[n] = is_inside ? fields[plane * padding.cells() + row * padding.nx + column] : 0.0;
  }
};

/// A value of the fields from the padded planes.
struct Extract
{
  Padding padding;
  const double* padded;
  double* fields;

  BRINELL_HOST_DEVICE void operator()(std::size_t n) const
  {
    const std::size_t column = n % padding.nx, row = n / padding.nx % padding.ny, plane = n / padding.cells();
    fields[n] = padded[plane * padding.padded() + row * padding.pitch() + column];
  }
};

} // namespace brinell::device
