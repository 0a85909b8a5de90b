// SPDX-License-Identifier: BSD-3-Clause
#include "heated_body.hpp"

#include "brinell/foundation/deviator.hpp"
#include "brinell/foundation/error.hpp"
#include "foundation/sharing.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::elastoplastic
{

namespace
{

/// Columns or rows of the thermal grid: wider than the material grid, in case the contact becomes larger than planned.
int thermal_cells(int cells, bool is_periodic)
{
  return is_periodic ? cells : cells + 2 * static_cast<int>(std::ceil(cells / 6.0));
}

SurfaceGrid heat_grid(const SurfaceGrid& body)
{
  SurfaceGrid grid = body;
  grid.nx = thermal_cells(body.nx, body.is_periodic_x());
  grid.ny = thermal_cells(body.ny, body.is_periodic_y());
  return grid;
}

/// Depths of the layers' centres [m], for twice as many layers as planned, because the material grid may grow.
std::vector<double> depths_of(const VolumeGrid& volume, int layers)
{
  const int count = 2 * std::max(volume.nz, layers);
  std::vector<double> depths;
  depths.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k)
    depths.push_back((k + 0.5) * volume.dz);
  return depths;
}

halfspace::SurfaceDisplacement all_of(BodyHeat::Displacement& displacement)
{
  return {displacement[0], displacement[1], displacement[2]};
}

/// Layers in which plastic work becomes heat.
halfspace::HeatedLayers heated_layers(const VolumeGrid& volume, const constitutive::Material& material,
                                      const HeatSettings& settings)
{
  if (!material.is_plastic() || settings.of_plastic_work == 0.0)
    return {};
  if (!material.layers.empty())
    throw InputError("the heat of plastic work in a coated body is not computed; allowed: of_plastic_work = 0");
  return {volume.nz, volume.dz};
}

} // namespace

void fit(const SurfaceGrid& from, std::span<const double> field, const SurfaceGrid& to, std::span<double> out)
{
  const int columns = (to.nx - from.nx) / 2, rows = (to.ny - from.ny) / 2;
  if (from.nx < to.nx || from.ny < to.ny)
    std::fill(out.begin(), out.end(), 0.0);
  for (int j = std::max(0, rows); j < std::min(to.ny, from.ny + rows); ++j)
    for (int i = std::max(0, columns); i < std::min(to.nx, from.nx + columns); ++i)
      out[to.index(i, j)] = field[from.index(i - columns, j - rows)];
}

BodyHeat::BodyHeat(const VolumeGrid& volume, const constitutive::Material& material, const HeatedRun& run,
                   const HeatNumerics& numerics)
    : grid_(heat_grid(volume.surface)), bulk_(material.temperature),
      swells_(run.settings.displacement && material.expands()),
      is_stressed_(run.settings.stress && material.expands() && material.is_plastic()),
      softening_law_(material.is_plastic() ? material.softening : std::nullopt), is_rigid_(material.elastic.is_rigid())
{
  if (run.settings.regime == HeatRegime::steady && !material.layers.empty())
    throw InputError("the steady heat of a coated body is not computed; allowed: the transient regime");
  if (run.settings.regime == HeatRegime::steady)
    steady_.emplace(grid_, *material.thermal, material.elastic, volume.dz, run.settings.reference);
  else
  {
    const halfspace::HeatedLayers heated = heated_layers(volume, material, run.settings);
    const auto images = numerics.shortcuts ? halfspace::HeatImages::coarse : halfspace::HeatImages::fine;
    const std::vector<double> depths = is_rigid_ ? std::vector<double>{} : depths_of(volume, run.layers);
    if (material.layers.empty())
      field_.emplace(grid_, *material.thermal, material.elastic, run.times, depths, images, heated);
    else
      field_.emplace(grid_, material.thermal_stack(), material.stack(), run.times, depths, images);
    if (heated.count > 0)
      plastic_.emplace(grid_, run.settings.of_plastic_work);
  }
  for (std::vector<double>* field : {&remaining_temperature_, &normal_before_, &state_.pressure})
    field->assign(grid_.size(), 0.0);
  for (std::size_t part = 0; part < (numerics.along_surface ? 3u : 1u); ++part)
    for (Displacement* displacement : {&remaining_displacement_, &state_.displacement})
      (*displacement)[part].assign(grid_.size(), 0.0);
  if (is_stressed_)
    stress_.assign(Deviator::size * volume.size(), 0.0);
}

void BodyHeat::begin(const std::vector<double>& expected, const halfspace::HeatMotion& motion, const VolumeGrid& body)
{
  motion_ = motion;
  if (steady_)
  {
    steady_->begin(motion.velocity_x, expected.empty() ? std::vector<double>(grid_.size()) : expected);
    if (acts_in_layers())
      find_layers(body);
    return;
  }
  if (plastic_)
  {
    field_->add_heat_in_body(plastic_->source(motion.velocity_x * motion.duration / grid_.dx, motion.duration),
                             motion.duration);
    is_volume_heat_advanced_ = true;
  }
  if (field_->time() > 0.0)
  {
    field_->remaining_temperature(motion.duration, remaining_temperature_);
    if (swells_)
      field_->displacement(all_of(remaining_displacement_), motion.duration);
  }
  if (plastic_)
    field_->add_temperature_of_body(remaining_temperature_);
  if (!acts_in_layers())
    return;
  expected_.assign(expected.begin(), expected.end());
  field_->add_step(expected_, motion, before_);
  is_expected_applied_ = true;
  find_layers(body);
}

void BodyHeat::require_room_for_work(std::span<const double> work, const VolumeGrid& body) const
{
  if (plastic_)
    plastic_->require_room(work, body);
}

