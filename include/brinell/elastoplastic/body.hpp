// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/material.hpp"
#include "brinell/elastoplastic/active_cells.hpp"
#include "brinell/elastoplastic/plastic_zone.hpp"
#include "brinell/elastoplastic/settings.hpp"
#include "brinell/foundation/field_table.hpp"
#include "brinell/foundation/symmetry.hpp"
#include "brinell/halfspace/half_space.hpp"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// The complete history of one body, on its own material grid.
struct BodyState
{
  std::vector<double> plastic_strain;        ///< deviator field, 5 values per cell; empty for a rigid body
  std::vector<double> equivalent;            ///< accumulated equivalent plastic strain; empty for a rigid body
  std::vector<double> backstress;            ///< deviator field per kinematic term, one after the other [Pa]
  std::vector<double> stress;                ///< deviator after the last increment [Pa]; empty if the body cannot yield
  std::vector<double> residual_displacement; ///< of the surface, positive into the body [m]
  std::vector<double> residual_displacement_x; ///< along x [m]; empty unless the surface bears shear
  std::vector<double> residual_displacement_y; ///< along y [m]; empty unless it bears shear along y
  double dissipation =
      0.0; ///< plastic work since the start [J]; with back stresses, a part of it stays in the material
  double locked_in_energy = 0.0;        ///< elastic energy of the residual stress [J]
  std::vector<double> thermal_stress{}; ///< deviator at the end of the last increment [Pa]; empty without heat
  double thermal_work = 0.0;            ///< work of the thermal stress on the plastic strain since the start [J]
  std::vector<double> softening{};      ///< current factors on the yield stress of the cells; empty: 1 everywhere

  static constexpr auto table()
  {
    using S = BodyState;
    constexpr auto deviator = InMirror::deviator;
    return std::tuple{listed(&S::plastic_strain, {"plastic_strain"}, {.in_mirror = deviator}),
                      listed(&S::equivalent, {"equivalent"}),
                      listed(&S::backstress, {"backstress"}, {.in_mirror = deviator}),
                      listed(&S::stress, {"stress"}, {.is_derived = true, .in_mirror = deviator}),
                      listed(&S::residual_displacement, {"residual_displacement"}, {.is_derived = true}),
                      listed(&S::residual_displacement_x, {"residual_displacement_x"},
                             {.is_derived = true, .in_mirror = InMirror::odd}),
                      listed(&S::residual_displacement_y, {"residual_displacement_y"}, {.is_derived = true}),
                      listed(&S::dissipation, {"dissipation"}),
                      listed(&S::locked_in_energy, {"locked_in_energy"}, {.is_derived = true}),
                      listed(&S::thermal_stress, {"thermal_stress"}, {.is_sized = true, .in_mirror = deviator}),
                      listed(&S::thermal_work, {"thermal_work"}),
                      listed(&S::softening, {"softening"}, {.is_sized = true})};
  }
  void exchange(Archive& archive) { exchange_members(archive, *this); }
};

class Window;
struct Columns;

/// Sides of a body's grid.
struct Edges
{
  bool ends = false;   ///< first or last column, along x
  bool sides = false;  ///< first or last row, along y
  bool bottom = false; ///< last layer
};

/// One body of a contact: material, operators, history, and the trial solution of the current increment.
///
/// The unknown of an increment is the trial deviator q = s + c d_eps in the active cells (those near or beyond yield).
/// Everywhere else the increment is elastic, and the stress follows from load and plastic strain. During an increment, from
/// `begin` to `commit` or `restore`, the plastic strain in the state is that of the trial; the rest of the state is unchanged.
class Body
{
public:
  /// @param half_space  operators of the grid and the elastic constants, shared by bodies that are alike; nullptr: rigid body.
  /// @param shortcuts   compute only the layers and cells near yield until an evaluation closes the increment; see
  ///                    Settings::shortcuts.
  /// @param displacements  the components on which the loads do work: also the one along x with shear along x, all with shear
  ///                    along x and y. All three are computed in each evaluation; if only x is added, it is computed on demand.
  /// @param symmetry    of history and loads. If there is one, evaluations work on the independent rows alone; in the state
  ///                    all rows are kept consistent.
  /// @param windows     with short cuts: compute only the columns of the active cells and of the load until an evaluation closes
  ///                    the increment; see Settings::windows.
  Body(const VolumeGrid& grid, std::shared_ptr<const halfspace::HalfSpace> half_space,
       const constitutive::Material& material, bool shortcuts = true,
       halfspace::Displacements displacements = halfspace::Displacements::normal, Symmetry symmetry = Symmetry::none,
       bool windows = false);
  ~Body();
  Body(Body&&) noexcept;
  Body& operator=(Body&&) noexcept;
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;

