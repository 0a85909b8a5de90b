// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/current.hpp"

#include "brinell/elastoplastic/effects.hpp"
#include "brinell/foundation/embedding.hpp"
#include "foundation/nan.hpp"
#include "foundation/sharing.hpp"
#include "spot_softening.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace brinell::elastoplastic
{

contact::HotConductor conductor(const constitutive::Material& material)
{
  const constitutive::Electrical& electrical = *material.electrical;
  contact::HotConductor result{.resistivity = electrical.resistivity,
                               .temperature_coefficient = electrical.temperature_coefficient,
                               .temperature = material.temperature};
  if (!material.layers.empty()) // the resistivity at the surface, which grows like that of the substrate
    result.resistivity *= material.conductors().top() / electrical.resistivity_at(material.temperature);
  if (material.thermal)
    result.conductivity = material.thermal->conductivity;
  return result;
}

std::optional<double> CurrentDrive::at(double step, std::span<const double> values) const
{
  if (values.empty())
    return std::nullopt;
  const auto step_of = [&](std::size_t n) { return steps.empty() ? static_cast<double>(n) : steps.at(n); };
  std::size_t next = 0;
  while (next < values.size() && step_of(next) < step)
    ++next;
  if (next == 0 || next == values.size())
    return next == 0 ? values.front() : values.back();
  const double share = (step - step_of(next - 1)) / (step_of(next) - step_of(next - 1));
  return share == 1.0 ? values[next] : values[next - 1] + share * (values[next] - values[next - 1]);
}

bool CurrentDrive::drives() const
{
  const auto acts = [](double value) { return value > 0.0; };
  return std::any_of(current.begin(), current.end(), acts) || std::any_of(voltage.begin(), voltage.end(), acts);
}

std::unique_ptr<const halfspace::SurfaceCompliance>
layered_conductors(const halfspace::SurfaceCompliance& compliance,
                   const std::array<const constitutive::Material*, 2>& materials,
                   ConductiveStack (*stack)(const constitutive::Material&))
{
  if (materials[0]->layers.empty() && materials[1]->layers.empty())
    return nullptr;
  return std::make_unique<const halfspace::SurfaceCompliance>(halfspace::SurfaceCompliance::of_conductors(
      compliance.grid(), stack(*materials[0]), stack(*materials[1]), compliance.reference()));
}

Current::Current(const halfspace::SurfaceCompliance& compliance, const VolumeGrid& lower, const VolumeGrid& upper,
                 double modulus, const Materials& materials, const CurrentDrive& drive, const Wear* wear)
    : layered_(layered_conductors(compliance, materials,
                                  [](const constitutive::Material& material) { return material.conductors(); })),
      grid_(compliance.grid()), bodies_{conductor(*materials[0]), conductor(*materials[1])},
      spreading_(bodies_[0].resistivity_at(bodies_[0].temperature) + bodies_[1].resistivity_at(bodies_[1].temperature)),
      constriction_(layered_ ? contact::Constriction::of_layers(*layered_, spreading_, modulus)
                             : contact::Constriction(compliance, modulus)),
      drive_(drive), film_law_(grid_, lower.surface, upper.surface, drive.film), wear_(wear)
{
  film_state_ = film_law_.start();
  if (softens(*materials[0], drive, grid_) || softens(*materials[1], drive, grid_))
    spot_softening_ = std::make_unique<const SpotSoftening>(grid_, std::array{lower, upper}, materials, spreading_);
}

Current::~Current() = default;

bool Current::softens(const constitutive::Material& material, const CurrentDrive& drive, const SurfaceGrid& contact)
{
  return drive.drives() && material.is_plastic() && material.softening &&
         contact.is_periodic_x() == contact.is_periodic_y();
}

/// Factors on the yield stress by the present contact; none without a steady state, or where a body that softens would melt: that is
/// told, and not iterated on.
std::optional<std::array<std::vector<double>, 2>> Current::softening_by_current(const Interaction& found,
                                                                                const Placement& placement)
{
  const std::vector<double> film = film_after(found, placement);
  contact::Flow flow = constriction_.flow({found.pressure(), found.gap()}, spreading_, film, state_.per_volt);
  if (!std::isfinite(flow.conductance))
    return std::nullopt;
  if (flow.density.empty()) // without contact
    flow.density.resize(grid_.size());
  const auto hot = flow.conductance == 0.0 ? Hot{} : hot_contact(flow, film, found.step());
  if (!hot)
    return std::nullopt;
  const SpotSoftening& spots = *spot_softening_;
  if (hot->contact.temperature >= spots.melting_temperature())
    return std::nullopt;
  if (film.empty())
    return std::array{spots.factors(0, placement.lower, flow.density, bodies_, hot->contact),
                      spots.factors(1, placement.upper, flow.density, bodies_, hot->contact)};
  const auto [density, bodies, heat] = heat_of_film(*hot, flow, film, found.pressure());
  if (*std::max_element(heat.temperature.begin(), heat.temperature.end()) >= spots.melting_temperature())
    return std::nullopt;
  return std::array{spots.factors(0, placement.lower, density, heat.flux[0], bodies[0].resistivity, bodies_[0]),
                    spots.factors(1, placement.upper, density, heat.flux[1], bodies[1].resistivity, bodies_[1])};
}

bool Current::renews_softening(const Interaction& found, const Placement& placement, int turn)
{
  constexpr double tolerance = 1e-3; // of the factors on the yield stress
  constexpr int most_turns = 30, first_turns = 3;
  if (!spot_softening_)
    return false;
  const auto wanted = softening_by_current(found, placement);
  if (!wanted)
    return false;
  double change = 0.0;
  for (std::size_t side = 0; side < 2; ++side)
  {
    const std::vector<double>& now = (*wanted)[side];
    std::vector<double>& factors = softening_[side];
    factors.resize(now.size(), 1.0);
    // Under a current softer spots are larger and cooler: half of the change in later turns, so that it cannot swing.
    const double share = turn < first_turns ? 1.0 : 0.5;
    for (std::size_t i = 0; i < now.size(); ++i)
    {
      change = std::max(change, std::abs(now[i] - factors[i]));
      factors[i] += share * (now[i] - factors[i]);
    }
  }
  if (turn < most_turns)
    return change > tolerance;
  softening_error_ = std::max(softening_error_, change);
  return false;
}

void Current::restore()
{
  softening_ = state_.softening;
  softening_error_ = state_.softening_error;
}

void Current::begin(const Interaction& /*before*/)
{
  if (!heats())
    return;
  heat_.resize(state_.density.size());
  for (std::size_t i = 0; i < heat_.size(); ++i)
    heat_[i] = state_.heat(i);
}

/// Advances the film by an increment.
/// @returns its area resistance on the contact grid [ohm m^2]; empty without a film
std::vector<double> Current::film_after(const Interaction& found, const Placement& placement)
{
  next_film_ = film_state_;
  film_law_.advance(
      next_film_, found, placement,
      {wear_ ? wear_->depth(0) : std::span<const double>(), wear_ ? wear_->depth(1) : std::span<const double>()});
  return film_law_.resistance(next_film_, placement);
}

void Current::settle(const Interaction& found, const Placement& placement)
{
  next_ = state_;
  next_.softening = softening_;
  next_.softening_error = softening_error_;
  next_.film = film_after(found, placement);
  contact::Flow flow =
      constriction_.flow({found.pressure(), found.gap()}, spreading_, next_.film, std::move(next_.per_volt));
  next_.spots = static_cast<int>(flow.of_patch.size());
  next_.largest_share =
      flow.of_patch.empty() ? 0.0 : *std::max_element(flow.of_patch.begin(), flow.of_patch.end()) / flow.conductance;
  next_.temperature = std::max(bodies_[0].temperature, bodies_[1].temperature);
  clean_conductance_ = next_.film.empty() && !layered_ ? std::optional(flow.conductance * spreading_) : std::nullopt;
  find_density(flow, drive_through(flow, found));
  find_means(found.pressure());
  next_.per_volt = std::move(flow.density);
  next_.least_resistance = std::min(next_.least_resistance, next_.resistance);
  next_.largest_temperature = larger(next_.largest_temperature, next_.temperature);
  if (!heats())
    return;
  heat_.resize(grid_.size());
  for (std::size_t i = 0; i < heat_.size(); ++i)
    heat_[i] = 0.5 * (heat_[i] + next_.heat(i));
}

void Current::commit(const Interaction& /*found*/, const Placement& /*placement*/)
{
  state_ = std::move(next_);
  film_state_ = std::move(next_film_);
}

void Current::find_means(std::span<const double> pressure)
{
  double sum = 0.0;
  std::size_t touching = 0;
  for (std::size_t i = 0; i < next_.film.size(); ++i)
    if (pressure[i] > 0.0)
    {
      sum += next_.film[i];
      ++touching;
    }
  next_.mean_film = touching > 0 ? sum / static_cast<double>(touching) : 0.0;
}

/// Finds the density. Heat does not change the share of each spot; a contact without resistance has a uniform density.
void Current::find_density(const contact::Flow& flow, double current)
{
  const bool is_full = std::isinf(flow.conductance);
  const double whole = static_cast<double>(grid_.size()) * grid_.cell_area();
  next_.density = is_full ? std::vector<double>(grid_.size(), 1.0 / whole) : flow.whole_density(grid_.cell_area());
  next_.density.resize(grid_.size()); // without contact
  const double scale = is_full ? current : flow.conductance > 0.0 ? current / flow.conductance : 0.0;
  next_.largest_density = 0.0;
  for (double& value : next_.density)
  {
    value *= scale;
    next_.largest_density = std::max(next_.largest_density, value);
  }
}

/// The hot contact and its current. The factor of shape and the share of the film in the power do not depend on temperature:
/// without a film the isotherms are those of the cold contact. None without a steady state in which metals are solid or liquid.
std::optional<Current::Hot> Current::hot_contact(const contact::Flow& flow, std::span<const double> film,
                                                 double step) const
{
  double power = 0.0, sum = 0.0; // of the film and of all, for 1 V
  for (std::size_t i = 0; i < film.size(); ++i)
  {
    power += film[i] * flow.density[i] * flow.density[i];
    sum += flow.density[i];
  }
  constexpr double most = 1.0 - 1e-12;
  const double of_film = sum > 0.0 ? std::min(power / sum, most) : 0.0, of_bodies = 1.0 - of_film;
  const double shape = flow.conductance * spreading_ / of_bodies, resistance = spreading_ * of_film / of_bodies;
  constexpr double hottest = 6000.0; // [deg C]: tungsten boils at 5930
  if (const std::optional<double> voltage = drive_.at(step, drive_.voltage))
  {
    const contact::HotContact hot = contact::hot_contact(bodies_, *voltage, resistance);
    const double drop = hot.contact[0] - hot.contact[1]; // of the two the one that is large is exact
    return hot.temperature < hottest
               ? std::optional(Hot{hot, of_film > 0.5 ? drop * flow.conductance / of_film : shape * hot.flow})
               : std::nullopt;
  }
  const double current = drive_.at(step, drive_.current).value_or(0.0);
  const auto hot = contact::hot_contact_of_current(bodies_, current / shape, resistance);
  return hot && hot->temperature < hottest ? std::optional(Hot{*hot, current}) : std::nullopt;
}

/// Finds resistance, current and voltage.
/// @returns the current; without a steady state, which leaves some of them unknown, that of the cold contact
double Current::drive_through(const contact::Flow& flow, const Interaction& found)
{
  constexpr double infinite = std::numeric_limits<double>::infinity();
  next_.resistance = flow.conductance > 0.0 ? 1.0 / flow.conductance : flow.conductance == 0.0 ? infinite : nan;
  const std::optional<double> current = drive_.at(found.step(), drive_.current),
                              voltage = drive_.at(found.step(), drive_.voltage);
  next_.heating_voltage = 0.0;
  const bool is_path = flow.conductance > 0.0 && std::isfinite(flow.conductance);
  if (!is_path) // open, or without resistance
  {
    const bool is_open = flow.conductance == 0.0;
    const double driven = current.value_or(0.0);
    next_.current = is_open ? 0.0 : voltage.value_or(0.0) > 0.0 ? infinite : driven;
    next_.voltage = is_open && driven > 0.0 ? infinite : is_open ? voltage.value_or(0.0) : 0.0;
    return next_.current;
  }
  const std::optional<Hot> hot = hot_contact(flow, next_.film, found.step());
  const double cold = current.value_or(voltage.value_or(0.0) * flow.conductance);
  next_.voltage = voltage.value_or(hot ? hot->contact.voltage : nan);
  next_.current = current.value_or(hot ? hot->current : nan);
  next_.temperature = hot ? hot->contact.temperature : nan;
  if (!hot || hot->contact.flow > 0.0)
    next_.resistance = next_.voltage / next_.current;
  next_.heating_voltage = hot ? next_.voltage : cold / flow.conductance;
  if (hot && !next_.film.empty() && next_.voltage > 0.0)
    heat_up(*hot, flow, found.pressure());
  return hot ? next_.current : cold;
}

/// Heat of a contact with a film, in which the spots are not equally hot.
Current::FilmHeat Current::heat_of_film(const Hot& hot, const contact::Flow& flow, std::span<const double> film,
                                        std::span<const double> pressure)
{
  FilmHeat result{.density = flow.density, .bodies = {}, .heat = {}};
  std::vector<double> source(film.size());
  for (std::size_t i = 0; i < film.size(); ++i)
  {
    result.density[i] *= flow.conductance > 0.0 ? hot.current / flow.conductance : 0.0;
    source[i] = film[i] * result.density[i] * result.density[i];
  }
  result.bodies = {as_constant(bodies_, hot.contact, 0), as_constant(bodies_, hot.contact, 1)};
  result.heat = constriction_.heat(pressure, result.density, source, result.bodies);
  return result;
}

/// Finds the largest temperature of a contact with a film; the hottest point may lie within the worse conductor.
void Current::heat_up(const Hot& hot, const contact::Flow& flow, std::span<const double> pressure)
{
  const std::vector<double> temperature = heat_of_film(hot, flow, next_.film, pressure).heat.temperature;
  for (std::size_t i = 0; i < temperature.size(); ++i)
    if (pressure[i] > 0.0)
      next_.temperature = std::max(next_.temperature, temperature[i]);
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
  totals.film_resistance = state_.mean_film;
  totals.softening_error = state_.softening_error;
  totals.min_contact_resistance = state_.least_resistance;
  totals.max_contact_temperature = state_.largest_temperature;
}

void Current::exchange(Archive& archive)
{
  exchange_members(archive, state_);
  exchange_members(archive, film_state_);
  restore();
}

void Current::embed(const Effect& smaller_grids)
{
  const auto& smaller = dynamic_cast<const Current&>(smaller_grids);
  state_ = smaller.state_;
  film_state_ = film_law_.embedded(smaller.film_law_, smaller.film_state_);
  for (std::vector<double>& factors : state_.softening)
    factors.clear(); // found anew by the increment that follows
  for (std::vector<double>* field : {&state_.density, &state_.per_volt})
    field->assign(grid_.size(), 0.0);
  state_.film.clear();
  if (!smaller.state_.density.empty()) // the heat of the increment that follows begins with it; the guess is found anew
    embed_field(smaller.grid_, smaller.state_.density, grid_, state_.density);
  restore();
}

} // namespace brinell::elastoplastic
