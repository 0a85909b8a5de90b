// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/halfspace/thermal_response.hpp"
#include "heated_body.hpp"

#include <list>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// One side of the contact: the heat of a body as it is seen from the contact grid, and what a flux adds to it in a step. In the steady
/// regime nothing remains of the steps before: all flux of a step has always been there.
class HeatedSide
{
public:
  /// @param heat  nullptr: the body does not conduct
  HeatedSide(const SurfaceGrid& contact, const constitutive::Material& material, std::shared_ptr<BodyHeat> heat,
             bool is_mirrored, std::optional<double> reference);

  [[nodiscard]] bool conducts() const { return heat_ != nullptr; }
  [[nodiscard]] bool is_mirrored() const { return is_mirrored_; }
  [[nodiscard]] BodyHeat& heat() const { return *heat_; } ///< of a side that conducts

  /// Begins a step. Of a side that is not mirrored, the body begins it, too.
  /// @param duration  [s], > 0
  /// @param slides    whether there is friction in it
  void begin(const VolumeGrid& body, const Place& place, double columns, double duration, bool slides);
  void settle();
  void count_apart(double heat) { total_ += heat; } ///< [J], that does not come in as a flux
  void restore();

  /// Temperature at the end of the step [deg C] without the flux of the step.
  [[nodiscard]] const std::vector<double>& remaining() const { return remaining_; }
  /// Of the step at hand: how the flux moves, and what it does to the temperature.
  [[nodiscard]] const halfspace::HeatMotion& motion() const { return motion_; }
  [[nodiscard]] const halfspace::HeatResponse& temperature_response() { return responses().temperature; }
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
  [[nodiscard]] Responses& responses();
  [[nodiscard]] bool swells() const { return conducts() && heat_->swells(); }
  [[nodiscard]] std::vector<double> seen(const std::vector<double>& of_heat, const Place& place) const;
  [[nodiscard]] std::vector<double> expected_flux(double duration) const;

  SurfaceGrid contact_;
  constitutive::Material material_;
  std::shared_ptr<BodyHeat> heat_;
  bool is_mirrored_;
  std::optional<double> reference_; ///< of the displacement by a steady flux at rest [m]
  halfspace::HeatMotion motion_{};  ///< of the step at hand
  std::list<Responses> planned_;    ///< the one of the last use is the first
  Place place_{};                   ///< on the grid of the heat
  double duration_ = 0.0;
  std::vector<double> remaining_, remaining_displacement_, own_displacement_, flux_;
  // At the end of the last step
  std::vector<double> temperature_, last_flux_, flux_before_;
  double last_duration_ = 0.0, total_ = 0.0;
};

} // namespace brinell::elastoplastic
