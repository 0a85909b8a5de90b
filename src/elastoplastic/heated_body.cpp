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

/// Columns or rows of the grid of the heat: room for a contact that turns out larger than planned.
int widened(int cells, bool is_periodic)
{
  return is_periodic ? cells : cells + 2 * static_cast<int>(std::ceil(cells / 6.0));
}

SurfaceGrid heat_grid(const SurfaceGrid& body)
{
  SurfaceGrid grid = body;
  grid.nx = widened(body.nx, body.is_periodic_x());
  grid.ny = widened(body.ny, body.is_periodic_y());
  return grid;
}

/// Middles of the layers, and of as many below: the body's grid may grow.
std::vector<double> depths_of(const VolumeGrid& volume)
{
  std::vector<double> depths;
  depths.reserve(2 * static_cast<std::size_t>(volume.nz));
  for (int k = 0; k < 2 * volume.nz; ++k)
    depths.push_back((k + 0.5) * volume.dz);
  return depths;
}

/// A field on a grid as it is on another one with the same middle and the same cells: zero where there was none.
void fit(const SurfaceGrid& from, std::span<const double> field, const SurfaceGrid& to, std::span<double> out)
{
  const int columns = (to.nx - from.nx) / 2, rows = (to.ny - from.ny) / 2;
  std::fill(out.begin(), out.end(), 0.0);
  for (int j = std::max(0, rows); j < std::min(to.ny, from.ny + rows); ++j)
    for (int i = std::max(0, columns); i < std::min(to.nx, from.nx + columns); ++i)
      out[to.index(i, j)] = field[from.index(i - columns, j - rows)];
}

SurfaceGrid with_rows_of(SurfaceGrid grid, const SurfaceGrid& other)
{
  grid.ny = other.ny;
  return grid;
}

/// Steps that are alike but for rounding have one plan, which does not depend on the step that was the first of them.
double without_rounding(double value)
{
  if (value == 0.0)
    return 0.0;
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 9.0);
  return std::round(value / unit) * unit;
}

Place on_heat(const SurfaceGrid& heat, const SurfaceGrid& body, const Place& place)
{
  return {place.column + (heat.nx - body.nx) / 2, place.fraction};
}

} // namespace

BodyHeat::BodyHeat(const VolumeGrid& volume, const constitutive::Material& material, const HeatedRun& run,
                   const HeatNumerics& numerics)
    : grid_(heat_grid(volume.surface)), thermal_(material.thermal.value()), bulk_(material.temperature),
      swells_(run.settings.displacement && thermal_.expansion != 0.0),
      is_stressed_(run.settings.stress && thermal_.expansion != 0.0 && material.is_plastic()),
      softening_law_(material.is_plastic() ? material.softening : std::nullopt),
      field_(grid_, thermal_, material.elastic, run.times,
             material.elastic.is_rigid() ? std::vector<double>{} : depths_of(volume),
             numerics.shortcuts ? halfspace::HeatImages::coarse : halfspace::HeatImages::fine, numerics.symmetry)
{
  for (std::vector<double>* field :
       {&remaining_temperature_, &remaining_displacement_, &displacement_, &displacement_before_, &pressure_})
    field->assign(grid_.size(), 0.0);
  if (is_stressed_)
    stress_.assign(Deviator::size * volume.size(), 0.0);
}

void BodyHeat::begin(std::span<const double> expected, const halfspace::HeatMotion& motion, const VolumeGrid& body)
{
  motion_ = motion;
  if (field_.time() > 0.0)
  {
    field_.remaining_temperature(motion.duration, remaining_temperature_);
    if (swells_)
      field_.displacement({remaining_displacement_, {}, {}}, motion.duration);
  }
  if (!acts_in_layers())
    return;
  expected_.assign(expected.begin(), expected.end());
  field_.take_up(expected_, motion, before_);
  is_expected_ = true;
  find_layers(body);
}

void BodyHeat::settle(std::span<const double> flux)
{
  if (!is_expected_)
    field_.take_up(flux, motion_);
  else
  {
    for (std::size_t i = 0; i < flux.size(); ++i)
      expected_[i] = flux[i] - expected_[i];
    field_.amend(expected_, motion_);
    is_expected_ = false;
  }
  if (!swells_)
    return;
  displacement_before_ = displacement_;
  field_.displacement({displacement_, {}, {}});
}

