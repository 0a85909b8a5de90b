// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "brinell/green/elastic.hpp"
#include "brinell/halfspace/surface_load.hpp"

#include <memory>

namespace brinell::halfspace
{

/// Pressure and shears on one surface grid -> elastic displacement of two half spaces, all three components:
/// docs/theory/half-space.md (traction-displacement). `SurfaceCompliance` is its part of pressure and z, with what a contact
/// solver needs besides.
///
/// z points into each body; the shear acts on body 1, and on body 2 the other way. The displacement along z is the sum of both,
/// along x and y that of body 1 less that of body 2. So the work of the load is that of load and displacement, and the operator
/// is symmetric and positive definite, but for loads that are uniform on a periodic surface: these displace nothing.
class TractionCompliance
{
public:
  /// @param body2      a rigid one for body 1 alone.
  /// @param reference  as that of `SurfaceCompliance`, for the displacements in all directions.
  TractionCompliance(const SurfaceGrid& grid, const Elastic& body1, const Elastic& body2, double reference = 0.0);
  ~TractionCompliance();
  TractionCompliance(TractionCompliance&&) noexcept;
  TractionCompliance& operator=(TractionCompliance&&) noexcept;
  TractionCompliance(const TractionCompliance&) = delete;
  TractionCompliance& operator=(const TractionCompliance&) = delete;

  [[nodiscard]] const SurfaceGrid& grid() const;
  /// The displacement [m]; parts of the load and of the displacement that are empty cost nothing.
  void apply(const SurfaceLoad& load, const SurfaceDisplacement& displacement) const;

private:
  struct Operator; ///< transform and spectra
  std::unique_ptr<Operator> operator_;
};

} // namespace brinell::halfspace
