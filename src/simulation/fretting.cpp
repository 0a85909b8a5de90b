// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/simulation/fretting.hpp"

#include "brinell/foundation/error.hpp"
#include "domain.hpp"
#include "footprint.hpp"
#include "friction.hpp"
#include "grid_layout.hpp"
#include "judgement.hpp"
#include "memory.hpp"
#include "run_state.hpp"
#include "wear.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace brinell::simulation
{

namespace
{

using contact::Drive;
using contact::TangentialDrive;

/// Pressed together, then to and fro.
class Fretting
{
public:
  Fretting(const FrettingCase& fretting, const FrettingPlan& plan)
      : case_(fretting), steps_(plan.steps), cos_(std::cos(fretting.direction)), sin_(std::sin(fretting.direction))
  {
    // A right angle, but for the rounding of pi.
    for (double* part : {&cos_, &sin_})
      if (std::abs(*part) < 1e-15)
        *part = 0.0;
  }

  [[nodiscard]] Stepper::Setup setup() const
  {
    Stepper::Setup setup = shaped_setup(case_.lower, case_.upper, case_.solver, {});
    setup.sliding = {.friction = case_.friction, .sticks = true, .wear = case_.wear};
    return setup;
  }
  [[nodiscard]] Centre centre() const { return {}; }
  [[nodiscard]] bool is_done() const { return done_ == steps_; }
  [[nodiscard]] int step_count() const { return steps_; }

  [[nodiscard]] Move next(Stepper& stepper)
  {
    if (done_ == 0)
    {
      const double touch = stepper.clearance({});
      from_ = by_load() ? 0.0 : std::min(0.0, touch);
      at_.approach = touch;
    }
    const auto path = [this](double t) {
      return Target{{}, {case_.press.kind, pressed(done_ + t)}, true, along(share(done_ + t))};
    };
    constexpr double finest = 1.0 / 64;
    const bool is_pressing = done_ < case_.press_steps;
    return {path, finest,
            is_pressing
                ? fmt::format("step {}, pressing", done_)
                : fmt::format("step {}, cycle {}, {} = {:g} {}", done_, cycle(), by_force() ? "force" : "displacement",
                              share(done_ + 1.0) * case_.amplitude, by_force() ? "N" : "m")};
  }

  void read(Stepper& stepper, const FrettingRecord& /*before*/, FrettingRecord& r)
  {
    r.cycle = cycle();
    r.pass = std::max(1, r.cycle);
    r.approach = r.F_n > 0.0 ? stepper.pair().approach() : stepper.clearance({});
    r.work += 0.5 * (r.F_n + at_.F_n) * (r.approach - at_.approach);
    at_.F_n = r.F_n;
    at_.approach = r.approach;
    if (const elastoplastic::PartialSlip* slip = stepper.pair().partial_slip())
      read(*slip, r);
    if (r.cycle > 0)
      add_to_cycle(r);
    ++done_;
    const int moved = done_ - case_.press_steps;
    if (moved < 0 || moved % case_.steps_per_cycle != 0)
      return;
    if (moved > 0)
      cycles_.push_back(current_);
    begin_cycle(r);
  }

  void summarise(FrettingSummary& summary, const StepFields& /*end*/) const { summary.cycles = cycles_; }

  void exchange(Archive& archive)
  {
    archive("at", at_);
    archive("current", current_);
    archive("begun", begun_);
    archive.list("cycles", cycles_);
    archive("from", from_);
    archive("done", done_, 0, steps_);
  }

private:
  /// Where the drive has worked so far.
  struct WorkedTo
  {
    double approach = 0.0, F_n = 0.0, along = 0.0; ///< [m], [N], [J]

    void exchange(Archive& archive)
    {
      archive("approach", approach);
      archive("F_n", F_n);
      archive("along", along);
    }
  };
  /// Sums before the present cycle.
  struct Begun
  {
    double along = 0.0, friction = 0.0, plastic = 0.0, path = 0.0; ///< [J], [J], [J], [m]

    void exchange(Archive& archive)
    {
      archive("along", along);
      archive("friction", friction);
      archive("plastic", plastic);
      archive("path", path);
    }
  };

  [[nodiscard]] bool by_load() const { return case_.press.kind == Drive::Kind::load; }
  [[nodiscard]] bool by_force() const { return case_.kind == FrettingCase::Kind::force; }
  /// Of the step at hand.
  [[nodiscard]] int cycle() const
  {
    return done_ < case_.press_steps ? 0 : (done_ - case_.press_steps) / case_.steps_per_cycle + 1;
  }
  /// Load or approach. Loads go by their power 2/3, so that the approach grows evenly.
  [[nodiscard]] double pressed(double steps) const
  {
    const double share = std::min(1.0, steps / case_.press_steps);
    if (!by_load())
      return from_ + (case_.press.value - from_) * share;
    return share == 1.0 ? case_.press.value : std::pow(std::pow(case_.press.value, 2.0 / 3.0) * share, 1.5);
  }
  /// Of the amplitude: 0, 1, 0, -1, 0 in the quarters of a cycle, straight in between.
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
    const auto [x, y] = slip.shift();
    const auto [F_x, F_y] = slip.forces();
    r.displacement = x * cos_ + y * sin_;
    r.F_x = F_x;
    r.F_y = F_y;
    r.force = F_x * cos_ + F_y * sin_;
    r.work += slip.work() - at_.along;
    at_.along = slip.work();
    r.dissipation_friction = slip.heat();
    r.stick_share = slip.pressed_cells() > 0 ? static_cast<double>(slip.sticking_cells()) / slip.pressed_cells() : 0.0;
    r.stick_area = r.stick_share * r.contact_area;
    r.slip_path = *std::max_element(slip.path().begin(), slip.path().end());
  }

  void begin_cycle(const FrettingRecord& r)
  {
    begun_ = {at_.along, r.dissipation_friction, plastic(r), r.slip_path};
    current_ = {};
    current_.stick_share = 1.0;
  }

  void add_to_cycle(const FrettingRecord& r)
  {
    FrettingCycle& c = current_;
    c.cycle = r.cycle;
    c.work = at_.along - begun_.along;
    c.dissipation_friction = r.dissipation_friction - begun_.friction;
    c.dissipation_plastic = plastic(r) - begun_.plastic;
    c.max_force = std::max(c.max_force, std::abs(r.force));
    c.max_displacement = std::max(c.max_displacement, std::abs(r.displacement));
    c.slip_amplitude = 0.25 * (r.slip_path - begun_.path);
    c.stick_share = std::min(c.stick_share, r.stick_share);
    c.max_equivalent_plastic_strain = r.max_equivalent_plastic_strain;
  }

  [[nodiscard]] static double plastic(const FrettingRecord& r) { return r.dissipation_lower + r.dissipation_upper; }

  const FrettingCase& case_;
  int steps_; ///< of the run
  double cos_, sin_;
  double from_ = 0.0; ///< load or approach at the start
  WorkedTo at_;
  Begun begun_;
  FrettingCycle current_;
  std::vector<FrettingCycle> cycles_;
  int done_ = 0; ///< steps
};

void require_press(const Drive& press, int steps)
{
  const bool by_load = press.kind == Drive::Kind::load;
  const char* key = by_load ? "fretting.load" : "fretting.approach";
  if (press.kind == Drive::Kind::mean_gap)
    throw KeyError("fretting.load", "fretting needs a load or an approach");
  if (!(press.value > 0.0 && std::isfinite(press.value)))
    throw KeyError(key, fmt::format("{} = {:g} {}; allowed: > 0", key, press.value, by_load ? "N" : "m"));
  if (steps < 1)
    throw KeyError("fretting.press_steps", fmt::format("fretting.press_steps = {}; allowed: >= 1", steps));
}

void require_cycles(const FrettingCase& fretting)
{
  if (fretting.cycles < 0)
    throw KeyError("fretting.cycles", fmt::format("fretting.cycles = {}; allowed: >= 0", fretting.cycles));
  if (fretting.steps_per_cycle < 4 || fretting.steps_per_cycle % 4 != 0)
    throw KeyError("fretting.steps_per_cycle",
                   fmt::format("fretting.steps_per_cycle = {}; allowed: multiples of 4", fretting.steps_per_cycle));
  if (!std::isfinite(fretting.direction))
    throw KeyError("fretting.direction", fmt::format("fretting.direction = {:g}; allowed: finite", fretting.direction));
}

/// Load above which no contact of these bodies comes [N]. Under an approach it is that of the elastic bodies, if these are smooth,
/// and more where they stick: surfaces that do not slip are stiffer, most of all beside a rigid body (Spence 1968).
double largest_load(const FrettingCase& fretting, const Footprint& footprint)
{
  if (fretting.press.kind == Drive::Kind::load)
    return fretting.press.value;
  if (!are_smooth(fretting.lower, fretting.upper))
    return std::numeric_limits<double>::infinity();
  double stuck = 1.0;
  for (const Elastic& body : {fretting.lower.material.elastic, fretting.upper.material.elastic})
    if (const double nu = body.poisson_ratio; !body.is_rigid() && nu < 0.499) // there the ratio is 1
      stuck = std::max(stuck, (1.0 - nu) * std::log(3.0 - 4.0 * nu) / (1.0 - 2.0 * nu));
  constexpr double error_of_cells = 0.1; // of coarse ones
  return (1.0 + error_of_cells) * stuck * footprint.elastic_load;
}

void require_held(const FrettingCase& fretting, const std::string& given, double load)
{
  const double most = fretting.friction.coefficient * load;
  if (fretting.amplitude < most)
    return;
  const std::string carried =
      fretting.press.kind == Drive::Kind::load
          ? "friction times load"
          : fmt::format("friction times the largest load under fretting.approach = {:g} m", fretting.press.value);
  throw KeyError("fretting.force", fmt::format("{}; allowed: below {:g} N, {}, at which all of the contact slides: "
                                               "give a displacement for that",
                                               given, most, carried));
}

/// What friction can carry, and the contact that stays where it is.
void require_amplitude(const FrettingCase& fretting, const Footprint& footprint)
{
  const bool by_force = fretting.kind == FrettingCase::Kind::force;
  const std::string key = by_force ? "fretting.force" : "fretting.displacement";
  const std::string given = fmt::format("{} = {:g} {}", key, fretting.amplitude, by_force ? "N" : "m");
  if (!(fretting.amplitude >= 0.0 && std::isfinite(fretting.amplitude)))
    throw KeyError(key, given + "; allowed: >= 0");
  if (fretting.amplitude > 0.0 && fretting.friction.coefficient == 0.0)
    throw KeyError("interface.friction",
                   "interface.friction = 0 with " + given + ": nothing holds the surfaces; allowed: > 0");
  if (by_force && fretting.amplitude > 0.0)
    require_held(fretting, given, largest_load(fretting, footprint));
  if (!by_force && !(fretting.amplitude <= footprint.half_x))
    throw KeyError(
        key, fmt::format("{}; allowed: up to {:.3g} m, the radius of the contact, which is counted as staying where "
                         "it is",
                         given, footprint.half_x));
}

/// Of a round contact (Mindlin 1949): shift over approach at full sliding.
double sliding_displacement(const FrettingCase& fretting, double approach)
{
  double compliance = 0.0;
  for (const Elastic& body : {fretting.lower.material.elastic, fretting.upper.material.elastic})
    compliance += body.is_rigid() ? 0.0 : (2.0 - body.poisson_ratio) / body.shear_modulus();
  const double modulus = contact_modulus(fretting.lower.material.elastic, fretting.upper.material.elastic);
  return 0.25 * fretting.friction.coefficient * approach * modulus * compliance;
}

/// Whether the upper body always is the image of the lower one, reversed in x: one of them is moved to the left as the other is
/// to the right, under a pressure that is even.
bool are_twins(const FrettingCase& fretting, const FrettingPlan& plan)
{
  const bool is_along_x = std::abs(std::sin(fretting.direction)) < 1e-15;
  return fretting.solver.mirror && !fretting.wear.wears() && is_along_x && !fretting.domain.x.is_periodic() &&
         plan.lower == plan.upper && alike(fretting.lower, fretting.upper);
}

// docs/verification.md (expected error)
constexpr Documented documented[] = {{"largest force along the surface", "cycles[*].max_force_N", 0.002, 8.0, 1.0},
                                     {"heat of friction", "cycles[*].dissipation_friction_J", 0.01, 8.0, 1.0},
                                     {"plastic work", "cycles[*].dissipation_plastic_J", 0.05, 8.0, 1.0},
                                     {"slip amplitude", "cycles[*].slip_amplitude_m", 0.2, 8.0, 1.0}};

Facts facts(const FrettingCase& c, const FrettingPlan& plan)
{
  Facts f = facts_of(c, c.lower, c.upper, plan, plan.contact_radius, plan.contact_radius_y);
  f.documented = documented;
  return f;
}

/// Width of the ring that slips at the turns over the contact radius, of smooth elastic balls: Mindlin (1949), Mindlin and
/// Deresiewicz (1953). None where these do not hold, or nothing moves, or all of the contact slides.
std::optional<double> slip_ring(const FrettingCase& c, const FrettingPlan& plan)
{
  const bool is_round = c.lower.texture.is_smooth() && c.upper.texture.is_smooth() && !c.domain.x.is_periodic() &&
                        !c.domain.y.is_periodic() && plan.sliding_displacement > 0.0;
  if (!is_round || c.amplitude == 0.0)
    return std::nullopt;
  if (c.kind == FrettingCase::Kind::shift)
  {
    const double share = c.amplitude / plan.sliding_displacement;
    return share < 1.0 ? std::optional(1.0 - std::sqrt(1.0 - share)) : std::nullopt;
  }
  if (c.press.kind != contact::Drive::Kind::load)
    return std::nullopt;
  return 1.0 - std::cbrt(1.0 - c.amplitude / (c.friction.coefficient * c.press.value));
}

/// The loop is then off by more than its documented error: 13 and 16 % with 0.6 and 0.9 cells, 6 % with 1.2, below 4 % from 1.9 cells on.
std::optional<Warning> thin_slip(const FrettingCase& c, const FrettingPlan& plan)
{
  constexpr double fewest = 2.0;
  const std::optional<double> ring = slip_ring(c, plan);
  const double cells = std::min(plan.contact_radius / plan.contact.dx, plan.contact_radius_y / plan.contact.dy);
  if (!ring || !(*ring * cells < fewest))
    return std::nullopt;
  return Warning{
      "thin_slip",
      fmt::format("the ring that slips is only about {:.2g} cells wide, by the elastic solution of two balls: "
                  "energy and slip of a cycle may be off by 5 to 20 %. Take a grid.resolution of {:.0f}",
                  *ring * cells, std::ceil(fewest / *ring))};
}

} // namespace

