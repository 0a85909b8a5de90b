// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/interface.hpp"
#include "brinell/green/elastic_stack.hpp"

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace brinell::elastoplastic
{

class ShearedSurfaces;

/// The shear along x between two surfaces that slide wherever they touch, with its displacements and its work. The shear is
/// positive where the upper body slides towards +x.
class SlidingInterface final : public Interface
{
public:
  /// @param direction  +1 where the upper body slides towards +x over the lower one, -1 the other way
  /// @param reference  reference distance of the displacement with one periodic axis, see halfspace::SurfaceCompliance [m]
  SlidingInterface(const SurfaceGrid& grid, const ElasticStack& lower, const ElasticStack& upper,
                   const Friction& friction, int direction, double reference);
  ~SlidingInterface() override;
  SlidingInterface(const SlidingInterface&) = delete;
  SlidingInterface& operator=(const SlidingInterface&) = delete;

  [[nodiscard]] std::array<double, 2> direction(const contact::TangentialDrive& along) const override;
  void begin(Start start) override;
  void set_limit(std::vector<double> limit) override { limit_ = std::move(limit); }
  Change follow(const Bodies& bodies) override;
  Change renew(const Bodies& bodies) override;
  [[nodiscard]] double held_energy() const override { return 0.0; }
  void add_to_gap(std::span<double> gap) const override;
  /// Ends an increment: adds the work of its shear to `work`.
  void settle(const Bodies& bodies) override;
  void restore() override { state_ = before_; }

  [[nodiscard]] contact::ConstAlongSurface shears() const override { return {state_.shear, {}}; }
  [[nodiscard]] std::array<double, 2> forces() const override;
  [[nodiscard]] double elastic_energy(std::span<const double> pressure) const override;
  [[nodiscard]] double limited_share() const override { return state_.limited_share; }
  /// Force along x on the lower body of the shear with which the surfaces slid at the beginning of the current or last
  /// increment [N]. It opposes the motion of this increment: at a reversal, it has changed its sign before the surfaces
  /// move; surfaces that begin to slide have the full shear of their pressure.
  [[nodiscard]] double force_at_start() const;
  /// Share of the full friction that acts now, for surfaces that are driven along `along`: 1 where they slide this way
  /// already, -1 where they slide the other way, 0 without shear.
  [[nodiscard]] double share_of(const contact::TangentialDrive& along) const;
  /// Adds the elastic normal displacement of each surface under the shear of the last increment, positive into the body [m].
  void add_depth(std::span<double> lower, std::span<double> upper) const;
  /// Work of the shear on the deformation of both bodies since the start [J].
  [[nodiscard]] double work() const { return state_.work; }

  [[nodiscard]] bool knows_slip() const override { return true; }
  [[nodiscard]] std::vector<double> slip_length(double slid) const override;
  /// Work of the shear of the trial on the sliding distance, per area [J/m^2].
  [[nodiscard]] std::vector<double> heat_of_trial(double slid) const override;
  /// Work of the shear on the sliding distance, minus its work on the deformation of the bodies in this increment and in those at
  /// rest before it, per area [J/m^2].
  [[nodiscard]] std::vector<double> heat_of_increment(double slid) const override;

  void exchange(Archive& archive) override { exchange_members(archive, state_); }
  void embed(const Interface& smaller) override;
  /// Recomputes the displacements under shear and pressure.
  void recall(const Bodies& bodies) override { find_displacements(bodies); }

private:
  /// Quantities that an increment changes and on which the next one depends.
  struct State
  {
    std::vector<double> shear; ///< [Pa]
    /// Normal displacement under the shear, positive into the body [m]: sum of both bodies, and that of the lower one.
    std::vector<double> depth, lower_depth;
    std::vector<double> slip; ///< displacement along x, lower minus upper surface [m]
    /// Shear times the slope of the displacement along x, for each body [Pa].
    std::vector<double> lower_stretch, upper_stretch;
    /// Work of the shear on the deformation in increments at rest since the surfaces moved last [J/m^2].
    std::vector<double> work_at_rest;
    double work = 0.0;
    double limited_share = 0.0;

    static constexpr auto table()
    {
      using S = State;
      return std::tuple{listed(&S::shear, {"shear"}),
                        listed(&S::depth, {"depth"}, {.is_derived = true}),
                        listed(&S::lower_depth, {"lower_depth"}, {.is_derived = true}),
                        listed(&S::slip, {"slip"}, {.is_derived = true}),
                        listed(&S::lower_stretch, {"lower_stretch"}, {.is_derived = true}),
                        listed(&S::upper_stretch, {"upper_stretch"}, {.is_derived = true}),
                        listed(&S::work_at_rest, {"work_at_rest"}),
                        listed(&S::work, {"work"}),
                        listed(&S::limited_share, {"limited_share"})};
    }
  };

  void set_shear_at_start(std::span<const double> pressure);
  Change set_shear(std::span<const double> pressure);
  void find_displacements(const Bodies& bodies);

  std::unique_ptr<const ShearedSurfaces> surfaces_;
  int direction_;
  bool slides_ = false, is_held_ = false;
  std::optional<double> share_at_rest_; ///< Motion::share_at_rest
  std::vector<double> limit_, shear_at_start_;
  State state_, before_; ///< now, and before the increment
  std::vector<double>
      work_per_area_; ///< work of the shear on the deformation for the heat of the last increment [J/m^2]
};

} // namespace brinell::elastoplastic
