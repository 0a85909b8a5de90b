// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/elastic_contact.hpp"
#include "brinell/elastoplastic/body_view.hpp"
#include "brinell/elastoplastic/effects.hpp"
#include "brinell/elastoplastic/heating.hpp"
#include "brinell/elastoplastic/partial_slip.hpp"
#include "brinell/elastoplastic/placement.hpp"
#include "brinell/elastoplastic/settings.hpp"
#include "brinell/elastoplastic/sliding.hpp"
#include "brinell/elastoplastic/window_error.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

/// One increment of two elastic-plastic bodies in contact: mutually consistent pressure, plastic strain and residual
/// displacement.
namespace brinell::elastoplastic
{

/// Edges of the three grids that pressure or plastic strain has reached.
struct Outgrown
{
  Edges lower, upper;
  /// Pressure in the outermost columns, or rows, of the contact grid; of surfaces that wear in the two outermost ones.
  bool contact_ends = false, contact_sides = false;
  [[nodiscard]] bool any() const
  {
    return contact_ends || contact_sides || lower.ends || lower.sides || lower.bottom || upper.ends || upper.sides ||
           upper.bottom;
  }
};

/// How an increment ended.
struct IncrementReport
{
  bool converged = false;
  Outgrown outgrown{}; ///< edges that the solution reached, if it converged
  bool contact_converged = false;
  double approach = 0.0; ///< imposed, or found for the load imposed [m]
  int evaluations = 0;   ///< evaluations of the elastic-plastic operator of both bodies
  int contact_iterations = 0;
  double yield_error = 0.0;        ///< largest |g(q) - q| over the yield stress
  double displacement_error = 0.0; ///< largest change of residual displacement in the last evaluation [m]
  double gap_error = 0.0;          ///< contact complementarity [m]
  double energy = 0.0;             ///< locked-in, elastic and dissipated energy, which backward Euler minimises [J]
  bool energy_rose = false;        ///< stopped by Strategy::watch_energy
  bool overloaded = false;         ///< friction could not carry the force along the surface in the last evaluation
};

/// Reference lengths of the tolerances [m].
struct Scales
{
  /// For the change of residual displacement: approach at first yield; plans limit it to between 1 % and 100 % of the largest
  /// approach. Friction is left out: it makes bodies yield earlier, but the displacements relevant to the contact stay as large.
  double displacement = 0.0;
  double gap = 0.0; ///< for complementarity: largest approach
};

/// Textures of the surfaces before the first load, on the material grids, as depth into the body [m]; empty: smooth.
struct Textures
{
  std::vector<double> lower, upper;
};

/// How one increment is solved.
struct Strategy
{
  Integration integration = Integration::path;
  int max_evaluations = 60;
  int anderson_depth = 6;
  /// c / (2 mu) in q = s + c d_eps, see Body::begin.
  double stiffness_share = 0.6;
  /// Compute all layers in each evaluation, and give up as soon as the energy of the increment's convex problem,
  /// docs/theory/elastoplastic.md (energy), rises (backward Euler, plain fixed point): the caller then tries a larger stiffness
  /// share, that is shorter steps of the iteration. If false, the stall rule ends an iteration that makes no progress.
  bool watch_energy = false;
  /// Do not commit a solution that has outgrown a grid: `converged` is then false, and the caller has to continue on larger
  /// grids. If false, strain beyond an edge is lost.
  bool stay_within_grids = false;
  /// Whether the surfaces slide on each other in this increment; if false there is no friction.
  bool slides = true;
  std::function<bool()> wants_stop{}; ///< asked before each evaluation and while the contact is solved
  /// Keep the largest shear that the surfaces can carry as it was before the increment, an error of first order in its length, so
  /// that hardening and shear do not raise each other. Implied by `watch_energy`.
  bool keeps_shear_limit = false;
  double duration = 0.0; ///< of the increment [s]; 0: no heat is generated or conducted
  double slid = 0.0;     ///< sliding distance of the undeformed surfaces in the increment [m], >= 0
  bool is_put_down =
      false;            ///< the contact was put down at its place without moving over the bodies: no heat on the way
  bool returns = false; ///< includes the way back of the contact to its start: no heat from a HeatSource
  /// Distances that the contact moves over the lower and the upper body in the increment [m]. Placements follow by whole columns.
  std::array<double, 2> moved{};
  /// Of surfaces that slide everywhere: the share of the full friction at the end of an increment in which friction is
  /// raised before the surfaces move, from -1, the friction of the opposite direction, to 1; none: the surfaces move
  /// under full friction. The work of the shear in increments at rest counts as heat of the next increment that moves.
  std::optional<double> share_at_rest{};
};

/// The history of two bodies, with the grids of its fields.
struct History
{
  SurfaceGrid contact;
  VolumeGrid lower_grid, upper_grid;
  std::vector<BodyState> solved; ///< the lower body, and the upper one unless it is a twin
  Placement placement;
  double approach = 0.0;
  std::vector<double> pressure;
  std::unique_ptr<Interface> interface {
  };                                  ///< none without friction
  std::unique_ptr<Heating> heating{}; ///< none without heat
  std::vector<std::unique_ptr<Effect>> effects{};
};

/// Settings of what happens between the surfaces: friction, direction of sliding, heat, further effects.
struct Sliding
{
  Friction friction{};
  int direction = 1;   ///< in which the upper body slides over the lower one: +1 towards +x, or -1
  bool sticks = false; ///< partial slip: surfaces stick where friction can hold them; `direction` is not used then
  /// Heat of friction; none: heat is not computed. The steady regime is not available where surfaces may stick.
  std::optional<HeatedRun> heat{};
  Effects effects{};
};

/// The solver of the coupled problem of contact and plastic flow, with its buffers.
class CoupledContact
{
public:
  /// @param twin       unless none, the upper body has, and keeps, the grid, material and history of the lower one (or their
  ///                   mirror image): only the lower one is solved.
  /// @param reference  reference distance of the displacement with one periodic axis, see halfspace::SurfaceCompliance [m].
  /// @param symmetry   of both bodies, their surfaces, and all later increments. With symmetry half of each body is solved; it is
  ///                   not available where surfaces may stick.
  CoupledContact(const SurfaceGrid& contact, const VolumeGrid& lower, const VolumeGrid& upper,
                 const constitutive::Material& lower_material, const constitutive::Material& upper_material,
                 const Scales& scales, const Settings& settings, Twin twin = Twin::none, Textures textures = {},
                 double reference = 0.0, const Sliding& sliding = {}, Symmetry symmetry = Symmetry::none);

