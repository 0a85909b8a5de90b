// SPDX-License-Identifier: BSD-3-Clause
#include "tangential_cells.hpp"
#include "tangential_iteration.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

/// Steps of the iteration for stick and slip: search direction, step length, and recovery if the energy has increased.
namespace brinell::contact
{

namespace
{

/// Weight of a sticking cell that exceeds its bound: so large that no such step is accepted.
constexpr double never = 1e100;

} // namespace

/// Weights of the cells in both parts of the preconditioner.
void TangentialContact::Iteration::find_preconditioner_weights()
{
  const double cell = compliance_.stiffness_of_cell();
  for_cells(cells(),
            [&](std::size_t i)
            {
              const double own = bound_compliance_[i] + own_.mean(i);
              const double share = 1.0 / (1.0 + cell * own);
              soft_[i] = std::sqrt(share);
              stiff_[i] = std::sqrt((1.0 - share) * mean_compliance_ / (mean_compliance_ + own));
            });
}

/// Applies the preconditioner to the slip: shears in the free directions that approximately cancel it, written to `image_`:
/// docs/theory/contact.md (stick-slip).
void TangentialContact::Iteration::precondition()
{
  const auto invert = [&](const std::vector<double>& weight, double added, const auto& use)
  {
    scatter([&](std::size_t i) { return weight[i] * free_part(i, slip_.at(i)); });
    compliance_.apply_inverse({grid_field_.x, grid_field_.y}, {grid_field_.x, grid_field_.y}, scratch_, added);
    gather([&](std::size_t i, const Along& q) { use(i, weight[i] * free_part(i, q)); });
  };
  find_preconditioner_weights();
  invert(soft_, 0.0, [&](std::size_t i, const Along& q) { image_.set(i, q); });
  if (slips_)
    invert(stiff_, mean_compliance_, [&](std::size_t i, const Along& q) { image_.set(i, image_.at(i) + q); });
}

/// The next direction: preconditioned slip plus `beta` times the last direction, minus the part that would change an imposed
/// force.
void TangentialContact::Iteration::combine(double beta)
{
  const auto combined = [&](std::size_t i) { return free_part(i, image_.at(i) + beta * direction_.at(i)); };
  const Along uniform = forced_.any() ? forced_.solution(unbalanced_.free, sum_of_cells(cells(), combined)) : Along{};
  for_cells(cells(), [&](std::size_t i) { direction_.set(i, combined(i) - free_part(i, uniform)); });
}

double TangentialContact::Iteration::find_direction()
{
  precondition();
  const auto slopes_of_cell = [&](std::size_t i)
  {
    const Along now = free_part(i, slip_.at(i));
    const Along slopes{dot(now, image_.at(i)), dot(gradient_.at(i), image_.at(i))};
    gradient_.set(i, now);
    return slopes;
  };
  const Along slopes = sum_of_cells(cells(), slopes_of_cell); // x: with the current slip; y: with the previous slip
  const double beta = slope_ > 0.0 ? std::max(0.0, (slopes.x - slopes.y) / slope_) : 0.0; // Polak, Ribiere 1969
  slope_ = slopes.x;
  const auto descent = [&]
  { return sum_of_cells(cells(), [&](std::size_t i) { return dot(gradient_.at(i), direction_.at(i)); }); };
  combine(beta);
  double along = descent();
  if (beta > 0.0 && !(along > 0.0)) // the set of slipping cells has changed: restart with the preconditioned slip
  {
    combine(0.0);
    along = descent();
  }
  scatter([&](std::size_t i) { return direction_.at(i); });
  multiply();
  gather([&](std::size_t i, const Along& u) { image_.set(i, u + own_.displacement(i, direction_.at(i))); });
  const auto curvature_of_cell = [&](std::size_t i)
  {
    const Along d = direction_.at(i);
    return dot(d, image_.at(i)) + bound_compliance_[i] * dot(d, d);
  };
  const double curvature = sum_of_cells(cells(), curvature_of_cell);
  return curvature > 0.0 ? along / curvature : 0.0;
}

/// Fraction by which shears of slipping cells may exceed their bound, such that the displacement by the excess is at most a tenth
/// of the slip error. Of all shears below a given bound on a given area, those on a disc displace its centre most.
double TangentialContact::Iteration::excess_allowed(double error) const
{
  const double area = static_cast<double>(cells()) * grid().cell_area();
  const double all = static_cast<double>(grid().size()) * grid().cell_area();
  const double share =
      std::min(1.0, 2.0 * std::sqrt(area / (std::numbers::pi * all))); // of the response to the longest wave
  return 0.1 * error / (largest_bound_ * compliance_.largest_of_shear() * share + own_.largest_displacement());
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
  // All shears on the straight line between the saved and the current ones are admissible, and their displacements are known.
  const auto of_cell = [&](std::size_t i)
  {
    const Along added = shear_.at(i) - saved_shear_.at(i);
    return Along{dot(added, target_.at(i) + shift_ - saved_displacement_.at(i)),
                 dot(added, displacement_.at(i) - saved_displacement_.at(i))};
  };
  // Work of the added shears: x: on the slip; y: on their own displacement.
  const Along work = sum_of_cells(cells(), of_cell);
  if (work.x > 0.0 && work.y > work.x)
  {
    const double share = work.x / work.y;
    const auto between = [&](const Along& now, const Along& kept) { return share * now + (1.0 - share) * kept; };
    const auto move = [&](std::size_t i)
    {
      const Along now = shear_.at(i), kept = saved_shear_.at(i), q = between(now, kept);
      const double square_of_bound = bound_[i] * bound_[i];
      // Between two neighbouring points of the edge of a disc, the shear still counts as being at its bound.
      constexpr double near = 0.99;
      const bool turns = is_bound(square(now), bound_[i]) && dot(now, kept) > near * square_of_bound;
      shear_.set(i, q);
      displacement_.set(i, between(displacement_.at(i), saved_displacement_.at(i)));
      return Largest{turns ? 1.0 - square(q) / square_of_bound : 0.0};
    };
    threshold_ = std::min(threshold_, 1.0 - sum_of_cells(cells(), move).value);
    return true;
  }
  return false;
}

/// A step of projected gradients: the slip divided by the largest curvature, then projection on the admissible shears.
void TangentialContact::Iteration::follow_gradient()
{
  slope_ = 0.0;
  const double step = 1.0 / (compliance_.largest_of_shear() + own_.largest());
  for_cells(cells(),
            [&](std::size_t i)
            {
              const Along slip = target_.at(i) + shift_ - saved_displacement_.at(i);
              shear_.set(i, saved_shear_.at(i) + step * slip);
            });
  bound_shears(true);
}

/// Each cell is moved independently, by its own stiffness.
void TangentialContact::Iteration::move_worst()
{
  slope_ = 0.0;
  const auto wrong_part = [&](std::size_t i)
  {
    const Along q = saved_shear_.at(i);
    const Along slip = target_.at(i) + shift_ - saved_displacement_.at(i);
    const double square_of_q = square(q);
    const bool slips = is_bound(square_of_q, bound_[i]) && dot(slip, q) > 0.0;
    return slips ? slip - (dot(slip, q) / square_of_q) * q : slip;
  };
  const double largest = sum_of_cells(cells(), [&](std::size_t i) { return Largest{square(wrong_part(i))}; }).value;
  constexpr double near = 0.25; // square of one half: errors from half of the largest one on
  const double stiffness = compliance_.stiffness_of_cell();
  for_cells(cells(),
            [&](std::size_t i)
            {
              const Along wrong = wrong_part(i);
              const double own = stiffness / (1.0 + stiffness * own_.mean(i));
              shear_.set(i, saved_shear_.at(i) + (square(wrong) >= near * largest ? own : 0.0) * wrong);
            });
  bound_shears(true);
}

} // namespace brinell::contact
