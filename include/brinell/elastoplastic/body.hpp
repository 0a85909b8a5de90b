// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/material.hpp"
#include "brinell/elastoplastic/active_cells.hpp"
#include "brinell/elastoplastic/device.hpp"
#include "brinell/elastoplastic/plastic_zone.hpp"
#include "brinell/elastoplastic/settings.hpp"
#include "brinell/foundation/field_table.hpp"
#include "brinell/foundation/hidden.hpp"
#include "brinell/foundation/layered_fields.hpp"
#include "brinell/foundation/symmetry.hpp"
#include "brinell/halfspace/half_space.hpp"
#include "brinell/halfspace/inclusions.hpp"

#include <functional>
#include <memory>
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

class Evaluation;

/// How much of a body an evaluation computes.
enum class Scope
{
  near,        ///< the layers and columns in which the increment changes anything, as far as short cuts are allowed
  all_columns, ///< all columns of these layers
  all          ///< all cells
};

/// An inclusion of a body that can yield.
struct Inclusion : halfspace::Inclusion
{
  double yield_factor = 1.0; ///< on the yield stress of its cells, > 0
  int number = 1;            ///< name in fields
};

/// How a body is computed.
struct BodySettings
{
  /// Compute only the layers and cells near yield until an evaluation closes the increment; see Settings::shortcuts.
  bool shortcuts = true;
  /// The components on which the loads do work: also the one along x with shear along x, all with shear along x and y. All three
  /// are computed in each evaluation; if only x is added, it is computed on demand.
  halfspace::Displacements displacements = halfspace::Displacements::normal;
  /// With short cuts: compute only the columns of the active cells and of the load until an evaluation closes the increment; see
  /// Settings::windows.
  bool windows = false;
  /// Cells of other elastic constants. The body is then computed in all columns, must be able to yield, and takes no heat.
  std::vector<Inclusion> inclusions{};
  /// Where increments are evaluated, if the body can yield; nullptr: on this processor.
  std::shared_ptr<const Device> device{};
};

/// Sides of a body's grid.
struct Edges
{
  bool ends = false;   ///< first or last column, along x
  bool sides = false;  ///< first or last row, along y
  bool bottom = false; ///< last layer
};

/// Size of the yield surface in each cell.
struct Yield
{
  constitutive::Material material;
  std::size_t cells_of_layer;
  std::vector<double> factor{}; ///< on the yield stress, of the layers of cells
  /// Laws of the coats and the substrate; infinite strength where it stays elastic.
  std::vector<constitutive::HardeningLaw> laws{};
  std::vector<std::size_t> law_of{}; ///< index of the law of each layer of cells
  std::vector<double> softening{};   ///< further factor, of the cells, at the end of the current increment; empty: none

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
  [[nodiscard]] const constitutive::HardeningLaw& law_at(std::size_t cell) const
  {
    return laws[law_of[layer_of(cell)]];
  }
  /// Terms of kinematic hardening in a cell: coats have none.
  [[nodiscard]] std::span<const constitutive::KinematicTerm> terms_at(std::size_t cell) const
  {
    return law_of[layer_of(cell)] + 1 == laws.size() ? std::span(material.kinematic)
                                                     : std::span<const constitutive::KinematicTerm>();
  }
  /// Calls work(law, first, last) for parts of the cells [first, last) of a list whose law is the same.
  template <typename Work>
  void with_laws(std::span<const std::size_t> cells, std::size_t first, std::size_t last, const Work& work) const
  {
    while (first < last)
    {
      std::size_t end = last;
      if (laws.size() > 1)
        for (end = first + 1; end < last && law_of[layer_of(cells[end])] == law_of[layer_of(cells[first])];)
          ++end;
      std::visit([&](const auto& law) { work(law, first, end); }, law_at(cells[first]));
      first = end;
    }
  }
};

