// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "brinell/green/surface_terms.hpp"
#include "brinell/halfspace/surface_load.hpp"
#include "foundation/fft.hpp"
#include "halfspace/transform/wave_product.hpp"
#include "stack_shears.hpp"

#include <array>
#include <optional>
#include <vector>

namespace brinell::halfspace
{

/// Pressure and shears -> displacement along z, x and y: the part of SurfaceCompliance with shears.
class Tractions
{
public:
  /// @param constants  of the materials at the surfaces
  /// @param layered    the bodies of the pair that have layers
  Tractions(const SurfaceGrid& grid, const green::PairConstants& constants, double reference,
            const std::vector<LayeredBody>& layered = {});

  /// The displacement along z, x and y of a pressure and the shears along x and y.
  using Product = WaveProduct<3>;
  [[nodiscard]] Product::Scratch make_scratch() const { return product_.make_scratch(); }
  void apply(const SurfaceLoad& load, const SurfaceDisplacement& displacement, Product::Scratch& scratch) const;
  /// Largest displacement along the surface by a wave of unit shear [m/Pa].
  [[nodiscard]] double largest_of_shear() const { return largest_of_shear_; }

private:
  static constexpr std::size_t term_count = 5; ///< green::SurfaceTerms
  /// Spectra of the terms for `lane_count` wavenumbers: real or imaginary parts, according to their parities.
  using Terms = std::array<Lanes, term_count>;
  using Excess = std::array<Lanes, excess::count>; ///< SurfaceExcess [m/Pa]
  void tabulate_cells(const PaddedFft& padded, double reference);
  void tabulate_waves(const PaddedFft& padded);
  void tabulate_excess(const PaddedFft& padded, double reference, const std::vector<LayeredBody>& layered);
  [[nodiscard]] Product::Values displaced(const Terms& term, int row, const Product::Values& load) const;
  void add_excess(const Excess& more, int row, const Product::Values& load, Product::Values& displacement) const;

  green::PairConstants constants_;
  Product product_;
  WaveTable<Terms> terms_;
  std::optional<WaveTable<Excess>> excess_; ///< of layered bodies
  double largest_of_shear_ = 0.0;
};

} // namespace brinell::halfspace
