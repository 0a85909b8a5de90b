// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/contact/contact_stiffness.hpp"
#include "brinell/foundation/error.hpp"
#include "contact_parts.hpp"
#include "foundation/require_size.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <tuple>

/// Results of the committed state: surfaces, stress, load, and reached edges.
namespace brinell::elastoplastic
{

namespace
{

/// A load on a body, in the axes of the solved body.
struct TurnedLoad
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
TurnedLoad load_on_solved(const ContactParts& c, std::size_t side, const Place& place)
{
  const BodyView view = c.view(side);
  if (view.material().elastic.is_rigid())
    throw InputError("the body is rigid and has no stress; allowed: the stress of a body that deforms");
  TurnedLoad load;
  const SurfaceGrid& surface = view.grid().surface;
  spread_traction(c.grid(), c.state.pressure, place, surface, load.pressure);
  if (c.interface)
    spread_shear(c, place, surface, side == 0 ? 1.0 : -1.0, load.shear);
  return {view.turned(load.pressure, 1.0), {view.turned(load.shear[0], -1.0), view.turned(load.shear[1], 1.0)}};
}

/// Whether pressure acts within so many cells of the ends, and of the sides, of the contact grid.
std::pair<bool, bool> presses_near_edges(const ContactParts& c, int cells)
{
  const SurfaceGrid& g = c.grid();
  const auto is_near = [cells](int cell, int last) { return std::min(cell, last - cell) < cells; };
  bool ends = false, sides = false;
  for (int j = 0; j < g.ny; ++j)
    for (int i = 0; i < g.nx; ++i)
      if (c.state.pressure[g.index(i, j)] > 0.0)
      {
        ends = ends || (!g.is_periodic_x() && is_near(i, g.nx - 1));
        sides = sides || (!g.is_periodic_y() && is_near(j, g.ny - 1));
      }
  return {ends, sides};
}

} // namespace

void add_depth_of(const ContactParts& c, std::size_t side, const Place& place, std::span<double> out)
{
  require_size("CoupledContact: the depth", out, c.grid().size());
  const BodyView view = c.view(side);
  const auto add = [&](std::span<const double> displacement)
  { add_depth(view.grid().surface, displacement, view.texture(), place, c.grid(), out); };
  if (view.is_mirrored())
    add(view.residual_displacement());
  else
    add(view.solved().residual_displacement()); // avoids a copy, as this is called in every evaluation
  for (const std::unique_ptr<Effect>& effect : c.effects)
    effect->add_depth(side, place, out);
}

Outgrown outgrown(const ContactParts& c)
{
  const auto edges_of = [](const Side& side)
  {
    Edges edges = side.body.reached_edges();
    edges.ends = edges.ends || side.leaves_grid;
    return edges;
  };
  Outgrown result{edges_of(c.sides.front()), edges_of(c.sides.back())};
  // The gap in two open cells tells where between cells a worn contact ends: contact::contact_area.
  const bool has_worn = largest_depth_of_effects(c) > tolerance_of_gap(c);
  std::tie(result.contact_ends, result.contact_sides) = presses_near_edges(c, has_worn ? 2 : 1);
  return result;
}

BodyView CoupledContact::lower() const
{
  return parts_->view(0);
}

BodyView CoupledContact::upper() const
{
  return parts_->view(1);
}

const SurfaceGrid& CoupledContact::grid() const
{
  return parts_->grid();
}

void CoupledContact::add_depth(std::size_t side, const Place& place, std::span<double> out) const
{
  add_depth_of(*parts_, side, place, out);
}

CoupledContact::Stress CoupledContact::stress(std::size_t side, const Place& place)
{
  ContactParts& c = *parts_;
  const BodyView view = c.view(side);
  const TurnedLoad load = load_on_solved(c, side, place);
  const std::size_t cells = view.solved().own_grid().size();
  Stress result{std::vector<double>(Deviator::size * cells), std::vector<double>(cells)};
  c.solved(side).full_stress(load.all(), result.deviator, result.trace);
  view.turn(result.deviator, result.trace);
  add_thermal_stress(c, side, result);
  return result;
}

std::vector<CoupledContact::CellState> CoupledContact::cells(std::size_t side, const Place& place,
                                                             std::span<const std::size_t> cells)
{
  ContactParts& c = *parts_;
  const BodyView view = c.view(side);
  std::vector<std::size_t> of_solved;
  for (const std::size_t cell : cells)
    of_solved.push_back(view.solved_cell(cell));
  if (cells.empty())
    return {};
  Body& solved = c.solved(side);
  const std::vector<Body::CellStress> stress = solved.stress_at(of_solved, load_on_solved(c, side, place).all());
  const BodyState& state = solved.state();
  const std::size_t size = view.grid().size();
  std::vector<CellState> result;
  for (std::size_t n = 0; n < cells.size(); ++n)
    result.push_back({{view.turned(stress[n].deviator), stress[n].trace},
                      view.turned(deviator_at(state.plastic_strain, size, of_solved[n])),
                      state.equivalent[of_solved[n]],
                      {}});
  add_heat(c, side, cells, result);
  return result;
}

void CoupledContact::keep_trace(std::size_t side)
{
  parts_->solved(side).keep_trace();
}

void CoupledContact::sample(std::size_t side, const Place& place, int first_column, int columns, int numbers,
                            std::span<float> out)
{
  ContactParts& c = *parts_;
  const BodyView view = c.view(side);
  const VolumeGrid& grid = view.grid();
  const int rows = grid.surface.independent_rows(), last = grid.surface.nx - 1;
  const TurnedLoad load = load_on_solved(c, side, place);
  Stress heat;
  if (c.heating)
  {
    heat = {std::vector<double>(Deviator::size * grid.size()), std::vector<double>(grid.size())};
    c.heating->layers(side, grid, {.temperature = {}, .deviator = heat.deviator, .trace = heat.trace});
  }
  Body& solved = c.solved(side);
  const bool is_plastic = solved.material().is_plastic(), turns = view.is_mirrored();
  const double* strain = numbers > numbers_of_stress && is_plastic ? solved.state().plastic_strain.data() : nullptr;
  const auto take = [&](int layer, const Body::LayerStress& s)
  {
    for (int j = 0; j < rows; ++j)
      for (int n = 0; n < numbers; ++n)
      {
        const int component = n < Deviator::size ? n : n - numbers_of_stress;
        const bool is_trace = n == Deviator::size;
        const std::size_t row = grid.surface.index(0, j), cell = row + grid.index(0, 0, layer);
        const double* from = nullptr;
        double added = 0.0, factor = 1.0;
        if (is_trace)
          from = s.trace + row, added = s.initial_trace, factor = 1.0 / 3.0;
        else if (n > Deviator::size)
          from = strain == nullptr ? nullptr : strain + static_cast<std::size_t>(component) * grid.size() + cell;
        else
        {
          from = s.deviator + static_cast<std::size_t>(n) * s.stride + row;
          added = n == Deviator::xx || n == Deviator::yy ? s.initial : 0.0;
        }
        const double* of_heat = nullptr; // the deviator of a body that can yield includes that of heat
        if (c.heating && is_trace)
          of_heat = heat.trace.data() + cell;
        else if (c.heating && n < Deviator::size && !is_plastic)
          of_heat = heat.deviator.data() + static_cast<std::size_t>(n) * grid.size() + cell;
        if (turns && !is_trace && (component == Deviator::xz || component == Deviator::xy))
          factor = -factor;
        float* to = out.data() +
                    ((static_cast<std::size_t>(layer) * static_cast<std::size_t>(rows) + static_cast<std::size_t>(j)) *
                         static_cast<std::size_t>(numbers) +
                     static_cast<std::size_t>(n)) *
                        static_cast<std::size_t>(columns);
        if (from == nullptr)
          std::fill_n(to, columns, 0.0F);
        else if (!turns && of_heat == nullptr)
#pragma omp simd
          for (int i = 0; i < columns; ++i)
            to[i] = static_cast<float>(factor * (from[first_column + i] + added));
        else
          for (int i = 0; i < columns; ++i)
          {
            const int column = turns ? last - first_column - i : first_column + i;
            to[i] = static_cast<float>(factor * (from[column] + added + (of_heat == nullptr ? 0.0 : of_heat[column])));
          }
      }
  };
  solved.for_layers(load.all(), take);
}

bool CoupledContact::reaches_edge() const
{
  const auto [ends, sides] = presses_near_edges(*parts_, 1);
  return ends || sides;
}

double CoupledContact::load() const
{
  return sum(parts_->state.pressure) * grid().cell_area();
}

double CoupledContact::stiffness() const
{
  return contact::stiffness(parts_->compliance, parts_->state.pressure);
}

} // namespace brinell::elastoplastic
