// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/halfspace/eigenstrain_stress.hpp"
#include "brinell/halfspace/image_correction.hpp"
#include "brinell/halfspace/pressure_stress.hpp"

#include <span>
#include <vector>

/// The linear operators of one body on one grid. Planned once from grid and constants; `const` when applied.
/// Deviator fields are 5 * grid.size() values, component by component (order of Deviator); other sizes: InternalError.
namespace brinell::halfspace
{

/// One elastic body with its surface pressure and its plastic strain.
class HalfSpace
{
public:
  HalfSpace(const VolumeGrid& grid, const Elastic& elastic);

  /// Buffers of one evaluation; make one per concurrent caller, once.
  class Work;
  [[nodiscard]] Work make_work() const;

  [[nodiscard]] const VolumeGrid& grid() const { return grid_; }
  [[nodiscard]] const Elastic& elastic() const { return elastic_; }

  /// Takes in the plastic strain [-] of all layers and prepares its stress in the layers [0, layers), for the functions
  /// below.
  /// @param displacement  receives the residual normal displacement of the surface [m], into the body positive.
  void load_strain(std::span<const double> plastic_strain, int layers, Work& work,
                   std::span<double> displacement) const;
  /// Deviatoric stress [Pa] of the pressure [Pa] (on the grid's surface) and of the strain loaded, in the layers loaded.
  /// Uses up what was loaded.
  void deviatoric_stress(std::span<const double> pressure, std::span<const double> plastic_strain, Work& work,
                         std::span<double> stress) const;
  /// Deviator and trace of the stress [Pa] in all layers (for output); loads the strain itself.
  void full_stress(std::span<const double> pressure, std::span<const double> plastic_strain, Work& work,
                   std::span<double> deviator, std::span<double> trace) const;

private:
  void load_strain(std::span<const double> plastic_strain, int layers, Work& work, std::span<double> displacement,
                   Complex* trace) const;
  void load_pressure(std::span<const double> pressure, Work& work) const;
  void finish(int component, int layer, std::span<const double> plastic_strain, const Work& work, double* field) const;
  [[nodiscard]] std::size_t field_at(int component, int layer) const;

  VolumeGrid grid_;
  Elastic elastic_;
  BlockedFft surface_fft_; ///< of one plane
  BlockedFft volume_fft_;  ///< of a deviator field
  BlockedFft trace_fft_;   ///< of a scalar field
  PressureStress pressure_stress_;
  EigenstrainStress eigenstrain_stress_;
  ImageCorrection image_correction_;
};

class HalfSpace::Work
{
public:
  [[nodiscard]] bool empty() const { return threads_.empty(); }

private:
  friend class HalfSpace;
  struct Scratch
  {
    BlockedFft::Scratch fft;
    EigenstrainStress::Scratch layers;
  };
  std::vector<Scratch> threads_;        ///< one per thread
  AlignedVector<Complex> rows_;         ///< of strain, later of stress
  AlignedVector<Complex> strain_;       ///< spectrum of one block
  AlignedVector<Complex> stress_;       ///< spectra of all blocks
  AlignedVector<Complex> surface_rows_; ///< of a displacement or pressure
  AlignedVector<Complex> surface_;      ///< spectrum of the same
  ImageCorrection::Response images_;
  int layers_ = 0; ///< layers loaded
};

} // namespace brinell::halfspace
