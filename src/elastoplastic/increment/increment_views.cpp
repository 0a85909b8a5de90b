// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/increment.hpp"

#include "brinell/contact/contact_stiffness.hpp"
#include "brinell/foundation/error.hpp"
#include "foundation/require_size.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <tuple>

/// Results of the committed state: surfaces, stress, load, and reached edges.
namespace brinell::elastoplastic
{

namespace
{

void add_depth_of(const BodyView& view, const Place& place, const SurfaceGrid& contact, std::span<double> out)
{
  require_size("CoupledContact: the depth", out, contact.size());
  const auto add = [&](std::span<const double> displacement)
  { add_depth(view.grid().surface, displacement, view.texture(), place, contact, out); };
  if (view.is_mirrored())
    add(view.residual_displacement());
  else
    add(view.solved().residual_displacement()); // avoids a copy, as this is called in every evaluation
}

} // namespace

void CoupledContact::add_lower_depth(const Place& place, std::span<double> out) const
{
  add_depth_of(lower(), place, grid(), out);
  for (const std::unique_ptr<Effect>& effect : effects_)
    effect->add_depth(0, place, out);
}

void CoupledContact::add_upper_depth(const Place& place, std::span<double> out) const
{
  add_depth_of(upper(), place, grid(), out);
  for (const std::unique_ptr<Effect>& effect : effects_)
    effect->add_depth(1, place, out);
}

CoupledContact::Stress CoupledContact::lower_stress(const Place& place)
{
  return stress(0, sides_.front().body, place);
}

CoupledContact::Stress CoupledContact::upper_stress(const Place& place)
{
  return stress(1, sides_.back().body, place);
}

/// A load on a body, in the axes of the solved body.
struct CoupledContact::TurnedLoad
{
  std::vector<double> pressure;
  std::array<std::vector<double>, 2> shear;

  [[nodiscard]] halfspace::SurfaceLoad all() const
  {
    return {.pressure = pressure, .shear_x = shear[0], .shear_y = shear[1]};
  }
};

/// The stress in a mirror image is the mirrored stress of the solved body under the mirrored load.
/// @throws InputError if the body is rigid
CoupledContact::TurnedLoad CoupledContact::load_on_solved(std::size_t side, const Place& place) const
{
  const BodyView view = side == 0 ? lower() : upper();
  if (view.material().elastic.is_rigid())
    throw InputError("the body is rigid and has no stress; allowed: the stress of a body that deforms");
  TurnedLoad load;
  const SurfaceGrid& surface = view.grid().surface;
  spread_traction(grid(), pressure_, place, surface, load.pressure);
  if (interface_)
    spread_shear(place, surface, side == 0 ? 1.0 : -1.0, load.shear);
  return {view.turned(load.pressure, 1.0), {view.turned(load.shear[0], -1.0), view.turned(load.shear[1], 1.0)}};
}

/// @param solved  the body itself, or the body of which it is the twin
CoupledContact::Stress CoupledContact::stress(std::size_t side, Body& solved, const Place& place) const
{
  const BodyView view = side == 0 ? lower() : upper();
  const TurnedLoad load = load_on_solved(side, place);
  const std::size_t cells = view.grid().size();
  Stress result{std::vector<double>(Deviator::size * cells), std::vector<double>(cells)};
  solved.full_stress(load.all(), result.deviator, result.trace);
  view.turn(result.deviator, result.trace);
  add_thermal_stress(side, view, result);
  return result;
}

/// @param solved  as in `stress`
std::vector<CoupledContact::CellState> CoupledContact::states(std::size_t side, Body& solved, const Place& place,
                                                              std::span<const std::size_t> cells) const
{
  const BodyView view = side == 0 ? lower() : upper();
  std::vector<std::size_t> of_solved;
  for (const std::size_t cell : cells)
    of_solved.push_back(view.solved_cell(cell));
  if (cells.empty())
    return {};
  const std::vector<Body::CellStress> stress = solved.stress_at(of_solved, load_on_solved(side, place).all());
  const BodyState& state = solved.state();
  const std::size_t size = view.grid().size();
  std::vector<CellState> result;
  for (std::size_t n = 0; n < cells.size(); ++n)
    result.push_back({{view.turned(stress[n].deviator), stress[n].trace},
                      view.turned(deviator_at(state.plastic_strain, size, of_solved[n])),
                      state.equivalent[of_solved[n]],
                      {}});
  add_heat(side, view, cells, result);
  return result;
}

Outgrown CoupledContact::outgrown() const
{
  const auto edges_of = [](const Side& side)
  {
    Edges edges = side.body.reached_edges();
    edges.ends = edges.ends || side.leaves_grid;
    return edges;
  };
  Outgrown result{edges_of(sides_.front()), edges_of(sides_.back())};
  // The gap in two open cells tells where between cells a worn contact ends: contact::contact_area.
  const bool has_worn = largest_depth_of_effects() > tolerance_of_gap();
  std::tie(result.contact_ends, result.contact_sides) = presses_near_edges(has_worn ? 2 : 1);
  return result;
}

/// Whether pressure acts within so many cells of the ends, and of the sides, of the contact grid.
std::pair<bool, bool> CoupledContact::presses_near_edges(int cells) const
{
  const SurfaceGrid& g = grid();
  const auto is_near = [cells](int cell, int last) { return std::min(cell, last - cell) < cells; };
  bool ends = false, sides = false;
  for (int j = 0; j < g.ny; ++j)
    for (int i = 0; i < g.nx; ++i)
      if (pressure_[g.index(i, j)] > 0.0)
      {
        ends = ends || (!g.is_periodic_x() && is_near(i, g.nx - 1));
        sides = sides || (!g.is_periodic_y() && is_near(j, g.ny - 1));
      }
  return {ends, sides};
}

bool CoupledContact::reaches_edge() const
{
  const auto [ends, sides] = presses_near_edges(1);
  return ends || sides;
}

double CoupledContact::load() const
{
  return sum(pressure_) * grid().cell_area();
}

double CoupledContact::stiffness() const
{
  return contact::stiffness(compliance_, pressure_);
}

} // namespace brinell::elastoplastic
