// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/halfspace/surface_compliance.hpp"

#include <span>
#include <vector>

namespace brinell::contact
{

/// A punch that is bonded to the surface of two half spaces: the pressure, or tension, under a given displacement of its face.
///
/// The same equation gives the flux of heat or current through a contact of which the potential is known
/// (docs/theory/electrical.md, spreading).
class Punch
{
public:
  /// @param compliance  must outlive this object.
  explicit Punch(const halfspace::SurfaceCompliance& compliance);

  struct Report
  {
    bool converged = false;
    int iterations = 0;
  };

  /// Solves (A + layer) p = face on the area, with p = 0 elsewhere, by conjugate gradients with a preconditioner; A is the surface
  /// compliance. On a mirrored grid half of the cells are solved.
  /// @param area      one value per cell; the punch covers those above zero
  /// @param face      displacement of the face [m]; only that on the area matters
  /// @param pressure  in: an initial guess, which may be zero; out: the pressure [Pa]
  /// @param layer     local compliance of a layer under the punch [m/Pa], >= 0, one per cell; empty: no layer
  /// @throws InternalError if a field does not have one value per cell
  Report press(std::span<const double> area, std::span<const double> face, std::span<double> pressure,
               std::span<const double> layer = {});

private:
  void displace(std::span<const double> pressure, std::span<const double> layer, std::span<double> out);
  /// Pressure that would approximately cause a displacement.
  void precondition(std::span<const double> area, std::span<const double> layer, bool is_layer_stiffer);

  const halfspace::SurfaceCompliance& compliance_;
  halfspace::SurfaceCompliance::Scratch scratch_;
  /// Displacement that is left; pressure that would cause it; search direction and its displacement.
  std::vector<double> rest_, correction_, direction_, image_;
};

} // namespace brinell::contact
