// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/host_device.hpp"

namespace brinell
{

/// One complex value with the arithmetic of ComplexLanes, for a CUDA thread and its twin on the host: the operators of
/// std::complex are no functions of a device. In memory it is a std::complex<double>; aligned so that a thread reads it at once.
struct alignas(2 * sizeof(double)) ComplexNumber
{
  double re = 0.0, im = 0.0;
};

BRINELL_HOST_DEVICE inline ComplexNumber operator+(const ComplexNumber& a, const ComplexNumber& b)
{
  return {a.re + b.re, a.im + b.im};
}
BRINELL_HOST_DEVICE inline ComplexNumber operator-(const ComplexNumber& a, const ComplexNumber& b)
{
  return {a.re - b.re, a.im - b.im};
}
BRINELL_HOST_DEVICE inline ComplexNumber operator*(double f, const ComplexNumber& a)
{
  return {f * a.re, f * a.im};
}
BRINELL_HOST_DEVICE inline ComplexNumber times_i(const ComplexNumber& a)
{
  return {-a.im, a.re};
}

} // namespace brinell
