// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/error.hpp"
#include "brinell/foundation/symmetry.hpp"
#include "brinell/halfspace/half_space.hpp"
#include "dilatation_stress.hpp"
#include "eigenstrain_stress.hpp"
#include "foundation/lazy.hpp"
#include "halfspace/traction/traction_stress.hpp"
#include "halfspace/transform/exchange.hpp"
#include "halfspace/transform/mirrored_fft.hpp"
#include "image_correction.hpp"
#include "stack_stress.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

/// Implementation of HalfSpace: transforms and kernels, and the order in which they are applied.
namespace brinell::halfspace
{

inline constexpr OfTraction<Traction> tractions{Traction::pressure, Traction::shear_x, Traction::shear_y};
[[nodiscard]] inline std::size_t index(Traction traction)
{
  return static_cast<std::size_t>(traction);
}

/// Which parts of a load are not empty.
[[nodiscard]] inline OfTraction<bool> parts_of(const SurfaceLoad& load)
{
  return {!load.pressure.empty(), !load.shear_x.empty(), !load.shear_y.empty()};
}
[[nodiscard]] inline std::span<const double> part_of(const SurfaceLoad& load, Traction traction)
{
  return OfTraction<std::span<const double>>{load.pressure, load.shear_x, load.shear_y}[index(traction)];
}

struct HalfSpace::Work::Buffers
{
  struct Scratch
  {
    BlockedFft::Scratch fft;
    EigenstrainStress::Scratch layers;
    StackStress::Scratch stack;
    AlignedVector<ComplexLanes> rows; ///< of one plane
    MirroredFft::Scratch mirrored;
  };
  std::vector<Scratch> threads; ///< one per thread
  int blocks_at_a_time = 1;
  AlignedVector<ComplexLanes> strain; ///< spectra of `blocks_at_a_time` blocks
  AlignedVector<ComplexLanes>
      stress; ///< spectra of the stress in all blocks, by the strain loaded; first, rows of the strain
  /// Displacements of the surface by a few layers each, in one block: they are summed in the order of the layers, for any
  /// number of threads.
  AlignedVector<ComplexLanes> displacement_parts; ///< [block at a time][part][traction][pitch]
  /// Only for the requested components; the others are empty.
  OfTraction<AlignedVector<ComplexLanes>> displacement_rows; ///< of the strain loaded
  OfTraction<AlignedVector<ComplexLanes>> surface;           ///< spectra of a displacement, later of a traction
  AlignedVector<ComplexLanes> trace; ///< spectra of the trace of the stress, if they have been asked for
  ImageCorrection::Response images;
  std::vector<CellRectangle> used;                     ///< of the strain loaded, [layer][component]
  Displacements displacements = Displacements::normal; ///< prepared
  int layers = 0;                                      ///< layers prepared
  long number = 0;                                     ///< of the strain loaded
  bool has_trace = false;                              ///< whether `trace` is that of the strain loaded

  /// The buffers that a guest borrows: their size per block does not depend on the number of columns.
  static constexpr auto lent() { return std::array{&Buffers::strain, &Buffers::stress, &Buffers::displacement_parts}; }

  /// Rows of the strain, between its transforms along x and y, are stored at the end of the memory of the stress: the rows of a
  /// block are read before the stress of this block is written, which ends before the rows of the next block begin.
  /// @param size  number of values in the rows of all blocks
  [[nodiscard]] ComplexLanes* rows(std::size_t size) { return stress.data() + (stress.size() - size); }
};

struct HalfSpace::Operators
{
  VolumeGrid grid;
  ElasticStack stack;
  Ranks ranks;
  Share share;
  VolumeGrid own;         ///< own layers
  BlockedFft surface_fft; ///< of one plane
  BlockedFft volume_fft;  ///< of a deviator field; on a mirrored grid `mirrored_fft` takes its place
  BlockedFft trace_fft;   ///< of a scalar field
  MirroredFft mirrored_fft;
  MirroredFft own_mirrored_fft;                        ///< of the own layers
  Portion blocks;                                      ///< own ones
  std::optional<EigenstrainStress> eigenstrain_stress; ///< of a homogeneous body
  std::optional<StackStress> stack_stress; ///< of a layered body whose interfaces are boundaries of the layers of cells
  ImageCorrection image_correction;
  /// Rows on their way between ranks, see Exchange. Ranks pass one thing at a time, so that bodies which share the operators share
  /// these buffers, too.
  struct Passing
  {
    AlignedVector<ComplexLanes> of_planes, of_blocks;
  };
  mutable Passing passing;
  int layers_at_a_time; ///< number of layers passed between ranks at a time, in whole turns
  int units_at_a_time;  ///< number of units: layers, or of mirror images pairs of layers

