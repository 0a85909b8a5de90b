// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/indentation.hpp"

#include "brinell/contact/drive_text.hpp"
#include "brinell/foundation/error.hpp"
#include "foundation/nan.hpp"
#include "indent.hpp"
#include "period.hpp"
#include "pressing.hpp"
#include "run_state.hpp"
#include "simulation/plan/domain.hpp"
#include "simulation/plan/effects.hpp"
#include "simulation/plan/footprint.hpp"
#include "simulation/plan/friction.hpp"
#include "simulation/plan/grid_layout.hpp"
#include "simulation/plan/plan_end.hpp"
#include "simulation/plan/symmetry.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace brinell::simulation
{

namespace
{

using contact::Drive;

/// Motion of indentation: loading and unloading, place after place.
class Indentation
{
public:
  Indentation(const IndentationCase& indentation, const IndentationPlan& plan)
      : case_(indentation), steps_(plan.steps), contact_(plan.contact), current_(x(0), 1, 0.0)
  {
  }

  [[nodiscard]] Stepper::Setup setup() const { return setup_of(case_, {case_.places.front(), 0.0}, {}); }
  [[nodiscard]] Centre centre() const { return {x(std::max(done_ - 1, 0)), 0.0}; }
  [[nodiscard]] bool is_done() const { return done_ == steps_; }
  [[nodiscard]] int step_count() const { return steps_; }

  [[nodiscard]] Move next(Stepper& stepper)
  {
    const Centre here{x(done_), 0.0};
    const int in_indent = done_ % steps_per_indent();
    const int in_entry = in_indent % case_.steps;
    const Stepper::Distances touch = stepper.distances(here);
    if (in_indent == 0)
      current_ = indent() % case_.cycles == 0 ? IndentReader(here.lower, place(), touch.smallest)
                                              : current_.next_cycle(touch.smallest);
    if (in_entry == 0)
      begin_entry(in_indent, touch);
    if (in_entry + 1 == case_.steps && to_ <= 0.0) // lifting off, from the surfaces with their residual displacement
      to_ = std::min(to_, without_contact(kind(), touch));
    const auto path = [this, here, in_entry](double t) {
      return Target{here, {kind(), imposed((in_entry + t) / case_.steps)}};
    };
    const auto [name, unit] = text_of(kind());
    return {path, finest_press, fmt::format("step {}, {} = {:g} {}", done_, name, path(1.0).drive.value, unit)};
  }

  void read(Stepper& stepper, const IndentationRecord& before, IndentationRecord& r)
  {
    const Centre here{x(done_), 0.0};
    r.pass = indent() + 1;
    r.place = place();
    r.x = here.lower;
    r.approach = stepper.pair().approach();
    r.contact_radius = std::sqrt(r.contact_area / std::numbers::pi);
    r.mean_pressure = r.contact_area > 0.0 ? r.F_n / r.contact_area : 0.0;
    const elastoplastic::CoupledContact& pair = stepper.pair();
    r.contact_cells = static_cast<int>(
        std::count_if(pair.pressure().begin(), pair.pressure().end(), [](double p) { return p > 0.0; }));
    read_period(pair, r);
    r.contact_stiffness =
        pair.grid().is_periodic() ? pair.stiffness() / (case_.domain.x.size * case_.domain.y.size) : nan;
    const auto [highest, deepest] = stepper.residual_range(here);
    r.residual_depth = deepest;
    r.pile_up = -highest;
    if (done_ % steps_per_indent() == 0)
      begun_ = before.work;
    trapezoid_ += current_.add(r, r.F_n > 0.0 ? 0.0 : stepper.distances(here).smallest);
    // While nothing has yielded, all of the work is stored: exact for any number of steps.
    const bool is_elastic = r.dissipation_lower == 0.0 && r.dissipation_upper == 0.0;
    r.work = is_elastic ? r.energy_elastic : trapezoid_;
    if (++done_ % steps_per_indent() != 0)
      return;
    indents_.push_back(current_.result());
    if (is_elastic)
      indents_.back().work = r.work - begun_;
  }

  void summarise(IndentationSummary& summary, const StepFields& /*end*/) const
  {
    summary.indents = indents_;
    const Roughness r = contact_.is_periodic() ? roughness(case_, contact_) : Roughness{nan, nan};
    summary.rms_height = r.height;
    summary.rms_slope = r.slope;
  }

  void exchange(Archive& archive)
  {
    archive("current", current_);
    archive.list("indents", indents_);
    archive("trapezoid", trapezoid_);
    archive("begun", begun_);
    archive("from", from_);
    archive("to", to_);
    archive("done", done_, 0, steps_);
  }

private:
  [[nodiscard]] int steps_per_indent() const { return case_.steps * static_cast<int>(case_.sequence.size()); }
  /// Index of the indent of the current step, counted over all places and cycles.
  [[nodiscard]] int indent() const { return done_ / steps_per_indent(); }
  /// Number of the place of the current step, counts from 1.
  [[nodiscard]] int place() const { return indent() / case_.cycles + 1; }
  [[nodiscard]] double x(int step) const
  {
    return case_.places[static_cast<std::size_t>(step / steps_per_indent() / case_.cycles)];
  }

  /// Value of the drive at a share of the current entry.
  [[nodiscard]] double imposed(double share) const { return pressed_between(kind(), from_, to_, share); }

  void begin_entry(int in_indent, const Stepper::Distances& touch)
  {
    const double entry = case_.sequence[static_cast<std::size_t>(in_indent / case_.steps)].value;
    from_ = in_indent == 0 ? without_contact(kind(), touch) : to_;
    to_ = entry == 0.0 ? without_contact(kind(), touch) : entry;
  }

  [[nodiscard]] Drive::Kind kind() const { return case_.sequence.front().kind; }

  const IndentationCase& case_;
  int steps_;           ///< number of steps of the run
  SurfaceGrid contact_; ///< contact grid at the start; used for periods, whose grid does not grow
  IndentReader current_;
  std::vector<Indent> indents_;
  double trapezoid_ = 0.0; ///< work of the drive so far, by the trapezoidal rule [J]
  double begun_ = 0.0;     ///< work before the current indent [J]
  double from_ = 0.0,
         to_ = 0.0; ///< load, approach or mean gap at beginning and end of the current entry of the sequence
  int done_ = 0;    ///< number of finished steps
};

/// Whether both bodies always have the same history.
bool are_twins(const IndentationCase& indentation, const IndentationPlan& plan)
{
  return indentation.solver.mirror && indentation.places == std::vector{0.0} && plan.lower == plan.upper &&
         alike(indentation.lower, indentation.upper);
}

/// Checks mean gaps: they must press the bodies together (be smaller than the mean gap at first touch), and a cycle must end
/// without contact.
void require_contact(const IndentationCase& indentation, double touching_gap)
{
  if (indentation.sequence.front().kind != Drive::Kind::mean_gap)
    return;
  const auto touches = [&](const Drive& drive) { return drive.value < touching_gap; };
  if (std::none_of(indentation.sequence.begin(), indentation.sequence.end(), touches))
    throw InputError(fmt::format("the mean gap is never below {:g} m, where the surfaces first touch", touching_gap));
  if ((indentation.cycles > 1 || indentation.places.size() > 1) && touches(indentation.sequence.back()))
    throw InputError(fmt::format("with several cycles or places the last mean gap must not be below {:g} m, where the "
                                 "surfaces first touch",
                                 touching_gap));
}

/// Checks that the largest imposed approach does not bring the whole period into contact. The reader of case files checks this
/// too; here it is for cases made by a program.
void require_drives(const IndentationCase& indentation)
{
  if (indentation.sequence.empty() || indentation.places.empty())
    throw InputError("an indentation needs one drive and one place at least");
  for (const Drive& drive : indentation.sequence)
    if (!std::isfinite(drive.value) || (drive.kind == Drive::Kind::load && drive.value < 0.0))
      throw InputError(fmt::format("indentation by {} = {:g} {}; allowed: {}", text_of(drive.kind).name, drive.value,
                                   text_of(drive.kind).unit,
                                   drive.kind == Drive::Kind::load ? "finite, >= 0" : "finite"));
}

void require_approach(const IndentationCase& indentation, const contact::Drive& largest)
{
  if (indentation.sequence.front().kind != Drive::Kind::approach)
    return;
  if (const auto reason = reason_against_approach(indentation.lower, indentation.upper, largest.value,
                                                  indentation.domain, "IndentationCase"))
    throw InputError(fmt::format("an approach of {:.4g} m {}", largest.value, *reason));
}

} // namespace

IndentationPlan plan(const IndentationCase& indentation)
{
  const char* resting = "the surfaces do not slide in an indentation; allowed: 0, or another scenario";
  require_friction(indentation, resting);
  require_effects(indentation, resting);
  if (indentation.heat.source.exists())
    throw PlanError(
        "`HeatSettings::source`: no heat is computed in an indentation; allowed: none, or another scenario");
  require_drives(indentation);
  const contact::Drive largest = largest_drive(indentation);
  require_approach(indentation, largest);
  const Footprint f = footprint(indentation.lower, indentation.upper, largest, indentation.domain);
  double track = 0.0;
  for (const double x : indentation.places)
    track = std::max(track, std::abs(x));
  IndentationPlan plan;
  plan.surfaces_only = needs_surfaces_only(indentation);
  lay_out(indentation, f, track, 0.0, plan);
  check_grids(indentation, plan);
  plan.contact_radius = f.half_x;
  plan.contact_radius_y = f.half_y;
  plan.touching_gap = indentation.domain.is_periodic() ? touching_gap(indentation, plan.contact) : nan;
  require_contact(indentation, plan.touching_gap);
  plan.twin = are_twins(indentation, plan) ? elastoplastic::Twin::alike : elastoplastic::Twin::none;
  mirror_grids(is_solved_by_halves(indentation, plan.contact), plan);
  plan.steps = step_count(static_cast<double>(indentation.steps) * indentation.cycles *
                              static_cast<double>(indentation.sequence.size() * indentation.places.size()),
                          "`IndentationCase::steps`");
  end_plan(indentation, false, plan, [] { return halfspace::HeatTimes(); });
  return plan;
}

void IndentationRecord::exchange(Archive& archive)
{
  exchange_row(*this, archive);
}

template <>
struct MotionOf<IndentationCase>
{
  using Type = Indentation;
};

template class Run<IndentationCase>;

} // namespace brinell::simulation
