// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/halfspace/surface_compliance.hpp"

#include <span>

/// Frictionless, non-adhesive contact of two surfaces: pressure and gap from the shape between them.
namespace brinell::contact
{

/// How a contact solution ended.
struct Report
{
  bool converged = false;
  int iterations = 0;
  double gap_error = 0.0;   ///< largest |gap| where pressure acts [m]
  double penetration = 0.0; ///< largest negative gap where none acts [m]
};

/// Displacement-driven contact by the constrained conjugate gradient method (Polonsky, Keer 1999; the approach is given,
/// so there is no load to correct).
///
/// Finds p >= 0, gap = rigid_gap + A p >= 0, p * gap = 0 with A the surface compliance.
class ElasticContact
{
public:
  explicit ElasticContact(const halfspace::SurfaceCompliance& compliance);

  /// @param rigid_gap  distance of the undeformed surfaces [m], negative where they would overlap.
  /// @param tolerance  largest |gap| under pressure and largest penetration elsewhere [m].
  /// @param pressure   in: a guess (zeros are one); out: the pressure [Pa].
  /// @param gap        out: [m].
  [[nodiscard]] Report solve(std::span<const double> rigid_gap, double tolerance, int max_iterations,
                             std::span<double> pressure, std::span<double> gap);

private:
  const halfspace::SurfaceCompliance& compliance_;
  halfspace::SurfaceCompliance::Scratch scratch_;
  std::vector<double> direction_, image_;
};

} // namespace brinell::contact
