// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/elastic_contact.hpp"
#include "brinell/elastoplastic/body.hpp"
#include "brinell/elastoplastic/settings.hpp"

#include <span>
#include <vector>

/// One increment of two elastic-plastic bodies in contact: pressure, plastic strain and residual displacement that agree.
namespace brinell::elastoplastic
{

/// How an increment ended.
struct IncrementReport
{
  bool converged = false;
  bool contact_converged = false;
  int evaluations = 0; ///< of the elastic-plastic operator of both bodies
  int contact_iterations = 0;
  double yield_error = 0.0;        ///< relative to the yield stress
  double displacement_error = 0.0; ///< last change of residual displacement [m]
  double gap_error = 0.0;          ///< contact complementarity [m]
  double energy = 0.0;             ///< locked-in, elastic and dissipated energy: what backward Euler minimises [J]
  bool energy_rose = false;        ///< stopped by Strategy::watch_energy
};

/// Where the cells of the contact grid lie on the material grids: contact column i is column i + offset.
struct Placement
{
  int lower = 0;
  int upper = 0;
};

/// Reference lengths of the tolerances [m].
struct Scales
{
  double displacement = 0.0; ///< alpha_c: for the change of residual displacement
  double gap = 0.0;          ///< interference: for complementarity
};

/// How one increment is solved.
struct Strategy
{
  Integration integration = Integration::path;
  int max_evaluations = 60;
  int anderson_depth = 6;
  /// c / (2 mu) in q = s + c d_eps, see Body::begin.
  double stiffness_share = 0.6;
  /// Give up as soon as the energy of the increment's convex problem rises (backward Euler, plain fixed point): the
  /// caller then retries with a larger stiffness share, that is with shorter steps.
  bool watch_energy = false;
};

/// The coupled solver, with its buffers.
class CoupledContact
{
public:
  /// @param mirrored  the upper body is and stays the mirror image in x of the lower one (same grid, material, shape and
  ///                  history): only the lower one is solved.
  CoupledContact(const SurfaceGrid& contact, const VolumeGrid& lower, const VolumeGrid& upper,
                 const constitutive::Material& lower_material, const constitutive::Material& upper_material,
                 const Scales& scales, const Settings& settings, bool mirrored = false);

  [[nodiscard]] const Body& lower() const { return lower_; }
  [[nodiscard]] const Body& upper() const { return upper_; }
  [[nodiscard]] std::span<const double> pressure() const { return pressure_; } ///< on the contact grid [Pa]
  [[nodiscard]] std::span<const double> gap() const { return gap_; }           ///< on the contact grid [m]
  [[nodiscard]] double elastic_energy() const;                                 ///< recoverable, 1/2 p A p [J]
  [[nodiscard]] const SurfaceGrid& grid() const { return compliance_.grid(); }

  /// Solves one increment from the present state; commits it only if it converged.
  /// @param rigid_gap  distance of the undeformed, unindented surfaces on the contact grid [m].
  /// @param placement  of the contact grid on the material grids.
  [[nodiscard]] IncrementReport advance(std::span<const double> rigid_gap, const Placement& placement,
                                        const Strategy& strategy);

  /// Residual displacement of a body under the contact grid [m]; zero outside its material grid.
  void gather(const Body& body, int offset, std::span<const double> field, std::span<double> out) const;

private:
  void load(std::span<const double> rigid_gap, const Placement& placement, IncrementReport& report);
  [[nodiscard]] double energy() const;
  void spread_pressure(const Body& body, int offset, std::vector<double>& out) const;

  halfspace::SurfaceCompliance compliance_;
  contact::ElasticContact contact_;
  Body lower_, upper_;
  Scales scales_;
  Settings settings_;
  bool mirrored_;
  Placement placement_;
  std::vector<double> pressure_, gap_, total_gap_, gathered_;
  std::vector<double> lower_pressure_, upper_pressure_; ///< the pressure on the material grids
};

} // namespace brinell::elastoplastic
