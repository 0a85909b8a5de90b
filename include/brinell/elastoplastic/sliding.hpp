// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/placement.hpp"
#include "brinell/foundation/archive.hpp"
#include "brinell/halfspace/traction_compliance.hpp"

#include <optional>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// Coulomb friction of surfaces that slide everywhere where they touch: docs/theory/elastoplastic.md (coulomb).
struct Friction
{
  double coefficient = 0.0; ///< shear over pressure, >= 0; 0: none
  std::optional<double>
      shear_limit{}; ///< that a surface can carry [Pa], > 0; none: the shear strength of the softer one
  /// Whether the shear moves the gap where the materials differ.
  bool coupling = true;

  bool operator==(const Friction&) const = default;
};

/// The shear between two sliding surfaces, what it displaces, and the work that it does.
///
/// The shear is that on the lower body, along x: positive where the upper body slides towards +x; on the upper body it acts the
/// other way. All fields are on the contact grid.
class SlidingInterface
{
public:
  /// @param direction  +1 where the upper body slides towards +x over the lower one, -1 the other way
  /// @param reference  of the displacement with one periodic axis, see halfspace::SurfaceCompliance [m]
  SlidingInterface(const SurfaceGrid& grid, const Elastic& lower, const Elastic& upper, const Friction& friction,
                   int direction, double reference);

  [[nodiscard]] const Friction& friction() const { return friction_; }
  [[nodiscard]] int direction() const { return direction_; }

  /// Starts an increment.
  /// @param slides  without it there is no shear
  /// @param limit   that the surfaces can carry in each cell [Pa]
  void begin(bool slides, std::vector<double> limit);
  /// By how much a quantity changed at most.
  struct Change
  {
    double shear = 0.0; ///< [Pa]
    double gap = 0.0;   ///< [m]
  };
  /// Sets the shear that belongs to a pressure, and what it adds to the gap.
  Change follow(std::span<const double> pressure);
  [[nodiscard]] std::span<const double> shear() const { return state_.shear; } ///< [Pa]
  /// Whether shear moves the gap.
  [[nodiscard]] bool moves_gap() const { return lower_weight_ != upper_weight_; }
  /// Adds what the shear adds to the gap [m].
  void add_to_gap(std::span<double> gap) const;

  /// What is known of both bodies at the end of an increment.
  struct Bodies
  {
    std::span<const double> pressure;                ///< [Pa]
    std::span<const double> lower_x, upper_x;        ///< residual displacement along x [m]
    double lower_columns = 0.0, upper_columns = 0.0; ///< by which the contact has moved on the bodies in the increment
  };
  /// Ends an increment: adds the work of its shear to `work`.
  void settle(const Bodies& bodies);
  /// Adds the elastic depth that the shear gives to each surface [m], as of the last increment.
  void add_depth(std::span<double> lower, std::span<double> upper) const;
  /// Elastic energy that the shear adds to that of the pressure, as of the last increment [J].
  [[nodiscard]] double elastic_energy(std::span<const double> pressure) const;
  /// Work that the shear has done on both bodies by their deformation since the start [J].
  [[nodiscard]] double work() const { return state_.work; }
  /// Sum of the shear on the lower body [N].
  [[nodiscard]] double force() const;
  /// Share of the cells under pressure whose shear is at its limit.
  [[nodiscard]] double limited_share() const { return state_.limited_share; }

  /// What an increment changes, and the next one depends on.
  struct State
  {
    std::vector<double> shear; ///< [Pa]
    /// Depth of the surface of a body with unit coupling weight under the shear [m].
    std::vector<double> depth;
    std::vector<double> slip; ///< displacement along x of the lower surface less that of the upper one [m]
    double lower_stretch = 0.0,
           upper_stretch = 0.0; ///< sums of the shear times the slope of the displacement along x [Pa]
    double work = 0.0;
    double limited_share = 0.0;

    void exchange(Archive& archive);
  };
  [[nodiscard]] const State& state() const { return state_; }
  [[nodiscard]] State& state() { return state_; }
  /// The increment has failed: as it was before it began.
  void restore() { state_ = before_; }
  /// Takes over the shear of the same interface on a smaller contact grid with the same middle; `find_displacements` is to
  /// follow, when the bodies have been moved, too.
  void embed(const State& state, const SurfaceGrid& from);
  /// What the shear and the pressure displace.
  void find_displacements(const Bodies& bodies);

private:
  halfspace::TractionCompliance pair_; ///< of both bodies
  halfspace::TractionCompliance unit_; ///< of a body with unit coupling weight
  Friction friction_;
  int direction_;
  /// (1 - 2 nu)/(2 mu) [1/Pa]: of pressure along x and of shear along z.
  double lower_weight_, upper_weight_;
  bool slides_ = false;
  std::vector<double> limit_;
  State state_, before_; ///< now, and before the increment
};

} // namespace brinell::elastoplastic
