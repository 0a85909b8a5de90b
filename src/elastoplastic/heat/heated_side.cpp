// SPDX-License-Identifier: BSD-3-Clause
#include "heated_side.hpp"

#include "brinell/foundation/embedding.hpp"
#include "brinell/foundation/error.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace brinell::elastoplastic
{

namespace
{

SurfaceGrid with_rows_of(SurfaceGrid grid, const SurfaceGrid& other)
{
  grid.ny = other.ny;
  return grid;
}

/// Rounds to 10 digits, so that steps that differ only by rounding share one response, whichever of them comes first.
double without_rounding(double value)
{
  if (value == 0.0)
    return 0.0;
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 9.0);
  return std::round(value / unit) * unit;
}

/// Place of the contact grid on the thermal grid, from that on the material grid.
Place on_thermal_grid(const SurfaceGrid& heat, const SurfaceGrid& body, const Place& place)
{
  return {place.column + (heat.nx - body.nx) / 2, place.fraction};
}

/// Interpolates a field of the thermal grid to the contact grid.
std::vector<double> on_contact(const SurfaceGrid& contact, const SurfaceGrid& thermal, std::span<const double> field,
                               const Place& place, bool is_mirrored)
{
  const SurfaceGrid rows = with_rows_of(thermal, contact);
  std::vector<double> fitted(rows.size()), out(contact.size(), 0.0);
  fit(thermal, field, rows, fitted);
  if (is_mirrored)
    for (auto row = fitted.begin(); row != fitted.end(); row += rows.nx)
      std::reverse(row, row + rows.nx);
  elastoplastic::add_depth(rows, fitted, {}, place, contact, out);
  return out;
}

/// Extrapolates a share linearly in time from the last two steps, on the contact grid; each is the mean over its step.
/// @param duration, last  of this step and of the last one, 0 if there is none [s]
std::vector<double> expected_share(std::span<const double> share, std::span<const double> share_before, double duration,
                                   double last)
{
  const double ahead = last > 0.0 ? 0.5 * (duration + last) / last : 0.0;
  std::vector<double> expected(share.begin(), share.end());
  for (std::size_t i = 0; i < expected.size(); ++i)
    if (share[i] != 0.0)
      expected[i] += std::min(ahead, 1.0) * (share[i] - share_before[i]);
  return expected;
}

std::vector<double> sum_of(std::vector<double> share, std::span<const double> imposed)
{
  for (std::size_t i = 0; i < imposed.size(); ++i)
    share[i] += imposed[i];
  return share;
}

} // namespace

HeatedSide::HeatedSide(const SurfaceGrid& contact, const constitutive::Material& material,
                       std::shared_ptr<BodyHeat> heat, bool is_mirrored, std::optional<double> reference,
                       bool along_surface)
    : contact_(contact), bulk_(material.temperature), heat_(std::move(heat)), is_mirrored_(is_mirrored),
      along_surface_(along_surface), response_(contact, material, swells(), reference, along_surface)
{
  assign_fields(state_, contact.size());
  for (std::vector<double>* field : {&share_, &flux_before_})
    field->assign(contact.size(), 0.0);
  for (std::size_t part = 0; part < response_.parts(); ++part)
    for (Displacement* displacement : {&remaining_displacement_, &own_displacement_})
      (*displacement)[part].assign(contact.size(), 0.0);
  remaining_.assign(contact.size(), bulk_);
  state_.temperature = remaining_;
}

/// Interpolates a displacement of the thermal grid to the contact grid.
void HeatedSide::set_from(const Displacement& thermal_field, Displacement& on_contact_grid) const
{
  for (std::size_t part = 0; part < response_.parts(); ++part)
    on_contact_grid[part] = on_contact(contact_, heat_->grid(), thermal_field[part], place_, is_mirrored_);
  if (is_mirrored_ && along_surface_)
    for (double& along_x : on_contact_grid[1])
      along_x = -along_x;
}

