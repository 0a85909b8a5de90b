// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/material.hpp"
#include "brinell/elastoplastic/increment.hpp"
#include "brinell/foundation/archive.hpp"
#include "brinell/foundation/error.hpp"
#include "brinell/foundation/grid.hpp"
#include "brinell/simulation/shape.hpp"
#include "brinell/simulation/texture.hpp"

#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Step loops: motion, history, energies. What all scenarios share. SI units.
namespace brinell::simulation
{

/// A body in the general scenarios.
struct ShapedBody
{
  Shape shape;
  constitutive::Material material;
  Texture texture{};
  bool operator==(const ShapedBody&) const = default;
};

/// What lies beyond the grids: docs/theory/half-space.md (copies). Along a periodic axis the grids are the cell of
/// periodicity, and never grow.
struct Domain
{
  struct Axis
  {
    Boundary boundary = Boundary::open;
    double size = 1.0; ///< period [m], > 0
    int cells = 0;     ///< in a period; 0: as many as the spacing makes
    [[nodiscard]] bool is_periodic() const { return boundary == Boundary::periodic; }
    bool operator==(const Axis&) const = default;
  };
  Axis x, y;
  double layer = 0.0;     ///< thickness of the layers unless there is a spacing [m]; 0: half the smaller cell
  double reference = 0.0; ///< with one periodic axis: see halfspace::SurfaceCompliance [m]; 0: reference_distance

  /// Whether the bodies have no ends.
  [[nodiscard]] bool is_periodic() const { return x.is_periodic() && y.is_periodic(); }
  bool operator==(const Domain&) const = default;
};

/// What one key of a case says does not go with the rest of it. The text names the key, its value and what is allowed.
class KeyError : public InputError
{
public:
  KeyError(std::string key, const std::string& what) : InputError(what), key_(std::move(key)) {}
  [[nodiscard]] const std::string& key() const { return key_; } ///< "grid.cells"

private:
  std::string key_;
};

/// Whether a grid is one row that repeats along y, so that nothing varies along it: a plane problem.
[[nodiscard]] inline bool is_plane(const SurfaceGrid& grid)
{
  return grid.is_periodic_y() && grid.ny == 1;
}

/// Why these bodies do not touch in a way that can be computed in that domain; empty if they do.
[[nodiscard]] std::optional<std::string> reason_against_contact(const ShapedBody& lower, const ShapedBody& upper,
                                                                const Domain& domain);

/// Why a texture does not go on over the end of a period; empty if it does. A dent, or a map that does not repeat, has to lie
/// within one period: then it is there again in each of them.
[[nodiscard]] std::optional<std::string> reason_against_texture(const Texture& texture, const Domain& domain);

/// The distance from a line load at which its displacement is counted as zero: as given; or 2 R/e of two cylinders, with which
/// their approach is Green's (2005), of the axis of a cylinder of the radius R and a rigid flat (Johnson 1985, section 5.6);
/// or the period. 0 unless just one axis is periodic [m].
[[nodiscard]] double reference_distance(const Shape& lower, const Shape& upper, const Domain& domain);

/// Length over which two bodies press as one along y: that of the shorter roller, or the period; infinite without either [m].
[[nodiscard]] double line_length(const Shape& lower, const Shape& upper, const Domain& domain);

/// What the cases of all scenarios have besides their bodies: cells, solver, and what is between the surfaces.
struct Numerics
{
  elastoplastic::Friction friction; ///< where the surfaces slide on each other
  elastoplastic::WearLaw wear;      ///< what they lose there
  elastoplastic::HeatSettings heat; ///< what becomes of its heat, in bodies that have thermal constants
  Domain domain;
  std::optional<std::array<double, 3>> spacing; ///< cell sizes dx, dy, dz [m]
  double resolution = 8.0;                      ///< cells per contact radius along x if no spacing is given
  double extent = 1.0; ///< factor on the automatic extent of the grids around contact and plastic zone, > 0
  elastoplastic::Settings solver;
};

/// What a run will cost and where its cells are; computed without running.
struct Plan
{
  SurfaceGrid contact;                                  ///< grid of the contact, carried along with it
  VolumeGrid lower, upper;                              ///< material grids, wide enough for the whole track
  int steps = 0;                                        ///< estimate
  elastoplastic::Twin twin = elastoplastic::Twin::none; ///< other than none: one body is solved
  Symmetry symmetry = Symmetry::none;                   ///< other than none: half of each body is solved
  double contact_share = 1.0;                           ///< of a period that touches, estimate; 1 where none tells
  double memory_bytes = 0.0;
  elastoplastic::Scales scales; ///< of the tolerances
  double first_yield = 0.0;     ///< approach at which a body yields, with friction, not below 1 % of the largest [m]
  double reference = 0.0;       ///< of the displacement with one periodic axis [m]
};

/// What the cells had to resolve so far: from it follows how well they do (simulation/quality.hpp).
struct Coverage
{
  int contact_columns = 0, contact_rows = 0; ///< over which the contact stretched in one step, at most
  int plastic_layers = 0;                    ///< of the plastic zone, in the body that has yielded more

