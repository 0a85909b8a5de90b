// SPDX-License-Identifier: BSD-3-Clause
#include "body_parts.hpp"
#include "surface_means.hpp"

#include <algorithm>
#include <array>

namespace brinell::elastoplastic
{

namespace
{

/// Squares of the von Mises norms of `cells` cells of a deviator field, 3/2 s : s.
void von_mises_squares(const double* field, std::size_t stride, std::size_t cells, double* squares)
{
  using D = Deviator;
  const double* xx = field + D::xx * stride;
  const double* yy = field + D::yy * stride;
  const double* yz = field + D::yz * stride;
  const double* xz = field + D::xz * stride;
  const double* xy = field + D::xy * stride;
#pragma omp simd
  for (std::size_t i = 0; i < cells; ++i)
    squares[i] = 3.0 * (xx[i] * xx[i] + yy[i] * yy[i] + xx[i] * yy[i] + yz[i] * yz[i] + xz[i] * xz[i] + xy[i] * xy[i]);
}

/// Whether any value exceeds the limit. In most rows none does, and the row needs no closer look.
bool exceeds(const double* values, std::size_t count, double limit)
{
  int exceeding = 0;
#pragma omp simd reduction(+ : exceeding)
  for (std::size_t i = 0; i < count; ++i)
    exceeding += values[i] > limit ? 1 : 0;
  return exceeding > 0;
}

/// Squares of the von Mises norms of q relative to the centre of the yield surface, for consecutive cells of a row.
/// @param q      xx component of q of the first cell, within a deviator field of the grid
/// @param row    of the grid, counted through all layers
/// @param first  column of the first cell
void sizes_from_centre(const BodyParts& b, const double* q, std::size_t row, std::size_t first,
                       std::span<double> squares)
{
  const std::size_t n = b.grid.size(), terms = b.yield.material.kinematic.size(), end = first + squares.size();
  von_mises_squares(q, n, squares.size(), squares.data());
  if (terms == 0)
    return;
  // Back stresses are non-zero only where the body has flowed. They are subtracted in blocks of columns.
  constexpr std::size_t block = 64;
  std::array<double, Deviator::size * block> from_centre{};
  const auto [from, to] = b.zone.columns(row);
  for (std::size_t column = std::max(from, first); column < std::min(to, end); column += block)
  {
    const std::size_t count = std::min(std::min(to, end) - column, block);
    const std::size_t cell = row * static_cast<std::size_t>(b.grid.surface.nx) + column;
    for (std::size_t c = 0; c < Deviator::size; ++c)
    {
      double* component = from_centre.data() + c * block;
      std::copy_n(q + c * n + (column - first), count, component);
      for (std::size_t term = 0; term < terms; ++term)
      {
        const double* back = b.state.backstress.data() + (term * Deviator::size + c) * n + cell;
#pragma omp simd
        for (std::size_t i = 0; i < count; ++i)
          component[i] -= back[i];
      }
    }
    von_mises_squares(from_centre.data(), block, count, squares.data() + (column - first));
  }
}

/// Finds cells of one layer that are not yet active and whose q lies outside the yield surface scaled by `fraction`.
template <typename Law>
void find_cells_beyond(const BodyParts& b, const Law& law, std::size_t layer, const std::vector<double>& q_field,
                       int shift, double fraction, std::vector<std::size_t>& found)
{
  const SurfaceGrid& s = b.grid.surface;
  const Columns columns = b.evaluation->columns();
  const auto first = static_cast<std::size_t>(std::max(columns.first, shift));
  const auto last = static_cast<std::size_t>(std::max(0, std::min(columns.first + columns.count, s.nx + shift)));
  if (last <= first)
    return;
  const auto square = [](double value) { return value < 0.0 ? -1.0 : value * value; };
  const double initial = square(fraction * law.yield_stress_at(0.0));
  std::vector<double> squares(last - first);
  for (std::size_t j = 0; j < static_cast<std::size_t>(s.independent_rows()); ++j)
  {
    const std::size_t row = layer * static_cast<std::size_t>(s.ny) + j;
    const std::size_t begin = row * static_cast<std::size_t>(s.nx) + first;
    sizes_from_centre(b, q_field.data() + static_cast<std::ptrdiff_t>(begin) - shift, row, first, squares);
    if (b.yield.softening.empty() && !exceeds(squares.data(), squares.size(), initial))
      continue;
    for (std::size_t i = 0; i < squares.size(); ++i)
    {
      const std::size_t cell = begin + i;
      const double softened = b.yield.softening_at(cell) * b.yield.softening_at(cell);
      // No law softens with strain: a cell within the initial yield surface is within the current one as well.
      if (squares[i] > initial * softened && !b.trial.active.contains(cell) &&
          squares[i] > square(fraction * law.yield_stress_at(b.state.equivalent[cell])) * softened)
        found.push_back(cell);
    }
  }
}

} // namespace

void collect_active(BodyParts& b, const std::vector<double>& q_field, int shift, double fraction)
{
  const std::size_t n = b.grid.size();
  std::vector<std::vector<std::size_t>> found(static_cast<std::size_t>(b.share.count(b.evaluation->layers())));
#pragma omp parallel for schedule(dynamic)
  for (std::size_t layer = 0; layer < found.size(); ++layer)
    std::visit([&](const auto& law)
               { find_cells_beyond(b, b.yield.of_layer(law, layer), layer, q_field, shift, fraction, found[layer]); },
               b.yield.laws[b.yield.law_of[layer]]);
  const SurfaceGrid& s = b.grid.surface;
  for (const std::vector<std::size_t>& cells : found) // by layers, so that the order does not depend on the threads
    for (const std::size_t cell : cells)
    {
      const int row = static_cast<int>(cell % s.size()) / s.nx;
      const Deviator q = deviator_at(q_field, n, static_cast<std::size_t>(static_cast<std::ptrdiff_t>(cell) - shift));
      b.trial.active.add(cell, q, deviator_at(b.state.plastic_strain, n, cell), s.copies_of_row(row));
    }
  if (b.share.is_all())
    return;
  std::vector<double> added;
  added.reserve(found.size());
  for (const std::vector<std::size_t>& cells : found)
    added.push_back(static_cast<double>(cells.size()));
  number_active_cells(b, added);
}

namespace
{

/// Extension of the step of trials along the flow, relative to their residual: for the cell's own flow along the surface in the
/// uppermost layer, and for the local mean of this flow around the cell. bench/notebook/2026-11-25-friction.md
constexpr double own_extension = 0.7, mean_extension = 3.0;

/// An active cell near the surface that flows.
struct Flowing
{
  std::size_t a;
  Deviator flow;   ///< in the increment
  double square;   ///< flow : flow
  double residual; ///< component of the residual along the flow, relative to the flow
};

} // namespace

void Body::go_further(const std::vector<double>& residual)
{
  BodyParts& b = parts_;
  if (!b.trial.bears_shear)
    return;
  SurfaceMeans means({b.grid.surface, b.share.count(std::min(SurfaceMeans::layers, b.whole.nz)), b.grid.dz});
  std::vector<Flowing> flowing;
  for (std::size_t a = 0; a < b.trial.active.size(); ++a)
  {
    if (!means.contains(b.trial.active.cell(a)) || b.trial.active.equivalent(a) == 0.0)
      continue;
    const Deviator flow =
        deviator_at(b.state.plastic_strain, b.grid.size(), b.trial.active.cell(a)) - b.trial.active.start(a);
    const double square = contract(flow, flow);
    if (!(square > 0.0))
      continue;
    Deviator cell_residual;
    std::copy_n(residual.begin() + static_cast<std::ptrdiff_t>(a * Deviator::size), Deviator::size,
                cell_residual.v.begin());
    flowing.push_back({a, flow, square, contract(cell_residual, flow) / square});
    b.with_copies(a,
                  [&](std::size_t cell, const auto& seen) { means.set(cell, flowing.back().residual * seen(flow)); });
  }
  means.average();
  for (const Flowing& one : flowing)
  {
    const std::size_t cell = b.trial.active.cell(one.a);
    double share = mean_extension * means.contracted(cell, one.flow) / one.square;
    if (b.layer_of(cell) == 0)
      share += own_extension * one.residual * 2.0 *
               (one.flow[Deviator::yz] * one.flow[Deviator::yz] + one.flow[Deviator::xz] * one.flow[Deviator::xz]) /
               one.square;
    b.trial.active.set_trial(one.a, b.trial.active.trial(one.a) + share * one.flow);
  }
}

void recover_guess(BodyParts& b)
{
  const std::size_t n = b.grid.size();
  b.trial.guessed_cells.clear();
  b.trial.guessed_q.clear();
  for (std::size_t cell = 0; cell < n; ++cell)
  {
    const Deviator q = deviator_at(b.trial.stress, n, cell);
    if (q.v == deviator_at(b.state.stress, n, cell).v)
      continue;
    b.trial.guessed_cells.push_back(cell);
    b.trial.guessed_q.insert(b.trial.guessed_q.end(), q.v.begin(), q.v.end());
  }
}

void store_guess(BodyParts& b)
{
  b.trial.guessed_cells.clear();
  std::vector<std::size_t> places; // index in b.trial.guessed_cells of the first copy of each active cell
  places.reserve(b.trial.active.size());
  for (std::size_t a = 0; a < b.trial.active.size(); ++a)
  {
    places.push_back(b.trial.guessed_cells.size());
    b.with_copies(a, [&](std::size_t cell, const auto& /*seen*/) { b.trial.guessed_cells.push_back(cell); });
  }
  b.trial.guessed_q.resize(Deviator::size * b.trial.guessed_cells.size());
#pragma omp parallel for schedule(static)
  for (std::size_t a = 0; a < places.size(); ++a)
  {
    auto to = b.trial.guessed_q.begin() + static_cast<std::ptrdiff_t>(Deviator::size * places[a]);
    b.with_copies(a,
                  [&](std::size_t cell, const auto& seen)
                  {
                    const Deviator q = seen(b.trial.active.mapped(a));
                    store(q, b.trial.stress, b.grid.size(), cell);
                    to = std::copy(q.v.begin(), q.v.end(), to);
                  });
  }
}

} // namespace brinell::elastoplastic
