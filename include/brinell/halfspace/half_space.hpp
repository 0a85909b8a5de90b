// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "brinell/foundation/symmetry.hpp"
#include "brinell/green/elastic.hpp"
#include "brinell/halfspace/surface_load.hpp"

#include <memory>
#include <span>

/// The linear operators of one body on one grid. Planned once from grid and constants; `const` when applied.
/// Deviator fields are 5 * grid.size() values, component by component (order of Deviator); other sizes: InternalError.
namespace brinell::halfspace
{

/// One elastic body with its surface load and its plastic strain.
///
/// The stress of an increment is asked for in two steps, because the load on the surface depends on the displacement that
/// the plastic strain gives to the surface: `load` transforms the strain and returns a `Loaded`, which gives the displacement
/// and, for any surface load, the stress. What shears need is made when the first one comes.
class HalfSpace
{
public:
  HalfSpace(const VolumeGrid& grid, const Elastic& elastic);
  /// Of some columns of a longer body with the same rows: as much like the operators of the whole as the shorter transforms
  /// allow (docs/theory/elastoplastic.md, windows).
  HalfSpace(const VolumeGrid& grid, const Elastic& elastic, const SurfaceGrid& whole);
  ~HalfSpace();
  HalfSpace(HalfSpace&&) noexcept;
  HalfSpace& operator=(HalfSpace&&) noexcept;
  HalfSpace(const HalfSpace&) = delete;
  HalfSpace& operator=(const HalfSpace&) = delete;

  /// Buffers of one evaluation; make one per concurrent caller, once.
  class Work;
  [[nodiscard]] Work make_work() const;
  /// Buffers without those that are large: it gets them from the work of a larger half space while that is not in use, and
  /// gives them back, both by `exchange_buffers`.
  [[nodiscard]] Work make_guest() const;
  static void exchange_buffers(Work& guest, Work& host);

  [[nodiscard]] const VolumeGrid& grid() const;
  [[nodiscard]] const Elastic& elastic() const;

  /// Plastic strain that has been transformed, and waits for the load on the surface.
  class Loaded;
  /// Transforms the plastic strain [-] of all layers and prepares its stress in the layers [0, layers).
  /// The `Loaded` that is returned refers to `plastic_strain`, `work` and this object, and lasts until `work` is used again:
  /// later calls of its functions throw InternalError. The order of the calls: docs/theory/half-space.md.
  /// @param displacements  those that the `Loaded` shall have
  /// @param symmetry       of the strain, and of the loads that the `Loaded` is given. With one, the independent rows of the strain
  ///                       (`independent_rows`) are read and those of the stress are written; the displacement has all rows.
  [[nodiscard]] Loaded load(std::span<const double> plastic_strain, int layers, Work& work,
                            Displacements displacements = Displacements::normal,
                            Symmetry symmetry = Symmetry::none) const;
  /// Deviator and trace of the stress [Pa] in all layers, for output.
  void full_stress(const SurfaceLoad& load, std::span<const double> plastic_strain, Work& work,
                   std::span<double> deviator, std::span<double> trace) const;

private:
  struct Operators; ///< transforms and kernels, and what they are applied with
  std::unique_ptr<Operators> operators_;
};

class HalfSpace::Work
{
public:
  Work(); ///< empty; HalfSpace::make_work gives one that can be used
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

class HalfSpace::Loaded
{
public:
  /// Residual displacement of the surface: those parts that `load` was asked for.
  void displacement(const SurfaceDisplacement& out) const;
  /// Deviatoric stress [Pa] of the load and the strain in the layers that were prepared; the others are left alone.
  /// May be asked for with one load after another.
  void stress(const SurfaceLoad& load, std::span<double> deviator) const;

private:
  friend class HalfSpace;
  Loaded(const Operators& operators, std::span<const double> plastic_strain, Work::Buffers& buffers);
  void require_current(const char* function_name) const;

  const Operators* operators_;
  std::span<const double> plastic_strain_;
  Work::Buffers* buffers_;
  long number_; ///< of the strain among those that the buffers have held
};

} // namespace brinell::halfspace