  [[nodiscard]] BodyView lower() const { return {sides_.front().body, Twin::none, textures_.lower}; }
  [[nodiscard]] BodyView upper() const { return {sides_.back().body, twin_, textures_.upper}; }
  /// Whether backward Euler minimises an energy in an increment, as Strategy::watch_energy requires. Under an imposed mean gap
  /// there is no such energy, because the approach that gives this gap changes with the plastic strain.
  [[nodiscard]] bool has_energy(contact::Drive::Kind drive) const;
  [[nodiscard]] std::span<const double> pressure() const { return pressure_; } ///< on the contact grid [Pa]
  [[nodiscard]] std::span<const double> gap() const { return gap_; }           ///< on the contact grid [m]
  [[nodiscard]] double approach() const { return approach_; }                  ///< of the last increment [m]
  [[nodiscard]] double load() const;                                           ///< sum of the pressure [N]
  [[nodiscard]] double elastic_energy() const; ///< recoverable, of pressure and shear [J]
  /// The shear between the surfaces; nullptr without friction.
  [[nodiscard]] const Interface* interface() const { return interface_.get(); }
  /// The interface of surfaces that slide everywhere; nullptr for others.
  [[nodiscard]] const SlidingInterface* sliding() const;
  /// The interface of surfaces that may stick; nullptr for others.
  [[nodiscard]] const PartialSlip* partial_slip() const;
  /// The heat of friction in both bodies; nullptr where none is computed.
  [[nodiscard]] const Heating* heating() const { return heating_.get(); }
  /// The effects that act between the surfaces.
  [[nodiscard]] std::span<const std::unique_ptr<Effect>> effects() const { return effects_; }
  /// Material lost by both surfaces; nullptr without wear.
  [[nodiscard]] const Wear* wear() const;
  /// Mechanical work of thermal expansion since the start, on the pressure and on the plastic strain [J].
  [[nodiscard]] double expansion_work() const;
  /// Elastic contact stiffness: change of load per change of approach, without yielding [N/m]: contact::stiffness.
  [[nodiscard]] double stiffness() const;
  [[nodiscard]] const SurfaceGrid& grid() const { return compliance_.grid(); }