FrettingPlan plan(const FrettingCase& fretting)
{
  require_friction(fretting, fretting.lower, fretting.upper, "");
  require_press(fretting.press, fretting.press_steps);
  require_cycles(fretting);
  // Where nothing moves, there is no shear that would let the bodies yield earlier.
  const double friction = fretting.amplitude > 0.0 ? fretting.friction.coefficient : 0.0;
  const Footprint f = footprint(fretting.lower, fretting.upper, fretting.press, fretting.domain, friction);
  require_amplitude(fretting, f);
  require_wear(fretting, fretting.amplitude > 0.0 && fretting.cycles > 0
                             ? ""
                             : "nothing slides in no cycle, or with an amplitude of 0; allowed: 0, or a motion");
  FrettingPlan plan;
  lay_out(fretting, f, 0.0, 0.0, plan);
  require_cells_in_periods(fretting.lower, fretting.upper, fretting.domain, plan.contact);
  plan.reference = reference_distance(fretting.lower.shape, fretting.upper.shape, fretting.domain);
  plan.contact_radius = f.half_x;
  plan.contact_radius_y = f.half_y;
  plan.sliding_displacement = sliding_displacement(fretting, f.approach);
  plan.steps = step_count(fretting.press_steps + static_cast<double>(fretting.cycles) * fretting.steps_per_cycle,
                          "fretting.cycles");
  plan.twin = are_twins(fretting, plan) ? elastoplastic::Twin::mirror_image : elastoplastic::Twin::none;
  plan.memory_bytes = memory_bytes(plan, fretting.lower.material, fretting.upper.material,
                                   fretting.solver.anderson_depth, fretting.friction.coefficient > 0.0 ? 2 : 0, false);
  return plan;
}

void FrettingRecord::exchange(Archive& archive)
{
  exchange_row(*this, archive);
}

void FrettingCycle::exchange(Archive& archive)
{
  exchange_columns(*this, archive);
}

Quality expected_quality(const FrettingCase& fretting, const FrettingPlan& plan)
{
  return quality_before(facts(fretting, plan), thin_slip(fretting, plan));
}

Quality quality(const FrettingCase& fretting, const FrettingPlan& plan, const RunTotals& totals)
{
  return quality_after(facts(fretting, plan), totals, thin_slip(fretting, plan));
}

template <>
struct MotionOf<FrettingCase>
{
  using Type = Fretting;
};

template class Run<FrettingCase>;

} // namespace brinell::simulation
