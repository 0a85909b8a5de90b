// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/flow.hpp"

namespace brinell::elastoplastic
{

using constitutive::Integration;

/// Tolerances and choices of the coupled increment.
struct Settings
{
  double yield_tolerance = 1e-4;        ///< largest violation of the yield condition, relative to the yield stress
  double displacement_tolerance = 1e-5; ///< largest change of residual displacement, relative to alpha_c
  double contact_tolerance = 1e-7;      ///< complementarity of the contact: gap relative to the interference
  int max_iterations = 60;              ///< evaluations per increment before it is split
  int anderson_depth = 6;               ///< 0: plain fixed point
  Integration integration = Integration::path;
  bool mirror = true; ///< of two bodies that are mirror images of each other, solve one
  /// Compute the stress only in the layers of the active cells, those near yield, until the increment is nearly solved; the
  /// evaluation that ends it computes all of it, and finds every cell that yields. false: all layers, every cell active.
  bool shortcuts = true;
};

} // namespace brinell::elastoplastic
