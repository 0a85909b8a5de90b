// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/body.hpp"
#include "foundation/sharing.hpp"
#include "window.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

/// When evaluations are those of a window: docs/theory/elastoplastic.md (windows).
namespace brinell::elastoplastic
{

namespace
{

/// The columns that hold all that has been added.
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

/// The columns in which something will change in the increment.
Columns Body::columns_at_work(const std::array<std::vector<double>, 3>& load, int shift) const
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

/// The window of the next evaluation. To be called while the plastic strain is still that of the last one.
void Body::choose_window()
{
  const bool is_whole = std::exchange(wants_whole_, false);
  if (!window_ || is_whole || windowed_ || reference_ == Known::nothing || active_.empty())
    return;
  const bool is_state = reference_ == Known::state;
  const auto& load = is_state ? committed_load_ : load_;
  windowed_ = window_->place(
      columns_at_work(load, is_state ? shift_ : 0),
      {.strain = state_.plastic_strain,
       .stress = is_state ? state_.stress : stress_,
       .thermal_stress = is_state ? state_.thermal_stress : thermal_stress_,
       .displacement = {displacement_, displacement_y_.empty() ? std::span<const double>() : displacement_x_,
                        displacement_y_},
       .load = &load});
  if (windowed_)
    keep_active_layers();
}

/// Loads the strain of the trial.
void Body::load_strain()
{
  const halfspace::Displacements wanted = found_at_once();
  if (windowed_)
  {
    const bool all = wanted == halfspace::Displacements::all;
    window_->load(state_.plastic_strain, layers_, wanted,
                  {displacement_, all ? std::span(displacement_x_) : std::span<double>(),
                   all ? std::span(displacement_y_) : std::span<double>()},
                  work_);
    knows_displacement_x_ = all;
    return;
  }
  loaded_.emplace(half_space_->load(state_.plastic_strain, layers_, work_, wanted, symmetry_));
  find_displacements(wanted);
}

/// Beside the window the displacement changes when the whole is computed again: that tells nothing of the iteration.
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

/// Stress of the strain loaded, under a load.
void Body::find_stress(const halfspace::SurfaceLoad& load)
{
  if (windowed_ && !window_->holds(load))
  {
    compute_all_layers();
    wants_whole_ = was_windowed_ = false;
    load_strain();
  }
  if (windowed_)
  {
    window_->stress(load, thermal_stress_, stress_, work_);
    return;
  }
  loaded_->stress(load, stress_);
  const int rows = independent_rows(grid().surface, symmetry_);
  add_initial_stress(layers_, rows, stress_);
  add_thermal_stress(layers_, rows, stress_);
  reference_ = layers_ == grid().nz ? Known::evaluation : Known::nothing;
  if (window_ && reference_ == Known::evaluation)
    keep(load, load_);
}

/// After cells have joined: those from `first` on.
void Body::widen(std::size_t first)
{
  const auto nx = static_cast<std::size_t>(grid().surface.nx);
  keep_active_layers();
  for (std::size_t a = first; windowed_ && a < active_.size(); ++a)
    if (window_->is_at_end(static_cast<int>(active_.cell(a) % nx)))
      compute_all_layers();
}

/// The columns among which evaluations look for new active cells.
Columns Body::searched() const
{
  return windowed_ ? window_->columns() : Columns{0, grid().surface.nx};
}

} // namespace brinell::elastoplastic
