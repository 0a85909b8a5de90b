// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace brinell::test
{

/// A flat rigid punch, pressed into an elastic half plane on which it rubs: where the surface beneath it sticks, over the half-width of
/// the punch, from the two integral equations of both tractions,
///   (1/pi) int p(s)/(x - s) ds - beta q(x) = 0 in |x| < 1,  (1/pi) int q(s)/(x - s) ds + beta p(x) = 0 in |x| < c,
/// with q = f p sign(x) in c < |x| < 1 (Johnson 1985, Eqs. 2.25; Spence 1973). The increments of cylinders and wedges have the same
/// stick (Spence 1975). Piecewise constant pressure and piecewise linear shear on elements that get smaller towards c and the edge,
/// extrapolated from two meshes: good to 1e-4, with all of the coupling.
/// @param beta  Dundurs' constant, > 0: (1 - 2 nu)/(2 (1 - nu)) on an elastic body and a rigid punch
/// @param friction  below that at which all sticks
[[nodiscard]] double stick_of_a_punch(double beta, double friction);

} // namespace brinell::test
