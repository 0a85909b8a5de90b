// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/green/elastic.hpp"

namespace brinell::reference
{

/// An elastic-perfectly-plastic sphere pressed by a rigid flat; two equal spheres are two of these back to back, with
/// the same ratios to first yield. Fits of finite-element computations; alpha* = approach over approach at first yield.
struct IndentedSphere
{
  Elastic elastic;
  double yield_stress = 0.0; ///< S_y [Pa], > 0
};

/// C = p0/S_y at first yield by Jackson & Green (2005): 1.295 exp(0.736 nu), within 0.1 % of `critical_pressure_ratio`.
[[nodiscard]] double jackson_green_pressure_ratio(double poisson_ratio);

/// Contact area over the critical one, pi R alpha_c, by Jackson & Green (2005): alpha* (alpha*/1.9)^B with
/// B = 0.14 exp(23 S_y/E'), E' = E/(1 - nu^2), and alpha* below 1.9.
/// @throws InputError
[[nodiscard]] double jackson_green_area(double interference_ratio, const IndentedSphere& sphere);

/// Load over the critical one by Jackson & Green (2005), Hertz below alpha* = 1.9:
///     exp(-alpha*^(5/12)/4) alpha*^1.5 + 4 H/(C S_y) (1 - exp(-alpha*^(5/9)/25)) alpha*,
///     H/S_y = 2.84 - 0.92 (1 - cos(pi a/R)),  a from `jackson_green_area`, R the sphere's radius.
/// @throws InputError
[[nodiscard]] double jackson_green_load(double interference_ratio, const IndentedSphere& sphere);

/// Load over the critical one by Kogut & Etsion (2002): alpha*^1.5 up to 1, 1.03 alpha*^1.425 up to 6, 1.40
/// alpha*^1.263 up to 110. The fit has steps of 3 % at 1 and of 2 % at 6.
/// @param interference_ratio  alpha*, (0, 110].
/// @throws InputError
[[nodiscard]] double kogut_etsion_load(double interference_ratio);

} // namespace brinell::reference
