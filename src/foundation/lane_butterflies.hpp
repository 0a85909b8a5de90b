// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "foundation/lanes.hpp"

#include <array>
#include <cstddef>
#include <cstring>

/// Butterflies: transforms of a few values, in as many lanes as a register of the processor has.
namespace brinell::butterflies
{

#if defined(__AVX512F__)
inline constexpr std::size_t part_size = 8;
#elif defined(__AVX__)
inline constexpr std::size_t part_size = 4;
#else
inline constexpr std::size_t part_size = 2;
#endif
/// A part of the lanes, so small that all values of a butterfly stay in registers.
using Part = double __attribute__((vector_size(part_size * sizeof(double))));

struct Value
{
  Part re, im;
};

inline Part load(const double* from)
{
  Part value;
  std::memcpy(&value, from, sizeof value);
  return value;
}
inline void store(const Part& value, double* to)
{
  std::memcpy(to, &value, sizeof value);
}

inline Value operator+(const Value& a, const Value& b)
{
  return {a.re + b.re, a.im + b.im};
}
inline Value operator-(const Value& a, const Value& b)
{
  return {a.re - b.re, a.im - b.im};
}
inline Value times_minus_i(const Value& a)
{
  return {a.im, -a.re};
}
/// Times the complex number at `factor`.
inline Value times(const Value& a, const double* factor)
{
  return {a.re * factor[0] - a.im * factor[1], a.im * factor[0] + a.re * factor[1]};
}

template <std::size_t radix>
using Values = std::array<Value, radix>;

/// Of four values, in place.
inline void transform_four(Value& a, Value& b, Value& c, Value& d)
{
  const Value even = a + c, odd = a - c, sum = b + d, turned = times_minus_i(b - d);
  a = even + sum;
  b = odd + turned;
  c = even - sum;
  d = odd - turned;
}

/// The transform of a prime number of values; values with opposite indices (k and radix - k) are combined.
/// @param roots  cos and sin of 2 pi k / radix, one after the other
template <std::size_t radix>
#if !defined(__AVX512F__) // calls cost up to a quarter of a transform with AVX2, and save a twentieth with AVX-512
[[gnu::always_inline]]
#endif
inline void
transform(Values<radix>& a, const double* roots)
{
  constexpr std::size_t pairs = radix / 2;
  std::array<Value, pairs> sum, difference;
  for (std::size_t j = 0; j < pairs; ++j)
  {
    sum[j] = a[j + 1] + a[radix - 1 - j];
    difference[j] = a[j + 1] - a[radix - 1 - j];
  }
  const Value first = a[0];
  for (std::size_t j = 0; j < pairs; ++j)
    a[0] = a[0] + sum[j];
  for (std::size_t k = 1; k <= pairs; ++k)
  {
    Value even{first.re + roots[2 * k] * sum[0].re, first.im + roots[2 * k] * sum[0].im};
    Value odd{roots[2 * k + 1] * difference[0].re, roots[2 * k + 1] * difference[0].im};
    for (std::size_t j = 1; j < pairs; ++j)
    {
      const double* root = roots + 2 * ((j + 1) * k % radix);
      even = {even.re + root[0] * sum[j].re, even.im + root[0] * sum[j].im};
      odd = {odd.re + root[1] * difference[j].re, odd.im + root[1] * difference[j].im};
    }
    const Value turned = times_minus_i(odd);
    a[k] = even + turned;
    a[radix - k] = even - turned;
  }
}

template <>
inline void transform<2>(Values<2>& a, const double* /*roots*/)
{
  const Value difference = a[0] - a[1];
  a[0] = a[0] + a[1];
  a[1] = difference;
}

template <>
inline void transform<4>(Values<4>& a, const double* /*roots*/)
{
  transform_four(a[0], a[1], a[2], a[3]);
}

/// Outputs with even and with odd index of a transform of eight values, from the inputs of the two transforms of four.
inline void finish_eight(Values<8>& a, Values<4>& even, Values<4>& odd)
{
  constexpr double half_root = 0.70710678118654752440;
  odd[1] = {half_root * (odd[1].re + odd[1].im), half_root * (odd[1].im - odd[1].re)};
  odd[2] = times_minus_i(odd[2]);
  odd[3] = {half_root * (odd[3].im - odd[3].re), -half_root * (odd[3].re + odd[3].im)};
  transform_four(even[0], even[1], even[2], even[3]);
  transform_four(odd[0], odd[1], odd[2], odd[3]);
  a = {even[0], odd[0], even[1], odd[1], even[2], odd[2], even[3], odd[3]};
}

template <>
inline void transform<8>(Values<8>& a, const double* /*roots*/)
{
  Values<4> even{a[0] + a[4], a[1] + a[5], a[2] + a[6], a[3] + a[7]};
  Values<4> odd{a[0] - a[4], a[1] - a[5], a[2] - a[6], a[3] - a[7]};
  finish_eight(a, even, odd);
}

/// Transform of values whose second half is zero; it is not read.
template <std::size_t radix>
inline void transform_half(Values<radix>& a);

template <>
inline void transform_half<2>(Values<2>& a)
{
  a[1] = a[0];
}

template <>
inline void transform_half<4>(Values<4>& a)
{
  const Value first = a[0], second = a[1], turned = times_minus_i(a[1]);
  a = {first + second, first + turned, first - second, first - turned};
}

template <>
inline void transform_half<8>(Values<8>& a)
{
  Values<4> even{a[0], a[1], a[2], a[3]};
  Values<4> odd = even;
  finish_eight(a, even, odd);
}

} // namespace brinell::butterflies