/// Transfers a flux or pressure from the contact grid to the thermal grid, conserving its sum.
/// @param what  name of the field for the message
/// @throws GridError if a part lies beyond the thermal grid
std::vector<double> HeatedSide::on_body(std::span<const double> field, const char* what) const
{
  const SurfaceGrid rows = with_rows_of(heat_->grid(), contact_);
  std::vector<double> spread, out(heat_->grid().size());
  const bool all_columns = spread_traction(contact_, field, place_, rows, spread);
  fit(rows, spread, heat_->grid(), out);
  double lost = 0.0;
  for (int j = 0; j < rows.ny; ++j)
    if (std::abs(j - 0.5 * (rows.ny - 1)) > 0.5 * heat_->grid().ny)
      for (int i = 0; i < rows.nx; ++i)
        lost = std::max(lost, std::abs(spread[rows.index(i, j)]));
  if (!all_columns || lost > 0.0)
    throw GridError(std::string("the contact has grown beyond the grid on which the heat of a body is kept, and its ") +
                    what + " would be lost");
  return out;
}

/// Adds the response to a flux that does not depend on the contact to what remains of earlier steps, once per step.
void HeatedSide::impose(std::span<const double> flux)
{
  if (is_zero(flux))
    return;
  std::vector<double> response(flux.size());
  response_.find_rise(flux, response);
  std::transform(remaining_.begin(), remaining_.end(), response.begin(), remaining_.begin(), std::plus<>());
  if (!swells())
    return;
  Displacement displacement;
  response_.find_displacement(flux, displacement);
  for (std::size_t part = 0; part < response_.parts(); ++part)
    std::transform(remaining_displacement_[part].begin(), remaining_displacement_[part].end(),
                   displacement[part].begin(), remaining_displacement_[part].begin(), std::plus<>());
}

void HeatedSide::begin(const VolumeGrid& body, const Place& place, double columns, double duration, bool is_fed,
                       std::span<const double> imposed)
{
  imposed_.assign(imposed.begin(), imposed.end());
  flux_before_ = state_.flux;
  if (!conducts())
    return;
  duration_ = without_rounding(duration);
  const double velocity = without_rounding(columns * contact_.dx / duration_);
  constexpr double always = std::numeric_limits<double>::infinity();
  response_.set_motion({heat_->is_steady() ? always : duration_, velocity});
  place_ = on_thermal_grid(heat_->grid(), body.surface, place);
  // The steady state of a step without heat between the surfaces has no flux left from steps with it.
  const bool is_new = heat_->is_steady() && !is_fed;
  const std::vector<double> none(contact_.size(), 0.0);
  if (!is_mirrored_)
  {
    std::vector<double> expected; // on the thermal grid
    if (heat_->acts_in_layers())
    {
      const std::vector<double> share =
          is_new ? none : expected_share(state_.share, state_.share_before, duration, state_.duration);
      expected = on_body(sum_of(share, imposed_), "heat");
    }
    heat_->begin(expected, response_.motion(), body);
  }
  remaining_ = on_contact(contact_, heat_->grid(), heat_->remaining_temperature(), place_, is_mirrored_);
  for (double& t : remaining_)
    t += bulk_;
  if (swells())
    set_from(heat_->remaining_displacement(), remaining_displacement_);
  impose(imposed_);
  set_share(is_new ? none : state_.share);
}

double HeatedSide::set_share(std::span<const double> flux)
{
  share_.assign(flux.begin(), flux.end());
  state_.flux = sum_of(share_, imposed_);
  if (!swells())
    return 0.0;
  const Displacement before = own_displacement_;
  response_.find_displacement(flux, own_displacement_);
  double change = 0.0;
  for (std::size_t part = 0; part < response_.parts(); ++part)
    for (std::size_t i = 0; i < before[part].size(); ++i)
      change = larger(change, std::abs(own_displacement_[part][i] - before[part][i]));
  return change;
}

void HeatedSide::add_displacement(std::span<double> gap) const
{
  if (!swells())
    return;
  for (std::size_t i = 0; i < gap.size(); ++i)
    gap[i] += remaining_displacement_[0][i] + own_displacement_[0][i];
}