  [[nodiscard]] const VolumeGrid& grid() const { return grid_; }
  [[nodiscard]] const constitutive::Material& material() const { return material_; }
  [[nodiscard]] const BodyState& state() const { return state_; }
  /// Where the state has plastic strain; empty for a body that cannot yield.
  [[nodiscard]] const PlasticZone& plastic_zone() const { return zone_; }
  [[nodiscard]] bool is_plastic() const { return material_.is_plastic(); }
  /// Whether backward Euler minimises an energy in an increment (docs/theory/elastoplastic.md): only with isotropic hardening.
  [[nodiscard]] bool has_energy() const { return material_.kinematic.empty(); }

  /// Sets a factor on the yield stress of each cell, in addition to the depth profile, for instance by temperature
  /// (constitutive/softening.hpp). Between increments the factor takes effect at once; within an increment it takes effect with
  /// the next `integrate`, and `restore` undoes it. The factor is part of the state: an increment begins with the factor of the
  /// previous one, and an increment of zero duration keeps it.
  /// @param factor  > 0, one per cell; empty: 1 everywhere
  void set_softening(std::span<const double> factor);

  /// Starts an increment. The initial guess for q is taken from the last increment and moved along x with the contact.
  /// @param shift            by which the contact moves along x [cells]
  /// @param stiffness_share  c / (2 mu) in q = s + c d_eps. With 1 the plain fixed point descends from any start in the
  ///                         continuum (docs/theory/elastoplastic.md); a cell's own stiffness, near 0.6, converges faster.
  void begin(int shift, double stiffness_share);
  /// Sets the deviator of the thermal stress at the end of the increment, 5 values per cell [Pa]; to be called after `begin`.
  /// Without this call the thermal stress of the last increment stays.
  void set_thermal_stress(std::span<const double> deviator);
  /// Makes the next evaluation compute the stress in all cells; without windows all later evaluations do so too, until new cells
  /// become active. An increment may only be committed after an evaluation of all cells that found no new active cell.
  void compute_all_layers();
  /// Makes all later evaluations of the increment compute all columns.
  void leave_window();
  /// Whether the last evaluation was restricted to a window.
  [[nodiscard]] bool was_windowed() const { return was_windowed_; }
  /// Number of cells whose stress the last evaluation computed, a measure of the time that it took.
  [[nodiscard]] double cost() const;
  /// Valid after `integrate`: whether the current evaluation computes the stress in all cells.
  [[nodiscard]] bool computes_all_layers() const { return layers_ == grid_.nz && !windowed_; }
  /// Undoes all changes of an increment that was not committed; does nothing after a commit.
  void restore();
  /// Integrates the plastic strain for the present q and computes the residual displacement of that strain.
  /// @returns the largest change of the normal displacement since the previous evaluation [m], over the cells that both computed
  double integrate(Integration integration);
  /// Computes the stress under `load` (on the whole surface grid) and, from the stress, the next fixed-point value g(q).
  /// @returns whether cells outside the active set yield; they have been added to the set.
  bool update(const halfspace::SurfaceLoad& load);
  /// Computes what evaluations leave out but `energy` and `commit` need: the displacement along x of the present trial, if the
  /// surface bears shear and it is not known yet; and with symmetry the rows of the trial that are mirror images of others.
  void complete_trial();
  /// Makes the present trial the new state.
  void commit(const halfspace::SurfaceLoad& load);

  /// Plastic work of the last committed increment [J/m^3], one value per cell. Valid until the next increment begins.
  [[nodiscard]] std::vector<double> work_of_increment() const;

  /// Everything that the next increment depends on.
  void exchange(Archive& archive);

  /// Edges of the grid that the plastic zone of the present trial has reached: strain beyond them would be lost.
  [[nodiscard]] Edges reached_edges() const;

  /// Takes over the history of the same body from a smaller grid with the same centre. Stress and residual displacement are
  /// computed anew, under `load` (on the whole surface grid).
  void continue_from(const BodyState& history, const VolumeGrid& from, const halfspace::SurfaceLoad& load);
  [[nodiscard]] BodyState take_state() && { return std::move(state_); }

