// SPDX-License-Identifier: BSD-3-Clause
#include "stepper.hpp"

#include "simulation/plan/heat.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/simulation/first_yield.hpp"
#include "coverage.hpp"
#include "foundation/nan.hpp"
#include "naming_extent.hpp"
#include "simulation/plan/device.hpp"
#include "simulation/plan/grid_layout.hpp"
#include "simulation/plan/memory.hpp"
#include "simulation/plan/plan_end.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace brinell::simulation
{

using elastoplastic::CoupledContact;
using elastoplastic::IncrementReport;
using elastoplastic::Integration;

namespace
{

/// Checks the grids of a stored state. They may have grown, or come from a plan with another extent, but must have the same
/// centres.
void require_same_middles(const Plan& plan, const Plan& stored)
{
  constexpr int max_cells = 1 << 20;
  for (const auto& [now, before] : {std::pair{stored.contact.nx, plan.contact.nx},
                                    {stored.contact.ny, plan.contact.ny},
                                    {stored.lower.surface.nx, plan.lower.surface.nx},
                                    {stored.upper.surface.nx, plan.upper.surface.nx}})
    if (now < 1 || now > max_cells || (now - before) % 2 != 0)
      throw InputError(fmt::format("the stored state has a grid of {} columns or rows, which does not fit", now));
  for (const int layers : {stored.lower.nz, stored.upper.nz})
    if (layers < 1 || layers > max_cells)
      throw InputError(fmt::format("the stored state has a grid of {} layers, which does not fit", layers));
}

} // namespace

Stepper::Setup setup_of(const PairCase& c, const Centre& start, const halfspace::HeatTimes& heat_times)
{
  Stepper::Setup setup{.lower = c.lower.material,
                       .upper = c.upper.material,
                       .distance = [&c](double x, double y)
                       { return height(c.lower.shape, x, y) + height(c.upper.shape, x, y); },
                       .solver = c.solver,
                       .start = start,
                       .lower_texture = c.lower.texture,
                       .upper_texture = c.upper.texture,
                       .films = {c.lower.film, c.upper.film},
                       .inclusions = {c.lower.inclusions, c.upper.inclusions}};
  setup.sliding = {.friction = c.friction, .effects = c};
  if (is_heated(c))
    setup.sliding.heat = {c.heat, heat_times};
  return setup;
}

namespace
{

/// Heat is computed in the same waves whether or not there are fields within the bodies.
Stepper::Setup with_layers(Stepper::Setup setup, const Plan& plan)
{
  if (setup.sliding.heat)
    setup.sliding.heat->layers = plan.layers;
  return setup;
}

} // namespace

Stepper::Stepper(const Plan& plan, Setup setup)
    : setup_(with_layers(std::move(setup), plan)), plan_(plan), lattice_(plan, setup_.start),
      device_(device_of(setup_.solver.device, setup_.lower, setup_.upper, has_inclusions(),
                        setup_.watch.ranks && !setup_.watch.ranks->is_alone())),
      pair_(make_pair()), distance_(plan.contact.size()),
      distance_x0_(nan), depths_{std::vector<double>(plan.contact.size()), std::vector<double>(plan.contact.size())}
{
}

std::unique_ptr<CoupledContact> Stepper::make_pair() const
{
  const auto on_lower = [&](const Texture& texture)
  { return textured(texture, plan_.lower.surface, lattice_.lower_origin(), setup_.beside.lower); };
  const auto on_upper = [&](const Texture& texture)
  { return textured(texture, plan_.upper.surface, lattice_.upper_origin(), setup_.beside.upper); };
  elastoplastic::Sliding sliding = setup_.sliding;
  std::array<std::vector<double>, 2>& cover = sliding.effects.current.film.cover;
  cover = {on_lower(setup_.films[0]), on_upper(setup_.films[1])};
  for (std::vector<double>& thickness : cover)
    for (double& value : thickness)
      value = -value; // heights point out of the body
  auto pair = std::make_unique<CoupledContact>(
      plan_.contact, plan_.lower, plan_.upper, setup_.lower, setup_.upper, plan_.scales, setup_.solver, plan_.twin,
      elastoplastic::Textures{on_lower(setup_.lower_texture), on_upper(setup_.upper_texture),
                              in_cells(setup_.inclusions[0], plan_.lower, lattice_.lower_origin(),
                                       setup_.beside.lower + plan_.lower.surface.y(0)),
                              in_cells(setup_.inclusions[1], plan_.upper, lattice_.upper_origin(),
                                       setup_.beside.upper + plan_.upper.surface.y(0))},
      plan_.reference, sliding, setup_.watch.ranks, device_);
  for (std::size_t side = 0; side < 2; ++side)
    if (setup_.follows_stress[side])
      pair->keep_trace(side);
  return pair;
}

void Stepper::exchange(Archive& archive)
{
  Plan stored = plan_;
  for (const auto& [name, cells] : {std::pair{"contact.nx", &stored.contact.nx},
                                    {"ny", &stored.contact.ny},
                                    {"lower.nx", &stored.lower.surface.nx},
                                    {"upper.nx", &stored.upper.surface.nx},
                                    {"lower.nz", &stored.lower.nz},
                                    {"upper.nz", &stored.upper.nz}})
    archive(std::string("grid.") + name, *cells);
  if (archive.gives())
  {
    stored.lower.surface.ny = stored.upper.surface.ny = stored.contact.ny;
    require_same_middles(plan_, stored);
    stored.memory_bytes = memory_of(stored);
    if (!(stored.memory_bytes <= setup_.watch.available_memory))
      throw InputError(fmt::format("the stored state needs {:.3g} GB; available are {:.3g} GB",
                                   1e-9 * stored.memory_bytes, 1e-9 * setup_.watch.available_memory));
    move_to(stored);
  }
  archive("pair", *pair_);
  archive("split_increments", split_increments_, 0, std::numeric_limits<int>::max() - 1);
  archive("centre.lower", centre_.lower);
  archive("centre.upper", centre_.upper);
  archive("time", time_);
  archive("slid", slid_);
  archive("steps", steps_, 0, std::numeric_limits<int>::max() - 1);
  archive.list("grid_changes", grid_changes_);
  archive("coverage", coverage_);
  if (has_inclusions())
  {
    archive("inclusion_iterations", inclusions_.iterations, 0, std::numeric_limits<long>::max());
    archive("inclusion_residual", inclusions_.largest_residual);
  }
}

int Stepper::advance(const std::function<Target(double)>& way, double finest, const std::string& where,
                     const std::function<void()>& at_onset)
{
  const auto path = [&](double t)
  {
    Target target = way(t);
    target.step = steps_ - 1 + t;
    return target;
  };
  evaluations_ = 0;
  where_ = where;
  const auto work_so_far = [this] { return pair_->sliding() != nullptr ? pair_->sliding()->work() : 0.0; };
  const double work_before = work_so_far();
  shear_force_at_start_.reset();
  const Target end = path(1.0);
  const double from = pair_->sliding() != nullptr && end.slides ? pair_->sliding()->share_of(end.along) : 1.0;
  if (const int increments = from < 1.0 ? onset_increments(from) : 0; increments > 0)
  {
    raise_friction(path(0.0), end.along, from, increments);
    if (at_onset)
      at_onset();
  }
  if (!attempt(end))
  {
    ++split_increments_;
    bisect(path, 0.0, 1.0, finest);
  }
  ++steps_;
  shear_work_ = work_so_far() - work_before;
  extend(coverage_, *pair_);
  return evaluations_;
}

/// Number of increments in which friction is raised to its full value; 0 where this needs none at rest.
/// @param from  present share of friction
int Stepper::onset_increments(double from) const
{
  double strength = std::numeric_limits<double>::infinity(); // in shear, where a body is weakest
  for (const constitutive::Material* material : {&setup_.lower, &setup_.upper})
    for (const auto& law : material->laws())
      if (law)
        strength = std::min(strength, smallest_yield_factor(*material) * constitutive::initial_yield_stress(*law) /
                                          std::sqrt(3.0));
  const std::span<const double> pressure = pair_->pressure();
  const double peak = *std::max_element(pressure.begin(), pressure.end());
  const double parts = setup_.solver.onset_increments;
  const double shear = setup_.sliding.friction.coefficient * peak;
  if (!(std::isfinite(strength) && shear > 0.0 && parts > 0.0))
    return 0;
  constexpr double most = 4.0; // times the shear yield stress: beyond it the surface limits the shear
  const double growth = std::min((1.0 - from) * shear / strength, most);
  return std::max(1, static_cast<int>(std::ceil(growth * parts)));
}

/// Raises friction to its full value at the present place, in equal parts.
/// @param start  the present state, as a target
/// @param from   present share of friction
void Stepper::raise_friction(const Target& start, const contact::TangentialDrive& along, double from, int increments)
{
  const auto path = [&](double t)
  {
    Target target = start;
    target.along = along;
    target.slides = true;
    target.share_at_rest = t == 1.0 ? 1.0 : from + t * (1.0 - from);
    return target;
  };
  constexpr double finest = 1.0 / 64; // of an increment
  bool is_split = false;
  for (int i = 0; i < increments; ++i)
  {
    const double begin = static_cast<double>(i) / increments, end = static_cast<double>(i + 1) / increments;
    if (attempt(path(end)))
      continue;
    is_split = true;
    bisect(path, begin, end, finest / increments);
  }
  split_increments_ += is_split ? 1 : 0;
}

void Stepper::bisect(const std::function<Target(double)>& path, double begin, double end, double finest)
{
  if (end - begin < 1.5 * finest)
    return descend(path(end));
  const double middle = 0.5 * (begin + end);
  for (const auto& [from, to] : {std::pair{begin, middle}, {middle, end}})
    if (!attempt(path(to)))
      bisect(path, from, to, finest);
}

IncrementReport Stepper::solved(const Target& target, const elastoplastic::Strategy& strategy)
{
  for (;;)
  {
    const Frame frame = lattice_.frame(target.centre);
    place(frame);
    elastoplastic::Motion motion{.along = target.along,
                                 .slides = target.slides,
                                 .slid = target.slid - slid_,
                                 .duration = target.time - time_,
                                 .is_put_down = target.is_put_down,
                                 .returns = target.returns,
                                 .step = target.step,
                                 .share_at_rest = target.share_at_rest};
    if (target.passing)
      motion.moved = {(*target.passing)[0] * motion.duration, (*target.passing)[1] * motion.duration};
    else if (!motion.is_put_down)
      motion.moved = {target.centre.lower - centre_.lower, target.centre.upper - centre_.upper};
    const IncrementReport report =
        naming_extent([&] { return pair_->advance(distance_, target.drive, frame.placement, strategy, motion); });
    evaluations_ += report.evaluations;
    inclusions_.iterations += report.inclusion_iterations;
    if (report.converged)
    {
      inclusions_.largest_residual = std::max(inclusions_.largest_residual, report.inclusion_residual);
      centre_ = target.centre;
      time_ = target.time;
      slid_ = target.slid;
      if (!target.share_at_rest && !shear_force_at_start_ && pair_->sliding() != nullptr)
        shear_force_at_start_ = pair_->sliding()->force_at_start();
    }
    if (!report.outgrown.any())
      return report;
    grow(report.outgrown);
  }
}

/// Tries one accelerated increment: first with the stiffness of a single cell, then with the upper bound of all stiffnesses.
/// @returns whether it converged
bool Stepper::attempt(const Target& target)
{
  const elastoplastic::Settings& s = setup_.solver;
  // A surface at its shear limit flows almost without resistance, which slows the iteration; shorter steps do not help, more
  // evaluations do.
  const int patience = pair_->interface() != nullptr ? 4 : 1;
  for (const double share : {0.6, 1.0})
  {
    const IncrementReport report = solved(target, {.integration = s.integration,
                                                   .max_evaluations = patience * s.max_evaluations,
                                                   .anderson_depth = s.anderson_depth,
                                                   .stiffness_share = share,
                                                   .stay_within_grids = true,
                                                   .wants_stop = setup_.watch.wants_stop});
    if (report.converged)
      return true;
  }
  return false;
}

void Stepper::descend(const Target& target)
{
  const elastoplastic::Settings& s = setup_.solver;
  IncrementReport report;
  constexpr int patience = 20; // the plain fixed point is slow, but its energy decreases in every evaluation
  const bool has_energy = pair_->has_energy(target.drive.kind);
  for (const double share : {1.0, 2.0, 4.0})
  {
    report = solved(target, {.integration = Integration::backward_euler,
                             .max_evaluations = patience * s.max_evaluations,
                             .anderson_depth = 0,
                             .stiffness_share = share,
                             .watch_energy = has_energy,
                             .stay_within_grids = true,
                             .wants_stop = setup_.watch.wants_stop,
                             .keeps_shear_limit = true});
    if (report.converged)
      return;
    if (has_energy && !report.energy_rose)
      break;
  }
  if (report.overloaded)
    throw InputError(fmt::format(
        "{}: friction cannot hold the surfaces against the force along them: friction times pressure, and "
        "nowhere more than the surfaces or `Friction::shear_limit` carry, add up to less; allowed: a smaller "
        "force, or a displacement in its place. All earlier steps are kept",
        where_));
  throw ConvergenceError(fmt::format(
      "{}: no convergence after {} evaluations; yield violation {:.2e} S_y (allowed {:.2e}), change of displacement "
      "{:.2e} m, contact gap {:.2e} m. All earlier steps are kept. Shorter steps or a larger "
      "`Settings::max_evaluations` "
      "may help{}",
      where_, evaluations_, report.yield_error, s.yield_tolerance, report.displacement_error, report.gap_error,
      advice_on_free_flow()));
}

/// Advice where friction may bring a surface that does not harden to its strength, so that there is no state of equilibrium.
std::string Stepper::advice_on_free_flow() const
{
  const bool hardens = !setup_.lower.is_perfectly_plastic() && !setup_.upper.is_perfectly_plastic();
  if (hardens || setup_.sliding.friction.coefficient == 0.0)
    return "";
  return ". A surface that does not harden flows without bound where friction brings the shear to its strength: "
         "hardening, or an `Friction::shear_limit` below its yield stress / sqrt(3), gives it a definite state";
}

void Stepper::grow(const elastoplastic::Outgrown& outgrown)
{
  Plan larger = plan_;
  if (outgrown.contact_ends)
    larger.contact.nx = grown(plan_.contact.nx);
  if (outgrown.contact_sides || outgrown.lower.sides || outgrown.upper.sides)
    larger.contact.ny = setup_.sliding.heat ? grown_by_heat(plan_.contact.ny) : grown(plan_.contact.ny);
  for (const auto& [body, edges] : {std::pair{&larger.lower, &outgrown.lower}, {&larger.upper, &outgrown.upper}})
  {
    if (edges->ends)
      body->surface.nx = grown(body->surface.nx);
    body->surface.nx = std::max(body->surface.nx, larger.contact.nx);
    body->surface.ny = larger.contact.ny;
    if (edges->bottom)
      body->nz += static_cast<int>(std::ceil(body->nz / 3.0));
  }
  if (plan_.twin != elastoplastic::Twin::none)
    larger.upper = larger.lower;
  require_interfaces_at_cells(larger, setup_.lower, setup_.upper, where_);
  // While the history moves to the larger grids, only the state of the smaller ones is in memory.
  larger.memory_bytes = memory_of(larger);
  if (!(larger.memory_bytes <= setup_.watch.available_memory))
    throw GridError(
        fmt::format("{}: contact or plastic zone has reached an edge of its grid, and larger grids would need "
                    "{:.3g} GB; available are {:.3g} GB. All steps so far are kept. Larger cells "
                    "(`Numerics::resolution`, `Numerics::spacing`) need less",
                    where_, 1e-9 * larger.memory_bytes, 1e-9 * setup_.watch.available_memory));
  announce(larger);
  elastoplastic::History history = std::move(*pair_).take_history();
  move_to(larger);
  pair_->continue_from(std::move(history));
}

double Stepper::memory_of(const Plan& plan) const
{
  const bool has_shear = setup_.sliding.friction.coefficient > 0.0 || setup_.sliding.heat;
  const int shears = has_shear ? (setup_.sliding.sticks ? 2 : 1) : 0;
  const int ranks = setup_.watch.ranks ? setup_.watch.ranks->size() : 1;
  return ranks * simulation::memory_bytes(plan, setup_.lower, setup_.upper, setup_.solver, shears,
                                          setup_.sliding.heat ? &setup_.sliding.heat->settings : nullptr, ranks);
}

void Stepper::announce(const Plan& larger)
{
  using Extent = GridChange::Extent;
  for (const GridChange& change :
       {GridChange{steps_, Extent::contact_columns, plan_.contact.nx, larger.contact.nx},
        GridChange{steps_, Extent::rows, plan_.contact.ny, larger.contact.ny},
        GridChange{steps_, Extent::lower_columns, plan_.lower.surface.nx, larger.lower.surface.nx},
        GridChange{steps_, Extent::upper_columns, plan_.upper.surface.nx, larger.upper.surface.nx},
        GridChange{steps_, Extent::lower_layers, plan_.lower.nz, larger.lower.nz},
        GridChange{steps_, Extent::upper_layers, plan_.upper.nz, larger.upper.nz}})
    if (change.before != change.after)
    {
      grid_changes_.push_back(change);
      if (setup_.watch.on_grid_change)
        setup_.watch.on_grid_change(change);
    }
}

/// Replaces the pair by a new one on larger grids, without history.
void Stepper::move_to(const Plan& larger)
{
  pair_.reset();
  lattice_.grow((larger.contact.nx - plan_.contact.nx) / 2, (larger.lower.surface.nx - plan_.lower.surface.nx) / 2,
                (larger.upper.surface.nx - plan_.upper.surface.nx) / 2);
  plan_ = larger;
  pair_ = make_pair();
  distance_.resize(plan_.contact.size());
  distance_x0_ = nan;
  depths_.lower.resize(plan_.contact.size());
  depths_.upper.resize(plan_.contact.size());
}

/// Computes the distance of the undeformed surfaces on the contact grid, unless it is the same as before, as in most steps.
void Stepper::place(const Frame& frame)
{
  if (frame.x0 == distance_x0_)
    return;
  distance_x0_ = frame.x0;
  const SurfaceGrid& g = pair_->grid();
  for (int j = 0; j < g.ny; ++j)
    for (int i = 0; i < g.nx; ++i)
      distance_[g.index(i, j)] = setup_.distance(frame.x0 + i * g.dx, g.y(j));
}

std::vector<double> textured(const Texture& texture, const SurfaceGrid& grid, double x0, double y)
{
  return texture.is_smooth() ? std::vector<double>{} : cell_depths(texture, grid, x0, y + grid.y(0));
}

} // namespace brinell::simulation
