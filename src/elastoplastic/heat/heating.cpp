// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/heating.hpp"

#include "brinell/foundation/error.hpp"
#include "foundation/sharing.hpp"
#include "heating_state.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace brinell::elastoplastic
{

namespace
{

/// The material grids of a resumed run may have grown, but the thermal grids follow from the initial material grids, which
/// therefore are stored.
void exchange_grids(Archive& archive, std::array<Heating::Partner, 2>& bodies)
{
  constexpr int max_cells = 1 << 20;
  for (const auto& [name, body] : {std::pair{"lower", &bodies[0]}, {"upper", &bodies[1]}})
  {
    const SurfaceGrid now = body->grid.surface;
    for (const auto& [part, cells] : {std::pair{".columns", &body->grid.surface.nx},
                                      {".rows", &body->grid.surface.ny},
                                      {".layers", &body->grid.nz}})
      archive(std::string(name) + part, *cells, 1, max_cells);
    if ((now.nx - body->grid.surface.nx) % 2 != 0 || (now.ny - body->grid.surface.ny) % 2 != 0)
      throw InputError(fmt::format("the stored state has heat on a grid of {} x {} cells, which does not fit",
                                   body->grid.surface.nx, body->grid.surface.ny));
  }
}

void require_conductors(const std::array<Heating::Partner, 2>& bodies)
{
  if (!bodies[0].material.thermal && !bodies[1].material.thermal)
    throw InputError("Heating: neither body has thermal constants");
  for (const Heating::Partner& body : bodies)
    if (!body.material.thermal && !body.material.elastic.is_rigid())
      throw InputError("Heating: a body that deforms has no thermal constants");
}

std::array<HeatedSide, 2> sides_of(const SurfaceGrid& contact, const HeatingPlan& plan)
{
  const auto& bodies = plan.bodies;
  const auto heat_of = [&](const Heating::Partner& body)
  {
    return body.material.thermal ? std::make_shared<BodyHeat>(body.grid, body.material, plan.run, plan.numerics)
                                 : nullptr;
  };
  const std::shared_ptr<BodyHeat> lower = heat_of(bodies[0]);
  const bool is_twin = plan.twin != Twin::none;
  const std::optional<double>& reference = plan.run.settings.reference;
  const bool along = plan.numerics.along_surface;
  return {HeatedSide(contact, bodies[0].material, lower, false, reference, along),
          HeatedSide(contact, bodies[1].material, is_twin ? lower : heat_of(bodies[1]), is_twin, reference, along)};
}

} // namespace

Heating::Heating(const SurfaceGrid& contact, const std::array<Partner, 2>& bodies, const HeatedRun& run, Twin twin,
                 const HeatNumerics& numerics)
{
  require_conductors(bodies);
  if (twin == Twin::alike)
    throw InternalError("Heating: bodies that are alike do not slide on each other");
  if (twin != Twin::none && run.settings.share() != 0.5)
    throw InternalError("Heating: twins have equal shares in the heat");
  if (const HeatSource& source = run.settings.source; source.is_on_body())
  {
    if (twin != Twin::none)
      throw InternalError("Heating: a source on one body heats no twin");
    if (!bodies.at(source.side()).material.thermal)
      throw InputError("Heating: the body of the source has no thermal constants");
  }
  const HeatingPlan plan{bodies, run, twin, numerics};
  state_ = make_hidden<State>(contact, plan, sides_of(contact, plan), twin == Twin::none ? 1.0 : 2.0);
}

void Heating::begin(const Start& start)
{
  State& s = *state_;
  s.duration = start.duration;
  s.slides = start.slides;
  s.pressure_before.assign(start.pressure_before.begin(), start.pressure_before.end());
  s.is_source_on = start.is_source_on && s.settings.source.exists();
  s.do_effects_heat = start.has_effects;
  s.touching.begin(s.contact.size());
  for (std::size_t side = 0; side < 2 && s.duration > 0.0; ++side)
  {
    const bool is_heated = s.is_source_on && s.settings.source.is_on_body() && s.settings.source.side() == side;
    s.sides[side].begin(start.grids[side], start.places[side], start.columns[side], s.duration,
                        start.slides || s.is_source_between() || s.do_effects_heat,
                        is_heated ? std::span<const double>(s.imposed) : std::span<const double>());
  }
}

double Heating::follow(std::span<const double> pressure, std::span<const double> heat_per_area, Sharing sharing,
                       std::span<const double> of_effects)
{
  State& s = *state_;
  if (s.duration == 0.0)
    return 0.0;
  std::vector<double> heat = s.power_of(heat_per_area);
  static_cast<void>(s.add_source_between(pressure, heat));
  static_cast<void>(s.add_effects(of_effects, heat));
  return s.share_flux(heat, pressure, sharing);
}

bool Heating::is_steady() const
{
  return state_->settings.regime == HeatRegime::steady;
}

void Heating::recall(const std::array<VolumeGrid, 2>& grids, const std::array<Place, 2>& places,
                     const std::array<double, 2>& columns)
{
  State& s = *state_;
  for (std::size_t side = 0; side < 2; ++side)
    s.sides[side].recall(grids[side], places[side], columns[side]);
  for (std::size_t axis = 0; axis < 2; ++axis)
    s.along_before[axis] = s.relative_displacement(axis);
}

void Heating::add_along(std::size_t side, std::size_t axis, std::span<double> out) const
{
  state_->sides.at(side).add_along(axis, out);
}

double Heating::work_of_shears(const std::array<std::span<const double>, 2>& shears) const
{
  double work = 0.0;
  for (std::size_t axis = 0; axis < 2; ++axis)
    if (!shears[axis].empty())
      work += dot(shears[axis], state_->relative_displacement(axis));
  return work * state_->contact.cell_area();
}

void Heating::add_to_gap(std::span<double> gap) const
{
  for (const HeatedSide& side : state_->sides)
    side.add_displacement(gap);
}

void Heating::require_room(std::span<const double> pressure, const std::array<std::vector<double>, 2>& works,
                           const std::array<VolumeGrid, 2>& grids) const
{
  for (std::size_t side = 0; side < 2; ++side)
  {
    const HeatedSide& s = state_->sides[side];
    if (state_->duration > 0.0)
      s.require_room(pressure);
    if (!works[side].empty())
      s.heat().require_room_for_work(works[side], grids[side]);
  }
}

void Heating::find_fluxes(std::span<const double> pressure, std::span<const double> heat_per_area,
                          std::span<const double> of_effects)
{
  State& s = *state_;
  if (s.duration == 0.0)
    return;
  std::vector<double> heat = s.power_of(heat_per_area);
  s.friction_of_increment = sum(heat) * s.duration * s.contact.cell_area();
  if (s.heats_without_flux())
    std::fill(heat.begin(), heat.end(), 0.0);
  s.power_of_source = s.add_source_between(pressure, heat);
  if (s.is_source_on)
    s.power_of_source += sum(s.imposed) * s.contact.cell_area();
  s.power_of_effects = s.add_effects(of_effects, heat);
  static_cast<void>(s.share_flux(heat, pressure, Sharing::fine));
}

void Heating::settle(std::span<const double> pressure, const std::array<std::span<const double>, 2>& shears)
{
  State& s = *state_;
  if (s.duration == 0.0)
    return;
  s.totals.of_friction += s.friction_of_increment;
  if (s.heats_without_flux())
    s.add_heat_without_flux(s.friction_of_increment);
  s.totals.of_source += s.power_of_source * s.duration;
  s.totals.of_effects += s.power_of_effects * s.duration;
  s.count_held();
  for (HeatedSide& side : s.sides)
    side.settle();
  for (HeatedSide& side : s.sides)
    if (side.conducts() && !side.is_mirrored())
      s.totals.work_on_tractions += s.copies * side.heat().work_against(side.on_body(pressure, "pressure"));
  s.totals.work_on_tractions += s.work_along(shears);
}

bool Heating::takes_work(std::size_t side) const
{
  const HeatedSide& s = state_->sides.at(side);
  return s.conducts() && !s.is_mirrored() && state_->settings.of_plastic_work > 0.0;
}

void Heating::settle_work(std::size_t side, std::span<const double> work, const VolumeGrid& body)
{
  if (takes_work(side))
    state_->sides.at(side).heat().settle_work(work, body, state_->duration);
}

void Heating::restore()
{
  if (state_->duration == 0.0)
    return;
  for (HeatedSide& side : state_->sides)
    side.restore();
}

std::span<const double> Heating::stress(std::size_t side) const
{
  const HeatedSide& s = state_->sides.at(side);
  if (!s.conducts() || s.is_mirrored())
    return {};
  return s.heat().stress();
}

std::span<const double> Heating::softening(std::size_t side) const
{
  const HeatedSide& s = state_->sides.at(side);
  if (!s.conducts() || s.is_mirrored())
    return {};
  return s.heat().softening();
}

std::span<const double> Heating::temperature(std::size_t side) const
{
  return state_->sides.at(side).temperature();
}

std::span<const double> Heating::flux(std::size_t side) const
{
  return state_->sides.at(side).flux();
}

double Heating::heat(std::size_t side) const
{
  return state_->sides.at(side).total();
}

double Heating::heat_of_friction() const
{
  return state_->totals.of_friction;
}

double Heating::heat_of_source() const
{
  return state_->totals.of_source;
}

double Heating::heat_of_effects() const
{
  return state_->totals.of_effects;
}

double Heating::heat_of_plastic_work() const
{
  double heat = 0.0;
  for (const HeatedSide& side : state_->sides)
    if (side.conducts() && !side.is_mirrored())
      heat += state_->copies * side.heat().heat_of_plastic_work();
  return heat;
}

double Heating::work_on_tractions() const
{
  return state_->totals.work_on_tractions;
}

int Heating::most_held_cells() const
{
  return state_->totals.most_held;
}

double Heating::share_of_held_cells() const
{
  return state_->totals.passed > 0.0 ? state_->totals.held / state_->totals.passed : 0.0;
}

void Heating::add_depth(std::size_t side, const SurfaceGrid& body, const Place& place, std::span<double> out) const
{
  state_->sides.at(side).add_depth(body, place, out);
}

void Heating::layers(std::size_t side, const VolumeGrid& body, const Layers& out) const
{
  const HeatedSide& s = state_->sides.at(side);
  if (s.conducts())
    s.heat().layers(body, out);
}

void Heating::layer(std::size_t side, const VolumeGrid& body, std::size_t layer, const Layers& out) const
{
  const HeatedSide& s = state_->sides.at(side);
  if (s.conducts())
    s.heat().layer(body, layer, out);
}

void Heating::exchange(Archive& archive)
{
  State& s = *state_;
  const std::array<Partner, 2> before = s.plan.bodies;
  const int layers_before = s.plan.run.layers;
  exchange_grids(archive, s.plan.bodies);
  archive("layers", s.plan.run.layers, 0, 1 << 20);
  if (s.plan.bodies[0].grid != before[0].grid || s.plan.bodies[1].grid != before[1].grid ||
      s.plan.run.layers != layers_before)
  {
    s.sides = sides_of(s.contact, s.plan);
    s.cached_responses.clear();
  }
  archive("lower", s.sides[0]);
  archive("upper", s.sides[1]);
  exchange_members(archive, s.totals);
}

void Heating::move_to(const SurfaceGrid& contact)
{
  for (HeatedSide& side : state_->sides)
    side.move_to(contact);
  state_->cached_responses.clear();
  state_->contact = contact;
  state_->imposed = flux_on(state_->settings.source, contact);
}

} // namespace brinell::elastoplastic