  [[nodiscard]] std::size_t unknowns() const { return Deviator::size * active_.size(); }
  [[nodiscard]] std::vector<double>& trial() { return active_.trials(); }              ///< q, unknowns() values
  [[nodiscard]] const std::vector<double>& mapped() const { return active_.mapped(); } ///< g(q)
  [[nodiscard]] const std::vector<double>& flow() const { return active_.flow(); }     ///< see ActiveCells::flow
  /// Lengthens the step of the trials in cells near the surface that flow along the surface, because the surrounding body hardly
  /// restrains such flow; does nothing without shear on the surface.
  /// @param residual  g - q of the combination of evaluations from which the trials come, unknowns() values. Trials with a zero
  ///                  residual are not changed.
  void go_further(const std::vector<double>& residual);
  /// Error of the last `update`: largest von Mises norm of g - q over the yield stress, among the cells that yield.
  [[nodiscard]] double yield_error() const { return yield_error_; }
  [[nodiscard]] std::span<const double> residual_displacement() const { return displacement_; }
  /// Empty unless the surface bears shear and the body is plastic.
  [[nodiscard]] std::span<const double> residual_displacement_x() const { return displacement_x_; }
  /// Residual displacement along y; empty unless all displacements are computed.
  [[nodiscard]] std::span<const double> residual_displacement_y() const { return displacement_y_; }
  /// Shear that each cell of the surface can carry along a unit vector, with the hardening of the present trial [Pa]; infinite if
  /// the body does not yield. For a zero vector: the shear that the cell can carry in every direction.
  [[nodiscard]] std::vector<double> shear_strength(double along_x, double along_y = 0.0) const;
  /// Total stress in all layers [Pa], from a load, the plastic strain and the initial stress before the first load: deviator, 5
  /// values per cell, and trace. The body must not be rigid.
  /// @param layers  number of layers from the surface that are computed
  void full_stress(const halfspace::SurfaceLoad& load, std::span<double> deviator, std::span<double> trace,
                   int layers = halfspace::HalfSpace::all_layers);
  /// Stress in one cell [Pa].
  struct CellStress
  {
    Deviator deviator;
    double trace = 0.0;
  };
  /// Stress in some cells, as by `full_stress` up to rounding. Increments between two calls with the same cells keep
  /// what the second one needs, so that it costs next to nothing.
  [[nodiscard]] std::vector<CellStress> stress_at(std::span<const std::size_t> cells,
                                                  const halfspace::SurfaceLoad& load);
  /// Locked-in elastic energy plus dissipation [J], of the present trial for the load of the last update, or of the last
  /// committed increment.
  [[nodiscard]] double energy(const halfspace::SurfaceLoad& load) const;

private:
  /// Adds the initial stress in the layers [0, layers) and in the rows [0, rows) of each layer.
  void add_initial_stress(int layers, int rows, std::span<double> stress) const;
  void add_thermal_stress(int layers, int rows, std::span<double> stress) const;
  [[nodiscard]] std::size_t independent_cells() const; ///< in each layer
  [[nodiscard]] int copies(std::size_t a) const { return static_cast<int>(active_.copies(a)); }
  template <typename Use>
  void with_copies(std::size_t a, const Use& use) const;
  void find_displacement_x();
  /// At the end of the current increment; empty without heat.
  [[nodiscard]] const std::vector<double>& thermal_stress() const
  {
    return has_own_thermal_stress_ ? thermal_stress_ : state_.thermal_stress;
  }
  [[nodiscard]] double work_of_thermal_stress(const PlasticZone& zone) const;
  [[nodiscard]] double thermal_work_of_trial() const;
  void prepare_trial();
  void recover_guess();
  void store_guess();
  void restrict_to_active_layers();
  void find_watched_traces(const halfspace::SurfaceLoad& load);
  [[nodiscard]] bool watches(std::span<const std::size_t> cells);
  [[nodiscard]] std::vector<CellStress> elastic_stress_at(std::span<const std::size_t> cells,
                                                          const halfspace::SurfaceLoad& load);
  [[nodiscard]] CellStress stress_of_state(std::size_t cell) const;
  [[nodiscard]] double softening(std::size_t cell) const { return softening_.empty() ? 1.0 : softening_[cell]; }
  /// Hardening law in a layer without softening.
  template <typename Law>
  [[nodiscard]] constitutive::ScaledLaw<Law> law_of(const Law& law, std::size_t layer) const
  {
    return {law, yield_factor_[layer]};
  }
  template <typename Law>
  [[nodiscard]] constitutive::ScaledLaw<Law> law_at(const Law& law, std::size_t cell) const
  {
    return {law, yield_factor_[layer_of(cell)] * softening(cell)};
  }
  [[nodiscard]] std::size_t layer_of(std::size_t cell) const { return cell / grid().surface.size(); }
  [[nodiscard]] Deviator backstress(std::size_t cell, std::size_t term) const;
  [[nodiscard]] Deviator centre(std::size_t cell) const;
  template <typename Law>
  [[nodiscard]] constitutive::PlasticIncrement increment(const Law& law, std::size_t a, Integration integration);
  struct ActiveLanes;
  template <typename Law>
  void flow_of(const Law& law, Integration integration);
  template <typename Law>
  [[nodiscard]] double map_trials(const Law& law);
  void put_on_yield_surface(std::size_t first);
  void sizes_from_centre(const double* q, std::size_t row, std::size_t first, std::span<double> squares) const;
  template <typename Law>
  void find_cells_beyond(const Law& law, std::size_t layer, const std::vector<double>& q_field, int shift,
                         double fraction, std::vector<std::size_t>& found) const;
  void collect_active(const std::vector<double>& q_field, int shift, double fraction);
  [[nodiscard]] double equivalent_of_active(std::size_t a) const;
  [[nodiscard]] bool extends_beyond(const std::vector<std::size_t>& cells, std::size_t apart, int places,
                                    double largest) const;
  [[nodiscard]] bool may_yield_below() const;
  [[nodiscard]] double locked_in_energy(const halfspace::SurfaceLoad& load, const PlasticZone& zone) const;
  [[nodiscard]] PlasticZone zone_of_trial() const;
  [[nodiscard]] halfspace::Displacements displacements_per_evaluation() const;
  void find_displacements(halfspace::Displacements wanted);
  void choose_window();
  void load_strain();
  void find_stress(const halfspace::SurfaceLoad& load);
  void include_new_cells(std::size_t first);
  [[nodiscard]] Columns affected_columns(const std::array<std::vector<double>, 3>& load, int shift) const;
  [[nodiscard]] Columns searched_columns() const;
  [[nodiscard]] double change_of_displacement(const std::vector<double>& before) const;

