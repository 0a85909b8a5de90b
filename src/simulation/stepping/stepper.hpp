// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"
#include "lattice.hpp"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace brinell::simulation
{

/// The state to be solved for: position of the contact, drive and time.
struct Target
{
  Centre centre;
  contact::Drive drive;
  bool slides = true;               ///< whether the surfaces slide on each other; if not there is no friction
  contact::TangentialDrive along{}; ///< see Motion::along
  double time = 0.0;                ///< since the start [s]; without a change of time heat does not change
  double slid = 0.0;                ///< accumulated sliding distance of the undeformed surfaces since the start [m]
  bool is_put_down = false;         ///< see Motion::is_put_down
  bool returns = false;             ///< see Motion::returns
  /// Velocities along x with which a steady flux passes the lower and the upper body although the contact does not move over
  /// them: those of the motion before which they are pressed together and after which they part [m/s].
  std::optional<std::array<double, 2>> passing{};
  std::optional<double> share_at_rest{}; ///< see Motion::share_at_rest
  double step = 0.0;                     ///< see Motion::step; set by `Stepper::advance`
};

/// The state of both bodies, and its solution step by step, for all scenarios. The grids grow when pressure or plastic strain
/// reaches their edges.
class Stepper
{
public:
  struct Setup
  {
    const constitutive::Material& lower;
    const constitutive::Material& upper;
    /// Distance of the smooth, undeformed surfaces at (x, y) from the contact's centre [m].
    std::function<double(double x, double y)> distance;
    const elastoplastic::Settings& solver;
    Centre start; ///< a moment when the columns of both bodies coincide
    Texture lower_texture{}, upper_texture{};
    std::array<Texture, 2> films{}; ///< see `ShapedBody::film`
    std::array<std::vector<BodyInclusion>, 2> inclusions{};
    Watch watch{};
    elastoplastic::Sliding sliding{};
    std::array<bool, 2> follows_stress{}; ///< whether the stress in all cells of a body is read after each step
    Centre beside{}; ///< y of the contact's centre on each body, which is constant; used to read textures
  };
  Stepper(const Plan& plan, Setup setup);

  /// Advances from the present state, `way(0)`, to `way(1)`. A piece of the way that does not converge is halved, as long as
  /// it is longer than `finest`. A piece of the finest length that does not converge is solved by the plain fixed point of the
  /// convex problem (backward Euler), whose energy is watched. If a solution outgrows a grid, the grid is enlarged and the piece
  /// is solved again.
  /// Where plastic surfaces begin to slide, or reverse, under pressure, friction is raised at `way(0)` first, in
  /// increments at rest:
  /// docs/theory/simulation.md (friction).
  /// @param where     description of the step for messages.
  /// @param at_onset  called when full friction acts and the surfaces have not moved yet; not called in other steps.
  /// @returns number of evaluations.
  /// @throws ConvergenceError; GridError if larger grids do not fit into the memory
  int advance(const std::function<Target(double)>& way, double finest, const std::string& where,
              const std::function<void()>& at_onset = {});

  /// Distances of the surfaces under the contact grid, with texture and residual displacement, at zero approach [m].
  struct Distances
  {
    double smallest = 0.0, mean = 0.0;
  };
  [[nodiscard]] Distances distances(const Centre& centre);
  /// Position of contact column 0 relative to the contact's centre [m].
  [[nodiscard]] double left_of(const Centre& centre) const { return lattice_.frame(centre).x0; }
  /// Fills the columns that all scenarios have.
  void fill(StepRecord& record) const;
  void fill(FrictionRecord& record) const;
  void fill(HeatedRecord& record) const;
  /// Depth of each surface under the contact grid [m].
  struct Depths
  {
    std::vector<double> lower, upper;
  };
  [[nodiscard]] const Depths& depths(const Centre& centre);
  /// Depths plus the elastic normal displacement under the shear of the last step: the surfaces on which the pressure acts. For
  /// surfaces that may stick all of it is added to the lower surface, which is equivalent, as the contact moves equally on both.
  [[nodiscard]] const Depths& loaded_depths(const Centre& centre);
  /// Work of the shear on the deformation of both surfaces in the last step [J].
  [[nodiscard]] double shear_work() const { return shear_work_; }
  /// Force along x of the shear with which the surfaces slid at the beginning of the last step, on the lower body [N].
  [[nodiscard]] double shear_force_at_start() const { return shear_force_at_start_.value_or(0.0); }
  /// Smallest (at most 0) and largest (at least 0) residual displacement of the lower body under the contact grid [m].
  [[nodiscard]] std::pair<double, double> residual_range(const Centre& centre) const;
  [[nodiscard]] const elastoplastic::CoupledContact& pair() const { return *pair_; }
  [[nodiscard]] int split_increments() const { return split_increments_; }
  /// Fields of the present state; must not be used after the next step.
  [[nodiscard]] StepFields fields(const Centre& centre) const;
  /// State for those that follow all cells from step to step; must not be used after the next step.
  struct Present
  {
    elastoplastic::CoupledContact& pair;
    elastoplastic::Placement placement;
    std::array<double, 2> origins; ///< surface coordinate of column 0 of the grid of each body [m]
    std::array<double, 2> centres; ///< of the contact on each body [m]
  };
  [[nodiscard]] Present present(const Centre& centre);
  /// Fills the part of a summary that concerns the solution.
  void fill(RunTotals& totals) const;

  void exchange(Archive& archive);

private:
  [[nodiscard]] bool has_inclusions() const { return !setup_.inclusions[0].empty() || !setup_.inclusions[1].empty(); }
  [[nodiscard]] int onset_increments(double from) const;
  void raise_friction(const Target& start, const contact::TangentialDrive& along, double from, int increments);
  void bisect(const std::function<Target(double)>& path, double begin, double end, double finest);
  bool attempt(const Target& target);
  [[nodiscard]] elastoplastic::IncrementReport solved(const Target& target, const elastoplastic::Strategy& strategy);
  void descend(const Target& target);
  [[nodiscard]] std::string advice_on_free_flow() const;
  void place(const Frame& frame);
  [[nodiscard]] std::unique_ptr<elastoplastic::CoupledContact> make_pair() const;
  void grow(const elastoplastic::Outgrown& outgrown);
  [[nodiscard]] double memory_of(const Plan& plan) const;
  void announce(const Plan& larger);
  void move_to(const Plan& larger);

  Setup setup_;
  Plan plan_; ///< with the current grids
  Lattice lattice_;
  std::shared_ptr<const elastoplastic::Device> device_; ///< nullptr: the processor
  std::unique_ptr<elastoplastic::CoupledContact> pair_;
  std::vector<double> distance_;
  double distance_x0_ = 0.0; ///< Frame::x0 for which `distance_` holds
  Depths depths_;
  std::string where_;
  int evaluations_ = 0;
  int steps_ = 0; ///< number of finished steps
  int split_increments_ = 0;
  InclusionTotals inclusions_{};
  double shear_work_ = 0.0;
  std::optional<double>
      shear_force_at_start_;       ///< none before the first piece of a step, and of surfaces that may stick
  Centre centre_{};                ///< of the present state, see Target
  double time_ = 0.0, slid_ = 0.0; ///< of the present state, see Target
  std::vector<GridChange> grid_changes_;
  Coverage coverage_;
};

/// Pressure and shear of the last step [Pa].
[[nodiscard]] halfspace::SurfaceLoad surface_load(const elastoplastic::CoupledContact& pair);
/// Whether a cell of the contact grid bears pressure.
[[nodiscard]] bool touches(const elastoplastic::CoupledContact& pair);

/// Setup of a case, whose surfaces slide everywhere; `start` as in the setup.
/// @param heat_times  of heated bodies
[[nodiscard]] Stepper::Setup setup_of(const PairCase& c, const Centre& start, const halfspace::HeatTimes& heat_times);

/// Depths of a texture on the grid of a body [m]; empty if it is smooth.
/// @param x0  surface coordinate of column 0 of the grid [m]
/// @param y   surface coordinate of the middle of its rows [m]
[[nodiscard]] std::vector<double> textured(const Texture& texture, const SurfaceGrid& grid, double x0, double y = 0.0);

} // namespace brinell::simulation
