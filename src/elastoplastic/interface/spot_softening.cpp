// SPDX-License-Identifier: BSD-3-Clause
#include "spot_softening.hpp"

#include <algorithm>

namespace brinell::elastoplastic
{

SpotSoftening::SpotSoftening(const SurfaceGrid& contact, const std::array<VolumeGrid, 2>& grids,
                             const std::array<const constitutive::Material*, 2>& materials, double spreading)
    : contact_(contact), grids_(grids), spreading_(spreading)
{
  for (std::size_t side = 0; side < 2; ++side)
  {
    const constitutive::Material& material = *materials[side];
    if (!material.is_plastic() || !material.softening)
      continue;
    laws_[side] = &*material.softening;
    melting_ = std::min(melting_, constitutive::melting_temperature(*material.softening).value_or(melting_));
    std::vector<double> depths;
    depths.reserve(static_cast<std::size_t>(grids[side].nz));
    for (int k = 0; k < grids[side].nz; ++k)
      depths.push_back((k + 0.5) * grids[side].dz);
    fields_[side] = side == 1 && fields_[0] && grids[0] == grids[1]
                        ? fields_[0]
                        : std::make_shared<const halfspace::SpreadingField>(grids[side].surface.whole(), depths);
  }
}

/// Potential of a flux of the contact in each cell of a body, for a resistivity of 1.
std::vector<double> SpotSoftening::potential(std::size_t side, const Place& place, std::span<const double> flux) const
{
  const VolumeGrid& grid = grids_[side];
  std::vector<double> on_body(grid.surface.size()), result(grid.size());
  static_cast<void>(spread_volume(contact_, flux, 1.0, place, grid.surface, on_body));
  fields_[side]->potential(on_body, result);
  return result;
}

std::vector<double> SpotSoftening::factors(std::size_t side, const Place& place, std::span<const double> density,
                                           const std::array<contact::HotConductor, 2>& bodies,
                                           const contact::HotContact& hot) const
{
  if (!fields_[side])
    return {};
  std::vector<double> factor = potential(side, place, density);
  for (double& value : factor)
  {
    const double share = std::clamp(spreading_ * value, 0.0, 1.0);
    value = constitutive::softening_factor(*laws_[side], contact::temperature_in(bodies, hot, side, share));
  }
  return factor;
}

std::vector<double> SpotSoftening::factors(std::size_t side, const Place& place, std::span<const double> density,
                                           std::span<const double> flux, double resistivity,
                                           const contact::HotConductor& body) const
{
  if (!fields_[side])
    return {};
  std::vector<double> factor = potential(side, place, flux);
  const std::vector<double> of_current = potential(side, place, density);
  for (std::size_t i = 0; i < factor.size(); ++i)
  {
    const double potential = resistivity * of_current[i];
    const double kirchhoff = resistivity * factor[i] - 0.5 * potential * potential;
    factor[i] = constitutive::softening_factor(*laws_[side], body.temperature_at(kirchhoff));
  }
  return factor;
}

} // namespace brinell::elastoplastic