/// The solution of an increment that is not committed, but for the plastic strain, which is in the state.
struct Trial
{
  bool is_open = false;            ///< in an increment
  std::vector<double> stiffness{}; ///< c of each layer of cells [Pa]
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
  /// Of a body that ranks share: places of the own active cells among those of all ranks, in the order in which a rank alone would
  /// add them, and the number of all.
  std::vector<std::size_t> places{};
  std::size_t count_of_all = 0;
};

/// A body on a device, and what both sides know of each other.
struct DevicePart
{
  std::unique_ptr<BodyOnDevice> body{}; ///< nullptr: on this processor
  bool knows_state = false;             ///< otherwise the state is to be written
  bool must_commit = false;             ///< the state is that of its trial
  bool is_read = false;                 ///< the processor knows the active cells of the trial
  bool is_stress_read = false;          ///< the processor knows its stress
  bool is_softening_known = true, is_thermal_stress_known = true;
  int deepest = 0; ///< layer of the active cells
};

/// The parts of a body. Ranks may share it: each then has the fields of its own layers, and all of them the surface.
struct BodyParts
{
  VolumeGrid grid; ///< of the fields: the own layers
  VolumeGrid whole;
  std::shared_ptr<const Communicator> ranks;
  Share share;
  BodySettings settings;
  Yield yield;
  Hidden<Evaluation> evaluation;
  BodyState state{};
  PlasticZone zone{}; ///< of the state
  Trial trial{};
  DevicePart device{};

  [[nodiscard]] bool is_plastic() const { return yield.material.is_plastic(); }
  /// Layer of the whole body in which an own cell lies.
  [[nodiscard]] int layer_of(std::size_t cell) const { return share.layer(static_cast<int>(yield.layer_of(cell))); }
  /// At the end of the current increment; empty without heat.
  [[nodiscard]] const std::vector<double>& thermal_stress() const
  {
    return trial.has_thermal_stress ? trial.thermal_stress : state.thermal_stress;
  }
  [[nodiscard]] Deviator backstress(std::size_t cell, std::size_t term) const;
  /// c of a cell [Pa].
  [[nodiscard]] double stiffness(std::size_t cell) const { return trial.stiffness[yield.layer_of(cell)]; }
  /// Centre of the yield surface before the increment.
  [[nodiscard]] Deviator centre(std::size_t cell) const;
  [[nodiscard]] int copies(std::size_t a) const { return static_cast<int>(trial.active.copies(a)); }
  /// Calls use(cell, seen) for an active cell and, on a mirrored grid, for its mirror image; the function `seen` converts a
  /// deviator of the active cell to its value in that cell.
  template <typename Use>
  void with_copies(std::size_t a, const Use& use) const
  {
    use(trial.active.cell(a), [](const Deviator& d) { return d; });
    if (copies(a) == 2)
      use(mirrored_cell(grid.surface, trial.active.cell(a)), mirrored_in_y);
  }
};

/// One body of a contact: material, operators, history, and the trial solution of the current increment.
///
/// The unknown of an increment is the trial deviator q = s + c d_eps in the active cells (those near or beyond yield).
/// Everywhere else the increment is elastic, and the stress follows from load and plastic strain. During an increment, from
/// `begin` to `commit` or `restore`, the plastic strain in the state is that of the trial; the rest of the state is unchanged.
class Body
{
public:
  /// @param grid        if it is mirrored, evaluations work on the independent rows alone; in the state all rows are kept
  ///                    consistent.
  /// @param half_space  operators of the grid and the elastic constants, shared by bodies that are alike; nullptr: rigid body.
  ///                    If ranks share it, they share the body: all of them call the same functions at the same time.
  Body(const VolumeGrid& grid, std::shared_ptr<const halfspace::HalfSpace> half_space,
       const constitutive::Material& material, const BodySettings& settings = {});

