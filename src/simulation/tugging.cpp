// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/tugging.hpp"

#include "brinell/elastoplastic/increment.hpp"
#include "brinell/foundation/error.hpp"
#include "brinell/simulation/forces.hpp"
#include "plan.hpp"
#include "snapshot.hpp"
#include "summary.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace brinell::simulation
{

namespace
{

using elastoplastic::Body;
using elastoplastic::CoupledContact;
using elastoplastic::IncrementReport;
using elastoplastic::Integration;

/// The two bodies, the motion, and the sums kept over a run.
class Tugging
{
public:
  Tugging(const TuggingCase& tugging, const TuggingObserver& observer)
      : case_(tugging), observer_(observer), plan_(plan(tugging)), cells_(relative_cells(tugging, plan_.contact.dx)),
        passing_(tugging.lower.radius, tugging.upper.radius, tugging.interference, cells_, plan_.contact.dx,
                 tugging.kinematics),
        pair_(plan_.contact, plan_.lower, plan_.upper, tugging.lower.material, tugging.upper.material,
              {yield_interference(tugging), tugging.interference}, tugging.solver, plan_.mirrored),
        rigid_gap_(plan_.contact.size()), lower_residual_(plan_.contact.size()), upper_residual_(plan_.contact.size())
  {
  }

  TuggingSummary run()
  {
    for (int pass = 0; pass < case_.passes; ++pass)
      run_pass(pass);
    TuggingSummary result = summary_.result();
    result.split_increments = split_increments_;
    result.final_state = snapshot(pair_, frame(last_), summary_.last());
    return result;
  }

private:
  /// Contact grid relative to the bodies at one position.
  Frame frame(const Position& p) const
  {
    const double dx = plan_.contact.dx;
    Frame f;
    f.position = p;
    const int lower_zero = (plan_.lower.surface.nx - 1) / 2;
    const int upper_zero = (plan_.upper.surface.nx - 1) / 2;
    const int half = (plan_.contact.nx - 1) / 2;
    // Lower column of the contact's central cell; the centre of contact is at most half a cell away from it.
    const int centre = static_cast<int>(std::lround(p.arc_lower / dx));
    f.placement.lower = centre - half + lower_zero;
    f.x0 = (centre - half) * dx - p.arc_lower;
    // The grids of both bodies coincide cell by cell; their relative column changes by whole cells only.
    const Position start = passing_.start(0);
    const int start_columns = static_cast<int>(std::lround((start.arc_lower - start.arc_upper) / dx));
    const int columns = start_columns + p.columns - start.columns;
    f.placement.upper = centre - columns - half + upper_zero;
    f.upper_origin = f.x0 - (f.placement.upper) * dx + p.arc_upper;
    f.lower_origin = -lower_zero * dx;
    return f;
  }

  void fill_rigid_gap(const Frame& f)
  {
    const SurfaceGrid& g = plan_.contact;
    const double curvature = 0.5 * (1.0 / case_.lower.radius + 1.0 / case_.upper.radius);
    for (int j = 0; j < g.ny; ++j)
      for (int i = 0; i < g.nx; ++i)
      {
        const double x = f.x0 + i * g.dx;
        const double y = (j - 0.5 * (g.ny - 1)) * g.dy;
        rigid_gap_[static_cast<std::size_t>(i + g.nx * j)] = curvature * (x * x + y * y) - f.position.interference;
      }
  }

  void run_pass(int pass)
  {
    Position position = first_position();
    // The first position of a pass has no contact; from there until rigid spheres part, and on while pressure remains.
    const int steps = (passing_.start(0).index - position.index) + passing_.step_count();
    for (int step = 0;; ++step)
    {
      const int evaluations = solve(step == 0 ? position : last_, position, pass);
      record(position, pass, evaluations, steps);
      check_extent("lower", pair_.lower());
      check_extent("upper", pair_.upper());
      last_ = position;
      const bool touching =
          std::any_of(pair_.pressure().begin(), pair_.pressure().end(), [](double p) { return p > 0.0; });
      if (step >= steps && !touching)
        break;
      position = passing_.next(position);
    }
    extra_steps_ = std::max(extra_steps_, last_.index - passing_.start(0).index - passing_.step_count());
  }

  /// Plastic strain that would spread beyond the grid is lost: better no result than that one.
  static void check_extent(const char* name, const Body& body)
  {
    constexpr double tolerated = 0.02;
    const Body::EdgeStrain edge = body.edge_strain();
    for (const auto& [share, where] :
         {std::pair{edge.ends, "end, along x,"}, {edge.sides, "side, along y,"}, {edge.bottom, "bottom"}})
      if (share > tolerated)
        throw InputError(fmt::format(
            "the plastic zone of the {} body has reached the {} of its grid ({:.0f} % of the largest plastic "
            "strain there): enlarge it by grid.extent. All steps so far are kept",
            name, where, 100.0 * share));
  }

  /// Far enough back that the surfaces, with what earlier passes left on them, do not touch yet.
  Position first_position()
  {
    for (int before = extra_steps_;; ++before)
    {
      const Position p = passing_.start(before);
      const Frame f = frame(p);
      fill_rigid_gap(f);
      gather_residual(f);
      double smallest = 1.0;
      for (std::size_t i = 0; i < rigid_gap_.size(); ++i)
        smallest = std::min(smallest, rigid_gap_[i] + lower_residual_[i] + upper_residual_[i]);
      if (smallest >= 0.0 || before > extra_steps_ + 1000)
        return p;
    }
  }

  void gather_residual(const Frame& f)
  {
    pair_.gather(pair_.lower(), f.placement.lower, pair_.lower().state().residual_displacement, lower_residual_);
    pair_.gather(pair_.upper(), f.placement.upper, pair_.upper().state().residual_displacement, upper_residual_);
  }

  /// One step from the last position. If it does not converge whole, it is split into moves of one cell; a move that
  /// still does not is solved by the plain fixed point of the convex problem, watched by its energy.
  int solve(const Position& from, const Position& to, int pass)
  {
    int evaluations = 0;
    if (attempt(to, evaluations))
      return evaluations;
    ++split_increments_;
    const int columns = std::max(1, to.columns - from.columns); // the first position of a pass comes from nowhere
    for (int c = 1; c <= columns; ++c)
    {
      const Position position = c == columns ? to : passing_.within_step(from, c);
      if (!(columns > 1 && attempt(position, evaluations)))
        solve_guarded(position, pass, evaluations);
    }
    return evaluations;
  }

  /// Accelerated: first with a cell's own stiffness, then with that which bounds all.
  bool attempt(const Position& position, int& evaluations)
  {
    const elastoplastic::Settings& s = case_.solver;
    const Frame f = frame(position);
    fill_rigid_gap(f);
    for (const double share : {0.6, 1.0})
    {
      const IncrementReport report =
          pair_.advance(rigid_gap_, f.placement, {s.integration, s.max_iterations, s.anderson_depth, share, false});
      evaluations += report.evaluations;
      if (report.converged)
        return true;
    }
    return false;
  }

  void solve_guarded(const Position& position, int pass, int& evaluations)
  {
    const elastoplastic::Settings& s = case_.solver;
    const Frame f = frame(position);
    fill_rigid_gap(f);
    IncrementReport report;
    constexpr int patience = 20; // the plain fixed point is slow, but it descends
    const bool has_energy = case_.lower.material.kinematic.empty() && case_.upper.material.kinematic.empty();
    for (const double share : {1.0, 2.0, 4.0})
    {
      report = pair_.advance(rigid_gap_, f.placement,
                             {Integration::backward_euler, patience * s.max_iterations, 0, share, has_energy});
      evaluations += report.evaluations;
      if (report.converged)
        return;
      if (has_energy && !report.energy_rose)
        break;
    }
    throw ConvergenceError(fmt::format(
        "pass {}, X = {:g} m: no convergence after {} evaluations; yield violation {:.2e} S_y (allowed {:.2e}), "
        "change of displacement {:.2e} m, contact gap {:.2e} m. All earlier steps are kept. A smaller tugging.shift "
        "or a larger solver.max_iterations may help",
        pass + 1, position.X, evaluations, report.yield_error, s.yield_tolerance, report.displacement_error,
        report.gap_error));
  }

  void record(const Position& position, int pass, int evaluations, int steps_per_pass)
  {
    const Frame f = frame(position);
    gather_residual(f);
    const double sum = case_.lower.radius + case_.upper.radius;
    const Forces forces =
        project_forces(plan_.contact, pair_.pressure(), position.theta, {lower_residual_, case_.lower.radius / sum},
                       {upper_residual_, case_.upper.radius / sum});
    StepRecord r;
    r.step = step_++;
    r.pass = pass;
    r.X = position.X;
    r.theta = position.theta;
    r.interference = position.interference;
    for (const double p : pair_.pressure())
    {
      r.contact_area += p > 0.0 ? plan_.contact.cell_area() : 0.0;
      r.max_pressure = std::max(r.max_pressure, p);
    }
    r.F_n = forces.F_n;
    r.F_X = forces.F_X;
    r.F_Y = forces.F_Y;
    r.F_Z = forces.F_Z;
    r.F_X_macro = forces.F_X_macro;
    r.F_Z_macro = forces.F_Z_macro;
    r.F_X_lower = forces.F_X_lower;
    r.F_X_upper = forces.F_X_upper;
    const auto& lower = pair_.lower().state();
    const auto& upper = pair_.upper().state();
    r.dissipation_lower = lower.dissipation;
    r.dissipation_upper = upper.dissipation;
    r.energy_residual = lower.locked_in_energy + upper.locked_in_energy;
    r.energy_elastic = pair_.elastic_energy();
    r.max_residual_lower = *std::max_element(lower.residual_displacement.begin(), lower.residual_displacement.end());
    r.max_residual_upper = *std::max_element(upper.residual_displacement.begin(), upper.residual_displacement.end());
    r.max_equivalent_plastic_strain = std::max(*std::max_element(lower.equivalent.begin(), lower.equivalent.end()),
                                               *std::max_element(upper.equivalent.begin(), upper.equivalent.end()));
    r.iterations = evaluations;
    summary_.add(r); // sets the work
    if (observer_.on_step)
      observer_.on_step(summary_.last(), case_.passes * (steps_per_pass + 1));
    if (observer_.wants_snapshot && observer_.on_snapshot && observer_.wants_snapshot(summary_.last()))
      observer_.on_snapshot(snapshot(pair_, f, summary_.last()));
  }

  const TuggingCase& case_;
  const TuggingObserver& observer_;
  TuggingPlan plan_;
  int cells_;
  Passing passing_;
  CoupledContact pair_;
  std::vector<double> rigid_gap_, lower_residual_, upper_residual_;
  Summariser summary_;
  Position last_;
  int step_ = 0;
  int extra_steps_ = 0;
  int split_increments_ = 0;
};

} // namespace

TuggingSummary run(const TuggingCase& tugging, const TuggingObserver& observer)
{
  return Tugging(tugging, observer).run();
}

} // namespace brinell::simulation
