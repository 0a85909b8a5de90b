// SPDX-License-Identifier: BSD-3-Clause
#include "plastic_heat.hpp"

#include "brinell/foundation/error.hpp"
#include "foundation/sharing.hpp"
#include "heated_body.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::elastoplastic
{

namespace
{

/// `to` += `factor` times a field, layer by layer, moved along x by a number of columns; values that leave an open grid are
/// dropped.
void add_moved(const SurfaceGrid& grid, std::span<const double> field, double columns, double factor,
               std::vector<double>& to)
{
  const int whole = static_cast<int>(std::floor(columns));
  const double fraction = columns - whole;
  for (std::size_t row = 0; row < field.size(); row += static_cast<std::size_t>(grid.nx))
    for (int i = 0; i < grid.nx; ++i)
    {
      const double value = factor * field[row + static_cast<std::size_t>(i)];
      if (value == 0.0)
        continue;
      for (const auto& [column, share] : {std::pair{i + whole, 1.0 - fraction}, {i + whole + 1, fraction}})
      {
        const int at = grid.is_periodic_x() ? (column % grid.nx + grid.nx) % grid.nx : column;
        if (at >= 0 && at < grid.nx)
          to[row + static_cast<std::size_t>(at)] += share * value;
      }
    }
}

} // namespace

std::vector<double> PlasticHeat::source(double columns, double duration)
{
  expected_.assign(state_.last.size(), 0.0);
  // A longer step, such as the way back to the next pass, does not imply more plastic work: no scaling up.
  add_moved(grid_, state_.last, columns, state_.duration > 0.0 ? std::min(1.0, duration / state_.duration) : 0.0,
            expected_);
  std::vector<double> all(std::max(expected_.size(), state_.pending.size()), 0.0);
  for (const std::vector<double>* part : {&expected_, &state_.pending})
    for (std::size_t i = 0; i < part->size(); ++i)
      all[i] += (*part)[i];
  return all;
}

/// Transfers the work from the material grid to the thermal grid.
std::vector<double> PlasticHeat::fitted(std::span<const double> work, const VolumeGrid& body) const
{
  const std::size_t cells = grid_.size(), of_body = body.surface.size();
  std::vector<double> heat(static_cast<std::size_t>(body.nz) * cells);
  for (std::size_t k = 0; k < static_cast<std::size_t>(body.nz); ++k)
    fit(body.surface, work.subspan(k * of_body, of_body), grid_, std::span(heat).subspan(k * cells, cells));
  return heat;
}

void PlasticHeat::require_room(std::span<const double> work, const VolumeGrid& body) const
{
  if (body.surface.nx <= grid_.nx && body.surface.ny <= grid_.ny)
    return;
  const double all = sum(work), kept = sum(fitted(work, body));
  if (constexpr double rounding = 1e-9; std::abs(all - kept) > rounding * all)
    throw GridError(
        "the plastic zone has grown beyond the grid on which the heat of a body is kept, and the heat of its "
        "plastic work would be lost");
}

void PlasticHeat::settle(std::span<const double> work, const VolumeGrid& body, double duration)
{
  std::vector<double> heat = fitted(work, body);
  const double kept = sum(heat);
  for (double& value : heat)
    value *= share_;
  state_.total += share_ * kept * body.cell_volume();
  if (duration > 0.0)
  {
    state_.pending.assign(std::max(heat.size(), expected_.size()), 0.0);
    for (std::size_t i = 0; i < expected_.size(); ++i)
      state_.pending[i] -= expected_[i];
    state_.last = heat;
    state_.duration = duration;
  }
  state_.pending.resize(std::max(heat.size(), state_.pending.size()), 0.0);
  for (std::size_t i = 0; i < heat.size(); ++i)
    state_.pending[i] += heat[i];
}

void PlasticHeat::exchange(Archive& archive)
{
  exchange_members(archive, state_);
  for (const std::vector<double>* field : {&state_.last, &state_.pending})
    if (field->size() % grid_.size() != 0)
      throw InputError("the stored heat of plastic work is on another grid");
}

} // namespace brinell::elastoplastic
