// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/placement.hpp"
#include "brinell/foundation/archive.hpp"

#include <array>
#include <span>
#include <vector>

/// What two surfaces lose where they slip on each other: docs/theory/elastoplastic.md (wear).
namespace brinell::elastoplastic
{

/// How much each surface loses.
struct WearLaw
{
  enum class Kind
  {
    archard, ///< worn depth = coefficient x pressure x length slipped
    energy   ///< worn depth = coefficient x shear x length slipped, the friction work per area
  };
  double lower = 0.0, upper = 0.0; ///< coefficients [1/Pa], >= 0
  Kind kind = Kind::archard;

  [[nodiscard]] double sum() const { return lower + upper; }
  [[nodiscard]] bool wears() const { return sum() > 0.0; }
  bool operator==(const WearLaw&) const = default;
};

/// What both surfaces have lost, as depth on their own material grids, and what they lose in an increment.
///
/// The depth of an increment follows from the pressure at its end (backward Euler), with which it is found: to the contact it
/// is a layer that gives way in proportion to the local pressure. However much is worn in an increment, nothing oscillates.
class Wear
{
public:
  Wear(const SurfaceGrid& contact, const SurfaceGrid& lower, const SurfaceGrid& upper, const WearLaw& law);

  /// What the surfaces do in the trial of an increment; one value per cell of the contact.
  struct Slip
  {
    std::span<const double> pressure; ///< [Pa]
    std::span<const double> length;   ///< slipped in the increment [m]
    std::span<const double> shear;    ///< its size [Pa]; for WearLaw::Kind::energy
  };

  /// Begins an increment. @param pressure  before it [Pa]
  void begin(std::span<const double> pressure);
  /// Sets what is worn per pressure. @returns the largest change of the worn depth of both [m]
  double follow(const Slip& slip);
  /// Depth that both surfaces lose in the increment per pressure at its end [m/Pa], on the contact grid.
  [[nodiscard]] std::span<const double> compliance() const { return compliance_; }
  /// What the energy of the increment's convex problem has of the wear, its slip being held [J].
  [[nodiscard]] double held_energy(std::span<const double> pressure) const;
  /// Ends an increment: puts on record what it has worn.
  void settle(std::span<const double> pressure, const Placement& placement);

  /// Since the start, of the lower (0) or upper (1) surface.
  [[nodiscard]] std::span<const double> depth(std::size_t side) const { return sides_.at(side).depth; } ///< [m]
  [[nodiscard]] double largest_depth(std::size_t side) const;                                           ///< [m]
  /// By pressure or shear and slip of each increment [m^3]: the sum of the depth over the cells, but for rounding.
  [[nodiscard]] double volume(std::size_t side) const { return sides_.at(side).volume; }
  /// Largest depth that both surfaces have lost together in one increment [m].
  [[nodiscard]] double largest_step() const { return largest_step_; }
  /// Work of the pressure on what was worn [J].
  [[nodiscard]] double work() const { return work_; }
  /// Adds the worn depth of a surface to the cells of the contact grid above it [m].
  void add_depth(std::size_t side, const Place& place, std::span<double> out) const;

  void exchange(Archive& archive);
  /// Takes over the history of smaller grids with the same middles.
  void embed(const Wear& smaller);

private:
  struct Side
  {
    SurfaceGrid grid;
    double share;              ///< of this surface in what both lose
    std::vector<double> depth; ///< [m]
    double volume = 0.0;       ///< [m^3]
  };

  SurfaceGrid contact_;
  WearLaw law_;
  std::array<Side, 2> sides_;
  double work_ = 0.0, largest_step_ = 0.0;
  std::vector<double> compliance_, pressure_before_; ///< of the increment at hand
};

} // namespace brinell::elastoplastic
