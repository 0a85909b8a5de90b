// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/increment.hpp"

#include "brinell/foundation/error.hpp"
#include "contact_parts.hpp"
#include "foundation/require_size.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>

/// One increment, from its start to its commit.
namespace brinell::elastoplastic
{

namespace
{

/// Restores the state before the increment on destruction, unless the increment was committed.
class Rollback
{
public:
  explicit Rollback(ContactParts& c) : c_(c), state_(c.state), window_error_(c.window_error) {}
  ~Rollback()
  {
    if (committed_)
      return;
    rewind();
    c_.window_error = window_error_;
    for (const std::unique_ptr<Effect>& effect : c_.effects)
      effect->restore();
  }
  Rollback(const Rollback&) = delete;
  Rollback& operator=(const Rollback&) = delete;
  void commit() { committed_ = true; }
  /// Returns to the state before the increment; what effects have found stays.
  void rewind()
  {
    c_.state = state_;
    for (Side& side : c_.sides)
      side.body.restore();
    if (c_.interface)
      c_.interface->restore();
    if (c_.heating)
      c_.heating->restore();
  }

private:
  ContactParts& c_;
  SurfaceState state_;
  WindowError window_error_;
  bool committed_ = false;
};

/// Whether the increment presses the bodies less against each other than the one before, at the same place.
bool lifts(const ContactParts& c, const Task& task)
{
  if (task.placement.lower != c.placement.lower || task.placement.upper != c.placement.upper)
    return false;
  constexpr double rounding = 1e-9;
  const double value = task.drive.value, least = (1.0 - rounding);
  switch (task.drive.kind)
  {
  case contact::Drive::Kind::approach:
    return value < least * c.state.approach;
  case contact::Drive::Kind::load:
    return value < least * sum(c.state.pressure) * c.grid().cell_area();
  case contact::Drive::Kind::mean_gap:
    return least * value * static_cast<double>(c.state.gap.size()) > sum(c.state.gap);
  }
  return false;
}

void begin(ContactParts& c, const Task& task)
{
  // Plastic flow does not go on when the bodies are lifted. In deep indents the last flow would be a guess so far off that the
  // iteration went astray.
  const Body::Guess guess = lifts(c, task) ? Body::Guess::stress : Body::Guess::last_increment;
  for (Side& side : c.sides)
    side.body.begin((task.placement.*side.place).column - (c.placement.*side.place).column,
                    task.strategy.stiffness_share, guess);
  begin_effects(c);
  if (c.heating)
    begin_heating(c, task);
  else
    soften_by_effects(c);
}

/// Iterates an increment, and repeats it until the softening by the effects fits its end. Where the heat of the bodies is computed,
/// that softens them.
IncrementReport solve(ContactParts& c, const Task& task, Rollback& rollback)
{
  int evaluations = 0;
  for (int turn = 0;; ++turn)
  {
    begin(c, task);
    IncrementReport report = iterate(c, task);
    evaluations += report.evaluations;
    report.evaluations = evaluations;
    if (!report.converged || c.heating || !renews_softening(c, task.placement, turn))
      return report;
    rollback.rewind();
    if (c.interface)
      begin_friction(c, task);
  }
}

/// Makes a converged trial the new state.
void commit(ContactParts& c, const Task& task, IncrementReport& report)
{
  on_sides(c, [&](std::size_t side) { c.sides[side].body.complete_trial(); });
  if (c.interface)
    settle_friction(c, task.placement);
  for (const std::unique_ptr<Effect>& effect : c.effects)
    effect->settle(interaction(c), task.placement);
  const std::array<std::vector<double>, 2> works = works_that_heat(c);
  if (c.heating)
    find_heat_of_increment(c, task.motion, works);
  // From here on nothing may fail: what is committed cannot be taken back.
  on_sides(c, [&](std::size_t side) { c.sides[side].body.commit(c.sides[side].load()); });
  report.energy =
      energy(c, imposed_approach(task.drive, report.approach)); // after commit, which computes the locked-in part
  for (const std::unique_ptr<Effect>& effect : c.effects)
    effect->commit(interaction(c), task.placement);
  if (c.heating)
    settle_heating(c, works);
  c.placement = task.placement;
  c.state.approach = report.approach;
}

} // namespace

IncrementReport CoupledContact::advance(std::span<const double> distance, const contact::Drive& drive,
                                        const Placement& placement, const Strategy& strategy, const Motion& motion)
{
  ContactParts& c = *parts_;
  require_size("CoupledContact::advance: the distance", distance, c.grid().size());
  const Task task{distance, drive, placement, motion, strategy};
  if (strategy.stay_within_grids && carries_off(c, placement))
  {
    IncrementReport report;
    report.outgrown.contact_ends = true;
    return report;
  }
  c.slid = motion.slides ? motion.slid : 0.0;
  c.step = motion.step;
  if (c.interface)
    begin_friction(c, task);
  Rollback rollback(c);
  IncrementReport report = solve(c, task, rollback);
  if (!report.converged)
    return report;
  for (Side& side : c.sides)
    side.body.fetch();
  report.outgrown = outgrown(c);
  if (strategy.stay_within_grids && report.outgrown.any())
  {
    report.converged = false;
    return report;
  }
  if (std::any_of(c.sides.begin(), c.sides.end(), [](const Side& side) { return side.leaves_grid; }))
    throw GridError("the contact has reached the end of a material grid");
  commit(c, task, report);
  rollback.commit();
  return report;
}

} // namespace brinell::elastoplastic
