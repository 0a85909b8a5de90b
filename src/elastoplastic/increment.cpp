// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/increment.hpp"

#include "brinell/elastoplastic/anderson.hpp"
#include "brinell/foundation/error.hpp"
#include "foundation/require_size.hpp"
#include "unknowns.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace brinell::elastoplastic
{

namespace
{

std::shared_ptr<const halfspace::HalfSpace> operators(const VolumeGrid& grid, const Elastic& elastic)
{
  return elastic.is_rigid() ? nullptr : std::make_shared<const halfspace::HalfSpace>(grid, elastic);
}

} // namespace

CoupledContact::CoupledContact(const SurfaceGrid& contact, const VolumeGrid& lower, const VolumeGrid& upper,
                               const constitutive::Material& lower_material,
                               const constitutive::Material& upper_material, const Scales& scales,
                               const Settings& settings, Twin twin, Textures textures)
    : compliance_(contact, contact_modulus(lower_material.elastic, upper_material.elastic)), contact_(compliance_),
      lower_(lower, operators(lower, lower_material.elastic), lower_material, settings.shortcuts,
             std::move(textures.lower)),
      upper_(upper,
             lower == upper && lower_material.elastic == upper_material.elastic
                 ? lower_.shared_half_space()
                 : operators(upper, upper_material.elastic),
             upper_material, settings.shortcuts, std::move(textures.upper)),
      scales_(scales), settings_(settings), twin_(twin), pressure_(contact.size(), 0.0), gap_(contact.size(), 0.0),
      distance_(contact.size(), 0.0), lower_pressure_(lower.surface.size()), upper_pressure_(upper.surface.size())
{
  for (const SurfaceGrid& s : {lower.surface, upper.surface})
    if (s.ny != contact.ny || s.dx != contact.dx || s.dy != contact.dy)
      throw InternalError("CoupledContact: the three grids must have the same cells and rows");
  if (twin != Twin::none && !(lower == upper && lower_material == upper_material))
    throw InternalError("CoupledContact: bodies that are not alike cannot be twins");
}

void CoupledContact::exchange(Archive& archive)
{
  archive("lower", lower_);
  if (twin_ == Twin::none)
    archive("upper", upper_);
  else
    upper_.adopt(lower_, twin_);
  for (const auto& [name, place] : {std::pair{"lower", &placement_.lower}, {"upper", &placement_.upper}})
  {
    constexpr int most_columns = 1 << 28; // differences stay whole numbers
    archive(std::string(name) + ".column", place->column, -most_columns, most_columns);
    archive(std::string(name) + ".fraction", place->fraction, 0.0, 1.0);
  }
  archive("approach", approach_);
  archive("pressure", pressure_);
  archive("gap", gap_);
}

void CoupledContact::surface_depth(const Body& body, const Place& place, std::span<double> out) const
{
  require_size("CoupledContact::surface_depth: the depth", out, grid().size());
  std::fill(out.begin(), out.end(), 0.0);
  add_depth(body.grid().surface, body.state().residual_displacement, body.texture(), place, grid(), out);
}

bool CoupledContact::spread_pressure(const Body& body, const Place& place, std::vector<double>& out) const
{
  return elastoplastic::spread_pressure(grid(), pressure_, place, body.grid().surface, out);
}

Outgrown CoupledContact::outgrown() const
{
  Outgrown result{lower_.reached_edges(), twin_ == Twin::none ? upper_.reached_edges() : lower_.reached_edges()};
  result.lower.ends = result.lower.ends || leaves_lower_;
  result.upper.ends = result.upper.ends || leaves_upper_;
  std::tie(result.contact_ends, result.contact_sides) = pressed_edges();
  return result;
}

/// Whether pressure acts in the outermost columns, and rows, of the contact grid.
std::pair<bool, bool> CoupledContact::pressed_edges() const
{
  const SurfaceGrid& g = grid();
  const auto pressed = [&](int i, int j) { return pressure_[static_cast<std::size_t>(i + g.nx * j)] > 0.0; };
  bool ends = false;
  bool sides = false;
  for (int i = 0; i < g.nx; ++i)
    sides = sides || pressed(i, 0) || pressed(i, g.ny - 1);
  for (int j = 0; j < g.ny; ++j)
    ends = ends || pressed(0, j) || pressed(g.nx - 1, j);
  return {ends, sides};
}

bool CoupledContact::reaches_edge() const
{
  const auto [ends, sides] = pressed_edges();
  return ends || sides;
}

History CoupledContact::take_history() &&
{
  return {
      grid(),     lower_.grid(), upper_.grid(),       std::move(lower_).take_state(), std::move(upper_).take_state(),
      placement_, approach_,     std::move(pressure_)};
}

void CoupledContact::continue_from(History history)
{
  const auto columns_added = [](int now, int before)
  {
    if (now < before || (now - before) % 2 != 0)
      throw InternalError("CoupledContact: a history continues on larger grids with the same middle");
    return (now - before) / 2;
  };
  const int columns = columns_added(grid().nx, history.contact.nx);
  const int rows = columns_added(grid().ny, history.contact.ny);
  for (int j = 0; j < history.contact.ny; ++j)
    std::copy_n(history.pressure.begin() + static_cast<std::ptrdiff_t>(j) * history.contact.nx, history.contact.nx,
                pressure_.begin() + columns + static_cast<std::ptrdiff_t>(j + rows) * grid().nx);
  approach_ = history.approach;
  placement_ = history.placement;
  placement_.lower.column += columns_added(lower_.grid().surface.nx, history.lower_grid.surface.nx) - columns;
  placement_.upper.column += columns_added(upper_.grid().surface.nx, history.upper_grid.surface.nx) - columns;
  spread_pressure(lower_, placement_.lower, lower_pressure_);
  lower_.continue_from(history.lower, history.lower_grid, lower_pressure_);
  if (twin_ != Twin::none)
    return upper_.adopt(lower_, twin_);
  spread_pressure(upper_, placement_.upper, upper_pressure_);
  upper_.continue_from(history.upper, history.upper_grid, upper_pressure_);
}

double CoupledContact::load() const
{
  return std::accumulate(pressure_.begin(), pressure_.end(), 0.0) * grid().cell_area();
}

double CoupledContact::elastic_energy() const
{
  std::vector<double> displacement(pressure_.size());
  halfspace::SurfaceCompliance::Scratch scratch = compliance_.make_scratch();
  compliance_.apply({.pressure = pressure_}, {.z = displacement}, scratch);
  double sum = 0.0;
  for (std::size_t i = 0; i < pressure_.size(); ++i)
    sum += pressure_[i] * displacement[i];
  return 0.5 * sum * grid().cell_area();
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

/// Contact of the deformed surfaces: gap and pressure for the residual displacements of the present trial.
void CoupledContact::touch(std::span<const double> distance, const contact::Drive& drive, const Placement& placement,
                           const Strategy& strategy, IncrementReport& report)
{
  std::copy(distance.begin(), distance.end(), distance_.begin());
  add_depth(lower_.grid().surface, lower_.residual_displacement(), lower_.texture(), placement.lower, grid(),
            distance_);
  add_depth(upper_.grid().surface, upper_.residual_displacement(), upper_.texture(), placement.upper, grid(),
            distance_);
  constexpr int most_iterations = 2000;
  const contact::Report contact = contact_.solve(distance_, drive, settings_.contact_tolerance * scales_.gap,
                                                 most_iterations, pressure_, gap_, strategy.wants_stop);
  report.contact_iterations += contact.iterations;
  report.gap_error = std::max(contact.gap_error, contact.penetration);
  report.contact_converged = contact.converged;
  report.approach = contact.approach;
  leaves_lower_ = !spread_pressure(lower_, placement.lower, lower_pressure_);
  leaves_upper_ = !spread_pressure(upper_, placement.upper, upper_pressure_);
}

double CoupledContact::energy(double approach) const
{
  // The contact's part as the dual value -(1/2 p A p + p distance), whose error is of second order in that of the pressure.
  // An imposed approach adds its work, which does not change in the increment only if the load is imposed.
  double work = 0.0;
  for (std::size_t i = 0; i < pressure_.size(); ++i)
    work += pressure_[i] * (distance_[i] - approach);
  const double lower = lower_.energy(lower_pressure_);
  const double upper = twin_ != Twin::none ? lower : upper_.energy(upper_pressure_);
  return lower + upper - elastic_energy() - work * grid().cell_area();
}

namespace
{

/// Puts back what an increment has changed, unless it is committed.
class Undo
{
public:
  Undo(std::vector<double>& pressure, std::vector<double>& gap, Body& lower, Body& upper)
      : pressure_(pressure), gap_(gap), lower_(lower), upper_(upper), old_pressure_(pressure), old_gap_(gap)
  {
  }
  ~Undo()
  {
    if (committed_)
      return;
    pressure_.swap(old_pressure_);
    gap_.swap(old_gap_);
    lower_.restore();
    upper_.restore();
  }
  Undo(const Undo&) = delete;
  Undo& operator=(const Undo&) = delete;
  void commit() { committed_ = true; }

private:
  std::vector<double>&pressure_, &gap_;
  Body &lower_, &upper_;
  std::vector<double> old_pressure_, old_gap_;
  bool committed_ = false;
};

} // namespace

namespace
{

/// Errors over their tolerances below which the next evaluation is likely to be the last one.
constexpr double closing_factor = 5.0;

} // namespace

/// The fixed point of the trial deviators, to convergence or until it is given up.
IncrementReport CoupledContact::iterate(std::span<const double> distance, const contact::Drive& drive,
                                        const Placement& placement, const Strategy& strategy)
{
  IncrementReport report;
  const bool twins = twin_ != Twin::none;
  const double imposed_approach = drive.kind == contact::Drive::Kind::approach ? drive.value : 0.0;
  Anderson anderson(strategy.anderson_depth);
  Unknowns unknowns;
  StallRule stall_rule;
  std::vector<double> x;
  std::vector<double> g;
  std::vector<double> last_lower;
  std::vector<double> last_upper;
  // The increment may end with an evaluation that has looked at the stress everywhere: the last few do.
  bool closing = strategy.watch_energy || lower_.unknowns() + upper_.unknowns() == 0;
  for (report.evaluations = 1;; ++report.evaluations)
  {
    if (strategy.wants_stop && strategy.wants_stop())
      throw Interrupted();
    if (closing)
    {
      lower_.compute_all_layers();
      upper_.compute_all_layers();
    }
    const bool complete = lower_.computes_all_layers() && upper_.computes_all_layers();
    last_lower.assign(lower_.residual_displacement().begin(), lower_.residual_displacement().end());
    last_upper.assign(upper_.residual_displacement().begin(), upper_.residual_displacement().end());
    lower_.integrate(strategy.integration);
    if (twins)
      upper_.follow(lower_, twin_);
    else
      upper_.integrate(strategy.integration);
    touch(distance, drive, placement, strategy, report);
    const bool lower_grew = lower_.update(lower_pressure_);
    const bool upper_grew = !twins && upper_.update(upper_pressure_);
    const bool grew = lower_grew || upper_grew;
    report.yield_error = std::max(lower_.yield_error(), upper_.yield_error());
    report.displacement_error = std::max(largest_change(lower_.residual_displacement(), last_lower),
                                         largest_change(upper_.residual_displacement(), last_upper));
    // The first evaluation measures its change against the state before the increment: only a second one can settle it.
    const bool settled = report.evaluations > 1 || lower_.unknowns() + upper_.unknowns() == 0;
    const auto within = [&](double factor)
    {
      return report.yield_error <= factor * settings_.yield_tolerance &&
             report.displacement_error <= factor * settings_.displacement_tolerance * scales_.displacement;
    };
    report.converged = report.contact_converged && !grew && settled && complete && within(1.0);
    closing = strategy.watch_energy || within(closing_factor);
    const bool finite = std::isfinite(report.yield_error + report.displacement_error + report.gap_error);
    if (report.converged || !finite || report.evaluations >= strategy.max_evaluations)
      break;
    if (strategy.watch_energy)
    {
      const double now = energy(imposed_approach);
      constexpr double rounding = 1e-10;
      report.energy_rose = report.evaluations > 2 && !grew && now > report.energy + rounding * std::abs(report.energy);
      report.energy = now;
      if (report.energy_rose)
        break;
    }
    else if (stall_rule.stalls(report.yield_error, grew || report.evaluations == 1))
      break;
    unknowns.grow(lower_, upper_);
    unknowns.pack(lower_.trial(), upper_.trial(), x);
    unknowns.pack(lower_.image(), upper_.image(), g);
    anderson.advance(x, g);
    unknowns.unpack(x, lower_.trial(), upper_.trial());
  }
  return report;
}

IncrementReport CoupledContact::advance(std::span<const double> distance, const contact::Drive& drive,
                                        const Placement& placement, const Strategy& strategy)
{
  require_size("CoupledContact::advance: the distance", distance, grid().size());
  Undo undo(pressure_, gap_, lower_, upper_);
  lower_.begin(placement.lower.column - placement_.lower.column, strategy.stiffness_share);
  if (twin_ != Twin::none)
    upper_.follow(lower_, twin_);
  else
    upper_.begin(placement.upper.column - placement_.upper.column, strategy.stiffness_share);
  IncrementReport report = iterate(distance, drive, placement, strategy);
  if (!report.converged)
    return report;
  report.outgrown = outgrown();
  if (strategy.stay_within_grids && report.outgrown.any())
  {
    report.converged = false;
    return report;
  }
  if (leaves_lower_ || leaves_upper_)
    throw GridError("the contact has reached the end of a material grid");
  report.energy = energy(drive.kind == contact::Drive::Kind::approach ? drive.value : 0.0);
  lower_.commit(lower_pressure_);
  if (twin_ != Twin::none)
    upper_.adopt(lower_, twin_);
  else
    upper_.commit(upper_pressure_);
  placement_ = placement;
  approach_ = report.approach;
  undo.commit();
  return report;
}

} // namespace brinell::elastoplastic
