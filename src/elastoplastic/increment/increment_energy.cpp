// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/increment.hpp"

#include "foundation/sharing.hpp"

#include <algorithm>

/// The energy that an increment minimises: docs/theory/elastoplastic.md (energy).
namespace brinell::elastoplastic
{

bool CoupledContact::has_energy(contact::Drive::Kind drive) const
{
  return drive != contact::Drive::Kind::mean_gap &&
         std::all_of(sides_.begin(), sides_.end(), [](const Side& side) { return side.body.material().kinematic.empty(); });
}

double CoupledContact::elastic_energy() const
{
  return pressure_energy() + (interface_ ? interface_->elastic_energy(pressure_) : 0.0);
}

double CoupledContact::pressure_energy() const
{
  std::vector<double> displacement(pressure_.size());
  halfspace::SurfaceCompliance::Scratch scratch = compliance_.make_scratch();
  compliance_.apply({.pressure = pressure_}, {.z = displacement}, scratch);
  return 0.5 * dot(pressure_, displacement) * grid().cell_area();
}

double CoupledContact::energy(double approach) const
{
  // The contact contributes its dual value -(1/2 p A p + p distance), whose error is of second order in the error of the
  // pressure. An imposed approach adds its work; under an imposed load this work is constant in the increment and left out.
  const double work = dot(pressure_, distance_) - approach * sum(pressure_);
  double bodies = 0.0;
  for (const Side& side : sides_)
    bodies += side.body.energy(side.load()) - work_of_shear(side);
  if (twin_ != Twin::none)
    bodies *= 2.0;
  const double shear_energy = interface_ ? interface_->held_energy() : 0.0;
  const double thermal_work = heating_ ? heating_->work_of_shears(interface_->shears()) : 0.0;
  double energy_of_effects = 0.0;
  for (const std::unique_ptr<Effect>& effect : effects_)
    energy_of_effects += effect->held_energy(pressure_);
  return bodies - pressure_energy() - work * grid().cell_area() + shear_energy - thermal_work + energy_of_effects;
}

} // namespace brinell::elastoplastic
