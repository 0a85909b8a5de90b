// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/archive.hpp"
#include "brinell/halfspace/steady_field.hpp"

#include <optional>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// What the flux into one body does to it in the steady regime: it has always been there, and moved as it does in the step at hand. Nothing
/// is remembered of the steps before.
class SteadyHeat
{
public:
  /// @param layer_thickness  of the body [m]; its layers count from the surface
  SteadyHeat(const SurfaceGrid& grid, const Thermal& thermal, const Elastic& elastic, double layer_thickness,
             std::optional<double> reference);

  /// Begins a step in which the flux moves so [m/s], with what is expected of it.
  void begin(double velocity, std::span<const double> expected);
  /// Ends it with the flux that there is.
  void settle(std::span<const double> flux);
  /// As before the step.
  void restore() { now_ = last_; }

  /// Into the body [m].
  void displacement(std::span<double> out) const;
  /// Of the flux that is expected, or the last one.
  void layers(std::span<const halfspace::ThermalLayer> out) const;

  void exchange(Archive& archive);

private:
  struct Source
  {
    double velocity = 0.0;
    std::vector<double> flux;
  };
  [[nodiscard]] bool is_cold() const;
  [[nodiscard]] const halfspace::SteadyField& field(std::size_t layers) const;

  SurfaceGrid grid_;
  Thermal thermal_;
  Elastic elastic_;
  double layer_thickness_;
  std::optional<double> reference_;
  Source now_, last_; ///< of the step at hand, and of the one before
  struct Planned
  {
    double velocity;
    halfspace::SteadyField field;
  };
  mutable std::optional<Planned>
      planned_{}; ///< the last one alone, as it has seven spectra a layer; a plan is no state
};

} // namespace brinell::elastoplastic
