// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/body.hpp"
#include "embedded.hpp"
#include "initial_stress.hpp"
#include "watched_cells.hpp"
#include "window.hpp"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// Residual displacement and stress of one body for a trial strain and a load: in all cells, or only in the layers and columns
/// that matter until an increment is nearly solved (docs/theory/elastoplastic.md, layer rule and windows). The stress is the sum
/// of that of the load, of the plastic strain, of heat, and the initial stress.
class Evaluation
{
public:
  Evaluation(const VolumeGrid& grid, std::shared_ptr<const halfspace::HalfSpace> half_space,
             const constitutive::Material& material, const BodySettings& settings);

  /// Begins an increment, in which all cells count until `follow`.
  /// @param shift  by which the contact moves along x [cells]
  void begin(int shift);
  /// Body::require
  void require(Scope scope);
  /// Of the last evaluation.
  [[nodiscard]] Scope scope() const;
  /// Body::cost
  [[nodiscard]] double cost() const { return static_cast<double>(layers_) * columns().count * grid_.surface.ny; }
  /// Layers, from the surface, and columns whose stress is computed.
  [[nodiscard]] int layers() const { return layers_; }
  [[nodiscard]] Columns columns() const { return windowed_ ? window_->columns() : Columns{0, grid_.surface.nx}; }
  /// Extends what is computed to the active cells, of which those from `first` on are new.
  void follow(const ActiveCells& active, std::size_t first);
  /// @param deepest  layer of the active cells of a body on a device
  void follow(int deepest);

  /// Transforms the plastic strain of a trial, which must stay where it is, and computes the displacement.
  /// @param state   before the increment, with the strain of the trial
  /// @param active  all cells whose strain may have changed
  /// @returns the largest change of the normal displacement since the previous evaluation [m], over the cells that both computed
  double load(const BodyState& state, const ActiveCells& active);
  /// Has a device integrate the plastic strain and compute the displacement.
  double load_on(BodyOnDevice& device, Integration integration);
  /// Computes the deviator of the stress of the transformed strain under a load, in the layers and columns above and their
  /// independent rows.
  /// @param thermal  deviator of the thermal stress; empty: none
  void stress(const halfspace::SurfaceLoad& load, std::span<const double> thermal, std::span<double> stress);
  /// Computes displacement and stress of the strain of a state in all cells, whatever was known.
  void compute_anew(const BodyState& state, const halfspace::SurfaceLoad& load, std::span<double> stress);
  /// Computes the displacement along x of a trial if it is needed and not known.
  /// @param device  that has the trial; nullptr: none
  void find_displacement_x(std::span<const double> strain, BodyOnDevice* device);

  /// Residual displacement along z, x, y; empty if it is not needed.
  [[nodiscard]] const std::vector<double>& displacement(std::size_t axis) const { return displacement_[axis]; }
  /// Returns to the displacements of a state.
  void restore(const BodyState& state);
  /// Writes the displacements to a state.
  void store(BodyState& state) const;
  /// Keeps the load of a committed state.
  void commit(const halfspace::SurfaceLoad& load);
  void exchange(Archive& archive);

  [[nodiscard]] const InitialStress& initial_stress() const { return initial_stress_; }
  /// Constants in an own layer of cells.
  [[nodiscard]] const Elastic& elastic_of(std::size_t layer) const
  {
    return half_space_->elastic_of(share_.layer(static_cast<int>(layer)));
  }
  /// Of the equivalent strain of the inclusions in the last evaluation; zero without inclusions.
  [[nodiscard]] halfspace::Inclusions::Report inclusion_report() const
  {
    return embedded_ ? embedded_->report() : halfspace::Inclusions::Report();
  }
  /// Deviator of the stress of the own strain of inclusions; empty: none.
  [[nodiscard]] std::span<const double> own_stress() const
  {
    return embedded_ ? std::span(embedded_->own_deviator()) : std::span<const double>();
  }
  /// Body::full_stress and Body::stress_at
  void full_stress(const halfspace::SurfaceLoad& load, std::span<const double> strain, std::span<double> deviator,
                   std::span<double> trace, int layers);
  [[nodiscard]] std::vector<Body::CellStress> stress_at(std::span<const std::size_t> cells,
                                                        const halfspace::SurfaceLoad& load, const BodyState& state);
  /// Body::keep_trace, Body::for_layers
  void keep_trace() { keeps_trace_ = true; }
  void for_layers(const halfspace::SurfaceLoad& load, const BodyState& state, const Body::UseLayer& use);

private:
  void choose_window(const BodyState& state, const ActiveCells& active);
  [[nodiscard]] bool is_whole() const { return layers_ == grid_.nz && !windowed_; }
  [[nodiscard]] halfspace::Displacements wanted() const;
  void load_strain();
  void find_displacements(halfspace::Displacements wanted);
  [[nodiscard]] double change_since(const std::vector<double>& before) const;
  void prepare_work();
  [[nodiscard]] std::size_t layer_of(std::size_t cell) const { return cell / grid_.surface.size(); }
  [[nodiscard]] std::vector<Body::CellStress> elastic_stress_at(std::span<const std::size_t> cells,
                                                                const halfspace::SurfaceLoad& load);

  [[nodiscard]] const Communicator& ranks() const { return half_space_->ranks(); }

  VolumeGrid grid_;
  std::shared_ptr<const halfspace::HalfSpace> half_space_;
  Share share_;
  VolumeGrid own_; ///< own layers
  bool is_plastic_, shortcuts_, is_on_device_;
  InitialStress initial_stress_;
  halfspace::HalfSpace::Work work_;
  std::span<const double> strain_;                     ///< of the present trial
  std::optional<halfspace::HalfSpace::Loaded> loaded_; ///< strain in waves
  int layers_;
  std::array<std::vector<double>, 3> displacement_;
  bool knows_displacement_x_ = false; ///< whether it is that of the present trial

  std::unique_ptr<Embedded> embedded_; ///< nullptr: no inclusions
  std::unique_ptr<Window> window_;     ///< nullptr: none
  bool windowed_ = false;              ///< the current evaluation is restricted to the window
  bool was_windowed_ = false;          ///< the previous one was, in the present box of the window
  bool wants_all_cells_ = false;       ///< the next evaluation is to compute all cells
  bool may_use_window_ = false;        ///< no evaluation of this increment has computed all cells
  int shift_ = 0;                      ///< by which the contact moves in the increment [cells]
  StoredLoad committed_load_;          ///< of the state; with a window

  WatchedCells watched_;            ///< by `stress_at`
  bool keeps_trace_ = false;        ///< evaluations of all cells prepare the trace in all of them
  std::vector<double> layer_trace_; ///< buffer of for_layers
};

} // namespace brinell::elastoplastic