void BodyHeat::restore()
{
  if (!is_expected_)
    return;
  field_.go_back(before_);
  is_expected_ = false;
}

void BodyHeat::require_layers(const VolumeGrid& body) const
{
  if (static_cast<std::size_t>(body.nz) > field_.depths().size())
    throw GridError("the plastic zone has become more than twice as deep as planned, and the heat is not known there; "
                    "allowed: a larger grid.extent");
}

/// What counts in the layers of the body.
void BodyHeat::find_layers(const VolumeGrid& body)
{
  if (is_stressed_)
    stress_.assign(Deviator::size * body.size(), 0.0);
  if (is_softened())
    softening_.assign(body.size(), 0.0);
  layers(body, {.temperature = softening_, .deviator = stress_, .trace = {}}, room_);
  for (double& value : softening_) // so far the rise of the temperature
    value = constitutive::softening_factor(*softening_law_, bulk_ + value);
}

void BodyHeat::layers(const VolumeGrid& body, const Heating::Layers& out) const
{
  std::vector<double> room;
  layers(body, out, room);
}

/// @param room  where the fields come to be on the grid of the heat
void BodyHeat::layers(const VolumeGrid& body, const Heating::Layers& out, std::vector<double>& room) const
{
  if (field_.depths().empty())
    return;
  require_layers(body);
  const auto count = static_cast<std::size_t>(body.nz);
  const std::size_t cells = grid_.size();
  const std::size_t deviators = out.deviator.empty() ? 0 : Deviator::size, traces = out.trace.empty() ? 0 : 1,
                    temperatures = out.temperature.empty() ? 0 : 1, fields = deviators + traces + temperatures;
  room.resize(fields * count * cells);
  std::vector<halfspace::ThermalLayer> found;
  found.reserve(count);
  for (std::size_t k = 0; k < count; ++k)
  {
    const std::span<double> of_layer = std::span(room).subspan(k * fields * cells, fields * cells);
    found.push_back({of_layer.subspan((deviators + traces) * cells), of_layer.first(deviators * cells),
                     of_layer.subspan(deviators * cells, traces * cells)});
  }
  field_.layers(0, found);
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

/// By the trapezoidal rule, in the cells of the body.
double BodyHeat::work_against(std::span<const double> pressure)
{
  double work = 0.0;
  for (std::size_t i = 0; i < pressure.size(); ++i)
    work -= 0.5 * (pressure_[i] + pressure[i]) * (displacement_[i] - displacement_before_[i]);
  pressure_.assign(pressure.begin(), pressure.end());
  return work * grid_.cell_area();
}

void BodyHeat::exchange(Archive& archive)
{
  archive("field", field_);
  archive("displacement", displacement_);
  archive("pressure", pressure_);
}

HeatedSide::HeatedSide(const SurfaceGrid& contact, const constitutive::Material& material,
                       std::shared_ptr<BodyHeat> heat, bool is_mirrored)
    : contact_(contact), material_(material), heat_(std::move(heat)), is_mirrored_(is_mirrored)
{
  for (std::vector<double>* field : {&remaining_displacement_, &own_displacement_, &flux_, &last_flux_, &flux_before_})
    field->assign(contact.size(), 0.0);
  remaining_.assign(contact.size(), material.temperature);
  temperature_ = remaining_;
}

/// A field on the grid of the heat, from the contact grid.
std::vector<double> HeatedSide::seen(const std::vector<double>& of_heat, const Place& place) const
{
  const SurfaceGrid rows = with_rows_of(heat_->grid(), contact_);
  std::vector<double> fitted(rows.size()), out(contact_.size(), 0.0);
  fit(heat_->grid(), of_heat, rows, fitted);
  if (is_mirrored_)
    for (auto row = fitted.begin(); row != fitted.end(); row += rows.nx)
      std::reverse(row, row + rows.nx);
  elastoplastic::add_depth(rows, fitted, {}, place, contact_, out);
  return out;
}

/// The way back, of what acts on a body; all of it.
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
                    what + " would be lost; allowed: a larger grid.extent");
  return out;
}

