// SPDX-License-Identifier: BSD-3-Clause
#include "inclusion_cells.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/foundation/symmetry.hpp"
#include "foundation/minres.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <tuple>
#include <utility>

namespace brinell::halfspace
{

namespace
{

double bulk_modulus(const Elastic& elastic)
{
  return elastic.young_modulus / (3.0 * (1.0 - 2.0 * elastic.poisson_ratio));
}

/// (a - b)/(a + b) of two moduli, of which `b` may be zero or infinite.
double contrast(double body, double inclusion)
{
  return std::isinf(inclusion) ? -1.0 : (body - inclusion) / (body + inclusion);
}

void require_allowed(const Elastic& elastic, std::size_t number)
{
  if (!(elastic.young_modulus >= 0.0))
    throw InputError(fmt::format("inclusion {}: Young's modulus {:g} Pa; allowed: 0 (a void) or more", number + 1,
                                 elastic.young_modulus));
  if (!(elastic.poisson_ratio > -1.0 && elastic.poisson_ratio < 0.5))
    throw InputError(
        fmt::format("inclusion {}: Poisson's ratio {:g}; allowed: -1 < nu < 0.5", number + 1, elastic.poisson_ratio));
}

bool are_mirror_images(const Inclusion& a, const Inclusion& b)
{
  return a.elastic == b.elastic && a.own.dilatation == b.own.dilatation &&
         a.own.deviator == mirrored_in_y(b.own.deviator);
}

/// Number of the inclusion that each cell belongs to.
std::map<std::size_t, std::size_t> owners(const VolumeGrid& grid, const std::vector<Inclusion>& inclusions)
{
  std::map<std::size_t, std::size_t> owner;
  for (std::size_t number = 0; number < inclusions.size(); ++number)
  {
    require_allowed(inclusions[number].elastic, number);
    for (const std::size_t cell : inclusions[number].cells)
    {
      if (cell >= grid.size())
        throw InputError(fmt::format("inclusion {}: cell {}; allowed: below {}, the cells of the grid", number + 1,
                                     cell, grid.size()));
      const auto [found, is_new] = owner.emplace(cell, number);
      if (!is_new && found->second != number)
        throw InputError(fmt::format("inclusions {} and {} overlap in cell {}; allowed: inclusions that share no cell",
                                     found->second + 1, number + 1, cell));
    }
  }
  return owner;
}

/// Range of places along an axis that holds all of [first, last] and one more on each side.
std::pair<int, int> with_margin(int first, int last, int count)
{
  const int begin = std::max(0, first - 1), end = std::min(count, last + 2);
  return {begin, end - begin};
}

} // namespace

InclusionCells::InclusionCells(const VolumeGrid& volume, const Elastic& elastic,
                               const std::vector<Inclusion>& inclusions)
    : grid(volume), poisson_ratio(elastic.poisson_ratio), root_shear(std::sqrt(2.0 * elastic.shear_modulus())),
      root_volume(std::sqrt(9.0 * bulk_modulus(elastic)))
{
  const SurfaceGrid& s = grid.surface;
  const auto owner = owners(grid, inclusions);
  const double mu = elastic.shear_modulus(), k = bulk_modulus(elastic);
  for (auto* list : {&copies, &in_shear, &in_volume})
    list->reserve(owner.size());
  cells.reserve(owner.size());
  for (const auto& [cell, number] : owner)
  {
    const int row = static_cast<int>(cell / static_cast<std::size_t>(s.nx)) % s.ny;
    if (s.is_mirrored_y)
    {
      const auto other = owner.find(mirrored_cell(s, cell));
      if (other == owner.end() || !are_mirror_images(inclusions[other->second], inclusions[number]))
        throw InputError(fmt::format("inclusion {}: cell {} has no mirror image in y; allowed on a mirrored grid: "
                                     "inclusions that are symmetric",
                                     number + 1, cell));
      if (row >= s.independent_rows())
        continue;
    }
    const Elastic& own_elastic = inclusions[number].elastic;
    cells.push_back(cell);
    copies.push_back(s.copies_of_row(row));
    in_shear.push_back(contrast(mu, own_elastic.shear_modulus()));
    in_volume.push_back(contrast(k, bulk_modulus(own_elastic)));
    layers = std::max(layers, static_cast<int>(cell / s.size()) + 1);
  }
  means = CellMeans(s, cells);
  own = make_field();
  for (std::size_t i = 0; i < size(); ++i)
  {
    const Inclusion& inclusion = inclusions[owner.at(cells[i])];
    store(inclusion.own.deviator, own.deviator, size(), i);
    own.volumetric[i] = inclusion.own.dilatation;
  }
}

CellBox InclusionCells::box() const
{
  const SurfaceGrid& s = grid.surface;
  int left = s.nx, right = -1, front = s.ny, back = -1;
  for (const std::size_t cell : cells)
  {
    const int i = static_cast<int>(cell % static_cast<std::size_t>(s.nx)),
              j = static_cast<int>(cell / static_cast<std::size_t>(s.nx)) % s.ny;
    left = std::min(left, i);
    right = std::max(right, i);
    front = std::min(front, j);
    back = std::max(back, s.is_mirrored_y ? s.ny - 1 - front : j);
  }
  CellBox box{0, s.nx, 0, s.ny};
  if (!s.is_periodic_x())
    std::tie(box.first_x, box.nx) = with_margin(left, right, s.nx);
  if (!s.is_periodic_y())
    std::tie(box.first_y, box.ny) = with_margin(front, back, s.ny);
  return box;
}

InclusionCells InclusionCells::on(const CellBox& box) const
{
  InclusionCells part = *this;
  part.grid.surface.nx = box.nx;
  part.grid.surface.ny = box.ny;
  part.grid.nz = layers;
  const auto nx = static_cast<std::size_t>(grid.surface.nx), ny = static_cast<std::size_t>(grid.surface.ny);
  for (std::size_t i = 0; i < size(); ++i)
    part.cells[i] =
        part.grid.index(static_cast<int>(cells[i] % nx) - box.first_x,
                        static_cast<int>(cells[i] / nx % ny) - box.first_y, static_cast<int>(cells[i] / (nx * ny)));
  part.means = CellMeans(part.grid.surface, part.cells);
  return part;
}

InclusionCells InclusionCells::others(std::vector<std::size_t> numbers) const
{
  InclusionCells result;
  result.grid = grid;
  result.grid.surface = grid.surface.whole();
  result.cells = std::move(numbers);
  result.copies.assign(result.size(), 1.0);
  result.in_shear.assign(result.size(), 0.0);
  result.in_volume.assign(result.size(), 0.0);
  result.own = result.make_field();
  result.poisson_ratio = poisson_ratio;
  result.root_shear = root_shear;
  result.root_volume = root_volume;
  result.layers = layers;
  result.means = CellMeans(result.grid.surface, result.cells);
  return result;
}

InclusionField InclusionCells::make_field() const
{
  return {std::vector<double>(Deviator::size * size()), std::vector<double>(size())};
}

double InclusionCells::dot(std::span<const double> a, std::span<const double> b) const
{
  double sum = 0.0;
  for (std::size_t i = 0; i < size(); ++i)
    sum += copies[i] * (contract(deviator_at(a, size(), i), deviator_at(b, size(), i)) +
                        a[Deviator::size * size() + i] * b[Deviator::size * size() + i]);
  return sum;
}

namespace
{

/// Calls use(component, cell, number of the unknown).
template <typename Use>
void for_unknowns(std::size_t cells, const Use& use)
{
  for (std::size_t c = 0; c <= Deviator::size; ++c)
    for (std::size_t i = 0; i < cells; ++i)
      use(c, i, c * cells + i);
}

double value(const InclusionField& field, std::size_t component, std::size_t cell, std::size_t unknown)
{
  return component < Deviator::size ? field.deviator[unknown] : field.volumetric[cell];
}

} // namespace

void InclusionCells::to_unknown(const InclusionField& equivalent, std::span<double> w) const
{
  for_unknowns(size(),
               [&](std::size_t c, std::size_t i, std::size_t at)
               {
                 const double root = std::sqrt(std::abs(contrast_of(c, i)));
                 const double strain = value(equivalent, c, i, at) * (c < Deviator::size ? root_shear : root_volume);
                 w[at] = root > 0.0 ? strain / root : 0.0;
               });
}

void InclusionCells::to_strain(std::span<const double> w, InclusionField& equivalent) const
{
  for_unknowns(size(),
               [&](std::size_t c, std::size_t i, std::size_t at)
               {
                 const double strain = std::sqrt(std::abs(contrast_of(c, i))) * w[at];
                 if (c < Deviator::size)
                   equivalent.deviator[at] = strain / root_shear;
                 else
                   equivalent.volumetric[i] = strain / root_volume;
               });
}

void InclusionCells::to_right_side(const InclusionField& stress, std::span<double> right) const
{
  for_unknowns(size(),
               [&](std::size_t c, std::size_t i, std::size_t at)
               {
                 right[at] = 2.0 * std::sqrt(std::abs(contrast_of(c, i))) * value(stress, c, i, at) /
                             (c < Deviator::size ? root_shear : root_volume);
               });
}

void InclusionCells::to_left_side(std::span<const double> w, const InclusionField& caused, std::span<double> left) const
{
  for_unknowns(size(),
               [&](std::size_t c, std::size_t i, std::size_t at)
               {
                 const double b = contrast_of(c, i), root = std::sqrt(std::abs(b));
                 const double reflected =
                     root * w[at] +
                     2.0 * value(caused, c, i, at) / (c < Deviator::size ? root_shear : root_volume); // R sqrt|B| w
                 left[at] = (b < 0.0 ? -1.0 : 1.0) * w[at] - root * reflected;
               });
}

Inclusions::Report InclusionCells::solve(const Stress& stress, std::span<const double> right, std::span<double> w,
                                         double tolerance, int most_iterations) const
{
  InclusionField strain = make_field(), caused = make_field();
  const auto apply = [&](std::span<const double> of, std::span<double> out)
  {
    to_strain(of, strain);
    stress(strain, caused);
    to_left_side(of, caused, out);
  };
  const auto product = [&](std::span<const double> a, std::span<const double> b) { return dot(a, b); };
  const MinresReport report = minres(apply, product, right, w, tolerance, most_iterations);
  return {.iterations = report.iterations, .residual = report.residual};
}

} // namespace brinell::halfspace
