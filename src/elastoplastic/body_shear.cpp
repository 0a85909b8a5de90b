// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace brinell::elastoplastic
{

/// What an evaluation finds of the displacement: the part on which the gap depends, and all of it where the shear depends on it.
/// Along x it is wanted of the last evaluation of an increment alone, which is one of those that compute all layers.
halfspace::Displacements Body::found_at_once() const
{
  if (!displacement_y_.empty())
    return halfspace::Displacements::all;
  return !displacement_x_.empty() && computes_all_layers() ? halfspace::Displacements::along_x
                                                           : halfspace::Displacements::normal;
}

/// Of the strain that has been loaded.
void Body::find_displacements(halfspace::Displacements wanted)
{
  using halfspace::Displacements;
  halfspace::SurfaceDisplacement found{.z = displacement_, .x = {}, .y = {}};
  if (wanted != Displacements::normal)
    found.x = displacement_x_;
  if (wanted == Displacements::all)
    found.y = displacement_y_;
  loaded_->displacement(found);
  knows_displacement_x_ = wanted != Displacements::normal;
}

/// Of the same strain the displacement into the body and the stress are known by now: no layer is asked for.
void Body::find_displacement_x()
{
  if (displacement_x_.empty() || knows_displacement_x_)
    return;
  if (work_.empty())
    work_ = half_space_->make_work();
  loaded_.reset();
  half_space_->load(state_.plastic_strain, 0, work_, halfspace::Displacements::along_x, symmetry_)
      .displacement({.x = displacement_x_});
  knows_displacement_x_ = true;
}

/// In pure shear the yield surface is a circle of the radius yield stress / sqrt(3) around its centre (xz, yz).
std::vector<double> Body::shear_strength(double along_x, double along_y) const
{
  const std::size_t cells = grid().surface.size();
  std::vector<double> strength(cells, std::numeric_limits<double>::infinity());
  if (!is_plastic())
    return strength;
  const bool is_directed = along_x != 0.0 || along_y != 0.0;
  std::visit(
      [&](const auto& law)
      {
        // A traction q makes the stresses xz, yz = -q at the surface, whose normal points out of the body.
        for (std::size_t cell = 0; cell < cells; ++cell)
        {
          const Deviator c = centre(cell);
          const double taken = is_directed ? along_x * c[Deviator::xz] + along_y * c[Deviator::yz]
                                           : std::hypot(c[Deviator::xz], c[Deviator::yz]);
          strength[cell] =
              std::max(0.0, law_at(law, cell).yield_stress_at(state_.equivalent[cell]) / std::sqrt(3.0) - taken);
        }
      },
      *material_.hardening);
  return strength;
}

} // namespace brinell::elastoplastic
