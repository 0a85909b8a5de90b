// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/body_stress.hpp"

namespace brinell::elastoplastic
{

BodyStress body_stress(const CoupledContact& pair, const Body& body, const Place& place)
{
  const VolumeGrid& grid = body.grid();
  std::vector<double> pressure;
  pair.spread_pressure(body, place, pressure);
  BodyStress stress{std::vector<double>(Deviator::size * grid.size()), std::vector<double>(grid.size())};
  const halfspace::HalfSpace& half_space = *body.shared_half_space();
  halfspace::HalfSpace::Work work = half_space.make_work();
  half_space.full_stress({.pressure = pressure}, body.state().plastic_strain, work, stress.deviator, stress.trace);
  body.add_initial_stress(grid.nz, stress.deviator);
  for (std::size_t i = 0; i < stress.trace.size(); ++i)
    stress.trace[i] += 2.0 * body.initial_stress()[i / grid.surface.size()];
  return stress;
}

} // namespace brinell::elastoplastic
