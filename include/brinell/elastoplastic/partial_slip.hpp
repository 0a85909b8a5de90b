// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/interface.hpp"
#include "brinell/halfspace/surface_compliance.hpp"

#include <array>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace brinell::contact
{
class EntryCompliance;
}

namespace brinell::elastoplastic
{

/// The shear between two surfaces that stick in places and slip in others: docs/theory/elastoplastic.md (partial-slip).
///
/// Slip is the relative displacement of the upper surface over the lower one. The contact may roll: it moves by the same whole
/// number of columns on both bodies. Shear, slip and heat belong to points of the surfaces, so that they move through the contact
/// grid with these points.
class PartialSlip final : public Interface
{
public:
  /// @param reference  reference distance of the displacement with one periodic axis, see halfspace::SurfaceCompliance [m]
  PartialSlip(const SurfaceGrid& grid, const Elastic& lower, const Elastic& upper, const Friction& friction,
              double reference);
  ~PartialSlip() override;

  [[nodiscard]] std::array<double, 2> direction(const contact::TangentialDrive& along) const override;
  void begin(Start start) override;
  void set_limit(std::vector<double> limit) override { start_.limit = std::move(limit); }
  [[nodiscard]] bool follows_displacement() const override { return true; }
  Change follow(const Bodies& bodies) override;
  Change renew(const Bodies& bodies) override;
  [[nodiscard]] double held_energy() const override;
  [[nodiscard]] bool moves_gap() const override { return couples_; }
  /// With unequal elastic constants the pressure displaces the surfaces tangentially: its errors become errors of the slip.
  [[nodiscard]] double tolerance_of_gap(double usual) const override { return couples_ ? start_.tolerance : usual; }
  void add_to_gap(std::span<double> gap) const override;
  void settle(const Bodies& bodies) override;
  void restore() override { state_ = before_; }

  [[nodiscard]] contact::ConstAlongSurface shears() const override { return {state_.shear[0], state_.shear[1]}; }
  [[nodiscard]] std::array<double, 2> forces() const override;
  [[nodiscard]] double elastic_energy(std::span<const double> pressure) const override;
  [[nodiscard]] double limited_share() const override { return state_.limited_share; }

  /// Signed slip since the start, or since these points of the surfaces came under the contact grid [m].
  [[nodiscard]] contact::ConstAlongSurface slips() const { return {state_.slip[0], state_.slip[1]}; }
  [[nodiscard]] bool knows_slip() const override { return false; }
  [[nodiscard]] std::vector<double> slip_length(double slid) const override;
  [[nodiscard]] std::span<const double> pressure_before(std::span<const double> /*last*/) const override
  {
    return pressure_before_;
  }
  [[nodiscard]] std::vector<double> pressure_of_onset(std::span<const double> pressure) const override;
  [[nodiscard]] std::vector<double> shear_of_onset() const override;
  /// Accumulated slip length, over the same time as `slips` [m].
  [[nodiscard]] std::span<const double> path() const { return state_.path; }
  /// Heat of friction per area, over the same time as `slips` [J/m^2].
  [[nodiscard]] std::span<const double> heat_per_area() const { return state_.heat; }
  [[nodiscard]] std::vector<double> heat_of_trial(double slid) const override;
  [[nodiscard]] std::vector<double> heat_of_increment(double /*slid*/) const override { return heat_of_increment_; }
  [[nodiscard]] std::array<std::vector<double>, 2> mean_shears() const override;
  /// Heat of friction since the start, including points that have left the grid [J].
  [[nodiscard]] double heat() const { return state_.total_heat; }
  /// Displacement of distant points of the upper body relative to those of the lower one since the start, along x and y [m].
  [[nodiscard]] std::array<double, 2> shift() const { return state_.shift; }
  /// Work of the tangential forces, and of their moment on the spin, since the start [J].
  [[nodiscard]] double work() const { return state_.work; }
  /// Cells under pressure that did not slip in the last increment, and all cells under pressure.
  [[nodiscard]] int sticking_cells() const { return state_.sticking; }
  [[nodiscard]] int pressed_cells() const { return state_.pressed; }

  void exchange(Archive& archive) override { exchange_members(archive, state_); }
  void embed(const Interface& smaller) override;
  void recall(const Bodies& bodies) override;

private:
  using Pair = std::array<std::vector<double>, 2>;
  /// Quantities that an increment changes and on which the next one depends.
  struct State
  {
    Pair shear;                ///< [Pa]
    Pair slip;                 ///< see `slips` [m]
    std::vector<double> path;  ///< see `path` [m]
    std::vector<double> heat;  ///< see `heat_per_area` [J/m^2]
    std::vector<double> depth; ///< displacement that the shears add to the gap [m]; empty without coupling
    std::array<double, 2> shift{};
    double turned = 0.0; ///< rotation of the upper body relative to the lower one about z [rad]
    double work = 0.0;
    double total_heat = 0.0; ///< [J]
    double limited_share = 0.0;
    int sticking = 0, pressed = 0;

    static constexpr auto table()
    {
      using S = State;
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

  void advect(const Bodies& bodies);
  [[nodiscard]] double imposed(std::size_t axis, int column, int row) const;
  [[nodiscard]] double driven_motion() const;
  [[nodiscard]] double tolerance_of_slip() const;
  void add_heat(std::size_t cell, double heat);
  [[nodiscard]] Pair parting_slip() const;
  void add_parting_heat();
  void add_work(double beyond_trapezoid);
  [[nodiscard]] double moment_of(const Pair& shear) const;
  [[nodiscard]] bool slips_at(std::size_t cell) const;
  [[nodiscard]] double bound_of_onset(std::size_t cell) const;
  [[nodiscard]] double heat_at(std::size_t cell) const;
  [[nodiscard]] double bound_at(std::size_t cell, double pressure) const;
  bool set_bound(std::span<const double> pressure);
  [[nodiscard]] bool carries_drive() const;
  [[nodiscard]] bool solve(const Bodies& bodies);
  void find_displacement(const Bodies& bodies, std::span<const double> pressure, Pair& out);
  [[nodiscard]] double update_depth();
  [[nodiscard]] bool is_forced(std::size_t axis) const;

  halfspace::SurfaceCompliance pair_; ///< of both bodies
  halfspace::SurfaceCompliance::Scratch scratch_;
  contact::TangentialContact tangential_;
  std::unique_ptr<contact::EntryCompliance> entry_; ///< of points that roll into the contact
  int entries_ = 0;                                 ///< how often it has been found in the increment
  bool couples_;
  Start start_;
  contact::TangentialDrive drive_; ///< of the increment
  bool is_driven_ = false;         ///< whether the increment imposes another shift, force or rotation
  std::array<int, 2> carried_{};   ///< cells by which the surfaces move through the contact grid in the increment
  Pair shear_before_;              ///< before the increment, of the surface points that now lie in each cell [Pa]
  std::vector<double> bound_before_, bound_;
  bool has_bound_ = false; ///< whether bound_ is already that of this increment
  std::vector<double> pressure_before_, pressure_added_;
  Pair residual_before_;     ///< residual displacement, lower minus upper body, before the increment [m]
  Pair displacement_before_; ///< total (elastic and residual) displacement, lower minus upper, before the increment [m]
  Pair change_;              ///< change in this increment of the displacement that is not due to the shears [m]
  Pair slip_;                ///< slip in this increment [m]
  std::vector<double> heat_of_increment_; ///< see `heat_of_increment`
  std::array<double, 2> shift_{};
  State state_, before_; ///< now, and before the increment
};

} // namespace brinell::elastoplastic
