// SPDX-License-Identifier: BSD-3-Clause
#include "tangential_iteration.hpp"

#include "carried_field.hpp"
#include "tangential_cells.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace brinell::contact
{

namespace
{

struct Mean
{
  Along sum;
  double count = 0.0;
  Mean& operator+=(const Mean& other)
  {
    sum += other.sum;
    count += other.count;
    return *this;
  }
};

} // namespace

TangentialContact::Iteration::Iteration(const halfspace::SurfaceCompliance& compliance)
    : compliance_(compliance), scratch_(compliance.make_scratch()), grid_field_(compliance.grid().size()),
      before_(compliance.grid().size()),
      mean_compliance_(std::sqrt(compliance.largest_of_shear() / compliance.stiffness_of_cell()))
{
}

/// Resizes all fields to the number of cells that can carry shear.
void TangentialContact::Iteration::resize()
{
  for (AlongField* field : {&target_, &shear_, &displacement_, &slip_, &normal_, &direction_, &image_, &gradient_,
                            &saved_shear_, &saved_displacement_})
    field->resize(cells());
  for (std::vector<double>* field : {&bound_, &bound_compliance_, &soft_, &stiff_})
    field->resize(cells());
  zone_.resize(cells());
}

void TangentialContact::Iteration::start(const TangentialStep& step, const AlongSurface& shear)
{
  using Kind = TangentialDrive::Kind;
  const TangentialDrive& drive = step.drive;
  cells_.clear();
  for (std::size_t cell = 0; cell < step.bound.size(); ++cell)
    if (step.bound[cell] > 0.0)
      cells_.push_back(cell);
  resize();
  for (std::size_t i = 0; i < cells(); ++i)
    bound_[i] = step.bound[cells_[i]];
  largest_bound_ = bound_.empty() ? 0.0 : *std::max_element(bound_.begin(), bound_.end());
  forced_ = {drive.x.kind == Kind::force, drive.y.kind == Kind::force};
  sum_ = {drive.x.value / grid().cell_area(), drive.y.value / grid().cell_area()};
  imposed_ = {forced_.x ? 0.0 : drive.x.value, forced_.y ? 0.0 : drive.y.value};
  has_before_ = !step.before[0].empty() || !step.before[1].empty();
  if (has_before_)
  {
    carry(grid(), step.carried, step.before[0], before_.x);
    carry(grid(), step.carried, step.before[1], before_.y);
  }
  read_targets(step);
  own_.read(step, cells_, bound_);
  products_ = 0;
  restart({shear[0], shear[1]});
}

void TangentialContact::Iteration::read_targets(const TangentialStep& step)
{
  const auto columns = static_cast<std::size_t>(grid().nx);
  for (std::size_t i = 0; i < cells(); ++i)
  {
    const std::size_t cell = cells_[i];
    const Along change{step.change[0].empty() ? 0.0 : step.change[0][cell],
                       step.change[1].empty() ? 0.0 : step.change[1][cell]};
    const Along by_spin = turned(grid(), step.carried, step.drive.spin, static_cast<int>(cell % columns),
                                 static_cast<int>(cell / columns));
    target_.set(i, imposed_ + by_spin - change);
  }
}

void TangentialContact::Iteration::restart(const ConstAlongSurface& shear)
{
  for (std::size_t i = 0; i < cells(); ++i)
  {
    const Along guess = bounded({shear[0][cells_[i]], shear[1][cells_[i]]}, bound_[i]);
    zone_[i] = is_bound(square(guess), bound_[i]) ? Zone::slip : Zone::stick;
    shear_.set(i, guess);
    direction_.set(i, {});
    gradient_.set(i, {});
  }
  bound_shears(false);
  displace();
  shift_ = {};
  shift_ = shift_of_sticking();
  slope_ = 0.0;
  threshold_ = slip_threshold;
}

/// Initial estimate of the shift: the mean over the cells within their bound of the shift for zero slip. With it, cells that slip
/// can be identified.
Along TangentialContact::Iteration::shift_of_sticking() const
{
  const auto required = [&](std::size_t i)
  {
    const bool is_within = !is_bound(square(shear_.at(i)), bound_[i]);
    return is_within ? Mean{displacement_.at(i) - target_.at(i), 1.0} : Mean{};
  };
  const Mean mean = sum_of_cells(cells(), required);
  return mean.count > 0.0 ? forced_.part((1.0 / mean.count) * mean.sum) : Along{};
}

void TangentialContact::Iteration::displace()
{
  scatter([&](std::size_t i) { return shear_.at(i); });
  bool is_zero = true;
  for (const auto& [of_axis, before] : {std::pair{&grid_field_.x, &before_.x}, {&grid_field_.y, &before_.y}})
    for (std::size_t cell = 0; cell < of_axis->size(); ++cell)
    {
      (*of_axis)[cell] -= has_before_ ? (*before)[cell] : 0.0;
      is_zero = is_zero && (*of_axis)[cell] == 0.0;
    }
  if (!is_zero)
    multiply();
  gather([&](std::size_t i, const Along& u) { displacement_.set(i, u + own_.displacement(i, shear_.at(i))); });
}

/// Multiplies `grid_field_` by the compliance.
void TangentialContact::Iteration::multiply()
{
  compliance_.apply({.shear_x = grid_field_.x, .shear_y = grid_field_.y}, {.x = grid_field_.x, .y = grid_field_.y},
                    scratch_);
  ++products_;
}

/// Projects the shears on their bounds; in directions with an imposed force, their sum is conserved.
/// @param of_slip  whether slipping cells may change to conserve the sum
void TangentialContact::Iteration::bound_shears(bool of_slip)
{
  if (forced_.any() && (balance(forced_, sum_, of_slip, bound_, zone_, shear_.x, shear_.y) ||
                        // the sticking cells cannot carry the force alone
                        (!of_slip && balance(forced_, sum_, true, bound_, zone_, shear_.x, shear_.y))))
    return;
  for_cells(cells(), [&](std::size_t i) { shear_.set(i, bounded(shear_.at(i), bound_[i])); });
}

/// Assigns each cell to stick or slip, and updates the part of the shift that an imposed force determines, so that the sum of the
/// slip in the free directions of the cells vanishes.
void TangentialContact::Iteration::classify()
{
  const auto of_cell = [&](std::size_t i)
  {
    const Along q = shear_.at(i);
    const Along slip = target_.at(i) + shift_ - displacement_.at(i);
    const double square_of_q = square(q);
    const bool slips = is_bound(square_of_q, bound_[i], threshold_) && dot(slip, q) > 0.0;
    const Along n = slips ? (1.0 / std::sqrt(square_of_q)) * q : Along{};
    zone_[i] = slips ? Zone::slip : Zone::stick;
    normal_.set(i, n);
    return Unbalanced{free_part(i, slip), {1.0 - n.x * n.x, 1.0 - n.y * n.y, -n.x * n.y}};
  };
  unbalanced_ = sum_of_cells(cells(), of_cell);
  slips_ = std::find(zone_.begin(), zone_.end(), Zone::slip) != zone_.end();
  shift_ = shift_ - forced_.solution(unbalanced_.free, unbalanced_.slip);
}

void TangentialContact::Iteration::evaluate(TangentialReport& report)
{
  classify();
  const auto error = [&](std::size_t i)
  {
    const Along q = shear_.at(i);
    const Along slip = target_.at(i) + shift_ - displacement_.at(i);
    const double square_of_q = square(q);
    const double along = is_bound(square_of_q, bound_[i], threshold_) ? std::max(0.0, dot(slip, q)) / square_of_q : 0.0;
    slip_.set(i, slip);
    bound_compliance_[i] = zone_[i] == Zone::slip ? along : 0.0;
    return Largest{square(slip - along * q)};
  };
  report.slip_error = std::sqrt(sum_of_cells(cells(), error).value);
  const Along shift = imposed_ + shift_;
  report.shift = {shift.x, shift.y};
}

void TangentialContact::Iteration::save()
{
  saved_shear_ = shear_;
  saved_displacement_ = displacement_;
}

void TangentialContact::Iteration::restore_saved()
{
  shear_ = saved_shear_;
  displacement_ = saved_displacement_;
  slope_ = 0.0;
}

bool TangentialContact::Iteration::has_descended() const
{
  // The change of the energy is minus the work of the change of the shears on the mean slip, which avoids the cancellation in a
  // difference of two energies.
  const auto of_cell = [&](std::size_t i)
  {
    const Along added = shear_.at(i) - saved_shear_.at(i);
    const Along u = 0.5 * (displacement_.at(i) + saved_displacement_.at(i));
    const Along required = target_.at(i) + shift_;
    return Along{dot(added, required - u), added.size() * (required.size() + u.size())};
  };
  const Along work = sum_of_cells(cells(), of_cell); // x: the work; y: a bound of its terms, for the rounding error
  constexpr double rounding = 1e-14;
  return work.x >= -rounding * work.y;
}

void TangentialContact::Iteration::finish(TangentialReport& report, const AlongSurface& shear,
                                          const AlongSurface& slip) const
{
  for (const AlongSurface* fields : {&shear, &slip})
    for (const std::span<double>& field : *fields)
      std::fill(field.begin(), field.end(), 0.0);
  Along force;
  double work = 0.0;
  for (std::size_t i = 0; i < cells(); ++i)
  {
    shear[0][cells_[i]] = shear_.x[i];
    shear[1][cells_[i]] = shear_.y[i];
    slip[0][cells_[i]] = slip_.x[i];
    slip[1][cells_[i]] = slip_.y[i];
    force += shear_.at(i);
    work += dot(shear_.at(i), slip_.at(i));
  }
  const double area = grid().cell_area();
  report.dissipated = area * work;
  report.force = {area * force.x, area * force.y};
  report.products = products_;
}

} // namespace brinell::contact
