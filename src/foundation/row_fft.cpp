// SPDX-License-Identifier: BSD-3-Clause
#include "foundation/row_fft.hpp"

#include "foundation/lane_tile.hpp"

#include <algorithm>

namespace brinell
{

namespace
{

/// Loads values at neighbouring positions of some rows, with the rows in lanes; zero beyond the last row and the last position.
[[gnu::always_inline]] inline Tile load_tile(const double* field, std::ptrdiff_t apart, int rows, int places)
{
  Tile tile;
#pragma GCC unroll 8
  for (int row = 0; row < lane_count; ++row)
    tile[static_cast<std::size_t>(row)] =
        row < rows ? load_lanes(field + row * apart, static_cast<std::size_t>(places)) : Lanes{};
  transpose(tile);
  return tile;
}

[[gnu::always_inline]] inline void store_tile(Tile& tile, double scale, double* field, std::ptrdiff_t apart, int rows,
                                              int places)
{
  transpose(tile);
#pragma GCC unroll 8
  for (int row = 0; row < lane_count; ++row)
    if (row < rows)
      store_lanes(scale * tile[static_cast<std::size_t>(row)], static_cast<std::size_t>(places), field + row * apart);
}

/// Stores values of a spectrum: transposes from [wavenumber][row in lanes] to [row][wavenumber in lanes].
[[gnu::always_inline]] inline void store_rows(Tile& re, Tile& im, int rows, ComplexLanes* spectra, bool past_caches)
{
  transpose(re);
  transpose(im);
#pragma GCC unroll 8
  for (int row = 0; row < lane_count; ++row)
    if (row < rows)
      store_lanes({re[static_cast<std::size_t>(row)], im[static_cast<std::size_t>(row)]}, spectra + row, past_caches);
}

/// The reverse of `store_rows`, for the real or the imaginary part.
template <Lanes ComplexLanes::*part>
[[gnu::always_inline]] inline Tile load_rows(const ComplexLanes* spectra, int rows)
{
  Tile tile;
#pragma GCC unroll 8
  for (int row = 0; row < lane_count; ++row)
    tile[static_cast<std::size_t>(row)] = row < rows ? spectra[row].*part : Lanes{};
  transpose(tile);
  return tile;
}

/// Of the rows that are transformed together, the first `lane_count` are real parts, the others imaginary parts.
int real_rows(int count)
{
  return std::min(count, lane_count);
}
int imaginary_rows(int count)
{
  return count - real_rows(count);
}

} // namespace

RowFft::RowFft(int given, int length)
    : given_(given), lanes_(length), series_(is_even() ? length / 2 : length),
      factors_(static_cast<std::size_t>(series_.length() / lane_count + 1))
{
  for (int k = 0; is_even() && k <= series_.length(); ++k)
  {
    ComplexLanes& factors = factors_[static_cast<std::size_t>(k / lane_count)];
    const Complex root = 2 * k == length ? -1.0 : root_of_one(k, length);
    factors.re[k % lane_count] = 0.5 * root.imag();
    factors.im[k % lane_count] = -0.5 * root.real();
  }
}

RowFft::Work RowFft::make_work() const
{
  const auto size = static_cast<std::size_t>(length());
  const auto single = static_cast<std::size_t>(series_.length() + 3 * lane_count);
  Work work;
  work.series.resize(size + lane_count); // tiles may reach beyond the last value
  work.spectrum.resize(size + lane_count + 1);
  work.lanes.resize(lanes_.work_size());
  work.one.fft = series_.make_work();
  work.one.pairs.resize(is_even() ? 0 : 2 * size);
  for (AlignedVector<double>* part : {&work.one.re, &work.one.im, &work.one.half_re, &work.one.half_im})
    part->resize(single);
  return work;
}

/// Whether the rows take less time together: a fit to measured times with AVX-512, AVX2 and SSE2 for lengths of 16 to 4096. Long
/// rows do not stay in the nearest cache together.
bool RowFft::is_worth_together(int count) const
{
  return count >= std::min(3 * lane_count / 2, 3 + length() * lane_count / 400);
}

void RowFft::forward(const double* field, int count, ComplexLanes* spectra, const Spectra& layout, Work& work) const
{
  if (is_worth_together(count))
    forward_together(field, count, spectra, layout, work);
  else
    for (std::ptrdiff_t row = 0; row < count; ++row)
      forward_one(field + row * given_, spectra + row, layout, work);
  end_streaming();
}

void RowFft::inverse(const ComplexLanes* spectra, const Spectra& layout, int count, double scale, double* field,
                     Work& work) const
{
  if (is_worth_together(count))
    inverse_together(spectra, layout, count, scale, field, work);
  else
    for (std::ptrdiff_t row = 0; row < count; ++row)
      inverse_one(spectra + row, layout, scale, field + row * given_, work);
}

void RowFft::forward_together(const double* field, int count, ComplexLanes* spectra, const Spectra& layout,
                              Work& work) const
{
  const double* imaginary = field + static_cast<std::ptrdiff_t>(real_rows(count)) * given_;
  for (int x = 0; x < given_; x += lane_count)
  {
    const int places = std::min(lane_count, given_ - x);
    const Tile re = load_tile(field + x, given_, real_rows(count), places);
    const Tile im = load_tile(imaginary + x, given_, imaginary_rows(count), places);
#pragma GCC unroll 8
    for (int i = 0; i < lane_count; ++i)
      work.series[static_cast<std::size_t>(x + i)] = {re[static_cast<std::size_t>(i)], im[static_cast<std::size_t>(i)]};
  }
  for (std::ptrdiff_t block = 0; !layout.past_caches && block < blocks(); ++block)
    for (std::ptrdiff_t row = 0; row < count; ++row)
      write_soon(spectra + block * layout.apart + row);
  lanes_.forward(work.series.data(), given_, work.spectrum.data(), work.lanes.data());
  std::fill(work.spectrum.begin() + length(), work.spectrum.end(), ComplexLanes{}); // of blocks beyond the length
  work.spectrum[static_cast<std::size_t>(length())] = work.spectrum.front();
  for (int block = 0; block < blocks(); ++block, spectra += layout.apart)
    separate(block, count, spectra, layout.past_caches, work);
}

/// Splits one block of the spectrum into its even and odd parts.
void RowFft::separate(int block, int count, ComplexLanes* spectra, bool past_caches, const Work& work) const
{
  const ComplexLanes* here = work.spectrum.data() + static_cast<std::ptrdiff_t>(block) * lane_count;
  const ComplexLanes* opposite = work.spectrum.data() + length() - static_cast<std::ptrdiff_t>(block) * lane_count;
  const int used = std::min(lane_count, wavenumbers() - block * lane_count);
  Tile even_re, even_im, odd_re, odd_im;
#pragma GCC unroll 8
  for (int i = 0; i < lane_count; ++i)
  {
    const auto at = static_cast<std::size_t>(i);
    const double half = i < used ? 0.5 : 0.0;
    const ComplexLanes a = here[i], b = opposite[i < used ? -i : 0];
    even_re[at] = half * (a.re + b.re);
    even_im[at] = half * (a.im - b.im);
    odd_re[at] = half * (a.im + b.im);
    odd_im[at] = half * (b.re - a.re);
  }
  store_rows(even_re, even_im, real_rows(count), spectra, past_caches);
  store_rows(odd_re, odd_im, imaginary_rows(count), spectra + real_rows(count), past_caches);
}

void RowFft::inverse_together(const ComplexLanes* spectra, const Spectra& layout, int count, double scale,
                              double* field, Work& work) const
{
  for (int block = 0; block < blocks(); ++block, spectra += layout.apart)
    unite(block, count, spectra, work);
  lanes_.inverse(work.spectrum.data(), work.series.data(), given_, work.lanes.data());
  double* imaginary = field + static_cast<std::ptrdiff_t>(real_rows(count)) * given_;
  for (int x = 0; x < given_; x += lane_count)
  {
    const int places = std::min(lane_count, given_ - x);
    Tile re, im;
#pragma GCC unroll 8
    for (int i = 0; i < lane_count; ++i)
    {
      re[static_cast<std::size_t>(i)] = work.series[static_cast<std::size_t>(x + i)].re;
      im[static_cast<std::size_t>(i)] = work.series[static_cast<std::size_t>(x + i)].im;
    }
    store_tile(re, scale, field + x, given_, real_rows(count), places);
    store_tile(im, scale, imaginary + x, given_, imaginary_rows(count), places);
  }
}

/// Combines the spectra of two real series to that of a complex series, at the wavenumbers of one block and at their opposites.
void RowFft::unite(int block, int count, const ComplexLanes* spectra, Work& work) const
{
  const ComplexLanes* others = spectra + real_rows(count);
  const Tile even_re = load_rows<&ComplexLanes::re>(spectra, real_rows(count));
  const Tile even_im = load_rows<&ComplexLanes::im>(spectra, real_rows(count));
  const Tile odd_re = load_rows<&ComplexLanes::re>(others, imaginary_rows(count));
  const Tile odd_im = load_rows<&ComplexLanes::im>(others, imaginary_rows(count));
  const int first = block * lane_count;
#pragma GCC unroll 8
  for (int i = 0; i < lane_count; ++i)
  {
    const auto at = static_cast<std::size_t>(i);
    const int k = first + i;
    if (k == 0 || 2 * k == length()) // real, up to rounding
      work.spectrum[static_cast<std::size_t>(k)] = {even_re[at], odd_re[at]};
    else if (k < wavenumbers())
    {
      work.spectrum[static_cast<std::size_t>(k)] = {even_re[at] - odd_im[at], even_im[at] + odd_re[at]};
      work.spectrum[static_cast<std::size_t>(length() - k)] = {even_re[at] + odd_im[at], odd_re[at] - even_im[at]};
    }
  }
}

/// Half the even part of a series of n values under conjugation and reversal, plus half the odd part times the factors, at
/// `lane_count` indices k: (Z_k + Z*_{n-k})/2 + f_k (Z_k - Z*_{n-k}), and with the conjugate of f for the inverse.
ComplexLanes RowFft::folded(const double* re, const double* im, std::ptrdiff_t k, bool inverse) const
{
  const std::ptrdiff_t opposite = series_.length() - k - (lane_count - 1);
  const auto reversed = [](const double* from)
  {
    const Lanes value = load_lanes(from);
    return shuffled(value, value, [](int lane) { return lane_count - 1 - lane; });
  };
  const ComplexLanes a{load_lanes(re + k), load_lanes(im + k)};
  const ComplexLanes b{reversed(re + opposite), -reversed(im + opposite)};
  const ComplexLanes& factor = factors_[static_cast<std::size_t>(k / lane_count)];
  const Lanes turn = inverse ? -factor.im : factor.im;
  const ComplexLanes odd = a - b;
  return 0.5 * (a + b) + ComplexLanes{factor.re * odd.re - turn * odd.im, factor.re * odd.im + turn * odd.re};
}

void RowFft::forward_one(const double* field, ComplexLanes* spectra, const Spectra& layout, Work& work) const
{
  Work::One& one = work.one;
  double *re = one.re.data() + lane_count, *im = one.im.data() + lane_count;
  const int n = series_.length();
  if (is_even())
    series_.forward(field, given_, re, im, one.fft);
  else
  {
    for (std::size_t i = 0; i < static_cast<std::size_t>(given_); ++i)
    {
      one.pairs[2 * i] = field[i];
      one.pairs[2 * i + 1] = 0.0;
    }
    series_.forward(one.pairs.data(), 2 * given_, re, im, one.fft);
  }
  re[n] = re[0];
  im[n] = im[0];
  for (std::ptrdiff_t block = 0; block < blocks(); ++block)
  {
    ComplexLanes value = folded(re, im, block * lane_count, false);
    for (int lane = wavenumbers() - static_cast<int>(block) * lane_count; lane < lane_count; ++lane)
      value.re[lane] = value.im[lane] = 0.0;
    store_lanes(value, spectra + block * layout.apart, layout.past_caches);
  }
}

void RowFft::inverse_one(const ComplexLanes* spectra, const Spectra& layout, double scale, double* field,
                         Work& work) const
{
  Work::One& one = work.one;
  double *re = one.re.data() + lane_count, *im = one.im.data() + lane_count;
  double *half_re = one.half_re.data() + lane_count, *half_im = one.half_im.data() + lane_count;
  for (std::ptrdiff_t block = 0; block < blocks(); ++block)
  {
    const ComplexLanes& value = spectra[block * layout.apart];
    store_lanes(value.re, lane_count, half_re + block * lane_count);
    store_lanes(value.im, lane_count, half_im + block * lane_count);
  }
  for (double* part : {half_re, half_im})
    std::fill(part + wavenumbers(), part + blocks() * lane_count, 0.0);
  half_im[0] = 0.0; // real, up to rounding
  if (is_even())
    half_im[series_.length()] = 0.0;
  for (std::ptrdiff_t k = 0; k < series_.length(); k += lane_count)
  {
    const ComplexLanes value = folded(half_re, half_im, k, true);
    store_lanes(value.re, lane_count, re + k);
    store_lanes(value.im, lane_count, im + k);
  }
  if (is_even())
    return series_.inverse(re, im, 2.0 * scale, field, given_, one.fft);
  series_.inverse(re, im, 2.0 * scale, one.pairs.data(), 2 * given_, one.fft);
  for (std::size_t i = 0; i < static_cast<std::size_t>(given_); ++i)
    field[i] = one.pairs[2 * i];
}

} // namespace brinell
