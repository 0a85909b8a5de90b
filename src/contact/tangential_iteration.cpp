// SPDX-License-Identifier: BSD-3-Clause
#include "tangential_iteration.hpp"

#include "carried_field.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::contact
{

namespace
{

/// work(cell) for all cells.
template <typename Work>
void for_cells(std::size_t cells, const Work& work)
{
  for_pieces(cells,
             [&](std::size_t first, std::size_t last)
             {
               for (std::size_t i = first; i < last; ++i)
                 work(i);
             });
}

/// Sum of part(cell).
template <typename Part>
auto sum_of_cells(std::size_t cells, const Part& part)
{
  return sum_of_pieces(cells,
                       [&](std::size_t first, std::size_t last)
                       {
                         decltype(part(first)) sum{};
                         for (std::size_t i = first; i < last; ++i)
                           sum += part(i);
                         return sum;
                       });
}

/// The part of a vector that a cell is free to move along: all of it, or the tangent of its disc.
Along free_part(Zone zone, const Along& shear, const Along& a)
{
  if (zone == Zone::none)
    return {};
  if (zone == Zone::stick)
    return a;
  const Along n = (1.0 / shear.size()) * shear;
  return a - dot(a, n) * n;
}

/// Stiffness that the bound gives to the tangent: slip along the shear over its size [m/Pa].
double stiffening(Zone zone, const Along& shear, const Along& slip)
{
  return zone == Zone::slip ? std::max(0.0, dot(slip, shear)) / dot(shear, shear) : 0.0;
}

/// Weight of a cell that leaves its bound while it sticks: no step may do so.
constexpr double never = 1e100;

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

/// The largest of values, under +=; a NaN stays.
struct Largest
{
  double value = 0.0;
  Largest& operator+=(const Largest& other)
  {
    value = larger(value, other.value);
    return *this;
  }
};

struct Errors
{
  Largest slip, displacement;
  Errors& operator+=(const Errors& other)
  {
    slip += other.slip;
    displacement += other.displacement;
    return *this;
  }
};

} // namespace

TangentialContact::Iteration::Iteration(const halfspace::TractionCompliance& compliance)
    : compliance_(compliance), scratch_(compliance.make_scratch()), bound_(compliance.grid().size()),
      zone_(bound_.size()), target_(cells()), shear_(cells()), displacement_(cells()), slip_(cells()),
      direction_(cells()), image_(cells()), gradient_(cells()), stiff_(cells()), kept_shear_(cells()),
      kept_displacement_(cells()), between_(std::sqrt(compliance.largest_of_shear() / compliance.stiffness_of_cell()))
{
}

void TangentialContact::Iteration::start(const TangentialStep& step, const AlongSurface& shear)
{
  using Kind = TangentialDrive::Kind;
  const SurfaceGrid& grid = compliance_.grid();
  const TangentialDrive& drive = step.drive;
  std::copy(step.bound.begin(), step.bound.end(), bound_.begin());
  forced_ = {drive.x.kind == Kind::force, drive.y.kind == Kind::force};
  sum_ = {drive.x.value / grid.cell_area(), drive.y.value / grid.cell_area()};
  imposed_ = {forced_.x ? 0.0 : drive.x.value, forced_.y ? 0.0 : drive.y.value};
  shift_ = {};
  for_cells(cells(), [&](std::size_t i) { target_.set(i, {}); });
  if (!step.before[0].empty() || !step.before[1].empty())
  {
    carry(grid, step.carried, step.before[0], kept_shear_.x);
    carry(grid, step.carried, step.before[1], kept_shear_.y);
    compliance_.apply({.shear_x = kept_shear_.x, .shear_y = kept_shear_.y}, {.x = target_.x, .y = target_.y}, scratch_);
  }
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
    {
      const std::size_t cell = grid.index(i, j);
      const Along change{step.change[0].empty() ? 0.0 : step.change[0][cell],
                         step.change[1].empty() ? 0.0 : step.change[1][cell]};
      const Along turned{-drive.spin * grid.y(j), drive.spin * grid.x(i)};
      target_.set(cell, target_.at(cell) + imposed_ + turned - change);
    }
  for_cells(cells(),
            [&](std::size_t i)
            {
              zone_[i] = bound_[i] > 0.0 ? Zone::stick : Zone::none;
              shear_.set(i, bounded({shear[0][i], shear[1][i]}, bound_[i]));
              direction_.set(i, {});
              gradient_.set(i, {});
            });
  bound_shears(true);
  displace();
  shift_ = shift_of_sticking();
  slope_ = 0.0;
}

/// The mean of what the cells within their bound ask for, so that the others can be told apart.
Along TangentialContact::Iteration::shift_of_sticking() const
{
  const auto asked = [&](std::size_t i)
  {
    const bool is_within = zone_[i] != Zone::none && shear_.at(i).size() < slip_threshold * bound_[i];
    return is_within ? Mean{displacement_.at(i) - target_.at(i), 1.0} : Mean{};
  };
  const Mean mean = sum_of_cells(cells(), asked);
  return mean.count > 0.0 ? forced_.part((1.0 / mean.count) * mean.sum) : Along{};
}

void TangentialContact::Iteration::displace()
{
  compliance_.apply({.shear_x = shear_.x, .shear_y = shear_.y}, {.x = displacement_.x, .y = displacement_.y}, scratch_);
}

/// Cuts shears at their bound; those of a force keep its sum.
/// @param of_slip  whether cells that slip take part
void TangentialContact::Iteration::bound_shears(bool of_slip)
{
  if (forced_.any() && (balance(forced_, sum_, of_slip, bound_, zone_, shear_.x, shear_.y) ||
                        // those that stick cannot carry it alone
                        (!of_slip && balance(forced_, sum_, true, bound_, zone_, shear_.x, shear_.y))))
    return;
  for_cells(cells(), [&](std::size_t i) { shear_.set(i, bounded(shear_.at(i), bound_[i])); });
}

/// Tells the cells that slip from those that do not, and improves the shift that a force finds, so that the slips that are left
/// where the cells are free cancel.
void TangentialContact::Iteration::classify()
{
  const auto of_cell = [&](std::size_t i)
  {
    Unbalanced here;
    if (zone_[i] == Zone::none)
      return here;
    const Along q = shear_.at(i);
    const Along slip = target_.at(i) + shift_ - displacement_.at(i);
    const bool slips = q.size() >= slip_threshold * bound_[i] && dot(slip, q) > 0.0;
    zone_[i] = slips ? Zone::slip : Zone::stick;
    here.slip = free_part(zone_[i], q, slip);
    here.free = {1.0, 1.0, 0.0};
    if (slips)
    {
      const Along n = (1.0 / q.size()) * q;
      here.free = {n.y * n.y, n.x * n.x, -n.x * n.y};
    }
    return here;
  };
  unbalanced_ = sum_of_cells(cells(), of_cell);
  const Along added = forced_.solution(unbalanced_.free, unbalanced_.slip);
  shift_ = shift_ - added;
}

void TangentialContact::Iteration::settle(TangentialReport& report)
{
  classify();
  const auto error = [&](std::size_t i)
  {
    const Along slip = target_.at(i) + shift_ - displacement_.at(i);
    slip_.set(i, zone_[i] == Zone::none ? Along{} : slip);
    if (zone_[i] == Zone::none)
      return Errors{};
    const Along q = shear_.at(i);
    const double along = q.size() >= slip_threshold * bound_[i] ? std::max(0.0, dot(slip, q)) / dot(q, q) : 0.0;
    return Errors{{(slip - along * q).size()}, {displacement_.at(i).size()}};
  };
  const Errors errors = sum_of_cells(cells(), error);
  report.slip_error = errors.slip.value;
  largest_displacement_ = errors.displacement.value;
  const Along shift = imposed_ + shift_;
  report.shift = {shift.x, shift.y};
}

void TangentialContact::Iteration::keep()
{
  for_cells(cells(),
            [&](std::size_t i)
            {
              kept_shear_.set(i, shear_.at(i));
              kept_displacement_.set(i, displacement_.at(i));
            });
}

bool TangentialContact::Iteration::has_descended() const
{
  // The change of the energy is minus the work of the change of the shears on the mean slip: of small numbers alone.
  const auto of_cell = [&](std::size_t i)
  {
    const Along added = shear_.at(i) - kept_shear_.at(i);
    const Along u = 0.5 * (displacement_.at(i) + kept_displacement_.at(i));
    const Along asked = target_.at(i) + shift_;
    return Along{dot(added, asked - u), added.size() * (asked.size() + u.size())};
  };
  const Along work = sum_of_cells(cells(), of_cell); // and the sum of the sizes of what cancels
  constexpr double rounding = 1e-14;
  return work.x >= -rounding * work.y;
}

/// The free part of a field, weighed for one of the two parts of the preconditioner.
void TangentialContact::Iteration::weigh(const AlongField& of, bool stiff, AlongField& weighed) const
{
  const double cell = compliance_.stiffness_of_cell();
  const auto weight = [&](std::size_t i)
  {
    const double added = stiffening(zone_[i], shear_.at(i), slip_.at(i));
    const double share = 1.0 / (1.0 + cell * added);
    return std::sqrt(stiff ? (1.0 - share) * between_ / (between_ + added) : share);
  };
  for_cells(cells(), [&](std::size_t i) { weighed.set(i, weight(i) * free_part(zone_[i], shear_.at(i), of.at(i))); });
}

/// Shears that would about take the slip away, where the cells are free: docs/theory/contact.md (stick-slip).
void TangentialContact::Iteration::want()
{
  const bool slips = std::find(zone_.begin(), zone_.end(), Zone::slip) != zone_.end();
  if (slips)
  {
    weigh(slip_, true, stiff_);
    compliance_.apply_inverse({stiff_.x, stiff_.y}, {stiff_.x, stiff_.y}, scratch_, between_);
    weigh(stiff_, true, stiff_);
  }
  weigh(slip_, false, image_);
  compliance_.apply_inverse({image_.x, image_.y}, {image_.x, image_.y}, scratch_);
  weigh(image_, false, image_);
  if (slips)
    for_cells(cells(), [&](std::size_t i) { image_.set(i, image_.at(i) + stiff_.at(i)); });
}

/// The next direction of what is wanted and `beta` times the last one, without what would change a force.
void TangentialContact::Iteration::combine(double beta)
{
  const auto combined = [&](std::size_t i)
  { return free_part(zone_[i], shear_.at(i), image_.at(i) + beta * direction_.at(i)); };
  const Along uniform = forced_.any() ? forced_.solution(unbalanced_.free, sum_of_cells(cells(), combined)) : Along{};
  for_cells(cells(),
            [&](std::size_t i) { direction_.set(i, combined(i) - free_part(zone_[i], shear_.at(i), uniform)); });
}

double TangentialContact::Iteration::aim()
{
  want();
  const auto slopes_of_cell = [&](std::size_t i)
  {
    const Along now = free_part(zone_[i], shear_.at(i), slip_.at(i));
    const Along slopes{dot(now, image_.at(i)), dot(gradient_.at(i), image_.at(i))};
    gradient_.set(i, now);
    return slopes;
  };
  const Along slopes = sum_of_cells(cells(), slopes_of_cell); // with the slip now, and with that before
  const double beta = slope_ > 0.0 ? std::max(0.0, (slopes.x - slopes.y) / slope_) : 0.0; // Polak, Ribiere 1969
  slope_ = slopes.x;
  const auto descent = [&]
  { return sum_of_cells(cells(), [&](std::size_t i) { return dot(gradient_.at(i), direction_.at(i)); }); };
  combine(beta);
  double along = descent();
  if (beta > 0.0 && !(along > 0.0)) // other cells slip now: the directions begin anew
  {
    combine(0.0);
    along = descent();
  }
  compliance_.apply({.shear_x = direction_.x, .shear_y = direction_.y}, {.x = image_.x, .y = image_.y}, scratch_);
  const auto curvature_of_cell = [&](std::size_t i)
  {
    const Along d = direction_.at(i);
    return dot(d, image_.at(i)) + stiffening(zone_[i], shear_.at(i), slip_.at(i)) * dot(d, d);
  };
  const double curvature = sum_of_cells(cells(), curvature_of_cell);
  return curvature > 0.0 ? along / curvature : 0.0;
}

bool TangentialContact::Iteration::advance(double step, double allowed)
{
  const auto move = [&](std::size_t i)
  {
    displacement_.set(i, displacement_.at(i) + step * image_.at(i));
    if (zone_[i] == Zone::none)
      return Largest{};
    const Along moved = shear_.at(i) + step * direction_.at(i);
    shear_.set(i, moved);
    return Largest{(moved.size() / bound_[i] - 1.0) * (zone_[i] == Zone::slip ? 1.0 : never)};
  };
  return sum_of_cells(cells(), move).value <= allowed;
}

void TangentialContact::Iteration::restore_bounds()
{
  for_cells(cells(),
            [&](std::size_t i)
            {
              if (zone_[i] == Zone::slip)
                shear_.set(i, (bound_[i] / shear_.at(i).size()) * shear_.at(i));
            });
  bound_shears(false);
}

bool TangentialContact::Iteration::retreat()
{
  slope_ = 0.0;
  // All shears between those kept and those now are allowed, and their displacements known.
  const auto of_cell = [&](std::size_t i)
  {
    const Along added = shear_.at(i) - kept_shear_.at(i);
    return Along{dot(added, target_.at(i) + shift_ - kept_displacement_.at(i)),
                 dot(added, displacement_.at(i) - kept_displacement_.at(i))};
  };
  const Along work = sum_of_cells(cells(), of_cell); // of what was added, on the slip and on its own displacement
  if (work.x > 0.0 && work.y > work.x)
  {
    const double share = work.x / work.y;
    const auto between = [&](AlongField& now, const AlongField& kept, std::size_t i)
    { now.set(i, share * now.at(i) + (1.0 - share) * kept.at(i)); };
    for_cells(cells(),
              [&](std::size_t i)
              {
                between(shear_, kept_shear_, i);
                between(displacement_, kept_displacement_, i);
              });
    return true;
  }
  // The gradient of a quadratic function, over its largest curvature, followed by the nearest shears that are allowed.
  const double step = 1.0 / compliance_.largest_of_shear();
  for_cells(cells(),
            [&](std::size_t i)
            {
              const Along slip = target_.at(i) + shift_ - kept_displacement_.at(i);
              shear_.set(i, zone_[i] == Zone::none ? Along{} : kept_shear_.at(i) + step * slip);
            });
  bound_shears(true);
  return false;
}

void TangentialContact::Iteration::finish(TangentialReport& report, const AlongSurface& shear,
                                          const AlongSurface& slip) const
{
  const double area = compliance_.grid().cell_area();
  const auto work_of_cell = [&](std::size_t i)
  {
    shear[0][i] = shear_.x[i];
    shear[1][i] = shear_.y[i];
    slip[0][i] = slip_.x[i];
    slip[1][i] = slip_.y[i];
    return dot(shear_.at(i), slip_.at(i));
  };
  report.dissipated = area * sum_of_cells(cells(), work_of_cell);
  const Along force = area * sum_of_cells(cells(), [&](std::size_t i) { return shear_.at(i); });
  report.force = {force.x, force.y};
}

} // namespace brinell::contact
