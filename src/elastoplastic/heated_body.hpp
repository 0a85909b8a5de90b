// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/material.hpp"
#include "brinell/elastoplastic/heating.hpp"
#include "brinell/halfspace/thermal_field.hpp"
#include "brinell/halfspace/thermal_response.hpp"

#include <list>
#include <memory>
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

  /// Whether its temperature takes part of its yield stress.
  [[nodiscard]] bool is_softened() const { return softening_law_.has_value(); }
  /// Whether what the heat does in the layers counts.
  [[nodiscard]] bool acts_in_layers() const { return is_stressed_ || is_softened(); }

  /// Begins a step with a flux that is expected in it, and finds stress and softening at its end, if they are wanted.
  void begin(std::span<const double> expected, const halfspace::HeatMotion& motion, const VolumeGrid& body);
  /// Ends it with the flux that has come in.
  void settle(std::span<const double> flux);
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
  halfspace::ThermalField field_;
  Hidden<halfspace::ThermalField::Heat> before_{}; ///< the step at hand
  bool is_expected_ = false;                       ///< whether the expected flux of the step at hand is taken up
  halfspace::HeatMotion motion_{};
  std::vector<double> expected_;
  std::vector<double> remaining_temperature_, remaining_displacement_, stress_, softening_, room_;
  std::vector<double> displacement_, displacement_before_, pressure_; ///< at the end of the last step
};

/// One side of the contact: the heat of a body as it is seen from the contact grid, and what a flux adds to it in a step.
class HeatedSide
{
public:
  /// @param heat  nullptr: the body does not conduct
  HeatedSide(const SurfaceGrid& contact, const constitutive::Material& material, std::shared_ptr<BodyHeat> heat,
             bool is_mirrored);

  [[nodiscard]] bool conducts() const { return heat_ != nullptr; }
  [[nodiscard]] bool is_mirrored() const { return is_mirrored_; }
  [[nodiscard]] BodyHeat& heat() const { return *heat_; }

  /// Begins a step. Of a side that is not mirrored, the body begins it, too.
  /// @param duration  [s], > 0
  void begin(const VolumeGrid& body, const Place& place, double columns, double duration);
  void settle();
  void restore();

  /// Temperature at the end of the step [deg C] without the flux of the step.
  [[nodiscard]] const std::vector<double>& remaining() const { return remaining_; }
  /// Of the step at hand: how the flux moves, and what it does to the temperature.
  [[nodiscard]] const halfspace::HeatMotion& motion() const { return planned_.front().motion; }
  [[nodiscard]] const halfspace::HeatResponse& temperature_response() const { return planned_.front().temperature; }
  /// What the flux of a step adds to the temperature.
  void warm(std::span<const double> flux, std::span<double> rise);
  /// The flux of the step at hand, and what it displaces. @returns the largest change of displacement
  double set_flux(std::span<const double> flux);
  [[nodiscard]] const std::vector<double>& flux() const { return flux_; }
  void add_displacement(std::span<double> gap) const;
  [[nodiscard]] const std::vector<double>& temperature() const { return temperature_; }
  [[nodiscard]] double total() const { return total_; } ///< heat since the start [J]
  void add_depth(const SurfaceGrid& body, const Place& place, std::span<double> out) const;
  [[nodiscard]] std::vector<double> on_body(std::span<const double> field, const char* what) const;

  void exchange(Archive& archive);
  void move_to(const SurfaceGrid& contact);

private:
  /// Of one motion.
  struct Responses
  {
    halfspace::HeatMotion motion;
    halfspace::HeatResponse temperature;
    std::optional<halfspace::ThermalResponse> displacement;
    halfspace::HeatResponse::Scratch temperature_scratch;
    halfspace::ThermalResponse::Scratch displacement_scratch;
  };
  [[nodiscard]] Responses& responses() { return planned_.front(); }
  void plan(const halfspace::HeatMotion& motion);
  [[nodiscard]] std::vector<double> seen(const std::vector<double>& of_heat, const Place& place) const;
  [[nodiscard]] std::vector<double> expected_flux(double duration) const;

  SurfaceGrid contact_;
  constitutive::Material material_;
  std::shared_ptr<BodyHeat> heat_;
  bool is_mirrored_;
  std::list<Responses> planned_; ///< the one of the step at hand is the first
  Place place_{};                ///< on the grid of the heat
  double duration_ = 0.0;
  std::vector<double> remaining_, remaining_displacement_, own_displacement_, flux_;
  // At the end of the last step
  std::vector<double> temperature_, last_flux_, flux_before_;
  double last_duration_ = 0.0, total_ = 0.0;
};

} // namespace brinell::elastoplastic