  [[nodiscard]] const VolumeGrid& grid() const { return parts_.whole; }
  /// Of the fields: the own layers, if ranks share the body.
  [[nodiscard]] const VolumeGrid& own_grid() const { return parts_.grid; }
  [[nodiscard]] const Share& share() const { return parts_.share; }
  /// The ranks that share the body.
  [[nodiscard]] const Communicator& ranks() const { return *parts_.ranks; }
  [[nodiscard]] bool has_inclusions() const { return !parts_.settings.inclusions.empty(); }
  /// The number of the inclusion in each cell; 0: none.
  [[nodiscard]] std::vector<double> inclusion_numbers() const;
  /// Iterations and residual of their equivalent strain in the last evaluation.
  [[nodiscard]] halfspace::Inclusions::Report inclusion_report() const;
  [[nodiscard]] const constitutive::Material& material() const { return parts_.yield.material; }
  /// Of a body that ranks share, with the fields of the own layers.
  [[nodiscard]] const BodyState& state() const { return parts_.state; }
  /// Fields within the body.
  /// @param own  of the own layers
  [[nodiscard]] LayeredFields layered(std::vector<std::vector<double>> own) const;
  /// The own layers of one or several fields within the body, one after the other.
  [[nodiscard]] std::vector<double> own_layers(std::span<const double> whole) const;
  /// Accumulated equivalent plastic strain in a cell of the whole body; 0 if it is rigid.
  [[nodiscard]] double equivalent_at(std::size_t cell) const;
  /// Where the state has plastic strain; empty for a body that cannot yield.
  [[nodiscard]] const PlasticZone& plastic_zone() const { return parts_.zone; }
  /// Largest equivalent plastic strain of each layer of the whole body; empty for a body that cannot yield.
  [[nodiscard]] std::vector<double> largest_of_layers() const;
  [[nodiscard]] double largest_strain() const;

  /// Sets a factor on the yield stress of each cell, in addition to the depth profile, for instance by temperature
  /// (constitutive/softening.hpp). Between increments the factor takes effect at once; within an increment it takes effect with
  /// the next `integrate`, and `restore` undoes it. The factor is part of the state: an increment begins with the factor of the
  /// previous one, and an increment of zero duration keeps it.
  /// @param factor  > 0, one per cell; empty: 1 everywhere
  void set_softening(std::span<const double> factor);

  /// Where the guess for q comes from.
  enum class Guess
  {
    last_increment, ///< q of the last increment, moved along x with the contact: the flow goes on
    stress          ///< the stress before the increment: no flow
  };
  /// Starts an increment.
  /// @param shift            by which the contact moves along x [cells]
  /// @param stiffness_share  c / (2 mu) in q = s + c d_eps. With 1 the plain fixed point descends from any start in the
  ///                         continuum (docs/theory/elastoplastic.md); a cell's own stiffness, near 0.6, converges faster.
  void begin(int shift, double stiffness_share, Guess guess = Guess::last_increment);
  /// Sets the deviator of the thermal stress at the end of the increment, 5 values per cell [Pa]; to be called after `begin`.
  /// Without this call the thermal stress of the last increment stays.
  void set_thermal_stress(std::span<const double> deviator);
  /// Makes the next evaluation compute at least this much. All columns stay for the rest of the increment, and all layers do
  /// until new cells become active. An increment may only be committed after an evaluation of all cells that found no new active
  /// cell.
  void require(Scope scope);
  /// How much the last evaluation computed.
  [[nodiscard]] Scope scope() const;
  /// Number of cells whose stress the last evaluation computed, a measure of the time that it took.
  [[nodiscard]] double cost() const;
  /// Undoes all changes of an increment that was not committed; does nothing after a commit.
  void restore();
  /// Integrates the plastic strain for the present q and computes the residual displacement of that strain.
  /// @returns the largest change of the normal displacement since the previous evaluation [m], over the cells that both computed
  double integrate(Integration integration);
  /// Computes the stress under `load` (on the whole surface grid) and, from the stress, the next fixed-point value g(q).
  /// @returns whether cells outside the active set yield; they have been added to the set.
  bool update(const halfspace::SurfaceLoad& load);
  /// Computes what evaluations leave out but `energy` and `commit` need: the displacement along x of the present trial, if the
  /// surface bears shear and it is not known yet; and of mirror images the rows of the trial that are mirror images of others.
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
  [[nodiscard]] BodyState take_state() && { return std::move(parts_.state); }

