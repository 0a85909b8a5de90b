// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/deviator.hpp"
#include "brinell/green/elastic.hpp"
#include "foundation/lane_functions.hpp"
#include "passing_waves.hpp"

#include <array>
#include <cstddef>

/// Waves of plastic strain that pass from one layer of cells to the next, as running sums: EigenstrainStress has those of a
/// homogeneous body, StackStress those of the layers of a stack.
namespace brinell::halfspace::layer_waves
{

/// Factors of one block of wavenumbers.
struct Factors : FactorsOf<Lanes>
{
  /// Sets the factors of one lane: `factors_of`.
  void set(std::size_t lane, double m, double n, double kept_x, double kept_y, double dz, double nu, double mu);
};

/// Fractions of the couplings of even order through the shears that are retained for the shortest waves, of two cells, along x and along y: 0 for a
/// whole grid; for parts of larger grids see HalfSpace.
struct Shortest
{
  double x = 0.0, y = 0.0;
};

using Wave = WaveOf<ComplexLanes>;
using Field = FieldOf<ComplexLanes>;
using Layer = LayerOf<ComplexLanes>;

/// Adds the local stress [Pa]: that of a uniform, unbounded layer held in its plane (plane stress across it). One component of its
/// deviator, or for component 5 its trace, over `cells` cells.
/// @param strain  components of the strain of the same cells
void add_local(const Elastic& elastic, int component, const std::array<const double*, Deviator::size>& strain,
               std::size_t cells, double* stress);

} // namespace brinell::halfspace::layer_waves
