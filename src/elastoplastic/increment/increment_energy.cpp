// SPDX-License-Identifier: BSD-3-Clause
#include "contact_parts.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>

/// The energy that an increment minimises: docs/theory/elastoplastic.md (energy).
namespace brinell::elastoplastic
{

namespace
{

double pressure_energy(const ContactParts& c)
{
  std::vector<double> displacement(c.state.pressure.size());
  halfspace::SurfaceCompliance::Scratch scratch = c.compliance.make_scratch();
  c.compliance.apply({.pressure = c.state.pressure}, {.z = displacement}, scratch);
  return 0.5 * dot(c.grid(), c.state.pressure, displacement) * c.grid().cell_area();
}

} // namespace

bool CoupledContact::has_energy(contact::Drive::Kind drive) const
{
  const ContactParts& c = *parts_;
  return drive != contact::Drive::Kind::mean_gap &&
         std::all_of(c.sides.begin(), c.sides.end(),
                     [](const Side& side)
                     { return side.body.material().kinematic.empty() && !side.body.has_inclusions(); });
}

double CoupledContact::elastic_energy() const
{
  const ContactParts& c = *parts_;
  return pressure_energy(c) + (c.interface ? c.interface->elastic_energy(c.state.pressure) : 0.0);
}

double energy(const ContactParts& c, double approach)
{
  // The contact contributes its dual value -(1/2 p A p + p distance), whose error is of second order in the error of the
  // pressure. An imposed approach adds its work; under an imposed load this work is constant in the increment and left out.
  const double work = dot(c.state.pressure, c.distance) - approach * sum(c.state.pressure);
  double bodies = 0.0;
  for (const Side& side : c.sides)
    bodies += side.body.energy(side.load()) - work_of_shear(c, side);
  if (c.twin != Twin::none)
    bodies *= 2.0;
  const double shear_energy = c.interface ? c.interface->held_energy() : 0.0;
  const double thermal_work = c.heating ? c.heating->work_of_shears(c.interface->shears()) : 0.0;
  double energy_of_effects = 0.0;
  for (const std::unique_ptr<Effect>& effect : c.effects)
    energy_of_effects += effect->held_energy(c.state.pressure);
  return bodies - pressure_energy(c) - work * c.grid().cell_area() + shear_energy - thermal_work + energy_of_effects;
}

double imposed_approach(const contact::Drive& drive, double found)
{
  return drive.kind == contact::Drive::Kind::load ? 0.0 : found;
}

} // namespace brinell::elastoplastic
