// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation.hpp"

#include <algorithm>

/// Stress in single cells. The deviator is part of the state; the trace is that of the watched cells.
namespace brinell::elastoplastic
{

std::vector<Body::CellStress> Evaluation::stress_at(std::span<const std::size_t> cells,
                                                    const halfspace::SurfaceLoad& load, const BodyState& state)
{
  if (!is_plastic_)
    return elastic_stress_at(cells, load);
  const std::size_t n = grid_.size();
  std::vector<Body::CellStress> result;
  if (embedded_ || is_on_device_ || !watched_.watch(cells))
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
    result.push_back({deviator, 2.0 * initial_stress_.at(layer_of(cell)) + watched_.trace(cell)});
  }
  return result;
}

void Evaluation::for_layers(const halfspace::SurfaceLoad& load, const BodyState& state, const Body::UseLayer& use)
{
  const std::size_t plane = grid_.surface.size(), n = grid_.size();
  if (!is_plastic_)
  {
    if (work_.empty())
      work_ = half_space_->make_guest();
    return half_space_->stress_of_load(
        load, work_,
        [&](int layer, std::span<const double> stress)
        {
          const double initial = initial_stress_.at(static_cast<std::size_t>(layer));
          use(layer, {stress.data(), plane, stress.data() + Deviator::size * plane, initial / 3.0, 2.0 * initial});
        });
  }
  std::vector<double> deviator;
  layer_trace_.resize(n);
  const double* of_state = state.stress.data();
  const bool is_known = !embedded_ && loaded_ && loaded_->has_trace();
  if (is_known)
    loaded_->traces(load, layer_trace_);
  else
  {
    deviator.resize(Deviator::size * n);
    full_stress(load, state.plastic_strain, deviator, layer_trace_, grid_.nz);
    for (std::size_t i = 0; i < state.thermal_stress.size(); ++i)
      deviator[i] += state.thermal_stress[i];
    of_state = deviator.data();
  }
#pragma omp parallel for schedule(static)
  for (int layer = 0; layer < grid_.nz; ++layer)
  {
    const std::size_t first = static_cast<std::size_t>(layer) * plane;
    const double initial = is_known ? 2.0 * initial_stress_.at(static_cast<std::size_t>(layer)) : 0.0;
    use(layer, {of_state + first, n, layer_trace_.data() + first, 0.0, initial});
  }
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
    const double initial = initial_stress_.at(layer);
    Body::CellStress& found = result[n];
    for (int c = 0; c < Deviator::size; ++c)
      found.deviator[c] = stress[static_cast<std::size_t>(c) * plane + at] +
                          (c == Deviator::xx || c == Deviator::yy ? initial / 3.0 : 0.0);
    found.trace = stress[Deviator::size * plane + at] + 2.0 * initial;
  }
  return result;
}

} // namespace brinell::elastoplastic
