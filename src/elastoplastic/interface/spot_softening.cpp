// SPDX-License-Identifier: BSD-3-Clause
#include "spot_softening.hpp"

#include <algorithm>

namespace brinell::elastoplastic
{

SpotSoftening::SpotSoftening(const SurfaceGrid& contact, const std::array<VolumeGrid, 2>& grids,
                             const std::array<const constitutive::Material*, 2>& materials, double spreading)
    : contact_(contact), grids_(grids), spreading_(spreading)
{
  constexpr Thermal unit{.conductivity = 1.0, .density = 1.0, .specific_heat = 1.0, .expansion = 1e-6};
  for (std::size_t side = 0; side < 2; ++side)
  {
    const constitutive::Material& material = *materials[side];
    if (!material.is_plastic() || !material.softening)
      continue;
    laws_[side] = &*material.softening;
    std::vector<double> depths;
    depths.reserve(static_cast<std::size_t>(grids[side].nz));
    for (int k = 0; k < grids[side].nz; ++k)
      depths.push_back((k + 0.5) * grids[side].dz);
    fields_[side] =
        side == 1 && fields_[0] && grids[0] == grids[1]
            ? fields_[0]
            : std::make_shared<const halfspace::SteadyField>(grids[side].surface.whole(), unit, material.elastic,
                                                             halfspace::SteadyMotion{}, std::move(depths));
  }
}

std::vector<double> SpotSoftening::factors(std::size_t side, const Place& place, std::span<const double> density,
                                           const std::array<contact::HotConductor, 2>& bodies,
                                           const contact::HotContact& hot) const
{
  if (!fields_[side])
    return {};
  const VolumeGrid& grid = grids_[side];
  const std::size_t size = grid.surface.size();
  std::vector<double> flux(size), factor(grid.size());
  static_cast<void>(spread_volume(contact_, density, 1.0, place, grid.surface, flux));
  std::vector<halfspace::ThermalLayer> layers(static_cast<std::size_t>(grid.nz));
  for (std::size_t k = 0; k < layers.size(); ++k)
    layers[k].temperature = std::span(factor).subspan(k * size, size);
  fields_[side]->layers(flux, 0, layers);
  for (double& value : factor) // up to here the potential per resistivity and volt
  {
    const double share = std::clamp(spreading_ * value, 0.0, 1.0);
    value = constitutive::softening_factor(*laws_[side], contact::temperature_in(bodies, hot, side, share));
  }
  return factor;
}

} // namespace brinell::elastoplastic
