// SPDX-License-Identifier: BSD-3-Clause
#include "tangential_iteration.hpp"

#include "carried_field.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

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
#pragma omp simd
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

[[nodiscard]] double square(const Along& a)
{
  return dot(a, a);
}

/// Whether a shear is as large as its bound.
/// @param threshold  share of the bound from which on it counts as such
bool is_bound(double square_of_shear, double bound, double threshold = slip_threshold)
{
  return square_of_shear >= threshold * threshold * bound * bound;
}

} // namespace

TangentialContact::Iteration::Iteration(const halfspace::TractionCompliance& compliance)
    : compliance_(compliance), scratch_(compliance.make_scratch()), all_(compliance.grid().size()),
      before_(compliance.grid().size()),
      between_(std::sqrt(compliance.largest_of_shear() / compliance.stiffness_of_cell()))
{
}

/// One value for each of the cells.
void TangentialContact::Iteration::resize()
{
  for (AlongField* field : {&target_, &shear_, &displacement_, &slip_, &normal_, &direction_, &image_, &gradient_,
                            &kept_shear_, &kept_displacement_})
    field->resize(cells());
  for (std::vector<double>* field : {&bound_, &added_, &soft_, &stiff_})
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
  products_ = 0;
  restart({shear[0], shear[1]});
}

