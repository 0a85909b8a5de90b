// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/flow.hpp"

#include <algorithm>

namespace brinell::elastoplastic
{

using constitutive::Integration;

/// Where the increments of bodies that can yield are evaluated.
enum class DeviceChoice
{
  cpu,
  cuda,      ///< a GPU
  automatic, ///< a GPU if there is one that can, otherwise the processor
  host       ///< the processor in the part of a GPU, to prove runs without one
};

/// Tolerances and choices of the coupled increment.
struct Settings
{
  double yield_tolerance = 1e-4;        ///< largest violation of the yield condition, relative to the yield stress
  double displacement_tolerance = 1e-5; ///< largest change of residual displacement, relative to Scales::displacement
  double contact_tolerance = 1e-7;      ///< complementarity of the contact: gap relative to Scales::gap
  int max_evaluations = 60;             ///< evaluations per increment before it is split
  int anderson_depth = 6;               ///< 0: plain fixed point
  Integration integration = Integration::path;
  /// If both bodies have mirrored or equal fields throughout, solve only one: docs/theory/elastoplastic.md.
  bool mirror = true;
  /// If bodies, surfaces and motion are symmetric about y = 0, solve one half: docs/theory/elastoplastic.md.
  bool symmetry = true;
  /// Until the increment is nearly solved, compute the stress only down to one layer below the deepest active cell (near yield);
  /// the evaluation that ends the increment computes all layers, and finds every cell that yields. false: all layers
  /// in every evaluation, every cell active.
  bool shortcuts = true;
  /// With short cuts, on a body longer than what an increment changes: until the increment is nearly solved, compute
  /// only the columns of the active cells and of the load; the evaluation that ends the increment computes all cells.
  /// false: all columns.
  bool windows = true;
  /// Where sliding begins or reverses, friction is raised before the surfaces move, in as many increments as it grows by parts of
  /// the shear yield stress, this number of parts being the whole of it. 0: in one increment together with the first motion.
  int onset_increments = 16;
  DeviceChoice device = DeviceChoice::cpu; ///< of a run; a CoupledContact is given its Device

  /// Complementarity to which contacts are solved. With smaller tolerances of yield and displacement than the default ones it is
  /// smaller than `contact_tolerance`: what the contact leaves unsolved changes from evaluation to evaluation, so that it must
  /// stay well below the errors that end an increment. docs/theory/elastoplastic.md
  [[nodiscard]] double tolerance_of_contact() const
  {
    constexpr double share_of_yield = 1e-3, share_of_displacement = 1e-2; // of the default tolerances
    constexpr double rounding = 1e-12;
    const double needed =
        std::max(rounding, std::min(share_of_yield * yield_tolerance, share_of_displacement * displacement_tolerance));
    return std::min(contact_tolerance, needed);
  }
};

} // namespace brinell::elastoplastic
