// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation.hpp"

#include <algorithm>
#include <iterator>

/// Stress in single cells. The deviator is part of the state; the trace, which plasticity does not need, is computed
/// along with the evaluations of all cells, in the layers of cells that have been asked for before.
namespace brinell::elastoplastic
{

namespace
{

/// The cell of the independent rows that has the same trace as a cell.
std::size_t independent_cell(const SurfaceGrid& surface, std::size_t cell)
{
  const auto nx = static_cast<std::size_t>(surface.nx), row = cell / nx;
  if (static_cast<int>(row) < surface.independent_rows())
    return cell;
  return (static_cast<std::size_t>(surface.ny) - 1 - row) * nx + cell % nx;
}

} // namespace

/// Computes the traces in the watched cells; to be called after the stress of an evaluation of all cells.
void Evaluation::find_traces(const halfspace::SurfaceLoad& load)
{
  const SurfaceGrid& surface = grid_.surface;
  std::vector<double> layer(surface.size());
  std::size_t known = grid_.size();
  watched_trace_.resize(watched_.size());
  for (std::size_t n = 0; n < watched_.size(); ++n) // in the order of the layers
  {
    if (const std::size_t wanted = layer_of(watched_[n]); wanted != known)
    {
      loaded_->trace(load, static_cast<int>(wanted), layer);
      known = wanted;
    }
    watched_trace_[n] = layer[independent_cell(surface, watched_[n] % surface.size())];
  }
  knows_traces_ = true;
}

/// Whether the traces in some cells are known. If not, they will be from the next increment on.
bool Evaluation::watches(std::span<const std::size_t> cells)
{
  const auto is_watched = [&](std::size_t cell) { return std::ranges::binary_search(watched_, cell); };
  if (std::ranges::all_of(cells, is_watched))
    return knows_traces_;
  watched_.insert(watched_.end(), cells.begin(), cells.end());
  std::ranges::sort(watched_);
  watched_.erase(std::unique(watched_.begin(), watched_.end()), watched_.end());
  knows_traces_ = false;
  return false;
}

std::vector<Body::CellStress> Evaluation::stress_at(std::span<const std::size_t> cells,
                                                    const halfspace::SurfaceLoad& load, const BodyState& state)
{
  if (!is_plastic_)
    return elastic_stress_at(cells, load);
  const std::size_t n = grid_.size();
  std::vector<Body::CellStress> result;
  if (!watches(cells))
  {
    std::vector<double> deviator(Deviator::size * n), trace(n);
    full_stress(load, state.plastic_strain, deviator, trace,
                static_cast<int>(layer_of(*std::ranges::max_element(cells))) + 1);
    for (const std::size_t cell : cells)
      result.push_back({deviator_at(deviator, n, cell), trace[cell]});
    return result;
  }
  for (const std::size_t cell : cells)
  {
    Deviator deviator = deviator_at(state.stress, n, cell);
    if (!state.thermal_stress.empty())
      deviator = deviator - deviator_at(state.thermal_stress, n, cell);
    const auto place = std::ranges::lower_bound(watched_, cell) - watched_.begin();
    result.push_back(
        {deviator, 2.0 * initial_stress(layer_of(cell)) + watched_trace_[static_cast<std::size_t>(place)]});
  }
  return result;
}

/// Stress of the load and the initial stress, layer by layer.
std::vector<Body::CellStress> Evaluation::elastic_stress_at(std::span<const std::size_t> cells,
                                                            const halfspace::SurfaceLoad& load)
{
  const std::size_t plane = grid_.surface.size();
  std::vector<double> stress((Deviator::size + 1) * plane);
  std::vector<Body::CellStress> result(cells.size());
  if (work_.empty())
    work_ = half_space_->make_guest();
  std::size_t known = grid_.size();
  for (std::size_t n = 0; n < cells.size(); ++n)
  {
    const std::size_t layer = layer_of(cells[n]), at = cells[n] % plane;
    if (layer != known)
      half_space_->stress_of_load(load, static_cast<int>(layer), work_, stress);
    known = layer;
    const double initial = initial_stress_[layer];
    Body::CellStress& found = result[n];
    for (int c = 0; c < Deviator::size; ++c)
      found.deviator[c] = stress[static_cast<std::size_t>(c) * plane + at] +
                          (c == Deviator::xx || c == Deviator::yy ? initial / 3.0 : 0.0);
    found.trace = stress[Deviator::size * plane + at] + 2.0 * initial;
  }
  return result;
}

} // namespace brinell::elastoplastic
