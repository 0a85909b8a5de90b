// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/active_cells.hpp"
#include "brinell/halfspace/half_space.hpp"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// Copy of a load on the whole surface, in the order pressure, shear along x, shear along y [Pa]; empty parts are zero.
using StoredLoad = std::array<std::vector<double>, 3>;
void copy_load(const halfspace::SurfaceLoad& load, StoredLoad& kept);

/// Columns [first, first + count) of a body.
struct Columns
{
  int first, count;
};

/// Possible lengths of windows, relative to the body. Only few, because each needs operators of its own, and none so long that it
/// would save little time.
inline constexpr std::array<double, 2> window_shares{0.375, 0.7};

/// Number of increments that request a length in vain, before its operators are made. Making them costs about as much as twenty
/// evaluations of the window, and while a contact grows, short windows are soon too short.
inline constexpr double requests_without_window = 3.0;

/// Columns of a window: an even number, so that its transforms have a Nyquist wave like those of the body.
[[nodiscard]] int length_of_window(std::size_t index, int columns);
/// Index of the shortest window that contains the needed columns and two more on either side; empty: none.
[[nodiscard]] std::optional<std::size_t> window_for(int needed, int columns);

/// A range of columns of a body in which strain and load change in an increment, computed like a half space of its own.
///
/// Stress and displacement are linear in plastic strain and load. Relative to a reference solution, for which all of the body has
/// been computed, only the changes of strain and load within the window and their effects within the window are computed. Their
/// effects outside the window are left out until all cells are computed again: docs/theory/elastoplastic.md (windows).
class Window
{
public:
  /// @param ranks  that share the body; fields are those of the own layers
  Window(const VolumeGrid& body, ElasticStack elastic, halfspace::HalfSpace::Ranks ranks);

  /// A consistent solution for the whole body.
  struct Reference
  {
    std::span<const double> stress;                      ///< deviator
    std::span<const double> thermal_stress;              ///< deviator, included in `stress`; empty: none
    std::array<std::span<const double>, 3> displacement; ///< along z, x and y; empty parts are not needed
    const StoredLoad* load;
  };
  /// To be called where an increment begins: it counts once for each length that it requests.
  void begin_increment();
  /// Places the window around the needed columns and a margin, if a possible length contains them and enough increments have
  /// requested this length, or a longer one, to justify the cost of its operators.
  /// @returns whether it has been placed
  [[nodiscard]] bool place(const Columns& needed, const Reference& reference);
  [[nodiscard]] const Columns& columns() const { return columns_; }
  /// Whether a column lies at an end of the window that is not an end of the body.
  [[nodiscard]] bool is_at_end(int column) const;
  /// Whether the load equals that of the reference outside the window.
  [[nodiscard]] bool holds(const halfspace::SurfaceLoad& load) const;

  /// Transforms the change of the strain, and writes the displacement of the surface within the window.
  /// @param strain  of the whole body
  /// @param active  all cells in which the strain may differ from that of the reference, with the latter; they must lie in the
  ///                window
  /// @param layers  number of layers, from the surface, whose stress will be computed
  /// @param host    work of the whole body, not in use, whose buffers are borrowed
  void load(std::span<const double> strain, const ActiveCells& active, int layers,
            halfspace::Displacements displacements, const std::array<std::span<double>, 3>& displacement,
            halfspace::HalfSpace::Work& host);
  /// Writes the stress for the strain of the last `load` and a load, in the requested layers and the independent rows of the
  /// window.
  void stress(const halfspace::SurfaceLoad& load, std::span<const double> thermal_stress, std::span<double> stress,
              halfspace::HalfSpace::Work& host);

  /// Number of increments that requested each length. It decides when windows are used, and therefore is part of the state in
  /// checkpoints.
  [[nodiscard]] std::vector<double>& requests() { return requests_; }

private:
  /// Operators of a window of a given length, with their buffers.
  struct Part
  {
    halfspace::HalfSpace half_space;
    halfspace::HalfSpace::Work work;
  };
  [[nodiscard]] std::optional<std::size_t> length_after_request(std::size_t index);
  [[nodiscard]] Part& operators();
  void set_reference(const Reference& reference);
  void find_strain_change(std::span<const double> strain, const ActiveCells& active);
  template <typename Use>
  void for_independent_rows(int layers, const Use& use) const;
  template <typename Use>
  void for_surface_rows(const Use& use) const;

  VolumeGrid body_; ///< own layers
  int all_layers_;
  ElasticStack elastic_;
  halfspace::HalfSpace::Ranks ranks_;
  Share share_;
  Columns columns_{0, 0};
  VolumeGrid cells_;                                       ///< grid of the window, own layers
  int layers_ = 0;                                         ///< number of layers whose stress is computed
  std::unique_ptr<Part> part_;                             ///< of the longest length so far, made when first used
  std::vector<double> requests_;                           ///< see `requests`
  std::array<bool, window_shares.size()> has_requested_{}; ///< by the present increment
  std::vector<double> stress_;                             ///< of the reference, within the window
  std::array<std::vector<double>, 3> displacement_;        ///< displacement of the reference, within the window
  StoredLoad load_;                                        ///< of the reference
  std::vector<double> strain_change_, stress_change_;
  std::array<std::vector<double>, 3> displacement_change_; ///< change of the displacement
  StoredLoad load_change_;                                 ///< change of the load
  std::optional<halfspace::HalfSpace::Loaded> loaded_;
};

} // namespace brinell::elastoplastic