void HeatedSide::plan(const halfspace::HeatMotion& motion)
{
  const auto known = std::find_if(planned_.begin(), planned_.end(),
                                  [&](const Responses& responses) { return responses.motion == motion; });
  if (known != planned_.end())
  {
    planned_.splice(planned_.begin(), planned_, known);
    return;
  }
  constexpr std::size_t most = 6;
  if (planned_.size() == most)
    planned_.pop_back();
  halfspace::HeatResponse temperature(contact_, *material_.thermal, motion);
  auto temperature_scratch = temperature.make_scratch();
  std::optional<halfspace::ThermalResponse> displacement;
  halfspace::ThermalResponse::Scratch displacement_scratch;
  if (heat_->swells())
  {
    displacement.emplace(contact_, *material_.thermal, material_.elastic, motion);
    displacement_scratch = displacement->make_scratch();
  }
  planned_.push_front({motion, std::move(temperature), std::move(displacement), std::move(temperature_scratch),
                       std::move(displacement_scratch)});
}

/// Linear in time, of the fluxes of the last two steps as seen from the contact: each is the mean over its step.
std::vector<double> HeatedSide::expected_flux(double duration) const
{
  const double ahead = last_duration_ > 0.0 ? 0.5 * (duration + last_duration_) / last_duration_ : 0.0;
  std::vector<double> expected(last_flux_);
  for (std::size_t i = 0; i < expected.size(); ++i)
    if (last_flux_[i] != 0.0)
      expected[i] += std::min(ahead, 1.0) * (last_flux_[i] - flux_before_[i]);
  return expected;
}

void HeatedSide::begin(const VolumeGrid& body, const Place& place, double columns, double duration)
{
  if (!conducts())
    return;
  duration_ = without_rounding(duration);
  const halfspace::HeatMotion motion{duration_, without_rounding(columns * contact_.dx / duration_), 0.0};
  place_ = on_heat(heat_->grid(), body.surface, place);
  plan(motion);
  if (!is_mirrored_)
    heat_->begin(heat_->acts_in_layers() ? on_body(expected_flux(duration), "heat") : std::vector<double>{}, motion,
                 body);
  remaining_ = seen(heat_->remaining_temperature(), place_);
  for (double& t : remaining_)
    t += material_.temperature;
  if (heat_->swells())
    remaining_displacement_ = seen(heat_->remaining_displacement(), place_);
  set_flux(last_flux_);
}

void HeatedSide::warm(std::span<const double> flux, std::span<double> rise)
{
  responses().temperature.apply(flux, rise, responses().temperature_scratch);
}

double HeatedSide::set_flux(std::span<const double> flux)
{
  flux_.assign(flux.begin(), flux.end());
  if (!conducts() || !heat_->swells())
    return 0.0;
  const std::vector<double> before = own_displacement_;
  responses().displacement->apply(flux_, own_displacement_, responses().displacement_scratch);
  double change = 0.0;
  for (std::size_t i = 0; i < before.size(); ++i)
    change = larger(change, std::abs(own_displacement_[i] - before[i]));
  return change;
}

void HeatedSide::add_displacement(std::span<double> gap) const
{
  if (!conducts() || !heat_->swells())
    return;
  for (std::size_t i = 0; i < gap.size(); ++i)
    gap[i] += remaining_displacement_[i] + own_displacement_[i];
}

void HeatedSide::settle()
{
  flux_before_ = last_flux_;
  last_flux_ = flux_;
  last_duration_ = duration_;
  total_ += sum(flux_) * contact_.cell_area() * duration_;
  if (!conducts())
    return;
  warm(flux_, temperature_);
  for (std::size_t i = 0; i < temperature_.size(); ++i)
    temperature_[i] += remaining_[i];
  if (!is_mirrored_)
    heat_->settle(on_body(flux_, "heat"));
}

void HeatedSide::restore()
{
  if (conducts() && !is_mirrored_)
    heat_->restore();
}

void HeatedSide::add_depth(const SurfaceGrid& body, const Place& place, std::span<double> out) const
{
  if (!conducts() || !heat_->swells())
    return;
  const std::vector<double> depth = seen(heat_->displacement(), on_heat(heat_->grid(), body, place));
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] += depth[i];
}

void HeatedSide::exchange(Archive& archive)
{
  archive("temperature", temperature_);
  archive("flux", last_flux_);
  archive("flux_before", flux_before_);
  archive("duration", last_duration_);
  archive("total", total_);
  flux_ = last_flux_;
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
  for (std::vector<double>* field : {&remaining_displacement_, &own_displacement_, &flux_, &last_flux_, &flux_before_})
    move(*field, 0.0);
  move(remaining_, material_.temperature);
  move(temperature_, material_.temperature);
  contact_ = contact;
  planned_.clear();
}

} // namespace brinell::elastoplastic
