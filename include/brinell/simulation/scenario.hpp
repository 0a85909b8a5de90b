// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/fatigue.hpp"
#include "brinell/constitutive/material.hpp"
#include "brinell/elastoplastic/increment.hpp"
#include "brinell/foundation/archive.hpp"
#include "brinell/foundation/communicator.hpp"
#include "brinell/foundation/error.hpp"
#include "brinell/foundation/grid.hpp"
#include "brinell/foundation/layered_fields.hpp"
#include "brinell/simulation/fatigue.hpp"
#include "brinell/simulation/inclusion_shape.hpp"
#include "brinell/simulation/plan_error.hpp"
#include "brinell/simulation/shape.hpp"
#include "brinell/simulation/texture.hpp"

#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// Parts that all scenarios share: cases, plans, records of the history, snapshots, totals. SI units.
namespace brinell::simulation
{

/// A body in the general scenarios.
struct ShapedBody
{
  Shape shape;
  constitutive::Material material;
  Texture texture{};
  std::optional<constitutive::Fatigue> fatigue{}; ///< none: it is not computed
  Texture film{}; ///< thickness of a film that conducts badly, at the start: a height map of numbers >= 0; smooth: none
  std::vector<BodyInclusion> inclusions{}; ///< docs/theory/inclusions.md
  bool operator==(const ShapedBody&) const = default;
};

/// Boundary conditions at the edges of the grids: docs/theory/half-space.md (copies). Along a periodic axis the grids cover one
/// period, and never grow.
struct Domain
{
  struct Axis
  {
    Boundary boundary = Boundary::open;
    double size = 1.0; ///< period [m], > 0
    int cells = 0;     ///< number of cells in a period; 0: it follows from the spacing
    [[nodiscard]] bool is_periodic() const { return boundary == Boundary::periodic; }
    bool operator==(const Axis&) const = default;
  };
  Axis x, y;
  double layer = 0.0;     ///< thickness of the layers if no spacing is given [m]; 0: half the smaller cell
  double reference = 0.0; ///< with one periodic axis: see halfspace::SurfaceCompliance [m]; 0: reference_distance