  void exchange(Archive& archive);
};

/// What a run has come to since its start: every row of a history tells it, and every summary of the last row.
struct RunningTotals
{
  double work = 0.0;                                       ///< of the drive since the start [J]
  double dissipation_lower = 0.0, dissipation_upper = 0.0; ///< plastic work since the start [J]
  double dissipation_friction = 0.0; ///< heat of friction between the surfaces since the start [J]
  double work_of_expansion = 0.0;    ///< that the bodies have done as heat made them swell, since the start [J]
  double energy_residual = 0.0;      ///< elastic energy locked in by the plastic strain of both bodies [J]
  double energy_elastic = 0.0;       ///< recoverable energy of pressure and shear [J]
  double max_residual_lower = 0.0, max_residual_upper = 0.0; ///< largest depth of the residual displacement [m]
  double max_equivalent_plastic_strain = 0.0;
  /// Of the lower and the upper surface, since the start; where nothing wears they are zero.
  double worn_volume_lower = 0.0, worn_volume_upper = 0.0;       ///< [m^3]
  double max_worn_depth_lower = 0.0, max_worn_depth_upper = 0.0; ///< [m]
  double max_wear_step = 0.0; ///< largest depth that both have lost together in one increment [m]
  double work_of_wear = 0.0;  ///< of the pressure on what was worn, since the start [J]
  Coverage coverage;
};

/// What every row of a history tells. Files have its numbers by the names and units in simulation/columns.hpp.
struct StepRecord : RunningTotals
{
  int step = 0;              ///< counts from 0: the row of the history
  int pass = 0;              ///< counts from 1
  double contact_area = 0.0; ///< [m^2]
  double max_pressure = 0.0; ///< [Pa]
  double F_n = 0.0;          ///< sum of the pressure [N]
  int evaluations = 0;       ///< evaluations of the elastic-plastic operator in this step
};

/// What the rows of scenarios tell in which the surfaces may slide on each other.
struct FrictionRecord : StepRecord
{
  double F_friction = 0.0;           ///< sum of the shear between the surfaces [N], >= 0: it resists the sliding
  double share_at_shear_limit = 0.0; ///< of the contact: there the surface carries no more shear
};

/// What the rows of scenarios tell in which the heat of friction may warm both bodies.
struct HeatedRecord : FrictionRecord
{
  /// Of each surface under the contact grid, at the end of the step [deg C]; without heat that of the bulk.
  double max_temperature_lower = 0.0, max_temperature_upper = 0.0;
  double heat_lower = 0.0, heat_upper = 0.0; ///< that has come into each body since the start [J]
  double heat_of_plastic_work = 0.0;         ///< that has arisen in both bodies since the start [J]
};

/// A grid was enlarged, because pressure or plastic strain had reached its edge.
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
  int step = 0; ///< that needed it
  Extent extent = Extent::contact_columns;
  int before = 0, after = 0; ///< cells

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
struct BodySnapshot
{
  VolumeGrid grid;
  double x0 = 0.0, y0 = 0.0;  ///< centre of cell (0, 0) in the body's surface coordinates [m]
  double contact_x = 0.0;     ///< where the contact centre is now [m]
  TensorField stress;         ///< of contact, plastic strain, heat and before the first load [Pa]; empty if rigid
  TensorField plastic_strain; ///< [-]
  std::vector<double> equivalent_plastic_strain; ///< [-]
  std::vector<double> residual_displacement;     ///< surface, into the body positive [m]
  std::vector<double> worn_depth;                ///< that the surface has lost since the start [m]; empty without wear
  /// Of a surface with a texture as it is now: texture less residual displacement and worn depth, out of the body positive
  /// [m]; empty of others.
  std::vector<double> height;
  std::vector<double> temperature; ///< [deg C]; empty without heat
};

/// Fields of one step.
struct Snapshot
{
  SurfaceGrid contact;
  double x0 = 0.0, y0 = 0.0;    ///< centre of contact cell (0, 0) from the contact's own centre [m]
  std::vector<double> pressure; ///< [Pa]
  std::vector<double> gap;      ///< [m], >= 0
  /// On the lower body along x and y [Pa]; empty where there never is one.
  std::array<std::vector<double>, 2> shear;
  /// Of surfaces that may stick, since the start; empty of others.
  std::array<std::vector<double>, 2> slip; ///< of the upper surface over the lower one, along x and y [m]
  std::vector<double> slip_path;           ///< length of the way slipped [m]
  std::vector<double> friction_heat;       ///< [J/m^2]
  /// Of the lower and the upper surface; empty without heat.
  std::array<std::vector<double>, 2> temperature; ///< [deg C]
  std::array<std::vector<double>, 2> heat_flux;   ///< into the body, in the last step [W/m^2]
  BodySnapshot lower, upper;
};

/// The fields of one step, of which those within the bodies are computed when they are asked for: who writes one after the
/// other never has them all in memory. Lasts until the run takes its next step, or ends.
struct StepFields
{
  /// Functions that are empty stand for fields that there are not, as those of a rigid body.
  struct Within
  {
    std::function<std::vector<double>()> equivalent_plastic_strain, temperature;
    std::function<TensorField()> plastic_strain, stress;
  };