  /// The active cells with their trials q, images g(q) and flow; `trial` gives the trials to be changed.
  [[nodiscard]] const ActiveCells& active() const { return parts_.trial.active; }
  /// Number of active cells of all ranks, and the place of an own one among them.
  [[nodiscard]] std::size_t active_of_all() const
  {
    return parts_.share.is_all() && !is_on_device() ? parts_.trial.active.size() : parts_.trial.count_of_all;
  }
  [[nodiscard]] std::size_t place_of_active(std::size_t a) const
  {
    return parts_.share.is_all() ? a : parts_.trial.places[a];
  }
  [[nodiscard]] std::vector<double>& trial() { return parts_.trial.active.trials(); }
  [[nodiscard]] bool is_on_device() const { return parts_.device.body != nullptr; }
  /// Access to the trials of a body on a device, for their acceleration.
  [[nodiscard]] BodyOnDevice& on_device() { return *parts_.device.body; }
  /// Of a body on a device: copies the trial to the processor, if it is not known there. Before this call, the active cells are not known
  /// but for their number.
  void fetch();
  /// Sets the trials of a body on a device to the combination of evaluations with these weights.
  /// @param goes_further  whether to `go_further` then
  void combine(std::span<const double> weights, bool goes_further);
  /// Lengthens the step of the trials in cells near the surface that flow along the surface, because the surrounding body hardly
  /// restrains such flow; does nothing without shear on the surface.
  /// @param residual  g - q of the combination of evaluations from which the trials come. Trials with a zero
  ///                  residual are not changed.
  void go_further(const std::vector<double>& residual);
  /// Error of the last `update`: largest von Mises norm of g - q over the yield stress, among the cells that yield.
  [[nodiscard]] double yield_error() const { return parts_.trial.yield_error; }
  /// Residual displacement of the present trial along z (0), x (1) or y (2) [m]. Those along the surface are empty unless they are
  /// computed and the body is plastic.
  [[nodiscard]] std::span<const double> residual_displacement(std::size_t axis = 0) const;
  /// Shear that each cell of the surface can carry along a unit vector, with the hardening of the present trial [Pa]; infinite if
  /// the body does not yield. For a zero vector: the shear that the cell can carry in every direction.
  [[nodiscard]] std::vector<double> shear_strength(double along_x, double along_y = 0.0) const;
  /// Total stress in all layers [Pa], from a load, the plastic strain and the initial stress before the first load: deviator, 5
  /// values per cell, and trace, in the own layers. The body must not be rigid.
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
  /// The independent rows of one layer: component c of the deviator is at deviator[c * stride + cell], to which `initial` is
  /// added for xx and yy, the trace is trace[cell] + initial_trace [Pa].
  struct LayerStress
  {
    const double* deviator;
    std::size_t stride;
    const double* trace;
    double initial, initial_trace;
  };
  using UseLayer = std::function<void(int layer, const LayerStress&)>;
  /// From the next increment on, what `for_layers` needs is prepared, so that it costs little.
  void keep_trace();
  /// Passes on the stress of the committed state, layer by layer; the threads share the layers. It includes the thermal stress
  /// only if the body can yield.
  void for_layers(const halfspace::SurfaceLoad& load, const UseLayer& use);
  /// Locked-in elastic energy plus dissipation [J], of the present trial for the load of the last update, or of the last
  /// committed increment.
  [[nodiscard]] double energy(const halfspace::SurfaceLoad& load) const;

private:
  BodyParts parts_;
};

} // namespace brinell::elastoplastic