  /// Whether both axes are periodic.
  [[nodiscard]] bool is_periodic() const { return x.is_periodic() && y.is_periodic(); }
  bool operator==(const Domain&) const = default;
};

/// Whether the problem is plane: the grid is a single row that repeats along y, so that nothing varies along y.
[[nodiscard]] inline bool is_plane(const SurfaceGrid& grid)
{
  return grid.is_periodic_y() && grid.ny == 1;
}

/// Why the contact of these bodies cannot be computed in the domain; empty if it can.
[[nodiscard]] std::optional<std::string> reason_against_contact(const ShapedBody& lower, const ShapedBody& upper,
                                                                const Domain& domain);

/// Why a texture is not compatible with the periods of the domain; empty if it is. A dent, or a map that does not repeat, has to
/// lie within one period; it is then repeated in each period.
[[nodiscard]] std::optional<std::string> reason_against_texture(const Texture& texture, const Domain& domain);

/// Distance from a line load at which its displacement is taken as zero [m]; 0 unless exactly one axis is periodic. It is the
/// given one; otherwise 2 R/e for two cylinders of equivalent radius R, so that their approach is that of Green (2005), of the
/// axis of a cylinder of radius R and a rigid flat (Johnson 1985, section 5.6); otherwise the period.
[[nodiscard]] double reference_distance(const Shape& lower, const Shape& upper, const Domain& domain);

/// Length of a line contact along y: that of the shorter roller, or the period; infinite without either [m].
[[nodiscard]] double line_length(const Shape& lower, const Shape& upper, const Domain& domain);

/// Parameters that the cases of all scenarios have besides their bodies: cells, solver, and the interface of the surfaces.
struct Numerics : elastoplastic::Effects ///< effects between the surfaces; wear acts where they slide on each other
{
  elastoplastic::Friction friction; ///< where the surfaces slide on each other
  elastoplastic::HeatSettings heat; ///< in bodies that have thermal constants
  Domain domain;
  std::optional<std::array<double, 3>> spacing; ///< cell sizes dx, dy, dz [m]
  double resolution = 8.0;                      ///< cells per contact radius along x if no spacing is given
  double extent = 1.0; ///< factor on the automatic extent of the grids around contact and plastic zone, > 0
  elastoplastic::Settings solver;
  /// Whether the fields within the bodies, such as stress, are wanted even if neither body can yield. Contact and surfaces then
  /// do not need them, and they cost a hundred times as much.
  bool fields_within = true;
};

/// Two bodies, and how their contact is computed: base of the cases of all scenarios.
struct PairCase : Numerics
{
  ShapedBody lower, upper;
};

/// Inclusions of a body on its grid.
struct EmbeddedCells
{
  std::size_t cells = 0;                                  ///< of all inclusions; 0: none
  int layers = 0;                                         ///< down to the deepest
  double least = std::numeric_limits<double>::infinity(); ///< cells along the smallest semi-axis
  double voxel = std::numeric_limits<double>::infinity(); ///< smallest edge of a voxel, in cells
  std::size_t coarsest = 0;                               ///< index of the inclusion with that semi-axis
  int cut = 0, beside = 0;              ///< shapes that end at the edge of the grid, and that lie beside it
  double contrast = 0.0;                ///< of the coarsest in shear: -1 rigid, 1 void
  double softest = 0.0, stiffest = 0.0; ///< largest and smallest contrast of all
  bool has_own_strain = false, has_own_strength = false;
  /// Largest ratio of the von Mises stress to the yield stress before any load, by own strain; NaN: not found in a plan.
  double at_rest = 0.0;
};

/// Grids, steps, tolerances and memory of a run; computed without running.
struct Plan
{
  SurfaceGrid contact;        ///< grid of the contact, which moves along with it
  VolumeGrid lower, upper;    ///< material grids, wide enough for the whole track
  bool surfaces_only = false; ///< no fields within the bodies, whose grids then have one layer
  int layers = 0;             ///< of grids with fields within the bodies
  int steps = 0;              ///< estimate
  elastoplastic::Twin twin = elastoplastic::Twin::none; ///< other than none: one body is solved
  halfspace::HeatTimes heat_times;                      ///< of heated bodies; zero without a speed
  bool is_textured = false;                             ///< whether a surface has a texture
  int shears = 0;                                       ///< components of the shear between the bodies
  double contact_share = 1.0; ///< estimated share of a period in contact; 1 without an estimate
  double memory_bytes = 0.0;
  elastoplastic::Scales scales; ///< of the tolerances
  double first_yield = 0.0;     ///< approach at which a body yields, with friction, not below 1 % of the largest [m]
  double peak_pressure = 0.0;   ///< of the smooth bodies if they stayed elastic, estimate [Pa]; 0 without an estimate
  /// Elastic peak pressure of the smooth bodies over that at first yield, with the friction of surfaces that slide; 0: not known.
  double peak_over_yield = 0.0;
  double reference = 0.0;                    ///< reference distance of the displacement with one periodic axis [m]
  std::array<EmbeddedCells, 2> inclusions{}; ///< of the lower and the upper body
};

/// Extent of contact and plastic zone in cells so far, from which the resolution is judged (quality/quality.hpp).
struct Coverage
{
  int contact_columns = 0, contact_rows = 0; ///< largest extent of the contact in one step
  int plastic_layers = 0;                    ///< depth of the plastic zone, in the body that has yielded more
  int largest_contact = 0;                   ///< cells in contact when their number last grew by a quarter
  /// Radius of the patches in cells when the contact was about largest: 4/pi times half of the mean chord along the shorter axis,
  /// which is the radius of a round contact; of a contact along a whole line half of its mean width. 0 without contact.
  double patch_cells = 0.0;
  double largest_pressure = 0.0; ///< [Pa]
  /// Radius of the paraboloid of the largest pressure in cells, from its neighbours along the axis where it falls faster: that of
  /// the contact for a pressure by Hertz, less if it stands on an asperity or a rim. 0 without contact.
  double peak_cells = 0.0;

