// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/interface.hpp"
#include "brinell/halfspace/traction_compliance.hpp"

#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// The shear between two surfaces that slide everywhere where they touch, along x: positive where the upper body slides towards
/// +x. What it displaces, and the work that it does.
class SlidingInterface final : public Interface
{
public:
  /// @param direction  +1 where the upper body slides towards +x over the lower one, -1 the other way
  /// @param reference  of the displacement with one periodic axis, see halfspace::SurfaceCompliance [m]
  SlidingInterface(const SurfaceGrid& grid, const Elastic& lower, const Elastic& upper, const Friction& friction,
                   int direction, double reference);

  [[nodiscard]] std::array<double, 2> direction(const contact::TangentialDrive& along) const override;
  void begin(Start start) override;
  [[nodiscard]] bool follows_displacement() const override { return false; }
  Change follow(const Bodies& bodies) override;
  Change renew(const Bodies& bodies) override;
  [[nodiscard]] double held_energy() const override { return 0.0; }
  [[nodiscard]] bool moves_gap() const override { return lower_weight_ != upper_weight_; }
  void add_to_gap(std::span<double> gap) const override;
  /// Ends an increment: adds the work of its shear to `work`.
  void settle(const Bodies& bodies) override;
  void restore() override { state_ = before_; }

  [[nodiscard]] contact::ConstAlongSurface shears() const override { return {state_.shear, {}}; }
  [[nodiscard]] std::array<double, 2> forces() const override { return {force(), 0.0}; }
  [[nodiscard]] double elastic_energy(std::span<const double> pressure) const override;
  [[nodiscard]] double limited_share() const override { return state_.limited_share; }
  [[nodiscard]] std::span<const double> shear() const { return state_.shear; } ///< along x [Pa]
  /// Sum of the shear on the lower body [N].
  [[nodiscard]] double force() const;
  /// Adds the elastic depth that the shear gives to each surface [m], as of the last increment.
  void add_depth(std::span<double> lower, std::span<double> upper) const;
  /// Work that the shear has done on both bodies by their deformation since the start [J].
  [[nodiscard]] double work() const { return state_.work; }

  /// Heat of friction in the last increment [J/m^2]: work of the shear, less what it has done by the deformation of the bodies.
  /// @param slid  by which the undeformed surfaces have slid in it [m]
  [[nodiscard]] std::vector<double> heat_per_area(double slid) const;

  void exchange(Archive& archive) override { state_.exchange(archive); }
  void embed(const Interface& smaller) override;
  /// What the shear and the pressure displace.
  void recall(const Bodies& bodies) override { find_displacements(bodies); }

private:
  /// What an increment changes, and the next one depends on.
  struct State
  {
    std::vector<double> shear; ///< [Pa]
    /// Depth of the surface of a body with unit coupling weight under the shear [m].
    std::vector<double> depth;
    std::vector<double> slip; ///< displacement along x of the lower surface less that of the upper one [m]
    /// The shear times the slope of the displacement along x, of each body [Pa].
    std::vector<double> lower_stretch, upper_stretch;
    double work = 0.0;
    double limited_share = 0.0;

    void exchange(Archive& archive);
  };

  Change set_shear(std::span<const double> pressure);
  void find_displacements(const Bodies& bodies);

  halfspace::TractionCompliance pair_; ///< of both bodies
  halfspace::TractionCompliance unit_; ///< of a body with unit coupling weight
  int direction_;
  /// (1 - 2 nu)/(2 mu) [1/Pa]: of pressure along x and of shear along z.
  double lower_weight_, upper_weight_;
  bool slides_ = false, is_held_ = false;
  std::vector<double> limit_;
  State state_, before_;              ///< now, and before the increment
  std::vector<double> work_per_area_; ///< of the shear on the deformation in the last increment [J/m^2]
};

} // namespace brinell::elastoplastic
