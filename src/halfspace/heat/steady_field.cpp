// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/steady_field.hpp"

#include "brinell/foundation/deviator.hpp"
#include "foundation/require_size.hpp"
#include "halfspace/transform/require_surface.hpp"
#include "steady_displacement.hpp"

#include <cmath>
#include <fmt/format.h>

namespace brinell::halfspace
{

namespace
{

/// Number of fields of a layer: temperature, trace, and components of the deviator.
constexpr std::size_t parts = 2 + Deviator::size;

void require_depths(const std::vector<double>& depths, const Thermal& thermal, const Elastic& elastic)
{
  for (const double depth : depths)
    if (!(depth >= 0.0) || std::isinf(depth))
      throw InputError(fmt::format("SteadyField: a depth of {} m; allowed: 0 and above", depth));
  if (elastic.is_rigid() && !depths.empty())
    throw InputError("SteadyField: a rigid body has no stress at any depth; allowed: an elastic body, or no depths");
  if (!std::isfinite(thermal.expansion))
    throw InputError(fmt::format("SteadyField: expansion = {}; allowed: a finite number", thermal.expansion));
}

/// Fields by a unit flux through one cell, [depth][part][offset].
std::vector<std::vector<double>> layer_tables(const SteadyLattices& lattices, const Thermal& thermal,
                                              const Elastic& elastic, const std::vector<double>& depths)
{
  const double nu = elastic.poisson_ratio;
  const double scale = 2.0 * elastic.shear_modulus() * thermal.expansion * (1.0 + nu) / (1.0 - nu);
  const auto waves = [&](const SurfaceWave& along, double depth, const ThermalWave& heat, std::span<Complex> out)
  {
    const StressWave stress = stress_wave(along, depth, heat, nu);
    const Complex trace = scale * stress.trace(), mean = trace / 3.0;
    out[0] = heat.temperature;
    out[1] = trace;
    out[2] = scale * stress.xx - mean;
    out[3] = scale * stress.yy - mean;
    out[4] = scale * stress.yz;
    out[5] = scale * stress.xz;
    out[6] = scale * stress.xy;
  };
  std::vector<bool> is_odd{false, false};
  for (int c = 0; c < Deviator::size; ++c)
    is_odd.push_back(is_odd_in_y(c));
  return lattices.tables(depths, {waves, is_odd});
}

} // namespace

struct SteadyField::State
{
  std::vector<double> depths;
  PaddedFft fft;
  SteadyLattices lattices;
  Thermal thermal;
  Elastic elastic;
  SteadyMotion motion;
  AlignedVector<Complex> of_displacement{};
  std::vector<AlignedVector<Complex>> of_layers{}; ///< [depth][part]

  /// Convolves the flux with some of the spectra.
  struct Convolution
  {
    const PaddedFft& fft;
    AlignedVector<Complex> flux, product;

    Convolution(const PaddedFft& given, std::span<const double> field)
        : fft(given), flux(given.forward(field)), product(given.plane())
    {
    }
    void operator()(const AlignedVector<Complex>& spectrum, std::span<double> out, bool is_odd = false)
    {
      for (std::size_t i = 0; i < flux.size(); ++i)
        product[i] = flux[i] * spectrum[i];
      fft.inverse(product.data(), out, is_odd);
    }
  };
};

SteadyField::SteadyField(const SurfaceGrid& grid, const Thermal& thermal, const Elastic& elastic,
                         const SteadyMotion& motion, std::vector<double> depths)
{
  require_steady("SteadyField", grid, thermal, motion);
  require_depths(depths, thermal, elastic);
  state_ = make_hidden<State>(std::move(depths), PaddedFft(grid), SteadyLattices(grid, thermal, motion.velocity),
                              thermal, elastic, motion);
  State& state = *state_;
  if (motion.velocity != 0.0 || motion.reference)
    state.of_displacement =
        spectrum_of_offsets(state.fft, steady_displacement(state.lattices, thermal, elastic, motion));
  for (const std::vector<double>& table : layer_tables(state.lattices, thermal, elastic, state.depths))
    state.of_layers.push_back(spectrum_of_offsets(state.fft, table));
}

const SurfaceGrid& SteadyField::grid() const
{
  return state_->fft.grid();
}

const std::vector<double>& SteadyField::depths() const
{
  return state_->depths;
}

void SteadyField::displacement(std::span<const double> flux, std::span<double> out) const
{
  require_size("SteadyField::displacement: the flux", flux, grid().size());
  require_size("SteadyField::displacement: the displacement", out, grid().size());
  if (state_->of_displacement.empty())
    throw InputError(
        "SteadyField::displacement: under a flux at rest the displacement has no limit: it grows with the logarithm of "
        "the distance; allowed: a reference, the distance at which the displacement is zero, or a velocity");
  State::Convolution(state_->fft, flux)(state_->of_displacement, out);
}

void SteadyField::layers(std::span<const double> flux, std::size_t first, std::span<const ThermalLayer> out) const
{
  const std::size_t cells = grid().size();
  require_size("SteadyField::layers: the flux", flux, cells);
  if (first + out.size() > depths().size())
    throw InternalError(fmt::format("SteadyField::layers: layer {} of {}", first + out.size() - 1, depths().size()));
  State::Convolution convolve(state_->fft, flux);
  for (std::size_t d = 0; d < out.size(); ++d)
  {
    const auto spectrum = state_->of_layers.begin() + static_cast<std::ptrdiff_t>((first + d) * parts);
    const ThermalLayer& layer = out[d];
    require_part("SteadyField::layers", "temperature", layer.temperature, cells);
    require_part("SteadyField::layers", "deviator", layer.deviator, Deviator::size * cells);
    require_part("SteadyField::layers", "trace", layer.trace, cells);
    if (!layer.temperature.empty())
      convolve(spectrum[0], layer.temperature);
    if (!layer.trace.empty())
      convolve(spectrum[1], layer.trace);
    for (std::size_t c = 0; c < Deviator::size && !layer.deviator.empty(); ++c)
      convolve(spectrum[2 + static_cast<std::ptrdiff_t>(c)], layer.deviator.subspan(c * cells, cells),
               is_odd_in_y(static_cast<int>(c)));
  }
}

} // namespace brinell::halfspace
