// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/body.hpp"
#include "with_copies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace brinell::elastoplastic
{

/// Components of the displacement that an evaluation computes: the normal one, on which the gap depends, and all three where the
/// shear depends on them. Otherwise the one along x is needed only after the last evaluation of an increment, which computes all
/// layers.
halfspace::Displacements Body::displacements_per_evaluation() const
{
  if (!displacement_y_.empty())
    return halfspace::Displacements::all;
  return !displacement_x_.empty() && computes_all_layers() ? halfspace::Displacements::along_x
                                                           : halfspace::Displacements::normal;
}

/// Computes displacements of the transformed strain.
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

/// Computes the displacement along x of the present trial if it is not known. Stress and normal displacement of this strain are
/// known already, so that no layer (0) is requested.
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

/// In pure shear the yield surface is a circle in (xz, yz) around its centre with the radius yield stress / sqrt(3). Strain and
/// back stresses of the state are those before an increment; those of the cells that flow in it are added here.
std::vector<double> Body::shear_strength(double along_x, double along_y) const
{
  const std::size_t cells = grid().surface.size();
  std::vector<double> strength(cells, std::numeric_limits<double>::infinity());
  if (!is_plastic())
    return strength;
  std::vector<double> equivalent(state_.equivalent.begin(),
                                 state_.equivalent.begin() + static_cast<std::ptrdiff_t>(cells));
  std::vector<Deviator> centres(cells);
  for (std::size_t cell = 0; cell < cells && !material_.kinematic.empty(); ++cell)
    centres[cell] = centre(cell);
  for (std::size_t a = 0; a < active_.size() && in_increment_; ++a)
  {
    if (layer_of(active_.cell(a)) > 0 || active_.equivalent(a) == 0.0)
      continue;
    const auto of_trial = active_.backstress(a);
    const Deviator sum = std::accumulate(of_trial.begin(), of_trial.end(), Deviator{});
    with_copies(a,
                [&](std::size_t cell, const auto& seen)
                {
                  equivalent[cell] += active_.equivalent(a);
                  centres[cell] = seen(sum);
                });
  }
  const bool is_directed = along_x != 0.0 || along_y != 0.0;
  std::visit(
      [&](const auto& law)
      {
        // A traction q causes the stresses xz, yz = -q at the surface, whose outward normal points against z.
        for (std::size_t cell = 0; cell < cells; ++cell)
        {
          const Deviator& c = centres[cell];
          const double backstress_part = is_directed ? along_x * c[Deviator::xz] + along_y * c[Deviator::yz]
                                                     : std::hypot(c[Deviator::xz], c[Deviator::yz]);
          strength[cell] =
              std::max(0.0, law_at(law, cell).yield_stress_at(equivalent[cell]) / std::sqrt(3.0) - backstress_part);
        }
      },
      *material_.hardening);
  return strength;
}

} // namespace brinell::elastoplastic
