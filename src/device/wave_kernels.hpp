// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/deviator.hpp"
#include "brinell/foundation/grid.hpp"
#include "brinell/foundation/host_device.hpp"
#include "foundation/complex_number.hpp"
#include "halfspace/strain/passing_waves.hpp"
#include "halfspace/traction/traction_waves.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

/// Kernels of a half space, each what one thread does: a wavenumber, or a cell. A field of deviators is [component][layer][cell],
/// its spectrum [component][layer][row][column].
namespace brinell::device
{

/// Wavenumbers of transforms of px times py values: rows of wrapped indices along y, columns of indices >= 0 along x.
struct SurfaceWaves
{
  int px = 0, py = 0;
  double dx = 0.0, dy = 0.0;

  [[nodiscard]] BRINELL_HOST_DEVICE int columns() const { return px / 2 + 1; }
  [[nodiscard]] BRINELL_HOST_DEVICE std::size_t size() const
  {
    return static_cast<std::size_t>(columns()) * static_cast<std::size_t>(py);
  }
  [[nodiscard]] BRINELL_HOST_DEVICE int column(std::size_t wave) const
  {
    return static_cast<int>(wave % static_cast<std::size_t>(columns()));
  }
  [[nodiscard]] BRINELL_HOST_DEVICE int row(std::size_t wave) const
  {
    return static_cast<int>(wave / static_cast<std::size_t>(columns()));
  }
  /// Whether the wavenumber along y is below 0.
  [[nodiscard]] BRINELL_HOST_DEVICE bool is_below(std::size_t wave) const { return row(wave) > py / 2; }
  /// The wave with the magnitude of the wavenumber along y, of which there are `stored`.
  [[nodiscard]] BRINELL_HOST_DEVICE std::size_t folded(std::size_t wave) const
  {
    return static_cast<std::size_t>(is_below(wave) ? py - row(wave) : row(wave)) * static_cast<std::size_t>(columns()) +
           static_cast<std::size_t>(column(wave));
  }
  [[nodiscard]] BRINELL_HOST_DEVICE std::size_t stored() const
  {
    return static_cast<std::size_t>(columns()) * static_cast<std::size_t>(py / 2 + 1);
  }
  /// Whether the wave is the shortest one, whose sign is not defined.
  [[nodiscard]] BRINELL_HOST_DEVICE bool is_shortest_x(std::size_t wave) const { return 2 * column(wave) == px; }
  [[nodiscard]] BRINELL_HOST_DEVICE bool is_shortest_y(std::size_t wave) const { return 2 * row(wave) == py; }
  /// Wavenumbers [rad/m].
  [[nodiscard]] BRINELL_HOST_DEVICE double m(std::size_t wave) const
  {
    return 2.0 * std::numbers::pi * column(wave) / (px * dx);
  }
  [[nodiscard]] BRINELL_HOST_DEVICE double n(std::size_t wave) const
  {
    return 2.0 * std::numbers::pi * (is_below(wave) ? row(wave) - py : row(wave)) / (py * dy);
  }
};

/// Kernels of a component of the traction.
struct TractionKernels
{
  SurfaceWaves waves;
  Traction traction;
  int layers;
  double dz, nu;
  const double* table = nullptr; ///< BoundaryParts::kernels; nullptr: those of waves

