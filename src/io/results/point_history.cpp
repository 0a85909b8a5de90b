// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/io/point_history.hpp"

#include "brinell/foundation/sym_tensor.hpp"
#include "surface_fields.hpp"

#include <array>
#include <cmath>
#include <optional>

namespace brinell::io
{

namespace
{

using simulation::StepFields;

struct PointValues
{
  double x = unknown, y = unknown, depth = unknown;
  SymTensor stress{unknown, unknown, unknown, unknown, unknown, unknown}, plastic_strain = stress;
  double equivalent = unknown, temperature = unknown;
};

std::vector<NamedNumber> row_of(int step, int point, int body, const PointValues& v)
{
  const auto& [sxx, syy, szz, syz, sxz, sxy] = v.stress;
  const auto& [exx, eyy, ezz, eyz, exz, exy] = v.plastic_strain;
  return {{"step", "1", "row of the history", step},
          {"point", "1", "number of the point, from 1", point},
          {"body", "1", "1: lower, 2: upper", body},
          {"x", "m", "centre of its cell", v.x},
          {"y", "m", "centre of its cell", v.y},
          {"depth", "m", "centre of its cell", v.depth},
          {"stress_xx", "Pa", "stress", sxx},
          {"stress_yy", "Pa", "stress", syy},
          {"stress_zz", "Pa", "stress", szz},
          {"stress_yz", "Pa", "stress", syz},
          {"stress_xz", "Pa", "stress", sxz},
          {"stress_xy", "Pa", "stress", sxy},
          {"von_mises_stress", "Pa", "von Mises stress", von_mises(v.stress)},
          {"plastic_strain_xx", "1", "plastic strain", exx},
          {"plastic_strain_yy", "1", "plastic strain", eyy},
          {"plastic_strain_zz", "1", "plastic strain", ezz},
          {"plastic_strain_yz", "1", "plastic strain", eyz},
          {"plastic_strain_xz", "1", "plastic strain", exz},
          {"plastic_strain_xy", "1", "plastic strain", exy},
          {"equivalent_plastic_strain", "1", "accumulated equivalent plastic strain", v.equivalent},
          {"temperature", "degC", "temperature; NaN without heat", v.temperature}};
}

/// Index of the cell around a coordinate; none beyond the grid.
std::optional<std::size_t> cell_along(double coordinate, double first, double size, int cells)
{
  const double cell = std::floor((coordinate - first) / size + 0.5);
  if (!(cell >= 0.0) || cell >= cells)
    return std::nullopt;
  return static_cast<std::size_t>(cell);
}

/// Index of the cell around a point; none beyond the grid.
std::optional<std::size_t> cell_around(const HistoryPoint& point, const simulation::BodySnapshot& body)
{
  const SurfaceGrid& grid = body.grid.surface;
  const auto i = cell_along(point.x, body.x0, grid.dx, grid.nx), j = cell_along(point.y, body.y0, grid.dy, grid.ny),
             k = cell_along(point.depth, 0.5 * body.grid.dz, body.grid.dz, body.grid.nz);
  if (!i || !j || !k)
    return std::nullopt;
  return (*k * static_cast<std::size_t>(grid.ny) + *j) * static_cast<std::size_t>(grid.nx) + *i;
}

/// The values of the points of a body, those of other bodies left as they are.
void fill(std::vector<PointValues>& values, const std::vector<HistoryPoint>& points, bool is_upper,
          const simulation::BodySnapshot& body, const StepFields::Within& within)
{
  std::vector<std::size_t> cells, places;
  for (std::size_t p = 0; p < points.size(); ++p)
    if (const auto cell = points[p].is_upper == is_upper ? cell_around(points[p], body) : std::nullopt)
    {
      cells.push_back(*cell);
      places.push_back(p);
    }
  if (cells.empty())
    return;
  const std::vector<StepFields::CellState> states = within.cells(cells);
  const SurfaceGrid& grid = body.grid.surface;
  const auto nx = static_cast<std::size_t>(grid.nx), ny = static_cast<std::size_t>(grid.ny);
  for (std::size_t n = 0; n < cells.size(); ++n)
  {
    const std::size_t cell = cells[n], row = cell / nx % ny, layer = cell / nx / ny;
    values[places[n]] = {body.x0 + static_cast<double>(cell % nx) * grid.dx,
                         body.y0 + static_cast<double>(row) * grid.dy,
                         (static_cast<double>(layer) + 0.5) * body.grid.dz,
                         states[n].stress,
                         states[n].plastic_strain,
                         states[n].equivalent_plastic_strain,
                         states[n].temperature.value_or(unknown)};
  }
}

} // namespace

std::vector<NamedNumber> point_columns()
{
  return row_of(0, 0, 0, {});
}

std::vector<std::vector<NamedNumber>> point_rows(const std::vector<HistoryPoint>& points, int step,
                                                 const StepFields& fields)
{
  std::vector<PointValues> values(points.size());
  fill(values, points, false, fields.surfaces.lower, fields.lower);
  fill(values, points, true, fields.surfaces.upper, fields.upper);
  std::vector<std::vector<NamedNumber>> rows;
  for (std::size_t p = 0; p < points.size(); ++p)
    rows.push_back(row_of(step, static_cast<int>(p) + 1, points[p].is_upper ? 2 : 1, values[p]));
  return rows;
}

} // namespace brinell::io