  layer_waves::Shortest shortest_waves;

  Operators(const VolumeGrid& volume, const ElasticStack& constants, const layer_waves::Shortest& shortest, Ranks by);

  /// @param of_guest  leave out the buffers that a guest borrows
  [[nodiscard]] std::unique_ptr<Work::Buffers> make_buffers(bool of_guest) const;
  /// Kernels of the `wanted` components of the traction, nullptr for the others. Those of a shear are tabulated when they are
  /// first needed.
  [[nodiscard]] OfTraction<const TractionStress*> kernels_of(const OfTraction<bool>& wanted) const;
  /// @param trace  nullptr, or becomes the spectra of the trace of the stress; on a rank without wavenumbers these are empty
  void load_strain(std::span<const double> plastic_strain, int layers, Displacements displacements, Work::Buffers& work,
                   AlignedVector<ComplexLanes>* trace) const;
  /// The operator of a dilatation, of a homogeneous body.
  [[nodiscard]] const DilatationStress& dilatation_stress() const;
  /// Transforms the load on the surface.
  void load_surface(const SurfaceLoad& load, Work::Buffers& work) const;
  void add_load_and_invert(const SurfaceLoad& load, std::span<const double> plastic_strain, Work::Buffers& work,
                           std::span<double> stress) const;
  /// Counterpart of add_load_and_invert for fields that are mirror images.
  void add_load_and_invert_mirrored(const SurfaceLoad& load, std::span<const double> plastic_strain,
                                    Work::Buffers& work, std::span<double> stress) const;
  /// One component of the stress, or its trace, in one layer: adds the stress of the surface load to the residual stress in the
  /// spectra of all blocks, and transforms the sum back to the grid. The spectra need only the rows of
  /// `spectrum_rows`.
  void invert_plane(int component, int layer, const OfTraction<const TractionStress*>& kernels, const BlockedFft& fft,
                    const ComplexLanes* spectra, int plane, const Work::Buffers& work, Work::Buffers::Scratch& scratch,
                    double* field) const;
  void finish(int component, int layer, std::span<const double> plastic_strain, const Work::Buffers& work,
              double* field) const;
  /// Stress of the strain in the spectra at some rows of one block, without its local part.
  void apply_to_strain(int block, const SpectrumRows& rows, const EigenstrainStress::Spectra& spectra,
                       Work::Buffers::Scratch& scratch) const;
  [[nodiscard]] bool is_mirrored() const { return grid.surface.is_mirrored_y; }
  /// Writes the other rows of a field whose independent rows are known.
  void complete(bool is_odd, std::span<double> field) const
  {
    if (is_mirrored())
      complete_in_y(grid.surface, is_odd ? -1.0 : 1.0, field.data(), field.size());
  }
  /// Position of one component in one layer, an own one, of a field.
  [[nodiscard]] std::size_t field_at(int component, int layer) const
  {
    return static_cast<std::size_t>(component * own.nz + share.place(layer)) * grid.surface.size();
  }
  /// Rows of the strain in the own blocks, between its transforms along x and y: see Work::Buffers::rows.
  /// @param size  number of values in the rows of all blocks
  [[nodiscard]] ComplexLanes* rows_of_strain(std::size_t size, Work::Buffers& work) const
  {
    return work.rows(size / static_cast<std::size_t>(surface_fft.blocks()) * static_cast<std::size_t>(blocks.count()));
  }
  /// Place of a plane in spectra of the own blocks.
  [[nodiscard]] std::ptrdiff_t plane_at(const BlockedFft& fft, int block, int plane) const
  {
    return fft.plane_at(block - blocks.first, plane);
  }
  /// Counterpart of add_load_and_invert for a half space that ranks share.
  void add_load_and_invert_shared(const SurfaceLoad& load, std::span<const double> plastic_strain, Work::Buffers& work,
                                  std::span<double> stress) const;
  /// The traces of own layers, in the layers [0, layers), without their local part.
  void invert_traces_shared(const OfTraction<const TractionStress*>& kernels, int layers, const ComplexLanes* spectra,
                            Work::Buffers& work, double* trace) const;
  void require_alone(const char* function_name) const
  {
    if (!share.is_all())
      throw InternalError(std::string(function_name) + ": not for a half space that ranks share");
  }
  /// Number of layers from the surface down to the deepest one with plastic strain.
  [[nodiscard]] int strained_layers(std::span<const double> plastic_strain) const;

private:
  void transform_strain(std::span<const double> plastic_strain, int layers, Work::Buffers& work,
                        Work::Buffers::Scratch& scratch) const;
  void transform_strain_mirrored(std::span<const double> plastic_strain, int layers, Work::Buffers& work,
                                 MirroredFft::Scratch& scratch) const;
  void transform_strain_shared(std::span<const double> plastic_strain, int layers, Work::Buffers& work,
                               Work::Buffers::Scratch& scratch) const;
  /// Passes what all ranks need of the strain: its moments, and the rows of the displacement.
  void join_shared(const OfTraction<const TractionStress*>& kernels, int strained, Work::Buffers& work) const;
  void join_layers(int layers, std::vector<double>& values) const;
  /// Of some layers, of mirror images pairs of layers, that are dealt out in whole turns.
  [[nodiscard]] Exchange exchange(int units) const;
  void transform_rows_shared(std::span<const double> plastic_strain, int layers, int plane, int own_unit,
                             ComplexLanes* out, const RowFft::Spectra& apart, Work::Buffers& work,
                             Work::Buffers::Scratch& scratch) const;
  void invert_rows_mirrored_shared(const MirroredFft::Plane& plane, const ComplexLanes* rows,
                                   const RowFft::Spectra& apart, std::span<const double> plastic_strain,
                                   Work::Buffers& work, std::span<double> stress) const;
  void invert_shared(int component, int layers, const OfTraction<const TractionStress*>& kernels, const BlockedFft& fft,
                     const ComplexLanes* spectra, int planes_of_layer, Work::Buffers& work, double* fields) const;
  void add_load_and_invert_mirrored_shared(const OfTraction<const TractionStress*>& kernels,
                                           std::span<const double> plastic_strain, Work::Buffers& work,
                                           std::span<double> stress) const;
  int prepare_part(const MirroredFft::Part& part, const MirroredFft::Part& next, std::span<const double> plastic_strain,
                   Work::Buffers& work) const;
  [[nodiscard]] CellRectangle strained_rows(int layer, const Work::Buffers& work) const;
  /// Counterpart of a plane of the spectra in the next block; for the last block, the plane itself.
  [[nodiscard]] const ComplexLanes* next_block(const BlockedFft& fft, int block, const ComplexLanes* plane) const
  {
    return block + 1 < blocks.end ? plane + fft.plane_at(1, 0) : plane;
  }
  [[nodiscard]] SpectrumRows mirrored(const SpectrumRows& rows) const;
  /// The threads that work on the same block: this one is number `rank` of `count`.
  struct Team
  {
    int rank, count;
  };
  [[nodiscard]] ComplexLanes* strain_of(int block, Work::Buffers& work) const
  {
    return work.strain.data() +
           (block - blocks.first) % work.blocks_at_a_time * static_cast<std::ptrdiff_t>(volume_fft.block_size());
  }
  /// Position of a part in `displacement_parts`.
  [[nodiscard]] ComplexLanes* displacement_part(int block, int part, Work::Buffers& work) const;
  void process_blocks(int thread, int strained, const OfTraction<const TractionStress*>& kernels, Work::Buffers& work,
                      ComplexLanes* trace) const;
  void process_waves(int block, int strained, const OfTraction<const TractionStress*>& kernels, const Team& team,
                     Work::Buffers& work, ComplexLanes* trace, Work::Buffers::Scratch& scratch) const;
  void transform_layers(int block, int layers, const OfTraction<const TractionStress*>& kernels, const Team& team,
                        Work::Buffers& work, Work::Buffers::Scratch& scratch) const;
  [[nodiscard]] const ComplexLanes* total_stress(int block, const MirroredFft::Part& part,
                                                 const OfTraction<const TractionStress*>& kernels,
                                                 const Work::Buffers& work, ComplexLanes* sum) const;
  /// Spectra of the traction in one block.
  [[nodiscard]] OfTraction<const ComplexLanes*> surface_spectra(int block, const Work::Buffers& work) const;
  void sum_displacement(int block, const SpectrumRows& rows, int parts,
                        const OfTraction<const TractionStress*>& kernels, Work::Buffers& work) const;
  OfTraction<Lazy<TractionStress>> kernels_;
  Lazy<DilatationStress> dilatation_;
};

} // namespace brinell::halfspace
