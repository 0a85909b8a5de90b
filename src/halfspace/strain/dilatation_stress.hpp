// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/halfspace/surface_load.hpp"
#include "halfspace/traction/traction_stress.hpp"
#include "image_correction.hpp"
#include "layer_waves.hpp"

#include <functional>
#include <vector>

namespace brinell::halfspace
{

/// Dilatation -> residual stress in a homogeneous half space whose surface is free of traction: the counterpart of
/// EigenstrainStress for a strain e, the same in all directions, that free cells would have.
///
/// A sheet of dilatation emits waves of one kind only, a = 2 (1 + nu) e (docs/theory/stacks.md, stack-strain), whose stress has no
/// trace, plus the stress of a layer held in its plane, -2 mu (1 + nu)/(1 - nu) e in xx and yy. The image of the waves that arrive at
/// the surface is that of (free-surface). So two running sums, one upwards and one downwards, are the operator, with the means
/// over source and target layer of EigenstrainStress. It is symmetric, also with the plastic strain: the trace of the
/// stress by a plastic strain is the transpose of the deviator by a dilatation.
class DilatationStress
{
public:
  /// @param fft  transform of single planes of the surface of `grid`; must outlive this object
  DilatationStress(const VolumeGrid& grid, const Elastic& elastic, const BlockedFft& fft,
                   const layer_waves::Shortest& shortest);

  static constexpr int stresses = Deviator::size + 1; ///< components of the stress: the deviator, then the trace

  struct Work
  {
    struct Thread
    {
      BlockedFft::Scratch fft;
      AlignedVector<ComplexLanes> strain; ///< of one block, [layer][pitch]
      AlignedVector<ComplexLanes> below;  ///< stress of the waves from below, [layer]
      AlignedVector<ComplexLanes> stress; ///< at one wavenumber along x, [layer][component][pitch]
      AlignedVector<ComplexLanes> column;
    };
    std::vector<Thread> threads;
    AlignedVector<ComplexLanes> strain, stress;           ///< rows of all planes
    OfTraction<AlignedVector<ComplexLanes>> displacement; ///< rows
    ImageCorrection::Response images;
  };
  [[nodiscard]] Work make_work() const;

  using Kernels = OfTraction<const TractionStress*>;
  /// Adds the stress in the layers [0, layers) and the displacement of the surface. On a mirrored grid only the independent rows are
  /// read and written.
  /// @param dilatation  e [-], one value per cell
  /// @param deviator, trace  [Pa]; empty: not wanted
  /// @param kernels     of the displacements that are wanted, otherwise nullptr
  void add(std::span<const double> dilatation, int layers, const Kernels& kernels, std::span<double> deviator,
           std::span<double> trace, const OfTraction<std::span<double>>& displacement, Work& work) const;

private:
  using Factors = layer_waves::Factors;
  void transform(std::span<const double> dilatation, int strained, Work& work) const;
  void process(int block, int strained, int layers, const Kernels& kernels, Work& work, Work::Thread& thread) const;
  void go_through(const Factors& f, int row, int strained, int layers, Work::Thread& thread) const;
  void invert(std::span<const double> dilatation, int layers, std::span<double> deviator, std::span<double> trace,
              Work& work) const;
  [[nodiscard]] int strained_layers(std::span<const double> dilatation) const;

  VolumeGrid grid_;
  double nu_, mu_;
  const BlockedFft& fft_;
  BlockedFft strain_fft_, stress_fft_; ///< of the planes of all layers
  AlignedVector<Factors> factors_;     ///< [block][row], only rows with ky >= 0
  ImageCorrection image_correction_;
};

} // namespace brinell::halfspace