  void exchange(Archive& archive);
};

/// Totals of a run since its start: part of every row of a history, and of every summary for the last row.
struct RunningTotals : elastoplastic::EffectTotals
{
  double work = 0.0;                                       ///< of the drive since the start [J]
  double dissipation_lower = 0.0, dissipation_upper = 0.0; ///< plastic work since the start [J]
  double dissipation_friction = 0.0; ///< heat of friction between the surfaces since the start [J]
  double work_of_expansion = 0.0;    ///< work of the bodies by thermal expansion since the start [J]
  double energy_residual = 0.0;      ///< elastic energy locked in by the plastic strain of both bodies [J]
  double energy_elastic = 0.0;       ///< recoverable energy of pressure and shear [J]
  double max_residual_lower = 0.0, max_residual_upper = 0.0; ///< largest depth of the residual displacement [m]
  double max_equivalent_plastic_strain = 0.0;
  Coverage coverage;
};

/// Part of every row of a history. Names and units of its numbers in files are in simulation/columns.hpp.
struct StepRecord : RunningTotals
{
  int step = 0;              ///< counts from 0: the row of the history
  int pass = 0;              ///< counts from 1
  double contact_area = 0.0; ///< [m^2]
  double max_pressure = 0.0; ///< [Pa]
  double F_n = 0.0;          ///< sum of the pressure [N]
  int evaluations = 0;       ///< evaluations of the elastic-plastic operator in this step
};

/// Row of a history in scenarios whose surfaces may slide on each other.
struct FrictionRecord : StepRecord
{
  double F_friction = 0.0;           ///< sum of the shear between the surfaces [N], >= 0: it resists the sliding
  double share_at_shear_limit = 0.0; ///< share of the contact where the shear is at the limit of the surface
};

/// Row of a history in scenarios in which friction may heat both bodies.
struct HeatedRecord : FrictionRecord
{
  /// Largest temperature of each surface under the contact grid, at the end of the step [deg C]; without heat that of the bulk.
  double max_temperature_lower = 0.0, max_temperature_upper = 0.0;
  double heat_lower = 0.0, heat_upper = 0.0; ///< heat that has entered each body by its surface since the start [J]
  double heat_of_source = 0.0;               ///< heat of the HeatSource since the start [J]
  double heat_of_current = 0.0;              ///< heat of the electric current since the start [J]
  double heat_of_plastic_work = 0.0;         ///< heat of the plastic work of both bodies since the start [J]
};

/// Record of a grid that was enlarged because pressure or plastic strain reached its edge.
struct GridChange
{
  enum class Extent
  {
    contact_columns,
    rows, ///< of all three grids
    lower_columns,
    upper_columns,
    lower_layers,
    upper_layers
  };
  int step = 0; ///< step in which the grid was enlarged
  Extent extent = Extent::contact_columns;
  int before = 0, after = 0; ///< number of cells

  void exchange(Archive& archive);
  bool operator==(const GridChange&) const = default;
};

/// "the grid of the lower body grows from 31 to 44 layers"
[[nodiscard]] std::string text(const GridChange& change);
/// "lower_layers"
[[nodiscard]] const char* extent_name(GridChange::Extent extent);

/// A symmetric tensor in every cell: xx yy zz yz xz xy.
using TensorField = std::array<std::vector<double>, 6>;

/// Fields of one body on its own material grid.
struct BodySnapshot : elastoplastic::EffectFields
{
  VolumeGrid grid;
  bool is_rigid = false;      ///< then it has no fields but its height and those of effects
  double x0 = 0.0, y0 = 0.0;  ///< centre of cell (0, 0) in the body's surface coordinates [m]
  double top = 0.0;           ///< depth of the upper side of layer 0 [m]; not 0 only in a part of the fields
  double contact_x = 0.0;     ///< current position of the contact's centre [m]
  TensorField stress;         ///< due to contact, plastic strain and heat, plus the initial stress [Pa]; empty if rigid
  TensorField plastic_strain; ///< [-]
  std::vector<double> equivalent_plastic_strain; ///< [-]
  std::vector<double> residual_displacement;     ///< of the surface, positive into the body [m]
  /// Current height of a textured surface: texture minus residual displacement and depths of effects, positive out of the body
  /// [m]; empty without a texture.
  std::vector<double> height;
  std::vector<double> temperature; ///< [deg C]; empty without heat
  std::vector<double> inclusion;   ///< number of the inclusion in a cell from 1, 0 for none; empty without inclusions
};

/// Fields of one step.
struct Snapshot : elastoplastic::EffectFields
{
  SurfaceGrid contact;
  double x0 = 0.0, y0 = 0.0;    ///< centre of contact cell (0, 0) relative to the contact's centre [m]
  std::vector<double> pressure; ///< [Pa]
  std::vector<double> gap;      ///< [m], >= 0
  /// Shear on the lower body along x and y [Pa]; a component that never acts is empty.
  std::array<std::vector<double>, 2> shear;
  /// Slip since the start, for surfaces that may stick; empty for others.
  std::array<std::vector<double>, 2> slip; ///< of the upper surface over the lower one, along x and y [m]
  std::vector<double> slip_path;           ///< accumulated slip length [m]
  std::vector<double> friction_heat;       ///< [J/m^2]
  /// For the lower and the upper surface; empty without heat.
  std::array<std::vector<double>, 2> temperature; ///< [deg C]
  std::array<std::vector<double>, 2> heat_flux;   ///< into the body, in the last step [W/m^2]
  BodySnapshot lower, upper;
};

/// The fields of one step, where fields within the bodies are computed on demand, so that they can be written one after the other
/// without having all in memory. Valid until the run takes its next step, or ends.
struct StepFields
{
  /// Stress and strain of a cell.
  struct CellState
  {
    SymTensor stress, plastic_strain;
    double equivalent_plastic_strain = 0.0;
    std::optional<double> temperature = {}; ///< [deg C]; none without heat
  };

