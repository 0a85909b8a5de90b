// SPDX-License-Identifier: BSD-3-Clause
#include "inclusion_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

namespace brinell::halfspace
{

namespace
{

/// Added to the magnitude of the diagonal, which is up to 2: strain within a void and stress within a rigid inclusion, of which nothing is noticed, would
/// otherwise be rounding divided by nearly nothing. It leaves this part of a right side.
constexpr double lift = 1e-8;

constexpr int components = Deviator::size + 1;

struct Place
{
  int x, y, layer;
};

Place place_of(const SurfaceGrid& s, std::size_t cell)
{
  const auto nx = static_cast<std::size_t>(s.nx);
  return {static_cast<int>(cell % nx), static_cast<int>(cell / nx) % s.ny, static_cast<int>(cell / s.size())};
}

bool is_odd_along_x(int component)
{
  return component == Deviator::xz || component == Deviator::xy;
}

bool is_odd_along_y(int component)
{
  return component < Deviator::size && is_odd_in_y(component);
}

/// Stress by the strain of one cell at the corner of the grid, in all cells as far from it as cells of the inclusions are from each other.
class Corner
{
public:
  Corner(InclusionFields& fields, const InclusionCells& of) : fields_(fields)
  {
    const SurfaceGrid& s = of.grid.surface;
    const CellBox box = of.box();
    const int margin_x = s.is_periodic_x() ? 0 : 1, margin_y = s.is_periodic_y() ? 0 : 1;
    nx_ = box.nx - 2 * margin_x;
    ny_ = box.ny - 2 * margin_y;
    std::vector<std::size_t> around;
    around.reserve(static_cast<std::size_t>(nx_ * ny_ * of.layers));
    for (int layer = 0; layer < of.layers; ++layer)
      for (int j = 0; j < ny_; ++j)
        for (int i = 0; i < nx_; ++i)
          around.push_back(of.grid.index(margin_x + i, margin_y + j, layer));
    cells_ = of.others(std::move(around));
    strain_ = caused_ = cells_.make_field();
  }

  /// Computes the stress by a component of the strain of a cell in some layer.
  void find(int layer, int component)
  {
    source_ = component;
    double& strain = value(strain_, component, at(0, 0, layer));
    strain = 1.0;
    fields_.stress(cells_, strain_, caused_);
    strain = 0.0;
  }

  /// Stress in a cell by the strain of a cell of that layer.
  [[nodiscard]] double stress(int component, const Place& from, const Place& in)
  {
    const int x = in.x - from.x, y = in.y - from.y;
    const double there = value(caused_, component, at(std::abs(x), std::abs(y), in.layer));
    const bool turns_x = x < 0 && is_odd_along_x(component) != is_odd_along_x(source_),
               turns_y = y < 0 && is_odd_along_y(component) != is_odd_along_y(source_);
    return turns_x != turns_y ? -there : there;
  }

private:
  [[nodiscard]] std::size_t at(int x, int y, int layer) const
  {
    return static_cast<std::size_t>((layer * ny_ + y) * nx_ + x);
  }
  [[nodiscard]] double& value(InclusionField& field, int component, std::size_t cell) const
  {
    return component < Deviator::size ? field.deviator[static_cast<std::size_t>(component) * cells_.size() + cell]
                                      : field.volumetric[cell];
  }

  InclusionFields& fields_;
  int nx_ = 0, ny_ = 0, source_ = 0;
  InclusionCells cells_;
  InclusionField strain_, caused_;
};

} // namespace

bool InclusionMatrix::is_possible(const InclusionCells& cells)
{
  const SurfaceGrid& s = cells.grid.surface;
  const auto is_inside = [&](std::size_t cell)
  {
    const Place at = place_of(s, cell);
    return (s.is_periodic_x() || (at.x > 0 && at.x + 1 < s.nx)) && (s.is_periodic_y() || (at.y > 0 && at.y + 1 < s.ny));
  };
  return cells.unknowns() <= Inclusions::most_of_matrix &&
         std::all_of(cells.cells.begin(), cells.cells.end(), is_inside);
}

Matrix InclusionMatrix::matrix(InclusionFields& fields, const InclusionCells& cells)
{
  const std::size_t n = cells.size();
  std::vector<Place> places;
  places.reserve(n);
  for (const std::size_t cell : cells.cells)
    places.push_back(place_of(cells.grid.surface, cell));
  const auto root = [&](int component, std::size_t i)
  {
    return std::sqrt(std::abs(cells.contrast_of(static_cast<std::size_t>(component), i))) /
           (component < Deviator::size ? cells.root_shear : cells.root_volume);
  };
  const auto number = [&](int component, std::size_t i)
  { return static_cast<int>(static_cast<std::size_t>(component) * n + i); };
  // The mirror image of a strain acts, too.
  const int rows = cells.grid.surface.ny;
  Corner corner(fields, cells);
  const auto stress = [&](int component, int of, std::size_t from, std::size_t in)
  {
    const double own = corner.stress(component, places[from], places[in]);
    const Place& p = places[from];
    const double image =
        cells.copies[from] == 2.0 ? corner.stress(component, {p.x, rows - 1 - p.y, p.layer}, places[in]) : 0.0;
    return own + (is_odd_along_y(of) ? -image : image);
  };
  Matrix a(static_cast<int>(cells.unknowns()), static_cast<int>(cells.unknowns()));
  for (int layer = 0; layer < cells.layers; ++layer)
    for (int of = 0; of < components; ++of)
    {
      bool is_found = false;
      for (std::size_t from = 0; from < n; ++from)
      {
        if (places[from].layer != layer)
          continue;
        if (!is_found)
          corner.find(layer, of);
        is_found = true;
        double* const column = a.column(number(of, from));
        const double b = cells.contrast_of(static_cast<std::size_t>(of), from);
        for (int c = 0; c < components; ++c)
          for (std::size_t i = 0; i < n; ++i)
            column[number(c, i)] = -2.0 * root(c, i) * stress(c, of, from, i) * root(of, from);
        column[number(of, from)] += (b < 0.0 ? -1.0 : 1.0) * std::max(1.0, std::abs(b) + lift) - std::abs(b);
      }
    }
  return a;
}

} // namespace brinell::halfspace
