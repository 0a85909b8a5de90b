// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/tangential_contact.hpp"
#include "brinell/elastoplastic/partial_slip.hpp"
#include "contact/entry_compliance.hpp"
#include "slip_increment.hpp"

#include <array>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// Shear and slip of an increment, from what is imposed and from the pressure and the displacements of the bodies. Keeps operators
/// and buffers, but no history.
class StickSlip
{
public:
  using Pair = SlipIncrement::Pair;

  /// @param couples    whether shear changes the gap, and pressure displaces the surfaces along each other, where the elastic
  ///                   constants differ
  /// @param reference  see PartialSlip
  StickSlip(const SurfaceGrid& grid, const ElasticStack& lower, const ElasticStack& upper, bool couples,
            double reference);

  [[nodiscard]] const halfspace::SurfaceCompliance& pair() const { return pair_; } ///< of both bodies
  /// Whether pressure and shear are coupled.
  [[nodiscard]] bool couples() const { return couples_; }

  /// Keeps the displacements before an increment, whose pressure and shear before it are known.
  void begin(const Interface::Bodies& before, SlipIncrement& increment);
  /// Solves for shear and slip under the bound that follows the pressure.
  /// @param before  shear before the increment, in the cells of that time [Pa]
  /// @param shear   in: a guess; out: [Pa]
  /// @returns whether the solution converged
  [[nodiscard]] bool solve(const Interface::Bodies& bodies, const Pair& before, SlipIncrement& increment, Pair& shear);
  /// Computes the normal displacement that shears add to the gap.
  /// @param depth  in: that of the last shears, empty without coupling; out: [m]
  /// @returns its largest change [m]
  [[nodiscard]] double find_depth(const Pair& shear, std::vector<double>& depth);
  /// Interface::held_energy
  [[nodiscard]] double held_energy(const SlipIncrement& increment, const Pair& shear) const;

private:
  void find_displacement(const Interface::Bodies& bodies, std::span<const double> pressure, Pair& out);

  halfspace::SurfaceCompliance pair_;
  halfspace::SurfaceCompliance::Scratch scratch_;
  contact::TangentialContact tangential_;
  contact::EntryCompliance entry_; ///< of points that roll into the contact
  bool couples_;
  std::vector<double> pressure_added_;
};

/// Displacement along x and y, lower minus upper body, by shears [m].
[[nodiscard]] StickSlip::Pair displacement_by(const halfspace::SurfaceCompliance& pair, const StickSlip::Pair& shear);

} // namespace brinell::elastoplastic
