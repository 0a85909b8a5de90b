// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/material.hpp"
#include "brinell/elastoplastic/heating.hpp"
#include "brinell/halfspace/thermal_field.hpp"
#include "plastic_heat.hpp"
#include "steady_heat.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// Temperature, thermal displacement and thermal stress of one body, on a thermal grid at rest on the body.
class BodyHeat
{
public:
  /// @param volume  material grid of the body at the start of the run
  BodyHeat(const VolumeGrid& volume, const constitutive::Material& material, const HeatedRun& run,
           const HeatNumerics& numerics);

  [[nodiscard]] const SurfaceGrid& grid() const { return grid_; }
  [[nodiscard]] bool swells() const { return swells_; }
  [[nodiscard]] bool is_steady() const { return steady_.has_value(); }

  /// Whether the temperature reduces the yield stress.
  [[nodiscard]] bool is_softened() const { return softening_law_.has_value(); }
  /// Whether temperatures or stresses below the surface are needed in increments.
  [[nodiscard]] bool acts_in_layers() const { return is_stressed_ || is_softened(); }

  /// Begins a step with an expected flux [W/m^2] and computes thermal stress and softening at the end of the step, if they are
  /// needed.
  void begin(const std::vector<double>& expected, const halfspace::HeatMotion& motion, const VolumeGrid& body);
  /// Ends a step with its actual flux [W/m^2].
  void settle(std::span<const double> flux);
  /// Checks that the heat of plastic work can be kept: PlasticHeat::require_room.
  void require_room_for_work(std::span<const double> work, const VolumeGrid& body) const;
  /// Adds the plastic work of a step [J/m^3] per cell of the material grid; the duration may be 0 [s].
  void settle_work(std::span<const double> work, const VolumeGrid& body, double duration);
  [[nodiscard]] double heat_of_plastic_work() const
  {
    return plastic_ ? plastic_->total() : 0.0;
  } ///< since the start [J]
  /// Returns to the state before the current step.
  void restore();

  /// Displacement of the surface along z (positive into the body), x and y on the thermal grid [m]; x and y are empty if they are
  /// not needed.
  using Displacement = std::array<std::vector<double>, 3>;
  /// Temperature rise and displacement at the end of the current step due to earlier steps, on the thermal grid.
  [[nodiscard]] const std::vector<double>& remaining_temperature() const { return remaining_temperature_; }
  [[nodiscard]] const Displacement& remaining_displacement() const { return remaining_displacement_; }
  /// Thermal displacement at the end of the last step.
  [[nodiscard]] const Displacement& displacement() const { return state_.displacement; }
  /// Thermal stress at the end of the current step, on the material grid [Pa]; empty if it is not needed.
  [[nodiscard]] const std::vector<double>& stress() const { return stress_; }
  /// Factors on the yield stress at the end of the current step, on the material grid; empty if they are not needed.
  [[nodiscard]] const std::vector<double>& softening() const { return softening_; }
  /// Temperature and thermal stress after the last step, in all layers of a material grid that may have grown.
  void layers(const VolumeGrid& body, const Heating::Layers& out) const;
  /// Temperature and thermal stress in one layer: `Heating::layer`.
  void layer(const VolumeGrid& body, std::size_t layer, const Heating::Layers& out) const;
  /// Work of the thermal displacement of the last step against a pressure on the thermal grid [J].
  [[nodiscard]] double work_against(std::span<const double> pressure);

  void exchange(Archive& archive);

private:
  void find_layers(const VolumeGrid& body);
  void layers(const VolumeGrid& body, const Heating::Layers& out, std::vector<double>& buffer) const;
  void require_layers(const VolumeGrid& body) const;

  SurfaceGrid grid_;
  double bulk_;               ///< temperature far from the contact [deg C]
  bool swells_, is_stressed_; ///< whether thermal displacement changes the gap, and thermal stress affects yielding
  std::optional<constitutive::SofteningLaw> softening_law_; ///< none: the yield stress does not depend on temperature
  bool is_rigid_;
  std::optional<PlasticHeat> plastic_;   ///< none: plastic work does not heat
  bool is_volume_heat_advanced_ = false; ///< whether volume heat has been advanced to the end of the current step
  std::optional<halfspace::ThermalField> field_;   ///< transient regime: field of all heat since the start
  std::optional<SteadyHeat> steady_;               ///< steady regime: field of the flux of one step
  Hidden<halfspace::ThermalField::Heat> before_{}; ///< heat before the current step, for `restore`
  bool is_expected_applied_ = false;               ///< whether field_ includes the expected flux of the current step
  halfspace::HeatMotion motion_{};
  std::vector<double> expected_;
  std::vector<double> remaining_temperature_, stress_, softening_, buffer_;
  Displacement remaining_displacement_;
  /// At the end of the last step, apart from the heat itself.
  struct State
  {
    Displacement displacement;
    std::vector<double> pressure;

    static constexpr auto table()
    {
      return std::tuple{listed(&State::displacement, {"displacement", "displacement_x", "displacement_y"}),
                        listed(&State::pressure, {"pressure"})};
    }
  };
  State state_;
  std::vector<double> normal_before_; ///< normal displacement before the last step
};

/// Copies a field to another grid with the same centre and the same cells; zero outside the first grid.
void fit(const SurfaceGrid& from, std::span<const double> field, const SurfaceGrid& to, std::span<double> out);

} // namespace brinell::elastoplastic
