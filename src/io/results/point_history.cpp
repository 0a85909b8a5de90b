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
  std::array<double, 6> stress{}, plastic_strain{};
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
          {"von_mises_stress", "Pa", "von Mises stress", von_mises(SymTensor{sxx, syy, szz, syz, sxz, sxy})},
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

/// The fields of a body at a step, each computed once.
struct FieldsAtPoints
{
  const simulation::BodySnapshot& body;
  simulation::TensorField stress, plastic_strain;
  std::vector<double> equivalent, temperature;

  FieldsAtPoints(const simulation::BodySnapshot& snapshot, const StepFields::Within& within)
      : body(snapshot), stress(within.stress()), plastic_strain(within.plastic_strain()),
        equivalent(within.equivalent_plastic_strain())
  {
    if (within.temperature)
      temperature = within.temperature();
  }

  [[nodiscard]] PointValues at(const HistoryPoint& point) const
  {
    PointValues values;
    values.stress.fill(unknown);
    values.plastic_strain.fill(unknown);
    const SurfaceGrid& grid = body.grid.surface;
    const auto i = cell_along(point.x, body.x0, grid.dx, grid.nx), j = cell_along(point.y, body.y0, grid.dy, grid.ny),
               k = cell_along(point.depth, 0.5 * body.grid.dz, body.grid.dz, body.grid.nz);
    if (!i || !j || !k)
      return values;
    const std::size_t cell = (*k * static_cast<std::size_t>(grid.ny) + *j) * static_cast<std::size_t>(grid.nx) + *i;
    values.x = body.x0 + static_cast<double>(*i) * grid.dx;
    values.y = body.y0 + static_cast<double>(*j) * grid.dy;
    values.depth = (static_cast<double>(*k) + 0.5) * body.grid.dz;
    for (std::size_t c = 0; c < values.stress.size(); ++c)
    {
      values.stress[c] = stress[c][cell];
      values.plastic_strain[c] = plastic_strain[c][cell];
    }
    values.equivalent = equivalent[cell];
    values.temperature = temperature.empty() ? unknown : temperature[cell];
    return values;
  }
};

} // namespace

std::vector<NamedNumber> point_columns()
{
  return row_of(0, 0, 0, {});
}

std::vector<std::vector<NamedNumber>> point_rows(const std::vector<HistoryPoint>& points, int step,
                                                 const StepFields& fields)
{
  std::array<std::optional<FieldsAtPoints>, 2> bodies;
  std::vector<std::vector<NamedNumber>> rows;
  for (const HistoryPoint& point : points)
  {
    const std::size_t side = point.is_upper ? 1 : 0;
    if (!bodies[side])
      bodies[side].emplace(side == 0 ? fields.surfaces.lower : fields.surfaces.upper,
                           side == 0 ? fields.lower : fields.upper);
    rows.push_back(
        row_of(step, static_cast<int>(rows.size()) + 1, static_cast<int>(side) + 1, bodies[side]->at(point)));
  }
  return rows;
}

} // namespace brinell::io
