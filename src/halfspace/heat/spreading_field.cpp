// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/spreading_field.hpp"

#include "brinell/foundation/error.hpp"
#include "foundation/fft.hpp"
#include "foundation/require_size.hpp"
#include "steady_displacement.hpp"
#include "steady_lattices.hpp"

#include <cmath>

namespace brinell::halfspace
{

namespace
{

/// Potential of a unit flux through one cell of an open grid, at each depth.
std::vector<AlignedVector<Complex>> open_spectra(const PaddedFft& fft, const std::vector<double>& depths)
{
  constexpr Thermal unit{.conductivity = 1.0, .density = 1.0, .specific_heat = 1.0, .expansion = 0.0};
  const auto waves = [](const SurfaceWave&, double, const ThermalWave& heat, std::span<Complex> out)
  { out[0] = heat.temperature; };
  std::vector<AlignedVector<Complex>> spectra;
  for (const std::vector<double>& table : SteadyLattices(fft.grid(), unit, 0.0).tables(depths, {waves, {false}}))
    spectra.push_back(spectrum_of_offsets(fft, table));
  return spectra;
}

/// e^(-k z)/k at each depth.
std::vector<AlignedVector<Complex>> periodic_spectra(const PaddedFft& fft, const std::vector<double>& depths)
{
  std::vector<AlignedVector<Complex>> spectra;
  for (const double depth : depths)
  {
    AlignedVector<Complex>& spectrum = spectra.emplace_back(fft.plane());
    for (int j = 0; j < fft.rows(); ++j)
      for (int i = 0; i < fft.kx(); ++i)
        if (const double k = std::hypot(fft.wavenumber_x(i), fft.wavenumber_y(j)); k > 0.0)
          spectrum[static_cast<std::size_t>(j) * static_cast<std::size_t>(fft.kx()) + static_cast<std::size_t>(i)] =
              std::exp(-k * depth) / k;
  }
  return spectra;
}

} // namespace

struct SpreadingField::State
{
  PaddedFft fft;
  std::vector<AlignedVector<Complex>> of_depths;
};

SpreadingField::SpreadingField(const SurfaceGrid& grid, const std::vector<double>& depths)
{
  if (grid.is_periodic_x() != grid.is_periodic_y())
    throw InputError("SpreadingField: a grid with one periodic axis; allowed: both axes open, or both periodic");
  for (const double depth : depths)
    if (!(depth >= 0.0 && std::isfinite(depth)))
      throw InputError("SpreadingField: a depth below 0; allowed: numbers >= 0");
  state_ = make_hidden<State>(PaddedFft(grid), std::vector<AlignedVector<Complex>>());
  state_->of_depths = grid.is_periodic() ? periodic_spectra(state_->fft, depths) : open_spectra(state_->fft, depths);
}

void SpreadingField::potential(std::span<const double> flux, std::span<double> out) const
{
  const PaddedFft& fft = state_->fft;
  const std::size_t cells = fft.grid().size();
  require_size("SpreadingField::potential: the flux", flux, cells);
  require_size("SpreadingField::potential: the potential", out, cells * state_->of_depths.size());
  const AlignedVector<Complex> spectrum = fft.forward(flux);
  AlignedVector<Complex> product(fft.plane());
  for (std::size_t d = 0; d < state_->of_depths.size(); ++d)
  {
    for (std::size_t i = 0; i < spectrum.size(); ++i)
      product[i] = spectrum[i] * state_->of_depths[d][i];
    fft.inverse(product.data(), out.subspan(d * cells, cells));
  }
}

} // namespace brinell::halfspace
