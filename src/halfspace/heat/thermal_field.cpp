// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/thermal_field.hpp"

#include "brinell/foundation/deviator.hpp"
#include "foundation/require_size.hpp"
#include "halfspace/transform/require_surface.hpp"
#include "open_heat_memory.hpp"
#include "thermal_stress.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <mutex>

namespace brinell::halfspace
{

namespace
{

double largest_of(const std::vector<double>& depths)
{
  return depths.empty() ? 0.0 : *std::max_element(depths.begin(), depths.end());
}

} // namespace

namespace
{

/// Factors of the waves at the depths, computed when a depth is first requested, because a plan may contain depths that are never
/// used. Thread-safe.
class LayerFactors
{
public:
  LayerFactors(DepthWaves waves, std::vector<double> depths) : waves_(std::move(waves)), depths_(std::move(depths))
  {
    found_.reserve(depths_.size()); // so that elements are never moved
  }
  [[nodiscard]] std::span<const DepthFactors> some(std::size_t first, std::size_t count)
  {
    const std::lock_guard lock(mutex_);
    if (const std::size_t there = found_.size(), wanted = first + count; there < wanted)
      for (DepthFactors& factors : depth_factors(waves_, std::span(depths_).subspan(there, wanted - there)))
        found_.push_back(std::move(factors));
    return std::span<const DepthFactors>(found_.data() + first, count);
  }

private:
  DepthWaves waves_;
  std::vector<double> depths_;
  std::mutex mutex_;
  std::vector<DepthFactors> found_;
};

} // namespace

struct ThermalField::State
{
  ThermalStack thermal;
  ElasticStack stack;
  std::vector<double> depths;
  OpenHeatMemory memory;
  // Of a homogeneous body
  Elastic elastic = stack.substrate;
  double expansion = thermal.substrate.expansion; ///< alpha [1/K]
  /// Of a layer constrained along the surface: alpha (1 + nu)/(1 - nu) [1/K].
  double strain = expansion * (1.0 + elastic.poisson_ratio) / (1.0 - elastic.poisson_ratio);
  double capacity = thermal.substrate.density * thermal.substrate.specific_heat; ///< rho c [J/(m^3 K)]
  std::unique_ptr<LayerFactors> layers{};
  DepthFactors surface{};
  std::vector<DepthFactors> coated{}; ///< depths of a coated body

