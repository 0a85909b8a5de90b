// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/deviator.hpp"
#include "brinell/halfspace/half_space.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace brinell::halfspace
{

/// Cells of a body that have other elastic constants, perfectly bonded to the body around them.
struct Inclusion
{
  /// E = 0 is a void; an infinite E is rigid.
  Elastic elastic;
  std::vector<std::size_t> cells; ///< of the volume grid
  /// Own strain, which it would have without the body around it: misfit, expansion, change of phase; in a void without meaning.
  struct Own
  {
    Deviator deviator{};
    double dilatation = 0.0; ///< strain that is equal in all directions
    bool operator==(const Own&) const = default;
  };
  Own own{};
};

/// Values of stress or strain in the cells of all inclusions, in the order of `Inclusions::cells`: the deviator as a field, component by
/// component, and the volumetric part.
struct InclusionField
{
  std::vector<double> deviator; ///< [component][cell]
  /// Of a stress its trace, of a strain the part that is equal in all directions: the work of both is trace times dilatation, in
  /// addition to that of the deviators.
  std::vector<double> volumetric;
};

/// Inclusions of other elastic constants by Eshelby's equivalent strain (Eshelby 1957; Mura 1987, section 22): docs/theory/inclusions.md.
///
/// The body is replaced by a homogeneous one with an equivalent strain eps* in the cells of the inclusions, in which the stress is the same:
///   eps* = (1/(2 mu_1) - 1/(2 mu_0)) s  and  e* = (1/(9 K_1) - 1/(9 K_0)) tr sigma,  sigma = sigma_0 - H eps*.
/// Here sigma_0 is the stress of all else, a load, plastic strain, or the own strain of an inclusion, in the homogeneous body; the class does not add
/// any of these by itself. In units of
/// the stiffness of the body H has its spectrum in [0, 1], so that R = 1 - 2 H is a contraction. With the contrasts
///   B = (mu_0 - mu_1)/(mu_0 + mu_1), (K_0 - K_1)/(K_0 + K_1), both in [-1, 1] from rigid to void
/// the system is (sign B - sqrt|B| R sqrt|B|) w = 2 sqrt|B| sigma_0 with eps* = sqrt|B| w: symmetric, and bounded for every contrast.
///
/// Within a cell the equivalent strain is uniform, and the stress is the mean over the cell: in the plane by a stencil, in depth by the
/// operator. Otherwise the waves that the cells just resolve would ring in inclusions of large contrast.
class Inclusions
{
public:
  /// @param body  must outlive this object; homogeneous, not rigid, and not shared by ranks
  /// @throws InputError if a constant is not allowed, or a cell is outside the grid or belongs to two inclusions. On a mirrored grid the
  ///         cells must be symmetric.
  Inclusions(const HalfSpace& body, const std::vector<Inclusion>& inclusions);
  ~Inclusions();
  Inclusions(Inclusions&&) noexcept;
  Inclusions& operator=(Inclusions&&) noexcept;
  Inclusions(const Inclusions&) = delete;
  Inclusions& operator=(const Inclusions&) = delete;

  /// Cells of all inclusions, on a mirrored grid only those in independent rows, in ascending order.
  [[nodiscard]] const std::vector<std::size_t>& cells() const;
  [[nodiscard]] InclusionField make_field() const; ///< zero
  [[nodiscard]] const InclusionField& own_strain() const;
  [[nodiscard]] bool has_own_strain() const;
  /// Layers from the surface down to the deepest cell.
  [[nodiscard]] int layers() const;

  /// Unknowns, six in a cell, up to which there is a matrix: it takes 140 MB, and less than a second.
  static constexpr std::size_t most_of_matrix = 4200;

  struct Report
  {
    int iterations = 0;    ///< each costs one evaluation of the body or, in `update`, of the box around the inclusions
    int corrections = 0;   ///< of `update`: additions to the fields, each of which costs one evaluation of the body
    double residual = 0.0; ///< of the equation, relative to the stress `sigma_0`
  };
  /// Finds the equivalent strain.
  /// @param stress      sigma_0 [Pa]
  /// @param equivalent  guess, and result [-]
  /// @param tolerance   of the residual
  Report solve(const InclusionField& stress, InclusionField& equivalent, double tolerance, int most_iterations = 200);
  /// An equivalent strain and the stress that it causes in the cells.
  struct Solution
  {
    InclusionField equivalent, caused;
  };
  [[nodiscard]] Solution make_solution() const; ///< zero
  /// Finds the equivalent strain and adds its stress and displacement, as `solve` and `add` do, in less time: it corrects the guess until the fields of the
  /// whole body satisfy the equation. A correction takes a factorised matrix of the equations if they are few, otherwise iterations in a small body, the
  /// columns, rows and layers around the inclusions, where these are a part of the grid: docs/theory/inclusions.md (corrections).
  /// @param solution  guess, and result
  /// @param layers    as many as hold the inclusions, or more
  Report update(const InclusionField& stress, Solution& solution, double tolerance, int most_iterations, int layers,
                const HalfSpace::Dilated& to);
  /// Stress that the equivalent strain causes in the cells of the inclusions [Pa].
  void stress(const InclusionField& equivalent, InclusionField& out);
  /// Adds the stress of the equivalent strain to fields of the body, in the layers [0, layers), and its displacement to the surface.
  /// @param to  as HalfSpace::Dilated, but all rows of the stress
  void add(const InclusionField& equivalent, int layers, const HalfSpace::Dilated& to);
  /// Means of a field of the body over the cells of the inclusions; on a mirrored grid its independent rows are read.
  void gather(std::span<const double> deviator, std::span<const double> trace, InclusionField& out) const;
  /// Work of a stress on a strain [J]; on a mirrored grid that of both sides.
  [[nodiscard]] double work(const InclusionField& stress, const InclusionField& strain) const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace brinell::halfspace
