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
      : case_(tugging), plan_(plan), cells_(relative_cells(tugging, plan.contact.dx)),
        passing_(tugging.lower.radius, tugging.upper.radius, tugging.interference, cells_, plan.contact.dx,
                 tugging.kinematics),
        position_(passing_.start(0))
  {
  }

  [[nodiscard]] Stepper::Setup setup() const
  {
    const double curvature = 0.5 * (1.0 / case_.lower.radius + 1.0 / case_.upper.radius);
    return {case_.lower.material,
            case_.upper.material,
            [curvature](double x, double y) { return curvature * (x * x + y * y); },
            case_.solver,
            centre(passing_.start(0)),
            {},
            {},
            {}};
  }
  [[nodiscard]] Centre centre() const { return centre(position_); }
  [[nodiscard]] bool is_done() const { return pass_ == case_.passes; }
  [[nodiscard]] int step_count() const { return case_.passes * (steps_in_pass_ + 1); }

  /// From one position to the next; the first one of a pass comes from nowhere.
  [[nodiscard]] Move next(Stepper& stepper)
  {
    const bool first = step_in_pass_ == 0;
    to_ = first ? first_position(stepper) : passing_.next(position_);
    if (first) // until rigid spheres part; then on while pressure remains
      steps_in_pass_ = (passing_.start(0).index - to_.index) + passing_.step_count();
    const bool whole = cells_ == std::round(cells_);
    const auto path = [this, first, whole](double t)
    {
      const double columns = t * cells_;
      return target(first || t == 1.0 ? to_ : passing_.within_step(position_, whole ? std::round(columns) : columns),
                    step_in_pass_ - 1.0 + t);
    };
    return {path, first ? 1.0 : 1.0 / cells_, fmt::format("pass {}, X = {:g} m", pass_ + 1, to_.X)};
  }

  void read(Stepper& stepper, const TuggingRecord& before, TuggingRecord& r)
  {
    position_ = to_;
    r.pass = pass_;
    record(stepper, r);
    r.work += work_between(before, r);
    add(before, r, peaks_);
    if (step_in_pass_ >= steps_in_pass_ && !stepper.touching())
    {
      extra_steps_ = std::max(extra_steps_, position_.index - passing_.start(0).index - passing_.step_count());
      step_in_pass_ = 0;
      ++pass_;
    }
    else
      ++step_in_pass_;
  }

  void summarise(TuggingSummary& summary) const { static_cast<TuggingPeaks&>(summary) = peaks_; }

  void exchange(Archive& archive)
  {
    archive("peaks", peaks_);
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

  /// Far enough back that the surfaces, with what earlier passes left on them, do not touch yet.
  Position first_position(Stepper& stepper) const
  {
    constexpr int most = 1000;
    for (int before = extra_steps_;; ++before)
    {
      const Position p = passing_.start(before);
      if (case_.load || stepper.clearance(centre(p)) >= p.interference || before > extra_steps_ + most)
        return p;
    }
  }

  void record(Stepper& stepper, TuggingRecord& r) const
  {
    const Position& p = position_;
    const double sum = case_.lower.radius + case_.upper.radius;
    const Stepper::Depths& depths = stepper.depths(centre(p));
    const Forces forces =
        project_forces(stepper.pair().grid(), stepper.pair().pressure(), p.theta,
                       {depths.lower, case_.lower.radius / sum}, {depths.upper, case_.upper.radius / sum});
    r.interference = case_.load ? stepper.pair().approach() : p.interference;
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
  }

  const TuggingCase& case_;
  const TuggingPlan& plan_;
  double cells_; ///< by which the bodies move against each other per step
  Passing passing_;
  TuggingPeaks peaks_;
  Position position_, to_; ///< of the last step, and where the present one goes
  int pass_ = 0, step_in_pass_ = 0, steps_in_pass_ = 0;
  int extra_steps_ = 0; ///< by which earlier passes lasted longer than that of rigid spheres
};

} // namespace

template <>
struct MotionOf<TuggingCase>
{
  using Type = Tugging;
};

template class Run<TuggingCase>;

} // namespace brinell::simulation