  Snapshot surfaces;   ///< all fields but those within the bodies
  Within lower, upper; ///< the others, as in `BodySnapshot`
  /// Whether both bodies have the same fields within: twins in pure rolling. Then those of one need be computed.
  bool are_alike = false;

  [[nodiscard]] Snapshot whole() const;
};

/// What every summary tells.
struct RunTotals : RunningTotals
{
  int steps = 0;
  long evaluations = 0;
  int split_increments = 0;                ///< steps that did not converge whole: split, or solved by plain descent
  double max_share_at_shear_limit = 0.0;   ///< largest `FrictionRecord::share_at_shear_limit` of the run
  std::array<double, 2> max_temperature{}; ///< largest of the lower and of the upper surface in the run [deg C]
  int most_held_cells = 0;                 ///< `Heating::most_held_cells`
  /// (work - dissipation - stored energy) / largest work reached; with the works of expansion and of wear
  double energy_balance_error = 0.0;
  std::vector<GridChange> grid_changes; ///< in the course of the run
  Symmetry symmetry = Symmetry::none;   ///< by which half of each body was solved
  double memory_bytes = 0.0;            ///< of the grids at the end, estimate
  Snapshot final_state;                 ///< has the grids of the end
};

/// The messages to a caller, and the questions, in the midst of a step. Empty functions are skipped.
struct Watch
{
  /// A grid grows: before the step that needs it is reported.
  std::function<void(const GridChange&)> on_grid_change{};
  /// Up to which grids may grow [bytes].
  double available_memory = std::numeric_limits<double>::infinity();
  /// Asked before each evaluation of a step and while the contact is solved; if the answer is true, the run ends with
  /// `Interrupted`, without a checkpoint of its own.
  std::function<bool()> wants_stop{};
};

/// How a caller watches a whole run. Empty functions are skipped; after each step the functions below are called in this
/// order, those of `Watch` in the midst of the step.
template <typename Record>
struct Observer : Watch
{
  std::function<void(const Record&, int step_count_estimate)> on_step;
  std::function<bool(const Record&)> wants_snapshot;
  std::function<void(const Record&, const StepFields&)> on_snapshot;
  std::function<bool(const Record&)> wants_checkpoint;
  /// Shows everything that the rest of the run depends on to an archive, as often as it is called: to be given to `run` later.
  using Checkpoint = std::function<void(Archive&)>;
  std::function<void(const Record&, const Checkpoint&)> on_checkpoint;
};

} // namespace brinell::simulation
