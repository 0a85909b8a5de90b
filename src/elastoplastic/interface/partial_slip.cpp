// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/partial_slip.hpp"

#include "brinell/foundation/embedding.hpp"
#include "brinell/foundation/error.hpp"
#include "contact/carried_field.hpp"
#include "slip_increment.hpp"
#include "stick_slip.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace brinell::elastoplastic
{

namespace
{

/// The columns by which both surfaces move through the contact grid in an increment.
std::array<int, 2> cells_carried(const Interface::Bodies& bodies)
{
  const std::array<int, 2> carried{-static_cast<int>(std::lround(bodies.lower_columns)), 0};
  const auto is_carried = [&](double columns) { return std::abs(columns + carried[0]) < 1e-6; };
  const bool rolls = is_carried(bodies.lower_columns) && is_carried(bodies.upper_columns);
  if (!rolls && sum(bodies.pressure) > 0.0)
    throw InternalError("PartialSlip: the contact moves by the same whole columns on both bodies");
  return carried;
}

/// Moves the quantities that belong to surface points through the contact grid as the contact rolls. Residual displacements are
/// read from the bodies at the new place and need no move.
void advect(std::span<const double> pressure, const SlipState& before, SlipIncrement& increment, SlipState& state)
{
  const std::array<int, 2>& carried = increment.drive.carried;
  contact::carry(increment.grid, carried, pressure, increment.pressure_before);
  for (std::size_t axis = 0; axis < 2; ++axis)
    contact::carry(increment.grid, carried, before.shear[axis], increment.shear_before[axis]);
  if (carried[0] == 0)
    return;
  for_fields(
      [&](const Traits& traits, const std::vector<double>& from, std::vector<double>& to)
      {
        if (traits.is_carried)
          contact::carry(increment.grid, carried, from, to);
      },
      before, state);
}

/// The usual tolerance of displacements is relative to the approach. Slip can be far smaller: shears at their bound displace the
/// surfaces by about friction times the approach, and the imposed motion of an increment may be smaller still. In rolling, errors
/// of the slip accumulate from step to step until the points have left the contact. Hence a tighter tolerance [m].
/// @param moved  motion that the increment imposes [m]
double tolerance_of_slip(const Interface::Start& start, double coefficient, double moved)
{
  constexpr double of_bound = 1e-4, of_motion = 1e-3, rounding = 1e-15;
  double wanted = of_bound * coefficient * start.approach;
  if (moved > 0.0)
    wanted = std::min(wanted, of_motion * moved);
  return std::min(start.tolerance, std::max(wanted, rounding * start.approach));
}

} // namespace

PartialSlip::PartialSlip(const SurfaceGrid& grid, const ElasticStack& lower, const ElasticStack& upper,
                         const Friction& friction, double reference)
    : Interface(friction), stick_slip_(std::make_unique<StickSlip>(grid, lower, upper, friction.coupling, reference)),
      increment_(std::make_unique<SlipIncrement>(grid, friction.coefficient))
{
  assign_fields(state_, grid.size());
  if (!stick_slip_->couples())
    state_.depth.clear();
}

PartialSlip::~PartialSlip() = default;

std::array<double, 2> PartialSlip::direction(const contact::TangentialDrive& along) const
{
  return direction_to(along, forces(), state_.shift);
}

void PartialSlip::begin(Start start)
{
  before_ = state_;
  SlipIncrement& now = *increment_;
  now.drive = {start.along, remaining_drive(start.along, state_.shift, state_.turned), cells_carried(start.bodies)};
  advect(start.bodies.pressure, before_, now, state_);
  now.bound.begin(std::move(start.limit), start.holds_law, now.pressure_before);
  const double coefficient = friction().coefficient;
  const double moved = driven_motion(now.grid, now.drive.along, forces(), sum(now.bound.now()) * now.grid.cell_area(),
                                     coefficient * start.approach); // displaced, by shears at their bound
  now.is_driven = moved > 0.0;
  now.tolerance = tolerance_of_slip(start, coefficient, moved);
  now.wants_stop = std::move(start.wants_stop);
  stick_slip_->begin(start.bodies, now);
}

void PartialSlip::set_limit(std::vector<double> limit)
{
  increment_->bound.set_limit(std::move(limit));
}

double PartialSlip::tolerance_of_gap(double usual) const
{
  return stick_slip_->couples() ? increment_->tolerance : usual;
}

Interface::Change PartialSlip::follow(const Bodies& bodies)
{
  Change change;
  change.is_solved = stick_slip_->solve(bodies, before_.shear, *increment_, state_.shear);
  change.is_overloaded = !increment_->is_carried();
  change.gap = stick_slip_->find_depth(state_.shear, state_.depth);
  return change;
}

Interface::Change PartialSlip::renew(const Bodies& bodies)
{
  return {.shear = increment_->bound.renew(bodies.pressure)};
}

double PartialSlip::held_energy() const
{
  return stick_slip_->held_energy(*increment_, state_.shear);
}

void PartialSlip::add_to_gap(std::span<double> gap) const
{
  for (std::size_t i = 0; i < state_.depth.size(); ++i)
    gap[i] += state_.depth[i];
}

void PartialSlip::embed(const Interface& smaller)
{
  const auto& other = dynamic_cast<const PartialSlip&>(smaller);
  embed_state(other.increment_->grid, other.state_, increment_->grid, state_);
}

void PartialSlip::recall(const Bodies& /*bodies*/)
{
  static_cast<void>(stick_slip_->find_depth(state_.shear, state_.depth));
}

} // namespace brinell::elastoplastic
