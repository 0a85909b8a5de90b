// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "depth_sums.hpp"
#include "layered_conduction.hpp"

#include <memory>
#include <span>
#include <vector>

namespace brinell::halfspace
{

/// Heat generated in the layers of a body with a periodic surface: for each wave along the surface, the temperatures of the
/// layers. Exact in time for heat generated at a constant rate over a step, and of second order in the thickness of the layers:
/// docs/theory/heat.md (buried).
class BuriedHeat
{
public:
  /// @param along    all waves, row by row
  /// @param columns  waves in a row
  BuriedHeat(std::shared_ptr<const LayeredConduction> layers, std::span<const SurfaceWave> along, std::size_t columns,
             double diffusivity);

  /// A step: the heat of earlier steps spreads, and new heat is generated at a constant rate.
  /// @param rise  spectra of the temperature rise of the layers if they retained all of the new heat [K], one each;
  ///              empty ones are zero
  void take_up(const std::vector<AlignedVector<Complex>>& rise, double duration);
  /// Restores the state before the last step.
  void go_back();
  [[nodiscard]] bool is_cold() const { return is_cold_; }

  /// Adds the temperature of the surface to the spectrum of all waves [K].
  void add_surface(Complex* temperature) const;

  /// Sums over the layers for a row of waves, in blocks of `lane_count` columns.
  struct Row
  {
    std::size_t first = 0;           ///< block
    AlignedVector<Lanes> left, sum;  ///< e^{-kh} and its integral, [kind]: for the heated layers, then the thicker ones
    AlignedVector<Lanes> to_surface; ///< e^{-kz} from the middle of each heated layer, [block][layer]
    /// By the heat above the top of each layer, integral of T e^{-k(z - z')} dz', and likewise below it: [block][layer].
    AlignedVector<ComplexLanes> from_above, from_below;
  };
  [[nodiscard]] Row make_row() const;
  void gather(std::size_t number, Row& row) const;
  /// Adds the potential of the surface, times k [K m], for a row of waves in whole blocks.
  void add_potential_at_surface(std::size_t number, double factor, Complex* potential) const;
  /// Temperature [K], potential times k, and its slope [K m], at one depth, of a row in whole blocks; real and imaginary parts
  /// alternate.
  struct Sums
  {
    double *temperature, *potential, *slope;
  };
  void add(double depth, double factor, const Row& row, const Sums& sums) const;

  /// The state: amplitudes of all modes, [mode][plane]. @param plane  values from one mode to the next
  [[nodiscard]] AlignedVector<Complex> modes(std::size_t plane) const;
  void set_modes(const AlignedVector<Complex>& modes, std::size_t plane);
  [[nodiscard]] const LayeredConduction& layers() const { return *layers_; }

private:
  /// Waves side by side, and what the steps need to know of them.
  struct Block
  {
    std::size_t wave, count;     ///< the first wave, and the number of them; the other lanes are unused
    Lanes k;                     ///< [1/m]
    Lanes half_left, half_sum;   ///< e^{-kz} and its integral over half a heated layer
    Lanes next_left, next_sum;   ///< over the first layer of the thicker ones
    Lanes rates{}, left_along{}; ///< kappa k^2 t, and e^{-that}, of the planned step
  };
  /// Quantities of a step that are the same for all waves.
  struct Step
  {
    std::span<const AlignedVector<Complex>> rise;
    std::size_t first, last;         ///< range of layers in which heat is generated; last = 0: in none
    std::vector<double> rates, left; ///< of the modes: kappa s^2 t, and e^{-that}
  };
  struct Scratch
  {
    AlignedVector<ComplexLanes> rise, in; ///< of layers, of modes
    AlignedVector<Lanes> left, sum;       ///< as in Row
  };
  [[nodiscard]] std::size_t kinds() const { return 1 + layers_->size() - layers_->heated(); }
  [[nodiscard]] std::size_t kind_of(std::size_t layer) const
  {
    return layer < layers_->heated() ? 0 : 1 + layer - layers_->heated();
  }
  [[nodiscard]] const ComplexLanes* temperature_of(std::size_t block) const
  {
    return temperature_.data() + block * layers_->size();
  }
  [[nodiscard]] Scratch make_scratch() const;
  void plan_step(double duration);
  void step_block(std::size_t number, const Step& step, Scratch& scratch);
  [[gnu::noinline]] void find_temperature(std::size_t block, Scratch& scratch);
  void find_decay_over_layers(const Block& block, Lanes* left, Lanes* sum) const;
  [[nodiscard]] ComplexLanes temperature_between(double depth, std::size_t block) const;

  std::shared_ptr<const LayeredConduction> layers_;
  std::size_t blocks_in_row_;
  double diffusivity_;
  bool is_cold_ = true, was_cold_ = true;
  AlignedVector<Block> blocks_;                ///< row by row
  double planned_ = 0.0;                       ///< duration of the last step
  AlignedVector<ComplexLanes> potential_;      ///< at the surface, times k, [block] [K m]
  AlignedVector<ComplexLanes> modes_, before_; ///< [block][mode] [K]
  AlignedVector<ComplexLanes> temperature_;    ///< [block][layer] [K]
};

} // namespace brinell::halfspace
