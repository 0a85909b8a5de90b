// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/tugging.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/simulation/forces.hpp"
#include "records.hpp"
#include "stepper.hpp"
#include "tugging_plan.hpp"
#include "tugging_summary.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace brinell::simulation
{

namespace
{

/// The two bodies, the motion, and the sums kept over a run.
class Tugging
{
public:
  Tugging(const TuggingCase& tugging, const Observer<TuggingRecord>& observer)
      : case_(tugging), observer_(observer), plan_(plan(tugging)), cells_(relative_cells(tugging, plan_.contact.dx)),
        passing_(tugging.lower.radius, tugging.upper.radius, tugging.interference, cells_, plan_.contact.dx,
                 tugging.kinematics),
        stepper_(plan_, {tugging.lower.material,
                         tugging.upper.material,
                         [curvature = 0.5 * (1.0 / tugging.lower.radius + 1.0 / tugging.upper.radius)](
                             double x, double y) { return curvature * (x * x + y * y); },
                         tugging.solver,
                         centre(passing_.start(0)),
                         {},
                         {},
                         observer.wants_stop,
                         observer.on_grid_change,
                         observer.available_memory})
  {
  }

  TuggingSummary run(const Archive::Fields* checkpoint)
  {
    resume(*this, checkpoint);
    while (pass_ < case_.passes)
      step();
    TuggingSummary result = summary_.result();
    stepper_.fill(result);
    result.final_state = snapshot();
    return result;
  }

  /// Everything that the rest of the run depends on.
  void exchange(Archive& archive)
  {
    archive("stepper", stepper_);
    archive("summary", summary_);
    archive("position", position_);
    // No pass lasts ten times as long as that of rigid spheres.
    const int most_steps = 10 * passing_.step_count() + 10000;
    archive("pass", pass_, 0, case_.passes);
    archive("step_in_pass", step_in_pass_, 0, most_steps);
    archive("steps_in_pass", steps_in_pass_, 0, most_steps);
    archive("extra_steps", extra_steps_, 0, most_steps);
    if (archive.gives())
      require_on_bodies(position_);
  }

private:
  /// A stored position must not lead off the grids, nor so far that columns could not be counted.
  void require_on_bodies(const Position& p) const
  {
    const double sum = case_.lower.radius + case_.upper.radius;
    const double columns = 10.0 * (plan_.lower.surface.nx + plan_.upper.surface.nx) + 1000.0;
    if (!(std::abs(p.X) <= sum && std::abs(p.columns) <= columns &&
          std::max(std::abs(p.arc_lower), std::abs(p.arc_upper)) <= columns * plan_.contact.dx))
      throw InputError("the stored state has a position that is not on the bodies");
  }
  [[nodiscard]] static Centre centre(const Position& p) { return {p.arc_lower, p.arc_upper}; }

  /// @param steps  of the pass that are done there
  [[nodiscard]] Target target(const Position& p, double steps) const
  {
    if (!case_.load)
      return {centre(p), {contact::Drive::Kind::approach, p.interference}};
    const double ramp = std::max(1.0, steps_in_pass_ / 8.0);
    const double share = std::clamp(std::min(steps, steps_in_pass_ - steps) / ramp, 0.0, 1.0);
    return {centre(p), {contact::Drive::Kind::load, share * *case_.load}};
  }

  [[nodiscard]] Snapshot snapshot() const { return stepper_.snapshot(centre(position_)); }

  /// From one position to the next; the first one of a pass comes from nowhere.
  void step()
  {
    const bool first = step_in_pass_ == 0;
    const Position to = first ? first_position() : passing_.next(position_);
    if (first) // until rigid spheres part; then on while pressure remains
      steps_in_pass_ = (passing_.start(0).index - to.index) + passing_.step_count();
    const bool whole = cells_ == std::round(cells_);
    const auto path = [&](double t)
    {
      const double columns = t * cells_;
      return target(first || t == 1.0 ? to : passing_.within_step(position_, whole ? std::round(columns) : columns),
                    step_in_pass_ - 1.0 + t);
    };
    const int evaluations =
        stepper_.advance(path, first ? 1.0 : 1.0 / cells_, fmt::format("pass {}, X = {:g} m", pass_ + 1, to.X));
    position_ = to;
    record(evaluations);
    const int step_count = case_.passes * (steps_in_pass_ + 1);
    if (step_in_pass_ >= steps_in_pass_ && !stepper_.touching())
    {
      extra_steps_ = std::max(extra_steps_, position_.index - passing_.start(0).index - passing_.step_count());
      step_in_pass_ = 0;
      ++pass_;
    }
    else
      ++step_in_pass_;
    report(observer_, summary_.last(), step_count, *this, [&] { return snapshot(); });
  }

  /// Far enough back that the surfaces, with what earlier passes left on them, do not touch yet.
  Position first_position()
  {
    constexpr int most = 1000;
    for (int before = extra_steps_;; ++before)
    {
      const Position p = passing_.start(before);
      if (case_.load || stepper_.clearance(centre(p)) >= p.interference || before > extra_steps_ + most)
        return p;
    }
  }

  void record(int evaluations)
  {
    const Position& p = position_;
    const double sum = case_.lower.radius + case_.upper.radius;
    const Stepper::Depths& depths = stepper_.depths(centre(p));
    const Forces forces =
        project_forces(stepper_.pair().grid(), stepper_.pair().pressure(), p.theta,
                       {depths.lower, case_.lower.radius / sum}, {depths.upper, case_.upper.radius / sum});
    TuggingRecord r;
    stepper_.fill(r);
    r.step = summary_.steps();
    r.pass = pass_;
    r.interference = case_.load ? stepper_.pair().approach() : p.interference;
    r.theta = p.theta;
    r.X = case_.load ? (sum - r.interference) * std::sin(p.theta) : p.X;
    r.height = case_.load ? (sum - r.interference) * std::cos(p.theta) : passing_.separation();
    r.F_X = forces.F_X;
    r.F_Y = forces.F_Y;
    r.F_Z = forces.F_Z;
    r.F_X_macro = forces.F_X_macro;
    r.F_Z_macro = forces.F_Z_macro;
    r.F_X_lower = forces.F_X_lower;
    r.F_X_upper = forces.F_X_upper;
    r.iterations = evaluations;
    summary_.add(r); // sets the work
  }

  const TuggingCase& case_;
  const Observer<TuggingRecord>& observer_;
  TuggingPlan plan_;
  double cells_; ///< by which the bodies move against each other per step
  Passing passing_;
  Stepper stepper_;
  Summariser summary_;
  Position position_; ///< of the last step
  int pass_ = 0, step_in_pass_ = 0, steps_in_pass_ = 0;
  int extra_steps_ = 0; ///< by which earlier passes lasted longer than that of rigid spheres
};

} // namespace

TuggingSummary run(const TuggingCase& tugging, const Observer<TuggingRecord>& observer,
                   const Archive::Fields* checkpoint)
{
  return Tugging(tugging, observer).run(checkpoint);
}

} // namespace brinell::simulation
