// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/fretting.hpp"

#include "brinell/foundation/embedding.hpp"
#include "brinell/foundation/error.hpp"
#include "column_statistics.hpp"
#include "drive_meter.hpp"
#include "pressing.hpp"
#include "run_state.hpp"
#include "slip_reading.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace brinell::simulation
{

namespace
{

using contact::Drive;
using contact::TangentialDrive;

/// Motion of fretting: press, then oscillate.
class Fretting
{
public:
  Fretting(const FrettingCase& fretting, const FrettingPlan& plan)
      : case_(fretting), steps_(plan.steps), heat_times_(plan.heat_times), cos_(std::cos(fretting.direction)),
        sin_(std::sin(fretting.direction))
  {
    // Makes right angles exact in spite of the rounding of pi.
    for (double* part : {&cos_, &sin_})
      if (std::abs(*part) < 1e-15)
        *part = 0.0;
  }

  [[nodiscard]] Stepper::Setup setup() const
  {
    Stepper::Setup setup = setup_of(case_, {}, heat_times_);
    setup.sliding.sticks = true;
    return setup;
  }
  [[nodiscard]] Centre centre() const { return {}; }
  [[nodiscard]] bool is_done() const { return done_ == steps_; }
  [[nodiscard]] int step_count() const { return steps_; }

  [[nodiscard]] Move next(Stepper& stepper)
  {
    if (done_ == 0)
    {
      const double touch = stepper.distances({}).smallest;
      from_ = by_load() ? 0.0 : std::min(0.0, touch);
      meter_.begin(0.0, touch);
    }
    const auto path = [this](double t)
    {
      Target target{{}, {case_.press.kind, pressed(done_ + t)}, true, along(share(done_ + t))};
      target.time = time(done_ + t);
      target.is_put_down = done_ == 0;
      return target;
    };
    const bool is_pressing = done_ < case_.press_steps;
    return {path, finest_press,
            is_pressing
                ? fmt::format("step {}, pressing", done_)
                : fmt::format("step {}, cycle {}, {} = {:g} {}", done_, cycle(), by_force() ? "force" : "displacement",
                              share(done_ + 1.0) * case_.amplitude, by_force() ? "N" : "m"),
            !is_pressing};
  }

  void read(Stepper& stepper, const FrettingRecord& before, FrettingRecord& r)
  {
    r.cycle = cycle();
    r.pass = std::max(1, r.cycle);
    r.approach = r.F_n > 0.0 ? stepper.pair().approach() : stepper.distances({}).smallest;
    r.work += meter_.to({.approach = r.approach, .F_n = r.F_n}).drive;
    const elastoplastic::PartialSlip* slip = stepper.pair().partial_slip();
    if (slip != nullptr)
      read(*slip, r);
    if (r.cycle > 0)
      current_.add(before, r);
    ++done_;
    const int moved = done_ - case_.press_steps;
    if (moved < 0 || moved % case_.steps_per_cycle != 0)
      return;
    if (moved > 0)
      cycles_.push_back(finished_cycle(stepper));
    current_ = {};
    work_before_ = work_along_;
    if (slip != nullptr)
      paths_.begin(stepper.pair().grid(), slip->state().path);
  }

  void summarise(FrettingSummary& summary, const StepFields& /*end*/) const { summary.cycles = cycles_; }

  void exchange(Archive& archive)
  {
    archive("drive", meter_);
    archive("work_along", work_along_);
    archive("current", current_);
    archive("work_before", work_before_);
    archive("paths_before", paths_);
    archive.list("cycles", cycles_);
    archive("from", from_);
    archive("done", done_, 0, steps_);
  }

private:
  /// Slip path of each point at the beginning of the current cycle.
  class Paths
  {
  public:
    void begin(const SurfaceGrid& grid, std::span<const double> path)
    {
      columns_ = grid.nx;
      path_.assign(path.begin(), path.end());
    }
    /// Largest growth at a point since then [m]. The contact grid may have grown in the cycle.
    [[nodiscard]] double largest_growth(const SurfaceGrid& grid, std::span<const double> path) const
    {
      SurfaceGrid smaller = grid;
      smaller.nx = columns_;
      smaller.ny = columns_ > 0 ? static_cast<int>(path_.size()) / columns_ : 0;
      if (smaller.nx > grid.nx || smaller.ny > grid.ny || smaller.size() != path_.size())
        throw InputError("the stored state has slip on a grid that does not fit; allowed: a run from its start");
      std::vector<double> before(grid.size());
      embed_field(smaller, path_, grid, before);
      double largest = 0.0;
      for (std::size_t i = 0; i < before.size(); ++i)
        largest = std::max(largest, path[i] - before[i]);
      return largest;
    }

    void exchange(Archive& archive)
    {
      archive("columns", columns_, 0, 1 << 20);
      archive.list("path", path_);
    }

  private:
    int columns_ = 0;
    std::vector<double> path_; ///< [m]
  };

  /// Time since the start after a number of steps, which all take as long [s]; 0 without a frequency.
  [[nodiscard]] double time(double steps) const
  {
    return case_.frequency ? steps / (case_.steps_per_cycle * *case_.frequency) : 0.0;
  }
  [[nodiscard]] bool by_load() const { return case_.press.kind == Drive::Kind::load; }
  [[nodiscard]] bool by_force() const { return case_.kind == FrettingCase::Kind::force; }
  /// Number of the cycle of the current step; 0 while pressing.
  [[nodiscard]] int cycle() const
  {
    return done_ < case_.press_steps ? 0 : (done_ - case_.press_steps) / case_.steps_per_cycle + 1;
  }
  /// Load or approach after a number of steps.
  [[nodiscard]] double pressed(double steps) const
  {
    return pressed_between(case_.press.kind, from_, case_.press.value, std::min(1.0, steps / case_.press_steps));
  }
  /// Factor on the amplitude after a number of steps: 0, 1, 0, -1, 0 at the quarters of a cycle, linear in between.
  [[nodiscard]] double share(double steps) const
  {
    const double quarters = std::max(0.0, steps - case_.press_steps) / (0.25 * case_.steps_per_cycle);
    const double phase = quarters - 4.0 * std::floor(0.25 * quarters);
    return phase <= 1.0 ? phase : (phase <= 3.0 ? 2.0 - phase : phase - 4.0);
  }
  [[nodiscard]] TangentialDrive along(double share) const
  {
    const double size = share * case_.amplitude;
    return {{case_.kind, size * cos_}, {case_.kind, size * sin_}, 0.0};
  }

  void read(const elastoplastic::PartialSlip& slip, FrettingRecord& r)
  {
    const auto [x, y] = slip.state().shift;
    const auto [F_x, F_y] = slip.forces();
    r.displacement = x * cos_ + y * sin_;
    r.F_x = F_x;
    r.F_y = F_y;
    r.force = F_x * cos_ + F_y * sin_;
    read_slip(slip, work_along_, r);
  }

  [[nodiscard]] FrettingCycle finished_cycle(const Stepper& stepper) const
  {
    using R = FrettingRecord;
    FrettingCycle c;
    c.cycle = static_cast<int>(current_.last(&R::cycle));
    c.work = work_along_ - work_before_;
    c.dissipation_friction = current_.growth(&R::dissipation_friction);
    c.dissipation_plastic = current_.growth(&R::dissipation_lower, &R::dissipation_upper);
    c.max_force = current_.largest_magnitude(&R::force);
    c.max_displacement = current_.largest_magnitude(&R::displacement);
    if (const elastoplastic::PartialSlip* slip = stepper.pair().partial_slip())
      c.slip_amplitude = 0.25 * paths_.largest_growth(stepper.pair().grid(), slip->state().path);
    c.stick_share = current_.smallest(&R::stick_share);
    c.max_equivalent_plastic_strain = current_.last(&R::max_equivalent_plastic_strain);
    return c;
  }

  const FrettingCase& case_;
  int steps_; ///< number of steps of the run
  halfspace::HeatTimes heat_times_;
  double cos_, sin_;
  double from_ = 0.0; ///< load or approach at the start
  DriveMeter meter_;
  double work_along_ = 0.0;  ///< of the tangential force since the start [J]
  double work_before_ = 0.0; ///< before the current cycle [J]
  Paths paths_;
  ColumnStatistics<FrettingRecord> current_; ///< over the steps of the current cycle
  std::vector<FrettingCycle> cycles_;
  int done_ = 0; ///< number of finished steps
};

} // namespace

void FrettingRecord::exchange(Archive& archive)
{
  exchange_row(*this, archive);
}

void FrettingCycle::exchange(Archive& archive)
{
  exchange_columns(*this, archive);
}

template <>
struct MotionOf<FrettingCase>
{
  using Type = Fretting;
};

template class Run<FrettingCase>;

} // namespace brinell::simulation
