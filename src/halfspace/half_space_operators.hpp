// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/halfspace/half_space.hpp"
#include "eigenstrain_stress.hpp"
#include "image_correction.hpp"
#include "traction_stress.hpp"

#include <array>
#include <mutex>
#include <vector>

/// What stands behind HalfSpace: transforms and kernels, and the order in which they are applied.
namespace brinell::halfspace
{

/// A value for each component of the traction on the surface, and of the displacement that it works on.
template <typename Value>
using OfTraction = std::array<Value, 3>;
inline constexpr OfTraction<Traction> tractions{Traction::pressure, Traction::shear_x, Traction::shear_y};
[[nodiscard]] inline std::size_t index(Traction traction)
{
  return static_cast<std::size_t>(traction);
}

/// The parts of a load that are not empty.
[[nodiscard]] inline OfTraction<bool> parts_of(const SurfaceLoad& load)
{
  return {!load.pressure.empty(), !load.shear_x.empty(), !load.shear_y.empty()};
}
[[nodiscard]] inline std::span<const double> part_of(const SurfaceLoad& load, Traction traction)
{
  return OfTraction<std::span<const double>>{load.pressure, load.shear_x, load.shear_y}[index(traction)];
}

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
  std::vector<Scratch> threads;  ///< one per thread
  AlignedVector<Complex> rows;   ///< of strain, later of stress
  AlignedVector<Complex> strain; ///< spectrum of one block
  AlignedVector<Complex> stress; ///< spectra of all blocks, of the strain loaded
  /// Of the components that have been asked for; the others are empty.
  OfTraction<AlignedVector<Complex>> displacement_rows; ///< of the strain loaded
  OfTraction<AlignedVector<Complex>> surface;           ///< spectra of a displacement, later of a traction
  AlignedVector<Complex> surface_rows;                  ///< of a traction
  ImageCorrection::Response images;
  Displacements displacements = Displacements::normal; ///< prepared
  int layers = 0;                                      ///< layers prepared
  long number = 0;                                     ///< of the strain loaded
};

struct HalfSpace::Operators
{
  VolumeGrid grid;
  Elastic elastic;
  BlockedFft surface_fft; ///< of one plane
  BlockedFft volume_fft;  ///< of a deviator field
  BlockedFft trace_fft;   ///< of a scalar field
  EigenstrainStress eigenstrain_stress;
  ImageCorrection image_correction;

  Operators(const VolumeGrid& volume, const Elastic& constants);

  [[nodiscard]] std::unique_ptr<Work::Buffers> make_buffers() const;
  /// Kernels of some components of the traction, nullptr for the others. Those of a shear are tabulated when they are first
  /// wanted.
  [[nodiscard]] OfTraction<const TractionStress*> kernels_of(const OfTraction<bool>& wanted) const;
  /// @param trace  nullptr, or spectra that receive the trace of the stress
  void load_strain(std::span<const double> plastic_strain, int layers, Displacements displacements, Work::Buffers& work,
                   Complex* trace) const;
  /// Transforms what acts on the surface.
  void load_surface(const SurfaceLoad& load, Work::Buffers& work) const;
  void add_load_and_invert(const SurfaceLoad& load, std::span<const double> plastic_strain, Work::Buffers& work,
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

private:
  struct Kernels
  {
    std::once_flag tabulated;
    std::unique_ptr<TractionStress> stress;
  };
  mutable OfTraction<Kernels> kernels_;
};

} // namespace brinell::halfspace
