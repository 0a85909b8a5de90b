// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/body.hpp"

#include "foundation/sharing.hpp"
#include "with_copies.hpp"

/// Work and energies of a body.
namespace brinell::elastoplastic
{

/// Locked-in elastic energy [J].
/// @param zone  contains all cells with plastic strain
double Body::locked_in_energy(const halfspace::SurfaceLoad& load, const PlasticZone& zone) const
{
  // 1/2 eps H eps - s0 eps, with H eps = (stress of the load + initial stress s0 - stress); the work of the load's stress is
  // computed on the surface by Betti's theorem. The energy of s0 itself is constant and left out.
  const std::size_t n = grid().size();
  const auto work_in = [&](std::size_t first, std::size_t last)
  {
    double work = 0.0;
    zone.for_cells(first, last,
                   [&](std::size_t from, std::size_t to)
                   {
                     const double initial = initial_stress_[layer_of(from)];
                     for (std::size_t cell = from; cell < to; ++cell)
                     {
                       const Deviator strain = deviator_at(state_.plastic_strain, n, cell);
                       const double relieved = initial * (strain[Deviator::xx] + strain[Deviator::yy]);
                       work += contract(deviator_at(stress_, n, cell), strain) + relieved;
                     }
                   });
    return work;
  };
  // The stress includes the thermal stress, which is not due to the plastic strain: its work is subtracted.
  const double volume_work = sum_of_pieces(n, work_in) - work_of_thermal_stress(zone);
  double surface_work = dot(load.pressure, displacement_);
  if (!load.shear_x.empty())
    surface_work += dot(load.shear_x, displacement_x_);
  if (!load.shear_y.empty())
    surface_work += dot(load.shear_y, displacement_y_);
  return 0.5 * (surface_work * grid().surface.cell_area() - volume_work * grid().cell_volume());
}

/// Work of the thermal stress on the plastic strain, as a sum over cells [Pa]; times the cell volume it is an energy.
/// @param zone  contains all cells with plastic strain
double Body::work_of_thermal_stress(const PlasticZone& zone) const
{
  const std::vector<double>& thermal = thermal_stress();
  if (thermal.empty())
    return 0.0;
  const std::size_t n = grid().size();
  double work = 0.0;
  zone.for_cells(0, n,
                 [&](std::size_t from, std::size_t to)
                 {
                   for (std::size_t cell = from; cell < to; ++cell)
                     work += contract(deviator_at(thermal, n, cell), deviator_at(state_.plastic_strain, n, cell));
                 });
  return work;
}

/// Work of the thermal stress on the plastic strain of the present increment, by the trapezoidal rule [J].
double Body::thermal_work_of_trial() const
{
  const std::vector<double>& thermal = thermal_stress();
  if (thermal.empty())
    return 0.0;
  const std::size_t n = grid().size();
  double work = 0.0;
  for (std::size_t a = 0; a < active_.size(); ++a)
  {
    const std::size_t cell = active_.cell(a);
    Deviator mean = 0.5 * deviator_at(thermal, n, cell);
    if (!state_.thermal_stress.empty())
      mean = mean + 0.5 * deviator_at(state_.thermal_stress, n, cell);
    work += copies(a) * contract(mean, deviator_at(state_.plastic_strain, n, cell) - active_.start(a));
  }
  return work * grid().cell_volume();
}

/// Plastic zone of the state with the cells that flow in the current increment.
PlasticZone Body::zone_of_trial() const
{
  PlasticZone zone = zone_;
  for (std::size_t a = 0; a < active_.size(); ++a)
    if (active_.equivalent(a) > 0.0)
      with_copies(a, [&](std::size_t cell, const auto& /*seen*/)
                  { zone.add(cell, state_.equivalent[cell] + active_.equivalent(a)); });
  return zone;
}

double Body::energy(const halfspace::SurfaceLoad& load) const
{
  if (!is_plastic())
    return 0.0;
  double dissipation = 0.0;
  for (std::size_t a = 0; a < active_.size(); ++a)
    dissipation += copies(a) * active_.dissipation(a);
  const std::optional<PlasticZone> trial = in_increment_ ? std::optional(zone_of_trial()) : std::nullopt;
  const double locked_in = trial ? locked_in_energy(load, *trial) : state_.locked_in_energy;
  const double thermal_work = work_of_thermal_stress(trial ? *trial : zone_) * grid().cell_volume();
  return dissipation * grid().cell_volume() + locked_in - thermal_work;
}

std::vector<double> Body::work_of_increment() const
{
  std::vector<double> work(grid().size());
  for (std::size_t a = 0; a < active_.size(); ++a)
    with_copies(a, [&](std::size_t cell, const auto& /*seen*/) { work[cell] = active_.dissipation(a); });
  return work;
}

} // namespace brinell::elastoplastic
