// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation.hpp"

#include "foundation/sharing.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace brinell::elastoplastic
{

namespace
{

using halfspace::Displacements;

/// Layers computed below the deepest active cell, so that cells yielding there are found at once and not only by the closing
/// evaluation.
constexpr int spare_layers = 1;

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

/// Residual displacements of a state along z, x, y.
template <typename State>
auto displacements_of(State& state)
{
  return std::array{&state.residual_displacement, &state.residual_displacement_x, &state.residual_displacement_y};
}

/// Columns in which an increment changes strain or load.
/// @param load   before the increment
/// @param shift  by which the contact moves in the increment [cells]
Columns affected_columns(const SurfaceGrid& s, const ActiveCells& active, const StoredLoad& load, int shift,
                         const Communicator& ranks)
{
  const auto nx = static_cast<std::size_t>(s.nx);
  Extent extent{s.nx, -1};
  for (const std::size_t cell : active.cells())
    extent.add(static_cast<int>(cell % nx));
  for (const std::vector<double>& part : load)
    for (std::size_t cell = 0; cell < part.size(); ++cell)
      if (part[cell] != 0.0)
      {
        const int column = static_cast<int>(cell % nx);
        extent.add(column);
        extent.add(std::clamp(column + shift, 0, s.nx - 1));
      }
  extent.add(static_cast<int>(ranks.largest(extent.last)));
  extent.first = -static_cast<int>(ranks.largest(-extent.first));
  return {extent.first, extent.last + 1 - extent.first};
}

void add_thermal_stress(const VolumeGrid& grid, std::span<const double> thermal, int layers, int rows,
                        std::span<double> stress)
{
  if (thermal.empty())
    return;
  for (std::size_t component = 0; component < Deviator::size; ++component)
    for (int layer = 0; layer < layers; ++layer)
    {
      const std::size_t first = component * grid.size() + grid.index(0, 0, layer);
      for (std::size_t cell = first; cell < first + grid.surface.index(0, rows); ++cell)
        stress[cell] += thermal[cell];
    }
}

} // namespace

Evaluation::Evaluation(const VolumeGrid& grid, std::shared_ptr<const halfspace::HalfSpace> half_space,
                       const constitutive::Material& material, const BodySettings& settings)
    : grid_(grid), half_space_(std::move(half_space)), share_(half_space_ ? half_space_->share() : Share()),
      own_(half_space_ ? half_space_->own_grid() : grid), is_plastic_(material.is_plastic()),
      shortcuts_(settings.shortcuts), is_on_device_(settings.device != nullptr),
      initial_stress_(own_, material, share_), layers_(grid.nz), watched_(grid)
{
  displacement_[0].assign(grid_.surface.size(), 0.0);
  if (is_plastic_ && settings.displacements != Displacements::normal)
    displacement_[1] = displacement_[0];
  if (is_plastic_ && settings.displacements == Displacements::all)
    displacement_[2] = displacement_[0];
  if (!settings.inclusions.empty())
    embedded_ = std::make_unique<Embedded>(
        *half_space_, std::vector<halfspace::Inclusion>(settings.inclusions.begin(), settings.inclusions.end()),
        static_cast<std::size_t>(std::count_if(displacement_.begin(), displacement_.end(),
                                               [](const auto& component) { return !component.empty(); })));
  else if (is_plastic_ && shortcuts_ && settings.windows)
    window_ = std::make_unique<Window>(grid_, material.stack(), half_space_->shared_ranks());
}

void Evaluation::begin(int shift)
{
  layers_ = grid_.nz;
  windowed_ = was_windowed_ = wants_all_cells_ = false;
  may_use_window_ = true;
  if (window_)
    window_->begin_increment();
  shift_ = shift;
}

void Evaluation::require(Scope scope)
{
  if (scope == Scope::all)
    layers_ = grid_.nz;
  if (scope == Scope::near)
    return;
  windowed_ = false;
  wants_all_cells_ = true;
}

Scope Evaluation::scope() const
{
  return was_windowed_ ? Scope::near : layers_ == grid_.nz ? Scope::all : Scope::all_columns;
}

/// Leaves the window if new cells reach its end.
void Evaluation::follow(const ActiveCells& active, std::size_t first)
{
  const auto nx = static_cast<std::size_t>(grid_.surface.nx);
  const int own_deepest = active.empty() ? 0 : share_.layer(static_cast<int>(layer_of(active.deepest())));
  follow(is_plastic_ ? static_cast<int>(ranks().largest(own_deepest)) : 0);
  if (!windowed_)
    return;
  bool is_at_end = false;
  for (std::size_t a = first; a < active.size(); ++a)
    is_at_end = is_at_end || window_->is_at_end(static_cast<int>(active.cell(a) % nx));
  if (ranks().any(is_at_end))
    require(Scope::all);
}

void Evaluation::follow(int deepest)
{
  layers_ = shortcuts_ ? std::min(grid_.nz, deepest + 1 + spare_layers) : grid_.nz;
  if (embedded_)
    layers_ = std::max(layers_, embedded_->layers());
}

double Evaluation::load(const BodyState& state, const ActiveCells& active)
{
  prepare_work();
  strain_ = state.plastic_strain;
  choose_window(state, active);
  const std::vector<double> before = displacement_[0];
  if (windowed_)
  {
    std::array<std::span<double>, 3> out{displacement_[0]};
    knows_displacement_x_ = wanted() == Displacements::all;
    if (knows_displacement_x_)
      out = {displacement_[0], displacement_[1], displacement_[2]};
    window_->load(strain_, active, layers_, wanted(), out, work_);
  }
  else
    load_strain();
  const double change = larger(change_since(before), embedded_ ? embedded_->error() : 0.0);
  was_windowed_ = windowed_;
  return change;
}

double Evaluation::load_on(BodyOnDevice& device, Integration integration)
{
  const std::vector<double> before = displacement_[0];
  const Displacements components = wanted();
  knows_displacement_x_ = components != Displacements::normal;
  device.integrate(integration,
                   {displacement_[0], knows_displacement_x_ ? std::span<double>(displacement_[1]) : std::span<double>(),
                    components == Displacements::all ? std::span<double>(displacement_[2]) : std::span<double>()});
  return change_since(before);
}

/// Places the window of the next evaluation, around what changes since the state before the increment. An increment has
/// one window: where a closing evaluation does not end it, its rest is as small as the error of a window.
void Evaluation::choose_window(const BodyState& state, const ActiveCells& active)
{
  const bool is_whole = std::exchange(wants_all_cells_, false);
  if (!window_ || is_whole || windowed_ || !may_use_window_ || !ranks().any(!active.empty()))
    return;
  const bool along = wanted() == Displacements::all;
  windowed_ = window_->place(
      affected_columns(grid_.surface, active, committed_load_, shift_, ranks()),
      {.stress = state.stress,
       .thermal_stress = state.thermal_stress,
       .displacement = {displacement_[0], along ? displacement_[1] : std::span<const double>(), displacement_[2]},
       .load = &committed_load_});
  if (windowed_)
    follow(active, active.size());
}

/// Components of the displacement that an evaluation computes: the normal one, on which the gap depends, and all three where the
/// shear depends on them. Otherwise the one along x is needed only after the last evaluation of an increment, which computes all
/// layers.
Displacements Evaluation::wanted() const
{
  if (!displacement_[2].empty())
    return Displacements::all;
  return !displacement_[1].empty() && is_whole() ? Displacements::along_x : Displacements::normal;
}

/// Transforms the strain of the trial in all columns, and computes the displacement.
void Evaluation::load_strain()
{
  const bool with_trace = embedded_ || ((keeps_trace_ || !watched_.empty()) && is_whole());
  loaded_.emplace(half_space_->load(strain_, layers_, work_, wanted(), with_trace));
  find_displacements(wanted());
}

void Evaluation::find_displacements(Displacements wanted)
{
  halfspace::SurfaceDisplacement found{.z = displacement_[0], .x = {}, .y = {}};
  if (wanted != Displacements::normal)
    found.x = displacement_[1];
  if (wanted == Displacements::all)
    found.y = displacement_[2];
  loaded_->displacement(found);
  for (std::size_t axis = 0; embedded_ && axis < displacement_.size(); ++axis)
    if (const std::array parts{found.z, found.x, found.y}; !parts[axis].empty())
      embedded_->add_displacement(axis, parts[axis]);
  knows_displacement_x_ = wanted != Displacements::normal;
}

/// Stress and normal displacement of the strain are known already, so that no layer (0) is requested.
void Evaluation::find_displacement_x(std::span<const double> strain, BodyOnDevice* device)
{
  if (displacement_[1].empty() || knows_displacement_x_)
    return;
  if (device != nullptr)
  {
    device->find_displacement_x(displacement_[1]);
    knows_displacement_x_ = true;
    return;
  }
  prepare_work();
  loaded_.reset();
  half_space_->load(strain, 0, work_, Displacements::along_x).displacement({.x = displacement_[1]});
  if (embedded_)
    embedded_->add_displacement(1, displacement_[1]);
  knows_displacement_x_ = true;
}

/// Largest change of the displacement [m]. When all cells are computed again after evaluations of a window, the displacement
/// outside the window changes for this reason alone, and only the columns of the window measure the progress of the iteration.
double Evaluation::change_since(const std::vector<double>& before) const
{
  const SurfaceGrid& s = grid_.surface;
  const Columns columns = was_windowed_ && !windowed_ ? window_->columns() : Columns{0, s.nx};
  double change = 0.0;
  for (int j = 0; j < s.ny; ++j)
    for (int i = columns.first; i < columns.first + columns.count; ++i)
      change = larger(change, std::abs(displacement_[0][s.index(i, j)] - before[s.index(i, j)]));
  return change;
}

void Evaluation::prepare_work()
{
  if (work_.empty())
    work_ = half_space_->make_work();
}

void Evaluation::stress(const halfspace::SurfaceLoad& load, std::span<const double> thermal, std::span<double> stress)
{
  if (windowed_ && !window_->holds(load))
  {
    require(Scope::all);
    wants_all_cells_ = was_windowed_ = false;
    load_strain();
  }
  if (windowed_)
    return window_->stress(load, thermal, stress, work_);
  loaded_->stress(load, stress);
  if (embedded_)
    embedded_->update(*loaded_, load, layers_, stress);
  if (!watched_.empty() && is_whole())
    watched_.find_traces(*loaded_, load);
  const int rows = grid_.surface.independent_rows();
  initial_stress_.add_to(stress, share_.count(layers_), rows);
  add_thermal_stress(own_, thermal, share_.count(layers_), rows, stress);
  may_use_window_ = false;
}

void Evaluation::compute_anew(const BodyState& state, const halfspace::SurfaceLoad& load, std::span<double> stress)
{
  work_ = half_space_->make_work();
  const Displacements all = wanted();
  loaded_.emplace(half_space_->load(state.plastic_strain, grid_.nz, work_, all, embedded_ != nullptr));
  loaded_->stress(load, stress);
  if (embedded_)
    embedded_->update(*loaded_, load, grid_.nz, stress);
  find_displacements(all);
  initial_stress_.add_to(stress, own_.nz, own_.surface.ny);
  add_thermal_stress(own_, state.thermal_stress, own_.nz, own_.surface.ny, stress);
  commit(load);
}

void Evaluation::restore(const BodyState& state)
{
  watched_.forget_traces();
  if (embedded_)
    embedded_->restore();
  const auto fields = displacements_of(state);
  for (std::size_t axis = 0; axis < fields.size(); ++axis)
    displacement_[axis] = *fields[axis];
}

void Evaluation::store(BodyState& state) const
{
  const auto fields = displacements_of(state);
  for (std::size_t axis = 0; axis < fields.size(); ++axis)
    *fields[axis] = displacement_[axis];
}

void Evaluation::commit(const halfspace::SurfaceLoad& load)
{
  if (embedded_)
    embedded_->commit();
  if (window_)
    copy_load(load, committed_load_);
}

void Evaluation::exchange(Archive& archive)
{
  if (embedded_)
    archive("inclusions", *embedded_);
  if (!window_)
    return;
  for (std::size_t part = 0; part < committed_load_.size(); ++part)
    archive.list(fmt::format("load_{}", part), committed_load_[part]);
  archive("window_wishes", window_->requests());
}

void Evaluation::full_stress(const halfspace::SurfaceLoad& load, std::span<const double> strain,
                             std::span<double> deviator, std::span<double> trace, int layers)
{
  if (!is_plastic_ || work_.empty())
    work_ = half_space_->make_work();
  half_space_->full_stress(load, strain, work_, deviator, trace, layers);
  if (embedded_)
    embedded_->add_stress(std::min(layers, grid_.nz), deviator, trace);
  initial_stress_.add_to(deviator, own_.nz, own_.surface.ny);
  for (std::size_t i = 0; i < trace.size(); ++i)
    trace[i] += 2.0 * initial_stress_.at(layer_of(i));
  if (!is_plastic_)
    work_ = {}; // an elastic body needs it for output only
}

} // namespace brinell::elastoplastic
