// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/deviator.hpp"
#include "brinell/green/elastic.hpp"

#include <array>
#include <complex>

namespace brinell::green
{

/// Amplitude of a plane wave of stress [Pa/m per unit strain].
struct SheetStress
{
  std::array<std::complex<double>, Deviator::size> deviator; ///< order of Deviator
  std::complex<double> trace;
};

/// Stress at depth z of a thin sheet of traceless plastic strain eps e^{i (m x + n y)} at depth z', in a half
/// space z >= 0 with a free surface, per unit thickness of the sheet [Pa/m]. The stress inside the sheet itself (a delta
/// function of z - z') is not included. Derived in docs/theory/half-space.md
/// (sheet-stress), (sheet-shear), (free-surface); formulas also in src/halfspace/strain/eigenstrain_stress.hpp.
/// @param m, n         wavenumbers along x and y [rad/m], not both zero
/// @param z, z_source  depths of the point and of the sheet [m], >= 0
/// @param strain       amplitude of the plastic strain, real
[[nodiscard]] SheetStress eigenstrain_sheet_stress(double m, double n, double z, double z_source,
                                                   const Deviator& strain, const Elastic& elastic);

} // namespace brinell::green
