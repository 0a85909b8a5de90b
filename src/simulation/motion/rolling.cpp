// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/rolling.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/simulation/forces.hpp"
#include "drive_meter.hpp"
#include "pressing.hpp"
#include "rolling_plan.hpp"
#include "run_state.hpp"
#include "simulation/plan/friction.hpp"
#include "slip_reading.hpp"
#include "track.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace brinell::simulation
{

namespace
{

using contact::Drive;
using contact::TangentialDrive;

/// Motion of rolling: press, roll and lift in each pass.
class Rolling
{
public:
  Rolling(const RollingCase& rolling, const RollingPlan& plan)
      : case_(rolling), plan_(plan), share_(upper_share(rolling)), track_(plan.way(), plan.shift)
  {
    meter_.begin(moment(0.0).x, 0.0);
  }

  [[nodiscard]] Stepper::Setup setup() const
  {
    Stepper::Setup setup = setup_of(case_, centre(moment(0.0).x), plan_.heat_times);
    setup.sliding.direction = case_.slide_to_roll < 0.0 ? -1 : 1;
    setup.sliding.sticks = case_.creepage.has_value();
    return setup;
  }
  [[nodiscard]] Centre centre() const { return centre(meter_.last().x); }
  [[nodiscard]] bool is_done() const { return pass_ == case_.passes; }
  [[nodiscard]] int step_count() const { return plan_.steps; }

  [[nodiscard]] Move next(Stepper& stepper)
  {
    const Centre from = centre(moment(step_in_pass_).x);
    if (step_in_pass_ == 0)
    {
      track_.begin_pass(stepper.pair().lower().solved());
      meter_.begin(moment(0.0).x, stepper.distances(from).smallest);
    }
    if (step_in_pass_ == 0 || step_in_pass_ == case_.load_steps + plan_.rolling_steps)
      touch_ = by_load() ? 0.0 : std::min(stepper.distances(from).smallest, case_.drive.value);
    const double to = moment(step_in_pass_ + 1).x;
    if (step_in_pass_ + 1 == steps_per_pass()) // lifting off, from the surfaces with their residual displacement
      touch_ = by_load() ? 0.0 : std::min(touch_, stepper.distances(centre(to)).smallest);
    const bool moves = is_rolling();
    const auto path = [this, moves](double t)
    {
      const Moment m = moment(step_in_pass_ + t);
      Target target{centre(m.x), drive(m.drive), moves, along(m.x)};
      target.time = time(step_in_pass_ + t);
      target.slid = slid(step_in_pass_ + t);
      target.is_put_down = step_in_pass_ == 0;
      target.returns = step_in_pass_ + 1 == steps_per_pass();
      if (!moves && case_.speed)
        target.passing = {*case_.speed, share_ * *case_.speed};
      return target;
    };
    const double cells = plan_.shift / plan_.contact.dx;
    return {path, moves ? std::min(1.0, 0.5 / cells) : finest_press, fmt::format("pass {}, x = {:g} m", pass_ + 1, to),
            moves, [this, &stepper] { read_onset(stepper); }};
  }

  void read(Stepper& stepper, const RollingRecord& before, RollingRecord& r)
  {
    r.pass = pass_ + 1;
    r.x = moment(step_in_pass_ + 1).x;
    const Centre here = centre(r.x);
    const Stepper::Depths& depths = stepper.loaded_depths(here);
    r.approach = r.F_n > 0.0 ? stepper.pair().approach() : stepper.distances(here).smallest;
    r.F_X = rolling_resistance(stepper.pair().grid(), stepper.pair().pressure(), depths.lower, depths.upper, share_);
    const double sliding_force = (1.0 - share_) * (share_ < 1.0 ? r.F_friction : -r.F_friction);
    r.F_X += sliding_force;
    if (is_rolling()) // where it begins to roll, the surfaces slide under the full shear before they move
      meter_.start_with_shear((1.0 - share_) * stepper.shear_force_at_start());
    const DriveMeter::Work work = meter_.to({r.x, r.approach, r.F_n, r.F_X, sliding_force});
    r.work += work.drive;
    r.dissipation_friction += work.shear - stepper.shear_work();
    read_shear(stepper, r);
    r.friction = force_ratio(r.F_X, r.F_n, plan_);
    track_.add(before, r);
    if (++step_in_pass_ < steps_per_pass())
      return;
    passes_.push_back(track_.end_pass(stepper.pair()));
    passes_.back().pass = ++pass_;
    step_in_pass_ = 0;
  }

  void summarise(RollingSummary& summary, const StepFields& end) const
  {
    summary.passes = passes_;
    summary.profile = track_profile(end.surfaces.lower.grid, end.lower);
  }

  void exchange(Archive& archive)
  {
    archive("drive", meter_);
    archive("creep_work", creep_work_);
    archive("track", track_);
    archive.list("passes", passes_);
    archive("touch", touch_);
    archive("pass", pass_, 0, case_.passes);
    archive("step_in_pass", step_in_pass_, 0, steps_per_pass() - 1);
    if (archive.gives() && !(std::abs(meter_.last().x) <= plan_.way()))
      throw InputError("the stored state has a place that is not on the track");
  }

private:
  /// Position of the contact's centre on the lower body [m], and factor on the drive.
  struct Moment
  {
    double x;
    double drive;
  };
  /// Moment after a number of steps of a pass, which may be fractional.
  [[nodiscard]] Moment moment(double steps) const
  {
    const double press = case_.load_steps;
    const double roll = plan_.rolling_steps;
    const double rolled = std::clamp(steps - press, 0.0, roll);
    const double lifted = std::max(0.0, steps - press - roll) / press;
    return {(rolled - 0.5 * roll) * plan_.shift, // exactly 0 in the middle
            std::min(steps / press, 1.0) - lifted};
  }
  /// Accumulated creep displacement of the upper body over the lower one when the contact is at x in this pass; it does not
  /// change while the body is pressed on or lifted off.
  [[nodiscard]] TangentialDrive along(double x) const
  {
    const Creepage creepage = case_.creepage.value_or(Creepage{});
    const double track = plan_.way();
    const double rolled = pass_ * track + (x + 0.5 * track);
    return {{TangentialDrive::Kind::shift, creepage.longitudinal * rolled},
            {TangentialDrive::Kind::shift, creepage.lateral * rolled},
            creepage.spin * rolled};
  }
  /// Whether the contact moves in the current step.
  [[nodiscard]] bool is_rolling() const
  {
    return step_in_pass_ >= case_.load_steps && step_in_pass_ < case_.load_steps + plan_.rolling_steps;
  }
  /// Takes over the forces under which the contact begins to roll, when friction has been raised at rest.
  void read_onset(Stepper& stepper)
  {
    const Stepper::Depths& depths = stepper.loaded_depths(centre(meter_.last().x));
    const double resistance =
        rolling_resistance(stepper.pair().grid(), stepper.pair().pressure(), depths.lower, depths.upper, share_);
    meter_.read_onset(stepper.pair(),
                      [&](double force)
                      {
                        const double shear = (1.0 - share_) * force;
                        return std::pair{resistance + shear, shear};
                      });
  }
  /// Fills the tangential forces and, with partial slip, work, heat and stick of the creepage.
  void read_shear(const Stepper& stepper, RollingRecord& r)
  {
    const SurfaceGrid& grid = stepper.pair().grid();
    const halfspace::SurfaceLoad load = surface_load(stepper.pair());
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i)
      {
        const std::size_t cell = grid.index(i, j);
        const double x = load.shear_x.empty() ? 0.0 : load.shear_x[cell] * grid.cell_area();
        const double y = load.shear_y.empty() ? 0.0 : load.shear_y[cell] * grid.cell_area();
        r.F_x += x;
        r.F_y += y;
        r.M_z += grid.x(i) * y - grid.y(j) * x;
      }
    const elastoplastic::PartialSlip* slip = stepper.pair().partial_slip();
    if (slip == nullptr)
      return;
    if (case_.creepage && is_rolling())
      r.F_X += case_.creepage->longitudinal * r.F_x + case_.creepage->lateral * r.F_y + case_.creepage->spin * r.M_z;
    read_slip(*slip, creep_work_, r);
  }
  /// Time since the start after a number of steps of a pass [s]; 0 without a speed. The way back belongs to the last step, in
  /// which the surfaces part.
  [[nodiscard]] double time(double steps) const
  {
    if (!case_.speed)
      return 0.0;
    const double rolled = std::clamp(steps - case_.load_steps, 0.0, static_cast<double>(plan_.rolling_steps));
    const double last = std::max(0.0, steps - (steps_per_pass() - 1.0));
    return (pass_ * way_of_pass(case_, plan_) + (steps - rolled) * way_of_load_step(case_, plan_) +
            (rolled + last * plan_.rolling_steps) * plan_.shift) /
           *case_.speed;
  }
  /// Sliding distance of the undeformed surfaces since the start after a number of steps of a pass [m].
  [[nodiscard]] double slid(double steps) const
  {
    const double rolled = std::clamp(steps - case_.load_steps, 0.0, static_cast<double>(plan_.rolling_steps));
    return std::abs(1.0 - share_) * plan_.shift * (pass_ * static_cast<double>(plan_.rolling_steps) + rolled);
  }
  [[nodiscard]] int steps_per_pass() const { return 2 * case_.load_steps + plan_.rolling_steps; }
  [[nodiscard]] Centre centre(double x) const { return {x, share_ * x}; }
  [[nodiscard]] bool by_load() const { return case_.drive.kind == Drive::Kind::load; }
  /// Drive at a share of its full value. An imposed approach begins and ends where the surfaces, with dents and bumps, just
  /// touch.
  [[nodiscard]] Drive drive(double share) const
  {
    return {case_.drive.kind, touch_ + (case_.drive.value - touch_) * share};
  }

  const RollingCase& case_;
  const RollingPlan& plan_;
  double share_; ///< distance on the upper body per distance on the lower one
  TrackReader track_;
  DriveMeter meter_;
  double creep_work_ = 0.0; ///< of the creepage since the start [J]
  std::vector<RollingPass> passes_;
  double touch_ = 0.0; ///< approach at which the surfaces just touch, where an imposed approach begins and ends [m]
  int pass_ = 0, step_in_pass_ = 0;
};

} // namespace

void RollingRecord::exchange(Archive& archive)
{
  exchange_row(*this, archive);
}

template <>
struct MotionOf<RollingCase>
{
  using Type = Rolling;
};

template class Run<RollingCase>;

} // namespace brinell::simulation
