// SPDX-License-Identifier: BSD-3-Clause
#include "body_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace brinell::elastoplastic
{

namespace
{

/// In pure shear the yield surface is a circle in (xz, yz) around its centre with the radius yield stress / sqrt(3). Strain and
/// back stresses of the state are those before an increment; those of the cells that flow in it are added here.
void find_shear_strength(const BodyParts& b, double along_x, double along_y, std::vector<double>& strength)
{
  const std::size_t cells = strength.size();
  std::vector<double> equivalent(b.state.equivalent.begin(),
                                 b.state.equivalent.begin() + static_cast<std::ptrdiff_t>(cells));
  std::vector<Deviator> centres(cells);
  for (std::size_t cell = 0; cell < cells && !b.yield.material.kinematic.empty(); ++cell)
    centres[cell] = b.centre(cell);
  for (std::size_t a = 0; a < b.trial.active.size() && b.trial.is_open; ++a)
  {
    if (b.yield.layer_of(b.trial.active.cell(a)) > 0 || b.trial.active.equivalent(a) == 0.0)
      continue;
    const auto of_trial = b.trial.active.backstress(a);
    const Deviator sum = std::accumulate(of_trial.begin(), of_trial.end(), Deviator{});
    b.with_copies(a,
                  [&](std::size_t cell, const auto& seen)
                  {
                    equivalent[cell] += b.trial.active.equivalent(a);
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
              std::max(0.0, b.yield.at(law, cell).yield_stress_at(equivalent[cell]) / std::sqrt(3.0) - backstress_part);
        }
      },
      b.yield.law_at(0));
}

} // namespace

std::vector<double> Body::shear_strength(double along_x, double along_y) const
{
  const BodyParts& b = parts_;
  const std::size_t cells = b.grid.surface.size();
  std::vector<double> strength(cells, std::numeric_limits<double>::infinity());
  if (!b.is_plastic())
    return strength;
  if (b.share.has(0))
    find_shear_strength(b, along_x, along_y, strength);
  b.ranks->broadcast(strength, b.share.layers().owner(0));
  return strength;
}

} // namespace brinell::elastoplastic
