// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/sliding.hpp"

#include "brinell/contact/contact_area.hpp"
#include "brinell/foundation/error.hpp"
#include "brinell/simulation/forces.hpp"
#include "drive_meter.hpp"
#include "foundation/nan.hpp"
#include "period.hpp"
#include "pressing.hpp"
#include "run_state.hpp"
#include "simulation/plan/friction.hpp"
#include "sliding_plan.hpp"
#include "stroke.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace brinell::simulation
{

namespace
{

using contact::Drive;

/// Motion of sliding: press, slide stroke after stroke, lift. The contact stays at the same place on the upper body.
class Sliding
{
public:
  Sliding(const SlidingCase& sliding, const SlidingPlan& plan) : case_(sliding), plan_(plan) {}

  [[nodiscard]] Stepper::Setup setup() const { return setup_of(case_, centre(0.0), plan_.heat_times); }
  [[nodiscard]] Centre centre() const { return centre(slid(done_)); }
  [[nodiscard]] bool is_done() const { return done_ == plan_.steps; }
  [[nodiscard]] int step_count() const { return plan_.steps; }

  [[nodiscard]] Move next(Stepper& stepper)
  {
    if (done_ == 0 || done_ == last() || done_ + 1 == plan_.steps) // from the surfaces with their residual displacement
    {
      const Stepper::Distances touch = stepper.distances(centre());
      lifted_ = lifted(touch);
      if (done_ == 0)
        meter_.begin(0.0, touch.smallest);
    }
    const bool moves = slides(done_);
    const auto path = [this, moves](double t)
    {
      contact::TangentialDrive along;
      along.x.value = moves ? way(done_) : 0.0; // only the sign is used
      Target target{centre(slid(done_ + t)), {case_.press.kind, pressed(done_ + t)}, moves, along};
      target.time = time(done_ + t);
      target.slid = way_slid(done_ + t);
      target.is_put_down = done_ == 0;
      if (!moves && case_.speed)
        target.passing = {way(done_) * *case_.speed, 0.0};
      return target;
    };
    const double cells = plan_.shift / plan_.contact.dx;
    return {path, moves ? std::min(1.0, 0.5 / cells) : finest_press,
            fmt::format("step {}, slid by {:g} m", done_, slid(done_ + 1.0)), moves,
            [this, &stepper] { read_onset(stepper); }};
  }

  void read(Stepper& stepper, const SlidingRecord& before, SlidingRecord& r)
  {
    const bool moves = slides(done_);
    const double sign = moves ? way(done_) : way(std::clamp(done_, first(), last() - 1));
    r.pass = stroke(done_) + 1;
    r.slid = slid(done_ + 1.0);
    r.way = before.way + (moves ? plan_.shift : 0.0);
    const Centre here = centre(r.slid);
    // After parting the approach is that of surfaces that just touch. Before, peaks may still be approaching each other.
    r.approach = r.F_n > 0.0 || done_ < last() ? stepper.pair().approach() : stepper.distances(here).smallest;
    read_period(stepper.pair(), r);
    read_patches(stepper.pair(), r);
    r.F_ploughing = sign * ploughing(stepper, here);
    r.F_X = r.F_ploughing + r.F_friction;
    r.friction = force_ratio(r.F_X, r.F_n, plan_);
    if (moves)
      meter_.start_with_shear(stepper.shear_force_at_start());
    const DriveMeter::Work work = meter_.to({r.slid, r.approach, r.F_n, sign * r.F_X, sign * r.F_friction});
    r.work += work.drive;
    r.dissipation_friction += work.shear - stepper.shear_work();
    ++done_;
    if (!moves)
      return;
    stroke_.add(before, r);
    if (in_stroke(done_) != 0)
      return;
    strokes_.push_back(stroke_of(stroke_, stepper));
    stroke_ = {};
  }

  void summarise(SlidingSummary& summary, const StepFields& /*end*/) const
  {
    summary.strokes = strokes_;
    const Roughness r = plan_.contact.is_periodic() ? roughness(pressing(case_), plan_.contact) : Roughness{nan, nan};
    summary.rms_height = r.height;
    summary.rms_slope = r.slope;
  }

  void exchange(Archive& archive)
  {
    archive("drive", meter_);
    archive("stroke", stroke_);
    archive.list("strokes", strokes_);
    archive("lifted", lifted_);
    archive("done", done_, 0, plan_.steps);
  }

private:
  /// Takes over the forces under which the upper body begins to slide, when friction has been raised at rest.
  void read_onset(Stepper& stepper)
  {
    const double of_pressure = ploughing(stepper, centre(meter_.last().x));
    meter_.read_onset(stepper.pair(), [&](double shear) { return std::pair{of_pressure + shear, shear}; });
  }

  /// Time since the start after a number of steps [s]; 0 without a speed.
  [[nodiscard]] double time(double steps) const { return case_.speed ? steps * plan_.shift / *case_.speed : 0.0; }
  /// The steps [first(), last()) slide.
  [[nodiscard]] int first() const { return case_.press_steps; }
  [[nodiscard]] int last() const { return first() + case_.strokes * plan_.sliding_steps; }
  [[nodiscard]] bool slides(int step) const { return step >= first() && step < last(); }
  [[nodiscard]] int in_stroke(int step) const { return (step - first()) % plan_.sliding_steps; }
  [[nodiscard]] int stroke(int step) const
  {
    return (std::clamp(step, first(), last() - 1) - first()) / plan_.sliding_steps;
  }
  /// Direction of sliding along x in a step: 1 or -1.
  [[nodiscard]] double way(int step) const { return case_.to_and_fro && stroke(step) % 2 == 1 ? -1.0 : 1.0; }
  /// Displacement of the upper body along x after a number of steps [m].
  [[nodiscard]] double slid(double steps) const
  {
    const double n = plan_.sliding_steps;
    const double sliding_steps = std::clamp(steps - first(), 0.0, case_.strokes * n);
    if (!case_.to_and_fro)
      return sliding_steps * plan_.shift;
    const double in_cycle = sliding_steps - 2.0 * n * std::floor(sliding_steps / (2.0 * n));
    return std::min(in_cycle, 2.0 * n - in_cycle) * plan_.shift;
  }
  /// Accumulated sliding distance after a number of steps [m].
  [[nodiscard]] double way_slid(double steps) const
  {
    return std::clamp(steps - first(), 0.0, static_cast<double>(last() - first())) * plan_.shift;
  }
  /// The track is centred on the lower grid; along a period it starts at 0.
  [[nodiscard]] Centre centre(double slid) const
  {
    const int half = plan_.sliding_steps / 2; // integer, so that the start lies on a cell if the shift is whole cells
    const double start = case_.domain.x.is_periodic() ? 0.0 : -half * plan_.shift;
    return {start + slid, 0.0};
  }

  void read_patches(const elastoplastic::CoupledContact& pair, SlidingRecord& r) const
  {
    const contact::Patches found =
        contact::patches(pair.grid(), pair.pressure(), pair.gap(),
                         contact_modulus(case_.lower.material.top(), case_.upper.material.top()));
    r.patches = static_cast<int>(found.area.size());
    r.largest_patch = found.area.empty() ? 0.0 : *std::max_element(found.area.begin(), found.area.end());
  }

  /// Value of the drive without contact; if the surfaces are still apart under the full drive, the full value.
  [[nodiscard]] double lifted(const Stepper::Distances& touch) const
  {
    const double apart = without_contact(case_.press.kind, touch);
    return case_.press.kind == Drive::Kind::mean_gap ? std::max(apart, case_.press.value)
                                                     : std::min(apart, case_.press.value);
  }

  /// Value of the drive after a number of steps. For loads, load^(2/3) changes linearly, so that the approach changes about
  /// linearly.
  [[nodiscard]] double pressed(double steps) const
  {
    const double up = std::min(1.0, steps / case_.press_steps);
    const double share = up - std::max(0.0, (steps - last()) / case_.press_steps);
    if (share == 1.0)
      return case_.press.value;
    if (case_.press.kind == Drive::Kind::load)
      return case_.press.value * std::pow(std::max(0.0, share), 1.5);
    return lifted_ + (case_.press.value - lifted_) * share;
  }

  /// Force of the pressure along x [N]: mean of the forces from the slopes of both surfaces. Within the contact both slopes are
  /// equal, except at its edges; the mean treats both bodies alike.
  [[nodiscard]] double ploughing(Stepper& stepper, const Centre& here) const
  {
    const Stepper::Depths& depths = stepper.loaded_depths(here);
    const SurfaceGrid& grid = stepper.pair().grid();
    std::vector<double> upper = depths.upper;
    const double x0 = stepper.left_of(here);
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i)
        upper[grid.index(i, j)] += height(case_.upper.shape, x0 + i * grid.dx, grid.y(j));
    return 0.5 * rolling_resistance(grid, stepper.pair().pressure(), depths.lower, upper, -1.0);
  }

  const SlidingCase& case_;
  const SlidingPlan& plan_;
  DriveMeter meter_;
  ColumnStatistics<SlidingRecord> stroke_; ///< over the steps of the current stroke
  std::vector<SlidingStroke> strokes_;
  double lifted_ = 0.0; ///< value of the drive without contact
  int done_ = 0;        ///< number of finished steps
};

} // namespace

void SlidingRecord::exchange(Archive& archive)
{
  exchange_row(*this, archive);
}

void SlidingStroke::exchange(Archive& archive)
{
  exchange_columns(*this, archive);
}

template <>
struct MotionOf<SlidingCase>
{
  using Type = Sliding;
};

template class Run<SlidingCase>;

} // namespace brinell::simulation