  /// Numbers of the deviator at one wavenumber in one layer, without the factor i of those that are imaginary.
  [[nodiscard]] BRINELL_HOST_DEVICE std::array<double, Deviator::size> at(std::size_t wave, int layer) const
  {
    std::array<double, Deviator::size> numbers;
    std::array<double, Deviator::size + 1> of_wave{};
    if (table == nullptr)
      of_wave = wave_numbers(wave, layer);
    for (int c = 0; c < Deviator::size; ++c)
    {
      const halfspace::Oddness odd = halfspace::oddness(traction, c);
      double& number = numbers[static_cast<std::size_t>(c)];
      if (table != nullptr)
      {
        number = table[static_cast<std::size_t>(layer * Deviator::size + c) * waves.stored() + waves.folded(wave)];
        number = odd.y && waves.is_below(wave) ? -number : number;
      }
      else // at the shortest wave an odd function cannot be represented on the grid
        number = (odd.x && waves.is_shortest_x(wave)) || (odd.y && waves.is_shortest_y(wave))
                     ? 0.0
                     : of_wave[static_cast<std::size_t>(c)];
    }
    return numbers;
  }

private:
  [[nodiscard]] BRINELL_HOST_DEVICE std::array<double, Deviator::size + 1> wave_numbers(std::size_t wave,
                                                                                        int layer) const
  {
    const double m = waves.m(wave), n = waves.n(wave), k = std::hypot(m, n);
    return halfspace::kernel_values(
        k == 0.0 ? halfspace::uniform_stress(traction, nu)
                 : halfspace::wave_stress(traction, m / k, n / k, halfspace::mean_decay(k * dz, layer), nu));
  }
};

/// Spectrum of the stress at one wavenumber by the plastic strain of all layers, without its local part, and by the traction.
struct StressOfWave
{
  using Factors = halfspace::layer_waves::FactorsOf<double>;

  SurfaceWaves waves;
  int layers;
  double dz, nu;
  const Factors* factors;           ///< of the `stored` waves
  const ComplexNumber* strain;      ///< nullptr: none
  const ComplexNumber* traction[3]; ///< in the order of Traction; nullptr: none
  const double* kernels[3];         ///< BoundaryParts::kernels
  ComplexNumber* stress;

  BRINELL_HOST_DEVICE void operator()(std::size_t wave) const
  {
    Factors f = factors[waves.folded(wave)];
    if (waves.is_below(wave))
    {
      f.ly = -f.ly;
      f.lxly = -f.lxly;
    }
    bool adds = strain != nullptr;
    if (adds)
      pass_down(f, wave, halfspace::layer_waves::reflect(f, pass_up(f, wave)));
    for (int t = 0; t < 3; ++t)
      if (traction[t] != nullptr)
      {
        add_traction(static_cast<Traction>(t), traction[t][wave], adds, wave);
        adds = true;
      }
    for (int plane = 0; !adds && plane < Deviator::size * layers; ++plane)
      stress[at(0, plane, wave)] = {};
  }

private:
  using Wave = halfspace::layer_waves::WaveOf<ComplexNumber>;
  using Field = halfspace::layer_waves::FieldOf<ComplexNumber>;

