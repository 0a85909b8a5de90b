// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/deviator.hpp"
#include "brinell/green/elastic.hpp"
#include "foundation/lane_functions.hpp"
#include "green/sheet_waves.hpp"

#include <array>
#include <cstddef>

/// Waves of plastic strain that pass from one layer of cells to the next, as running sums: EigenstrainStress has those of a
/// homogeneous body, StackStress those of the layers of a stack.
namespace brinell::halfspace::layer_waves
{

/// Factors of one block of wavenumbers. All couplings are zero for k = 0 and in lanes without a wavenumber.
/// At a Nyquist index lx or ly is zero, or reduced; this also drops the couplings of even order through the shears yz and xz,
/// which are negligible for a strain that the cells resolve. The contribution of couplings of odd order there is imaginary in a
/// row along x and is ignored by the inverse transform of the row.
struct Factors : green::WaveDirection<Lanes>
{
  Lanes q{};                    ///< e^{-x}, x = k dz: decay over a layer
  Lanes e0{}, e1{}, e2{}, e3{}; ///< stress of arriving waves in the next layer
  Lanes m0{}, m1{}, m2{};       ///< stress of a layer in the layer itself
  Lanes x{}, rise{}, lag{};     ///< conversion of a wave at a boundary of layers to that of a sheet there

  /// @param kept_x, kept_y  fractions of m / k and n / k that are retained
  void set(std::size_t lane, double m, double n, double kept_x, double kept_y, double dz, double nu, double mu);
};

/// Amplitudes of the waves in one direction, each a running sum over the layers passed.
struct Wave
{
  ComplexLanes a, c, c1, w; ///< sum of a, of c, of c times the number of layers passed, and of w
};

/// Stress in the frame of the wavevector; lz and lt also stand for the shears lz and tz, without their factor +-i.
struct Field
{
  ComplexLanes ll, zz, lz, lt;
};

/// Values of a layer that an upward pass stores for the downward pass.
struct Layer
{
  green::SheetStrain<ComplexLanes> strain;
  ComplexLanes below_ll, below_zz, below_lz, below_lt; ///< stress of the waves from below
};

/// Mean stress in the next layer of the waves that arrive there.
inline Field emit(const Factors& f, const Wave& wave)
{
  const ComplexLanes ea = f.e0 * wave.a;
  const ComplexLanes ec = f.e0 * wave.c;
  const ComplexLanes sc = f.e1 * wave.c1 - f.e2 * wave.c;
  const ComplexLanes lz = ea + ec - sc;
  return {lz + ec, sc - ea, lz, f.e3 * wave.w};
}

/// Propagates the waves through one layer and adds those of its strain; g = +1 downwards, -1 upwards.
inline void advance(const Factors& f, const green::SheetStrain<ComplexLanes>& strain, double g, Wave& wave)
{
  const green::SheetWave<ComplexLanes> source = green::wave_of(strain, g);
  wave.c1 = f.q * (wave.c1 + wave.c) + source.c;
  wave.c = f.q * wave.c + source.c;
  wave.a = f.q * wave.a + source.a;
  wave.w = f.q * wave.w + source.w;
}

/// Propagates the waves through one layer without strain.
inline void pass(const Factors& f, Wave& wave)
{
  wave.c1 = f.q * (wave.c1 + wave.c);
  wave.c = f.q * wave.c;
  wave.a = f.q * wave.a;
  wave.w = f.q * wave.w;
}

/// Sum of k z' c over the layers passed, for waves at a boundary of layers.
inline ComplexLanes lagging(const Factors& f, const Wave& wave)
{
  return f.x * (wave.c1 - 0.5 * wave.c) - f.rise * wave.c;
}

/// The waves at a boundary of layers, like those of a sheet there.
inline green::SheetWave<ComplexLanes> at_boundary(const Factors& f, const Wave& wave)
{
  return {wave.a - lagging(f, wave), wave.c, wave.w};
}

/// The running sums of a wave that starts at a boundary of layers. The amplitudes are such that `emit` gives the mean over the next
/// layer of a sheet at the boundary, where it expects layers behind.
inline Wave from_boundary(const Factors& f, const green::SheetWave<ComplexLanes>& wave)
{
  return {wave.a, wave.c, f.lag * wave.c, wave.w};
}

/// Adds the stress of a layer in itself and that of the layers below to the stress `s` of the layers above. @returns the total
/// tz: for the layers above and below it follows from lt up to the factor +-i, but not for the layer itself.
inline ComplexLanes add_own(const Factors& f, const Layer& layer, Field& s)
{
  const green::SheetStrain<ComplexLanes>& own = layer.strain;
  const ComplexLanes held = f.m0 * own.a - f.m1 * own.d;
  const Lanes twice = 2.0 * f.m0;
  const ComplexLanes tz = times_i(s.lt - layer.below_lt) - f.m2 * own.tz;
  s.ll = s.ll + layer.below_ll + held + twice * own.d;
  s.zz = s.zz + layer.below_zz - held;
  s.lz = times_i(s.lz - layer.below_lz) - (twice - 2.0 * f.m1) * own.lz;
  s.lt = s.lt + layer.below_lt + f.m2 * own.lt;
  return tz;
}

/// Adds the local stress [Pa]: that of a uniform, unbounded layer held in its plane (plane stress across it). One component of its
/// deviator, or for component 5 its trace, over `cells` cells.
/// @param strain  components of the strain of the same cells
void add_local(const Elastic& elastic, int component, const std::array<const double*, Deviator::size>& strain,
               std::size_t cells, double* stress);

} // namespace brinell::halfspace::layer_waves
