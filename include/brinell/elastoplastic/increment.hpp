// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/elastic_contact.hpp"
#include "brinell/elastoplastic/body_view.hpp"
#include "brinell/elastoplastic/heating.hpp"
#include "brinell/elastoplastic/partial_slip.hpp"
#include "brinell/elastoplastic/placement.hpp"
#include "brinell/elastoplastic/settings.hpp"
#include "brinell/elastoplastic/sliding.hpp"
#include "brinell/elastoplastic/wear.hpp"

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

/// One increment of two elastic-plastic bodies in contact: pressure, plastic strain and residual displacement that agree.
namespace brinell::elastoplastic
{

/// Edges of the three grids that pressure or plastic strain has reached.
struct Outgrown
{
  Edges lower, upper;
  bool contact_ends = false, contact_sides = false; ///< pressure in the outermost columns or rows of the contact grid
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
  Outgrown outgrown{}; ///< by the solution, if it converged
  bool contact_converged = false;
  double approach = 0.0; ///< imposed, or found for the load imposed [m]
  int evaluations = 0;   ///< of the elastic-plastic operator of both bodies
  int contact_iterations = 0;
  double yield_error = 0.0;        ///< largest |g(q) - q| over the yield stress
  double displacement_error = 0.0; ///< largest change of residual displacement in the last evaluation [m]
  double gap_error = 0.0;          ///< contact complementarity [m]
  double energy = 0.0;             ///< locked-in, elastic and dissipated energy: what backward Euler minimises [J]
  bool energy_rose = false;        ///< stopped by Strategy::watch_energy
  bool overloaded = false;         ///< friction could not carry the force along the surface in the last evaluation
};

/// Reference lengths of the tolerances [m].
struct Scales
{
  /// For the change of residual displacement: approach at first yield, in plans between 1 % and all of the largest approach.
  /// Without friction: with it bodies yield sooner, but what matters to the contact is no smaller for that.
  double displacement = 0.0;
  double gap = 0.0; ///< for complementarity: largest approach
};

/// Heights that the surfaces had before the first load, on the material grids, as depth into the body [m]; empty: smooth.
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
  /// share, that is shorter steps of the iteration. Otherwise the stall rule ends an iteration that runs in circles.
  bool watch_energy = false;
  /// Do not commit a solution that has outgrown a grid: `converged` then is false, and the caller is to continue on larger
  /// grids. Without this, strain beyond an edge is lost.
  bool stay_within_grids = false;
  /// Whether the surfaces slide on each other in this increment: without it there is no friction.
  bool slides = true;
  std::function<bool()> wants_stop{}; ///< asked before each evaluation and while the contact is solved
  double duration = 0.0;              ///< of the increment [s]; 0: nothing happens to the heat
  double slid = 0.0;                  ///< by which the undeformed surfaces slide on each other in it [m], >= 0
  bool is_put_down = false;           ///< the contact has not moved over the bodies to where it is: no heat on the way
  /// By which the contact moves over the lower and the upper body in it [m]. The placements follow that by whole columns.
  std::array<double, 2> moved{};
};

/// What two bodies have been through, and the grids on which it is written.
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
  std::unique_ptr<Wear> wear{};       ///< none without wear
};

/// Friction and wear, and what the surfaces do along each other.
struct Sliding
{
  Friction friction{};
  int direction = 1;   ///< in which the upper body slides over the lower one: +1 towards +x, or -1
  bool sticks = false; ///< where friction can hold the surfaces they stick: there is no direction then
  /// Of surfaces that slide everywhere: what becomes of the heat of friction; none: nothing.
  std::optional<HeatedRun> heat{};
  WearLaw wear{};
};

/// The coupled solver, with its buffers.
class CoupledContact
{
public:
  /// @param twin  unless none, the upper body has the grid, material and history of the lower one (or their mirror image)
  ///              and keeps it: only the lower one is solved.
  /// @param reference  of the displacement with one periodic axis, see halfspace::SurfaceCompliance [m].
  /// @param symmetry   of both bodies, their surfaces, and all that will be asked of them. Half of each body is solved; not
  ///                   where surfaces may stick.
  CoupledContact(const SurfaceGrid& contact, const VolumeGrid& lower, const VolumeGrid& upper,
                 const constitutive::Material& lower_material, const constitutive::Material& upper_material,
                 const Scales& scales, const Settings& settings, Twin twin = Twin::none, Textures textures = {},
                 double reference = 0.0, const Sliding& sliding = {}, Symmetry symmetry = Symmetry::none);

  [[nodiscard]] BodyView lower() const { return {sides_.front().body, Twin::none, textures_.lower}; }
  [[nodiscard]] BodyView upper() const { return {sides_.back().body, twin_, textures_.upper}; }
  /// Whether backward Euler minimises an energy in an increment, so that Strategy::watch_energy has something to watch. A mean
  /// gap has none: the approach that it asks for changes with the plastic strain.
  [[nodiscard]] bool has_energy(contact::Drive::Kind drive) const;
  [[nodiscard]] std::span<const double> pressure() const { return pressure_; } ///< on the contact grid [Pa]
  [[nodiscard]] std::span<const double> gap() const { return gap_; }           ///< on the contact grid [m]
  [[nodiscard]] double approach() const { return approach_; }                  ///< of the last increment [m]
  [[nodiscard]] double load() const;                                           ///< sum of the pressure [N]
  [[nodiscard]] double elastic_energy() const; ///< recoverable, of pressure and shear [J]
  /// The shear between the surfaces; nullptr without friction.
  [[nodiscard]] const Interface* interface() const { return interface_.get(); }
  /// The same of surfaces that slide everywhere; nullptr of others.
  [[nodiscard]] const SlidingInterface* sliding() const;
  /// The same of surfaces that may stick; nullptr of others.
  [[nodiscard]] const PartialSlip* partial_slip() const;
  /// The heat of friction in both bodies; nullptr where none is computed.
  [[nodiscard]] const Heating* heating() const { return heating_.get(); }
  /// What both surfaces have lost; nullptr without wear.
  [[nodiscard]] const Wear* wear() const { return wear_.get(); }
  /// What heat has done mechanically since the start, on the pressure and on the plastic strain [J].
  [[nodiscard]] double expansion_work() const;
  /// Load per approach with which the bodies would begin to part or to approach further without yielding [N/m]:
  /// contact::stiffness.
  [[nodiscard]] double stiffness() const;
  [[nodiscard]] const SurfaceGrid& grid() const { return compliance_.grid(); }

