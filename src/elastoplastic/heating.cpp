// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/heating.hpp"

#include "brinell/foundation/error.hpp"
#include "foundation/sharing.hpp"
#include "heat_partition.hpp"
#include "heated_side.hpp"
#include "touching_cells.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <list>

namespace brinell::elastoplastic
{

namespace
{

/// Arguments of the constructor, from which the sides are built again when a checkpoint has other thermal grids.
struct Plan
{
  std::array<Heating::Partner, 2> bodies; ///< with the grids at the start of the run
  HeatedRun run;
  Twin twin;
  HeatNumerics numerics;
};

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

} // namespace

struct Heating::State
{
  SurfaceGrid contact;
  Plan plan;
  std::array<HeatedSide, 2> sides;
  double copies; ///< number of bodies that each solved body represents: 2 for twins
  HeatSettings settings = plan.run.settings;
  std::vector<double> imposed = flux_on(settings.source, contact); ///< flux of a source on one body [W/m^2]
  /// Response of the sum of both surface temperatures to a flux into both bodies, for a pair of motions.
  struct BothResponses
  {
    std::array<halfspace::HeatMotion, 2> motions;
    halfspace::HeatResponse response;
    halfspace::HeatResponse::Scratch scratch;
  };
  std::list<BothResponses> cached_responses{}; ///< cache, most recently used first
  // Of the current increment
  double duration = 0.0, slid = 0.0;
  std::vector<double> shear_at_start{}, pressure_before{};
  bool is_source_on = false; ///< whether a source acts
  TouchingCells touching{};
  // Since the start [J]
  double heat_of_friction = 0.0, heat_of_source = 0.0, work_on_pressure = 0.0;
  int most_held = 0; ///< largest number of held cells in an increment
  double heat_passed = 0.0,
         heat_of_held = 0.0; ///< through the surfaces, and the part of it through held cells that are open

