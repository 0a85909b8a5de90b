// SPDX-License-Identifier: BSD-3-Clause
#include "eigenstrain_stress.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace brinell::halfspace
{

namespace
{

using layer_waves::Factors;
using layer_waves::Field;
using layer_waves::Wave;
using Layer = EigenstrainStress::Layer;

} // namespace

EigenstrainStress::EigenstrainStress(const VolumeGrid& grid, const Elastic& elastic, const BlockedFft& fft,
                                     const layer_waves::Shortest& shortest)
    : grid_(grid), nu_(elastic.poisson_ratio), mu_(elastic.shear_modulus()), fft_(fft),
      spectra_bytes_(static_cast<std::size_t>(fft.blocks()) * static_cast<std::size_t>(fft.py()) *
                     static_cast<std::size_t>(Deviator::size * grid.nz) * sizeof(ComplexLanes))
{
  const int rows = fft.py() / 2 + 1;
  factors_.resize(static_cast<std::size_t>(fft.blocks() * rows));
  for (int i = 0; i < fft.kx(); ++i)
    for (int row = 0; row < rows; ++row)
    {
      const double m = 2.0 * std::numbers::pi * i / (fft.px() * grid.surface.dx);
      const double n = 2.0 * std::numbers::pi * row / (fft.py() * grid.surface.dy);
      factors_[static_cast<std::size_t>(i / lane_count * rows + row)].set(
          static_cast<std::size_t>(i % lane_count), m, n, 2 * i == fft.px() ? std::sqrt(shortest.x) : 1.0,
          2 * row == fft.py() ? std::sqrt(shortest.y) : 1.0, grid.dz, nu_, mu_);
    }
}

/// Rows that are propagated through the layers together.
struct EigenstrainStress::Tile
{
  std::array<const Factors*, SpectrumRows::most> factors;
  std::array<Wave, SpectrumRows::most> waves;
};

void EigenstrainStress::apply(int block, const SpectrumRows& rows, const Spectra& spectra, Scratch& scratch) const
{
  const auto factors_at = [&](int r)
  { return &factors_[static_cast<std::size_t>(block * (fft_.py() / 2 + 1) + fft_.folded(rows.first + r))]; };
  Tile tile;
  for (int r = 0; r < rows.count; ++r)
    tile.factors[static_cast<std::size_t>(r)] = factors_at(r);
  if (rows.first == fft_.folded(rows.first))
    return go_through(rows, spectra, tile, scratch);
  std::array<Factors, SpectrumRows::most> opposite;
  for (int r = 0; r < rows.count; ++r)
  {
    Factors& f = opposite[static_cast<std::size_t>(r)] = *factors_at(r);
    f.ly = -f.ly;
    f.lxly = -f.lxly;
    tile.factors[static_cast<std::size_t>(r)] = &f;
  }
  go_through(rows, spectra, tile, scratch);
}

void EigenstrainStress::go_through(const SpectrumRows& rows, const Spectra& spectra, Tile& tile, Scratch& scratch) const
{
  go_up(rows, spectra, tile, scratch);
  for (int r = 0; r < rows.count; ++r)
  {
    Wave& wave = tile.waves[static_cast<std::size_t>(r)];
    wave = reflect(*tile.factors[static_cast<std::size_t>(r)], wave);
  }
  go_down(rows, spectra, tile, scratch);
}

/// Upward pass: stores the stress of the layers below; the sums that reach the surface determine the image.
void EigenstrainStress::go_up(const SpectrumRows& rows, const Spectra& spectra, Tile& tile, Scratch& scratch) const
{
  const std::ptrdiff_t pitch = fft_.pitch();
  for (std::ptrdiff_t i = spectra.strained - 1; i >= 0; --i)
    for (std::ptrdiff_t r = 0; r < rows.count; ++r)
    {
      const Factors& f = *tile.factors[static_cast<std::size_t>(r)];
      Wave& up = tile.waves[static_cast<std::size_t>(r)];
      Layer& layer = scratch[static_cast<std::size_t>(i * SpectrumRows::most + r)];
      const Field below = emit(f, up);
      const ComplexLanes* strain = spectra.strain + i * Deviator::size * pitch + rows.first + r;
      if (i > 0)
        for (int c = 1; c <= Deviator::size; ++c)
          fetch_soon(strain - c * pitch); // of the next layer: so far apart that the processor does not expect it
      layer = {green::in_wave_frame<Lanes>(f, nu_, strain[0], strain[pitch], strain[2 * pitch], strain[3 * pitch],
                                           strain[4 * pitch]),
               below.ll, below.zz, below.lz, below.lt};
      advance(f, layer.strain, -1.0, up);
    }
}

/// Downward pass: adds the stress of the image, of the layers above, of those below and of the layer itself, and transforms it to
/// the axes x, y, z.
void EigenstrainStress::go_down(const SpectrumRows& rows, const Spectra& spectra, Tile& tile,
                                const Scratch& scratch) const
{
  const bool past_caches = spectra_bytes_ > cached_bytes;
  const std::ptrdiff_t pitch = fft_.pitch();
  for (std::ptrdiff_t i = 0; i < spectra.layers; ++i)
    for (std::ptrdiff_t r = 0; r < rows.count; ++r)
    {
      const Factors& f = *tile.factors[static_cast<std::size_t>(r)];
      Wave& down = tile.waves[static_cast<std::size_t>(r)];
      Field s = emit(f, down);
      ComplexLanes tz;
      if (i < spectra.strained)
      {
        const Layer& layer = scratch[static_cast<std::size_t>(i * SpectrumRows::most + r)];
        tz = add_own(f, layer, s);
        advance(f, layer.strain, 1.0, down);
      }
      else
      {
        tz = times_i(s.lt);
        s.lz = times_i(s.lz);
        pass(f, down);
      }
      const auto axes = green::in_axes<Lanes>(f, nu_, s.ll, s.zz, s.lz, s.lt, tz);
      ComplexLanes* stress = spectra.stress + i * Deviator::size * pitch + rows.first + r;
      for (int c = 0; !past_caches && i + 1 < spectra.layers && c < Deviator::size; ++c)
        write_soon(stress + (Deviator::size + c) * pitch); // of the next layer
      for (const ComplexLanes& component : {axes.xx, axes.yy, axes.yz, axes.xz, axes.xy})
      {
        store_lanes(component, stress, past_caches);
        stress += pitch;
      }
      if (spectra.trace != nullptr)
        spectra.trace[i * pitch + rows.first + r] = axes.trace;
    }
  end_streaming();
}

} // namespace brinell::halfspace
