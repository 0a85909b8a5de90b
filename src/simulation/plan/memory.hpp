// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/material.hpp"
#include "brinell/simulation/scenario.hpp"

namespace brinell::simulation
{

/// Factor by which the grids of bodies that touch along a line grow during a run, an estimate from measured ones: below a line
/// plastic strain reaches deeper than planned.
/// @param over_yield  elastic pressure over that at first yield
[[nodiscard]] double growth_of_line(double over_yield);

/// Parts of the memory of a run [bytes].
struct MemoryParts
{
  double growth = 1.0;    ///< factor on all of them, as grids grow
  double contact = 0.0;   ///< fields and transforms of the contact
  double operators = 0.0; ///< kernels of the bodies
  double bodies = 0.0;    ///< their states and spectra
  double windows = 0.0;
  double heat = 0.0;
  // One after the other:
  double trials = 0.0; ///< within an increment
  double output = 0.0; ///< while fields are written

  [[nodiscard]] double total() const; ///< peak, with the program itself
};

[[nodiscard]] MemoryParts memory_parts(const Plan& plan, const constitutive::Material& lower,
                                       const constitutive::Material& upper, const elastoplastic::Settings& solver,
                                       int shears, const elastoplastic::HeatSettings* heat, int ranks = 1);

/// Cells near yield in an increment, an estimate.
[[nodiscard]] double active_cells(const VolumeGrid& grid, const elastoplastic::Settings& solver, const Plan& plan);
/// Whether increments keep a longer history (docs/theory/elastoplastic.md, deep). Of their scales that of displacements is limited from
/// below.
[[nodiscard]] bool has_deep_indents(const Plan& plan);

/// Peak memory of a run, including the program itself [bytes].
/// @param lower, upper  materials of the bodies
/// @param solver        of the increments
/// @param shears        number of components of the shear between the bodies, 0 to 2
/// @param heat          settings of heat, in bodies that have thermal constants; nullptr: heat is not computed
/// @param ranks         that share the bodies: the memory of the first of them, which needs most. Each has all of contact and heat.
[[nodiscard]] double memory_bytes(const Plan& plan, const constitutive::Material& lower,
                                  const constitutive::Material& upper, const elastoplastic::Settings& solver,
                                  int shears, const elastoplastic::HeatSettings* heat, int ranks = 1);

} // namespace brinell::simulation
