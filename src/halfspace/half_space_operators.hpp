// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/halfspace/half_space.hpp"
#include "eigenstrain_stress.hpp"
#include "image_correction.hpp"
#include "pressure_stress.hpp"

#include <vector>

/// What stands behind HalfSpace: transforms and kernels, and the order in which they are applied.
namespace brinell::halfspace
{

/// In a spectrum of one block, or of all blocks one after the other: the row of one wavenumber along y.
inline std::ptrdiff_t row_at(const BlockedFft& fft, int block, int row)
{
  return (static_cast<std::ptrdiff_t>(block) * fft.py() + row) * fft.pitch() * lane_count;
}

struct HalfSpace::Work::Buffers
{
  struct Scratch
  {
    BlockedFft::Scratch fft;
    EigenstrainStress::Scratch layers;
  };
  std::vector<Scratch> threads;             ///< one per thread
  AlignedVector<Complex> rows;              ///< of strain, later of stress
  AlignedVector<Complex> strain;            ///< spectrum of one block
  AlignedVector<Complex> stress;            ///< spectra of all blocks, of the strain loaded
  AlignedVector<Complex> displacement_rows; ///< of the strain loaded
  AlignedVector<Complex> surface_rows;      ///< of a pressure
  AlignedVector<Complex> surface;           ///< spectrum of a displacement, later of a pressure
  ImageCorrection::Response images;
  int layers = 0;  ///< layers prepared
  long number = 0; ///< of the strain loaded
};

struct HalfSpace::Operators
{
  VolumeGrid grid;
  Elastic elastic;
  BlockedFft surface_fft; ///< of one plane
  BlockedFft volume_fft;  ///< of a deviator field
  BlockedFft trace_fft;   ///< of a scalar field
  PressureStress pressure_stress;
  EigenstrainStress eigenstrain_stress;
  ImageCorrection image_correction;

  Operators(const VolumeGrid& volume, const Elastic& constants);

  [[nodiscard]] std::unique_ptr<Work::Buffers> make_buffers() const;
  /// @param trace  nullptr, or spectra that receive the trace of the stress
  void load_strain(std::span<const double> plastic_strain, int layers, Work::Buffers& work, Complex* trace) const;
  void load_pressure(std::span<const double> pressure, Work::Buffers& work) const;
  void add_pressure_and_invert(bool has_pressure, std::span<const double> plastic_strain, Work::Buffers& work,
                               std::span<double> stress) const;
  void finish(int component, int layer, std::span<const double> plastic_strain, const Work::Buffers& work,
              double* field) const;
  /// Place of one component in one layer of a field.
  [[nodiscard]] std::size_t field_at(int component, int layer) const
  {
    return static_cast<std::size_t>(component * grid.nz + layer) * grid.surface.size();
  }
  /// Layers from the surface down to the deepest one that holds plastic strain.
  [[nodiscard]] int strained_layers(std::span<const double> plastic_strain) const;
};

} // namespace brinell::halfspace
