// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/thermal_field.hpp"

#include "brinell/foundation/deviator.hpp"
#include "foundation/require_size.hpp"
#include "open_heat_memory.hpp"
#include "require_surface.hpp"
#include "thermal_wave.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace brinell::halfspace
{

namespace
{

/// Of one wave in a row of them.
StressWave stress_wave(const HeatRow& heat, std::size_t i, double poisson_ratio)
{
  return stress_wave(heat.waves[i], heat.depth,
                     {heat.temperature[i], heat.potential[i], heat.slope[i], heat.potential_at_surface[i]},
                     poisson_ratio);
}

double largest_of(const std::vector<double>& depths)
{
  return depths.empty() ? 0.0 : *std::max_element(depths.begin(), depths.end());
}

} // namespace

struct ThermalField::State
{
  Elastic elastic;
  double expansion; ///< alpha [1/K]
  double strain;    ///< of a layer that cannot expand along the surface: alpha (1 + nu)/(1 - nu) [1/K]
  double capacity;  ///< rho c [J/(m^3 K)]
  std::vector<double> depths;
  OpenHeatMemory memory;
  std::vector<DepthFactors> layers{};
  DepthFactors surface{};

  void tabulate()
  {
    surface = surface_factors(memory.waves());
    layers = depth_factors(memory.waves(), depths);
  }
};

ThermalField::ThermalField(const SurfaceGrid& grid, const Thermal& thermal, const Elastic& elastic,
                           const HeatTimes& times, std::vector<double> depths, HeatImages images, Symmetry symmetry,
                           const HeatedLayers& heated)
{
  for (const double depth : depths)
    if (!(depth >= 0.0) || std::isinf(depth))
      throw InputError(fmt::format("ThermalField: a depth of {} m; allowed: 0 and above", depth));
  if (elastic.is_rigid() && !depths.empty())
    throw InputError("ThermalField: a rigid body has no stress at any depth; allowed: an elastic body, or no depths");
  if (!std::isfinite(thermal.expansion))
    throw InputError(fmt::format("ThermalField: expansion = {}; allowed: a finite number", thermal.expansion));
  const double nu = elastic.poisson_ratio, deepest = largest_of(depths);
  state_ = make_hidden<State>(
      elastic, thermal.expansion, thermal.expansion * (1.0 + nu) / (1.0 - nu), thermal.density * thermal.specific_heat,
      std::move(depths), OpenHeatMemory("ThermalField", grid, thermal, times, {deepest, images, symmetry, heated}));
  state_->tabulate();
}

const SurfaceGrid& ThermalField::grid() const
{
  return state_->memory.grid();
}

const std::vector<double>& ThermalField::depths() const
{
  return state_->depths;
}

double ThermalField::time() const
{
  return state_->memory.time();
}

void ThermalField::take_up(std::span<const double> flux, const HeatMotion& motion)
{
  state_->memory.take_up("ThermalField::take_up", flux, motion);
}

void ThermalField::amend(std::span<const double> flux, const HeatMotion& motion)
{
  state_->memory.amend("ThermalField::amend", flux, motion);
}

void ThermalField::take_up_in_body(std::span<const double> heat, double duration)
{
  std::vector<double> rise(heat.begin(), heat.end());
  for (double& value : rise)
    value /= state_->capacity;
  state_->memory.take_up_in_body("ThermalField::take_up_in_body", rise, duration);
}

void ThermalField::go_back_in_body()
{
  state_->memory.go_back_in_body();
}

void ThermalField::add_temperature_of_body(std::span<double> temperature) const
{
  require_size("ThermalField::add_temperature_of_body: the temperature", temperature, grid().size());
  state_->memory.add_temperature_of_body(temperature);
}

struct ThermalField::Heat
{
  OpenHeatMemory::Heat of_memory;
};

Hidden<ThermalField::Heat> ThermalField::heat() const
{
  return make_hidden<Heat>(state_->memory.heat());
}

void ThermalField::take_up(std::span<const double> flux, const HeatMotion& motion, Hidden<Heat>& before)
{
  if (before.empty())
    before = make_hidden<Heat>();
  state_->memory.take_up("ThermalField::take_up", flux, motion, &before->of_memory);
}

void ThermalField::go_back(const Hidden<Heat>& heat)
{
  state_->memory.set_heat(heat->of_memory);
}

void ThermalField::exchange(Archive& archive)
{
  state_->memory.exchange(archive);
}

void ThermalField::remaining_temperature(double duration, std::span<double> temperature) const
{
  state_->memory.remaining("ThermalField::remaining_temperature", duration, temperature);
}

void ThermalField::displacement(const SurfaceDisplacement& displacement, double duration) const
{
  constexpr const char* name = "ThermalField::displacement";
  require_displacement(name, displacement, grid().size());
  const State& state = *state_;
  const double factor = -2.0 * (1.0 + state.elastic.poisson_ratio) * state.expansion;
  // What is uniform and has no ends expands along z alone.
  const double of_uniform = grid().is_periodic() ? -state.strain : factor;
  std::vector<std::span<double>> out;
  std::vector<bool> is_odd;
  for (const auto& [part, odd] : {std::pair{displacement.z, false}, {displacement.x, false}, {displacement.y, true}})
    if (!part.empty())
    {
      out.push_back(part);
      is_odd.push_back(odd);
    }
  const auto waves = [&](const HeatRow& heat, std::span<Complex* const> to)
  {
    for (std::size_t i = 0; i < heat.waves.size(); ++i)
    {
      const SurfaceWave& wave = heat.waves[i];
      const Complex potential = (wave.k > 0.0 ? factor : of_uniform) * heat.potential_at_surface[i];
      const Complex along = wave.k > 0.0 ? -1.0 / wave.k * divided_by_i(potential) : Complex{};
      auto field = to.begin();
      if (!displacement.z.empty())
        (*field++)[i] = potential;
      if (!displacement.x.empty())
        (*field++)[i] = wave.odd_x * along;
      if (!displacement.y.empty())
        (*field++)[i] = wave.odd_y * along;
    }
  };
  state.memory.fields(name, duration, {&state.surface, 1}, {waves, is_odd}, out);
}

namespace
{

/// The parts of a layer that are wanted.
std::vector<std::span<double>> wanted(const ThermalLayer& out, std::size_t cells)
{
  require_part("ThermalField::layer", "temperature", out.temperature, cells);
  require_part("ThermalField::layer", "deviator", out.deviator, Deviator::size * cells);
  require_part("ThermalField::layer", "trace", out.trace, cells);
  std::vector<std::span<double>> fields;
  if (!out.temperature.empty())
    fields.push_back(out.temperature);
  if (!out.trace.empty())
    fields.push_back(out.trace);
  if (!out.deviator.empty())
    for (std::size_t c = 0; c < Deviator::size; ++c)
      fields.push_back(out.deviator.subspan(c * cells, cells));
  return fields;
}

} // namespace

void ThermalField::layer(std::size_t layer, const ThermalLayer& out, double duration) const
{
  layers(layer, {&out, 1}, duration);
}

void ThermalField::layers(std::size_t first, std::span<const ThermalLayer> out, double duration) const
{
  const State& state = *state_;
  if (first + out.size() > state.layers.size())
    throw InternalError(
        fmt::format("ThermalField::layers: layer {} of {}", first + out.size() - 1, state.layers.size()));
  const double scale = 2.0 * state.elastic.shear_modulus() * state.strain;
  const bool has_temperature = !out.front().temperature.empty(), has_trace = !out.front().trace.empty(),
             has_deviator = !out.front().deviator.empty();
  std::vector<bool> is_odd(static_cast<std::size_t>(has_temperature) + static_cast<std::size_t>(has_trace), false);
  for (int c = 0; has_deviator && c < Deviator::size; ++c)
    is_odd.push_back(is_odd_in_y(c));
  const auto waves = [&](const HeatRow& heat, std::span<Complex* const> to)
  {
    for (std::size_t i = 0; i < heat.waves.size(); ++i)
    {
      const StressWave stress = stress_wave(heat, i, state.elastic.poisson_ratio);
      const Complex trace = scale * stress.trace(), mean = trace / 3.0;
      auto field = to.begin();
      if (has_temperature)
        (*field++)[i] = heat.temperature[i];
      if (has_trace)
        (*field++)[i] = trace;
      if (has_deviator)
        for (const Complex& component : {scale * stress.xx - mean, scale * stress.yy - mean, scale * stress.yz,
                                         scale * stress.xz, scale * stress.xy})
          (*field++)[i] = component;
    }
  };
  std::vector<std::span<double>> fields;
  for (const ThermalLayer& layer : out)
    for (const std::span<double>& field : wanted(layer, grid().size()))
      fields.push_back(field);
  if (!fields.empty())
    state.memory.fields("ThermalField::layer", duration, std::span(state.layers).subspan(first, out.size()),
                        {waves, is_odd}, fields);
}

} // namespace brinell::halfspace
