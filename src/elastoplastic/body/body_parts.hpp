// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/body.hpp"
#include "evaluation.hpp"

/// The parts of a body, and functions of several of them.
namespace brinell::elastoplastic
{

/// Size of the yield surface in each cell.
struct Yield
{
  constitutive::Material material;
  std::size_t cells_of_layer;
  std::vector<double> factor{};    ///< on the yield stress, of the layers
  std::vector<double> softening{}; ///< further factor, of the cells, at the end of the current increment; empty: none

  [[nodiscard]] std::size_t layer_of(std::size_t cell) const { return cell / cells_of_layer; }
  [[nodiscard]] double softening_at(std::size_t cell) const { return softening.empty() ? 1.0 : softening[cell]; }
  /// Hardening law in a layer without softening.
  template <typename Law>
  [[nodiscard]] constitutive::ScaledLaw<Law> of_layer(const Law& law, std::size_t layer) const
  {
    return {law, factor[layer]};
  }
  template <typename Law>
  [[nodiscard]] constitutive::ScaledLaw<Law> at(const Law& law, std::size_t cell) const
  {
    return {law, factor[layer_of(cell)] * softening_at(cell)};
  }
};

/// The solution of an increment that is not committed, but for the plastic strain, which is in the state.
struct Trial
{
  bool is_open = false;   ///< in an increment
  double stiffness = 0.0; ///< c [Pa]
  ActiveCells active{};
  /// Deviatoric stress in the computed layers. Between increments: the stress of the state, but in the cells that were active last
  /// their q, which is the initial guess of the next increment.
  std::vector<double> stress{};
  /// Indices and q of those cells, to restore the guess when an increment fails.
  std::vector<std::size_t> guessed_cells{};
  std::vector<double> guessed_q{};
  std::vector<double> thermal_stress{}; ///< at the end of the current increment, if it is `has_thermal_stress`
  bool has_thermal_stress = false;      ///< otherwise that of the state stays
  double yield_error = 0.0;             ///< of the last evaluation
  bool bears_shear = false;             ///< whether there was shear in the last evaluation
};

struct BodyParts
{
  VolumeGrid grid;
  BodySettings settings;
  Yield yield;
  Evaluation evaluation;
  BodyState state{};
  PlasticZone zone{}; ///< of the state
  Trial trial{};

  [[nodiscard]] bool is_plastic() const { return yield.material.is_plastic(); }
  /// At the end of the current increment; empty without heat.
  [[nodiscard]] const std::vector<double>& thermal_stress() const
  {
    return trial.has_thermal_stress ? trial.thermal_stress : state.thermal_stress;
  }
  [[nodiscard]] Deviator backstress(std::size_t cell, std::size_t term) const;
  /// Centre of the yield surface before the increment.
  [[nodiscard]] Deviator centre(std::size_t cell) const;
  [[nodiscard]] int copies(std::size_t a) const { return static_cast<int>(trial.active.copies(a)); }
  /// Calls use(cell, seen) for an active cell and, with symmetry, for its mirror image; the function `seen` converts a deviator of
  /// the active cell to its value in that cell.
  template <typename Use>
  void with_copies(std::size_t a, const Use& use) const
  {
    use(trial.active.cell(a), [](const Deviator& d) { return d; });
    if (copies(a) == 2)
      use(mirrored_cell(grid.surface, trial.active.cell(a)), mirrored_in_y);
  }
};

/// Plastic flow in all active cells.
void flow(BodyParts& body, Integration integration);
/// Computes the images g(q) of the trials from the stress of the evaluation.
/// @returns the largest von Mises norm of g - q over the yield stress, among the cells that yield
[[nodiscard]] double map_trials(BodyParts& body);
/// Moves the trials of the active cells from `first` on, which have not been evaluated yet, to the nearest stress of the yield
/// surface. Without plastic strain this is the stress of the material law; g - q, the excess of the stress over it, is then the
/// residual that belongs to the evaluation that found the cells. A trial of g would have no residual there but one in the next
/// evaluation, at the same trial, and the difference of the two would mislead the acceleration.
void put_on_yield_surface(BodyParts& body, std::size_t first);
/// Adds cells to the active set.
/// @param q_field   on the whole grid, read `shift` columns to the left of each cell; cells without a value there are not added
/// @param fraction  of the yield stress above which a cell is active; negative: every cell
void collect_active(BodyParts& body, const std::vector<double>& q_field, int shift, double fraction);
/// Stores the q of the active cells, with their mirror images, as the guess for the next increment.
void store_guess(BodyParts& body);
/// Recovers the guess from the fields, for instance of a checkpoint: guessed cells are those whose q differs from the stress.
void recover_guess(BodyParts& body);

/// Locked-in elastic energy [J].
/// @param zone  contains all cells with plastic strain
[[nodiscard]] double locked_in_energy(const BodyParts& body, const halfspace::SurfaceLoad& load,
                                      const PlasticZone& zone);
/// Work of the thermal stress on the plastic strain of the present increment, by the trapezoidal rule [J].
[[nodiscard]] double thermal_work_of_trial(const BodyParts& body);

} // namespace brinell::elastoplastic
