// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cell_response.hpp"
#include "foundation/fft.hpp"
#include "foundation/lane_functions.hpp"

#include <algorithm>

namespace brinell::halfspace
{

/// Parity of a kernel that is even or odd in x and in y. If it is odd in exactly one of them, its spectrum is imaginary,
/// otherwise real: one number per wavenumber is stored, only for wavenumbers >= 0 along y.
struct Parity
{
  bool odd_x, odd_y;

  [[nodiscard]] bool is_imaginary() const { return odd_x != odd_y; }
  /// Applies the phase and sign of the spectrum to `value`: the stored number times the result is the spectrum times `value`.
  /// @param row  wavenumber index along y, wrapped, < py
  [[nodiscard]] ComplexLanes phased(int row, int py, const ComplexLanes& value) const
  {
    const ComplexLanes signed_value = odd_y && row > py / 2 ? -1.0 * value : value;
    return is_imaginary() ? times_i(signed_value) : signed_value;
  }
};

/// Computes the spectrum of the kernel of a convolution on a grid.
/// @param value  value(i, j) of the kernel at offsets in cells; only the magnitudes of i and j matter
/// @param store  store(row, column, number) is called with each number of the spectrum
template <typename Value, typename Store>
void parity_spectrum(const PaddedFft& fft, const Parity& parity, const Value& value, const Store& store)
{
  const SurfaceGrid& grid = fft.grid();
  const int px = fft.px(), py = fft.py();
  const Offsets along_x(grid.nx, grid.boundary_x), along_y(grid.ny, grid.boundary_y);
  AlignedVector<double> plane(static_cast<std::size_t>(px) * static_cast<std::size_t>(py));
  for (int j = along_y.first(); j <= along_y.last(); ++j)
    for (int i = along_x.first(); i <= along_x.last(); ++i)
    {
      const double sign = (parity.odd_x ? along_x.sign(i) : 1.0) * (parity.odd_y ? along_y.sign(j) : 1.0);
      plane[static_cast<std::size_t>((j + py) % py * px + (i + px) % px)] = sign * value(i, j);
    }
  const AlignedVector<Complex> transformed = fft.forward_padded(plane);
  for (int row = 0; row <= py / 2; ++row)
    for (int i = 0; i < fft.kx(); ++i)
    {
      const Complex number = transformed[static_cast<std::size_t>(row * fft.kx() + i)];
      store(row, i, parity.is_imaginary() ? number.imag() : number.real());
    }
}

} // namespace brinell::halfspace
