// SPDX-License-Identifier: BSD-3-Clause
#include "heat_quadrature.hpp"

#include "foundation/gauss.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::halfspace
{

namespace
{

/// Adds the integral over u = sqrt(t) from `first` to `last`, where dt/sqrt(t) = 2 du.
void add_piece(double first, double last, std::vector<PastTime>& times)
{
  const double middle = 0.5 * (first + last), half = 0.5 * (last - first);
  for (std::size_t g = 0; g < gauss_point.size(); ++g)
    for (const double side : {-1.0, 1.0})
    {
      const double u = middle + side * half * gauss_point[g];
      times.push_back({u * u, 2.0 * half * gauss_weight[g]});
    }
}

/// The rest up to infinity, of an integrand that falls like 1/t: in w = 1/u.
void add_tail(double first, std::vector<PastTime>& times)
{
  const double half = 0.5 / first;
  for (std::size_t g = 0; g < gauss_point.size(); ++g)
    for (const double side : {-1.0, 1.0})
    {
      const double w = half * (1.0 + side * gauss_point[g]);
      times.push_back({1.0 / (w * w), 2.0 * half * gauss_weight[g] / (w * w)});
    }
}

/// The motion of the cell along one axis of the grid.
struct Passage
{
  int cells;
  double size, velocity;
  bool is_periodic;
};

/// Times at which an edge of the cell passes the centres of cells along one axis, after (n + 1/2) cells, and the beginning and
/// end of each passage of the spread edge as long as the passage is short. Afterwards the spreading itself determines the
/// intervals.
void add_passages(const Passage& along, double diffusivity, double duration, std::vector<double>& ends)
{
  const double speed = std::abs(along.velocity), passage = along.size / speed, extent = along.cells * along.size;
  constexpr double negligible = 7.0; ///< spreads
  for (double n = 0.0;;)             // cells passed: a double, as they may exceed the range of int in slow motion
  {
    const double time = (n + 0.5) * passage, spread = std::sqrt(4.0 * diffusivity * time);
    const bool is_over = along.is_periodic ? spread > 2.0 * extent : speed * time > extent + negligible * spread;
    if (time >= duration || is_over)
      return;
    ends.push_back(time);
    for (const double widths : {0.5, 1.5, 4.0})
      if (widths * spread < 0.5 * along.size)
        ends.insert(ends.end(), {time - widths * spread / speed, time + widths * spread / speed});
    n += std::max(1.0, std::floor(spread / along.size));
  }
}

/// The time after which a unit flux has a negligible effect on the grid; infinite for a flux at rest.
double end_of_memory(const SurfaceGrid& grid, double diffusivity, const HeatMotion& motion)
{
  const double speed = std::hypot(motion.velocity_x, motion.velocity_y);
  if (speed == 0.0)
    return motion.duration;
  // When the flux was farther away than twice the diagonal, its effect is at most exp(-(v t/2)^2/(4 kappa t)).
  const double diagonal = std::hypot(grid.nx * grid.dx, grid.ny * grid.dy);
  constexpr double negligible = 40.0;
  return std::min(motion.duration, std::max(2.0 * diagonal / speed, 16.0 * negligible * diffusivity / (speed * speed)));
}

} // namespace

std::vector<PastTime> past_times(const SurfaceGrid& grid, double diffusivity, const HeatMotion& motion)
{
  const double end = end_of_memory(grid, diffusivity, motion);
  std::vector<double> ends;
  if (motion.velocity_x != 0.0)
    add_passages({grid.nx, grid.dx, motion.velocity_x, grid.is_periodic_x()}, diffusivity, end, ends);
  if (motion.velocity_y != 0.0)
    add_passages({grid.ny, grid.dy, motion.velocity_y, grid.is_periodic_y()}, diffusivity, end, ends);
  const double cell = std::min(grid.dx, grid.dy);
  const double extent = std::hypot(grid.nx * grid.dx, grid.ny * grid.dy);
  // Before the time `first`, heat does not reach the centre of a cell from its edge; after `far`, all cells act as one point.
  const double first = cell * cell / (256.0 * diffusivity);
  const double far = 4.0 * extent * extent / diffusivity;
  constexpr double growth = 2.0;
  for (double time = first; time < std::min(end, far * growth); time *= growth)
    ends.push_back(time);
  const bool has_tail = std::isinf(end);
  if (!has_tail)
  {
    for (double time = far * growth; time < end; time *= growth)
      ends.push_back(time);
    ends.push_back(end);
  }
  std::sort(ends.begin(), ends.end());

  std::vector<PastTime> times;
  double before = 0.0;
  for (const double time : ends)
  {
    const double now = std::sqrt(std::clamp(time, 0.0, end));
    if (now > before)
      add_piece(before, now, times);
    before = std::max(before, now);
  }
  if (has_tail)
    add_tail(before, times);
  return times;
}

} // namespace brinell::halfspace