void HeatedSide::add_along(std::size_t axis, std::span<double> out) const
{
  if (!swells() || !along_surface_)
    return;
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] += remaining_displacement_[1 + axis][i] + own_displacement_[1 + axis][i];
}

/// The displacement of the field and that of the last trial differ by the errors of both. Slip is the sum of the changes in all
/// steps, so that points that stay under the contact grid continue from the trial: the difference would add up.
void HeatedSide::recall(const VolumeGrid& body, const Place& place, double columns)
{
  if (!swells())
    return;
  place_ = on_thermal_grid(heat_->grid(), body.surface, place);
  set_from(heat_->displacement(), remaining_displacement_);
  for (std::vector<double>& part : own_displacement_)
    std::fill(part.begin(), part.end(), 0.0);
  const int moved = static_cast<int>(std::lround(columns)), nx = contact_.nx;
  for (std::size_t axis = 0; axis < 2 && !state_.along[axis].empty(); ++axis)
    for (int j = 0; j < contact_.ny; ++j)
      for (int i = 0; i < nx; ++i)
      {
        const int before = contact_.is_periodic_x() ? ((i + moved) % nx + nx) % nx : i + moved;
        if (before >= 0 && before < nx)
          remaining_displacement_[1 + axis][contact_.index(i, j)] = state_.along[axis][contact_.index(before, j)];
      }
}

void HeatedSide::require_room(std::span<const double> pressure) const
{
  if (!conducts() || is_mirrored_)
    return;
  static_cast<void>(on_body(pressure, "pressure"));
  static_cast<void>(on_body(state_.flux, "heat"));
}

void HeatedSide::settle()
{
  state_.share_before = state_.share;
  state_.share = share_;
  state_.duration = duration_;
  state_.total += sum(state_.flux) * contact_.cell_area() * duration_;
  if (!conducts())
    return;
  if (swells() && along_surface_)
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
      state_.along[axis].assign(share_.size(), 0.0);
      add_along(axis, state_.along[axis]);
    }
  response_.find_rise(share_, state_.temperature);
  for (std::size_t i = 0; i < state_.temperature.size(); ++i)
    state_.temperature[i] += remaining_[i];
  if (conducts() && !is_mirrored_)
    heat_->settle(on_body(state_.flux, "heat"));
}

void HeatedSide::restore()
{
  state_.flux = flux_before_;
  if (conducts() && !is_mirrored_)
    heat_->restore();
}

void HeatedSide::add_depth(const SurfaceGrid& body, const Place& place, std::span<double> out) const
{
  if (!swells())
    return;
  const std::vector<double> depth = on_contact(contact_, heat_->grid(), heat_->displacement()[0],
                                               on_thermal_grid(heat_->grid(), body, place), is_mirrored_);
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] += depth[i];
}

void HeatedSide::exchange(Archive& archive)
{
  exchange_members(archive, state_);
  share_ = state_.share;
  if (conducts() && !is_mirrored_)
    archive("heat", *heat_);
}

void HeatedSide::move_to(const SurfaceGrid& contact)
{
  const auto move = [&](std::vector<double>& field, double outside)
  {
    std::vector<double> moved(contact.size(), outside);
    embed_field(contact_, field, contact, moved);
    field = std::move(moved);
  };
  for (std::vector<double>* field : {&share_, &flux_before_})
    move(*field, 0.0);
  for (std::size_t part = 0; part < response_.parts(); ++part)
    for (Displacement* displacement : {&remaining_displacement_, &own_displacement_})
      move((*displacement)[part], 0.0);
  state_.along = {}; // the points that are new under the grid are known from the field only
  move(remaining_, bulk_);
  for_fields(
      [&](const Traits& traits, std::vector<double>& field)
      {
        if (!traits.is_derived)
          move(field, &field == &state_.temperature ? bulk_ : 0.0);
      },
      state_);
  imposed_.clear();
  contact_ = contact;
  response_.move_to(contact);
}

} // namespace brinell::elastoplastic
