// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <complex>

namespace brinell
{

/// Faddeeva's function w(z) = e^{-z^2} erfc(-iz) for Im z >= 0, where it is at most 1 in size; to some 1e-13
/// (Weideman 1994, SIAM J. Numer. Anal. 31, 1497, Table 1, with 40 terms).
[[nodiscard]] std::complex<double> faddeeva(std::complex<double> z);

} // namespace brinell
