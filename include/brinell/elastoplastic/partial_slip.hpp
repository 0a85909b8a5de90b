// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/interface.hpp"
#include "brinell/halfspace/traction_compliance.hpp"

#include <array>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// The shear between two surfaces that stick in places and slip in others: docs/theory/elastoplastic.md (partial-slip).
///
/// Slip is that of the upper surface over the lower one. The contact may roll: it moves by the same whole columns on both bodies,
/// and shear, slip and heat are those of the points of the surfaces that are under it, which carry them along.
class PartialSlip final : public Interface
{
public:
  /// @param reference  of the displacement with one periodic axis, see halfspace::SurfaceCompliance [m]
  PartialSlip(const SurfaceGrid& grid, const Elastic& lower, const Elastic& upper, const Friction& friction,
              double reference);

  [[nodiscard]] std::array<double, 2> direction(const contact::TangentialDrive& along) const override;
  void begin(Start start) override;
  [[nodiscard]] bool follows_displacement() const override { return true; }
  Change follow(const Bodies& bodies) override;
  Change renew(const Bodies& bodies) override;
  [[nodiscard]] double held_energy() const override;
  [[nodiscard]] bool moves_gap() const override { return couples_; }
  /// The pressure pulls along the surfaces, so that errors of it are errors of the slip.
  [[nodiscard]] double tolerance_of_gap(double usual) const override { return couples_ ? start_.tolerance : usual; }
  void add_to_gap(std::span<double> gap) const override;
  void settle(const Bodies& bodies) override;
  void restore() override { state_ = before_; }

  [[nodiscard]] contact::ConstAlongSurface shears() const override { return {state_.shear[0], state_.shear[1]}; }
  [[nodiscard]] std::array<double, 2> forces() const override;
  [[nodiscard]] double elastic_energy(std::span<const double> pressure) const override;
  [[nodiscard]] double limited_share() const override { return state_.limited_share; }

  /// Slip since the start, or since these points of the surfaces came under the contact grid, with its sign [m].
  [[nodiscard]] contact::ConstAlongSurface slips() const { return {state_.slip[0], state_.slip[1]}; }
  /// Length of the way slipped in the increment at hand, where the surfaces slip on each other under pressure [m].
  [[nodiscard]] std::vector<double> slipped() const;
  /// Length of the way slipped since then [m].
  [[nodiscard]] std::span<const double> path() const { return state_.path; }
  /// Heat of friction per area since then [J/m^2].
  [[nodiscard]] std::span<const double> heat_per_area() const { return state_.heat; }
  /// Heat of friction since the start, with that of points which have left the grid [J].
  [[nodiscard]] double heat() const { return state_.total_heat; }
  /// By which distant points of the upper body have been moved past those of the lower one since the start [m].
  [[nodiscard]] std::array<double, 2> shift() const { return state_.shift; }
  /// Work of the forces along the surface, and of their moment on the spin, since the start [J].
  [[nodiscard]] double work() const { return state_.work; }
  /// Cells under pressure that did not slip in the last increment, and all cells under pressure.
  [[nodiscard]] int sticking_cells() const { return state_.sticking; }
  [[nodiscard]] int pressed_cells() const { return state_.pressed; }

  void exchange(Archive& archive) override { state_.exchange(archive); }
  void embed(const Interface& smaller) override;
  void recall(const Bodies& bodies) override;

private:
  using Pair = std::array<std::vector<double>, 2>;
  /// What an increment changes, and the next one depends on.
  struct State
  {
    Pair shear;                ///< [Pa]
    Pair slip;                 ///< see `slips` [m]
    std::vector<double> path;  ///< length of the way slipped since then [m]
    std::vector<double> heat;  ///< since then [J/m^2]
    std::vector<double> depth; ///< what the shears add to the gap [m]; empty if they do not
    std::array<double, 2> shift{};
    double turned = 0.0; ///< of the upper body past the lower one about z [rad]
    double work = 0.0;
    double total_heat = 0.0; ///< [J]
    double limited_share = 0.0;
    int sticking = 0, pressed = 0;

    void exchange(Archive& archive);
  };

  void carry_along(const Bodies& bodies);
  [[nodiscard]] double imposed(std::size_t axis, int column, int row) const;
  [[nodiscard]] double motion() const;
  [[nodiscard]] double tolerance_of_slip() const;
  void add_parting_heat();
  [[nodiscard]] double moment_of(const Pair& shear) const;
  [[nodiscard]] bool slips_at(std::size_t cell) const;
  [[nodiscard]] double bound_at(std::size_t cell, double pressure) const;
  void set_bound(std::span<const double> pressure);
  [[nodiscard]] bool carries_drive() const;
  [[nodiscard]] bool solve(const Bodies& bodies);
  void find_displacement(const Bodies& bodies, std::span<const double> pressure, Pair& out);
  [[nodiscard]] double lower_gap();
  [[nodiscard]] bool is_forced(std::size_t axis) const;

  halfspace::TractionCompliance pair_; ///< of both bodies
  halfspace::TractionCompliance::Scratch scratch_;
  contact::TangentialContact tangential_;
  bool couples_;
  Start start_;
  contact::TangentialDrive drive_; ///< of the increment
  std::array<int, 2> carried_{};   ///< by which the surfaces move through the contact grid in it, in cells
  Pair shear_before_;              ///< of the points that are in a cell now [Pa]
  std::vector<double> bound_before_, bound_;
  bool has_bound_ = false; ///< in this increment
  std::vector<double> pressure_before_, pressure_added_;
  Pair residual_before_;     ///< of the lower body less that of the upper one [m]
  Pair displacement_before_; ///< likewise of all, elastic and residual [m]
  Pair change_;              ///< in this increment, of all but the shears [m]
  Pair slip_;                ///< of this increment [m]
  std::array<double, 2> shift_{};
  State state_, before_; ///< now, and before the increment
};

} // namespace brinell::elastoplastic
