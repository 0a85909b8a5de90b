// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/green/surface_terms.hpp"
#include "halfspace/transform/cell_response.hpp"
#include "halfspace/transform/kernel_places.hpp"
#include "stack_shears.hpp"

#include <vector>

namespace brinell::halfspace
{

/// Compliance along x and y to shears along x and y, for one wave: a symmetric matrix [m/Pa].
struct ShearWave
{
  double xx = 0.0, yy = 0.0, xy = 0.0;

  /// Matrix from the spectra of the terms x^2/r^3, y^2/r^3, x y/r^3 (green::SurfaceTerms).
  [[nodiscard]] static ShearWave of_terms(double xx, double yy, double xy, const green::PairConstants& constants);
  [[nodiscard]] double smallest() const; ///< eigenvalue
  [[nodiscard]] double largest() const;  ///< eigenvalue
  [[nodiscard]] ShearWave inverse() const;
};

/// Largest eigenvalue of all.
[[nodiscard]] double largest(const std::vector<ShearWave>& waves);

/// Compliances of bodies that are periodic along both axes, row by row, [ny / 2 + 1][nx / 2 + 1]; zero for the uniform wave
/// [m/Pa].
[[nodiscard]] std::vector<ShearWave> periodic_shear_waves(const SurfaceGrid& grid,
                                                          const green::PairConstants& constants);

/// Compliances from a kernel on the grid, row by row [m/Pa].
[[nodiscard]] std::vector<ShearWave> shear_waves(const SurfaceGrid& grid, const KernelPlaces& places,
                                                 const Quadrant<green::SurfaceTerms>& response,
                                                 const green::PairConstants& constants);

/// Adds what layered bodies yield more than bodies of their top materials to the compliances of the nearest periodic operator, row by
/// row.
void add_excess(const SurfaceGrid& grid, const std::vector<LayeredBody>& layered, double reference,
                std::vector<ShearWave>& waves);

} // namespace brinell::halfspace