  /// Sets factors on the yield stress of the cells, see Body::set_softening. An upper twin follows the lower body.
  /// @throws InternalError if factors are given for an upper twin
  void set_softening(std::span<const double> lower, std::span<const double> upper);

  /// Solves one increment from the present state; commits it only if it converged.
  /// @param distance   of the smooth, undeformed surfaces on the contact grid where they touch without load [m], one per cell.
  /// @param placement  of the contact grid on the material grids.
  /// @param along      for surfaces that may stick: forces at the end of the increment, or shifts since the first one. For
  ///                   others: the sign of the shift along x, unless zero, is the direction of sliding.
  /// @throws Interrupted between two evaluations or within a contact solution; GridError. Without convergence, or after an
  /// exception, the state is that before the increment, but for the counts that decide when windows pay.
  [[nodiscard]] IncrementReport advance(std::span<const double> distance, const contact::Drive& drive,
                                        const Placement& placement, const Strategy& strategy,
                                        const contact::TangentialDrive& along = {});

  /// Adds to `out` the depth of a surface under the contact grid, from texture, residual displacement and effects such as wear [m]; zero outside
  /// the grid of the body.
  void add_lower_depth(const Place& place, std::span<double> out) const;
  void add_upper_depth(const Place& place, std::span<double> out) const;
  /// Total stress in all layers of a body [Pa]: from the load, the plastic strain, heat, and the initial stress before the first
  /// load.
  struct Stress
  {
    std::vector<double> deviator; ///< 5 values per cell
    std::vector<double> trace;    ///< [cell]
  };
  /// @throws InputError if the body is rigid
  [[nodiscard]] Stress lower_stress(const Place& place);
  [[nodiscard]] Stress upper_stress(const Place& place);
  /// State of one cell, in the axes of its side.
  struct CellState
  {
    Body::CellStress stress;
    Deviator plastic_strain;
    double equivalent = 0.0;                ///< accumulated equivalent plastic strain
    std::optional<double> temperature = {}; ///< [deg C]; none without heat
  };
  /// The states of some cells of a body, as in the fields up to rounding; asked for in each increment, they cost little.
  /// @throws InputError if the body is rigid
  [[nodiscard]] std::vector<CellState> lower_cells(const Place& place, std::span<const std::size_t> cells)
  {
    return states(0, sides_.front().body, place, cells);
  }
  [[nodiscard]] std::vector<CellState> upper_cells(const Place& place, std::span<const std::size_t> cells)
  {
    return states(1, sides_.back().body, place, cells);
  }
  /// Temperature in all cells of a body [deg C]; empty without heat, or if the body is rigid.
  [[nodiscard]] std::vector<double> lower_temperature() const { return temperature(0, lower()); }
  [[nodiscard]] std::vector<double> upper_temperature() const { return temperature(1, upper()); }
  /// Whether pressure acts on the outermost cells of the contact grid.
  [[nodiscard]] bool reaches_edge() const;
  /// Moves out the history, to be continued on other grids; this object must not be used afterwards.
  [[nodiscard]] History take_history() &&;
  /// Continues a history from smaller grids that have the same centres as these grids.
  /// @throws InternalError if the centres differ
  void continue_from(History history);

  /// Everything that the next increment depends on.
  void exchange(Archive& archive);

private:
  /// A body that is solved, with the load that the contact puts on it.
  struct Side
  {
    Body body;
    Place Placement::*place;
    std::vector<double> pressure{};             ///< of the trial, on the grid of the body [Pa]
    bool leaves_grid = false;                   ///< pressure of the trial lies beyond an end of the body's grid
    double shear_sign = 1.0;                    ///< sign of the interface's shear on this body
    std::array<std::vector<double>, 2> shear{}; ///< of the trial, along x and y [Pa]; empty if there never is any

    [[nodiscard]] halfspace::SurfaceLoad load() const
    {
      return {.pressure = pressure, .shear_x = shear[0], .shear_y = shear[1]};
    }
  };

