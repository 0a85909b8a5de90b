// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "flux_response.hpp"
#include "heated_body.hpp"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// One side of the contact: temperature and thermal displacement of a body on the contact grid, from earlier steps and from the
/// flux of the current step. In the steady regime earlier steps leave nothing: the flux of a step counts as having acted always.
class HeatedSide
{
public:
  /// @param heat  nullptr: the body does not conduct
  /// @param along_surface  HeatNumerics::along_surface
  HeatedSide(const SurfaceGrid& contact, const constitutive::Material& material, std::shared_ptr<BodyHeat> heat,
             bool is_mirrored, std::optional<double> reference, bool along_surface);

  [[nodiscard]] bool conducts() const { return heat_ != nullptr; }
  [[nodiscard]] bool is_mirrored() const { return is_mirrored_; }
  [[nodiscard]] BodyHeat& heat() const { return *heat_; } ///< requires conducts()

  /// Begins a step. A side that is not mirrored also begins the step of its body.
  /// @param body      current material grid of the body
  /// @param place     of the contact grid on the material grid, at the end of the step
  /// @param columns   by which the contact moves on the body
  /// @param duration  [s], > 0
  /// @param is_fed    whether heat arises between the surfaces in the step
  /// @param imposed   flux from outside into this side [W/m^2]; empty: none
  void begin(const VolumeGrid& body, const Place& place, double columns, double duration, bool is_fed,
             std::span<const double> imposed);
  /// Checks that the thermal grid reaches as far as a pressure on the contact grid and the flux of the trial.
  /// @throws GridError
  void require_room(std::span<const double> pressure) const;
  void settle();
  void add_heat_without_flux(double heat) { state_.total += heat; } ///< adds heat that is not applied as a flux [J]
  void restore();

  /// Surface temperature at the end of the step [deg C] due to earlier steps and to the imposed flux alone.
  [[nodiscard]] const std::vector<double>& remaining() const { return remaining_; }
  /// Of this side to a flux in the current step.
  [[nodiscard]] FluxResponse& response() { return response_; }
  /// Sets this side's share in the heat between the surfaces [W/m^2], and computes its displacement.
  /// @returns the largest change of the displacement [m]
  double set_share(std::span<const double> flux);
  [[nodiscard]] const std::vector<double>& share() const { return share_; }
  /// Total flux of the current step [W/m^2]: share and imposed flux.
  [[nodiscard]] const std::vector<double>& flux() const { return state_.flux; }
  void add_displacement(std::span<double> gap) const;
  void add_along(std::size_t axis, std::span<double> out) const; ///< Heating::add_along
  /// Heating::recall
  /// @param columns  by which the contact grid moves on the body
  void recall(const VolumeGrid& body, const Place& place, double columns);
  [[nodiscard]] const std::vector<double>& temperature() const { return state_.temperature; }
  [[nodiscard]] double total() const { return state_.total; } ///< heat since the start [J]
  void add_depth(const SurfaceGrid& body, const Place& place, std::span<double> out) const;
  [[nodiscard]] std::vector<double> on_body(std::span<const double> field, const char* what) const;

  void exchange(Archive& archive);
  void move_to(const SurfaceGrid& contact);

private:
  /// At the end of the last step; the flux is that of the current one.
  struct State
  {
    std::vector<double> temperature, flux, share, share_before;
    double duration = 0.0, total = 0.0;
    std::array<std::vector<double>, 2> along{}; ///< displacement along x and y [m]; empty: not known on this grid

    static constexpr auto table()
    {
      using S = State;
      return std::tuple{listed(&S::temperature, {"temperature"}),
                        listed(&S::flux, {"flux"}),
                        listed(&S::share, {"share"}),
                        listed(&S::share_before, {"share_before"}),
                        listed(&S::duration, {"duration"}),
                        listed(&S::total, {"total"}),
                        listed(&S::along, {"along_x", "along_y"}, {.is_sized = true, .is_derived = true})};
    }
  };
  [[nodiscard]] bool swells() const { return conducts() && heat_->swells(); }
  using Displacement = BodyHeat::Displacement;
  void set_from(const Displacement& thermal_field, Displacement& on_contact_grid) const;
  void impose(std::span<const double> flux);

  SurfaceGrid contact_;
  double bulk_; ///< temperature far from the contact [deg C]
  std::shared_ptr<BodyHeat> heat_;
  bool is_mirrored_;
  bool along_surface_; ///< whether the displacement along the surface is needed
  FluxResponse response_;
  Place place_{}; ///< of the contact grid on the thermal grid
  double duration_ = 0.0;
  std::vector<double> remaining_, share_, flux_before_;
  Displacement remaining_displacement_, own_displacement_; ///< on the contact grid; see FluxResponse::parts
  std::vector<double> imposed_; ///< flux from outside in the current step [W/m^2]; empty: none
  State state_;
};

} // namespace brinell::elastoplastic
