// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/rolling.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/simulation/forces.hpp"
#include "domain.hpp"
#include "footprint.hpp"
#include "friction.hpp"
#include "grid_layout.hpp"
#include "heat.hpp"
#include "judgement.hpp"
#include "run_state.hpp"
#include "symmetry.hpp"
#include "track.hpp"
#include "wear.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace brinell::simulation
{

namespace
{

using contact::Drive;
using contact::TangentialDrive;

/// Press, roll, lift, pass after pass.
class Rolling
{
public:
  Rolling(const RollingCase& rolling, const RollingPlan& plan)
      : case_(rolling), plan_(plan), share_(upper_share(rolling)), track_(rolling.distance, plan.shift)
  {
    at_.x = moment(0.0).x;
  }

  [[nodiscard]] Stepper::Setup setup() const
  {
    Stepper::Setup setup = shaped_setup(case_.lower, case_.upper, case_.solver, centre(moment(0.0).x));
    setup.sliding = {.friction = case_.friction,
                     .direction = case_.slide_to_roll < 0.0 ? -1 : 1,
                     .sticks = case_.creepage.has_value(),
                     .wear = case_.wear};
    if (is_heated(case_, case_.lower, case_.upper))
      setup.sliding.heat = {case_.heat, heat_times()};
    return setup;
  }
  [[nodiscard]] Centre centre() const { return centre(at_.x); }
  [[nodiscard]] bool is_done() const { return pass_ == case_.passes; }
  [[nodiscard]] int step_count() const { return plan_.steps; }

  [[nodiscard]] Move next(Stepper& stepper)
  {
    const Centre from = centre(moment(step_in_pass_).x);
    if (step_in_pass_ == 0)
    {
      track_.begin_pass(stepper.pair().lower().solved(), dissipation(stepper));
      at_ = {moment(0.0).x, stepper.clearance(from), 0.0, 0.0, 0.0, at_.along};
    }
    if (step_in_pass_ == 0 || step_in_pass_ == case_.load_steps + plan_.rolling_steps)
      touch_ = by_load() ? 0.0 : std::min(stepper.clearance(from), case_.drive.value);
    const double to = moment(step_in_pass_ + 1).x;
    if (step_in_pass_ + 1 == steps_per_pass()) // lifted: what has yielded on the way counts
      touch_ = by_load() ? 0.0 : std::min(touch_, stepper.clearance(centre(to)));
    const bool moves = is_rolling();
    const auto path = [this, moves](double t)
    {
      const Moment m = moment(step_in_pass_ + t);
      Target target{centre(m.x), drive(m.drive), moves, along(m.x)};
      target.time = time(step_in_pass_ + t);
      target.slid = slid(step_in_pass_ + t);
      target.is_put_down = step_in_pass_ == 0;
      return target;
    };
    const double cells = plan_.shift / plan_.contact.dx;
    const double finest = moves ? std::min(1.0, 0.5 / cells) : 1.0 / 64;
    return {path, finest, fmt::format("pass {}, x = {:g} m", pass_ + 1, to)};
  }

  void read(Stepper& stepper, const RollingRecord& /*before*/, RollingRecord& r)
  {
    r.pass = pass_ + 1;
    r.x = moment(step_in_pass_ + 1).x;
    const Centre here = centre(r.x);
    const Stepper::Depths& depths = stepper.loaded_depths(here);
    r.approach = r.F_n > 0.0 ? stepper.pair().approach() : stepper.clearance(here);
    r.F_X = rolling_resistance(stepper.pair().grid(), stepper.pair().pressure(), depths.lower, depths.upper, share_);
    const double sliding_force = (1.0 - share_) * (share_ < 1.0 ? r.F_friction : -r.F_friction);
    r.F_X += sliding_force;
    r.work += 0.5 * (r.F_n + at_.F_n) * (r.approach - at_.approach) + 0.5 * (r.F_X + at_.F_X) * (r.x - at_.x);
    r.dissipation_friction += 0.5 * (sliding_force + at_.sliding_force) * (r.x - at_.x) - stepper.shear_work();
    at_ = {r.x, r.approach, r.F_n, r.F_X, sliding_force, at_.along};
    read_shear(stepper, r);
    r.friction = r.F_n > 0.0 ? r.F_X / r.F_n : 0.0;
    track_.add(r);
    if (++step_in_pass_ < steps_per_pass())
      return;
    passes_.push_back(track_.end_pass(stepper.pair(), dissipation(stepper)));
    passes_.back().pass = ++pass_;
    step_in_pass_ = 0;
  }

  void summarise(RollingSummary& summary) const
  {
    summary.passes = passes_;
    summary.profile = track_profile(summary.final_state.lower);
  }

  void exchange(Archive& archive)
  {
    archive("at", at_);
    archive("track", track_);
    archive.list("passes", passes_);
    archive("touch", touch_);
    archive("pass", pass_, 0, case_.passes);
    archive("step_in_pass", step_in_pass_, 0, steps_per_pass() - 1);
    if (archive.gives() && !(std::abs(at_.x) <= case_.distance))
      throw InputError("the stored state has a place that is not on the track");
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
  /// By which the upper body has crept over the lower one when the contact is at x in this pass: nothing while it is pressed
  /// on or lifted off.
  [[nodiscard]] TangentialDrive along(double x) const
  {
    const Creepage creepage = case_.creepage.value_or(Creepage{});
    const double track = plan_.rolling_steps * plan_.shift;
    const double rolled = pass_ * track + (x + 0.5 * track);
    return {{TangentialDrive::Kind::shift, creepage.longitudinal * rolled},
            {TangentialDrive::Kind::shift, creepage.lateral * rolled},
            creepage.spin * rolled};
  }
  /// Whether the contact moves in the step at hand.
  [[nodiscard]] bool is_rolling() const
  {
    return step_in_pass_ >= case_.load_steps && step_in_pass_ < case_.load_steps + plan_.rolling_steps;
  }
  /// What acts between the surfaces along them, and the work of the creepage.
  void read_shear(const Stepper& stepper, RollingRecord& r)
  {
    const SurfaceGrid& grid = stepper.pair().grid();
    const halfspace::SurfaceLoad load = stepper.load();
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
    r.work += slip->work() - at_.along;
    at_.along = slip->work();
    r.dissipation_friction = slip->heat();
    r.stick_share =
        slip->pressed_cells() > 0 ? static_cast<double>(slip->sticking_cells()) / slip->pressed_cells() : 0.0;
    r.stick_area = r.stick_share * r.contact_area;
    r.slip_path = *std::max_element(slip->path().begin(), slip->path().end());
  }
  /// After some steps of a pass, since the start [s]; without a speed it stands still. The way back belongs to the last step,
  /// in which the surfaces part.
  [[nodiscard]] double time(double steps) const
  {
    if (!case_.speed)
      return 0.0;
    const double last = std::max(0.0, steps - (steps_per_pass() - 1.0));
    return (pass_ * (steps_per_pass() + plan_.rolling_steps) + steps + last * plan_.rolling_steps) * plan_.shift /
           *case_.speed;
  }
  /// Likewise the length by which the undeformed surfaces have slid on each other [m].
  [[nodiscard]] double slid(double steps) const
  {
    const double rolled = std::clamp(steps - case_.load_steps, 0.0, static_cast<double>(plan_.rolling_steps));
    return std::abs(1.0 - share_) * plan_.shift * (pass_ * static_cast<double>(plan_.rolling_steps) + rolled);
  }
  [[nodiscard]] halfspace::HeatTimes heat_times() const
  {
    const double step = plan_.shift / *case_.speed, passes = case_.passes;
    constexpr double finest = 1.0 / 128; // of a step: half the shortest piece, while pressing
    return {step * std::min(finest, 0.25 * plan_.contact.dx / plan_.shift),
            step * passes * (steps_per_pass() + plan_.rolling_steps + 1.0)};
  }
  [[nodiscard]] int steps_per_pass() const { return 2 * case_.load_steps + plan_.rolling_steps; }
  [[nodiscard]] Centre centre(double x) const { return {x, share_ * x}; }
  [[nodiscard]] bool by_load() const { return case_.drive.kind == Drive::Kind::load; }
  /// An imposed approach begins and ends where the surfaces touch, dents and bumps included.
  [[nodiscard]] Drive drive(double share) const
  {
    return {case_.drive.kind, touch_ + (case_.drive.value - touch_) * share};
  }

  [[nodiscard]] static double dissipation(const Stepper& stepper)
  {
    return stepper.pair().lower().solved().state().dissipation + stepper.pair().upper().solved().state().dissipation;
  }

  /// Where the drive has worked so far.
  struct WorkedTo
  {
    double x = 0.0, approach = 0.0, F_n = 0.0, F_X = 0.0;
    double sliding_force = 0.0; ///< share of the shear in F_X, of surfaces that slide everywhere [N]
    double along = 0.0;         ///< work of the creepage [J]

    void exchange(Archive& archive)
    {
      archive("x", x);
      archive("approach", approach);
      archive("F_n", F_n);
      archive("F_X", F_X);
      archive("sliding_force", sliding_force);
      archive("along", along);
    }
  };

  const RollingCase& case_;
  const RollingPlan& plan_;
  double share_; ///< distance on the upper body per distance on the lower one
  TrackReader track_;
  WorkedTo at_;
  std::vector<RollingPass> passes_;
  double touch_ = 0.0; ///< where an imposed approach comes from and goes back to: the surfaces touch [m]
  int pass_ = 0, step_in_pass_ = 0;
};

/// Whether both bodies always have the same history: then one is solved and its residual displacement counts twice.
bool are_twins(const RollingCase& rolling, const RollingPlan& plan)
{
  return rolling.solver.mirror && rolling.slide_to_roll == 0.0 && !rolling.creepage && plan.lower == plan.upper &&
         alike(rolling.lower, rolling.upper);
}

// docs/verification.md (expected error)
constexpr Documented documented[] = {{"rut", "passes[*].rut_depth_m", 0.05, 4.0, 1.5},
                                     {"resistance", "passes[*].resistance_N", 0.08, 4.0, 1.5},
                                     {"dissipation", "passes[*].dissipation_J", 0.07, 4.0, 1.5}};
constexpr Documented documented_with_creepage[] = {
    {"creep force", "passes[*].F_x_N", 0.05, 8.0, 1.0, true}, documented[0], documented[1], documented[2]};

Facts facts(const RollingCase& c, const RollingPlan& plan)
{
  Facts f = facts_of(c, c.lower, c.upper, plan, plan.half_width_x, plan.half_width_y);
  f.documented = documented;
  if (c.creepage)
    f.documented = documented_with_creepage;
  f.moves = true;
  // Of the faster surface: with much sliding it moves many cells where the other one moves one.
  if (const double faster = plan.shift * std::max(1.0, upper_share(c)); c.shift || faster > plan.shift)
    f.shift = faster;
  return f;
}

/// Creepage that does not go with the rest of the case.
/// @param half  half-length of the contact, the larger one [m]
void require_creepage(const RollingCase& rolling, double half)
{
  if (!rolling.creepage)
    return;
  const auto& [longitudinal, lateral, spin] = *rolling.creepage;
  const bool only_spins = longitudinal == 0.0 && lateral == 0.0 && spin != 0.0;
  const std::string creepage = fmt::format("rolling.creepage = [{:g}, {:g}]", longitudinal, lateral);
  const std::string given = only_spins ? fmt::format("rolling.spin = {:g} rad/m", spin) : creepage;
  const std::string key = only_spins ? "rolling.spin" : "rolling.creepage";
  for (const double part : {longitudinal, lateral})
    if (!(std::abs(part) <= largest_creepage))
      throw KeyError("rolling.creepage",
                     fmt::format("{}; allowed: each from -{} to {}. For surfaces that slide everywhere there is "
                                 "rolling.slide_to_roll",
                                 creepage, largest_creepage, largest_creepage));
  if (!(std::abs(spin) * half <= largest_creepage))
    throw KeyError("rolling.spin",
                   fmt::format("rolling.spin = {:g} rad/m; allowed: up to {:.3g} rad/m, {} over the half-length of the "
                               "contact",
                               spin, largest_creepage / half, largest_creepage));
  if (rolling.slide_to_roll != 0.0)
    throw KeyError(key, fmt::format("{} with rolling.slide_to_roll = {:g}, which makes the surfaces slide everywhere; "
                                    "allowed: 0. The first creepage is what slide_to_roll counts, with stick and slip",
                                    given, rolling.slide_to_roll));
  if (rolling.friction.coefficient == 0.0)
    throw KeyError(key, fmt::format("{} with interface.friction = 0: nothing holds the surfaces; allowed: > 0", given));
  if (spin != 0.0 && (rolling.domain.x.is_periodic() || rolling.domain.y.is_periodic()))
    throw KeyError(
        "rolling.spin",
        fmt::format("rolling.spin = {:g} rad/m between surfaces without ends, which cannot turn; allowed: 0, "
                    "or grid.boundary = \"open\"",
                    spin));
}

/// The history of stick and slip is carried along by whole cells.
void require_whole_cells(const RollingCase& rolling, const RollingPlan& plan)
{
  const double cells = plan.shift / plan.contact.dx;
  constexpr double rounding = 1e-9;
  if (rolling.creepage && !(std::abs(cells - std::round(cells)) <= rounding * cells && cells > 0.5))
    throw KeyError("rolling.shift",
                   fmt::format("rolling.shift = {:g} m with creepage; allowed: whole multiples of the cell, {:g} m",
                               plan.shift, plan.contact.dx));
}

/// Tells of the worst pass.
std::optional<Warning> unsteadiness(const RollingCase& rolling, const std::vector<RollingPass>& passes)
{
  // Relative difference of the two quarters: each is then as far from their mean as resistance and dissipation usually are from
  // the limit of fine cells, 8 %, twice over.
  constexpr double largest_unsteadiness = 0.3;
  const auto worst = std::max_element(passes.begin(), passes.end(),
                                      [](const RollingPass& a, const RollingPass& b)
                                      { return std::abs(a.unsteadiness) < std::abs(b.unsteadiness); });
  if (worst == passes.end() || !(std::abs(worst->unsteadiness) > largest_unsteadiness))
    return std::nullopt;
  const bool is_rough = !rolling.lower.texture.is_smooth() || !rolling.upper.texture.is_smooth();
  return Warning{
      "unsteady_track",
      fmt::format("pass {}: the energy taken up per length differs by {} between the two quarters of the middle of the "
                  "track: its resistance, friction and mean F_X are those of this stretch and no average; take a "
                  "longer track{}",
                  worst - passes.begin() + 1, percent_text(std::abs(worst->unsteadiness)),
                  is_rough ? ", of many lengths of the texture" : "")};
}

/// Tells of the last pass, unless it has become steady.
std::optional<Warning> creep_unsteadiness(const RollingCase& rolling, const std::vector<RollingPass>& passes)
{
  if (!rolling.creepage || passes.empty() || passes.back().creeps_steadily())
    return std::nullopt;
  return Warning{
      "unsteady_creep",
      fmt::format("pass {}: the force along the surface differs by {} between both halves of the last quarter of the "
                  "track: stick and slip are still on their way to those of steady rolling; take a longer track",
                  passes.size(), percent_text(passes.back().creep_unsteadiness))};
}

} // namespace

double upper_share(const RollingCase& rolling)
{
  return (2.0 - rolling.slide_to_roll) / (2.0 + rolling.slide_to_roll);
}

RollingPlan plan(const RollingCase& rolling)
{
  const std::string why_not =
      rolling.slide_to_roll == 0.0 && !rolling.creepage
          ? "nothing slides with rolling.slide_to_roll = 0; allowed: 0, or another slide_to_roll"
          : "";
  require_friction(rolling, rolling.lower, rolling.upper, why_not.empty() ? "" : why_not + ", or rolling.creepage");
  // What slips there does so where the pressure falls to nothing within a step: a law by the pressure at its end would be far off.
  require_wear(rolling, rolling.creepage ? "not computed where surfaces that roll stick in places; allowed: 0, or "
                                           "rolling.slide_to_roll in place of rolling.creepage and spin"
                                         : why_not);
  require_heat(rolling, rolling.lower, rolling.upper, rolling.speed, "rolling.speed");
  if (rolling.creepage && is_heated(rolling, rolling.lower, rolling.upper))
    throw KeyError("rolling.creepage", "heat of surfaces that stick in places is not computed; with thermal constants "
                                       "allowed: rolling.slide_to_roll in place of rolling.creepage and spin");
  if (!(rolling.drive.value > 0.0))
    throw InputError("rolling needs a load or an approach > 0");
  const Footprint f =
      footprint(rolling.lower, rolling.upper, rolling.drive, rolling.domain, rolling.friction.coefficient);
  require_creepage(rolling, f.endless_y ? f.half_x : std::max(f.half_x, f.half_y));
  RollingPlan plan;
  plan.half_width_x = f.half_x;
  plan.half_width_y = f.half_y;
  plan.shift = rolling.shift.value_or(cell_sizes(rolling, {f.half_x, f.half_y, f.straight_y}, 1.0)[0]);
  if (!(plan.shift <= 0.5 * rolling.distance))
    throw InputError(
        fmt::format("a shift of {:g} m in {:g} m; allowed: up to half of the distance", plan.shift, rolling.distance));
  // An even number, so that the middle of the track is reached.
  plan.rolling_steps = 2 * std::max(1, step_count(std::round(0.5 * rolling.distance / plan.shift), "rolling.distance"));
  const double track = 0.5 * plan.rolling_steps * plan.shift;
  lay_out(rolling, f, track, upper_share(rolling) * track, plan);
  require_cells_in_periods(rolling.lower, rolling.upper, rolling.domain, plan.contact);
  require_whole_cells(rolling, plan);
  plan.reference = reference_distance(rolling.lower.shape, rolling.upper.shape, rolling.domain);
  plan.steps = step_count(static_cast<double>(rolling.passes) * (plan.rolling_steps + 2.0 * rolling.load_steps),
                          "rolling.passes");
  plan.twin = are_twins(rolling, plan) ? elastoplastic::Twin::alike : elastoplastic::Twin::none;
  plan.symmetry = symmetry_of(rolling.lower, rolling.upper, rolling, plan.contact, rolling.creepage.has_value());
  const bool heats = is_heated(rolling, rolling.lower, rolling.upper);
  const int shears = rolling.friction.coefficient > 0.0 ? (rolling.creepage ? 2 : 1) : 0;
  plan.memory_bytes = memory_bytes(plan, rolling.lower.material.is_plastic(), rolling.upper.material.is_plastic(),
                                   rolling.solver.anderson_depth, shears, heats && rolling.lower.material.thermal,
                                   heats && rolling.upper.material.thermal);
  return plan;
}

void RollingRecord::exchange(Archive& archive)
{
  exchange_row(*this, archive);
}

Quality expected_quality(const RollingCase& rolling, const RollingPlan& plan)
{
  return quality_before(facts(rolling, plan));
}

Quality quality(const RollingCase& rolling, const RollingPlan& plan, const RunTotals& totals)
{
  return quality_after(facts(rolling, plan), totals);
}

Quality quality(const RollingCase& rolling, const RollingPlan& plan, const RollingSummary& summary)
{
  Quality quality = quality_after(facts(rolling, plan), summary, unsteadiness(rolling, summary.passes));
  if (const std::optional<Warning> warning = creep_unsteadiness(rolling, summary.passes))
    quality.warnings.push_back(*warning);
  return quality;
}

template <>
struct MotionOf<RollingCase>
{
  using Type = Rolling;
};

template class Run<RollingCase>;

} // namespace brinell::simulation