  void solve_contact(std::span<const double> distance, const contact::Drive& drive, const Placement& placement,
                     const Strategy& strategy, bool closing, IncrementReport& report);
  [[nodiscard]] IncrementReport iterate(std::span<const double> distance, const contact::Drive& drive,
                                        const Placement& placement, const Strategy& strategy);
  [[nodiscard]] bool has_unknowns() const;
  [[nodiscard]] std::ptrdiff_t windows() const;
  template <typename Work>
  void on_sides(const Work& work);
  [[nodiscard]] double integrate(Integration integration);
  [[nodiscard]] bool update(IncrementReport& report);
  [[nodiscard]] bool is_within(double factor, const IncrementReport& report) const;
  [[nodiscard]] double energy_of_trial(const contact::Drive& drive, double approach);
  void solve_frictional_contact(const contact::Drive& drive, const Placement& placement, const Strategy& strategy,
                                bool closing, IncrementReport& report);
  void press(const contact::Drive& drive, const Strategy& strategy, IncrementReport& report);
  [[nodiscard]] bool renews_law(IncrementReport& report);
  [[nodiscard]] double energy(double approach) const;
  [[nodiscard]] double pressure_energy() const;
  [[nodiscard]] double work_of_shear(const Side& side) const;
  [[nodiscard]] std::vector<double> shear_limit(const Placement& placement,
                                                const std::array<double, 2>& direction) const;
  template <typename Use>
  void with_bodies(const Placement& placement, const Use& use) const;
  [[nodiscard]] std::array<double, 2> columns_moved(const Placement& placement) const;
  void begin_friction(const Placement& placement, const Strategy& strategy, const contact::TangentialDrive& along);
  [[nodiscard]] Interface::Change follow(const Placement& placement);
  [[nodiscard]] Interaction interaction() const;
  void begin_effects();
  [[nodiscard]] double evaluate_effects();
  void find_compliance();
  [[nodiscard]] double largest_depth_of_effects() const;
  void begin_heating(const Placement& placement, const Strategy& strategy);
  [[nodiscard]] std::array<std::vector<double>, 2> works_that_heat() const;
  void find_heat_of_increment(const Strategy& strategy, const std::array<std::vector<double>, 2>& works);
  void settle_heating(const std::array<std::vector<double>, 2>& works);
  [[nodiscard]] double follow_heat(Heating::Sharing sharing);
  [[nodiscard]] std::vector<double> temperature(std::size_t side, const BodyView& view) const;
  void add_thermal_stress(std::size_t side, const BodyView& view, Stress& stress) const;
  void settle_friction(const Placement& placement);
  [[nodiscard]] double tolerance_of_gap() const;
  void recall_friction();
  [[nodiscard]] bool carries_off(const Placement& placement) const;
  [[nodiscard]] Outgrown outgrown() const;
  [[nodiscard]] std::pair<bool, bool> presses_near_edges(int cells) const;
  void spread(const Placement& placement);
  void spread_shear(const Place& place, const SurfaceGrid& body, double sign,
                    std::array<std::vector<double>, 2>& out) const;
  [[nodiscard]] Stress stress(std::size_t side, Body& solved, const Place& place) const;
  struct TurnedLoad;
  [[nodiscard]] TurnedLoad load_on_solved(std::size_t side, const Place& place) const;
  [[nodiscard]] std::vector<CellState> states(std::size_t side, Body& solved, const Place& place,
                                              std::span<const std::size_t> cells) const;
  void add_heat(std::size_t side, const BodyView& view, std::span<const std::size_t> cells,
                std::vector<CellState>& states) const;

  halfspace::SurfaceCompliance compliance_;
  contact::ElasticContact contact_;
  std::vector<Side> sides_; ///< the lower body, and the upper one unless it is a twin
  Textures textures_;
  Scales scales_;
  Settings settings_;
  Twin twin_;
  Symmetry symmetry_;
  std::unique_ptr<Interface> interface_; ///< none without friction
  std::unique_ptr<Heating> heating_;     ///< none without heat
  std::vector<std::unique_ptr<Effect>> effects_;
  std::vector<double> compliance_of_effects_; ///< change of the gap per pressure by all effects [m/Pa]; empty: none
  double slid_ = 0.0;                         ///< Strategy::slid of the current increment, 0 if nothing slides [m]
  std::array<double, 2> driven_along_{};      ///< Interface::direction of the current increment
  WindowError window_error_;
  Placement placement_;
  double approach_ = 0.0;
  std::vector<double> pressure_, gap_;
  std::vector<double>
      distance_; ///< distance of the surfaces with texture and residual displacement, at zero approach [m]
};

} // namespace brinell::elastoplastic
