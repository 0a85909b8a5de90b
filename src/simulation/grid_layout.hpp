// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

/// Cells and grids of a run: the one place that counts them. What they have to cover is each scenario's own estimate.
namespace brinell::simulation
{

/// What the cells of a contact follow from.
struct ContactSize
{
  double half_x = 0.0, half_y = 0.0; ///< [m]
  bool straight_y = false;           ///< the contact ends with a roller, and so do its cells
};

/// Cells from the contact's size, unless they are given. Along a periodic axis a whole number of them makes the period.
/// @param aspect  dy over dx for a round contact.
/// @throws GridError; KeyError of a period that is no whole number of given cells
[[nodiscard]] std::array<double, 3> cell_sizes(const Numerics& numerics, const ContactSize& contact, double aspect);

/// Half-lengths around the middle of each grid, and depth, to be covered [m].
struct Extents
{
  double contact_x = 0.0, contact_y = 0.0;
  double lower_x = 0.0, upper_x = 0.0; ///< of the material
  double depth = 0.0;
};

/// Lays the grids out: an odd number of columns and rows, so that one cell is in the middle. The material grids have the rows
/// of the contact's, some columns more than asked for, because material is pushed ahead, and never fewer than the contact.
/// Along a periodic axis all three have the cells of one period.
/// @throws GridError if they are beyond all measure
void lay_out(const std::array<double, 3>& cells, const Extents& extents, const Domain& domain, Plan& plan);

/// Columns or rows of a grid that has been outgrown: at least a third more, as many at either end.
[[nodiscard]] int grown(int cells);
/// Rows likewise, of a contact that heat widens by little: at least a sixth more. The grid of the heat has no more than a third.
[[nodiscard]] int grown_by_heat(int rows);

/// A number of steps as a whole one. @throws KeyError of the key if there are far too many
[[nodiscard]] int step_count(double steps, const std::string& key);

} // namespace brinell::simulation
