// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/halfspace/eigenstrain_stress.hpp"
#include "brinell/halfspace/image_correction.hpp"
#include "brinell/halfspace/pressure_stress.hpp"

#include <memory>
#include <span>
#include <vector>

/// The linear operators of one body on one grid. Planned once from grid and constants; `const` when applied.
/// All volume fields of deviators are 5 * grid.size() values, component by component (order of Deviator).
namespace brinell::halfspace
{

/// One elastic body with its surface pressure and its plastic strain.
class HalfSpace
{
public:
  HalfSpace(const VolumeGrid& grid, const Elastic& elastic);

  /// Buffers of one evaluation; make one per concurrent caller, once.
  struct Work
  {
    AlignedVector<Complex> strain_hat, stress_hat, pressure_hat;
    AlignedVector<double> scratch;
  };
  [[nodiscard]] Work make_work() const;

  [[nodiscard]] const VolumeGrid& grid() const { return grid_; }
  [[nodiscard]] const Elastic& elastic() const { return elastic_; }
  [[nodiscard]] const PaddedFft& fft() const { return *fft_; }

  /// Transforms the plastic strain [-] of the layers [0, layers), for the two functions below; the strain in the
  /// layers beneath must be zero.
  void load_strain(std::span<const double> plastic_strain, int layers, Work& work) const;
  /// Residual normal displacement of the surface [m], into the body positive, of the strain loaded.
  void residual_displacement(int layers, Work& work, std::span<double> displacement) const;
  /// Deviatoric stress [Pa] of the pressure [Pa] (on the grid's surface) and of the strain loaded, which is used up.
  /// Only the layers [0, layers) are computed.
  void deviatoric_stress(std::span<const double> pressure, std::span<const double> plastic_strain, int layers,
                         Work& work, std::span<double> stress) const;
  /// Like deviatoric_stress, in all layers, with the trace of the stress [Pa] besides (for output).
  void full_stress(std::span<const double> pressure, std::span<const double> plastic_strain, Work& work,
                   std::span<double> deviator, std::span<double> trace) const;

private:
  void finish(std::span<const double> plastic_strain, int layers, Work& work, std::span<double> stress,
              std::span<double> trace = {}) const;

  VolumeGrid grid_;
  Elastic elastic_;
  std::unique_ptr<PaddedFft> fft_;
  PressureStress pressure_stress_;
  EigenstrainStress eigenstrain_stress_;
  ImageCorrection image_correction_;
};

} // namespace brinell::halfspace
