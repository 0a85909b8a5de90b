// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/material.hpp"
#include "brinell/elastoplastic/heating.hpp"
#include "brinell/halfspace/thermal_field.hpp"
#include "plastic_heat.hpp"
#include "steady_heat.hpp"

#include <optional>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// The heat of one body, on a grid at rest on it.
class BodyHeat
{
public:
  /// @param volume  of the body when the run begins
  BodyHeat(const VolumeGrid& volume, const constitutive::Material& material, const HeatedRun& run,
           const HeatNumerics& numerics);

  [[nodiscard]] const SurfaceGrid& grid() const { return grid_; }
  [[nodiscard]] bool swells() const { return swells_; }
  [[nodiscard]] bool is_steady() const { return steady_.has_value(); }

  /// Whether its temperature takes part of its yield stress.
  [[nodiscard]] bool is_softened() const { return softening_law_.has_value(); }
  /// Whether what the heat does in the layers counts.
  [[nodiscard]] bool acts_in_layers() const { return is_stressed_ || is_softened(); }

  /// Begins a step with a flux that is expected in it, and finds stress and softening at its end, if they are wanted.
  void begin(const std::vector<double>& expected, const halfspace::HeatMotion& motion, const VolumeGrid& body);
  /// Ends it with the flux that has come in.
  void settle(std::span<const double> flux);
  /// Ends it with the plastic work that has been done [J/m^3]; a step that takes no time, too.
  void settle_work(std::span<const double> work, const VolumeGrid& body, double duration);
  [[nodiscard]] double heat_of_plastic_work() const
  {
    return plastic_ ? plastic_->total() : 0.0;
  } ///< since the start [J]
  /// Nothing has come in, and no time has passed.
  void restore();

  /// What remains of all steps before the one at hand at its end, on the grid of the heat.
  [[nodiscard]] const std::vector<double>& remaining_temperature() const { return remaining_temperature_; }
  [[nodiscard]] const std::vector<double>& remaining_displacement() const { return remaining_displacement_; }
  /// As of the last step.
  [[nodiscard]] const std::vector<double>& displacement() const { return displacement_; }
  /// On the body, at the end of the step at hand [Pa]; empty if it is not wanted.
  [[nodiscard]] const std::vector<double>& stress() const { return stress_; }
  /// Factors on the yield stress of the body's cells, likewise.
  [[nodiscard]] const std::vector<double>& softening() const { return softening_; }
  /// In all layers of a body that may have grown, as of the last step.
  void layers(const VolumeGrid& body, const Heating::Layers& out) const;
  /// Work of the displacement in the last step against a pressure on the grid of the heat [J].
  [[nodiscard]] double work_against(std::span<const double> pressure);

  void exchange(Archive& archive);

private:
  void find_layers(const VolumeGrid& body);
  void layers(const VolumeGrid& body, const Heating::Layers& out, std::vector<double>& room) const;
  void require_layers(const VolumeGrid& body) const;

  SurfaceGrid grid_;
  Thermal thermal_;
  double bulk_;               ///< temperature far from the contact [deg C]
  bool swells_, is_stressed_; ///< whether its displacement counts in the gap, its thermal stress when it yields
  std::optional<constitutive::SofteningLaw> softening_law_; ///< none: it does not count
  bool is_rigid_;
  std::optional<PlasticHeat> plastic_; ///< none: plastic work does not heat
  bool is_carried_on_ = false;         ///< whether the heat in the body is that at the end of the step at hand
  std::optional<halfspace::ThermalField> field_;   ///< of all heat since the start; or
  std::optional<SteadyHeat> steady_;               ///< of that of a step
  Hidden<halfspace::ThermalField::Heat> before_{}; ///< the step at hand
  bool is_expected_ = false;                       ///< whether the expected flux of the step at hand is taken up
  halfspace::HeatMotion motion_{};
  std::vector<double> expected_;
  std::vector<double> remaining_temperature_, remaining_displacement_, stress_, softening_, room_;
  std::vector<double> displacement_, displacement_before_, pressure_; ///< at the end of the last step
};

/// A field on a grid as it is on another one with the same middle and the same cells: zero where there was none.
void fit(const SurfaceGrid& from, std::span<const double> field, const SurfaceGrid& to, std::span<double> out);

} // namespace brinell::elastoplastic
