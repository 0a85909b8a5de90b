// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/communicator.hpp"
#include "brinell/foundation/grid.hpp"
#include "brinell/foundation/share.hpp"
#include "brinell/green/elastic.hpp"
#include "brinell/green/stack.hpp"
#include "brinell/halfspace/surface_load.hpp"

#include <functional>
#include <limits>
#include <memory>
#include <span>

/// The linear operators of one body on one grid. They are planned once from grid and constants; applying them is `const`.
/// A deviator field has 5 * grid.size() values, component by component (order of Deviator); other sizes: InternalError.
namespace brinell::halfspace
{

/// Whether the layers of cells end at all interfaces of a layered body within the grid, as plastic strain needs.
[[nodiscard]] bool is_aligned(const VolumeGrid& grid, const ElasticStack& stack);
/// @throws InputError with a thickness that would do, unless `is_aligned`
void require_aligned(const VolumeGrid& grid, const ElasticStack& stack);

/// One elastic body with its surface load and its plastic strain.
///
/// The stress of an increment is computed in two steps, because the load on the surface depends on the residual displacement
/// that the plastic strain causes: `load` transforms the strain and returns a `Loaded`, which computes the displacement and,
/// for any surface load, the stress. The kernels of pressure and of shears are computed when they are first needed: a body that
/// stays elastic needs them for output only.
///
/// Several ranks may share a half space. Each then has the fields of its own layers (`share`), all of them every surface field, and
/// all call the same functions at the same time; the digits are those of a rank alone (docs/theory/ranks.md).
class HalfSpace
{
public:
  using Ranks = std::shared_ptr<const Communicator>;

  /// @param ranks  by which the half space is shared; nullptr: this process alone
  HalfSpace(const VolumeGrid& grid, const Elastic& elastic, Ranks ranks = nullptr);
  /// Operators on some columns and rows of a larger grid `whole`: as close to the operators on the whole grid as the
  /// shorter transforms allow (docs/theory/elastoplastic.md, windows).
  HalfSpace(const VolumeGrid& grid, const Elastic& elastic, const SurfaceGrid& whole, Ranks ranks = nullptr);
  /// A layered body (docs/theory/stacks.md). The stress of a load in cells that an interface cuts is the mean of both layers. With
  /// plastic strain no interface may cut cells: otherwise `load` throws InputError, see `require_aligned`. Neighbouring layers with equal
  /// constants are one.
  HalfSpace(const VolumeGrid& grid, const ElasticStack& stack, Ranks ranks = nullptr);
  HalfSpace(const VolumeGrid& grid, const ElasticStack& stack, const SurfaceGrid& whole, Ranks ranks = nullptr);
  ~HalfSpace();
  HalfSpace(HalfSpace&&) noexcept;
  HalfSpace& operator=(HalfSpace&&) noexcept;
  HalfSpace(const HalfSpace&) = delete;
  HalfSpace& operator=(const HalfSpace&) = delete;

  /// Buffers of one evaluation; make one per concurrent caller, once.
  class Work;
  [[nodiscard]] Work make_work() const;
  /// A Work without the large buffers. `exchange_buffers` lends it those of the Work of a larger half space while that one is not
  /// in use, and, called again, returns them.
  [[nodiscard]] Work make_guest() const;
  static void exchange_buffers(Work& guest, Work& host);

  [[nodiscard]] const VolumeGrid& grid() const;
  /// Constants of the substrate.
  [[nodiscard]] const Elastic& elastic() const;
  /// Constants of the material of a layer of cells: that in the middle of the layer.
  [[nodiscard]] const Elastic& elastic_of(int layer) const;
  [[nodiscard]] const ElasticStack& stack() const;
  [[nodiscard]] const Communicator& ranks() const { return *shared_ranks(); }
  [[nodiscard]] const Ranks& shared_ranks() const;
  [[nodiscard]] const Share& share() const;
  /// The layers of this rank as a grid: that of its fields.
  [[nodiscard]] VolumeGrid own_grid() const;

