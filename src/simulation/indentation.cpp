// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/indentation.hpp"

#include "brinell/foundation/error.hpp"
#include "footprint.hpp"
#include "indent.hpp"
#include "records.hpp"
#include "stepper.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
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

class Indentation
{
public:
  Indentation(const IndentationCase& indentation, const Observer<IndentationRecord>& observer)
      : case_(indentation), observer_(observer), plan_(plan(indentation)),
        stepper_(plan_, {indentation.lower.material,
                         indentation.upper.material,
                         [&indentation](double x, double y)
                         { return height(indentation.lower.shape, x, y) + height(indentation.upper.shape, x, y); },
                         indentation.solver,
                         {indentation.places.front(), 0.0},
                         indentation.lower.texture,
                         indentation.upper.texture,
                         observer.wants_stop,
                         observer.on_grid_change,
                         observer.available_memory})
  {
  }

  IndentationSummary run(const Archive::Fields* checkpoint)
  {
    resume(*this, checkpoint);
    while (done_ < plan_.steps)
      step();
    IndentationSummary result;
    result.steps = done_;
    result.iterations = iterations_;
    stepper_.fill(result);
    take_totals(last_, largest_work_, result);
    result.indents = indents_;
    result.last = last_;
    result.final_state = snapshot();
    return result;
  }

  /// Everything that the rest of the run depends on.
  void exchange(Archive& archive)
  {
    archive("stepper", stepper_);
    archive("last", last_);
    archive("current", current_);
    archive.list("indents", indents_);
    archive("largest_work", largest_work_);
    archive("iterations", iterations_, 0, std::numeric_limits<long>::max());
    archive("from", from_);
    archive("to", to_);
    archive("done", done_, 0, plan_.steps);
  }

private:
  [[nodiscard]] int steps_per_indent() const { return case_.steps * static_cast<int>(case_.sequence.size()); }
  [[nodiscard]] double x() const
  {
    return case_.places[static_cast<std::size_t>(std::min(done_, plan_.steps - 1) / steps_per_indent() / case_.cycles)];
  }
  [[nodiscard]] Centre centre() const { return {x(), 0.0}; }
  [[nodiscard]] Snapshot snapshot() const { return stepper_.snapshot(centre()); }

  void step()
  {
    const int indent = done_ / steps_per_indent();
    const int in_indent = done_ % steps_per_indent();
    const int in_entry = in_indent % case_.steps;
    const Centre here = centre();
    const double touch = stepper_.clearance(here);
    if (in_indent == 0)
      current_ = IndentReader(x(), indent / case_.cycles, indent % case_.cycles, touch);
    if (in_entry == 0)
      begin_entry(in_indent, touch);
    if (in_entry + 1 == case_.steps && to_ <= 0.0) // lifted: what has yielded on the way counts
      to_ = std::min(to_, lifted(touch));
    const auto path = [&](double t) {
      return Target{here, {case_.sequence.front().kind, imposed((in_entry + t) / case_.steps)}};
    };
    constexpr double finest = 1.0 / 64;
    const Target target = path(1.0);
    const std::string where = fmt::format("step {}, {} = {:g} {}", done_, by_load() ? "load" : "approach",
                                          target.drive.value, by_load() ? "N" : "m");
    const int evaluations = stepper_.advance(path, finest, where);
    record(indent, evaluations, here);
    if (in_indent + 1 == steps_per_indent())
      indents_.push_back(current_.result());
    // The snapshot of this step lies where the step was.
    const auto snap = [this, here] { return stepper_.snapshot(here); };
    ++done_;
    report(observer_, last_, plan_.steps, *this, snap);
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

  void record(int indent, int evaluations, const Centre& here)
  {
    IndentationRecord r;
    stepper_.fill(r);
    r.step = done_;
    r.pass = indent;
    r.place = indent / case_.cycles;
    r.x = x();
    r.approach = stepper_.pair().approach();
    r.contact_radius = std::sqrt(r.contact_area / std::numbers::pi);
    r.mean_pressure = r.contact_area > 0.0 ? r.F_n / r.contact_area : 0.0;
    const auto [highest, deepest] = stepper_.residual_range(here);
    r.residual_depth = deepest;
    r.pile_up = -highest;
    r.iterations = evaluations;
    r.work = last_.work + current_.add(r, r.F_n > 0.0 ? 0.0 : stepper_.clearance(here));
    largest_work_ = std::max(largest_work_, r.work);
    iterations_ += evaluations;
    last_ = r;
  }

  const IndentationCase& case_;
  const Observer<IndentationRecord>& observer_;
  IndentationPlan plan_;
  Stepper stepper_;
  IndentationRecord last_;
  IndentReader current_;
  std::vector<Indent> indents_;
  double from_ = 0.0, to_ = 0.0; ///< load or approach at the ends of the present entry of the sequence
  double largest_work_ = 0.0;
  long iterations_ = 0;
  int done_ = 0; ///< steps
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
  const Footprint f = footprint(indentation.lower, indentation.upper, largest_drive(indentation));
  double track = 0.0;
  for (const double x : indentation.places)
    track = std::max(track, std::abs(x));
  IndentationPlan plan;
  lay_out(indentation, f, track, 0.0, plan);
  plan.contact_radius = f.half_x;
  plan.contact_radius_y = f.half_y;
  plan.twin = are_twins(indentation, plan) ? elastoplastic::Twin::alike : elastoplastic::Twin::none;
  plan.steps = step_count(static_cast<double>(indentation.steps) * indentation.cycles *
                          static_cast<double>(indentation.sequence.size() * indentation.places.size()));
  plan.memory_bytes = memory_bytes(plan, indentation.lower.material.is_plastic(),
                                   indentation.upper.material.is_plastic(), indentation.solver.anderson_depth);
  return plan;
}

IndentationSummary run(const IndentationCase& indentation, const Observer<IndentationRecord>& observer,
                       const Archive::Fields* checkpoint)
{
  return Indentation(indentation, observer).run(checkpoint);
}

} // namespace brinell::simulation
