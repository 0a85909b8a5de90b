// SPDX-License-Identifier: BSD-3-Clause
#include "foundation/lane_fft.hpp"

#include "foundation/aligned.hpp"
#include "foundation/fft.hpp"
#include "foundation/lane_butterflies.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brinell
{

Complex root_of_one(long long numerator, long long denominator)
{
  const double angle =
      2.0 * std::numbers::pi * static_cast<double>(numerator % denominator) / static_cast<double>(denominator);
  return {std::cos(angle), -std::sin(angle)};
}

/// One radix of the algorithm. Its input consists of `done` series of `left` * radix values each, `done` being the product of the
/// radices of the steps before; every `left`-th value of a series belongs to the same butterfly.
struct LaneFft::Step
{
  int radix, done, left;
  std::vector<double> twiddles; ///< [butterfly < left][value 1 ... radix - 1], complex
  std::vector<double> roots;    ///< of the radix: complex conjugate
};

/// Real and imaginary parts of the values, with a stride of `value_size`. If they are exchanged in both source and target, the
/// transform becomes its inverse.
struct LaneFft::Source
{
  const double *re, *im;
  int given; ///< number of values; those beyond are zero
};

struct LaneFft::Target
{
  double *re, *im;
  int wanted;
};

namespace
{

using butterflies::load;
using butterflies::part_size;
using butterflies::store;
using butterflies::Value;
using butterflies::Values;

constexpr std::ptrdiff_t value_size = 2 * lane_count;
constexpr int largest_radix = 13;

double* doubles(ComplexLanes* values)
{
  return reinterpret_cast<double*>(values);
}

LaneFft::Source source(const ComplexLanes* from, int given)
{
  const auto* re = reinterpret_cast<const double*>(from);
  return {re, re + lane_count, given};
}

LaneFft::Target target(ComplexLanes* to, int wanted)
{
  return {doubles(to), doubles(to) + lane_count, wanted};
}

/// Radices whose product is the length; empty if the length has a prime factor above `largest_radix`. An even radix comes first,
/// since half or more of the values of its butterflies are padding.
std::vector<int> radices_of(int length)
{
  std::vector<int> odd;
  for (const int prime : {3, 5, 7, 11, 13})
    for (; length % prime == 0; length /= prime)
      odd.push_back(prime);
  int twos = 0;
  for (; length % 2 == 0; length /= 2)
    ++twos;
  if (length != 1)
    return {};
  std::vector<int> even;
  for (; twos >= 3 && twos != 4; twos -= 3)
    even.push_back(8);
  for (; twos >= 2; twos -= 2)
    even.push_back(4);
  if (twos == 1)
    even.push_back(2);
  std::vector<int> radices;
  if (!even.empty())
  {
    radices.push_back(even.back());
    even.pop_back();
  }
  radices.insert(radices.end(), odd.begin(), odd.end());
  radices.insert(radices.end(), even.begin(), even.end());
  return radices;
}

LaneFft::Step make_step(int radix, int done, int length)
{
  LaneFft::Step step{radix, done, length / (done * radix), {}, {}};
  const auto append = [](std::vector<double>& values, const Complex& value) {
    values.insert(values.end(), {value.real(), value.imag()});
  };
  for (int butterfly = 0; butterfly < step.left; ++butterfly)
    for (int k = 1; k < radix; ++k)
      append(step.twiddles, root_of_one(static_cast<long long>(butterfly) * k, radix * step.left));
  for (int k = 0; k < radix; ++k)
    append(step.roots, std::conj(root_of_one(k, radix)));
  return step;
}

/// Position of a butterfly in its step.
struct Place
{
  bool is_first, is_last;
};

/// One butterfly of some of the lanes.
template <std::size_t radix, Place place, bool is_half>
inline void butterfly(const LaneFft::Step& step, const LaneFft::Source& from, std::ptrdiff_t first,
                      const double* twiddles, const LaneFft::Target& to, std::ptrdiff_t first_target, std::size_t part)
{
  Values<radix> a;
  const std::ptrdiff_t apart = static_cast<std::ptrdiff_t>(step.done) * step.left;
  for (std::size_t k = 0; k < (is_half ? radix / 2 : radix); ++k)
  {
    const std::ptrdiff_t at = first + apart * static_cast<std::ptrdiff_t>(k);
    if (!place.is_first || at < from.given)
      a[k] = Value{load(from.re + at * value_size + part), load(from.im + at * value_size + part)};
    else
      a[k] = Value{};
  }
  if constexpr (is_half)
    butterflies::transform_half<radix>(a);
  else
    butterflies::transform<radix>(a, step.roots.data());
  for (std::size_t k = 0; k < radix; ++k)
  {
    const std::ptrdiff_t at = first_target + step.done * static_cast<std::ptrdiff_t>(k);
    if (place.is_last && at >= to.wanted)
      return;
    const Value value = place.is_last || k == 0 ? a[k] : butterflies::times(a[k], twiddles + 2 * (k - 1));
    store(value.re, to.re + at * value_size + part);
    store(value.im, to.im + at * value_size + part);
  }
}

template <std::size_t radix, Place place, bool is_half>
void take_butterflies(const LaneFft::Step& step, const LaneFft::Source& from, const LaneFft::Target& to)
{
  const double* twiddles = step.twiddles.data();
  for (std::ptrdiff_t p = 0; p < step.left; ++p, twiddles += 2 * (radix - 1))
    for (std::ptrdiff_t q = 0; q < step.done; ++q)
      for (std::size_t part = 0; part < lane_count; part += part_size)
        butterfly<radix, place, is_half>(step, from, q + step.done * p, twiddles, to,
                                         q + step.done * static_cast<std::ptrdiff_t>(radix) * p, part);
}

template <std::size_t radix>
void take_step(const LaneFft::Step& step, const LaneFft::Source& from, const LaneFft::Target& to)
{
  const bool is_first = step.done == 1, is_last = step.left == 1;
  if constexpr (radix % 2 == 0)
    if (is_first && !is_last && from.given <= step.left * static_cast<int>(radix / 2))
      return take_butterflies<radix, Place{true, false}, true>(step, from, to);
  if (is_first && is_last)
    take_butterflies<radix, Place{true, true}, false>(step, from, to);
  else if (is_first)
    take_butterflies<radix, Place{true, false}, false>(step, from, to);
  else if (is_last)
    take_butterflies<radix, Place{false, true}, false>(step, from, to);
  else
    take_butterflies<radix, Place{false, false}, false>(step, from, to);
}

void take(const LaneFft::Step& step, const LaneFft::Source& from, const LaneFft::Target& to)
{
  switch (step.radix)
  {
  case 2:
    return take_step<2>(step, from, to);
  case 3:
    return take_step<3>(step, from, to);
  case 4:
    return take_step<4>(step, from, to);
  case 5:
    return take_step<5>(step, from, to);
  case 7:
    return take_step<7>(step, from, to);
  case 8:
    return take_step<8>(step, from, to);
  case 11:
    return take_step<11>(step, from, to);
  default:
    static_assert(largest_radix == 13);
    return take_step<13>(step, from, to);
  }
}

/// Multiplies the first `count` values by complex numbers.
void multiply(const LaneFft::Source& from, const Complex* factors, int count, const LaneFft::Target& to)
{
  for (std::ptrdiff_t i = 0; i < count; ++i)
    for (std::size_t part = 0; part < lane_count; part += part_size)
    {
      const std::ptrdiff_t at = i * value_size + static_cast<std::ptrdiff_t>(part);
      const std::array factor{factors[i].real(), factors[i].imag()};
      const Value product = butterflies::times({load(from.re + at), load(from.im + at)}, factor.data());
      store(product.re, to.re + at);
      store(product.im, to.im + at);
    }
}

} // namespace

/// With c_j = e^{-pi i j^2 / n}, the transform is c_k times the convolution of c_j x_j with the conjugate of c; the convolution
/// is computed by transforms of a longer, fast length.
struct LaneFft::Chirp
{
  LaneFft longer;
  std::vector<Complex> chirp;    ///< c
  std::vector<Complex> spectrum; ///< of its conjugate, over the longer length

  explicit Chirp(int length) : longer(fast_length(2 * length - 1)), chirp(static_cast<std::size_t>(length))
  {
    AlignedVector<ComplexLanes> kernel(static_cast<std::size_t>(longer.length())), transformed(kernel.size());
    AlignedVector<ComplexLanes> work(longer.work_size());
    for (int j = 0; j < length; ++j)
    {
      const Complex value = root_of_one(static_cast<long long>(j) * j, 2LL * length);
      chirp[static_cast<std::size_t>(j)] = value;
      for (const int at : {j, (longer.length() - j) % longer.length()})
      {
        kernel[static_cast<std::size_t>(at)].re[0] = value.real();
        kernel[static_cast<std::size_t>(at)].im[0] = -value.imag();
      }
    }
    longer.forward(kernel.data(), longer.length(), transformed.data(), work.data());
    for (const ComplexLanes& value : transformed)
      spectrum.emplace_back(value.re[0] / longer.length(), value.im[0] / longer.length());
  }
};

LaneFft::LaneFft(int length) : length_(length)
{
  int done = 1;
  for (const int radix : radices_of(length))
  {
    steps_.push_back(make_step(radix, done, length));
    done *= radix;
  }
  if (done != length)
    chirp_ = std::make_unique<Chirp>(length);
}

LaneFft::~LaneFft() = default;
LaneFft::LaneFft(LaneFft&&) noexcept = default;
LaneFft& LaneFft::operator=(LaneFft&&) noexcept = default;

std::size_t LaneFft::work_size() const
{
  if (chirp_)
    return 2 * static_cast<std::size_t>(chirp_->longer.length()) + chirp_->longer.work_size();
  return 2 * static_cast<std::size_t>(length_);
}

void LaneFft::forward(const ComplexLanes* from, int given, ComplexLanes* to, ComplexLanes* work) const
{
  transform(source(from, given), target(to, length_), work);
}

void LaneFft::inverse(const ComplexLanes* from, ComplexLanes* to, int wanted, ComplexLanes* work) const
{
  const Source in = source(from, length_);
  const Target out = target(to, wanted);
  transform({in.im, in.re, in.given}, {out.im, out.re, out.wanted}, work);
}

void LaneFft::transform(const Source& from, const Target& to, ComplexLanes* work) const
{
  if (chirp_)
    return convolve(from, to, work);
  if (steps_.empty()) // of a single value
    return multiply(from, std::array{Complex(1.0)}.data(), std::min(from.given, to.wanted), to);
  Source here = from;
  ComplexLanes* free = work;
  for (const Step& step : steps_)
  {
    const Target there = step.left == 1 ? to : target(free, length_);
    take(step, here, there);
    here = {there.re, there.im, length_};
    free = free == work ? work + length_ : work;
  }
}

void LaneFft::convolve(const Source& from, const Target& to, ComplexLanes* work) const
{
  const LaneFft& longer = chirp_->longer;
  ComplexLanes* values = work;
  ComplexLanes* spectrum = values + longer.length();
  ComplexLanes* rest = spectrum + longer.length();
  multiply(from, chirp_->chirp.data(), from.given, target(values, from.given));
  longer.forward(values, from.given, spectrum, rest);
  multiply(source(spectrum, longer.length()), chirp_->spectrum.data(), longer.length(),
           target(spectrum, longer.length()));
  longer.inverse(spectrum, values, to.wanted, rest);
  multiply(source(values, to.wanted), chirp_->chirp.data(), to.wanted, to);
}

} // namespace brinell
