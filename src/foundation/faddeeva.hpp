// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <complex>

namespace brinell
{

/// Faddeeva function w(z) = e^{-z^2} erfc(-iz) for Im z >= 0, where |w| <= 1; accurate to about 1e-13
/// (Weideman 1994, SIAM J. Numer. Anal. 31, 1497, Table 1, with 40 terms).
[[nodiscard]] std::complex<double> faddeeva(std::complex<double> z);

} // namespace brinell
