// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/green/surface_terms.hpp"
#include "halfspace/transform/wave_product.hpp"
#include "stack_shears.hpp"

#include <vector>

namespace brinell::halfspace
{

/// Displacement along a surface -> approximately the shears that cause it: the inverse of the nearest operator that is periodic
/// on the grid (T. Chan 1988), the analogue of `SurfaceCompliance::apply_inverse` for shears.
class ShearStiffness
{
public:
  /// @param layered  the bodies of the pair that have layers
  ShearStiffness(const SurfaceGrid& grid, const green::PairConstants& constants, double reference,
                 const std::vector<LayeredBody>& layered = {});

  using Product = WaveProduct<2>;
  using Scratch = Product::Scratch;
  [[nodiscard]] Scratch make_scratch() const { return product_.make_scratch(); }
  [[nodiscard]] bool fits(const Scratch& scratch) const { return product_.fits(scratch); }

  /// Input and output are fields along x and y and may be the same.
  /// @param added  additional compliance of each cell [m/Pa]
  void apply(const std::array<std::span<const double>, 2>& displacement, const std::array<std::span<double>, 2>& shear,
             Scratch& scratch, double added) const;
  /// Mean over all waves and both directions: the shear on a cell per unit displacement of this cell alone [Pa/m].
  [[nodiscard]] double of_one_cell() const { return of_one_cell_; }

private:
  ShearStiffness(const SurfaceGrid& grid, const SurfaceGrid& larger, const green::PairConstants& constants,
                 double reference, const std::vector<LayeredBody>& layered);

  Product product_;
  WaveTable<std::array<Lanes, 3>> stiffness_; ///< xx, yy, xy of each wave
  double of_one_cell_ = 0.0;
};

} // namespace brinell::halfspace
