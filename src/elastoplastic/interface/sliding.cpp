// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/sliding.hpp"

#include "brinell/elastoplastic/placement.hpp"
#include "brinell/foundation/embedding.hpp"
#include "foundation/sharing.hpp"
#include "sheared_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace brinell::elastoplastic
{

namespace
{

/// Shear times the slope along x of a displacement, by central differences [Pa].
std::vector<double> stretch(const SurfaceGrid& grid, std::span<const double> shear,
                            std::span<const double> displacement)
{
  std::vector<double> result(grid.size());
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
    {
      const double q = shear[grid.index(i, j)];
      if (q == 0.0 || grid.nx == 1)
        continue;
      const bool wraps = grid.is_periodic_x();
      const int before = i > 0 ? i - 1 : (wraps ? grid.nx - 1 : i);
      const int after = i < grid.nx - 1 ? i + 1 : (wraps ? 0 : i);
      const double cells = wraps ? 2.0 : after - before;
      result[grid.index(i, j)] =
          q * (displacement[grid.index(after, j)] - displacement[grid.index(before, j)]) / (cells * grid.dx);
    }
  return result;
}

} // namespace

SlidingInterface::SlidingInterface(const SurfaceGrid& grid, const ElasticStack& lower, const ElasticStack& upper,
                                   const Friction& friction, int direction, double reference)
    : Interface(friction),
      surfaces_(std::make_unique<const ShearedSurfaces>(grid, lower, upper, friction.coupling, reference)),
      direction_(direction), limit_(grid.size(), std::numeric_limits<double>::infinity())
{
  assign_fields(state_, grid.size());
  for (std::vector<double>* field : {&work_per_area_, &shear_at_start_})
    field->assign(grid.size(), 0.0);
}

SlidingInterface::~SlidingInterface() = default;

std::array<double, 2> SlidingInterface::direction(const contact::TangentialDrive& along) const
{
  const double shift = along.x.value;
  return {shift == 0.0 ? static_cast<double>(direction_) : std::copysign(1.0, shift), 0.0};
}

void SlidingInterface::begin(Start start)
{
  before_ = state_;
  slides_ = start.slides;
  direction_ = direction(start.along)[0] > 0.0 ? 1 : -1;
  is_held_ = start.holds_law;
  share_at_rest_ = start.share_at_rest;
  if (!slides_)
    for (std::vector<double>* field : {&state_.shear, &state_.depth, &state_.lower_depth})
      std::fill(field->begin(), field->end(), 0.0);
  limit_ = std::move(start.limit);
  set_shear_at_start(start.bodies.pressure);
}

void SlidingInterface::set_shear_at_start(std::span<const double> pressure)
{
  const bool begins = std::all_of(before_.shear.begin(), before_.shear.end(), [](double q) { return q == 0.0; });
  for (std::size_t i = 0; i < pressure.size(); ++i)
  {
    const double size = begins ? std::min(friction().coefficient * pressure[i], limit_[i]) : std::abs(before_.shear[i]);
    shear_at_start_[i] = slides_ ? direction_ * size : 0.0;
  }
}

SlidingInterface::Change SlidingInterface::follow(const Bodies& bodies)
{
  return is_held_ ? Change{} : set_shear(bodies.pressure);
}

SlidingInterface::Change SlidingInterface::renew(const Bodies& bodies)
{
  return set_shear(bodies.pressure);
}

SlidingInterface::Change SlidingInterface::set_shear(std::span<const double> pressure)
{
  Change change;
  std::size_t pressed = 0, limited = 0;
  const double share = slides_ ? share_at_rest_.value_or(1.0) : 0.0;
  const double sense = share < 0.0 ? -direction_ : direction_;
  const double size = std::abs(share) * friction().coefficient;
  for (std::size_t i = 0; i < pressure.size(); ++i)
  {
    const double wanted = size * pressure[i];
    pressed += pressure[i] > 0.0 ? 1 : 0;
    limited += wanted > limit_[i] ? 1 : 0;
    const double shear = sense * std::min(wanted, limit_[i]);
    change.shear = larger(change.shear, std::abs(shear - state_.shear[i]));
    state_.shear[i] = shear;
  }
  state_.limited_share = pressed > 0 ? static_cast<double>(limited) / static_cast<double>(pressed) : 0.0;
  if (!surfaces_->changes_gap())
    return change;
  const std::vector<double> before = state_.depth;
  surfaces_->find_depth(state_.shear, state_.depth);
  for (std::size_t i = 0; i < before.size(); ++i)
    change.gap = larger(change.gap, std::abs(state_.depth[i] - before[i]));
  return change;
}

void SlidingInterface::add_to_gap(std::span<double> gap) const
{
  if (surfaces_->changes_gap())
    add_scaled(1.0, state_.depth, gap);
}

/// The work of the shear on its own stretch vanishes in sum, because the displacement along x is even in the distance from the
/// load, but it moves heat from the front of a contact to its rear.
void SlidingInterface::find_displacements(const Bodies& bodies)
{
  const SurfaceGrid& grid = surfaces_->grid();
  surfaces_->find_depth(state_.shear, state_.depth);
  surfaces_->find_lower_depth(state_.shear, state_.depth, state_.lower_depth);
  std::vector<double> lower(bodies.lower_x.begin(), bodies.lower_x.end());
  std::vector<double> upper(bodies.upper_x.begin(), bodies.upper_x.end());
  surfaces_->add_along(bodies.pressure, state_.shear, lower, upper);
  for (std::size_t i = 0; i < grid.size(); ++i)
    state_.slip[i] = lower[i] - upper[i];
  state_.lower_stretch = stretch(grid, state_.shear, lower);
  state_.upper_stretch = stretch(grid, state_.shear, upper);
}

/// Work of the shear on the displacement of the material under it: by the change within a cell of the contact grid, and because
/// the cell moves along the bodies. Both parts use the trapezoidal rule. Where surfaces begin to slide, or reverse, the shear
/// grows in proportion to the displacement that it causes, so that the rule uses the shear before the increment.
/// Increments at rest have no way of sliding to turn into heat: the elastic energy of their shear is taken from the
/// heat of the next one.
void SlidingInterface::settle(const Bodies& bodies)
{
  const SurfaceGrid& grid = surfaces_->grid();
  find_displacements(bodies);
  const double along_lower = bodies.lower_columns * grid.dx, along_upper = bodies.upper_columns * grid.dx;
  for (std::size_t i = 0; i < grid.size(); ++i)
  {
    const double in_cell = 0.5 * (before_.shear[i] + state_.shear[i]) * (state_.slip[i] - before_.slip[i]);
    const double on_lower = 0.5 * (before_.lower_stretch[i] + state_.lower_stretch[i]) * along_lower;
    const double on_upper = 0.5 * (before_.upper_stretch[i] + state_.upper_stretch[i]) * along_upper;
    work_per_area_[i] = in_cell - on_lower + on_upper;
  }
  state_.work = before_.work + sum(work_per_area_) * grid.cell_area();
  add_scaled(1.0, before_.work_at_rest, work_per_area_);
  if (share_at_rest_)
    state_.work_at_rest = work_per_area_;
  else
    std::fill(state_.work_at_rest.begin(), state_.work_at_rest.end(), 0.0);
}

std::vector<double> SlidingInterface::slip_length(double slid) const
{
  return std::vector<double>(state_.shear.size(), slid);
}

/// By the mean of the shear at the beginning and at the end of the increment: second order in the step.
std::vector<double> SlidingInterface::heat_of_trial(double slid) const
{
  std::vector<double> work(state_.shear.size());
  for (std::size_t i = 0; i < work.size(); ++i)
    work[i] = 0.5 * slid * (std::abs(shear_at_start_[i]) + std::abs(state_.shear[i]));
  return work;
}

std::vector<double> SlidingInterface::heat_of_increment(double slid) const
{
  std::vector<double> heat = heat_of_trial(slid);
  add_scaled(-1.0, work_per_area_, heat);
  return heat;
}

void SlidingInterface::add_depth(std::span<double> lower, std::span<double> upper) const
{
  add_scaled(1.0, state_.lower_depth, lower);
  add_scaled(1.0, state_.depth, upper);
  add_scaled(-1.0, state_.lower_depth, upper);
}

double SlidingInterface::elastic_energy(std::span<const double> pressure) const
{
  const SurfaceGrid& grid = surfaces_->grid();
  std::vector<double> along(state_.shear.size());
  surfaces_->pair().apply({.shear_x = state_.shear}, {.x = along});
  const double coupling = surfaces_->changes_gap() ? dot(pressure, state_.depth) : 0.0;
  return (coupling + 0.5 * dot(grid, state_.shear, along)) * grid.cell_area();
}

std::array<double, 2> SlidingInterface::forces() const
{
  return {sum(state_.shear) * surfaces_->grid().cell_area(), 0.0};
}

double SlidingInterface::force_at_start() const
{
  return sum(shear_at_start_) * surfaces_->grid().cell_area();
}

double SlidingInterface::share_of(const contact::TangentialDrive& along) const
{
  const auto acts = std::find_if(state_.shear.begin(), state_.shear.end(), [](double q) { return q != 0.0; });
  return acts == state_.shear.end() ? 0.0 : std::copysign(1.0, *acts) * direction(along)[0];
}

void SlidingInterface::embed(const Interface& smaller)
{
  const auto& other = dynamic_cast<const SlidingInterface&>(smaller);
  embed_state(other.surfaces_->grid(), other.state_, surfaces_->grid(), state_);
}

} // namespace brinell::elastoplastic
