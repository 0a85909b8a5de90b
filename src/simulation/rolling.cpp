// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/rolling.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/simulation/forces.hpp"
#include "footprint.hpp"
#include "records.hpp"
#include "stepper.hpp"
#include "track.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace brinell::simulation
{

namespace
{

using contact::Drive;

class Rolling
{
public:
  Rolling(const RollingCase& rolling, const Observer<RollingRecord>& observer)
      : case_(rolling), observer_(observer), plan_(plan(rolling)), share_(upper_share(rolling)),
        start_(-0.5 * plan_.rolling_steps * plan_.shift),
        stepper_(plan_, {rolling.lower.material,
                         rolling.upper.material,
                         [&rolling](double x, double y)
                         { return height(rolling.lower.shape, x, y) + height(rolling.upper.shape, x, y); },
                         rolling.solver,
                         {start_, share_ * start_},
                         rolling.lower.texture,
                         rolling.upper.texture,
                         observer.wants_stop,
                         observer.on_grid_change,
                         observer.available_memory}),
        track_(rolling.distance, plan_.shift)
  {
  }

  RollingSummary run(const Archive::Fields* checkpoint)
  {
    resume(*this, checkpoint);
    while (pass_ < case_.passes)
      step();
    RollingSummary result;
    result.steps = steps_;
    result.iterations = iterations_;
    stepper_.fill(result);
    take_totals(last_, largest_work_, result);
    result.passes = passes_;
    result.last = last_;
    result.final_state = snapshot(last_.x);
    result.profile = track_profile(result.final_state.lower);
    return result;
  }

  /// Everything that the rest of the run depends on.
  void exchange(Archive& archive)
  {
    archive("stepper", stepper_);
    archive("last", last_);
    archive("track", track_);
    archive.list("passes", passes_);
    archive("largest_work", largest_work_);
    archive("touch", touch_);
    archive("iterations", iterations_, 0, std::numeric_limits<long>::max());
    archive("steps", steps_, 0, plan_.steps);
    archive("pass", pass_, 0, case_.passes);
    archive("step_in_pass", step_in_pass_, 0, steps_per_pass() - 1);
  }

private:
  /// Contact's centre on the lower body and share of the drive after some steps of a pass: press, roll, lift.
  struct Moment
  {
    double x;
    double drive;
  };
  [[nodiscard]] Moment moment(double steps) const
  {
    const double press = case_.load_steps;
    const double roll = plan_.rolling_steps;
    const double rolled = std::clamp(steps - press, 0.0, roll);
    const double lifted = std::max(0.0, steps - press - roll) / press;
    return {(rolled - 0.5 * roll) * plan_.shift, // exactly 0 in the middle
            std::min(steps / press, 1.0) - lifted};
  }
  [[nodiscard]] int steps_per_pass() const { return 2 * case_.load_steps + plan_.rolling_steps; }
  [[nodiscard]] Centre centre(double x) const { return {x, share_ * x}; }
  [[nodiscard]] Snapshot snapshot(double x) const { return stepper_.snapshot(centre(x)); }

  /// An imposed approach begins and ends where the surfaces touch, dents and bumps included.
  [[nodiscard]] Drive drive(double share) const
  {
    return {case_.drive.kind, touch_ + (case_.drive.value - touch_) * share};
  }

  void step()
  {
    const Centre before = centre(moment(step_in_pass_).x);
    if (step_in_pass_ == 0)
    {
      track_.begin_pass(stepper_.pair().lower(), dissipation());
      last_.approach = stepper_.clearance(before);
      last_.F_n = last_.F_X = 0.0;
      last_.x = start_;
    }
    if (step_in_pass_ == 0 || step_in_pass_ == case_.load_steps + plan_.rolling_steps)
      touch_ = case_.drive.kind == Drive::Kind::load ? 0.0 : std::min(stepper_.clearance(before), case_.drive.value);
    const Moment to = moment(step_in_pass_ + 1);
    if (step_in_pass_ + 1 == steps_per_pass()) // lifted: what has yielded on the way counts
      touch_ = case_.drive.kind == Drive::Kind::load ? 0.0 : std::min(touch_, stepper_.clearance(centre(to.x)));
    const auto path = [&](double t)
    {
      const Moment m = moment(step_in_pass_ + t);
      return Target{centre(m.x), drive(m.drive)};
    };
    const double cells = plan_.shift / plan_.contact.dx;
    const bool moves = step_in_pass_ >= case_.load_steps && step_in_pass_ < case_.load_steps + plan_.rolling_steps;
    const double finest = moves ? std::min(1.0, 0.5 / cells) : 1.0 / 64;
    record(stepper_.advance(path, finest, fmt::format("pass {}, x = {:g} m", pass_ + 1, to.x)), to.x);
    if (++step_in_pass_ == steps_per_pass())
    {
      passes_.push_back(track_.end_pass(stepper_.pair(), dissipation()));
      step_in_pass_ = 0;
      ++pass_;
    }
    report(observer_, last_, plan_.steps, *this, [this, x = to.x] { return snapshot(x); });
  }

  [[nodiscard]] double dissipation() const
  {
    return stepper_.pair().lower().state().dissipation + stepper_.pair().upper().state().dissipation;
  }

  void record(int evaluations, double x)
  {
    RollingRecord r;
    stepper_.fill(r);
    const Centre here = centre(x);
    const Stepper::Depths& depths = stepper_.depths(here);
    r.step = steps_++;
    r.pass = pass_;
    r.x = x;
    r.approach = r.F_n > 0.0 ? stepper_.pair().approach() : stepper_.clearance(here);
    r.F_X = rolling_resistance(stepper_.pair().grid(), stepper_.pair().pressure(), depths.lower, depths.upper, share_);
    r.iterations = evaluations;
    r.work = last_.work + 0.5 * (r.F_n + last_.F_n) * (r.approach - last_.approach) +
             0.5 * (r.F_X + last_.F_X) * (r.x - last_.x);
    largest_work_ = std::max(largest_work_, r.work);
    iterations_ += evaluations;
    track_.add(r);
    last_ = r;
  }

  const RollingCase& case_;
  const Observer<RollingRecord>& observer_;
  RollingPlan plan_;
  double share_; ///< distance on the upper body per distance on the lower one
  double start_; ///< of the track [m]
  Stepper stepper_;
  TrackReader track_;
  RollingRecord last_;
  std::vector<RollingPass> passes_;
  double largest_work_ = 0.0;
  double touch_ = 0.0; ///< where an imposed approach comes from and goes back to: the surfaces touch [m]
  long iterations_ = 0;
  int steps_ = 0, pass_ = 0, step_in_pass_ = 0;
};

/// Whether both bodies always have the same history: then one is solved and its residual displacement counts twice.
bool are_twins(const RollingCase& rolling, const RollingPlan& plan)
{
  return rolling.solver.mirror && rolling.slide_to_roll == 0.0 && plan.lower == plan.upper &&
         alike(rolling.lower, rolling.upper);
}

} // namespace

double upper_share(const RollingCase& rolling)
{
  return (2.0 - rolling.slide_to_roll) / (2.0 + rolling.slide_to_roll);
}

RollingPlan plan(const RollingCase& rolling)
{
  if (!(rolling.drive.value > 0.0))
    throw InputError("rolling needs a load or an approach > 0");
  const Footprint f = footprint(rolling.lower, rolling.upper, rolling.drive);
  RollingPlan plan;
  plan.half_width_x = f.half_x;
  plan.half_width_y = f.half_y;
  plan.shift = rolling.shift.value_or(cell_sizes(rolling, f)[0]);
  if (!(plan.shift <= 0.5 * rolling.distance))
    throw InputError(
        fmt::format("a shift of {:g} m in {:g} m; allowed: up to half of the distance", plan.shift, rolling.distance));
  // An even number, so that the middle of the track is reached.
  plan.rolling_steps = 2 * std::max(1, step_count(std::round(0.5 * rolling.distance / plan.shift)));
  const double track = 0.5 * plan.rolling_steps * plan.shift;
  lay_out(rolling, f, track, upper_share(rolling) * track, plan);
  plan.steps = step_count(static_cast<double>(rolling.passes) * (plan.rolling_steps + 2.0 * rolling.load_steps));
  plan.twin = are_twins(rolling, plan) ? elastoplastic::Twin::alike : elastoplastic::Twin::none;
  plan.memory_bytes = memory_bytes(plan, rolling.lower.material.is_plastic(), rolling.upper.material.is_plastic(),
                                   rolling.solver.anderson_depth);
  return plan;
}

RollingSummary run(const RollingCase& rolling, const Observer<RollingRecord>& observer,
                   const Archive::Fields* checkpoint)
{
  return Rolling(rolling, observer).run(checkpoint);
}

} // namespace brinell::simulation
