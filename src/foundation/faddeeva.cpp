// SPDX-License-Identifier: BSD-3-Clause
#include "foundation/faddeeva.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace brinell
{

namespace
{

constexpr int terms = 40;

/// Coefficients of e^{-t^2} (L^2 + t^2) in the powers of (L + it)/(L - it): a Fourier sum over theta, t = L tan(theta/2).
struct Weideman
{
  double length = std::sqrt(terms / std::numbers::sqrt2);
  std::array<double, terms> coefficient{};

  Weideman()
  {
    constexpr int half = 2 * terms, points = 2 * half;
    for (int n = 0; n < terms; ++n)
    {
      double sum = 0.0;
      for (int j = 1 - half; j < half; ++j)
      {
        const double theta = j * std::numbers::pi / half, t = length * std::tan(0.5 * theta);
        sum += std::exp(-t * t) * (length * length + t * t) * std::cos((n + 1) * theta);
      }
      coefficient[static_cast<std::size_t>(n)] = sum / points;
    }
  }
};

} // namespace

std::complex<double> faddeeva(std::complex<double> z)
{
  static const Weideman table;
  // (L + iz) and 1/(L - iz) by real and imaginary parts, because products of std::complex check for infinities.
  const double below_re = table.length + z.imag(), below_im = -z.real();
  const double inverse = 1.0 / (below_re * below_re + below_im * below_im);
  const double re = below_re * inverse, im = -below_im * inverse;
  const double above_re = table.length - z.imag(), above_im = z.real();
  const double ratio_re = above_re * re - above_im * im, ratio_im = above_re * im + above_im * re;
  double sum_re = 0.0, sum_im = 0.0;
  for (std::size_t n = terms; n-- > 0;)
  {
    const double next = sum_re * ratio_re - sum_im * ratio_im + table.coefficient[n];
    sum_im = sum_re * ratio_im + sum_im * ratio_re;
    sum_re = next;
  }
  const double square_re = re * re - im * im, square_im = 2.0 * re * im;
  return {2.0 * (sum_re * square_re - sum_im * square_im) + re * std::numbers::inv_sqrtpi,
          2.0 * (sum_re * square_im + sum_im * square_re) + im * std::numbers::inv_sqrtpi};
}

} // namespace brinell
