// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/halfspace/half_space.hpp"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// The parts of a load in the order pressure, shear along x, shear along y, on the whole surface; empty ones are zero.
using KeptLoad = std::array<std::vector<double>, 3>;
void keep(const halfspace::SurfaceLoad& load, KeptLoad& kept);

/// Columns [first, first + count) of a body.
struct Columns
{
  int first, count;
};

/// Columns of a body in which an increment happens, as a half space of their own.
///
/// Stress and displacement are linear in plastic strain and load. So of a reference, for which all of the body has been
/// computed, only differences are computed: those of strain and load within the window, on its cells. What they make beside it is
/// left out until the whole is computed again: docs/theory/elastoplastic.md (windows).
class Window
{
public:
  Window(const VolumeGrid& body, const Elastic& elastic, Symmetry symmetry);

  /// Fields of the whole body that belong together.
  struct Reference
  {
    std::span<const double> strain, stress;              ///< deviators
    std::span<const double> thermal_stress;              ///< which `stress` contains; empty: none
    std::array<std::span<const double>, 3> displacement; ///< along z, x and y; empty parts are not wanted
    const KeptLoad* load;
  };
  /// Places the window around what is needed and some columns more, if it is short enough to pay, and wanted often enough for
  /// what planning costs.
  /// @returns whether it has been placed
  [[nodiscard]] bool place(const Columns& needed, const Reference& reference);
  [[nodiscard]] const Columns& columns() const { return columns_; }
  /// Whether a column lies at an end of the window that is none of the body.
  [[nodiscard]] bool is_at_end(int column) const;
  /// Whether the load differs from that of the reference within the window alone.
  [[nodiscard]] bool holds(const halfspace::SurfaceLoad& load) const;

  /// Transforms the strain, and writes the displacement of the surface within the window.
  /// @param strain  of the whole body
  /// @param layers  whose stress is wanted
  /// @param host    work of the whole body, not in use
  void load(std::span<const double> strain, int layers, halfspace::Displacements displacements,
            const std::array<std::span<double>, 3>& displacement, halfspace::HalfSpace::Work& host);
  /// Stress of the strain loaded and of a load, in the layers wanted and the independent rows of the window.
  void stress(const halfspace::SurfaceLoad& load, std::span<const double> thermal_stress, std::span<double> stress,
              halfspace::HalfSpace::Work& host);

  /// On how often it has been wanted depends when there is one: a part of the state.
  [[nodiscard]] std::vector<double>& wishes() { return wishes_; }

private:
  /// Operators of a window of some length, and what they are applied with.
  struct Part
  {
    halfspace::HalfSpace half_space;
    halfspace::HalfSpace::Work work;
  };
  [[nodiscard]] Part& part();
  void refer_to(const Reference& reference);
  template <typename Use>
  void for_independent_rows(int layers, const Use& use) const;
  template <typename Use>
  void for_surface_rows(const Use& use) const;

  VolumeGrid body_;
  Elastic elastic_;
  Symmetry symmetry_;
  Columns columns_{0, 0};
  VolumeGrid cells_;                           ///< of the window
  int layers_ = 0;                             ///< wanted
  std::vector<std::unique_ptr<Part>> parts_;   ///< by length, planned when they are first used
  std::vector<double> wishes_;                 ///< evaluations that have asked for each length
  std::vector<double> strain_, stress_;        ///< of the reference, within the window
  std::array<std::vector<double>, 3> surface_; ///< its displacement there
  KeptLoad load_;                              ///< of the reference
  std::vector<double> change_, answer_;        ///< of the strain, and of the stress with it
  std::array<std::vector<double>, 3> moved_;   ///< change of the displacement
  KeptLoad added_;                             ///< change of the load
  std::size_t length_ = 0;                     ///< of the window, among those that occur
  std::optional<halfspace::HalfSpace::Loaded> loaded_;
};

} // namespace brinell::elastoplastic
