// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/tugging.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/simulation/forces.hpp"
#include "run_state.hpp"
#include "tugging_peaks.hpp"
#include "tugging_plan.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace brinell::simulation
{

namespace
{

/// The upper asperity is carried past the lower one, pass after pass.
class Tugging
{
public:
  Tugging(const TuggingCase& tugging, const TuggingPlan& plan)
      : case_(tugging), plan_(plan), cells_(relative_cells(plan.shift, plan.contact.dx)),
        passing_(passing(tugging, plan.shift, plan.contact.dx)),
        sum_(passing_.radius_lower() + passing_.radius_upper()), position_(passing_.start(0)), lead_(lead_steps())
  {
  }

  [[nodiscard]] Stepper::Setup setup() const
  {
    Stepper::Setup setup = setup_of(case_, centre(passing_.start(0)), plan_.heat_times);
    setup.beside = {plan_.closest.y_lower, plan_.closest.y_upper};
    if (setup.sliding.heat)
      setup.sliding.heat->times = heat_times();
    if (equivalent_radius(case_.lower.shape, case_.upper.shape)) // a round pair: one paraboloid has less rounding
      setup.distance = [curvature = 0.5 * (*relative_curvature(case_.lower.shape, case_.upper.shape))[0]](
                           double x, double y) { return curvature * (x * x + y * y); };
    return setup;
  }
  [[nodiscard]] Centre centre() const { return centre(position_); }
  [[nodiscard]] bool is_done() const { return pass_ == case_.passes; }
  [[nodiscard]] int step_count() const { return case_.passes * (steps_in_pass_ + 1); }

  /// Moves to the next position; at the first one of a pass the bodies are put down.
  [[nodiscard]] Move next(Stepper& stepper)
  {
    const bool first = step_in_pass_ == 0;
    to_ = first ? first_position(stepper) : passing_.next(position_);
    if (first) // steps until rigid spheres part; the pass continues as long as there is pressure
      steps_in_pass_ = (passing_.start(0).index - to_.index) + passing_.step_count();
    const bool whole = cells_ == std::round(cells_);
    const auto path = [this, first, whole](double t)
    {
      const double columns = t * cells_;
      const Position p =
          first || t == 1.0 ? to_ : passing_.within_step(position_, whole ? std::round(columns) : columns);
      Target there = target(p);
      const Moment moment = moment_at(p);
      there.time = moment.time;
      there.slid = moment.slid;
      there.is_put_down = first;
      there.returns = first;
      return there;
    };
    return {path, first ? 1.0 : 1.0 / cells_, fmt::format("pass {}, X = {:g} m", pass_ + 1, to_.X)};
  }

  void read(Stepper& stepper, const TuggingRecord& before, TuggingRecord& r)
  {
    moment_ = moment_at(to_);
    position_ = to_;
    r.pass = pass_ + 1;
    record(stepper, r);
    interference_ = r.interference;
    r.work += work_between(before, r);
    r.dissipation_friction += friction_work_between(before, r) - stepper.shear_work();
    add(before, r, peaks_);
    if (step_in_pass_ >= steps_in_pass_ && have_parted(stepper))
    {
      extra_steps_ = std::max(extra_steps_, position_.index - passing_.start(0).index - passing_.step_count());
      step_in_pass_ = 0;
      ++pass_;
    }
    else
      ++step_in_pass_;
  }

  void summarise(TuggingSummary& summary, const StepFields& /*end*/) const
  {
    static_cast<TuggingPeaks&>(summary) = peaks_;
  }

  void exchange(Archive& archive)
  {
    archive("peaks", peaks_);
    archive("position", position_);
    // A plausible limit for stored values: no pass takes ten times as many steps as one of rigid spheres.
    const int max_steps = 10 * passing_.step_count() + 10000;
    archive("pass", pass_, 0, case_.passes);
    archive("step_in_pass", step_in_pass_, 0, max_steps);
    archive("steps_in_pass", steps_in_pass_, 0, max_steps);
    archive("extra_steps", extra_steps_, 0, max_steps);
    archive("time", moment_.time);
    archive("slid", moment_.slid);
    archive("interference", interference_);
    if (archive.gives())
      require_on_bodies(position_);
  }

private:
  /// Checks that a restored position lies on the bodies, with columns in the range of integers.
  void require_on_bodies(const Position& p) const
  {
    const double columns = 10.0 * (plan_.lower.surface.nx + plan_.upper.surface.nx) + 1000.0;
    if (!(std::abs(p.X) <= sum_ && std::abs(p.columns) <= columns &&
          std::max(std::abs(p.arc_lower), std::abs(p.arc_upper)) <= columns * plan_.contact.dx))
      throw InputError("the stored state has a position that is not on the bodies");
  }
  [[nodiscard]] static Centre centre(const Position& p) { return {p.arc_lower, p.arc_upper}; }

  [[nodiscard]] Target target(const Position& p) const
  {
    if (!case_.load)
      return {centre(p), {contact::Drive::Kind::approach, p.interference}};
    return {centre(p), {contact::Drive::Kind::load, share_of_load(p.theta) * *case_.load}};
  }

  /// The load rises in the first eighth of the way on which the rigid bodies would touch, and falls in the last: by
  /// place and not by step, so that the work does not depend on where the steps begin.
  [[nodiscard]] double share_of_load(double theta) const
  {
    const double touch = passing_.angle_at_touch();
    const double share = (touch - std::abs(theta)) / (0.25 * touch);
    constexpr double rounding = 1e-9; // where a step ends at the end of the way
    return share > rounding ? std::min(share, 1.0) : 0.0;
  }

  /// Time [s] and sliding distance of the undeformed surfaces [m] since the start.
  struct Moment
  {
    double time = 0.0, slid = 0.0;
  };
  /// Moment at a position at the end of a step or within it; without a speed at the time 0.
  [[nodiscard]] Moment moment_at(const Position& p) const
  {
    const double second_per_column = case_.speed ? plan_.contact.dx / *case_.speed : 0.0;
    if (step_in_pass_ == 0) // includes the time of the way back
      return {moment_.time + (pass_ == 0 ? 0.0 : steps_in_pass_ * cells_ * second_per_column), moment_.slid};
    const double interference = case_.load ? interference_ : 0.5 * (position_.interference + p.interference);
    return {moment_.time + (p.columns - position_.columns) * second_per_column,
            moment_.slid + (sum_ - interference) * (p.theta - position_.theta)};
  }
  /// Durations of a heated run, with those of the further steps of textured bodies.
  [[nodiscard]] halfspace::HeatTimes heat_times() const
  {
    const double step = cells_ * plan_.contact.dx / *case_.speed;
    halfspace::HeatTimes times = plan_.heat_times;
    times.duration += step * case_.passes * (reserve_of_heated_pass * 2.0 * lead_);
    return times;
  }

  /// Number of steps by which textured bodies may touch earlier, and part later, than smooth ones.
  [[nodiscard]] int lead_steps() const
  {
    const double height = plan_.texture_height;
    if (case_.load || height == 0.0) // under a load the bodies touch from the first step on
      return 0;
    int lead = 0;
    while (passing_.start(lead).interference > -height)
      ++lead;
    return lead;
  }

  /// Whether the surfaces, with textures and residual displacements, would overlap at a position.
  [[nodiscard]] bool overlap(Stepper& stepper, const Position& p) const
  {
    return stepper.distances(centre(p)).smallest < p.interference;
  }

  /// First position of a pass: far enough back that the surfaces do not touch yet.
  Position first_position(Stepper& stepper) const
  {
    int before = extra_steps_;
    if (case_.load)
      return passing_.start(before);
    for (int farthest = lead_; farthest > before; --farthest) // textured surfaces may touch, part and touch again
      if (overlap(stepper, passing_.start(farthest)))
        before = farthest;
    constexpr int max_steps = 1000;
    const int last = before + max_steps;
    while (before <= last && overlap(stepper, passing_.start(before)))
      ++before;
    return passing_.start(before);
  }

  /// Whether the bodies do not touch, and will not touch on the rest of the pass.
  [[nodiscard]] bool have_parted(Stepper& stepper) const
  {
    if (touches(stepper.pair()))
      return false;
    const int last = passing_.start(0).index + passing_.step_count() + lead_;
    for (Position p = position_; p.index < last;)
    {
      p = passing_.next(p);
      if (overlap(stepper, p))
        return false;
    }
    return true;
  }

  void record(Stepper& stepper, TuggingRecord& r) const
  {
    const Position& p = position_;
    const Stepper::Depths& depths = stepper.loaded_depths(centre(p));
    const Forces forces =
        project_forces(stepper.pair().grid(), surface_load(stepper.pair()), p.theta,
                       {depths.lower, passing_.radius_lower() / sum_}, {depths.upper, passing_.radius_upper() / sum_});
    r.interference = case_.load ? stepper.pair().approach() : p.interference;
    r.theta = p.theta;
    r.X = case_.load ? (sum_ - r.interference) * std::sin(p.theta) : p.X;
    // The plane of motion is tilted about X: forces are rotated back to Y and Z.
    const double cosine = std::cos(plan_.closest.tilt), sine = std::sin(plan_.closest.tilt);
    r.height = case_.load ? (sum_ - r.interference) * std::cos(p.theta) : passing_.separation() * cosine;
    r.F_X = forces.F_X;
    r.F_Y = forces.F_Y * cosine + forces.F_Z * sine;
    r.F_Z = forces.F_Z * cosine - forces.F_Y * sine;
    r.F_X_macro = forces.F_X_macro;
    r.F_Z_macro = forces.F_Z_macro * cosine;
    r.F_X_lower = forces.F_X_lower;
    r.F_X_upper = forces.F_X_upper;
    r.F_X_friction = forces.F_X_friction;
    r.F_Z_friction = forces.F_Z_friction * cosine;
  }

  const TuggingCase& case_;
  const TuggingPlan& plan_;
  double cells_; ///< cells by which the bodies move relative to each other per step
  Passing passing_;
  double sum_; ///< of the radii [m]
  TuggingPeaks peaks_;
  Position position_, to_; ///< at the end of the last step, and of the current one
  int lead_;
  int pass_ = 0, step_in_pass_ = 0, steps_in_pass_ = 0;
  int extra_steps_ = 0; ///< largest number of steps by which earlier passes were longer than that of rigid spheres
  Moment moment_;       ///< at the end of the last step
  double interference_ = 0.0; ///< at the end of the last step; under a load, the approach [m]
};

} // namespace

void TuggingRecord::exchange(Archive& archive)
{
  exchange_row(*this, archive);
  archive("F_X_lower", F_X_lower); // this and the following are not columns of the history
  archive("F_X_upper", F_X_upper);
  archive("F_X_friction", F_X_friction);
  archive("F_Z_friction", F_Z_friction);
}

template <>
struct MotionOf<TuggingCase>
{
  using Type = Tugging;
};

template class Run<TuggingCase>;

} // namespace brinell::simulation
