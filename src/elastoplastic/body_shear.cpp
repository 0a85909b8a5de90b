// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace brinell::elastoplastic
{

/// Of the same strain the displacement into the body and the stress are known by now: no layer is asked for.
void Body::find_displacement_x()
{
  if (displacement_x_.empty())
    return;
  if (work_.empty())
    work_ = half_space_->make_work();
  loaded_.reset();
  half_space_->load(state_.plastic_strain, 0, work_, halfspace::Displacements::along_x)
      .displacement({.x = displacement_x_});
}

/// In pure shear xz the yield surface around its centre is met at tau = centre_xz +- yield stress / sqrt(3).
std::vector<double> Body::shear_strength(double sign) const
{
  const std::size_t cells = grid().surface.size();
  std::vector<double> strength(cells, std::numeric_limits<double>::infinity());
  if (!is_plastic())
    return strength;
  std::visit(
      [&](const auto& law)
      {
        // A traction q along x makes the stress xz = -q at the surface, whose normal points out of the body.
        for (std::size_t cell = 0; cell < cells; ++cell)
          strength[cell] = std::max(0.0, law_of(law, 0).yield_stress_at(state_.equivalent[cell]) / std::sqrt(3.0) -
                                             sign * centre(cell)[Deviator::xz]);
      },
      *material_.hardening);
  return strength;
}

} // namespace brinell::elastoplastic
