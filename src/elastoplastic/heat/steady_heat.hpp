// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/field_table.hpp"
#include "brinell/halfspace/steady_field.hpp"

#include <optional>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// Thermal displacement and stress of one body in the steady regime: the flux of the current step is taken to have acted, and
/// moved with the velocity of this step, for all time. Earlier steps have no influence.
class SteadyHeat
{
public:
  /// @param layer_thickness  of the body [m]; its layers count from the surface
  SteadyHeat(const SurfaceGrid& grid, const Thermal& thermal, const Elastic& elastic, double layer_thickness,
             std::optional<double> reference);

  /// Begins a step with the velocity of the flux [m/s] and its expected value [W/m^2].
  void begin(double velocity, std::span<const double> expected);
  /// Ends the step with the actual flux [W/m^2].
  void settle(std::span<const double> flux);
  /// Returns to the state before the step.
  void restore() { now_ = last_; }

  /// Displacement of the surface, positive into the body [m].
  void displacement(std::span<double> out) const;
  /// Temperature and stress in the layers, for the expected flux during a step and the actual one after it.
  void layers(std::span<const halfspace::ThermalLayer> out) const;
  /// Temperature and stress in one of `count` layers.
  void layer(std::size_t count, std::size_t layer, const halfspace::ThermalLayer& out) const;

  void exchange(Archive& archive);

private:
  struct Source
  {
    double velocity = 0.0;
    std::vector<double> flux{};

    static constexpr auto table()
    {
      return std::tuple{listed(&Source::velocity, {"velocity"}), listed(&Source::flux, {"flux"})};
    }
  };
  [[nodiscard]] bool is_cold() const;
  void layers(std::size_t count, std::size_t first, std::span<const halfspace::ThermalLayer> out) const;
  [[nodiscard]] const halfspace::SteadyField& field(std::size_t layers) const;

  SurfaceGrid grid_;
  Thermal thermal_;
  Elastic elastic_;
  double layer_thickness_;
  std::optional<double> reference_;
  Source now_, last_; ///< of the current step, and of the previous one
  struct Planned
  {
    double velocity;
    halfspace::SteadyField field;
  };
  mutable std::optional<Planned>
      planned_{}; ///< cache of the last field only, which needs seven spectra per layer; not part of the state
};

} // namespace brinell::elastoplastic
