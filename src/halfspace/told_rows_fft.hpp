// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/symmetry.hpp"
#include "foundation/fft.hpp"

#include <span>
#include <vector>

namespace brinell::halfspace
{

/// Transforms of surface fields of which some wavenumbers tell all: without symmetry all of them; of fields that are even or odd about
/// the middle row those along y that are not negative. At -n their spectrum is w^n or -w^n times that at n, w = e^{2 pi i (ny - 1)/py}.
class ToldRowsFft
{
public:
  ToldRowsFft(const SurfaceGrid& grid, int px, int py, Symmetry symmetry);

  [[nodiscard]] const PaddedFft& all() const { return fft_; }
  [[nodiscard]] int rows() const { return rows_; } ///< that tell all, the first ones of the plane
  /// Complex values of them; from one field to the next: whole cache lines.
  [[nodiscard]] std::size_t plane() const { return plane_; }

  /// Told rows of the spectrum of a field, which with symmetry is even.
  [[nodiscard]] AlignedVector<Complex> forward(std::span<const double> field) const;
  /// Fields on the grid from the told rows of their spectra, which are destroyed.
  /// @param is_odd  of so many fields, again and again; without symmetry it does not matter
  /// @param adds    to what is there; otherwise it is overwritten
  void inverse(std::vector<AlignedVector<Complex>>& spectra, const std::vector<bool>& is_odd, bool adds,
               const std::vector<std::span<double>>& fields) const;

  /// All rows of an even field from the told ones.
  void complete(const Complex* told, Complex* all) const { join(told, nullptr, all); }

private:
  void join(const Complex* even, const Complex* odd, Complex* both) const;

  PaddedFft fft_;
  Symmetry symmetry_;
  int rows_;
  std::size_t plane_;
  std::vector<Complex> nothing_; ///< a row of zeros
  std::vector<Complex> turn_;    ///< w^n of the told rows
};

} // namespace brinell::halfspace