  /// Functions that compute the fields; empty for fields that do not exist, such as those of a rigid body.
  struct Within
  {
    std::function<LayeredFields()> equivalent_plastic_strain, temperature;
    std::function<LayeredFields()> plastic_strain, stress; ///< xx yy zz yz xz xy
    std::function<LayeredFields()> inclusion;              ///< number from 1; 0: none
    /// The state of some cells. If the same ones are asked for after each step, they cost little.
    std::function<std::vector<CellState>(std::span<const std::size_t> cells)> cells;
    std::vector<std::function<LayeredFields()>> fatigue{}; ///< the first ones of `fatigue_fields`; empty: none
    bool keeps_stress = true, keeps_von_mises = true;      ///< parts of the stress that a result keeps
  };

  Snapshot surfaces;   ///< all fields but those within the bodies
  Within lower, upper; ///< fields within the bodies, as in `BodySnapshot`
  /// Whether the fields within both bodies are equal (twins in pure rolling), so that computing one body is enough.
  bool are_alike = false;

  [[nodiscard]] Snapshot whole() const;
};

/// How the equivalent strain of inclusions was found, since the start.
struct InclusionTotals
{
  long iterations = 0;           ///< in the box around the inclusions; none where a matrix solves
  double largest_residual = 0.0; ///< at the end of an increment, relative to the stress
};

/// Part of every summary.
struct RunTotals : RunningTotals
{
  int steps = 0;
  long evaluations = 0;
  int split_increments = 0; ///< steps that did not converge in one increment: split, or solved by plain descent
  std::optional<InclusionTotals> inclusions; ///< none without inclusions
  double max_share_at_shear_limit = 0.0;     ///< largest `FrictionRecord::share_at_shear_limit` of the run
  std::array<double, 2> max_temperature{};   ///< largest of the lower and of the upper surface in motion [deg C]
  int most_held_cells = 0;                   ///< `Heating::most_held_cells`
  double share_of_held_cells = 0.0;          ///< `Heating::share_of_held_cells`
  /// (work - dissipation - stored energy) / largest work reached; with the works of expansion and of wear
  double energy_balance_error = 0.0;
  std::vector<GridChange> grid_changes;                 ///< during the run
  std::array<std::optional<FatigueSummary>, 2> fatigue; ///< of the lower and of the upper body
  bool is_mirrored_y = false;                           ///< half of each body was solved
  double memory_bytes = 0.0;                            ///< estimate for the grids at the end
  Snapshot final_state;                                 ///< on the grids at the end
};

/// Callbacks during a step. Empty functions are skipped.
struct Watch
{
  /// Called when a grid grows, before `on_step` reports the step concerned.
  std::function<void(const GridChange&)> on_grid_change{};
  /// Memory up to which grids may grow [bytes].
  double available_memory = std::numeric_limits<double>::infinity();
  /// Asked before each evaluation of a step and while the contact is solved; if the answer is true, the run ends with
  /// `Interrupted`, without a checkpoint of its own.
  std::function<bool()> wants_stop{};
  /// Processes that compute the case together, each with its part of the bodies (docs/theory/ranks.md); nullptr: this process alone. All of
  /// them must do the same at the same time, so the answer of `wants_stop` must be the same.
  std::shared_ptr<const Communicator> ranks{};
};

/// Callbacks of a whole run. Empty functions are skipped; the functions below are called after each step in this order, those of
/// `Watch` during the step.
template <typename Record>
struct Observer : Watch
{
  std::function<void(const Record&, int step_count_estimate)> on_step;
  std::function<bool(const Record&)> wants_snapshot;
  std::function<void(const Record&, const StepFields&)> on_snapshot;
  std::function<bool(const Record&)> wants_checkpoint;
  /// Function that writes a checkpoint to an archive: everything that the rest of the run depends on. It may be called
  /// repeatedly.
  using Checkpoint = std::function<void(Archive&)>;
  std::function<void(const Record&, const Checkpoint&)> on_checkpoint;
};

} // namespace brinell::simulation
