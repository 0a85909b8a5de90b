// SPDX-License-Identifier: BSD-3-Clause
#include "window.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace brinell::elastoplastic
{

namespace
{

std::array<std::span<const double>, 3> parts_of(const halfspace::SurfaceLoad& load)
{
  return {load.pressure, load.shear_x, load.shear_y};
}

double value_at(std::span<const double> field, std::size_t cell)
{
  return field.empty() ? 0.0 : field[cell];
}

} // namespace

void copy_load(const halfspace::SurfaceLoad& load, StoredLoad& kept)
{
  const auto parts = parts_of(load);
  for (std::size_t t = 0; t < parts.size(); ++t)
    kept[t].assign(parts[t].begin(), parts[t].end());
}

Window::Window(const VolumeGrid& body, ElasticStack elastic, halfspace::HalfSpace::Ranks ranks)
    : body_(body), all_layers_(body.nz), elastic_(std::move(elastic)), ranks_(std::move(ranks)),
      share_(ranks_->rank(), ranks_->size()), cells_(body), requests_(window_shares.size(), 0.0)
{
  body_.nz = cells_.nz = share_.count(all_layers_);
}

int length_of_window(std::size_t index, int columns)
{
  return 2 * static_cast<int>(std::floor(0.5 * window_shares[index] * columns));
}

std::optional<std::size_t> window_for(int needed, int columns)
{
  constexpr int margin = 2; // columns on either side of the needed ones
  for (std::size_t index = 0; index < window_shares.size(); ++index)
    if (length_of_window(index, columns) >= needed + 2 * margin)
      return index;
  return {};
}

void Window::begin_increment()
{
  has_requested_.fill(false);
}

/// Counts the request of the present increment for a length.
/// @returns the index of the longest length that enough increments have requested
std::optional<std::size_t> Window::length_after_request(std::size_t index)
{
  if (!std::exchange(has_requested_[index], true))
    ++requests_[index];
  for (std::size_t longer = window_shares.size(); longer-- > 0;)
    if (requests_[longer] > requests_without_window)
      return longer;
  return {};
}

bool Window::place(const Columns& needed, const Reference& reference)
{
  const int all = body_.surface.nx;
  const auto wanted = body_.surface.is_periodic_x() ? std::nullopt : window_for(needed.count, all);
  if (!wanted)
    return false;
  const auto length = length_after_request(*wanted);
  if (!length || *length < *wanted)
    return false;
  const int count = length_of_window(*length, all);
  columns_ = {std::clamp(needed.first - (count - needed.count) / 2, 0, all - count), count};
  cells_.surface.nx = count;
  set_reference(reference);
  return true;
}

/// Calls use(start of a row in a deviator field of the body, start of the same row in one of the window) for all independent
/// rows.
template <typename Use>
void Window::for_independent_rows(int layers, const Use& use) const
{
  const int rows = cells_.surface.independent_rows();
#pragma omp parallel for schedule(static)
  for (int plane = 0; plane < Deviator::size * layers; ++plane)
  {
    const int k = plane % layers;
    const auto c = static_cast<std::size_t>(plane / layers);
    for (int j = 0; j < rows; ++j)
      use(c * body_.size() + body_.index(columns_.first, j, k), c * cells_.size() + cells_.index(0, j, k));
  }
}

/// Calls use(start of a row on the surface of the body, start of the same row on that of the window) for all rows.
template <typename Use>
void Window::for_surface_rows(const Use& use) const
{
  for (int j = 0; j < cells_.surface.ny; ++j)
    use(body_.surface.index(columns_.first, j), cells_.surface.index(0, j));
}

void Window::set_reference(const Reference& reference)
{
  const auto count = static_cast<std::size_t>(columns_.count);
  stress_.resize(Deviator::size * cells_.size());
  stress_change_.resize(stress_.size());
  strain_change_.assign(stress_.size(), 0.0);
  for_independent_rows(body_.nz,
                       [&](std::size_t in_body, std::size_t in_window)
                       {
                         for (std::size_t i = 0; i < count; ++i)
                           stress_[in_window + i] =
                               reference.stress[in_body + i] - value_at(reference.thermal_stress, in_body + i);
                       });
  for (std::size_t t = 0; t < displacement_.size(); ++t)
  {
    const std::span<const double> field = reference.displacement[t];
    displacement_[t].assign(field.empty() ? 0 : cells_.surface.size(), 0.0);
    displacement_change_[t] = displacement_[t];
    if (!field.empty())
      for_surface_rows([&](std::size_t from, std::size_t to)
                       { std::copy_n(field.data() + from, count, displacement_[t].data() + to); });
  }
  load_ = *reference.load;
}

bool Window::is_at_end(int column) const
{
  const int last = columns_.first + columns_.count - 1;
  return (column <= columns_.first && columns_.first > 0) || (column >= last && last + 1 < body_.surface.nx);
}

bool Window::holds(const halfspace::SurfaceLoad& load) const
{
  const SurfaceGrid& s = body_.surface;
  const auto parts = parts_of(load);
  const auto agree = [&](std::size_t t, int first, int last, int row)
  {
    for (int i = first; i < last; ++i)
      if (const std::size_t cell = s.index(i, row); value_at(parts[t], cell) != value_at(load_[t], cell))
        return false;
    return true;
  };
  for (std::size_t t = 0; t < parts.size(); ++t)
    for (int j = 0; j < s.ny && !(parts[t].empty() && load_[t].empty()); ++j)
      if (!agree(t, 0, columns_.first, j) || !agree(t, columns_.first + columns_.count, s.nx, j))
        return false;
  return true;
}

Window::Part& Window::operators()
{
  if (!part_ || part_->half_space.grid().surface.nx != columns_.count)
  {
    loaded_.reset();
    part_.reset(); // before the longer one takes memory
    halfspace::HalfSpace half_space({cells_.surface, all_layers_, cells_.dz}, elastic_, body_.surface, ranks_);
    halfspace::HalfSpace::Work work = half_space.make_guest();
    part_ = std::make_unique<Part>(Part{std::move(half_space), std::move(work)});
  }
  return *part_;
}

/// Updates the change of the strain since the reference, which vanishes outside the active cells.
void Window::find_strain_change(std::span<const double> strain, const ActiveCells& active)
{
  const auto columns = static_cast<std::size_t>(body_.surface.nx);
  const auto count = static_cast<std::size_t>(columns_.count), first = static_cast<std::size_t>(columns_.first);
#pragma omp parallel for schedule(static)
  for (std::size_t a = 0; a < active.size(); ++a)
  {
    const std::size_t cell = active.cell(a), row = cell / columns, column = cell % columns;
    store(deviator_at(strain, body_.size(), cell) - active.start(a), strain_change_, cells_.size(),
          row * count + column - first);
  }
}

void Window::load(std::span<const double> strain, const ActiveCells& active, int layers,
                  halfspace::Displacements displacements, const std::array<std::span<double>, 3>& displacement,
                  halfspace::HalfSpace::Work& host)
{
  layers_ = layers;
  const auto count = static_cast<std::size_t>(columns_.count);
  find_strain_change(strain, active);
  Part& part = operators();
  halfspace::HalfSpace::exchange_buffers(part.work, host);
  loaded_.emplace(part.half_space.load(strain_change_, layers, part.work, displacements));
  std::array<std::span<double>, 3> wanted;
  for (std::size_t t = 0; t < wanted.size(); ++t)
    if (!displacement[t].empty())
      wanted[t] = displacement_change_[t];
  loaded_->displacement({.z = wanted[0], .x = wanted[1], .y = wanted[2]});
  halfspace::HalfSpace::exchange_buffers(part.work, host);
  for (std::size_t t = 0; t < wanted.size(); ++t)
    for_surface_rows(
        [&](std::size_t to, std::size_t from)
        {
          for (std::size_t i = 0; i < (wanted[t].empty() ? 0 : count); ++i)
            displacement[t][to + i] = displacement_[t][from + i] + displacement_change_[t][from + i];
        });
}

void Window::stress(const halfspace::SurfaceLoad& load, std::span<const double> thermal_stress,
                    std::span<double> stress, halfspace::HalfSpace::Work& host)
{
  const auto count = static_cast<std::size_t>(columns_.count);
  const auto parts = parts_of(load);
  for (std::size_t t = 0; t < parts.size(); ++t)
  {
    load_change_[t].assign(parts[t].empty() && load_[t].empty() ? 0 : cells_.surface.size(), 0.0);
    for_surface_rows(
        [&](std::size_t from, std::size_t to)
        {
          for (std::size_t i = 0; i < (load_change_[t].empty() ? 0 : count); ++i)
            load_change_[t][to + i] = value_at(parts[t], from + i) - value_at(load_[t], from + i);
        });
  }
  Part& part = operators();
  halfspace::HalfSpace::exchange_buffers(part.work, host);
  loaded_->stress({.pressure = load_change_[0], .shear_x = load_change_[1], .shear_y = load_change_[2]},
                  stress_change_);
  halfspace::HalfSpace::exchange_buffers(part.work, host);
  for_independent_rows(share_.count(layers_),
                       [&](std::size_t in_body, std::size_t in_window)
                       {
                         for (std::size_t i = 0; i < count; ++i)
                           stress[in_body + i] = stress_[in_window + i] + stress_change_[in_window + i] +
                                                 value_at(thermal_stress, in_body + i);
                       });
}

} // namespace brinell::elastoplastic
