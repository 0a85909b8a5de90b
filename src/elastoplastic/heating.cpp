// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/heating.hpp"

#include "brinell/foundation/error.hpp"
#include "foundation/sharing.hpp"
#include "heat_partition.hpp"
#include "heated_side.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <list>

namespace brinell::elastoplastic
{

namespace
{

/// Where heat passes between the surfaces in one increment: where they touch, and on cells that cannot tell. A cell at the edge that
/// opens by the heat that it gets when it touches, and closes without, has no state in which it does the one or the other for good.
/// Once it has parted so often that this is clear, it is taken as touching until the increment ends: it is open by less than the heat
/// displaces it.
class TouchingCells
{
public:
  void begin(std::size_t cells)
  {
    was_touching_.assign(cells, false);
    partings_.assign(cells, 0);
  }
  [[nodiscard]] std::vector<bool> find(std::span<const double> heat, std::span<const double> pressure)
  {
    std::vector<bool> touching(heat.size());
    for (std::size_t i = 0; i < touching.size(); ++i)
    {
      const bool touches = pressure[i] > 0.0 || heat[i] != 0.0; // or has touched at the beginning of the increment
      partings_[i] += was_touching_[i] && !touches ? 1 : 0;
      was_touching_[i] = touches;
      touching[i] = touches || partings_[i] >= most_partings;
    }
    return touching;
  }
  /// Cells that are taken as touching in this increment whether they do or not.
  [[nodiscard]] int held() const
  {
    return static_cast<int>(
        std::count_if(partings_.begin(), partings_.end(), [](int partings) { return partings >= most_partings; }));
  }

private:
  static constexpr int most_partings = 3;
  std::vector<bool> was_touching_;
  std::vector<int> partings_; ///< in the increment
};

} // namespace

namespace
{

/// What the heat of both bodies is made for, and kept on.
struct Plan
{
  std::array<Heating::Partner, 2> bodies; ///< as they were when the run began
  HeatedRun run;
  Twin twin;
  HeatNumerics numerics;
};

/// The grids of a run that is taken up may have grown before, but not those of the heat, which are made from the first ones.
void exchange_grids(Archive& archive, std::array<Heating::Partner, 2>& bodies)
{
  constexpr int most = 1 << 20;
  for (const auto& [name, body] : {std::pair{"lower", &bodies[0]}, {"upper", &bodies[1]}})
  {
    const SurfaceGrid now = body->grid.surface;
    for (const auto& [part, cells] : {std::pair{".columns", &body->grid.surface.nx},
                                      {".rows", &body->grid.surface.ny},
                                      {".layers", &body->grid.nz}})
      archive(std::string(name) + part, *cells, 1, most);
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
  double twins; ///< bodies for which one that is solved stands
  HeatSettings settings = plan.run.settings;
  /// What a flux into both bodies adds to the sum of their temperatures, for a pair of motions.
  struct BothResponses
  {
    std::array<halfspace::HeatMotion, 2> motions;
    halfspace::HeatResponse response;
    halfspace::HeatResponse::Scratch scratch;
  };
  std::list<BothResponses> planned{}; ///< the one of the last use is the first
  // Of the increment at hand
  double duration = 0.0, slid = 0.0;
  std::vector<double> shear_before{};
  TouchingCells touching{};
  // Since the start [J]
  double heat_of_friction = 0.0, work_on_pressure = 0.0;
  int most_held = 0; ///< in an increment

  void count_apart(double heat);
  [[nodiscard]] BothResponses& of_both();
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
  const Plan plan{bodies, run, twin, numerics};
  state_ = make_hidden<State>(contact, plan, sides_of(contact, plan), twin == Twin::none ? 1.0 : 2.0);
}

void Heating::begin(const Start& start)
{
  State& s = *state_;
  s.duration = start.duration;
  s.slid = start.slid;
  s.shear_before.assign(start.shear_before.begin(), start.shear_before.end());
  s.touching.begin(s.contact.size());
  for (std::size_t side = 0; side < 2 && s.duration > 0.0; ++side)
    s.sides[side].begin(start.grids[side], start.places[side], start.columns[side], s.duration, start.slid > 0.0);
}

Heating::State::BothResponses& Heating::State::of_both()
{
  const std::array<halfspace::HeatMotion, 2> motions{sides[0].motion(), sides[1].motion()};
  const auto known =
      std::find_if(planned.begin(), planned.end(), [&](const BothResponses& both) { return both.motions == motions; });
  if (known != planned.end())
  {
    planned.splice(planned.begin(), planned, known);
    return planned.front();
  }
  constexpr std::size_t most = 6;
  if (planned.size() == most)
    planned.pop_back();
  auto response = halfspace::HeatResponse::of_both(sides[0].temperature_response(), sides[1].temperature_response());
  auto scratch = response.make_scratch();
  planned.push_front({motions, std::move(response), std::move(scratch)});
  return planned.front();
}

/// The flux into the lower body where they touch, of heat that passes between the surfaces: a share s of it, and what the
/// conductance h lets through,
///   q_lower = s q + h (T_upper + R_upper (q - q_lower) - T_lower - R_lower q_lower),
/// divided by h, so that without a resistance both have one temperature.
std::vector<double> Heating::State::exchanged_flux(const std::vector<double>& heat, std::span<const double> pressure,
                                                   Sharing sharing)
{
  HeatedSide &lower = sides[0], &upper = sides[1];
  const double resistance = settings.conductance ? 1.0 / *settings.conductance : 0.0;
  const double of_heat = resistance * settings.share();
  std::vector<double> rhs(heat.size());
  const std::vector<bool> pressed = touching.find(heat, pressure);
  upper.warm(heat, rhs);
  double largest = 0.0;
  for (std::size_t i = 0; i < rhs.size(); ++i)
  {
    rhs[i] += upper.remaining()[i] - lower.remaining()[i] + of_heat * heat[i];
    if (pressed[i])
      largest = std::max(largest, std::abs(rhs[i]));
  }
  if (largest == 0.0)
    return std::vector<double>(heat.size(), 0.0);
  BothResponses& both = of_both();
  const FieldOperator warm_both = [&](std::span<const double> in, std::span<double> out)
  {
    both.response.apply(in, out, both.scratch);
    for (std::size_t i = 0; i < in.size(); ++i)
      out[i] += resistance * in[i];
  };
  const double tolerance = sharing == Sharing::fine ? 1e-6 : 1e-3; // of the difference that the shares make up for
  std::vector<double> flux = lower.flux();
  if (!solve_in_cells(warm_both, rhs, pressed, tolerance * largest, flux))
    throw ConvergenceError("the surfaces have not come to the temperatures at which they share the heat");
  return flux;
}

/// Shares the heat, a flux [W/m^2]. @returns the largest change of the displacement [m]
double Heating::State::share_flux(const std::vector<double>& heat, std::span<const double> pressure, Sharing sharing)
{
  auto& [lower, upper] = sides;
  std::vector<double> into_lower(heat.size());
  if (!upper.conducts())
    into_lower = heat;
  else if (lower.conducts() && settings.exchanges())
    into_lower = exchanged_flux(heat, pressure, sharing);
  else if (lower.conducts())
    std::transform(heat.begin(), heat.end(), into_lower.begin(), [&](double q) { return settings.share() * q; });
  std::vector<double> into_upper(heat.size());
  for (std::size_t i = 0; i < heat.size(); ++i)
    into_upper[i] = heat[i] - into_lower[i];
  return lower.set_flux(into_lower) + upper.set_flux(into_upper);
}

/// Heat that warms nothing, in the shares that are given [J].
void Heating::State::count_apart(double heat)
{
  const double lower = !sides[1].conducts() ? 1.0 : sides[0].conducts() ? settings.share() : 0.0;
  sides[0].count_apart(lower * heat);
  sides[1].count_apart((1.0 - lower) * heat);
}

double Heating::follow(std::span<const double> pressure, std::span<const double> shear, Sharing sharing)
{
  State& s = *state_;
  if (s.duration == 0.0)
    return 0.0;
  // The mean of the shear at the beginning and at the end: second order in the step.
  const double factor = 0.5 * s.settings.fraction * s.slid / s.duration;
  std::vector<double> heat(pressure.size());
  for (std::size_t i = 0; i < heat.size(); ++i)
    heat[i] = factor * (std::abs(s.shear_before[i]) + std::abs(shear[i]));
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
  const double all = sum(heat) * s.duration * s.contact.cell_area();
  s.heat_of_friction += all;
  if (is_steady() && s.slid == 0.0)
  {
    // What the shear gives back where nothing slides is heat, but no source that could have been there always.
    s.count_apart(all);
    std::fill(heat.begin(), heat.end(), 0.0);
  }
  static_cast<void>(s.share_flux(heat, pressure, Sharing::fine));
  s.most_held = std::max(s.most_held, s.touching.held());
  for (HeatedSide& side : s.sides)
    side.settle();
  for (HeatedSide& side : s.sides)
    if (side.conducts() && !side.is_mirrored())
      s.work_on_pressure += s.twins * side.heat().work_against(side.on_body(pressure, "pressure"));
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

double Heating::heat_of_plastic_work() const
{
  double heat = 0.0;
  for (const HeatedSide& side : state_->sides)
    if (side.conducts() && !side.is_mirrored())
      heat += state_->twins * side.heat().heat_of_plastic_work();
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
  const std::array<Partner, 2> planned = s.plan.bodies;
  exchange_grids(archive, s.plan.bodies);
  if (s.plan.bodies[0].grid != planned[0].grid || s.plan.bodies[1].grid != planned[1].grid)
  {
    s.sides = sides_of(s.contact, s.plan);
    s.planned.clear();
  }
  archive("lower", s.sides[0]);
  archive("upper", s.sides[1]);
  archive("heat_of_friction", s.heat_of_friction);
  archive("work_on_pressure", s.work_on_pressure);
  archive("most_held_cells", s.most_held, 0, std::numeric_limits<int>::max() - 1);
}

void Heating::move_to(const SurfaceGrid& contact)
{
  for (HeatedSide& side : state_->sides)
    side.move_to(contact);
  state_->planned.clear();
  state_->contact = contact;
}

} // namespace brinell::elastoplastic
