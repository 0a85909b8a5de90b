// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/increment.hpp"

#include "brinell/contact/contact_stiffness.hpp"
#include "brinell/elastoplastic/anderson.hpp"
#include "brinell/foundation/error.hpp"
#include "foundation/require_size.hpp"
#include "foundation/sharing.hpp"
#include "unknowns.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace brinell::elastoplastic
{

namespace
{

std::shared_ptr<const halfspace::HalfSpace> operators(const VolumeGrid& grid, const Elastic& elastic)
{
  return elastic.is_rigid() ? nullptr : std::make_shared<const halfspace::HalfSpace>(grid, elastic);
}

std::unique_ptr<Interface> make_interface(const SurfaceGrid& contact, const Elastic& lower, const Elastic& upper,
                                          const Sliding& sliding, double reference)
{
  if (sliding.sticks)
    return std::make_unique<PartialSlip>(contact, lower, upper, sliding.friction, reference);
  return std::make_unique<SlidingInterface>(contact, lower, upper, sliding.friction, sliding.direction, reference);
}

/// Those of the surfaces on which the shear works.
halfspace::Displacements displacements_under(const Interface* interface)
{
  if (interface == nullptr)
    return halfspace::Displacements::normal;
  return interface->shears()[1].empty() ? halfspace::Displacements::along_x : halfspace::Displacements::all;
}

} // namespace

CoupledContact::CoupledContact(const SurfaceGrid& contact, const VolumeGrid& lower, const VolumeGrid& upper,
                               const constitutive::Material& lower_material,
                               const constitutive::Material& upper_material, const Scales& scales,
                               const Settings& settings, Twin twin, Textures textures, double reference,
                               const Sliding& sliding, Symmetry symmetry)
    : compliance_(contact, contact_modulus(lower_material.elastic, upper_material.elastic), reference),
      contact_(compliance_), textures_(std::move(textures)), scales_(scales), settings_(settings), twin_(twin),
      symmetry_(sliding.sticks ? Symmetry::none : symmetry), pressure_(contact.size(), 0.0), gap_(contact.size(), 0.0),
      distance_(contact.size(), 0.0)
{
  for (const SurfaceGrid& s : {lower.surface, upper.surface})
    if (s.ny != contact.ny || s.dx != contact.dx || s.dy != contact.dy || s.boundary_x != contact.boundary_x ||
        s.boundary_y != contact.boundary_y || (contact.is_periodic_x() && s.nx != contact.nx))
      throw InternalError("CoupledContact: the three grids must have the same cells, rows and boundaries");
  const bool are_alike = lower == upper && lower_material.elastic == upper_material.elastic;
  if (twin != Twin::none && !(are_alike && lower_material == upper_material))
    throw InternalError("CoupledContact: bodies that are not alike cannot be twins");
  for (const auto& [texture, grid] : {std::pair{&textures_.lower, &lower}, {&textures_.upper, &upper}})
    if (!texture->empty())
      require_size("CoupledContact: the texture", *texture, grid->surface.size());
  const bool has_friction = sliding.friction.coefficient > 0.0;
  if (has_friction && twin == Twin::alike)
    throw InternalError("CoupledContact: the shear acts on the bodies in opposite ways, so they are not alike");
  if (has_friction)
    interface_ = make_interface(contact, lower_material.elastic, upper_material.elastic, sliding, reference);
  if (has_friction && sliding.heat && !sliding.sticks)
    heating_ = std::make_unique<Heating>(
        contact, std::array{Heating::Partner{lower, lower_material}, Heating::Partner{upper, upper_material}},
        *sliding.heat, twin);
  if (sliding.wear.wears() && twin != Twin::none)
    throw InternalError("CoupledContact: bodies whose surfaces wear are not twins");
  if (sliding.wear.wears())
    wear_ = std::make_unique<Wear>(contact, lower.surface, upper.surface, sliding.wear);
  const auto half_space = operators(lower, lower_material.elastic);
  const halfspace::Displacements displacements = displacements_under(interface_.get());
  sides_.push_back(
      {Body(lower, half_space, lower_material, settings.shortcuts, displacements, symmetry_), &Placement::lower});
  if (twin == Twin::none)
    sides_.push_back({.body = Body(upper, are_alike ? half_space : operators(upper, upper_material.elastic),
                                   upper_material, settings.shortcuts, displacements, symmetry_),
                      .place = &Placement::upper,
                      .shear_sign = -1.0});
}

namespace
{

void add_depth_of(const BodyView& view, const Place& place, const SurfaceGrid& contact, std::span<double> out)
{
  require_size("CoupledContact: the depth", out, contact.size());
  const auto add = [&](std::span<const double> displacement)
  { add_depth(view.grid().surface, displacement, view.texture(), place, contact, out); };
  if (view.is_mirrored())
    add(view.residual_displacement());
  else
    add(view.solved().residual_displacement()); // every evaluation comes here: without a copy
}

} // namespace

void CoupledContact::add_lower_depth(const Place& place, std::span<double> out) const
{
  add_depth_of(lower(), place, grid(), out);
  if (wear_)
    wear_->add_depth(0, place, out);
}

void CoupledContact::add_upper_depth(const Place& place, std::span<double> out) const
{
  add_depth_of(upper(), place, grid(), out);
  if (wear_)
    wear_->add_depth(1, place, out);
}

void CoupledContact::set_softening(std::span<const double> lower, std::span<const double> upper)
{
  if (twin_ != Twin::none && !upper.empty())
    throw InternalError("CoupledContact: an upper body that is a twin has the softening of the lower one");
  sides_.front().body.set_softening(lower);
  if (twin_ == Twin::none)
    sides_.back().body.set_softening(upper);
}

CoupledContact::Stress CoupledContact::lower_stress(const Place& place)
{
  return stress(0, sides_.front().body, place);
}

CoupledContact::Stress CoupledContact::upper_stress(const Place& place)
{
  return stress(1, sides_.back().body, place);
}

/// @param solved  whose buffers are used
CoupledContact::Stress CoupledContact::stress(std::size_t side, Body& solved, const Place& place) const
{
  const BodyView view = side == 0 ? lower() : upper();
  const double shear_sign = side == 0 ? 1.0 : -1.0;
  if (view.material().elastic.is_rigid())
    throw InputError("the body is rigid: it has no stress");
  const VolumeGrid& volume = view.grid();
  std::vector<double> pressure;
  std::array<std::vector<double>, 2> shear;
  spread_traction(grid(), pressure_, place, volume.surface, pressure);
  if (interface_)
    spread_shear(place, volume.surface, shear_sign, shear);
  Stress result{std::vector<double>(Deviator::size * volume.size()), std::vector<double>(volume.size())};
  solved.full_stress({.pressure = pressure, .shear_x = shear[0], .shear_y = shear[1]},
                     view.deviators(&BodyState::plastic_strain), result.deviator, result.trace);
  add_thermal_stress(side, view, result);
  return result;
}

bool CoupledContact::has_energy(contact::Drive::Kind drive) const
{
  return drive != contact::Drive::Kind::mean_gap &&
         std::all_of(sides_.begin(), sides_.end(), [](const Side& side) { return side.body.has_energy(); });
}

Outgrown CoupledContact::outgrown() const
{
  const auto edges_of = [](const Side& side)
  {
    Edges edges = side.body.reached_edges();
    edges.ends = edges.ends || side.leaves_grid;
    return edges;
  };
  Outgrown result{edges_of(sides_.front()), edges_of(sides_.back())};
  std::tie(result.contact_ends, result.contact_sides) = pressed_edges();
  return result;
}

/// Whether pressure acts in the outermost columns, and rows, of the contact grid.
std::pair<bool, bool> CoupledContact::pressed_edges() const
{
  const SurfaceGrid& g = grid();
  const auto pressed = [&](int i, int j) { return pressure_[g.index(i, j)] > 0.0; };
  bool ends = false;
  bool sides = false;
  for (int i = 0; i < g.nx && !g.is_periodic_y(); ++i)
    sides = sides || pressed(i, 0) || pressed(i, g.ny - 1);
  for (int j = 0; j < g.ny && !g.is_periodic_x(); ++j)
    ends = ends || pressed(0, j) || pressed(g.nx - 1, j);
  return {ends, sides};
}

bool CoupledContact::reaches_edge() const
{
  const auto [ends, sides] = pressed_edges();
  return ends || sides;
}

/// Pressure and shear on the grids of the bodies.
void CoupledContact::spread(const Placement& placement)
{
  for (Side& side : sides_)
  {
    const Place& place = placement.*side.place;
    const SurfaceGrid& surface = side.body.grid().surface;
    side.leaves_grid = !spread_traction(grid(), pressure_, place, surface, side.pressure);
    if (interface_)
      spread_shear(place, surface, side.shear_sign, side.shear);
  }
}

double CoupledContact::load() const
{
  return sum(pressure_) * grid().cell_area();
}

double CoupledContact::stiffness() const
{
  return contact::stiffness(compliance_, pressure_);
}

double CoupledContact::elastic_energy() const
{
  return pressure_energy() + (interface_ ? interface_->elastic_energy(pressure_) : 0.0);
}

double CoupledContact::pressure_energy() const
{
  std::vector<double> displacement(pressure_.size());
  halfspace::SurfaceCompliance::Scratch scratch = compliance_.make_scratch();
  compliance_.apply({.pressure = pressure_}, {.z = displacement}, scratch);
  return 0.5 * dot(pressure_, displacement) * grid().cell_area();
}

namespace
{

double largest_change(std::span<const double> a, const std::vector<double>& b)
{
  double change = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    change = std::max(change, std::abs(a[i] - b[i]));
  return change;
}

} // namespace

/// Gap and pressure of the surfaces with the residual displacements of the present trial.
void CoupledContact::solve_contact(std::span<const double> distance, const contact::Drive& drive,
                                   const Placement& placement, const Strategy& strategy, bool closing,
                                   IncrementReport& report)
{
  std::copy(distance.begin(), distance.end(), distance_.begin());
  add_lower_depth(placement.lower, distance_);
  add_upper_depth(placement.upper, distance_);
  if (interface_)
    solve_frictional_contact(drive, placement, strategy, closing, report);
  else
    press(drive, strategy, report);
  spread(placement);
}

/// The pressure of surfaces at the distance `distance_`.
void CoupledContact::press(const contact::Drive& drive, const Strategy& strategy, IncrementReport& report)
{
  constexpr int most_iterations = 2000;
  const contact::Report contact =
      contact_.solve(distance_, drive, settings_.contact_tolerance * scales_.gap, most_iterations, pressure_, gap_,
                     strategy.wants_stop, wear_ ? wear_->compliance() : std::span<const double>{});
  if (symmetry_ != Symmetry::none) // rounding shall not grow from step to step
    for (std::vector<double>* field : {&pressure_, &gap_})
      complete_in_y(grid(), 1.0, field->data(), field->size());
  report.contact_iterations += contact.iterations;
  report.gap_error = std::max(contact.gap_error, contact.penetration);
  report.contact_converged = contact.converged;
  report.approach = contact.approach;
}

double CoupledContact::energy(double approach) const
{
  // The contact's part as the dual value -(1/2 p A p + p distance), whose error is of second order in that of the pressure.
  // An imposed approach adds its work, which does not change in the increment only if the load is imposed.
  const double work = dot(pressure_, distance_) - approach * sum(pressure_);
  double bodies = 0.0;
  for (const Side& side : sides_)
    bodies += side.body.energy(side.load()) - work_of_shear(side);
  if (twin_ != Twin::none)
    bodies *= 2.0;
  const double of_shear = interface_ ? interface_->held_energy() : 0.0;
  const double of_wear = wear_ ? wear_->held_energy(pressure_) : 0.0;
  return bodies - pressure_energy() - work * grid().cell_area() + of_shear + of_wear;
}

namespace
{

/// Puts back what an increment has changed, unless it is committed.
template <typename Sides>
class Undo
{
public:
  Undo(std::vector<double>& pressure, std::vector<double>& gap, Sides& sides, Interface* interface, Heating* heating)
      : pressure_(pressure), gap_(gap), sides_(sides), interface_(interface), heating_(heating),
        old_pressure_(pressure), old_gap_(gap)
  {
  }
  ~Undo()
  {
    if (committed_)
      return;
    pressure_.swap(old_pressure_);
    gap_.swap(old_gap_);
    for (auto& side : sides_)
      side.body.restore();
    if (interface_ != nullptr)
      interface_->restore();
    if (heating_ != nullptr)
      heating_->restore();
  }
  Undo(const Undo&) = delete;
  Undo& operator=(const Undo&) = delete;
  void commit() { committed_ = true; }

private:
  std::vector<double>&pressure_, &gap_;
  Sides& sides_;
  Interface* interface_; ///< nullptr: none
  Heating* heating_;     ///< nullptr: none
  std::vector<double> old_pressure_, old_gap_;
  bool committed_ = false;
};

} // namespace

namespace
{

/// Errors over their tolerances below which the next evaluation is likely to be the last one.
constexpr double closing_factor = 5.0;

} // namespace

bool CoupledContact::has_unknowns() const
{
  return std::any_of(sides_.begin(), sides_.end(), [](const Side& side) { return side.body.unknowns() > 0; });
}

namespace
{

/// What the contact's dual value counts as imposed, see CoupledContact::energy.
double imposed_approach(const contact::Drive& drive, double found)
{
  return drive.kind == contact::Drive::Kind::load ? 0.0 : found;
}

} // namespace

/// The fixed point of the trial deviators, to convergence or until it is given up.
IncrementReport CoupledContact::iterate(std::span<const double> distance, const contact::Drive& drive,
                                        const Placement& placement, const Strategy& strategy)
{
  IncrementReport report;
  Anderson anderson(strategy.anderson_depth);
  Unknowns unknowns;
  StallRule stall_rule;
  std::vector<double> x;
  std::vector<double> g;
  std::vector<double> displacement; // of one body, before an evaluation
  // The increment may end with an evaluation that has looked at the stress everywhere: the last few do.
  bool closing = strategy.watch_energy || !has_unknowns();
  int comparable = 2; // energies after this evaluation
  for (report.evaluations = 1;; ++report.evaluations)
  {
    if (strategy.wants_stop && strategy.wants_stop())
      throw Interrupted();
    bool complete = true;
    report.displacement_error = 0.0;
    for (Side& side : sides_)
    {
      Body& body = side.body;
      if (closing)
        body.compute_all_layers();
      complete = complete && body.computes_all_layers();
      displacement.assign(body.residual_displacement().begin(), body.residual_displacement().end());
      body.integrate(strategy.integration);
      report.displacement_error =
          larger(report.displacement_error, largest_change(body.residual_displacement(), displacement));
    }
    solve_contact(distance, drive, placement, strategy, closing, report);
    bool grew = false;
    report.yield_error = 0.0;
    for (Side& side : sides_)
    {
      grew = side.body.update(side.load()) || grew;
      report.yield_error = larger(report.yield_error, side.body.yield_error());
    }
    // The first evaluation measures its change against the state before the increment: only a second one can settle it.
    const bool settled = report.evaluations > 1 || !has_unknowns();
    const auto within = [&](double factor)
    {
      return report.yield_error <= factor * settings_.yield_tolerance &&
             report.displacement_error <= factor * settings_.displacement_tolerance * scales_.displacement;
    };
    report.converged = report.contact_converged && !grew && settled && complete && within(1.0);
    const bool renewed = report.converged && strategy.watch_energy && renews_law(report);
    closing = strategy.watch_energy || within(closing_factor);
    const bool finite = std::isfinite(report.yield_error + report.displacement_error + report.gap_error);
    if (report.converged || !finite || report.evaluations >= strategy.max_evaluations)
      break;
    if (strategy.watch_energy)
    {
      for (Side& side : sides_)
        side.body.complete_trial();
      const double now = energy(imposed_approach(drive, report.approach));
      constexpr double rounding = 1e-10;
      report.energy_rose =
          report.evaluations > comparable && !grew && now > report.energy + rounding * std::abs(report.energy);
      if (renewed) // another function
        comparable = report.evaluations + 1;
      report.energy = now;
      if (report.energy_rose)
        break;
    }
    else if (strategy.anderson_depth > 0 && stall_rule.stalls(report.yield_error, grew || report.evaluations == 1))
      break;
    unknowns.grow(sides_);
    unknowns.pack(sides_, x, g);
    anderson.advance(x, g, unknowns.weights());
    unknowns.unpack(x, sides_);
  }
  return report;
}

IncrementReport CoupledContact::advance(std::span<const double> distance, const contact::Drive& drive,
                                        const Placement& placement, const Strategy& strategy,
                                        const contact::TangentialDrive& along)
{
  require_size("CoupledContact::advance: the distance", distance, grid().size());
  if (strategy.stay_within_grids && carries_off(placement))
  {
    IncrementReport report;
    report.outgrown.contact_ends = true;
    return report;
  }
  if (interface_)
    begin_friction(placement, strategy, along);
  Undo undo(pressure_, gap_, sides_, interface_.get(), heating_.get());
  for (Side& side : sides_)
    side.body.begin((placement.*side.place).column - (placement_.*side.place).column, strategy.stiffness_share);
  if (wear_)
    begin_wear(strategy);
  if (heating_)
    begin_heating(placement, strategy);
  IncrementReport report = iterate(distance, drive, placement, strategy);
  if (!report.converged)
    return report;
  report.outgrown = outgrown();
  if (strategy.stay_within_grids && report.outgrown.any())
  {
    report.converged = false;
    return report;
  }
  if (std::any_of(sides_.begin(), sides_.end(), [](const Side& side) { return side.leaves_grid; }))
    throw GridError("the contact has reached the end of a material grid");
  for (Side& side : sides_)
    side.body.complete_trial();
  report.energy = energy(imposed_approach(drive, report.approach));
  for (Side& side : sides_)
    side.body.commit(side.load());
  if (interface_)
    settle_friction(placement);
  if (wear_)
    wear_->settle(pressure_, placement);
  if (heating_)
    settle_heating(strategy);
  placement_ = placement;
  approach_ = report.approach;
  undo.commit();
  return report;
}

} // namespace brinell::elastoplastic
