// SPDX-License-Identifier: BSD-3-Clause
#include "steady_heat.hpp"

#include <algorithm>

namespace brinell::elastoplastic
{

SteadyHeat::SteadyHeat(const SurfaceGrid& grid, const Thermal& thermal, const Elastic& elastic, double layer_thickness,
                       std::optional<double> reference)
    : grid_(grid), thermal_(thermal), elastic_(elastic), layer_thickness_(layer_thickness), reference_(reference)
{
  now_.flux.assign(grid.size(), 0.0);
  last_ = now_;
}

void SteadyHeat::begin(double velocity, std::span<const double> expected)
{
  now_.velocity = velocity;
  now_.flux.assign(expected.begin(), expected.end());
}

void SteadyHeat::settle(std::span<const double> flux)
{
  now_.flux.assign(flux.begin(), flux.end());
  last_ = now_;
}

bool SteadyHeat::is_cold() const
{
  return std::all_of(now_.flux.begin(), now_.flux.end(), [](double q) { return q == 0.0; });
}

const halfspace::SteadyField& SteadyHeat::field(std::size_t layers) const
{
  if (planned_ && planned_->velocity == now_.velocity && planned_->field.depths().size() >= layers)
    return planned_->field;
  planned_.reset(); // frees its memory before the next field is made
  std::vector<double> depths;
  for (std::size_t k = 0; k < layers; ++k)
    depths.push_back((static_cast<double>(k) + 0.5) * layer_thickness_);
  planned_ = Planned{now_.velocity,
                     halfspace::SteadyField(grid_, thermal_, elastic_, {now_.velocity, reference_}, std::move(depths))};
  return planned_->field;
}

void SteadyHeat::displacement(std::span<double> out) const
{
  if (is_cold())
    std::fill(out.begin(), out.end(), 0.0);
  else
    field(0).displacement(now_.flux, out);
}

void SteadyHeat::layers(std::span<const halfspace::ThermalLayer> out) const
{
  layers(out.size(), 0, out);
}

void SteadyHeat::layer(std::size_t count, std::size_t layer, const halfspace::ThermalLayer& out) const
{
  layers(count, layer, {&out, 1});
}

/// @param count  number of layers for which a field is planned
void SteadyHeat::layers(std::size_t count, std::size_t first, std::span<const halfspace::ThermalLayer> out) const
{
  if (!is_cold())
  {
    field(count).layers(now_.flux, first, out);
    return;
  }
  for (const halfspace::ThermalLayer& layer : out)
    for (const std::span<double>& part : {layer.temperature, layer.deviator, layer.trace})
      std::fill(part.begin(), part.end(), 0.0);
}

void SteadyHeat::exchange(Archive& archive)
{
  exchange_members(archive, last_);
  now_ = last_;
}

} // namespace brinell::elastoplastic
