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

/// Heat that has arisen in the layers of a body, of one periodic surface: for each wave along it, how warm the layers are. Exact in
/// time for heat that arises evenly over a step, and of second order in the thickness of the layers: docs/theory/heat.md (buried).
class BuriedHeat
{
public:
  /// @param along  all waves
  /// @param plane  values of one field: whole cache lines, not fewer than waves
  BuriedHeat(std::shared_ptr<const LayeredConduction> layers, std::span<const SurfaceWave> along, std::size_t plane,
             double diffusivity);

  /// A step: what is there spreads, and heat arises evenly over it.
  /// @param rise  spectra of what it would warm layers by that nothing leaves [K], [layer][plane]; empty ones are zero
  void take_up(const std::vector<AlignedVector<Complex>>& rise, double duration);
  /// As before the last step.
  void go_back();
  [[nodiscard]] bool is_cold() const { return is_cold_; }

  /// Adds the temperature of the surface [K]. @param begin, count  waves
  void add_surface(std::size_t begin, std::size_t count, Complex* temperature) const;

  /// What a row of waves makes of the layers: real and imaginary parts in turn.
  struct Row
  {
    std::size_t begin = 0, parts = 0, pitch = 0;
    AlignedVector<double> left, sum;  ///< e^{-kh} and its integral, [kind][pitch]: heated, and the next thicker ones
    AlignedVector<double> to_surface; ///< e^{-kz} from the middle of each heated layer
    AlignedVector<double> from_above; ///< of the heat above the top of each layer, integral of T e^{-k(z - z')} dz'
    AlignedVector<double> from_below; ///< likewise below it
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

  /// What it remembers.
  [[nodiscard]] const AlignedVector<Complex>& modes() const { return modes_; }
  void set_modes(const AlignedVector<Complex>& modes);
  [[nodiscard]] const LayeredConduction& layers() const { return *layers_; }

private:
  [[nodiscard]] const double* layer(std::size_t n, std::size_t wave) const
  {
    return reinterpret_cast<const double*>(temperature_.data() + n * plane_ + wave);
  }
  /// What all waves have in common in a step.
  struct Step
  {
    double duration;
    std::span<const AlignedVector<Complex>> rise;
    std::size_t first, last;         ///< layers between which heat arises; last = 0: in none
    std::vector<double> rates, left; ///< of the modes: kappa s^2 t, and e^{-that}
  };
  /// Of some waves side by side, [layer or mode][lane].
  struct Scratch
  {
    AlignedVector<double> rise, in, modes, warm;
  };
  /// What a step does to waves along the surface: kappa k^2 t, and e^{-that}.
  struct Planned
  {
    double duration;
    AlignedVector<double> rates, left; ///< [plane]
  };
  void plan_step(double duration);
  void take_up_from(std::size_t wave, const Step& step, std::array<Scratch, 2>& halves);
  void find_temperature_from(std::size_t wave, Scratch& scratch);
  void find_temperature();
  void find_decay_over_layers(std::size_t begin, std::size_t parts, std::size_t pitch, double* left, double* sum) const;
  void find_potential_at_surface();
  /// Of all waves, each twice: for real and imaginary parts.
  struct Decays
  {
    AlignedVector<double> half_left, half_sum; ///< e^{-kz} and its integral over half a heated layer
    AlignedVector<double> next_left, next_sum; ///< over the next thicker one
    AlignedVector<double> k;                   ///< [1/m]
  };
  void add_temperature_between(double depth, double factor, const Row& row, double* temperature) const;

  std::shared_ptr<const LayeredConduction> layers_;
  std::size_t plane_;
  double diffusivity_;
  bool is_cold_ = true, was_cold_ = true;
  Decays decays_;
  std::optional<Planned> planned_;        ///< of the last step
  AlignedVector<double> potential_;       ///< of the surface, times k, in parts [K m]
  AlignedVector<Complex> modes_, before_; ///< [mode][plane] [K]
  AlignedVector<Complex> temperature_;    ///< [layer][plane] [K]
};

} // namespace brinell::halfspace