  VolumeGrid grid_;
  constitutive::Material material_;
  std::shared_ptr<const halfspace::HalfSpace> half_space_;
  halfspace::HalfSpace::Work work_;
  std::optional<halfspace::HalfSpace::Loaded> loaded_; ///< strain of the present trial
  BodyState state_;
  PlasticZone zone_;                                  ///< of the state
  std::vector<double> yield_factor_, initial_stress_; ///< of the layers
  std::vector<double> softening_;                     ///< at the end of the current increment; empty: none
  std::vector<double> thermal_stress_;  ///< at the end of the current increment, if it is `has_own_thermal_stress_`
  bool has_own_thermal_stress_ = false; ///< otherwise that of the state stays
  double stiffness_ = 0.0;              ///< c [Pa]
  bool shortcuts_;
  Symmetry symmetry_;
  int layers_; ///< layers whose stress is computed, from the surface
  ActiveCells active_;
  double yield_error_ = 0.0; ///< error of the last evaluation
  bool bears_shear_ = false; ///< whether there was shear in the last evaluation
  bool in_increment_ = false;
  /// Deviatoric stress of the trial in the computed layers. Between increments: the stress of the state, but in the cells that
  /// were active last their q, which is the initial guess of the next increment.
  std::vector<double> stress_;
  /// Indices and q of those cells, to restore the guess when an increment fails.
  std::vector<std::size_t> guessed_cells_;
  std::vector<double> guessed_q_;
  std::vector<double> displacement_, displacement_x_, displacement_y_;
  bool knows_displacement_x_ = false; ///< whether displacement_x_ is that of the present trial

  std::unique_ptr<Window> window_;                    ///< nullptr: none
  bool windowed_ = false;                             ///< the current evaluation is restricted to the window
  bool was_windowed_ = false;                         ///< the previous one was, in the present box of the window
  bool wants_all_cells_ = false;                      ///< the next evaluation is to compute all cells
  bool may_use_window_ = false;                       ///< no evaluation of this increment has computed all cells
  int shift_ = 0;                                     ///< by which the contact moves in the increment [cells]
  std::array<std::vector<double>, 3> committed_load_; ///< of the state; with a window

  /// Cells that `stress_at` has been asked for, and the trace of their stress in the last evaluation of all cells [Pa],
  /// without the initial stress.
  std::vector<std::size_t> watched_;
  std::vector<double> watched_trace_;
  bool knows_watched_traces_ = false; ///< whether it is that of the present trial
};

} // namespace brinell::elastoplastic
