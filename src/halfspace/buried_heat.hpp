// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "depth_sums.hpp"
#include "layered_conduction.hpp"

#include <array>
#include <memory>
#include <optional>
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
  /// @param along  all waves
  /// @param plane  complex values from one field to the next: whole cache lines, at least as many as waves
  BuriedHeat(std::shared_ptr<const LayeredConduction> layers, std::span<const SurfaceWave> along, std::size_t plane,
             double diffusivity);

  /// A step: the heat of earlier steps spreads, and new heat is generated at a constant rate.
  /// @param rise  spectra of the temperature rise of the layers if they retained all of the new heat [K], [layer][plane]; empty
  ///              ones are zero
  void take_up(const std::vector<AlignedVector<Complex>>& rise, double duration);
  /// Restores the state before the last step.
  void go_back();
  [[nodiscard]] bool is_cold() const { return is_cold_; }

  /// Adds the temperature of the surface [K]. @param begin, count  waves
  void add_surface(std::size_t begin, std::size_t count, Complex* temperature) const;

  /// Sums over the layers for a row of waves; real and imaginary parts alternate.
  struct Row
  {
    std::size_t begin = 0, parts = 0, pitch = 0;
    AlignedVector<double> left,
        sum; ///< e^{-kh} and its integral, [kind][pitch]: for the heated layers, then the thicker ones
    AlignedVector<double> to_surface; ///< e^{-kz} from the middle of each heated layer
    AlignedVector<double> from_above; ///< by the heat above the top of each layer, integral of T e^{-k(z - z')} dz'
    AlignedVector<double> from_below; ///< likewise by the heat below it
  };
  [[nodiscard]] Row make_row(std::size_t columns) const;
  void gather(std::size_t begin, std::size_t count, Row& row) const;
  /// Adds the potential of the surface, times k [K m]. @param begin, count  waves
  void add_potential_at_surface(std::size_t begin, std::size_t count, double factor, Complex* potential) const;
  /// Temperature [K], potential times k, and its slope [K m], at one depth, of all parts of a row.
  struct Sums
  {
    double *temperature, *potential, *slope;
  };
  void add(double depth, double factor, const Row& row, const Sums& sums) const;

  /// The state: amplitudes of all modes.
  [[nodiscard]] const AlignedVector<Complex>& modes() const { return modes_; }
  void set_modes(const AlignedVector<Complex>& modes);
  [[nodiscard]] const LayeredConduction& layers() const { return *layers_; }

private:
  [[nodiscard]] const double* layer(std::size_t n, std::size_t wave) const
  {
    return reinterpret_cast<const double*>(temperature_.data() + n * plane_ + wave);
  }
  /// Quantities of a step that are the same for all waves.
  struct Step
  {
    double duration;
    std::span<const AlignedVector<Complex>> rise;
    std::size_t first, last;         ///< range of layers in which heat is generated; last = 0: in none
    std::vector<double> rates, left; ///< of the modes: kappa s^2 t, and e^{-that}
  };
  /// Values of neighbouring waves side by side, [layer or mode][lane].
  struct Scratch
  {
    AlignedVector<double> rise, in, modes, warm;
  };
  /// Decay of waves along the surface in a step: kappa k^2 t, and e^{-kappa k^2 t}.
  struct Planned
  {
    double duration;
    AlignedVector<double> rates, left; ///< [plane]
  };
  void plan_step(double duration);
  void step_waves(std::size_t wave, const Step& step, std::array<Scratch, 2>& halves);
  void find_temperature_from(std::size_t wave, Scratch& scratch);
  void find_temperature();
  void find_decay_over_layers(std::size_t begin, std::size_t parts, std::size_t pitch, double* left, double* sum) const;
  void find_potential_at_surface();
  /// Factors of all waves, each stored twice: for the real and the imaginary part.
  struct Decays
  {
    AlignedVector<double> half_left, half_sum; ///< e^{-kz} and its integral over half a heated layer
    AlignedVector<double> next_left, next_sum; ///< over the first layer of the thicker ones
    AlignedVector<double> k;                   ///< [1/m]
  };
  void add_temperature_between(double depth, double factor, const Row& row, double* temperature) const;

  std::shared_ptr<const LayeredConduction> layers_;
  std::size_t plane_;
  double diffusivity_;
  bool is_cold_ = true, was_cold_ = true;
  Decays decays_;
  std::optional<Planned> planned_;        ///< of the last step
  AlignedVector<double> potential_;       ///< at the surface, times k, real and imaginary parts [K m]
  AlignedVector<Complex> modes_, before_; ///< [mode][plane] [K]
  AlignedVector<Complex> temperature_;    ///< [layer][plane] [K]
};

} // namespace brinell::halfspace
