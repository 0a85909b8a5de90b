// SPDX-License-Identifier: BSD-3-Clause
#include "body_parts.hpp"
#include "foundation/sharing.hpp"

#include <numeric>

/// Work and energies of a body.
namespace brinell::elastoplastic
{

namespace
{

/// Work of the thermal stress on the plastic strain, as a sum over cells [Pa]; times the cell volume it is an energy.
/// @param zone  contains all cells with plastic strain
double work_of_thermal_stress(const BodyParts& b, const PlasticZone& zone)
{
  const std::vector<double>& thermal = b.thermal_stress();
  if (thermal.empty())
    return 0.0;
  const std::size_t n = b.grid.size();
  const auto term = [&](std::size_t cell)
  { return contract(deviator_at(thermal, n, cell), deviator_at(b.state.plastic_strain, n, cell)); };
  if (!b.share.is_all())
    return sum_over_zone(b, zone, b.whole.size(), term);
  double work = 0.0;
  zone.for_cells(0, n,
                 [&](std::size_t from, std::size_t to)
                 {
                   for (std::size_t cell = from; cell < to; ++cell)
                     work += term(cell);
                 });
  return work;
}

/// Plastic zone of the state with the cells that flow in the current increment.
PlasticZone zone_of_trial(const BodyParts& b)
{
  PlasticZone zone = b.zone;
  for (std::size_t a = 0; a < b.trial.active.size(); ++a)
    if (b.trial.active.equivalent(a) > 0.0)
      b.with_copies(a, [&](std::size_t cell, const auto& /*seen*/)
                    { zone.add(cell, b.state.equivalent[cell] + b.trial.active.equivalent(a)); });
  return zone;
}

} // namespace

double locked_in_energy(const BodyParts& b, const halfspace::SurfaceLoad& load, const PlasticZone& zone)
{
  // 1/2 eps H eps - s0 eps, with H eps = (stress of the load + initial stress s0 - stress); the work of the load's stress is
  // computed on the surface by Betti's theorem. The energy of s0 itself is constant and left out.
  const std::size_t n = b.grid.size();
  const std::span<const double> own = b.evaluation->own_stress(); // of inclusions: an initial stress like s0
  const auto term = [&](double initial, std::size_t cell)
  {
    const Deviator strain = deviator_at(b.state.plastic_strain, n, cell);
    const double relieved = initial * (strain[Deviator::xx] + strain[Deviator::yy]) +
                            (own.empty() ? 0.0 : contract(deviator_at(own, n, cell), strain));
    return contract(deviator_at(b.trial.stress, n, cell), strain) + relieved;
  };
  const auto initial_at = [&](std::size_t cell) { return b.evaluation->initial_stress().at(b.yield.layer_of(cell)); };
  const auto work_in = [&](std::size_t first, std::size_t last)
  {
    double work = 0.0;
    zone.for_cells(first, last,
                   [&](std::size_t from, std::size_t to)
                   {
                     const double initial = initial_at(from);
                     for (std::size_t cell = from; cell < to; ++cell)
                       work += term(initial, cell);
                   });
    return work;
  };
  // The stress includes the thermal stress, which is not due to the plastic strain: its work is subtracted.
  const double all_work =
      b.share.is_all()
          ? sum_of_pieces(n, work_in)
          : sum_over_zone(b, zone, piece_size, [&](std::size_t cell) { return term(initial_at(cell), cell); });
  const double volume_work = all_work - work_of_thermal_stress(b, zone);
  double surface_work = dot(load.pressure, b.evaluation->displacement(0));
  if (!load.shear_x.empty())
    surface_work += dot(load.shear_x, b.evaluation->displacement(1));
  if (!load.shear_y.empty())
    surface_work += dot(load.shear_y, b.evaluation->displacement(2));
  return 0.5 * (surface_work * b.grid.surface.cell_area() - volume_work * b.grid.cell_volume());
}

double thermal_work_of_trial(const BodyParts& b)
{
  const std::vector<double>& thermal = b.thermal_stress();
  if (thermal.empty())
    return 0.0;
  const std::size_t n = b.grid.size();
  std::vector<double> works;
  for (std::size_t a = 0; a < b.trial.active.size(); ++a)
  {
    const std::size_t cell = b.trial.active.cell(a);
    Deviator mean = 0.5 * deviator_at(thermal, n, cell);
    if (!b.state.thermal_stress.empty())
      mean = mean + 0.5 * deviator_at(b.state.thermal_stress, n, cell);
    works.push_back(b.copies(a) *
                    contract(mean, deviator_at(b.state.plastic_strain, n, cell) - b.trial.active.start(a)));
  }
  if (!b.share.is_all())
    works = in_order(b, works);
  return std::accumulate(works.begin(), works.end(), 0.0) * b.grid.cell_volume();
}

double Body::energy(const halfspace::SurfaceLoad& load) const
{
  const BodyParts& b = parts_;
  if (!b.is_plastic())
    return 0.0;
  const double dissipation = with_dissipation(b, 0.0, 1.0);
  const std::optional<PlasticZone> trial = b.trial.is_open ? std::optional(zone_of_trial(b)) : std::nullopt;
  const double locked_in = trial ? locked_in_energy(b, load, *trial) : b.state.locked_in_energy;
  const double thermal_work = work_of_thermal_stress(b, trial ? *trial : b.zone) * b.grid.cell_volume();
  return dissipation * b.grid.cell_volume() + locked_in - thermal_work;
}

std::vector<double> Body::work_of_increment() const
{
  const BodyParts& b = parts_;
  std::vector<double> work(b.grid.size());
  for (std::size_t a = 0; a < b.trial.active.size(); ++a)
    b.with_copies(a, [&](std::size_t cell, const auto& /*seen*/) { work[cell] = b.trial.active.dissipation(a); });
  if (b.share.is_all())
    return work;
  work = gathered(b, work);
  work.resize(b.whole.size());
  b.ranks->broadcast(work, 0);
  return work;
}

} // namespace brinell::elastoplastic