  [[nodiscard]] bool is_source_between() const
  {
    return is_source_on && settings.source.shape == HeatSource::Shape::contact;
  }
  [[nodiscard]] double add_source_between(std::span<const double> pressure, std::vector<double>& heat) const;
  void add_heat_without_flux(double heat);
  void count_held();
  [[nodiscard]] bool is_parted(std::span<const double> pressure) const;
  [[nodiscard]] BothResponses& combined_response();
  [[nodiscard]] double share_flux(const std::vector<double>& heat, std::span<const double> pressure, Sharing sharing);
  [[nodiscard]] std::vector<double> exchanged_flux(const std::vector<double>& heat, std::span<const double> pressure,
                                                   Sharing sharing);
};

namespace
{

void require_conductors(const std::array<Heating::Partner, 2>& bodies)
{
  if (!bodies[0].material.thermal && !bodies[1].material.thermal)
    throw InputError("Heating: neither body has thermal constants");
  for (const Heating::Partner& body : bodies)
    if (!body.material.thermal && !body.material.elastic.is_rigid())
      throw InputError("Heating: a body that deforms has no thermal constants");
}

std::array<HeatedSide, 2> sides_of(const SurfaceGrid& contact, const Plan& plan)
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
  return {HeatedSide(contact, bodies[0].material, lower, false, reference),
          HeatedSide(contact, bodies[1].material, is_twin ? lower : heat_of(bodies[1]), is_twin, reference)};
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
  const Plan plan{bodies, run, twin, numerics};
  state_ = make_hidden<State>(contact, plan, sides_of(contact, plan), twin == Twin::none ? 1.0 : 2.0);
}

void Heating::begin(const Start& start)
{
  State& s = *state_;
  s.duration = start.duration;
  s.slid = start.slid;
  s.shear_at_start.assign(start.shear_at_start.begin(), start.shear_at_start.end());
  s.pressure_before.assign(start.pressure_before.begin(), start.pressure_before.end());
  s.is_source_on = start.is_source_on && s.settings.source.exists();
  s.touching.begin(s.contact.size());
  for (std::size_t side = 0; side < 2 && s.duration > 0.0; ++side)
  {
    const bool is_heated = s.is_source_on && s.settings.source.is_on_body() && s.settings.source.side() == side;
    s.sides[side].begin(start.grids[side], start.places[side], start.columns[side], s.duration,
                        start.slid > 0.0 || s.is_source_between(),
                        is_heated ? std::span<const double>(s.imposed) : std::span<const double>());
  }
}

Heating::State::BothResponses& Heating::State::combined_response()
{
  const std::array<halfspace::HeatMotion, 2> motions{sides[0].motion(), sides[1].motion()};
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
  auto response = halfspace::HeatResponse::of_both(sides[0].temperature_response(), sides[1].temperature_response());
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
  upper.find_rise(heat, rhs);
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
  return slid == 0.0 && std::all_of(pressure.begin(), pressure.end(), [](double p) { return p == 0.0; });
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

/// Adds heat that is not applied as a flux to the totals of the bodies, by the given partition [J].
void Heating::State::add_heat_without_flux(double heat)
{
  const double lower = !sides[1].conducts() ? 1.0 : sides[0].conducts() ? settings.share() : 0.0;
  sides[0].add_heat_without_flux(lower * heat);
  sides[1].add_heat_without_flux((1.0 - lower) * heat);
}

/// After the last partition of an increment: counts the cells that it held in contact, and the heat through them.
void Heating::State::count_held()
{
  most_held = std::max(most_held, touching.held());
  const double per_flux = duration * contact.cell_area();
  const std::span<const double> lower = sides[0].share(), upper = sides[1].share();
  for (std::size_t i = 0; i < contact.size(); ++i)
  {
    const double passed = std::max(std::abs(lower[i]), std::abs(upper[i])) * per_flux;
    heat_passed += passed;
    heat_of_held += touching.is_held_open(i) ? passed : 0.0;
  }
}

double Heating::follow(std::span<const double> pressure, std::span<const double> shear, Sharing sharing)
{
  State& s = *state_;
  if (s.duration == 0.0)
    return 0.0;
  // Mean of the shear at the beginning and at the end of the increment: second order in the step.
  const double factor = 0.5 * s.settings.fraction * s.slid / s.duration;
  std::vector<double> heat(pressure.size());
  for (std::size_t i = 0; i < heat.size(); ++i)
    heat[i] = factor * (std::abs(s.shear_at_start[i]) + std::abs(shear[i]));
  static_cast<void>(s.add_source_between(pressure, heat));
  return s.share_flux(heat, pressure, sharing);
}

bool Heating::is_steady() const
{
  return state_->settings.regime == HeatRegime::steady;
}

void Heating::add_to_gap(std::span<double> gap) const
{
  for (const HeatedSide& side : state_->sides)
    side.add_displacement(gap);
}

void Heating::settle(std::span<const double> pressure, std::span<const double> heat_per_area)
{
  State& s = *state_;
  if (s.duration == 0.0)
    return;
  std::vector<double> heat(heat_per_area.size());
  for (std::size_t i = 0; i < heat.size(); ++i)
    heat[i] = s.settings.fraction * heat_per_area[i] / s.duration;
  const double total = sum(heat) * s.duration * s.contact.cell_area();
  s.heat_of_friction += total;
  if (is_steady() && s.slid == 0.0)
  {
    // Without sliding, heat comes only from work that the deformation returns; it is counted, but is not a steady source.
    s.add_heat_without_flux(total);
    std::fill(heat.begin(), heat.end(), 0.0);
  }
  double power = s.add_source_between(pressure, heat);
  if (s.is_source_on)
    power += sum(s.imposed) * s.contact.cell_area();
  s.heat_of_source += power * s.duration;
  static_cast<void>(s.share_flux(heat, pressure, Sharing::fine));
  s.count_held();
  for (HeatedSide& side : s.sides)
    side.settle();
  for (HeatedSide& side : s.sides)
    if (side.conducts() && !side.is_mirrored())
      s.work_on_pressure += s.copies * side.heat().work_against(side.on_body(pressure, "pressure"));
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
  return state_->heat_of_friction;
}

double Heating::heat_of_source() const
{
  return state_->heat_of_source;
}

double Heating::heat_of_plastic_work() const
{
  double heat = 0.0;
  for (const HeatedSide& side : state_->sides)
    if (side.conducts() && !side.is_mirrored())
      heat += state_->copies * side.heat().heat_of_plastic_work();
  return heat;
}

double Heating::work_on_pressure() const
{
  return state_->work_on_pressure;
}

int Heating::most_held_cells() const
{
  return state_->most_held;
}

double Heating::share_of_held_cells() const
{
  return state_->heat_passed > 0.0 ? state_->heat_of_held / state_->heat_passed : 0.0;
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

void Heating::exchange(Archive& archive)
{
  State& s = *state_;
  const std::array<Partner, 2> before = s.plan.bodies;
  exchange_grids(archive, s.plan.bodies);
  if (s.plan.bodies[0].grid != before[0].grid || s.plan.bodies[1].grid != before[1].grid)
  {
    s.sides = sides_of(s.contact, s.plan);
    s.cached_responses.clear();
  }
  archive("lower", s.sides[0]);
  archive("upper", s.sides[1]);
  archive("heat_of_friction", s.heat_of_friction);
  archive("heat_of_source", s.heat_of_source);
  archive("work_on_pressure", s.work_on_pressure);
  archive("most_held_cells", s.most_held, 0, std::numeric_limits<int>::max() - 1);
  archive("heat_passed", s.heat_passed);
  archive("heat_of_held", s.heat_of_held);
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
