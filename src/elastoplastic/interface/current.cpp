// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/current.hpp"

#include "brinell/elastoplastic/effects.hpp"
#include "foundation/nan.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <limits>

namespace brinell::elastoplastic
{

namespace
{

contact::HotConductor conductor(const constitutive::Material& material)
{
  contact::HotConductor result{.resistivity = material.electrical->resistivity,
                               .temperature_coefficient = material.electrical->temperature_coefficient,
                               .temperature = material.temperature};
  if (material.thermal)
    result.conductivity = material.thermal->conductivity;
  return result;
}

} // namespace

Current::Current(const halfspace::SurfaceCompliance& compliance, double modulus, const Materials& materials,
                 const CurrentDrive& drive)
    : constriction_(compliance, modulus),
      grid_(compliance.grid()), bodies_{conductor(*materials[0]), conductor(*materials[1])},
      spreading_(bodies_[0].resistivity_at(bodies_[0].temperature) + bodies_[1].resistivity_at(bodies_[1].temperature)),
      drive_(drive), film_(drive.film > 0.0 ? grid_.size() : 0, drive.film)
{
}

void Current::commit(const Interaction& found, const Placement& /*placement*/)
{
  contact::Flow flow =
      constriction_.flow({found.pressure(), found.gap()}, spreading_, film_, std::move(state_.per_volt));
  state_.spots = static_cast<int>(flow.of_patch.size());
  state_.largest_share =
      flow.of_patch.empty() ? 0.0 : *std::max_element(flow.of_patch.begin(), flow.of_patch.end()) / flow.conductance;
  state_.temperature = std::max(bodies_[0].temperature, bodies_[1].temperature);
  drive_through(flow, found.pressure());
  find_density(flow);
  state_.per_volt = std::move(flow.density);
  if (state_.resistance < state_.least_resistance)
    state_.least_resistance = state_.resistance;
  state_.largest_temperature = larger(state_.largest_temperature, state_.temperature);
}

/// Finds the density. Heat does not change the share of each spot; a contact without resistance has a uniform density.
void Current::find_density(const contact::Flow& flow)
{
  const bool is_full = std::isinf(flow.conductance);
  const double whole = static_cast<double>(grid_.size()) * grid_.cell_area();
  state_.density = is_full ? std::vector<double>(grid_.size(), 1.0 / whole) : flow.whole_density(grid_.cell_area());
  state_.density.resize(grid_.size()); // without contact
  const double scale = is_full ? state_.current : flow.conductance > 0.0 ? state_.current / flow.conductance : 0.0;
  state_.largest_density = 0.0;
  for (double& value : state_.density)
  {
    value *= scale;
    state_.largest_density = std::max(state_.largest_density, value);
  }
}

/// Finds resistance, current and voltage.
void Current::drive_through(const contact::Flow& flow, std::span<const double> pressure)
{
  constexpr double infinite = std::numeric_limits<double>::infinity();
  state_.resistance = flow.conductance > 0.0 ? 1.0 / flow.conductance : flow.conductance == 0.0 ? infinite : nan;
  const bool is_path = flow.conductance > 0.0 && std::isfinite(flow.conductance);
  if (!is_path) // open, or without resistance
  {
    const bool is_open = flow.conductance == 0.0;
    const double driven = drive_.current.value_or(0.0);
    state_.current = is_open ? 0.0 : drive_.voltage.value_or(0.0) > 0.0 ? infinite : driven;
    state_.voltage = is_open && driven > 0.0 ? infinite : is_open ? drive_.voltage.value_or(0.0) : 0.0;
    return;
  }
  if (!film_.empty())
  {
    state_.voltage = drive_.voltage ? *drive_.voltage : drive_.current.value_or(0.0) * state_.resistance;
    state_.current = drive_.current.value_or(state_.voltage * flow.conductance);
    return heat_up(flow, pressure);
  }
  // The factor of shape does not depend on temperature: the isotherms are those of the cold contact.
  const double shape = flow.conductance * spreading_;
  const std::optional<contact::HotContact> hot =
      drive_.voltage ? contact::hot_contact(bodies_, *drive_.voltage)
                     : contact::hot_contact_of_current(bodies_, drive_.current.value_or(0.0) / shape);
  state_.voltage = hot ? hot->voltage : nan;
  state_.current = drive_.current.value_or(hot ? shape * hot->flow : nan);
  state_.temperature = hot ? hot->temperature : nan;
  if (!hot || hot->flow > 0.0)
    state_.resistance = state_.voltage / state_.current;
}

/// Finds the temperature of a contact with a film.
void Current::heat_up(const contact::Flow& flow, std::span<const double> pressure)
{
  if (state_.voltage == 0.0)
    return;
  std::vector<double> density(flow.density), source(flow.density.size());
  for (std::size_t i = 0; i < density.size(); ++i)
  {
    density[i] *= state_.voltage;
    source[i] = film_[i] * density[i] * density[i];
  }
  std::array<contact::Constriction::Conductor, 2> bodies;
  for (std::size_t side = 0; side < bodies.size(); ++side)
  {
    const contact::HotConductor& body = bodies_[side];
    const double resistivity = body.resistivity_at(body.temperature);
    bodies[side] = {resistivity, body.conductivity_at(body.temperature), body.temperature};
  }
  const std::vector<double> temperature = constriction_.temperature(pressure, density, source, bodies);
  for (std::size_t i = 0; i < temperature.size(); ++i)
    if (pressure[i] > 0.0)
      state_.temperature = std::max(state_.temperature, temperature[i]);
}

void Current::report(EffectTotals& totals) const
{
  totals.contact_resistance = state_.resistance;
  totals.current = state_.current;
  totals.voltage = state_.voltage;
  totals.electric_power = state_.current == 0.0 ? 0.0 : state_.voltage * state_.current;
  totals.max_current_density = state_.largest_density;
  totals.current_spots = state_.spots;
  totals.largest_spot_share = state_.largest_share;
  totals.contact_temperature = state_.temperature;
  totals.min_contact_resistance = state_.least_resistance;
  totals.max_contact_temperature = state_.largest_temperature;
}

void Current::embed(const Effect& smaller_grids)
{
  state_ = dynamic_cast<const Current&>(smaller_grids).state_;
  for (std::vector<double>* field : {&state_.density, &state_.per_volt}) // found anew by the increment that follows
    field->assign(grid_.size(), 0.0);
}

} // namespace brinell::elastoplastic
