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
  double displacement_tolerance = 1e-5; ///< largest change of residual displacement, relative to Scales::displacement
  double contact_tolerance = 1e-7;      ///< complementarity of the contact: gap relative to Scales::gap
  int max_evaluations = 60;             ///< evaluations per increment before it is split
  int anderson_depth = 6;               ///< 0: plain fixed point
  Integration integration = Integration::path;
  /// Of two bodies that keep mirrored or equal fields, solve one: docs/theory/elastoplastic.md.
  bool mirror = true;
  /// Where bodies, surfaces and motion are the same on both sides of y = 0, solve one side: docs/theory/elastoplastic.md.
  bool symmetry = true;
  /// Compute the stress only down to the deepest active cell (near yield) and one layer more, until the increment is nearly
  /// solved; the evaluation that ends the increment computes all layers, and finds every cell that yields. false: all layers
  /// in every evaluation, every cell active.
  bool shortcuts = true;
  /// With short cuts, on a body much longer than the contact: until an increment is nearly solved compute only the columns of the
  /// active cells and of the load; the evaluation that ends the increment computes all cells. false: all columns.
  bool windows = true;
};

} // namespace brinell::elastoplastic