  struct Layers
  {
    std::size_t first, count;
  };
  void find_layers(double duration, const Layers& which, const ThermalLayer& wanted,
                   const std::vector<std::span<double>>& fields, const HeatMemory::Window& window) const;
  [[nodiscard]] bool is_coated() const { return memory.coat() != nullptr; }
  void tabulate()
  {
    surface = surface_factors(memory.waves());
    if (is_coated()) // HeatCoat has the weights
      for (const double depth : depths)
        coated.push_back({depth, {0.0}, {}, {}, {}});
    layers = std::make_unique<LayerFactors>(memory.waves(), depths);
  }
};

/// @param wanted  the parts that are not empty determine which fields of each layer are computed
void ThermalField::State::find_layers(double duration, const Layers& which, const ThermalLayer& wanted,
                                      const std::vector<std::span<double>>& fields,
                                      const HeatMemory::Window& window) const
{
  const double scale = 2.0 * elastic.shear_modulus() * strain;
  const bool has_temperature = !wanted.temperature.empty(), has_trace = !wanted.trace.empty(),
             has_deviator = !wanted.deviator.empty();
  std::vector<bool> is_odd(static_cast<std::size_t>(has_temperature) + static_cast<std::size_t>(has_trace), false);
  for (int c = 0; has_deviator && c < Deviator::size; ++c)
    is_odd.push_back(is_odd_in_y(c));
  if (is_coated())
    return memory.fields("ThermalField::layer", duration, std::span(coated).subspan(which.first, which.count),
                         {CoatedStress{thermal, stack, has_temperature, has_trace, has_deviator}, is_odd}, fields,
                         window);
  const StressOfRow stress(elastic.poisson_ratio, scale);
  const auto waves = [&](const HeatRow& heat, std::span<Complex* const> to)
  {
    std::size_t field = 0;
    if (has_temperature)
      std::copy(heat.temperature.begin(), heat.temperature.end(), to[field++]);
    if (has_trace)
      stress.trace(heat, to[field++]);
    if (has_deviator)
      stress.deviator(heat, to.subspan(field));
  };
  memory.fields("ThermalField::layer", duration, layers->some(which.first, which.count), {waves, is_odd}, fields,
                window);
}

void ThermalField::begin(const SurfaceGrid& grid, const ThermalStack& thermal, const ElasticStack& elastic,
                         const HeatTimes& times, std::vector<double> depths, const WantedOfHeat& wanted)
{
  for (const double depth : depths)
    if (!(depth >= 0.0) || std::isinf(depth))
      throw InputError(fmt::format("ThermalField: a depth of {} m; allowed: 0 and above", depth));
  if (elastic.substrate.is_rigid() && !depths.empty())
    throw InputError("ThermalField: a rigid body has no stress at any depth; allowed: an elastic body, or no depths");
  for (std::size_t n = 0; n <= thermal.layers.size(); ++n)
    if (!std::isfinite(thermal.of_layer(n).expansion))
      throw InputError(
          fmt::format("ThermalField: expansion = {}; allowed: a finite number", thermal.of_layer(n).expansion));
  state_ = make_hidden<State>(thermal, elastic, std::move(depths),
                              OpenHeatMemory("ThermalField", grid, HeatCoat::of_memory(thermal), times, wanted));
  state_->tabulate();
}

ThermalField::ThermalField(const SurfaceGrid& grid, const Thermal& thermal, const Elastic& elastic,
                           const HeatTimes& times, std::vector<double> depths, HeatImages images,
                           const HeatedLayers& heated)
{
  const WantedOfHeat wanted{largest_of(depths), images, heated, {}};
  begin(grid, {{}, thermal}, {{}, elastic}, times, std::move(depths), wanted);
}

namespace
{

void require_same_layers(const ThermalStack& thermal, const ElasticStack& elastic)
{
  if (elastic.substrate.is_rigid())
    throw InputError("ThermalField: layers on a rigid substrate; allowed: an elastic substrate");
  const auto same = [](const ThermalCoat& coat, const ElasticLayer& layer)
  { return coat.thickness == layer.thickness; };
  if (!std::equal(thermal.layers.begin(), thermal.layers.end(), elastic.layers.begin(), elastic.layers.end(), same))
    throw InputError("ThermalField: the layers that conduct are not those that deform; allowed: the same thicknesses");
}

} // namespace

ThermalField::ThermalField(const SurfaceGrid& grid, const ThermalStack& thermal, const ElasticStack& elastic,
                           const HeatTimes& times, std::vector<double> depths, HeatImages images)
{
  WantedOfHeat wanted{largest_of(depths), images, {}, {}};
  if (!thermal.is_homogeneous())
  {
    require_same_layers(thermal, elastic);
    wanted.coat = CoatOfBody{thermal, elastic, HeatCoat::Surface::difference, depths};
  }
  begin(grid, thermal, elastic, times, std::move(depths), wanted);
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

void ThermalField::add_step(std::span<const double> flux, const HeatMotion& motion)
{
  state_->memory.add_step("ThermalField::add_step", flux, motion);
}

void ThermalField::add_to_last_step(std::span<const double> flux, const HeatMotion& motion)
{
  state_->memory.add_to_last_step("ThermalField::add_to_last_step", flux, motion);
}

void ThermalField::add_heat_in_body(std::span<const double> heat, double duration)
{
  std::vector<double> rise(heat.begin(), heat.end());
  for (double& value : rise)
    value /= state_->capacity;
  state_->memory.add_heat_in_body("ThermalField::add_heat_in_body", rise, duration);
}

void ThermalField::restore_heat_in_body()
{
  state_->memory.restore_heat_in_body();
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

void ThermalField::add_step(std::span<const double> flux, const HeatMotion& motion, Hidden<Heat>& before)
{
  if (before.empty())
    before = make_hidden<Heat>();
  state_->memory.add_step("ThermalField::add_step", flux, motion, &before->of_memory);
}

void ThermalField::restore(const Hidden<Heat>& heat)
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
  // A uniform temperature of a body periodic along both axes causes expansion along z only.
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
      const bool is_coated = !heat.moved.empty();
      const Complex potential =
          is_coated ? heat.moved[i] : (wave.k > 0.0 ? factor : of_uniform) * heat.potential_at_surface[i];
      const Complex of_along = is_coated ? -1.0 * heat.moved_along[i] : potential;
      const Complex along = wave.k > 0.0 ? -1.0 / wave.k * divided_by_i(of_along) : Complex{};
      auto field = to.begin();
      if (!displacement.z.empty())
        (*field++)[i] = potential;
      if (!displacement.x.empty())
        (*field++)[i] = wave.odd_x * along;
      if (!displacement.y.empty())
        (*field++)[i] = wave.odd_y * along;
    }
  };
  state.memory.fields(name, duration, {&state.surface, 1}, {waves, is_odd}, out, state.memory.whole());
}

namespace
{

/// The parts of a layer whose spans are not empty.
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
  if (first + out.size() > state.depths.size())
    throw InternalError(
        fmt::format("ThermalField::layers: layer {} of {}", first + out.size() - 1, state.depths.size()));
  std::vector<std::span<double>> fields;
  for (const ThermalLayer& layer : out)
    for (const std::span<double>& field : wanted(layer, grid().size()))
      fields.push_back(field);
  if (!fields.empty())
    state.find_layers(duration, {first, out.size()}, out.front(), fields, state.memory.whole());
}

bool ThermalField::holds(const SurfaceGrid& cells) const
{
  return cells.nx <= grid().nx && cells.ny <= grid().ny && (grid().nx - cells.nx) % 2 == 0 &&
         (grid().ny - cells.ny) % 2 == 0;
}

void ThermalField::in_body(const VolumeGrid& body, const ThermalLayer& out, std::size_t first) const
{
  const State& state = *state_;
  const SurfaceGrid& cells = body.surface;
  const auto count = static_cast<std::size_t>(body.nz);
  if (!holds(cells) || first + count > state.depths.size())
    throw InternalError("ThermalField::in_body: the body is not within the grid and the layers");
  require_part("ThermalField::in_body", "temperature", out.temperature, body.size());
  require_part("ThermalField::in_body", "deviator", out.deviator, Deviator::size * body.size());
  require_part("ThermalField::in_body", "trace", out.trace, body.size());
  std::vector<std::span<double>> fields;
  for (std::size_t k = 0; k < count; ++k)
    for (const std::span<double>& part : {out.temperature, out.trace, out.deviator})
      for (std::size_t at = k * cells.size(); at < part.size(); at += body.size())
        fields.push_back(part.subspan(at, cells.size()));
  if (!fields.empty())
    state.find_layers(0.0, {first, count}, out, fields,
                      {(grid().nx - cells.nx) / 2, cells.nx, (grid().ny - cells.ny) / 2, cells.ny});
}

} // namespace brinell::halfspace
