// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/interface.hpp"
#include "brinell/foundation/grid.hpp"

#include <array>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace brinell::elastoplastic
{

class StickSlip;
struct SlipIncrement;

/// History of two surfaces that stick in places and slip in others, which each increment continues. Slip, its length and its heat
/// per area belong to points of the surfaces: they count since the start, or since these points came under the contact grid.
struct SlipState
{
  std::array<std::vector<double>, 2> shear; ///< along x and y [Pa]
  std::array<std::vector<double>, 2> slip;  ///< signed, along x and y [m]
  std::vector<double> path;                 ///< accumulated length of the slip [m]
  std::vector<double> heat;                 ///< of friction, per area [J/m^2]
  std::vector<double> depth;                ///< displacement that the shears add to the gap [m]; empty without coupling
  /// Displacement of distant points of the upper body relative to those of the lower one since the start, along x and y [m].
  std::array<double, 2> shift{};
  double turned = 0.0;        ///< rotation of the upper body relative to the lower one about z [rad]
  double work = 0.0;          ///< of the tangential forces, and of their moment on the spin, since the start [J]
  double total_heat = 0.0;    ///< of friction since the start, including points that have left the grid [J]
  double limited_share = 0.0; ///< Interface::limited_share
  int sticking = 0,
      pressed = 0; ///< cells under pressure that did not slip in the last increment; all cells under pressure

  static constexpr auto table()
  {
    using S = SlipState;
    return std::tuple{listed(&S::shear, {"shear_x", "shear_y"}),
                      listed(&S::slip, {"slip_x", "slip_y"}, {.is_carried = true}),
                      listed(&S::path, {"path"}, {.is_carried = true}),
                      listed(&S::heat, {"heat"}, {.is_carried = true}),
                      listed(&S::depth, {"depth"}, {.is_derived = true}),
                      listed(&S::shift, {"shift_x", "shift_y"}),
                      listed(&S::turned, {"turned"}),
                      listed(&S::work, {"work"}),
                      listed(&S::total_heat, {"total_heat"}),
                      listed(&S::limited_share, {"limited_share"}, {.range = std::pair{0.0, 1.0}}),
                      listed(&S::sticking, {"sticking"}),
                      listed(&S::pressed, {"pressed"})};
  }
};

/// The shear between two surfaces that stick in places and slip in others: docs/theory/elastoplastic.md (partial-slip).
///
/// Slip is the relative displacement of the upper surface over the lower one. The contact may roll: it moves by the same whole
/// number of columns on both bodies. Shear, slip and heat belong to points of the surfaces, so that they move through the contact
/// grid with these points.
class PartialSlip final : public Interface
{
public:
  /// @param reference  reference distance of the displacement with one periodic axis, see halfspace::SurfaceCompliance [m]
  PartialSlip(const SurfaceGrid& grid, const ElasticStack& lower, const ElasticStack& upper, const Friction& friction,
              double reference);
  ~PartialSlip() override;

  /// Up to the last increment.
  [[nodiscard]] const SlipState& state() const { return state_; }

  [[nodiscard]] std::array<double, 2> direction(const contact::TangentialDrive& along) const override;
  void begin(Start start) override;
  void set_limit(std::vector<double> limit) override;
  Change follow(const Bodies& bodies) override;
  Change renew(const Bodies& bodies) override;
  [[nodiscard]] double held_energy() const override;
  /// With unequal elastic constants the pressure displaces the surfaces tangentially: its errors become errors of the slip.
  [[nodiscard]] double tolerance_of_gap(double usual) const override;
  void add_to_gap(std::span<double> gap) const override;
  void settle(const Bodies& bodies) override;
  void restore() override { state_ = before_; }

  [[nodiscard]] contact::ConstAlongSurface shears() const override { return {state_.shear[0], state_.shear[1]}; }
  [[nodiscard]] std::array<double, 2> forces() const override;
  [[nodiscard]] double elastic_energy(std::span<const double> pressure) const override;
  [[nodiscard]] double limited_share() const override { return state_.limited_share; }

  [[nodiscard]] bool knows_slip() const override { return false; }
  [[nodiscard]] std::vector<double> slip_length(double slid) const override;
  [[nodiscard]] std::span<const double> pressure_before(std::span<const double> last) const override;
  [[nodiscard]] Onset onset(std::span<const double> pressure) const override;
  [[nodiscard]] std::vector<double> heat_of_trial(double slid) const override;
  [[nodiscard]] std::vector<double> heat_of_increment(double slid) const override;
  [[nodiscard]] std::array<std::vector<double>, 2> mean_shears() const override;

  void exchange(Archive& archive) override { exchange_members(archive, state_); }
  void embed(const Interface& smaller) override;
  void recall(const Bodies& bodies) override;

private:
  std::unique_ptr<StickSlip> stick_slip_;    ///< solves an increment
  std::unique_ptr<SlipIncrement> increment_; ///< the current or last one
  SlipState state_, before_;                 ///< now, and before the increment
};

} // namespace brinell::elastoplastic