  /// Factors on the yield stress of the cells, see Body::set_softening. The upper one of twins follows the lower one.
  /// @throws InternalError for factors of an upper twin
  void set_softening(std::span<const double> lower, std::span<const double> upper);

  /// Solves one increment from the present state; commits it only if it converged.
  /// @param distance   of the smooth, undeformed surfaces on the contact grid where they touch without load [m], one per cell.
  /// @param placement  of the contact grid on the material grids.
  /// @param along      of surfaces that may stick: forces at the end of the increment, or shifts since the first one; of
  ///                   others the sign of the shift along x is their direction, unless it is zero.
  /// @throws Interrupted between two evaluations or within a contact solution; GridError. Without convergence, or after these,
  /// everything is as it was before the increment.
  [[nodiscard]] IncrementReport advance(std::span<const double> distance, const contact::Drive& drive,
                                        const Placement& placement, const Strategy& strategy,
                                        const contact::TangentialDrive& along = {});

  /// Depth of the surfaces under the contact grid, each with texture, residual displacement and what is worn off [m]; zero outside
  /// their grids.
  /// They are added to `out`.
  void add_lower_depth(const Place& place, std::span<double> out) const;
  void add_upper_depth(const Place& place, std::span<double> out) const;
  /// Stress in all layers of a body [Pa]: of the contact's pressure, of the plastic strain, and that from before the first load.
  struct Stress
  {
    std::vector<double> deviator; ///< 5 values per cell
    std::vector<double> trace;    ///< [cell]
  };
  /// @throws InputError if the body is rigid
  [[nodiscard]] Stress lower_stress(const Place& place);
  [[nodiscard]] Stress upper_stress(const Place& place);
  /// Temperature of all cells of a body [deg C]; empty without heat, or if the body is rigid.
  [[nodiscard]] std::vector<double> lower_temperature() const { return temperature(0, lower()); }
  [[nodiscard]] std::vector<double> upper_temperature() const { return temperature(1, upper()); }
  /// Whether pressure acts on the outermost cells of the contact grid.
  [[nodiscard]] bool reaches_edge() const;
  /// The history, to be continued on other grids; what is left of this object is not to be used.
  [[nodiscard]] History take_history() &&;
  /// Continues a history from smaller grids whose middles are those of these grids.
  /// @throws InternalError if they do not lie so
  void continue_from(History history);

  /// Everything that the next increment depends on.
  void exchange(Archive& archive);

private:
  /// A body that is solved, and what the contact does to it.
  struct Side
  {
    Body body;
    Place Placement::*place;
    std::vector<double> pressure{};             ///< of the trial, on the grid of the body [Pa]
    bool leaves_grid = false;                   ///< pressure of the trial lies beyond an end of the body's grid
    double shear_sign = 1.0;                    ///< of the shear on this body
    std::array<std::vector<double>, 2> shear{}; ///< of the trial, along x and y [Pa]; empty if there never is one

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
  void begin_friction(const Placement& placement, const Strategy& strategy, const contact::TangentialDrive& along);
  [[nodiscard]] Interface::Change follow(const Placement& placement);
  void begin_wear(const Strategy& strategy);
  [[nodiscard]] double follow_wear();
  void begin_heating(const Placement& placement, const Strategy& strategy);
  void settle_heating(const Strategy& strategy);
  [[nodiscard]] double follow_heat(Heating::Sharing sharing);
  [[nodiscard]] std::vector<double> temperature(std::size_t side, const BodyView& view) const;
  void add_thermal_stress(std::size_t side, const BodyView& view, Stress& stress) const;
  void settle_friction(const Placement& placement);
  [[nodiscard]] double tolerance_of_gap() const;
  void recall_friction();
  [[nodiscard]] bool carries_off(const Placement& placement) const;
  [[nodiscard]] Outgrown outgrown() const;
  [[nodiscard]] std::pair<bool, bool> pressed_edges() const;
  void spread(const Placement& placement);
  void spread_shear(const Place& place, const SurfaceGrid& body, double sign,
                    std::array<std::vector<double>, 2>& out) const;
  [[nodiscard]] Stress stress(std::size_t side, Body& solved, const Place& place) const;

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
  std::unique_ptr<Wear> wear_;           ///< none without wear
  double slid_ = 0.0;                    ///< Strategy::slid of the increment at hand [m]
  Placement placement_;
  double approach_ = 0.0;
  std::vector<double> pressure_, gap_;
  std::vector<double> distance_; ///< of the surfaces with texture and residual displacement at no approach
};

} // namespace brinell::elastoplastic
