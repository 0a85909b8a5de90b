// SPDX-License-Identifier: BSD-3-Clause
#include "foundation/row_fft.hpp"

#include "brinell/foundation/error.hpp"
#include "foundation/fftw.hpp"
#include "foundation/lane_functions.hpp"

#include <algorithm>
#include <array>

namespace brinell
{

namespace
{

/// Number of single rows that take as long as a tile of rows (measured for lengths of 90 and 512 with AVX-512). Without AVX the
/// transposition between rows and lanes takes longer than the transforms, so rows are always transformed one by one.
#if defined(__AVX__)
constexpr int worth_together = 3 * lane_count / 4;
#else
constexpr int worth_together = RowFft::most_rows + 1;
#endif

/// A square of values: `lane_count` rows at as many neighbouring positions or wavenumbers. Loops over a tile are unrolled, so
/// that it stays in registers.
using Tile = std::array<Lanes, lane_count>;

/// Step of a recursive transposition: exchanges the off-diagonal squares of `size` in each diagonal square of 2 * `size`.
template <int size>
[[gnu::always_inline]] inline void exchange_squares(Tile& t)
{
#pragma GCC unroll 8
  for (std::size_t i = 0; i < lane_count; ++i)
    if ((i & size) == 0)
    {
      const Lanes a = t[i], b = t[i + size];
      t[i] = shuffled(a, b, [](int lane) { return lane & size ? lane_count + lane - size : lane; });
      t[i + size] = shuffled(a, b, [](int lane) { return lane & size ? lane_count + lane : lane + size; });
    }
  if constexpr (2 * size < lane_count)
    exchange_squares<2 * size>(t);
}

/// Transposes a tile.
[[gnu::always_inline]] inline void transpose(Tile& t)
{
  exchange_squares<1>(t);
}

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

struct RowFft::Plans
{
  fftw_plan forward = nullptr, inverse = nullptr;

  Plans(int length, Work& work)
  {
    // FFTW_ESTIMATE makes the choice of algorithm, and so the last bit of every result, reproducible.
    const unsigned flags = FFTW_ESTIMATE | FFTW_DESTROY_INPUT;
    const auto lock = planner_lock();
    forward = fftw_plan_dft_r2c_1d(length, work.real.data(), as_fftw(work.half.data()), flags);
    inverse = fftw_plan_dft_c2r_1d(length, as_fftw(work.half.data()), work.real.data(), flags);
    if (!forward || !inverse)
      throw InternalError("FFTW made no plan");
  }
  ~Plans()
  {
    const auto lock = planner_lock();
    fftw_destroy_plan(forward);
    fftw_destroy_plan(inverse);
  }
  Plans(const Plans&) = delete;
  Plans& operator=(const Plans&) = delete;
};

RowFft::RowFft(int given, int length) : given_(given), lanes_(length)
{
  Work work = make_work();
  plans_ = std::make_unique<Plans>(length, work);
}

RowFft::~RowFft() = default;

RowFft::Work RowFft::make_work() const
{
  const auto size = static_cast<std::size_t>(length());
  Work work;
  work.series.resize(size + lane_count); // tiles may reach beyond the last value
  work.spectrum.resize(size + lane_count + 1);
  work.lanes.resize(lanes_.work_size());
  work.real.resize(size);
  work.half.resize(static_cast<std::size_t>(blocks()) * lane_count);
  return work;
}

void RowFft::forward(const double* field, int count, ComplexLanes* spectra, const Spectra& layout, Work& work) const
{
  if (count >= worth_together)
    forward_together(field, count, spectra, layout, work);
  else
    for (std::ptrdiff_t row = 0; row < count; ++row)
      forward_one(field + row * given_, spectra + row, layout, work);
  end_streaming();
}

void RowFft::inverse(const ComplexLanes* spectra, const Spectra& layout, int count, double scale, double* field,
                     Work& work) const
{
  if (count >= worth_together)
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

void RowFft::forward_one(const double* field, ComplexLanes* spectra, const Spectra& layout, Work& work) const
{
  double* padding = std::copy_n(field, given_, work.real.data());
  std::fill_n(padding, length() - given_, 0.0);
  fftw_execute_dft_r2c(plans_->forward, work.real.data(), as_fftw(work.half.data()));
  for (std::ptrdiff_t block = 0; block < blocks(); ++block)
    store_lanes(load_lanes(work.half.data() + block * lane_count), spectra + block * layout.apart, layout.past_caches);
}

void RowFft::inverse_one(const ComplexLanes* spectra, const Spectra& layout, double scale, double* field,
                         Work& work) const
{
  for (std::ptrdiff_t block = 0; block < blocks(); ++block)
    store_lanes(spectra[block * layout.apart], work.half.data() + block * lane_count);
  fftw_execute_dft_c2r(plans_->inverse, as_fftw(work.half.data()), work.real.data());
  for (std::ptrdiff_t i = 0; i < given_; ++i)
    field[i] = scale * work.real[static_cast<std::size_t>(i)];
}

} // namespace brinell
