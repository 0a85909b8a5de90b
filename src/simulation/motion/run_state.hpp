// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/error.hpp"
#include "brinell/simulation/run.hpp"
#include "simulation/plan/heat.hpp"
#include "simulation/stepping/fatigue_recorder.hpp"
#include "simulation/stepping/records.hpp"
#include "simulation/stepping/stepper.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace brinell::simulation
{

/// One step of a motion: the path from the present state (0) to the end of the step (1).
struct Move
{
  std::function<Target(double)> path;
  double finest;     ///< shortest piece of the path into which a step may be split
  std::string where; ///< for messages
  /// Whether the step belongs to the motion that the run is about. While the bodies are pressed together before it or part after
  /// it, how fast they do so is a choice of the program, and so are the temperatures.
  bool is_motion = true;
  std::function<void()> at_onset{}; ///< see Stepper::advance
};

/// The motion of a scenario and the evaluation of its steps: everything that distinguishes one scenario from another.
template <typename Case>
struct MotionOf;

template <typename M, typename Case>
concept Motion = requires(M m, const M& fixed, Stepper& stepper, const typename Case::Record& before,
                          typename Case::Record& record, typename Case::Summary& summary, const StepFields& fields,
                          Archive& archive)
{
  requires std::constructible_from<M, const Case&, const typename Case::Plan&>;
  /// Materials, shapes, and the place at which the run starts.
  {
    fixed.setup()
    } -> std::same_as<Stepper::Setup>;
  /// Centre of the contact after the last step.
  {
    fixed.centre()
    } -> std::same_as<Centre>;
  {
    fixed.is_done()
    } -> std::same_as<bool>;
  /// Estimated number of steps of the whole run.
  {
    fixed.step_count()
    } -> std::same_as<int>;
  /// The next step: path of the contact and of its drive.
  {
    m.next(stepper)
    } -> std::same_as<Move>;
  /// Called after a step is solved: fills the scenario's own columns of `record`, whose common columns are filled already, and
  /// adds the work of the step to that of `before`.
  m.read(stepper, before, record);
  /// Fills the scenario's own numbers of a summary, whose common numbers are filled already.
  /// `fields`: at the end of the run so far.
  fixed.summarise(summary, fields);
  /// Everything that the rest of the run depends on.
  m.exchange(archive);
};

/// Owns what every scenario needs: case, plan, motion, bodies, counters, totals.
template <typename Case>
class Run<Case>::State
{
public:
  /// @param known  the plan of the case; nullptr: it is made
  State(Case scenario, Watch watch, const Archive::Fields* checkpoint, const typename Case::Plan* known)
      : case_(std::move(scenario)), plan_(known != nullptr ? *known : plan(case_)), motion_(case_, plan_),
        stepper_(plan_, setup(std::move(watch))), fatigue_(case_.lower, case_.upper)
  {
    if (checkpoint != nullptr)
      restore(*checkpoint);
  }
  State(const State&) = delete; // its parts refer to the case and the plan
  State& operator=(const State&) = delete;

  [[nodiscard]] bool is_done() const { return motion_.is_done(); }
  [[nodiscard]] int step_count() const { return motion_.step_count(); }
  [[nodiscard]] StepFields fields() const
  {
    StepFields result = stepper_.fields(motion_.centre());
    if (is_done()) // judging all cells takes a while
      fatigue_.attach(result);
    return result;
  }

  const Record& step()
  {
    if (is_done())
      throw InternalError("Run::step: the run is done");
    require_sound();
    has_failed_ = true; // until the step is complete: a step that was interrupted by an exception must not be continued
    const Move move = motion_.next(stepper_);
    Record record;
    record.evaluations = stepper_.advance(move.path, move.finest, move.where, move.at_onset);
    stepper_.fill(record);
    record.step = steps_++;
    record.work = last_.work;
    record.dissipation_friction = last_.dissipation_friction;
    motion_.read(stepper_, last_, record);
    if (fatigue_.is_wanted())
      fatigue_.add(record.pass, stepper_.present(motion_.centre()));
    evaluations_ += record.evaluations;
    largest_work_ = std::max(largest_work_, std::abs(record.work));
    if constexpr (std::derived_from<Record, FrictionRecord>)
      largest_limited_share_ = std::max(largest_limited_share_, record.share_at_shear_limit);
    if constexpr (std::derived_from<Record, HeatedRecord>)
    {
      if (move.is_motion && case_.heat.at_melting == elastoplastic::AtMelting::stop)
        require_below_melting(move.where, record, case_.lower.material, case_.upper.material);
      if (move.is_motion)
        hottest_ = {std::max(hottest_[0], record.max_temperature_lower),
                    std::max(hottest_[1], record.max_temperature_upper)};
    }
    last_ = record;
    has_failed_ = false;
    return last_;
  }

  [[nodiscard]] Summary totals() const
  {
    Summary s;
    s.steps = steps_;
    s.evaluations = evaluations_;
    stepper_.fill(s);
    take_totals(last_, largest_work_, s);
    s.max_share_at_shear_limit = largest_limited_share_;
    s.max_temperature = hottest_;
    if constexpr (std::derived_from<Record, HeatedRecord>)
      if (hottest_ == nothing_yet) // pressed on, but not yet in motion
        s.max_temperature = {last_.max_temperature_lower, last_.max_temperature_upper};
    s.last = last_;
    const StepFields end = fields();
    s.final_state = end.surfaces;
    motion_.summarise(s, end);
    s.fatigue = fatigue_.summaries();
    return s;
  }

  void exchange(Archive& archive)
  {
    require_sound();
    archive("stepper", stepper_);
    archive("motion", motion_);
    archive("fatigue", fatigue_);
    archive("last", last_);
    archive("largest_work", largest_work_);
    archive("largest_limited_share", largest_limited_share_, 0.0, 1.0);
    archive("hottest.lower", hottest_[0]);
    archive("hottest.upper", hottest_[1]);
    archive("evaluations", evaluations_, 0, std::numeric_limits<long>::max());
    archive("steps", steps_, 0, std::numeric_limits<int>::max() - 1);
  }

private:
  void require_sound() const
  {
    if (has_failed_)
      throw InputError("this run has ended with an error; start another one");
  }
  [[nodiscard]] Stepper::Setup setup(Watch watch) const
  {
    Stepper::Setup result = motion_.setup();
    result.watch = std::move(watch);
    result.follows_stress = {follows_fatigue(case_.lower), follows_fatigue(case_.upper)};
    return result;
  }
  void restore(const Archive::Fields& checkpoint)
  {
    Archive archive(checkpoint);
    exchange(archive);
  }

  using M = typename MotionOf<Case>::Type;
  static_assert(Motion<M, Case>);

  Case case_;
  typename Case::Plan plan_;
  M motion_;
  Stepper stepper_;
  FatigueRecorder fatigue_;
  Record last_;
  double largest_work_ = 0.0; ///< [J]
  double largest_limited_share_ = 0.0;
  static constexpr std::array<double, 2> nothing_yet{-273.15, -273.15}; ///< absolute zero
  std::array<double, 2> hottest_ = nothing_yet; ///< largest temperature of each surface in the motion [deg C]
  long evaluations_ = 0;
  int steps_ = 0;
  bool has_failed_ = false;
};

template <typename Case>
Run<Case>::Run(Case scenario, Watch watch, const Archive::Fields* checkpoint)
    : state_(std::make_unique<State>(std::move(scenario), std::move(watch), checkpoint, nullptr))
{
}
template <typename Case>
Run<Case>::Run(Case scenario, Watch watch, const Archive::Fields* checkpoint, const typename Case::Plan& plan)
    : state_(std::make_unique<State>(std::move(scenario), std::move(watch), checkpoint, &plan))
{
}
template <typename Case>
Run<Case>::~Run() = default;
template <typename Case>
Run<Case>::Run(Run&&) noexcept = default;
template <typename Case>
Run<Case>& Run<Case>::operator=(Run&&) noexcept = default;

template <typename Case>
bool Run<Case>::is_done() const
{
  return state_->is_done();
}
template <typename Case>
auto Run<Case>::step() -> const Record&
{
  return state_->step();
}
template <typename Case>
int Run<Case>::step_count() const
{
  return state_->step_count();
}
template <typename Case>
StepFields Run<Case>::fields() const
{
  return state_->fields();
}
template <typename Case>
Archive::Fields Run<Case>::checkpoint()
{
  Archive archive;
  checkpoint(archive);
  return std::move(archive).fields();
}
template <typename Case>
void Run<Case>::checkpoint(Archive& archive)
{
  state_->exchange(archive);
}
template <typename Case>
auto Run<Case>::summary() const -> Summary
{
  Summary s = totals();
  s.final_state = snapshot();
  return s;
}
template <typename Case>
auto Run<Case>::totals() const -> Summary
{
  return state_->totals();
}

} // namespace brinell::simulation
