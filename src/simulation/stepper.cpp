// SPDX-License-Identifier: BSD-3-Clause
#include "stepper.hpp"

#include "brinell/foundation/error.hpp"
#include "snapshot.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace brinell::simulation
{

using elastoplastic::Body;
using elastoplastic::IncrementReport;
using elastoplastic::Integration;
using elastoplastic::Place;

namespace
{

/// A column position as a whole number and a fraction; what is whole but for rounding is whole.
Place place_at(double column)
{
  constexpr double rounding = 1e-7;
  const double nearest = std::round(column);
  if (std::abs(column - nearest) < rounding)
    return {static_cast<int>(nearest), 0.0};
  const double below = std::floor(column);
  return {static_cast<int>(below), column - below};
}

/// Plastic strain that would spread beyond the grid is lost: better no result than that one.
void check_extent(const char* name, const Body& body)
{
  constexpr double tolerated = 0.02;
  const Body::EdgeStrain edge = body.edge_strain();
  for (const auto& [share, where] :
       {std::pair{edge.ends, "end, along x,"}, {edge.sides, "side, along y,"}, {edge.bottom, "bottom"}})
    if (share > tolerated)
      throw GridError(fmt::format("the plastic zone of the {} body has reached the {} of its grid ({:.0f} % of the "
                                  "largest plastic strain there): enlarge it by grid.extent. All steps so far are kept",
                                  name, where, 100.0 * share));
}

double largest(const std::vector<double>& values)
{
  return *std::max_element(values.begin(), values.end());
}

} // namespace

Lattice::Lattice(const Plan& plan, double arc_lower, double arc_upper)
    : dx_(plan.contact.dx), half_((plan.contact.nx - 1) / 2), lower_origin_(0.0), upper_origin_(0.0)
{
  const int lower_zero = (plan.lower.surface.nx - 1) / 2;
  lower_origin_ = -lower_zero * dx_;
  // Local x' of the contact's column 0, as a coordinate of the upper body, is to fall on one of its columns.
  const double upper = static_cast<double>(centre_column(arc_lower) - half_) * dx_ - arc_lower + arc_upper;
  const int upper_zero = (plan.upper.surface.nx - 1) / 2;
  upper_origin_ = upper - std::round(upper / dx_ + upper_zero) * dx_;
}

long Lattice::centre_column(double arc_lower) const
{
  return std::lround(arc_lower / dx_);
}

Frame Lattice::frame(double arc_lower, double arc_upper) const
{
  Frame f;
  const double left = static_cast<double>(centre_column(arc_lower) - half_) * dx_; // on the lower body
  f.x0 = left - arc_lower;
  f.placement.lower = place_at((left - lower_origin_) / dx_);
  f.placement.upper = place_at((f.x0 + arc_upper - upper_origin_) / dx_);
  return f;
}

Stepper::Stepper(const Plan& plan, Setup setup)
    : setup_(std::move(setup)), pair_(plan.contact, plan.lower, plan.upper, setup_.lower, setup_.upper, plan.scales,
                                      setup_.solver, plan.twin, std::move(setup_.textures)),
      distance_(plan.contact.size()),
      distance_x0_(std::numeric_limits<double>::quiet_NaN()), depths_{std::vector<double>(plan.contact.size()),
                                                                      std::vector<double>(plan.contact.size())}
{
}

void Stepper::exchange(Archive& archive)
{
  archive("pair", pair_);
  archive("split_increments", split_increments_, 0, std::numeric_limits<int>::max() - 1);
}

int Stepper::advance(const std::function<Target(double)>& path, double finest, const std::string& where)
{
  evaluations_ = 0;
  where_ = where;
  if (!attempt(path(1.0)))
  {
    ++split_increments_;
    bisect(path, 0.0, 1.0, finest);
  }
  check_extent("lower", pair_.lower());
  check_extent("upper", pair_.upper());
  if (pair_.reaches_edge())
    throw GridError(
        "the contact has reached the edge of its grid: enlarge it by grid.extent. All steps so far are kept");
  return evaluations_;
}

void Stepper::bisect(const std::function<Target(double)>& path, double begin, double end, double finest)
{
  if (end - begin < 1.5 * finest)
    return guard(path(end));
  const double middle = 0.5 * (begin + end);
  for (const auto& [from, to] : {std::pair{begin, middle}, {middle, end}})
    if (!attempt(path(to)))
      bisect(path, from, to, finest);
}

IncrementReport Stepper::solved(const Target& target, const elastoplastic::Strategy& strategy)
{
  try
  {
    const IncrementReport report = pair_.advance(distance_, target.drive, target.frame.placement, strategy);
    evaluations_ += report.evaluations;
    return report;
  }
  catch (const GridError& error)
  {
    throw GridError(fmt::format("{}: enlarge it by grid.extent. All steps so far are kept", error.what()));
  }
}

/// Accelerated: first with a cell's own stiffness, then with that which bounds all.
bool Stepper::attempt(const Target& target)
{
  const elastoplastic::Settings& s = setup_.solver;
  place(target.frame);
  for (const double share : {0.6, 1.0})
  {
    const IncrementReport report =
        solved(target, {s.integration, s.max_iterations, s.anderson_depth, share, false, setup_.wants_stop});
    if (report.converged)
      return true;
  }
  return false;
}

void Stepper::guard(const Target& target)
{
  const elastoplastic::Settings& s = setup_.solver;
  place(target.frame);
  IncrementReport report;
  constexpr int patience = 20; // the plain fixed point is slow, but it descends
  const bool has_energy = setup_.lower.kinematic.empty() && setup_.upper.kinematic.empty();
  for (const double share : {1.0, 2.0, 4.0})
  {
    report = solved(
        target, {Integration::backward_euler, patience * s.max_iterations, 0, share, has_energy, setup_.wants_stop});
    if (report.converged)
      return;
    if (has_energy && !report.energy_rose)
      break;
  }
  throw ConvergenceError(fmt::format(
      "{}: no convergence after {} evaluations; yield violation {:.2e} S_y (allowed {:.2e}), change of displacement "
      "{:.2e} m, contact gap {:.2e} m. All earlier steps are kept. Shorter steps or a larger solver.max_iterations may "
      "help",
      where_, evaluations_, report.yield_error, s.yield_tolerance, report.displacement_error, report.gap_error));
}

/// Distance of the undeformed surfaces on the contact grid; most steps have the same.
void Stepper::place(const Frame& frame)
{
  if (frame.x0 == distance_x0_)
    return;
  distance_x0_ = frame.x0;
  const SurfaceGrid& g = pair_.grid();
  for (int j = 0; j < g.ny; ++j)
    for (int i = 0; i < g.nx; ++i)
      distance_[static_cast<std::size_t>(i + g.nx * j)] =
          setup_.distance(frame.x0 + i * g.dx, (j - 0.5 * (g.ny - 1)) * g.dy);
}

double Stepper::clearance(const Frame& frame)
{
  place(frame);
  const Depths& depth = depths(frame);
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < distance_.size(); ++i)
    smallest = std::min(smallest, distance_[i] + depth.lower[i] + depth.upper[i]);
  return smallest;
}

