// SPDX-License-Identifier: BSD-3-Clause
#include "foundation/series_fft.hpp"

#include "foundation/lane_butterflies.hpp"
#include "foundation/lane_tile.hpp"

#include <algorithm>
#include <array>

namespace brinell
{

namespace
{

using butterflies::Value;
using butterflies::Values;

/// The divisor of the length that leaves the fewest lanes empty; of several, the first here, which takes the fewest instructions.
int best_parts(int length)
{
  int best = 1;
  const auto used = [](int parts)
  {
    const int lanes = (parts + lane_count - 1) / lane_count * lane_count; // of whole registers
    return static_cast<double>(parts) / lanes;
  };
  for (const int parts : {4, 8, 2, 7, 5, 3})
    if (length % parts == 0 && used(parts) > used(best))
      best = parts;
  return best;
}

/// Calls work with the number of parts as a constant.
template <typename Work>
void for_parts(int parts, const Work& work)
{
  switch (parts)
  {
  case 2:
    return work.template operator()<2>();
  case 3:
    return work.template operator()<3>();
  case 4:
    return work.template operator()<4>();
  case 5:
    return work.template operator()<5>();
  case 7:
    return work.template operator()<7>();
  case 8:
    return work.template operator()<8>();
  default:
    return work.template operator()<1>();
  }
}

/// Values of which `count` parts, real and imaginary by turns, are given; the others are zero.
ComplexLanes load_pairs(const double* from, int count)
{
  if (count >= 2 * lane_count)
    return load_lanes(reinterpret_cast<const Complex*>(from));
  std::array<double, 2 * lane_count> values{};
  std::copy_n(from, count, values.data());
  return load_lanes(reinterpret_cast<const Complex*>(values.data()));
}

/// Stores at most `count` parts.
void store_pairs(const ComplexLanes& value, int count, double* to)
{
  if (count >= 2 * lane_count)
    return store_lanes(value, reinterpret_cast<Complex*>(to));
  std::array<double, 2 * lane_count> values;
  store_lanes(value, reinterpret_cast<Complex*>(values.data()));
  std::copy_n(values.data(), count, to);
}

Value times(const Value& a, const ComplexLanes& factor)
{
  return {a.re * factor.re - a.im * factor.im, a.im * factor.re + a.re * factor.im};
}

} // namespace

SeriesFft::SeriesFft(int length) : parts_(best_parts(length)), lanes_(length / parts_)
{
  for (int k = 0; k < lanes_.length(); k += lane_count)
    for (int l = 1; l < parts_; ++l)
    {
      ComplexLanes& twiddle = twiddles_.emplace_back();
      for (int lane = 0; lane < lane_count; ++lane)
      {
        const Complex root = root_of_one(static_cast<long long>(l) * (k + lane), length);
        twiddle.re[lane] = root.real();
        twiddle.im[lane] = root.imag();
      }
    }
  for (int k = 0; k < parts_; ++k)
  {
    const Complex root = root_of_one(k, parts_);
    roots_.insert(roots_.end(), {root.real(), -root.imag()});
  }
}

SeriesFft::Work SeriesFft::make_work() const
{
  const auto size = static_cast<std::size_t>(groups() * apart());
  return {AlignedVector<ComplexLanes>(size), AlignedVector<ComplexLanes>(size),
          AlignedVector<ComplexLanes>(lanes_.work_size())};
}

void SeriesFft::forward(const double* from, int given, double* re, double* im, Work& work) const
{
  const int places = (given + 2 * parts_ - 1) / (2 * parts_);
  for (int group = 0; group < groups(); ++group)
  {
    ComplexLanes* series = work.series.data() + group * apart();
    for (int place = 0; place < places; ++place)
    {
      const int first = 2 * (place * parts_ + group * lane_count);
      series[place] = load_pairs(from + std::min(first, given), std::max(0, given - first));
    }
    lanes_.forward(series, places, work.spectra.data() + group * apart(), work.lanes.data());
  }
  for_parts(parts_, [&]<std::size_t parts>() { combine<parts>(work.spectra.data(), re, im); });
}

template <std::size_t parts>
void SeriesFft::combine(const ComplexLanes* spectra, double* re, double* im) const
{
  const std::ptrdiff_t length = lanes_.length();
  const ComplexLanes* twiddles = twiddles_.data();
  for (std::ptrdiff_t k = 0; k < length; k += lane_count, twiddles += parts - 1)
  {
    Values<parts> a;
#pragma GCC unroll 4
    for (std::size_t first = 0; first < parts; first += lane_count)
    {
      const ComplexLanes* from = spectra + static_cast<std::ptrdiff_t>(first / lane_count) * apart() + k;
      Tile tile_re, tile_im;
#pragma GCC unroll 8
      for (std::size_t i = 0; i < lane_count; ++i)
      {
        tile_re[i] = from[i].re;
        tile_im[i] = from[i].im;
      }
      transpose(tile_re);
      transpose(tile_im);
#pragma GCC unroll 8
      for (std::size_t i = 0; i < lane_count; ++i)
        if (first + i < parts)
          a[first + i] = {tile_re[i], tile_im[i]};
    }
    for (std::size_t l = 1; l < parts; ++l)
      a[l] = times(a[l], twiddles[l - 1]);
    butterflies::transform<parts>(a, roots_.data());
    const auto count = static_cast<std::size_t>(std::min<std::ptrdiff_t>(lane_count, length - k));
#pragma GCC unroll 8
    for (std::size_t r = 0; r < parts; ++r)
    {
      store_lanes(a[r].re, count, re + k + static_cast<std::ptrdiff_t>(r) * length);
      store_lanes(a[r].im, count, im + k + static_cast<std::ptrdiff_t>(r) * length);
    }
  }
}

void SeriesFft::inverse(const double* re, const double* im, double scale, double* to, int wanted, Work& work) const
{
  for_parts(parts_, [&]<std::size_t parts>() { divide<parts>(re, im, work.spectra.data()); });
  const int places = (wanted + 2 * parts_ - 1) / (2 * parts_);
  for (int group = 0; group < groups(); ++group)
    lanes_.inverse(work.spectra.data() + group * apart(), work.series.data() + group * apart(), places,
                   work.lanes.data());
  // In the order of their places, because the empty lanes are written, too, and then overwritten.
  for (int place = 0; place < places; ++place)
    for (int group = 0; group < groups(); ++group)
    {
      const int first = 2 * (place * parts_ + group * lane_count);
      if (first < wanted)
        store_pairs(scale * work.series[static_cast<std::size_t>(group * apart() + place)], wanted - first, to + first);
    }
}

/// With real and imaginary parts exchanged, the inverse is a transform forward.
template <std::size_t parts>
void SeriesFft::divide(const double* re, const double* im, ComplexLanes* spectra) const
{
  const std::ptrdiff_t length = lanes_.length();
  const ComplexLanes* twiddles = twiddles_.data();
  for (std::ptrdiff_t k = 0; k < length; k += lane_count, twiddles += parts - 1)
  {
    Values<parts> a;
#pragma GCC unroll 8
    for (std::size_t r = 0; r < parts; ++r)
    {
      const std::ptrdiff_t at = k + static_cast<std::ptrdiff_t>(r) * length;
      a[r] = {load_lanes(im + at), load_lanes(re + at)};
    }
    butterflies::transform<parts>(a, roots_.data());
    for (std::size_t l = 1; l < parts; ++l)
      a[l] = times(a[l], twiddles[l - 1]);
#pragma GCC unroll 4
    for (std::size_t first = 0; first < parts; first += lane_count)
    {
      ComplexLanes* to = spectra + static_cast<std::ptrdiff_t>(first / lane_count) * apart() + k;
      Tile tile_re{}, tile_im{};
#pragma GCC unroll 8
      for (std::size_t i = 0; i < lane_count; ++i)
        if (first + i < parts)
        {
          tile_re[i] = a[first + i].im;
          tile_im[i] = a[first + i].re;
        }
      transpose(tile_re);
      transpose(tile_im);
#pragma GCC unroll 8
      for (std::size_t i = 0; i < lane_count; ++i)
        to[i] = {tile_re[i], tile_im[i]};
    }
  }
}

} // namespace brinell
