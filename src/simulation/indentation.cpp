// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/indentation.hpp"

#include "brinell/foundation/error.hpp"
#include "domain.hpp"
#include "footprint.hpp"
#include "grid_layout.hpp"
#include "indent.hpp"
#include "run_state.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace brinell::simulation
{

namespace
{

using contact::Drive;

Drive largest_drive(const IndentationCase& indentation)
{
  if (indentation.sequence.empty())
    throw InputError("an indentation needs at least one load or approach");
  Drive largest = indentation.sequence.front();
  for (const Drive& drive : indentation.sequence)
    largest.value = std::max(largest.value, drive.value);
  if (!(largest.value > 0.0))
    throw InputError("an indentation needs a load or an approach > 0");
  return largest;
}

/// Loading and unloading, place after place.
class Indentation
{
public:
  Indentation(const IndentationCase& indentation, const IndentationPlan& plan)
      : case_(indentation), steps_(plan.steps), current_(x(0), 0, 0, 0.0)
  {
  }

  [[nodiscard]] Stepper::Setup setup() const
  {
    return shaped_setup(case_.lower, case_.upper, case_.solver, {case_.places.front(), 0.0});
  }
  [[nodiscard]] Centre centre() const { return {x(std::max(done_ - 1, 0)), 0.0}; }
  [[nodiscard]] bool is_done() const { return done_ == steps_; }
  [[nodiscard]] int step_count() const { return steps_; }

  [[nodiscard]] Move next(Stepper& stepper)
  {
    const Centre here{x(done_), 0.0};
    const int in_indent = done_ % steps_per_indent();
    const int in_entry = in_indent % case_.steps;
    const double touch = stepper.clearance(here);
    if (in_indent == 0)
      current_ = IndentReader(here.lower, indent() / case_.cycles, indent() % case_.cycles, touch);
    if (in_entry == 0)
      begin_entry(in_indent, touch);
    if (in_entry + 1 == case_.steps && to_ <= 0.0) // lifted: what has yielded on the way counts
      to_ = std::min(to_, lifted(touch));
    const auto path = [this, here, in_entry](double t) {
      return Target{here, {case_.sequence.front().kind, imposed((in_entry + t) / case_.steps)}};
    };
    constexpr double finest = 1.0 / 64;
    return {path, finest,
            fmt::format("step {}, {} = {:g} {}", done_, by_load() ? "load" : "approach", path(1.0).drive.value,
                        by_load() ? "N" : "m")};
  }

  void read(Stepper& stepper, const IndentationRecord& /*before*/, IndentationRecord& r)
  {
    const Centre here{x(done_), 0.0};
    r.pass = indent();
    r.place = indent() / case_.cycles;
    r.x = here.lower;
    r.approach = stepper.pair().approach();
    r.contact_radius = std::sqrt(r.contact_area / std::numbers::pi);
    r.mean_pressure = r.contact_area > 0.0 ? r.F_n / r.contact_area : 0.0;
    const auto [highest, deepest] = stepper.residual_range(here);
    r.residual_depth = deepest;
    r.pile_up = -highest;
    r.work += current_.add(r, r.F_n > 0.0 ? 0.0 : stepper.clearance(here));
    if (++done_ % steps_per_indent() == 0)
      indents_.push_back(current_.result());
  }

  void summarise(IndentationSummary& summary) const { summary.indents = indents_; }

  void exchange(Archive& archive)
  {
    archive("current", current_);
    archive.list("indents", indents_);
    archive("from", from_);
    archive("to", to_);
    archive("done", done_, 0, steps_);
  }

private:
  [[nodiscard]] int steps_per_indent() const { return case_.steps * static_cast<int>(case_.sequence.size()); }
  /// Of the present step.
  [[nodiscard]] int indent() const { return done_ / steps_per_indent(); }
  [[nodiscard]] double x(int step) const
  {
    return case_.places[static_cast<std::size_t>(step / steps_per_indent() / case_.cycles)];
  }

  /// An imposed approach of zero means no contact, dents and bumps included.
  [[nodiscard]] double lifted(double touch) const { return by_load() ? 0.0 : std::min(0.0, touch); }

  /// Load or approach at a share of the present entry. Loads go by their power 2/3, so that the depth grows evenly: the first
  /// step in load would be the longest by far.
  [[nodiscard]] double imposed(double share) const
  {
    if (!by_load())
      return from_ + (to_ - from_) * share;
    const double from = std::pow(from_, 2.0 / 3.0);
    return share == 1.0 ? to_ : std::pow(from + (std::pow(to_, 2.0 / 3.0) - from) * share, 1.5);
  }

  void begin_entry(int in_indent, double touch)
  {
    const double entry = case_.sequence[static_cast<std::size_t>(in_indent / case_.steps)].value;
    from_ = in_indent == 0 ? lifted(touch) : to_;
    to_ = entry == 0.0 ? lifted(touch) : entry;
  }

  [[nodiscard]] bool by_load() const { return case_.sequence.front().kind == Drive::Kind::load; }

  const IndentationCase& case_;
  int steps_; ///< of the run
  IndentReader current_;
  std::vector<Indent> indents_;
  double from_ = 0.0, to_ = 0.0; ///< load or approach at the ends of the present entry of the sequence
  int done_ = 0;                 ///< steps
};

/// Whether both bodies always have the same history.
bool are_twins(const IndentationCase& indentation, const IndentationPlan& plan)
{
  return indentation.solver.mirror && indentation.places == std::vector{0.0} && plan.lower == plan.upper &&
         alike(indentation.lower, indentation.upper);
}

} // namespace

IndentationPlan plan(const IndentationCase& indentation)
{
  const Footprint f = footprint(indentation.lower, indentation.upper, largest_drive(indentation), indentation.domain);
  double track = 0.0;
  for (const double x : indentation.places)
    track = std::max(track, std::abs(x));
  IndentationPlan plan;
  lay_out(indentation, f, track, 0.0, plan);
  require_cells_in_periods(indentation.lower, indentation.upper, indentation.domain, plan.contact);
  plan.reference = reference_distance(indentation.lower.shape, indentation.upper.shape, indentation.domain);
  plan.contact_radius = f.half_x;
  plan.contact_radius_y = f.half_y;
  plan.twin = are_twins(indentation, plan) ? elastoplastic::Twin::alike : elastoplastic::Twin::none;
  plan.steps = step_count(static_cast<double>(indentation.steps) * indentation.cycles *
                              static_cast<double>(indentation.sequence.size() * indentation.places.size()),
                          "indentation.steps");
  plan.memory_bytes = memory_bytes(plan, indentation.lower.material.is_plastic(),
                                   indentation.upper.material.is_plastic(), indentation.solver.anderson_depth);
  return plan;
}

template <>
struct MotionOf<IndentationCase>
{
  using Type = Indentation;
};

template class Run<IndentationCase>;

} // namespace brinell::simulation
