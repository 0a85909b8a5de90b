// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "foundation/lanes.hpp"

#include <cstddef>
#include <cstring>
#include <span>
#include <utility>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

/// Arithmetic, loads and stores of lanes.
namespace brinell
{

inline ComplexLanes operator+(const ComplexLanes& a, const ComplexLanes& b)
{
  return {a.re + b.re, a.im + b.im};
}
inline ComplexLanes operator-(const ComplexLanes& a, const ComplexLanes& b)
{
  return {a.re - b.re, a.im - b.im};
}
inline ComplexLanes operator*(const Lanes& f, const ComplexLanes& a)
{
  return {f * a.re, f * a.im};
}
inline ComplexLanes operator*(double f, const ComplexLanes& a)
{
  return {f * a.re, f * a.im};
}
inline ComplexLanes times_i(const ComplexLanes& a)
{
  return {-a.im, a.re};
}

inline Lanes load_lanes(const double* from)
{
  Lanes value;
  std::memcpy(&value, from, sizeof value);
  return value;
}
/// Loads the first `count` values; zero in the other lanes.
inline Lanes load_lanes(const double* from, std::size_t count)
{
  if (count == lane_count)
    return load_lanes(from);
#if defined(__AVX512F__)
  return _mm512_maskz_loadu_pd(static_cast<__mmask8>((1U << count) - 1U), from);
#else
  Lanes value{};
  for (std::size_t lane = 0; lane < count; ++lane)
    value[lane] = from[lane];
  return value;
#endif
}

template <typename Place, int... lane>
[[gnu::always_inline]] inline Lanes shuffled(const Lanes& a, const Lanes& b, Place /*place*/,
                                             std::integer_sequence<int, lane...> /*all*/)
{
  return __builtin_shufflevector(a, b, Place()(lane)...);
}
/// The values of `a` followed by those of `b`, in another order: result[lane] = both[place(lane)].
template <typename Place>
[[gnu::always_inline]] inline Lanes shuffled(const Lanes& a, const Lanes& b, Place place)
{
  return shuffled(a, b, place, std::make_integer_sequence<int, lane_count>());
}

inline ComplexLanes load_lanes(const Complex* from)
{
  const Lanes low = load_lanes(reinterpret_cast<const double*>(from));
  const Lanes high = load_lanes(reinterpret_cast<const double*>(from) + lane_count);
  return {shuffled(low, high, [](int lane) { return 2 * lane; }),
          shuffled(low, high, [](int lane) { return 2 * lane + 1; })};
}
/// Loads the first `count` values; zero in the other lanes.
inline ComplexLanes load_lanes(const Complex* from, std::size_t count)
{
  if (count == lane_count)
    return load_lanes(from);
  ComplexLanes value;
  for (std::size_t lane = 0; lane < count; ++lane)
  {
    value.re[lane] = from[lane].real();
    value.im[lane] = from[lane].imag();
  }
  return value;
}
/// Stores that bypass the caches, for arrays larger than `cached_bytes`: the old contents of the array then need not be read from
/// memory first. `to` must begin on a cache line. Other threads see the values only after `end_streaming`.
inline void stream_lanes(const Lanes& value, double* to)
{
#if defined(__AVX512F__)
  _mm512_stream_pd(to, reinterpret_cast<const __m512d&>(value));
#elif defined(__SSE2__)
  const auto* part = reinterpret_cast<const __m128d*>(&value);
  for (int i = 0; i < lane_count / 2; ++i)
    _mm_stream_pd(to + 2 * i, part[i]);
#else
  std::memcpy(to, &value, sizeof value);
#endif
}
inline void end_streaming()
{
#if defined(__SSE2__)
  _mm_sfence();
#endif
}

/// Stores the first `count` values.
inline void store_lanes(const Lanes& value, std::size_t count, double* to)
{
  if (count == lane_count)
  {
    std::memcpy(to, &value, sizeof value);
    return;
  }
#if defined(__AVX512F__)
  _mm512_mask_storeu_pd(to, static_cast<__mmask8>((1U << count) - 1U), value);
#else
  for (std::size_t lane = 0; lane < count; ++lane)
    to[lane] = value[lane];
#endif
}

/// Stores complex values with real and imaginary parts alternating, as std::complex.
inline void store_lanes(const ComplexLanes& value, Complex* to)
{
  const auto alternating = [](int place) { return place / 2 + (place % 2) * lane_count; };
  const Lanes low = shuffled(value.re, value.im, alternating);
  const Lanes high = shuffled(value.re, value.im, [](int lane) { return decltype(alternating)()(lane + lane_count); });
  auto* lanes = reinterpret_cast<double*>(to);
  std::memcpy(lanes, &low, sizeof low);
  std::memcpy(lanes + lane_count, &high, sizeof high);
}

/// Prefetches a value into the cache, for memory that is read in many short pieces, which the hardware prefetcher does not
/// predict.
inline void fetch_soon(const Lanes* value)
{
  __builtin_prefetch(value);
}
inline void fetch_soon(const ComplexLanes* value)
{
  fetch_soon(&value->re);
  fetch_soon(&value->im);
}

/// Prefetches many values, not necessarily into the nearest cache.
inline void fetch_soon(std::span<const double> values)
{
  constexpr std::size_t cache_line = 64 / sizeof(double);
  for (std::size_t i = 0; i < values.size(); i += cache_line)
    __builtin_prefetch(values.data() + i, 0, 2);
}

/// Prefetches a value that will be written.
inline void write_soon(ComplexLanes* value)
{
  __builtin_prefetch(&value->re, 1);
  __builtin_prefetch(&value->im, 1);
}

inline void store_lanes(const ComplexLanes& value, ComplexLanes* to, bool past_caches)
{
  if (past_caches)
  {
    stream_lanes(value.re, reinterpret_cast<double*>(&to->re));
    stream_lanes(value.im, reinterpret_cast<double*>(&to->im));
  }
  else
    *to = value;
}

} // namespace brinell
