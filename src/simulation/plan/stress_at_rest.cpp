// SPDX-License-Identifier: BSD-3-Clause
#include "stress_at_rest.hpp"

#include "brinell/foundation/deviator.hpp"
#include "brinell/halfspace/half_space.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace brinell::simulation
{

namespace
{

/// Cells around inclusions, in which the stress is that at their surface.
constexpr int margin = 3;
/// Cells that take a second or so.
constexpr std::size_t most_cells = 150000;

struct Range
{
  int first = std::numeric_limits<int>::max(), end = 0;

  void add(int place)
  {
    first = std::min(first, place);
    end = std::max(end, place + 1);
  }
  /// With cells around, within an axis.
  [[nodiscard]] Range widened(int count, bool is_periodic) const
  {
    return is_periodic ? Range{0, count} : Range{std::max(0, first - margin), std::min(count, end + margin)};
  }
  [[nodiscard]] int size() const { return end - first; }
};

/// Columns, rows and layers around inclusions.
struct Box
{
  Range x, y, z;

  Box(const std::vector<elastoplastic::Inclusion>& inclusions, const VolumeGrid& grid)
  {
    const SurfaceGrid& s = grid.surface;
    const auto nx = static_cast<std::size_t>(s.nx);
    for (const elastoplastic::Inclusion& inclusion : inclusions)
      for (const std::size_t cell : inclusion.cells)
      {
        x.add(static_cast<int>(cell % nx));
        y.add(static_cast<int>(cell / nx) % s.ny);
        z.add(static_cast<int>(cell / s.size()));
      }
    x = x.widened(s.nx, s.is_periodic_x());
    y = y.widened(s.ny, s.is_periodic_y());
    z = {0, std::min(grid.nz, z.end + margin)};
  }
  [[nodiscard]] VolumeGrid grid(const VolumeGrid& whole) const
  {
    VolumeGrid part = whole;
    part.surface = whole.surface.whole();
    part.surface.nx = x.size();
    part.surface.ny = y.size();
    part.nz = z.size();
    return part;
  }
  [[nodiscard]] std::size_t place(const VolumeGrid& whole, const VolumeGrid& part, std::size_t cell) const
  {
    const auto nx = static_cast<std::size_t>(whole.surface.nx);
    return part.index(static_cast<int>(cell % nx) - x.first, static_cast<int>(cell / nx) % whole.surface.ny - y.first,
                      static_cast<int>(cell / whole.surface.size()));
  }
};

} // namespace

double ratio_at_rest(const std::vector<elastoplastic::Inclusion>& inclusions, const VolumeGrid& grid,
                     const constitutive::Material& material)
{
  constexpr double tolerance = 1e-3;
  constexpr int most_iterations = 200;
  const Box box(inclusions, grid);
  const VolumeGrid part = box.grid(grid);
  if (part.size() > most_cells)
    return std::numeric_limits<double>::quiet_NaN();
  std::vector<double> strength(part.size());
  for (std::size_t cell = 0; cell < part.size(); ++cell)
  {
    const std::size_t layer = cell / part.surface.size(); // from the surface on
    const double depth = (static_cast<double>(layer) + 0.5) * grid.dz;
    strength[cell] = constitutive::initial_yield_stress(material.law()) * material.yield_factor.at(depth, 1.0);
  }
  std::vector<halfspace::Inclusion> moved;
  moved.reserve(inclusions.size());
  for (const elastoplastic::Inclusion& inclusion : inclusions)
  {
    moved.push_back({inclusion.elastic, {}, inclusion.own});
    moved.back().cells.reserve(inclusion.cells.size());
    for (const std::size_t cell : inclusion.cells)
    {
      moved.back().cells.push_back(box.place(grid, part, cell));
      strength[moved.back().cells.back()] *= inclusion.yield_factor;
    }
  }
  const halfspace::HalfSpace body(part, material.elastic);
  halfspace::Inclusions embedded(body, moved);
  halfspace::InclusionField stress = embedded.make_field(), strain = stress;
  embedded.stress(embedded.own_strain(), stress);
  (void)embedded.solve(stress, strain, tolerance, most_iterations);
  for (std::size_t i = 0; i < strain.deviator.size(); ++i)
    strain.deviator[i] += embedded.own_strain().deviator[i];
  for (std::size_t i = 0; i < strain.volumetric.size(); ++i)
    strain.volumetric[i] += embedded.own_strain().volumetric[i];
  std::vector<double> deviator(Deviator::size * part.size());
  embedded.add(strain, part.nz, {deviator, {}, {}});
  double largest = 0.0;
  for (std::size_t cell = 0; cell < part.size(); ++cell)
    largest = std::max(largest, von_mises(deviator_at(deviator, part.size(), cell)) / strength[cell]);
  return largest;
}

} // namespace brinell::simulation
