// SPDX-License-Identifier: BSD-3-Clause
#include "flux_response.hpp"

#include <algorithm>
#include <utility>

namespace brinell::elastoplastic
{

bool is_zero(std::span<const double> flux)
{
  return std::all_of(flux.begin(), flux.end(), [](double value) { return value == 0.0; });
}

/// Operators for the motion of the current step. They are computed only when a flux needs them, since for a steady flux at rest
/// they may not exist.
FluxResponse::Operators& FluxResponse::operators()
{
  const auto known = std::find_if(cached_.begin(), cached_.end(),
                                  [&](const Operators& operators) { return operators.motion == motion_; });
  if (known != cached_.end())
  {
    cached_.splice(cached_.begin(), cached_, known);
    return cached_.front();
  }
  constexpr std::size_t max_cached = 6;
  if (cached_.size() == max_cached)
    cached_.pop_back();
  halfspace::HeatResponse temperature(contact_, material_.thermal_stack(), motion_);
  auto temperature_scratch = temperature.make_scratch();
  std::optional<halfspace::ThermalResponse> displacement;
  halfspace::ThermalResponse::Scratch displacement_scratch;
  if (swells_)
  {
    const auto parts = along_surface_ ? halfspace::Displacements::all : halfspace::Displacements::normal;
    if (material_.layers.empty())
      displacement.emplace(contact_, *material_.thermal, material_.elastic, motion_, reference_, parts);
    else
      displacement.emplace(contact_, material_.thermal_stack(), material_.stack(), motion_, parts);
    displacement_scratch = displacement->make_scratch();
  }
  cached_.push_front({motion_, std::move(temperature), std::move(displacement), std::move(temperature_scratch),
                      std::move(displacement_scratch)});
  return cached_.front();
}

void FluxResponse::find_rise(std::span<const double> flux, std::span<double> rise)
{
  if (is_zero(flux))
    std::fill(rise.begin(), rise.end(), 0.0);
  else
    operators().temperature.apply(flux, rise, operators().temperature_scratch);
}

void FluxResponse::find_displacement(std::span<const double> flux, Displacement& out)
{
  for (std::size_t part = 0; part < parts(); ++part)
    out[part].assign(flux.size(), 0.0);
  if (!is_zero(flux))
    operators().displacement->apply(flux, {out[0], out[1], out[2]}, operators().displacement_scratch);
}

void FluxResponse::move_to(const SurfaceGrid& contact)
{
  contact_ = contact;
  cached_.clear();
}

} // namespace brinell::elastoplastic