  /// Transformed plastic strain, ready to be combined with a load on the surface.
  class Loaded;
  /// Transforms the plastic strain [-] of all layers and prepares its stress in the layers [0, layers). On a grid that
  /// `is_mirrored_y` only the independent rows of the strain are read and those of the stress are written; the displacement has
  /// all rows.
  /// The returned `Loaded` refers to `plastic_strain`, `work` and this object, and is valid until `work` is used again:
  /// later calls of its functions throw InternalError. The order of the calls: docs/theory/half-space.md.
  /// @param displacements  components of the displacement that the `Loaded` can compute
  /// @param with_trace     whether the `Loaded` can compute the trace of the stress, too
  [[nodiscard]] Loaded load(std::span<const double> plastic_strain, int layers, Work& work,
                            Displacements displacements = Displacements::normal, bool with_trace = false) const;
  /// Deviator and trace of the stress [Pa] in the layers [0, layers), for output; other layers are not written.
  /// @param layers  as many as there are, or more: all
  void full_stress(const SurfaceLoad& load, std::span<const double> plastic_strain, Work& work,
                   std::span<double> deviator, std::span<double> trace, int layers = all_layers) const;
  static constexpr int all_layers = std::numeric_limits<int>::max();
  /// Stress [Pa] of a load alone in one layer: the five components of the deviator and then the trace, each [y][x].
  /// @param work  may be one of `make_guest` that has borrowed nothing
  void stress_of_load(const SurfaceLoad& load, int layer, Work& work, std::span<double> stress) const;
  /// Stress of a load alone in all layers, which the threads share: calls use(layer, stress) with the independent rows of each layer.
  void stress_of_load(const SurfaceLoad& load, Work& work,
                      const std::function<void(int layer, std::span<const double> stress)>& use) const;

  /// Buffers of `add_dilatation`; make one per concurrent caller, once. The first one also plans the operator, which bodies
  /// without dilatation do not have.
  class DilatationWork;
  [[nodiscard]] DilatationWork make_dilatation_work() const;
  /// Where to add the fields of a dilatation; an empty part is not computed.
  struct Dilated
  {
    std::span<double> deviator{}, trace{}; ///< stress [Pa]; on a grid that `is_mirrored_y` only the independent rows
    SurfaceDisplacement displacement{};    ///< of the surface [m], all rows
  };
  /// Adds the stress in the layers [0, layers) and the displacement by a dilatation e [-], the strain along each axis that a cell
  /// without neighbours would have: by heat, a change of phase, or the part of an inclusion's equivalent strain that changes the
  /// volume. On a grid that `is_mirrored_y` only the independent rows of e are read.
  /// @throws InputError for a layered body, InternalError if ranks share it
  void add_dilatation(std::span<const double> dilatation, int layers, DilatationWork& work, const Dilated& to) const;

private:
  struct Operators; ///< transforms and kernels, and the functions that apply them
  std::unique_ptr<Operators> operators_;
};

class HalfSpace::Work
{
public:
  Work(); ///< empty; HalfSpace::make_work returns one that can be used
  ~Work();
  Work(Work&&) noexcept;
  Work& operator=(Work&&) noexcept;
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;

  [[nodiscard]] bool empty() const { return !buffers_; }

private:
  friend class HalfSpace;
  struct Buffers;
  std::unique_ptr<Buffers> buffers_;
};

class HalfSpace::DilatationWork
{
public:
  DilatationWork(); ///< empty; HalfSpace::make_dilatation_work returns one that can be used
  ~DilatationWork();
  DilatationWork(DilatationWork&&) noexcept;
  DilatationWork& operator=(DilatationWork&&) noexcept;
  DilatationWork(const DilatationWork&) = delete;
  DilatationWork& operator=(const DilatationWork&) = delete;

private:
  friend class HalfSpace;
  struct Buffers;
  std::unique_ptr<Buffers> buffers_;
};

class HalfSpace::Loaded
{
public:
  /// Residual displacement of the surface [m]: only the components that `load` was asked to prepare.
  void displacement(const SurfaceDisplacement& out) const;
  /// Deviatoric stress [Pa] of the load and the strain in the layers that were prepared; other layers are not written.
  /// May be called repeatedly with different loads.
  void stress(const SurfaceLoad& load, std::span<double> deviator) const;
  /// Trace of the stress [Pa] in one prepared layer, [y][x], for the load of the last call of `stress`.
  /// @throws InternalError if `load` was not asked for it
  void trace(const SurfaceLoad& load, int layer, std::span<double> out) const;
  /// Whether `trace` can be called: the load was asked for it, and the buffers have not been used since.
  [[nodiscard]] bool has_trace() const;
  /// The trace in the independent rows of all layers that were prepared, [layer][y][x].
  void traces(const SurfaceLoad& load, std::span<double> out) const;

private:
  friend class HalfSpace;
  Loaded(const Operators& operators, std::span<const double> plastic_strain, Work::Buffers& buffers);
  void require_current(const char* function_name) const;

  const Operators* operators_;
  std::span<const double> plastic_strain_;
  Work::Buffers* buffers_;
  long number_; ///< serial number of the strain in the buffers, to detect that they have been reused
};

} // namespace brinell::halfspace
