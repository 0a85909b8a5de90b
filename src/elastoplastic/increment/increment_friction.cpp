// SPDX-License-Identifier: BSD-3-Clause
#include "contact_parts.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

/// Friction in an increment: docs/theory/elastoplastic.md (coulomb).
namespace brinell::elastoplastic
{

namespace
{

/// Reduces `limit` to the shear strength of a surface where this is smaller. The strength is interpolated linearly between the
/// columns of the body and continued as a constant beyond its ends.
void limit_to_strength(const SurfaceGrid& body, const std::vector<double>& strength, const Place& place,
                       const SurfaceGrid& contact, std::vector<double>& limit)
{
  const auto column_on = [&](int column)
  {
    if (body.is_periodic_x())
      return ((column % body.nx) + body.nx) % body.nx;
    return std::clamp(column, 0, body.nx - 1);
  };
  for (int j = 0; j < contact.ny; ++j)
    for (int i = 0; i < contact.nx; ++i)
    {
      const double here = strength[body.index(column_on(i + place.column), j)];
      const double next = strength[body.index(column_on(i + place.column + 1), j)];
      double& value = limit[contact.index(i, j)];
      value = std::min(value, (1.0 - place.fraction) * here + place.fraction * next);
    }
}

/// Calls `use` with the data of both bodies that the interface needs. Thermal displacement counts as residual
/// displacement: it does not depend on the shear.
template <typename Use>
void with_bodies(const ContactParts& c, const Placement& placement, const Use& use)
{
  const auto along = [&](std::size_t axis)
  {
    std::array<std::vector<double>, 2> both{std::vector<double>(c.grid().size()), std::vector<double>(c.grid().size())};
    for (std::size_t side = 0; side < 2; ++side)
    {
      const Place& place = side == 0 ? placement.lower : placement.upper;
      const BodyView body = c.view(side);
      if (const std::vector<double> residual = body.residual_displacement(1 + axis); !residual.empty())
        add_depth(body.grid().surface, residual, {}, place, c.grid(), both[side]);
      if (c.heating)
        c.heating->add_along(side, axis, both[side]);
    }
    return both;
  };
  const auto x = along(0), y = along(1);
  const std::array<double, 2> moved = columns_moved(c, placement);
  use(Interface::Bodies{c.state.pressure, x[0], x[1], y[0], y[1], moved[0], moved[1], c.state.gap});
}

} // namespace

std::vector<double> shear_limit(const ContactParts& c, const Placement& placement,
                                const std::array<double, 2>& direction)
{
  constexpr double none = std::numeric_limits<double>::infinity();
  std::vector<double> limit(c.grid().size(), c.interface->friction().shear_limit.value_or(none));
  const auto& [x, y] = direction;
  if (const BodyView body = c.view(0); body.material().is_plastic())
    limit_to_strength(body.grid().surface, body.shear_strength(x, y), placement.lower, c.grid(), limit);
  if (const BodyView body = c.view(1); body.material().is_plastic())
    limit_to_strength(body.grid().surface, body.shear_strength(-x, -y), placement.upper, c.grid(), limit);
  return limit;
}

Interface::Change follow(ContactParts& c, const Placement& placement)
{
  if (c.interface->knows_slip())
    return c.interface->follow({.pressure = c.state.pressure, .lower_x = {}, .upper_x = {}});
  Interface::Change change;
  with_bodies(c, placement, [&](const Interface::Bodies& bodies) { change = c.interface->follow(bodies); });
  return change;
}

void spread_shear(const ContactParts& c, const Place& place, const SurfaceGrid& body, double sign,
                  std::array<std::vector<double>, 2>& out)
{
  const contact::ConstAlongSurface shears = c.interface->shears();
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    if (shears[axis].empty())
      continue;
    spread_traction(c.grid(), shears[axis], place, body, out[axis]);
    for (double& q : out[axis])
      q *= sign;
  }
}

std::array<double, 2> columns_moved(const ContactParts& c, const Placement& placement)
{
  const auto moved = [](const Place& now, const Place& before)
  { return (now.column - before.column) + (now.fraction - before.fraction); };
  return {moved(placement.lower, c.placement.lower), moved(placement.upper, c.placement.upper)};
}

void begin_friction(ContactParts& c, const Task& task)
{
  const Motion& motion = task.motion;
  const Placement& placement = task.placement;
  c.driven_along = c.interface->direction(motion.along);
  if (motion.share_at_rest.value_or(1.0) < 0.0)
    for (double& part : c.driven_along)
      part = -part;
  if (c.heating && c.may_stick())
    c.heating->recall(c.grids(), {placement.lower, placement.upper}, columns_moved(c, placement));
  std::vector<double> limit = shear_limit(c, placement, c.driven_along);
  with_bodies(c, placement,
              [&](const Interface::Bodies& bodies)
              {
                c.interface->begin({.slides = motion.slides,
                                    .along = motion.along,
                                    .limit = std::move(limit),
                                    .bodies = bodies,
                                    .holds_law = task.strategy.watch_energy,
                                    .tolerance = c.settings.tolerance_of_contact() * c.scales.gap,
                                    .approach = c.scales.gap,
                                    .wants_stop = task.strategy.wants_stop,
                                    .share_at_rest = motion.share_at_rest});
              });
}

void settle_friction(ContactParts& c, const Placement& placement)
{
  with_bodies(c, placement, [&](const Interface::Bodies& bodies) { c.interface->settle(bodies); });
}

void recall_friction(ContactParts& c)
{
  with_bodies(c, c.placement, [&](const Interface::Bodies& bodies) { c.interface->recall(bodies); });
}

bool carries_off(const ContactParts& c, const Placement& placement)
{
  const SurfaceGrid& g = c.grid();
  const int columns = placement.lower.column - c.placement.lower.column;
  if (!c.may_stick() || g.is_periodic_x() || std::abs(columns) >= g.nx)
    return false;
  const int ends = std::abs(columns);
  for (int j = 0; j < g.ny; ++j)
    for (int i = 0; i < ends; ++i)
      if (c.state.pressure[g.index(i, j)] > 0.0 || c.state.pressure[g.index(g.nx - 1 - i, j)] > 0.0)
        return true;
  return false;
}

double work_of_shear(const ContactParts& c, const Side& side)
{
  double work = 0.0;
  for (const auto& [shear, displacement] :
       {std::pair{std::span<const double>(side.shear[0]), side.body.residual_displacement(1)},
        {std::span<const double>(side.shear[1]), side.body.residual_displacement(2)}})
    if (!displacement.empty() && !shear.empty())
      work += dot(shear, displacement) * c.grid().cell_area();
  return work;
}

} // namespace brinell::elastoplastic