void TangentialContact::Iteration::read_targets(const TangentialStep& step)
{
  const auto columns = static_cast<std::size_t>(grid().nx);
  const double spin = step.drive.spin;
  for (std::size_t i = 0; i < cells(); ++i)
  {
    const std::size_t cell = cells_[i];
    const Along change{step.change[0].empty() ? 0.0 : step.change[0][cell],
                       step.change[1].empty() ? 0.0 : step.change[1][cell]};
    const Along turned{-spin * grid().y(static_cast<int>(cell / columns)),
                       spin * grid().x(static_cast<int>(cell % columns))};
    target_.set(i, imposed_ + turned - change);
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

/// The mean of what the cells within their bound ask for, so that the others can be told apart.
Along TangentialContact::Iteration::shift_of_sticking() const
{
  const auto asked = [&](std::size_t i)
  {
    const bool is_within = !is_bound(square(shear_.at(i)), bound_[i]);
    return is_within ? Mean{displacement_.at(i) - target_.at(i), 1.0} : Mean{};
  };
  const Mean mean = sum_of_cells(cells(), asked);
  return mean.count > 0.0 ? forced_.part((1.0 / mean.count) * mean.sum) : Along{};
}

/// Lays values of the cells on the grid, with nothing in the others.
template <typename Value>
void TangentialContact::Iteration::lay_out(const Value& value)
{
  all_.clear();
  for (std::size_t i = 0; i < cells(); ++i)
    all_.set(cells_[i], value(i));
}

/// Takes values of the cells from the grid.
template <typename Use>
void TangentialContact::Iteration::take_in(const Use& use)
{
  for (std::size_t i = 0; i < cells(); ++i)
    use(i, all_.at(cells_[i]));
}

void TangentialContact::Iteration::displace()
{
  lay_out([&](std::size_t i) { return shear_.at(i); });
  bool is_zero = true;
  for (const auto& [of_axis, before] : {std::pair{&all_.x, &before_.x}, {&all_.y, &before_.y}})
    for (std::size_t cell = 0; cell < of_axis->size(); ++cell)
    {
      (*of_axis)[cell] -= has_before_ ? (*before)[cell] : 0.0;
      is_zero = is_zero && (*of_axis)[cell] == 0.0;
    }
  if (!is_zero)
    multiply();
  take_in([&](std::size_t i, const Along& u) { displacement_.set(i, u); });
}

/// What is laid out, by the compliance.
void TangentialContact::Iteration::multiply()
{
  compliance_.apply({.shear_x = all_.x, .shear_y = all_.y}, {.x = all_.x, .y = all_.y}, scratch_);
  ++products_;
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

void TangentialContact::Iteration::settle(TangentialReport& report)
{
  classify();
  const auto error = [&](std::size_t i)
  {
    const Along q = shear_.at(i);
    const Along slip = target_.at(i) + shift_ - displacement_.at(i);
    const double square_of_q = square(q);
    const double along = is_bound(square_of_q, bound_[i], threshold_) ? std::max(0.0, dot(slip, q)) / square_of_q : 0.0;
    slip_.set(i, slip);
    added_[i] = zone_[i] == Zone::slip ? along : 0.0;
    return Largest{square(slip - along * q)};
  };
  report.slip_error = std::sqrt(sum_of_cells(cells(), error).value);
  const Along shift = imposed_ + shift_;
  report.shift = {shift.x, shift.y};
}

void TangentialContact::Iteration::keep()
{
  kept_shear_ = shear_;
  kept_displacement_ = displacement_;
}

void TangentialContact::Iteration::take_back()
{
  shear_ = kept_shear_;
  displacement_ = kept_displacement_;
  slope_ = 0.0;
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

/// Of the cells in both parts of the preconditioner.
void TangentialContact::Iteration::weigh_zones()
{
  const double cell = compliance_.stiffness_of_cell();
  for_cells(cells(),
            [&](std::size_t i)
            {
              const double share = 1.0 / (1.0 + cell * added_[i]);
              soft_[i] = std::sqrt(share);
              stiff_[i] = std::sqrt((1.0 - share) * between_ / (between_ + added_[i]));
            });
}

/// Shears that would about take the slip away, where the cells are free: docs/theory/contact.md (stick-slip).
void TangentialContact::Iteration::want()
{
  const auto invert = [&](const std::vector<double>& weight, double added, const auto& use)
  {
    lay_out([&](std::size_t i) { return weight[i] * free_part(i, slip_.at(i)); });
    compliance_.apply_inverse({all_.x, all_.y}, {all_.x, all_.y}, scratch_, added);
    take_in([&](std::size_t i, const Along& q) { use(i, weight[i] * free_part(i, q)); });
  };
  weigh_zones();
  invert(soft_, 0.0, [&](std::size_t i, const Along& q) { image_.set(i, q); });
  if (slips_)
    invert(stiff_, between_, [&](std::size_t i, const Along& q) { image_.set(i, image_.at(i) + q); });
}

/// The next direction of what is wanted and `beta` times the last one, without what would change a force.
void TangentialContact::Iteration::combine(double beta)
{
  const auto combined = [&](std::size_t i) { return free_part(i, image_.at(i) + beta * direction_.at(i)); };
  const Along uniform = forced_.any() ? forced_.solution(unbalanced_.free, sum_of_cells(cells(), combined)) : Along{};
  for_cells(cells(), [&](std::size_t i) { direction_.set(i, combined(i) - free_part(i, uniform)); });
}

double TangentialContact::Iteration::aim()
{
  want();
  const auto slopes_of_cell = [&](std::size_t i)
  {
    const Along now = free_part(i, slip_.at(i));
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
  lay_out([&](std::size_t i) { return direction_.at(i); });
  multiply();
  take_in([&](std::size_t i, const Along& u) { image_.set(i, u); });
  const auto curvature_of_cell = [&](std::size_t i)
  {
    const Along d = direction_.at(i);
    return dot(d, image_.at(i)) + added_[i] * dot(d, d);
  };
  const double curvature = sum_of_cells(cells(), curvature_of_cell);
  return curvature > 0.0 ? along / curvature : 0.0;
}

/// By which share the shears where the surfaces slip may exceed their bound, so that they displace by no more than a tenth of the
/// error. No shears below a bound on a given area displace a point by more than those on a disc around it.
double TangentialContact::Iteration::excess_allowed(double error) const
{
  const double area = static_cast<double>(cells()) * grid().cell_area();
  const double all = static_cast<double>(grid().size()) * grid().cell_area();
  const double share =
      std::min(1.0, 2.0 * std::sqrt(area / (std::numbers::pi * all))); // of the response to the longest wave
  return 0.1 * error / (largest_bound_ * compliance_.largest_of_shear() * share);
}

bool TangentialContact::Iteration::advance(double step, double error)
{
  const auto move = [&](std::size_t i)
  {
    displacement_.set(i, displacement_.at(i) + step * image_.at(i));
    const Along moved = shear_.at(i) + step * direction_.at(i);
    shear_.set(i, moved);
    return Largest{(square(moved) / (bound_[i] * bound_[i]) - 1.0) * (zone_[i] == Zone::slip ? 0.5 : never)};
  };
  const double allowed = excess_allowed(error);
  threshold_ = std::min(slip_threshold, 1.0 - allowed); // until the bounds are restored
  return sum_of_cells(cells(), move).value <= allowed;
}

void TangentialContact::Iteration::restore_bounds()
{
  for_cells(cells(),
            [&](std::size_t i)
            {
              const Along q = shear_.at(i);
              const double factor = zone_[i] == Zone::slip ? bound_[i] / q.size() : 1.0;
              shear_.set(i, factor * q);
            });
  bound_shears(false);
  threshold_ = slip_threshold;
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
    const auto between = [&](const Along& now, const Along& kept) { return share * now + (1.0 - share) * kept; };
    const auto move = [&](std::size_t i)
    {
      const Along now = shear_.at(i), kept = kept_shear_.at(i), q = between(now, kept);
      const double square_of_bound = bound_[i] * bound_[i];
      // Between two points of a disc's edge that are near each other the shear still counts as bound.
      constexpr double near = 0.99;
      const bool turns = is_bound(square(now), bound_[i]) && dot(now, kept) > near * square_of_bound;
      shear_.set(i, q);
      displacement_.set(i, between(displacement_.at(i), kept_displacement_.at(i)));
      return Largest{turns ? 1.0 - square(q) / square_of_bound : 0.0};
    };
    threshold_ = std::min(threshold_, 1.0 - sum_of_cells(cells(), move).value);
    return true;
  }
  // The gradient of a quadratic function, over its largest curvature, followed by the nearest shears that are allowed.
  const double step = 1.0 / compliance_.largest_of_shear();
  for_cells(cells(),
            [&](std::size_t i)
            {
              const Along slip = target_.at(i) + shift_ - kept_displacement_.at(i);
              shear_.set(i, kept_shear_.at(i) + step * slip);
            });
  bound_shears(true);
  return false;
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
