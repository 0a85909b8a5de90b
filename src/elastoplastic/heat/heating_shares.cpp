// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "foundation/sharing.hpp"
#include "heat_partition.hpp"
#include "heating_state.hpp"

#include <algorithm>
#include <cmath>

/// How the heat that arises between the surfaces is shared by both bodies: docs/theory/heat.md.
namespace brinell::elastoplastic
{

Heating::State::BothResponses& Heating::State::combined_response()
{
  const std::array<halfspace::HeatMotion, 2> motions{sides[0].response().motion(), sides[1].response().motion()};
  const auto known = std::find_if(cached_responses.begin(), cached_responses.end(),
                                  [&](const BothResponses& both) { return both.motions == motions; });
  if (known != cached_responses.end())
  {
    cached_responses.splice(cached_responses.begin(), cached_responses, known);
    return cached_responses.front();
  }
  constexpr std::size_t max_cached = 6;
  if (cached_responses.size() == max_cached)
    cached_responses.pop_back();
  auto response =
      halfspace::HeatResponse::of_both(sides[0].response().temperature(), sides[1].response().temperature());
  auto scratch = response.make_scratch();
  cached_responses.push_front({motions, std::move(response), std::move(scratch)});
  return cached_responses.front();
}

/// Flux into the lower body where the surfaces touch and exchange heat: a share s of the friction heat q, plus the flux through
/// the conductance h,
///   q_lower = s q + h (T_upper + R_upper (q - q_lower) - T_lower - R_lower q_lower).
/// The equation is solved divided by h, so that without resistance (1/h = 0) both surfaces get the same temperature.
std::vector<double> Heating::State::exchanged_flux(const std::vector<double>& heat, std::span<const double> pressure,
                                                   Sharing sharing)
{
  HeatedSide &lower = sides[0], &upper = sides[1];
  const double resistance = settings.conductance ? 1.0 / *settings.conductance : 0.0;
  const double resisted_share = resistance * settings.share();
  std::vector<double> rhs(heat.size());
  const std::vector<bool> pressed = touching.find(heat, pressure);
  upper.response().find_rise(heat, rhs);
  double largest = 0.0;
  for (std::size_t i = 0; i < rhs.size(); ++i)
  {
    rhs[i] += upper.remaining()[i] - lower.remaining()[i] + resisted_share * heat[i];
    if (pressed[i])
      largest = std::max(largest, std::abs(rhs[i]));
  }
  if (largest == 0.0)
    return std::vector<double>(heat.size(), 0.0);
  BothResponses& both = combined_response();
  const FieldOperator apply_both = [&](std::span<const double> in, std::span<double> out)
  {
    both.response.apply(in, out, both.scratch);
    for (std::size_t i = 0; i < in.size(); ++i)
      out[i] += resistance * in[i];
  };
  const double tolerance =
      sharing == Sharing::fine ? 1e-6 : 1e-3; // relative to the temperature difference that the partition removes
  std::vector<double> flux = lower.share();
  if (!solve_in_cells(apply_both, rhs, pressed, tolerance * largest, flux))
    throw ConvergenceError(
        "the partition of the heat between the surfaces has not converged: their temperatures still differ");
  return flux;
}

/// Whether the surfaces have been lifted off each other, without sliding, by the end of the increment. Such an increment may
/// include the way back to the start of the track, during which no heat passes between them.
bool Heating::State::is_parted(std::span<const double> pressure) const
{
  return !slides && std::all_of(pressure.begin(), pressure.end(), [](double p) { return p == 0.0; });
}

/// Partitions the heat between the bodies and sets their fluxes.
/// @param heat  flux of heat into both bodies together [W/m^2]
/// @returns the largest change of the thermal displacement, summed over both sides [m]
double Heating::State::share_flux(const std::vector<double>& heat, std::span<const double> pressure, Sharing sharing)
{
  auto& [lower, upper] = sides;
  std::vector<double> into_lower(heat.size());
  if (!upper.conducts())
    into_lower = heat;
  else if (lower.conducts() && settings.exchanges() && !is_parted(pressure))
    into_lower = exchanged_flux(heat, pressure, sharing);
  else if (lower.conducts())
    std::transform(heat.begin(), heat.end(), into_lower.begin(), [&](double q) { return settings.share() * q; });
  std::vector<double> into_upper(heat.size());
  for (std::size_t i = 0; i < heat.size(); ++i)
    into_upper[i] = heat[i] - into_lower[i];
  return lower.set_share(into_lower) + upper.set_share(into_upper);
}

/// Adds the flux of a source between the surfaces: its power, distributed as the pressure; the mean of the beginning and the end
/// of the increment, as for friction.
/// @returns the power that acts [W]: zero where the surfaces do not touch
double Heating::State::add_source_between(std::span<const double> pressure, std::vector<double>& heat) const
{
  if (!is_source_between())
    return 0.0;
  const double before = sum(pressure_before), now = sum(pressure);
  const int ends = (before > 0.0 ? 1 : 0) + (now > 0.0 ? 1 : 0);
  if (ends == 0)
    return 0.0;
  const double each = *settings.source.power / (ends * contact.cell_area());
  for (std::size_t i = 0; i < heat.size(); ++i)
    heat[i] += each * ((before > 0.0 ? pressure_before[i] / before : 0.0) + (now > 0.0 ? pressure[i] / now : 0.0));
  return *settings.source.power;
}

/// Adds the flux of effects between the surfaces.
/// @returns their power [W]
double Heating::State::add_effects(std::span<const double> of_effects, std::vector<double>& heat) const
{
  if (!do_effects_heat)
    return 0.0;
  for (std::size_t i = 0; i < of_effects.size(); ++i)
    heat[i] += of_effects[i];
  return sum(of_effects) * contact.cell_area();
}

/// Adds heat that is not applied as a flux to the totals of the bodies, by the given partition [J].
void Heating::State::add_heat_without_flux(double heat)
{
  const double lower = !sides[1].conducts() ? 1.0 : sides[0].conducts() ? settings.share() : 0.0;
  sides[0].add_heat_without_flux(lower * heat);
  sides[1].add_heat_without_flux((1.0 - lower) * heat);
}

/// Flux of heat into both bodies together [W/m^2], from the friction work per area of the increment [J/m^2].
std::vector<double> Heating::State::power_of(std::span<const double> heat_per_area) const
{
  std::vector<double> flux(heat_per_area.size());
  for (std::size_t i = 0; i < flux.size(); ++i)
    flux[i] = settings.fraction * heat_per_area[i] / duration;
  return flux;
}

/// Thermal displacement along the surface, lower minus upper body [m].
std::vector<double> Heating::State::relative_displacement(std::size_t axis) const
{
  std::vector<double> upper(contact.size()), relative(contact.size());
  sides[0].add_along(axis, relative);
  sides[1].add_along(axis, upper);
  for (std::size_t i = 0; i < relative.size(); ++i)
    relative[i] -= upper[i];
  return relative;
}

/// Work of the thermal displacement along the surfaces against the shear in the increment [J].
/// @param shears  means of the increment [Pa]
double Heating::State::work_along(const std::array<std::span<const double>, 2>& shears) const
{
  double work = 0.0;
  for (std::size_t axis = 0; axis < shears.size(); ++axis)
  {
    if (shears[axis].empty())
      continue;
    const std::vector<double> now = relative_displacement(axis);
    for (std::size_t i = 0; i < now.size(); ++i)
      work -= shears[axis][i] * (now[i] - along_before[axis][i]);
  }
  return work * contact.cell_area();
}

/// After the last partition of an increment: counts the cells that it held in contact, and the heat through them.
void Heating::State::count_held()
{
  totals.most_held = std::max(totals.most_held, touching.held());
  const double per_flux = duration * contact.cell_area();
  const std::span<const double> lower = sides[0].share(), upper = sides[1].share();
  for (std::size_t i = 0; i < contact.size(); ++i)
  {
    const double passed = std::max(std::abs(lower[i]), std::abs(upper[i])) * per_flux;
    totals.passed += passed;
    totals.held += touching.is_held_open(i) ? passed : 0.0;
  }
}

} // namespace brinell::elastoplastic