const Stepper::Depths& Stepper::depths(const Frame& frame)
{
  pair_.surface_depth(pair_.lower(), frame.placement.lower, depths_.lower);
  pair_.surface_depth(pair_.upper(), frame.placement.upper, depths_.upper);
  return depths_;
}

std::pair<double, double> Stepper::residual_range(const Frame& frame) const
{
  const SurfaceGrid& s = pair_.lower().grid().surface;
  const std::vector<double>& residual = pair_.lower().state().residual_displacement;
  const int first = std::max(0, frame.placement.lower.column);
  const int last = std::min(s.nx, frame.placement.lower.column + pair_.grid().nx);
  std::pair<double, double> range{0.0, 0.0};
  for (int j = 0; j < s.ny; ++j)
    for (int i = first; i < last; ++i)
    {
      const double u = residual[static_cast<std::size_t>(i + s.nx * j)];
      range = {std::min(range.first, u), std::max(range.second, u)};
    }
  return range;
}

bool Stepper::touching() const
{
  return std::any_of(pair_.pressure().begin(), pair_.pressure().end(), [](double p) { return p > 0.0; });
}

void Stepper::fill(StepRecord& r) const
{
  const elastoplastic::BodyState& lower = pair_.lower().state();
  const elastoplastic::BodyState& upper = pair_.upper().state();
  for (const double p : pair_.pressure())
  {
    r.contact_area += p > 0.0 ? pair_.grid().cell_area() : 0.0;
    r.max_pressure = std::max(r.max_pressure, p);
  }
  r.F_n = pair_.load();
  r.dissipation_lower = lower.dissipation;
  r.dissipation_upper = upper.dissipation;
  r.energy_residual = lower.locked_in_energy + upper.locked_in_energy;
  r.energy_elastic = pair_.elastic_energy();
  r.max_residual_lower = largest(lower.residual_displacement);
  r.max_residual_upper = largest(upper.residual_displacement);
  r.max_equivalent_plastic_strain = std::max(largest(lower.equivalent), largest(upper.equivalent));
}

Snapshot Stepper::snapshot(const Lattice& lattice, const Frame& frame, double arc_lower, double arc_upper) const
{
  Snapshot s;
  s.contact = pair_.grid();
  s.x0 = frame.x0;
  s.y0 = -0.5 * (s.contact.ny - 1) * s.contact.dy;
  s.pressure.assign(pair_.pressure().begin(), pair_.pressure().end());
  s.gap.assign(pair_.gap().begin(), pair_.gap().end());
  s.lower = body_snapshot(pair_, pair_.lower(), frame.placement.lower, lattice.lower_origin(), arc_lower);
  s.upper = body_snapshot(pair_, pair_.upper(), frame.placement.upper, lattice.upper_origin(), arc_upper);
  return s;
}

std::vector<double> textured(const Texture& texture, const SurfaceGrid& grid, double x0)
{
  if (std::holds_alternative<Smooth>(texture))
    return {};
  std::vector<double> depths(grid.size());
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      depths[static_cast<std::size_t>(i + grid.nx * j)] =
          depth(texture, x0 + i * grid.dx, (j - 0.5 * (grid.ny - 1)) * grid.dy);
  return depths;
}

} // namespace brinell::simulation