void BodyHeat::settle_work(std::span<const double> work, const VolumeGrid& body, double duration)
{
  if (plastic_)
    plastic_->settle(work, body, duration);
}

void BodyHeat::settle(std::span<const double> flux)
{
  is_volume_heat_advanced_ = false;
  if (steady_)
    steady_->settle(flux);
  else if (!is_expected_applied_)
    field_->add_step(flux, motion_);
  else
  {
    for (std::size_t i = 0; i < flux.size(); ++i)
      expected_[i] = flux[i] - expected_[i];
    field_->add_to_last_step(expected_, motion_);
    is_expected_applied_ = false;
  }
  if (!swells_)
    return;
  normal_before_ = state_.displacement[0];
  if (steady_)
    steady_->displacement(state_.displacement[0]);
  else
    field_->displacement(all_of(state_.displacement));
}

void BodyHeat::restore()
{
  if (steady_)
    steady_->restore();
  if (is_volume_heat_advanced_)
    field_->restore_heat_in_body();
  is_volume_heat_advanced_ = false;
  if (!is_expected_applied_)
    return;
  field_->restore(before_);
  is_expected_applied_ = false;
}

void BodyHeat::require_layers(const VolumeGrid& body) const
{
  if (field_ && static_cast<std::size_t>(body.nz) > field_->depths().size())
    throw GridError("the plastic zone has become more than twice as deep as planned, and the heat is not known there");
}

/// Computes thermal stress and softening in the layers of the body, as far as they are needed.
void BodyHeat::find_layers(const VolumeGrid& body)
{
  if (is_stressed_)
    stress_.resize(Deviator::size * body.size());
  if (is_softened())
    softening_.resize(body.size());
  layers(body, {.temperature = softening_, .deviator = stress_, .trace = {}}, buffer_);
  for (double& value : softening_) // up to here it holds the rise of the temperature
    value = constitutive::softening_factor(*softening_law_, bulk_ + value);
}

void BodyHeat::layers(const VolumeGrid& body, const Heating::Layers& out) const
{
  std::vector<double> buffer;
  layers(body, out, buffer);
}

/// @param buffer  for the fields on the thermal grid; resized
void BodyHeat::layers(const VolumeGrid& body, const Heating::Layers& out, std::vector<double>& buffer) const
{
  if (is_rigid_)
    return;
  require_layers(body);
  if (field_ && field_->holds(body.surface))
    return field_->in_body(body, {out.temperature, out.deviator, out.trace});
  const auto count = static_cast<std::size_t>(body.nz);
  const std::size_t cells = grid_.size();
  const std::size_t deviators = out.deviator.empty() ? 0 : Deviator::size, traces = out.trace.empty() ? 0 : 1,
                    temperatures = out.temperature.empty() ? 0 : 1, fields = deviators + traces + temperatures;
  buffer.resize(fields * count * cells);
  std::vector<halfspace::ThermalLayer> found;
  found.reserve(count);
  for (std::size_t k = 0; k < count; ++k)
  {
    const std::span<double> of_layer = std::span(buffer).subspan(k * fields * cells, fields * cells);
    found.push_back({of_layer.subspan((deviators + traces) * cells), of_layer.first(deviators * cells),
                     of_layer.subspan(deviators * cells, traces * cells)});
  }
  if (steady_)
    steady_->layers(found);
  else
    field_->layers(0, found);
  const auto place = [&](std::span<const double> field, std::span<double> all, std::size_t number, std::size_t layer)
  {
    const std::size_t size = body.surface.size();
    fit(grid_, field, body.surface, all.subspan(number * body.size() + layer * size, size));
  };
  for (std::size_t k = 0; k < count; ++k)
  {
    for (std::size_t c = 0; c < deviators; ++c)
      place(found[k].deviator.subspan(c * cells, cells), out.deviator, c, k);
    if (traces > 0)
      place(found[k].trace, out.trace, 0, k);
    if (temperatures > 0)
      place(found[k].temperature, out.temperature, 0, k);
  }
}

void BodyHeat::layer(const VolumeGrid& body, std::size_t layer, const Heating::Layers& out) const
{
  if (is_rigid_)
    return;
  require_layers(body);
  if (field_ && field_->holds(body.surface))
    return field_->in_body({body.surface, 1, body.dz}, {out.temperature, out.deviator, out.trace}, layer);
  const std::size_t cells = grid_.size();
  std::vector<double> temperature(cells), deviator(Deviator::size * cells), trace(cells);
  const halfspace::ThermalLayer found{temperature, deviator, trace};
  if (steady_)
    steady_->layer(static_cast<std::size_t>(body.nz), layer, found);
  else
    field_->layer(layer, found);
  const std::size_t size = body.surface.size();
  fit(grid_, temperature, body.surface, out.temperature);
  fit(grid_, trace, body.surface, out.trace);
  for (std::size_t c = 0; c < Deviator::size; ++c)
    fit(grid_, std::span(deviator).subspan(c * cells, cells), body.surface, out.deviator.subspan(c * size, size));
}

/// Trapezoidal rule in time, with the pressure of the previous call.
double BodyHeat::work_against(std::span<const double> pressure)
{
  double work = 0.0;
  for (std::size_t i = 0; i < pressure.size(); ++i)
    work -= 0.5 * (state_.pressure[i] + pressure[i]) * (state_.displacement[0][i] - normal_before_[i]);
  state_.pressure.assign(pressure.begin(), pressure.end());
  return work * grid_.cell_area();
}

void BodyHeat::exchange(Archive& archive)
{
  if (steady_)
    archive("steady", *steady_);
  else
    archive("field", *field_);
  exchange_members(archive, state_);
  if (plastic_)
    archive("plastic", *plastic_);
}

} // namespace brinell::elastoplastic
