// SPDX-License-Identifier: BSD-3-Clause
#include "tangential_cells.hpp"
#include "tangential_iteration.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

/// The steps of the iteration for stick and slip: where to go, how far, and what to do where the energy rises.
namespace brinell::contact
{

namespace
{

/// Weight of a cell that leaves its bound while it sticks: no step may do so.
constexpr double never = 1e100;

} // namespace

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
  return false;
}

/// The gradient of a quadratic function, over its largest curvature, followed by the nearest shears that are allowed.
void TangentialContact::Iteration::follow_gradient()
{
  slope_ = 0.0;
  const double step = 1.0 / compliance_.largest_of_shear();
  for_cells(cells(),
            [&](std::size_t i)
            {
              const Along slip = target_.at(i) + shift_ - kept_displacement_.at(i);
              shear_.set(i, kept_shear_.at(i) + step * slip);
            });
  bound_shears(true);
}

/// Each by itself, as if no other moved.
void TangentialContact::Iteration::move_worst()
{
  slope_ = 0.0;
  const auto wrong_part = [&](std::size_t i)
  {
    const Along q = kept_shear_.at(i);
    const Along slip = target_.at(i) + shift_ - kept_displacement_.at(i);
    const double square_of_q = square(q);
    const bool slips = is_bound(square_of_q, bound_[i]) && dot(slip, q) > 0.0;
    return slips ? slip - (dot(slip, q) / square_of_q) * q : slip;
  };
  const double largest = sum_of_cells(cells(), [&](std::size_t i) { return Largest{square(wrong_part(i))}; }).value;
  constexpr double near = 0.25; // half of the largest
  const double stiffness = compliance_.stiffness_of_cell();
  for_cells(cells(),
            [&](std::size_t i)
            {
              const Along wrong = wrong_part(i);
              shear_.set(i, kept_shear_.at(i) + (square(wrong) >= near * largest ? stiffness : 0.0) * wrong);
            });
  bound_shears(true);
}

} // namespace brinell::contact
