// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/deviator.hpp"
#include "brinell/foundation/share.hpp"
#include "brinell/green/stack.hpp"
#include "brinell/green/traction.hpp"
#include "foundation/blocked_fft.hpp"
#include "foundation/fft.hpp"
#include "halfspace/transform/parity_spectrum.hpp"
#include "stack_cells.hpp"

#include <array>

namespace brinell::halfspace
{

/// A value for each component of the traction on the surface, or for the displacement component conjugate to it.
template <typename Value>
using OfTraction = std::array<Value, 3>;

/// One component of the traction on the surface -> stress under it, and the transpose: plastic strain -> displacement of the
/// surface along that component.
///
/// Closed form of the uniformly loaded rectangle (Love 1929, Cerruti), one convolution per layer; the value of a cell is the
/// mean over the layer's thickness at the middle of the cell in x and y. On a grid with two periodic axes, waves are used
/// instead. The transpose follows from Betti's theorem,
///   u(x) = integral of s^(unit load at x) : eps_p dV,    docs/theory/half-space.md (residual-displacement),
/// with the same coefficients, so the discrete system is symmetric.
///
/// Works on the spectra of single blocks of BlockedFft.
class TractionStress
{
public:
  /// @param fft     transform of single planes on the surface of `grid`; must outlive this object.
  /// @param blocks  of wavenumbers that will be asked for
  TractionStress(const VolumeGrid& grid, const ElasticStack& stack, const BlockedFft& fft, Traction traction,
                 const Portion& blocks);
  TractionStress(const VolumeGrid& grid, const ElasticStack& stack, const BlockedFft& fft, Traction traction)
      : TractionStress(grid, stack, fft, traction, {0, 1, fft.blocks()})
  {
  }

  /// The stored number of the spectrum of a kernel at a wavenumber >= 0 along y: `oddness` tells its phase.
  [[nodiscard]] double number(int row, int column, int layer, int component) const
  {
    return kernel(column / lane_count, layer, component)[row][column % lane_count];
  }
  static constexpr int trace = Deviator::size; ///< component index of the trace, after those of the deviator
  /// Adds one component of the stress in one layer by all components of the traction that are not zero, in one pass.
  /// @param kernels        one per component of the traction; nullptr if that component is zero
  /// @param rows           number of rows of the spectra that are computed, from the first one
  /// @param traction       [row]
  /// @param stress, total  [row] [Pa]; may be the same
  /// @param next           the stress of the same plane in the next block, which is prefetched together with its kernels;
  ///                       `stress` itself in the last block
  static void add(const OfTraction<const TractionStress*>& kernels, int block, int component, int layer, int rows,
                  const OfTraction<const ComplexLanes*>& traction, const ComplexLanes* stress, const ComplexLanes* next,
                  ComplexLanes* total);
  /// Adds the displacement of the surface [m] by the plastic strain in one layer, in the direction of this traction component.
  /// @param strain        [component][pitch], traceless
  /// @param displacement  [row]
  void add_displacement(int block, int layer, int rows, const ComplexLanes* strain, ComplexLanes* displacement) const;
  /// Displacement by a dilatation, a strain that is equal in all directions, [row].
  void add_displacement_by_dilatation(int block, int layer, int rows, const ComplexLanes* dilatation,
                                      ComplexLanes* displacement) const;

private:
  /// Kernels of a layer, one per component of the stress.
  enum : int
  {
    xx = Deviator::xx,
    yy = Deviator::yy,
    yz = Deviator::yz,
    xz = Deviator::xz,
    xy = Deviator::xy,
    kernel_count = trace + 1
  };
  [[nodiscard]] Parity parity(int which) const;
  [[nodiscard]] const Lanes* kernel(int block, int layer, int which) const;
  void set(int row, int column, int layer, int which, double value);
  void tabulate_cells(int layer, const ElasticStack& stack, const ExcessStress* excess, const PaddedFft& fft);
  void tabulate_waves(int layer, const ElasticStack& stack, const PaddedFft& fft);

  VolumeGrid grid_;
  const BlockedFft& fft_;
  Traction traction_;
  int rows_; ///< stored rows, ky >= 0
  Portion blocks_;
  /// [block][layer][kernel][row]. Every kernel is even or odd in x and in y; the imaginary part of its spectrum is stored if it
  /// is odd in exactly one of them, otherwise the real part.
  AlignedVector<Lanes> kernels_;
};

} // namespace brinell::halfspace
