// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/body.hpp"
#include "foundation/sharing.hpp"
#include "window.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

/// Evaluations that are restricted to a window: docs/theory/elastoplastic.md (windows).
namespace brinell::elastoplastic
{

namespace
{

/// Smallest range of columns that contains all added columns.
struct Extent
{
  int first, last;

  void add(int column)
  {
    first = std::min(first, column);
    last = std::max(last, column);
  }
};

} // namespace

/// Columns in which the increment changes strain or load.
Columns Body::affected_columns(const std::array<std::vector<double>, 3>& load, int shift) const
{
  const SurfaceGrid& s = grid().surface;
  const auto nx = static_cast<std::size_t>(s.nx);
  Extent extent{s.nx, -1};
  for (const std::size_t cell : active_.cells())
    extent.add(static_cast<int>(cell % nx));
  for (const std::vector<double>& part : load)
    for (std::size_t cell = 0; cell < part.size(); ++cell)
      if (part[cell] != 0.0)
      {
        const int column = static_cast<int>(cell % nx);
        extent.add(column);
        extent.add(std::clamp(column + shift, 0, s.nx - 1));
      }
  return {extent.first, extent.last + 1 - extent.first};
}

/// Places the window of the next evaluation, around what changes since the state before the increment. An increment has
/// one window: where a closing evaluation does not end it, its rest is as small as the error of a window.
void Body::choose_window()
{
  const bool is_whole = std::exchange(wants_all_cells_, false);
  if (!window_ || is_whole || windowed_ || !may_use_window_ || active_.empty())
    return;
  windowed_ = window_->place(
      affected_columns(committed_load_, shift_),
      {.stress = state_.stress,
       .thermal_stress = state_.thermal_stress,
       .displacement = {displacement_, displacement_y_.empty() ? std::span<const double>() : displacement_x_,
                        displacement_y_},
       .load = &committed_load_});
  if (windowed_)
    restrict_to_active_layers();
}

/// Transforms the plastic strain of the trial and computes the residual displacement.
void Body::load_strain()
{
  const halfspace::Displacements wanted = displacements_per_evaluation();
  if (windowed_)
  {
    const bool all = wanted == halfspace::Displacements::all;
    window_->load(state_.plastic_strain, active_, layers_, wanted,
                  {displacement_, all ? std::span(displacement_x_) : std::span<double>(),
                   all ? std::span(displacement_y_) : std::span<double>()},
                  work_);
    knows_displacement_x_ = all;
    return;
  }
  const bool with_trace = !watched_.empty() && computes_all_layers();
  loaded_.emplace(half_space_->load(state_.plastic_strain, layers_, work_, wanted, symmetry_, with_trace));
  find_displacements(wanted);
}

/// Largest change of the displacement [m]. When all cells are computed again after evaluations of a window, the displacement
/// outside the window changes for this reason alone, and only the columns of the window measure the progress of the iteration.
double Body::change_of_displacement(const std::vector<double>& before) const
{
  const SurfaceGrid& s = grid().surface;
  const Columns columns = was_windowed_ && !windowed_ ? window_->columns() : Columns{0, s.nx};
  double change = 0.0;
  for (int j = 0; j < s.ny; ++j)
    for (int i = columns.first; i < columns.first + columns.count; ++i)
      change = larger(change, std::abs(displacement_[s.index(i, j)] - before[s.index(i, j)]));
  return change;
}

/// Computes the stress for the transformed strain and a load.
void Body::find_stress(const halfspace::SurfaceLoad& load)
{
  if (windowed_ && !window_->holds(load))
  {
    compute_all_layers();
    wants_all_cells_ = was_windowed_ = false;
    load_strain();
  }
  if (windowed_)
  {
    window_->stress(load, thermal_stress(), stress_, work_);
    return;
  }
  loaded_->stress(load, stress_);
  if (!watched_.empty() && computes_all_layers())
    find_watched_traces(load);
  const int rows = independent_rows(grid().surface, symmetry_);
  add_initial_stress(layers_, rows, stress_);
  add_thermal_stress(layers_, rows, stress_);
  may_use_window_ = false;
}

/// Extends the computed layers after the active cells from `first` on have been added; leaves the window if they reach its end.
void Body::include_new_cells(std::size_t first)
{
  const auto nx = static_cast<std::size_t>(grid().surface.nx);
  restrict_to_active_layers();
  for (std::size_t a = first; windowed_ && a < active_.size(); ++a)
    if (window_->is_at_end(static_cast<int>(active_.cell(a) % nx)))
      compute_all_layers();
}

/// Columns in which evaluations look for new active cells.
Columns Body::searched_columns() const
{
  return windowed_ ? window_->columns() : Columns{0, grid().surface.nx};
}

double Body::cost() const
{
  return is_plastic() ? static_cast<double>(layers_) * searched_columns().count * grid().surface.ny : 0.0;
}

} // namespace brinell::elastoplastic
