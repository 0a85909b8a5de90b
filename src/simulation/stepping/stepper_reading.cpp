// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/contact/contact_area.hpp"
#include "naming_extent.hpp"
#include "snapshot.hpp"
#include "stepper.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

/// Reading the state between two steps; nothing here changes the bodies.
namespace brinell::simulation
{

namespace
{

double largest(const std::vector<double>& values)
{
  return *std::max_element(values.begin(), values.end());
}

} // namespace

Stepper::Distances Stepper::distances(const Centre& centre)
{
  place(lattice_.frame(centre));
  const Depths& depth = depths(centre);
  Distances result{std::numeric_limits<double>::infinity(), 0.0};
  for (std::size_t i = 0; i < distance_.size(); ++i)
  {
    const double distance = distance_[i] + depth.lower[i] + depth.upper[i];
    result.smallest = std::min(result.smallest, distance);
    result.mean += distance / static_cast<double>(distance_.size());
  }
  return result;
}

const Stepper::Depths& Stepper::depths(const Centre& centre)
{
  const Frame frame = lattice_.frame(centre);
  std::fill(depths_.lower.begin(), depths_.lower.end(), 0.0);
  std::fill(depths_.upper.begin(), depths_.upper.end(), 0.0);
  pair_->add_depth(0, frame.placement.lower, depths_.lower);
  pair_->add_depth(1, frame.placement.upper, depths_.upper);
  if (const elastoplastic::Heating* heating = pair_->heating())
  {
    heating->add_depth(0, plan_.lower.surface, frame.placement.lower, depths_.lower);
    heating->add_depth(1, plan_.upper.surface, frame.placement.upper, depths_.upper);
  }
  return depths_;
}

const Stepper::Depths& Stepper::loaded_depths(const Centre& centre)
{
  static_cast<void>(depths(centre));
  if (const elastoplastic::SlidingInterface* sliding = pair_->sliding())
    sliding->add_depth(depths_.lower, depths_.upper);
  else if (const elastoplastic::PartialSlip* slip = pair_->partial_slip())
    slip->add_to_gap(depths_.lower);
  return depths_;
}

halfspace::SurfaceLoad surface_load(const elastoplastic::CoupledContact& pair)
{
  if (pair.interface() == nullptr)
    return {.pressure = pair.pressure()};
  const auto [shear_x, shear_y] = pair.interface()->shears();
  return {.pressure = pair.pressure(), .shear_x = shear_x, .shear_y = shear_y};
}

std::pair<double, double> Stepper::residual_range(const Centre& centre) const
{
  const Frame frame = lattice_.frame(centre);
  const SurfaceGrid& s = pair_->lower().grid().surface;
  const std::vector<double>& residual = pair_->lower().solved().state().residual_displacement;
  const bool all = s.is_periodic_x();
  const int first = all ? 0 : std::max(0, frame.placement.lower.column);
  const int last = all ? s.nx : std::min(s.nx, frame.placement.lower.column + pair_->grid().nx);
  std::pair<double, double> range{0.0, 0.0};
  for (int j = 0; j < s.ny; ++j)
    for (int i = first; i < last; ++i)
    {
      const double u = residual[s.index(i, j)];
      range = {std::min(range.first, u), std::max(range.second, u)};
    }
  return range;
}

bool touches(const elastoplastic::CoupledContact& pair)
{
  return std::any_of(pair.pressure().begin(), pair.pressure().end(), [](double p) { return p > 0.0; });
}

void Stepper::fill(StepRecord& r) const
{
  const elastoplastic::BodyState& lower = pair_->lower().solved().state();
  const elastoplastic::BodyState& upper = pair_->upper().solved().state();
  r.contact_area = contact::contact_area(pair_->grid(), pair_->pressure(), pair_->gap(),
                                         contact_modulus(setup_.lower.top(), setup_.upper.top()));
  for (const double p : pair_->pressure())
    r.max_pressure = std::max(r.max_pressure, p);
  r.F_n = pair_->load();
  r.dissipation_lower = lower.dissipation;
  r.dissipation_upper = upper.dissipation;
  r.energy_residual = lower.locked_in_energy + upper.locked_in_energy;
  r.energy_elastic = pair_->elastic_energy();
  r.max_residual_lower = largest(lower.residual_displacement);
  r.max_residual_upper = largest(upper.residual_displacement);
  r.max_equivalent_plastic_strain =
      std::max(pair_->lower().solved().largest_strain(), pair_->upper().solved().largest_strain());
  r.coverage = coverage_;
  for (const std::unique_ptr<elastoplastic::Effect>& effect : pair_->effects())
    effect->report(r);
}

void Stepper::fill(FrictionRecord& r) const
{
  fill(static_cast<StepRecord&>(r));
  if (const elastoplastic::Interface* interface = pair_->interface())
  {
    const auto [x, y] = interface->forces();
    r.F_friction = std::hypot(x, y);
    r.share_at_shear_limit = interface->limited_share();
  }
}

void Stepper::fill(HeatedRecord& r) const
{
  fill(static_cast<FrictionRecord&>(r));
  r.max_temperature_lower = setup_.lower.temperature;
  r.max_temperature_upper = setup_.upper.temperature;
  const elastoplastic::Heating* heating = pair_->heating();
  if (heating == nullptr)
    return;
  const auto hottest = [&](std::size_t side)
  { return *std::max_element(heating->temperature(side).begin(), heating->temperature(side).end()); };
  r.max_temperature_lower = hottest(0);
  r.max_temperature_upper = hottest(1);
  r.heat_lower = heating->heat(0);
  r.heat_upper = heating->heat(1);
  r.heat_of_source = heating->heat_of_source();
  r.heat_of_current = heating->heat_of_effects();
  r.heat_of_plastic_work = heating->heat_of_plastic_work();
  r.work_of_expansion = pair_->expansion_work();
}

StepFields Stepper::fields(const Centre& centre) const
{
  const Frame frame = lattice_.frame(centre);
  StepFields fields;
  Snapshot& s = fields.surfaces;
  s.contact = pair_->grid().whole();
  s.x0 = frame.x0;
  s.y0 = s.contact.y(0);
  s.pressure.assign(pair_->pressure().begin(), pair_->pressure().end());
  s.gap.assign(pair_->gap().begin(), pair_->gap().end());
  set_shear(*pair_, s);
  s.lower = surface_snapshot(pair_->lower(), lattice_.lower_origin(), centre.lower);
  s.upper = surface_snapshot(pair_->upper(), lattice_.upper_origin(), centre.upper);
  set_heat(*pair_, s);
  set_effects(*pair_, s);
  fields.are_alike = plan_.twin == elastoplastic::Twin::alike && frame.placement.lower == frame.placement.upper;
  if (plan_.surfaces_only)
    return fields;
  std::function<std::vector<double>()> lower_temperature, upper_temperature;
  if (pair_->heating() != nullptr)
  {
    lower_temperature = [this] { return naming_extent([&] { return pair_->temperature(0); }); };
    upper_temperature = [this] { return naming_extent([&] { return pair_->temperature(1); }); };
  }
  const auto& [lower_place, upper_place] = frame.placement;
  using Cells = std::span<const std::size_t>;
  fields.lower = fields_within(
      pair_->lower(), [this, place = lower_place] { return naming_extent([&] { return pair_->stress(0, place); }); },
      lower_temperature,
      [this, place = lower_place](Cells cells)
      { return naming_extent([&] { return pair_->cells(0, place, cells); }); });
  fields.upper = fields_within(
      pair_->upper(), [this, place = upper_place] { return naming_extent([&] { return pair_->stress(1, place); }); },
      upper_temperature,
      [this, place = upper_place](Cells cells)
      { return naming_extent([&] { return pair_->cells(1, place, cells); }); });
  return fields;
}

Stepper::Present Stepper::present(const Centre& centre)
{
  return {*pair_,
          lattice_.frame(centre).placement,
          {lattice_.lower_origin(), lattice_.upper_origin()},
          {centre.lower, centre.upper}};
}

void Stepper::fill(RunTotals& totals) const
{
  totals.split_increments = split_increments_;
  if (has_inclusions())
    totals.inclusions = inclusions_;
  if (const elastoplastic::Heating* heating = pair_->heating())
  {
    totals.most_held_cells = heating->most_held_cells();
    totals.share_of_held_cells = heating->share_of_held_cells();
  }
  totals.grid_changes = grid_changes_;
  totals.is_mirrored_y = plan_.contact.is_mirrored_y;
  totals.memory_bytes = plan_.memory_bytes;
}

} // namespace brinell::simulation