  [[nodiscard]] BRINELL_HOST_DEVICE std::size_t at(int c, int layer, std::size_t wave) const
  {
    return (static_cast<std::size_t>(c) * static_cast<std::size_t>(layers) + static_cast<std::size_t>(layer)) *
               waves.size() +
           wave;
  }
  [[nodiscard]] BRINELL_HOST_DEVICE green::SheetStrain<ComplexNumber> strain_of(const Factors& f, int layer,
                                                                                std::size_t wave) const
  {
    using D = Deviator;
    return green::in_wave_frame<double>(f, nu, strain[at(D::xx, layer, wave)], strain[at(D::yy, layer, wave)],
                                        strain[at(D::yz, layer, wave)], strain[at(D::xz, layer, wave)],
                                        strain[at(D::xy, layer, wave)]);
  }
  /// Upward pass: until the downward pass, the stress of a layer has the place for that of the waves from below.
  BRINELL_HOST_DEVICE Wave pass_up(const Factors& f, std::size_t wave) const
  {
    Wave up{};
    for (int layer = layers - 1; layer >= 0; --layer)
    {
      const Field below = emit(f, up);
      stress[at(0, layer, wave)] = below.ll;
      stress[at(1, layer, wave)] = below.zz;
      stress[at(2, layer, wave)] = below.lz;
      stress[at(3, layer, wave)] = below.lt;
      advance(f, strain_of(f, layer, wave), -1.0, up);
    }
    return up;
  }
  BRINELL_HOST_DEVICE void pass_down(const Factors& f, std::size_t wave, Wave down) const
  {
    for (int layer = 0; layer < layers; ++layer)
    {
      Field s = emit(f, down);
      const halfspace::layer_waves::LayerOf<ComplexNumber> own{strain_of(f, layer, wave), stress[at(0, layer, wave)],
                                                               stress[at(1, layer, wave)], stress[at(2, layer, wave)],
                                                               stress[at(3, layer, wave)]};
      const ComplexNumber tz = add_own(f, own, s);
      advance(f, own.strain, 1.0, down);
      const auto axes = green::in_axes<double>(f, nu, s.ll, s.zz, s.lz, s.lt, tz);
      stress[at(Deviator::xx, layer, wave)] = axes.xx;
      stress[at(Deviator::yy, layer, wave)] = axes.yy;
      stress[at(Deviator::yz, layer, wave)] = axes.yz;
      stress[at(Deviator::xz, layer, wave)] = axes.xz;
      stress[at(Deviator::xy, layer, wave)] = axes.xy;
    }
  }
  BRINELL_HOST_DEVICE void add_traction(Traction of, const ComplexNumber& amplitude, bool adds, std::size_t wave) const
  {
    const TractionKernels of_traction{waves, of, layers, dz, nu, kernels[static_cast<int>(of)]};
    for (int layer = 0; layer < layers; ++layer)
    {
      const std::array<double, Deviator::size> kernel = of_traction.at(wave, layer);
      for (int c = 0; c < Deviator::size; ++c)
      {
        const halfspace::Oddness odd = halfspace::oddness(of, c);
        const ComplexNumber part =
            kernel[static_cast<std::size_t>(c)] * (odd.x != odd.y ? times_i(amplitude) : amplitude);
        ComplexNumber& total = stress[at(c, layer, wave)];
        total = adds ? total + part : part;
      }
    }
  }
};

/// Spectrum of the displacement of the surface by the plastic strain, conjugate to a traction.
struct DisplacementOfWave
{
  TractionKernels kernels;
  const ComplexNumber* strain;
  ComplexNumber* displacement;

  BRINELL_HOST_DEVICE void operator()(std::size_t wave) const
  {
    ComplexNumber sum;
    for (int layer = 0; layer < kernels.layers; ++layer)
    {
      const std::array<double, Deviator::size> kernel = kernels.at(wave, layer);
      const auto strain_of = [&](int c)
      { return strain[static_cast<std::size_t>(c * kernels.layers + layer) * kernels.waves.size() + wave]; };
      sum =
          sum + kernels.dz * halfspace::betti_product(
                                 kernels.traction == Traction::pressure,
                                 [&](int c, const ComplexNumber& e) { return kernel[static_cast<std::size_t>(c)] * e; },
                                 strain_of(Deviator::xx), strain_of(Deviator::yy), strain_of(Deviator::yz),
                                 strain_of(Deviator::xz), strain_of(Deviator::xy));
    }
    displacement[wave] = sum;
  }
};

/// Scales the inverse transform of the stress in a cell, and adds the local stress of its plastic strain.
struct FinishStress
{
  halfspace::layer_waves::HeldLayer held;
  std::size_t cells; ///< of the volume
  double scale;
  const double* strain; ///< nullptr: none
  double* stress;

  BRINELL_HOST_DEVICE void operator()(std::size_t cell) const
  {
    using D = Deviator;
    for (int c = 0; c < D::size; ++c)
      stress[static_cast<std::size_t>(c) * cells + cell] *= scale;
    if (strain == nullptr)
      return;
    const double xx = strain[D::xx * cells + cell], yy = strain[D::yy * cells + cell];
    stress[D::xx * cells + cell] += held.own * xx + held.other * yy;
    stress[D::yy * cells + cell] += held.other * xx + held.own * yy;
    stress[D::xy * cells + cell] += held.shear * strain[D::xy * cells + cell];
  }
};

/// Sets values to zero, whatever they were: a product with zero would leave NaN.
struct SetZero
{
  double* values;

  BRINELL_HOST_DEVICE void operator()(std::size_t n) const { values[n] = 0.0; }
};

struct Scale
{
  double factor;
  double* values;

  BRINELL_HOST_DEVICE void operator()(std::size_t n) const { values[n] *= factor; }
};

} // namespace brinell::device
