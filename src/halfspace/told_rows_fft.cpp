// SPDX-License-Identifier: BSD-3-Clause
#include "told_rows_fft.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brinell::halfspace
{

ToldRowsFft::ToldRowsFft(const SurfaceGrid& grid, int px, int py, Symmetry symmetry)
    : fft_(grid, px, py), symmetry_(symmetry), rows_(symmetry == Symmetry::none ? py : py / 2 + 1),
      plane_((static_cast<std::size_t>(fft_.kx()) * static_cast<std::size_t>(rows_) + 7) / 8 * 8),
      nothing_(static_cast<std::size_t>(fft_.kx()))
{
  for (int n = 0; n < rows_; ++n)
    turn_.push_back(std::polar(1.0, 2.0 * std::numbers::pi * n * (grid.ny - 1) / py));
}

AlignedVector<Complex> ToldRowsFft::forward(std::span<const double> field) const
{
  AlignedVector<Complex> spectrum(fft_.plane());
  AlignedVector<double> scratch(fft_.scratch_size());
  fft_.forward(field.data(), spectrum.data(), scratch);
  spectrum.resize(plane_);
  return spectrum;
}

/// All rows of an even field, an odd one, or the sum of both.
/// @param even, odd  nullptr if there is none
void ToldRowsFft::join(const Complex* even, const Complex* odd, Complex* both) const
{
  const std::ptrdiff_t columns = fft_.kx();
  for (int n = 0; n < rows_; ++n)
  {
    const Complex turn = turn_[static_cast<std::size_t>(n)];
    const std::ptrdiff_t here = n * columns, there = (fft_.py() - n) * columns;
    const Complex* e = even != nullptr ? even + here : nothing_.data();
    const Complex* o = odd != nullptr ? odd + here : nothing_.data();
    for (std::ptrdiff_t i = 0; i < columns; ++i)
      both[here + i] = e[i] + o[i];
    const bool has_opposite = symmetry_ != Symmetry::none && n > 0 && 2 * n < fft_.py();
    for (std::ptrdiff_t i = 0; i < columns && has_opposite; ++i)
    {
      const Complex d = e[i] - o[i]; // spelt out: the product of the library looks for infinities
      both[there + i] = {turn.real() * d.real() - turn.imag() * d.imag(),
                         turn.real() * d.imag() + turn.imag() * d.real()};
    }
  }
}

namespace
{

/// The part of a field that is even or odd about the middle row.
/// @param sign  1 or -1
template <bool adds>
void put_part(const SurfaceGrid& g, std::span<const double> field, double sign, std::span<double> part)
{
  const auto put = [](double value, double& to) { to = adds ? to + value : value; };
  for (int j = 0; 2 * j < g.ny; ++j)
  {
    const double *here = field.data() + g.index(0, j), *there = field.data() + g.index(0, g.ny - 1 - j);
    double *to = part.data() + g.index(0, j), *opposite = part.data() + g.index(0, g.ny - 1 - j);
    for (int i = 0; i < g.nx; ++i)
      put(0.5 * (here[i] + sign * there[i]), to[i]);
    for (int i = 0; i < g.nx && to != opposite; ++i)
      put(sign * 0.5 * (here[i] + sign * there[i]), opposite[i]);
  }
}

} // namespace

void ToldRowsFft::inverse(std::vector<AlignedVector<Complex>>& spectra, const std::vector<bool>& is_odd, bool adds,
                          const std::vector<std::span<double>>& fields) const
{
  AlignedVector<double> scratch(fft_.scratch_size());
  std::vector<double> field(fft_.grid().size());
  if (symmetry_ == Symmetry::none)
  {
    for (std::size_t f = 0; f < fields.size(); ++f)
    {
      fft_.inverse(spectra[f].data(), adds ? field.data() : fields[f].data(), scratch);
      for (std::size_t n = 0; adds && n < field.size(); ++n)
        fields[f][n] += field[n];
    }
    return;
  }
  // An even and an odd field are one, their sum.
  std::vector<std::size_t> even, odd;
  for (std::size_t f = 0; f < fields.size(); ++f)
    (is_odd[f % is_odd.size()] ? odd : even).push_back(f);
  AlignedVector<Complex> both(fft_.plane());
  for (std::size_t n = 0; n < std::max(even.size(), odd.size()); ++n)
  {
    const bool has_even = n < even.size(), has_odd = n < odd.size();
    join(has_even ? spectra[even[n]].data() : nullptr, has_odd ? spectra[odd[n]].data() : nullptr, both.data());
    fft_.inverse(both.data(), field.data(), scratch);
    const auto put = adds ? put_part<true> : put_part<false>;
    if (has_even)
      put(fft_.grid(), field, 1.0, fields[even[n]]);
    if (has_odd)
      put(fft_.grid(), field, -1.0, fields[odd[n]]);
  }
}

} // namespace brinell::halfspace
