// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

/// Cell sizes and grids of a run. The extents that the grids have to cover are estimated by each scenario.
namespace brinell::simulation
{

/// Size of the contact, from which the cell sizes follow.
struct ContactSize
{
  double half_x = 0.0, half_y = 0.0; ///< [m]
  bool straight_y = false;           ///< the contact ends at the ends of a roller, where cells have to end too
};

/// Whether layers of cells must end at the interfaces of a body: of a coated one that can yield, or whose fatigue is computed.
[[nodiscard]] bool needs_aligned_cells(const ShapedBody& body);

/// Cell sizes dx, dy, dz [m] from the size of the contact, unless they are given. Along a periodic axis the period is a whole
/// number of cells. Under coatings, layers of cells end at the interfaces where these need it and at most four times as many do.
/// @param aspect  dy over dx for a round contact.
/// @throws GridError; PlanError if a period is not a whole number of given cells
[[nodiscard]] std::array<double, 3> cell_sizes(const PairCase& pair, const ContactSize& contact, double aspect);

/// Cells of a contact that moves along a way, and the steps in which it does.
struct StepsOnWay
{
  std::array<double, 3> cells{}; ///< [m]
  double shift = 0.0;            ///< distance of a step [m]
  int count = 0;
};

/// The distance of a step that a case asks for.
struct WantedShift
{
  std::optional<double> shift{}; ///< [m]; none: one cell
  bool is_whole = false;         ///< whether it must be a whole number of cells
};

/// Steps that end where the way does. A step is one cell, and cells that follow from a resolution are chosen such that an even
/// number of them is the way; a given shift that is no whole number of cells is chosen so instead. Given cells, those of a period,
/// and a given shift of whole cells stay, and the number of steps is rounded. Where a shift must be whole cells, cells that follow
/// from a resolution are made to fit it.
/// @param cells     of `cell_sizes`
/// @param multiple  of which the number of steps is one
/// @param key       of the way, for messages
/// @throws PlanError if there are too many steps
[[nodiscard]] StepsOnWay steps_on_way(const Numerics& numerics, const std::array<double, 3>& cells,
                                      const WantedShift& wanted, double way, int multiple, const std::string& key);

/// Number of cells of a shift that is whole cells, with which surfaces are not interpolated; none of another shift.
[[nodiscard]] std::optional<double> whole_cells(double shift, double cell);

/// Half-lengths around the middle of each grid, and depth, that the grids have to cover [m].
struct Extents
{
  double contact_x = 0.0, contact_y = 0.0;
  double lower_x = 0.0, upper_x = 0.0; ///< of the material
  double depth = 0.0;
};

/// Widens the extents to those of a heat source on one body.
void cover(const elastoplastic::HeatSource& source, Extents& extents);

/// Sets the grids of a plan; its `surfaces_only` must be set. Numbers of columns and rows are odd, so that one cell is in the
/// middle. The material grids have the rows of the contact grid; they get some more columns than requested, because material is
/// pushed ahead, and never fewer than the contact grid. Along a periodic axis all three grids have the cells of one period.
/// @throws GridError if the grids are absurdly large
void lay_out(const std::array<double, 3>& cells, const Extents& extents, const Domain& domain, Plan& plan);

/// Columns or rows of the next larger grid: at least a third more, equally many at either end.
[[nodiscard]] int grown(int cells);
/// Rows of the next larger grid with heat: at least a sixth more, because the thermal grid, which does not grow, is only a third
/// wider.
[[nodiscard]] int grown_by_heat(int rows);

/// Converts a number of steps to an integer.
/// @throws PlanError of the key if the number is far too large
[[nodiscard]] int step_count(double steps, const std::string& member);

} // namespace brinell::simulation
