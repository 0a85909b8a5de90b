// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

#include <functional>
#include <memory>
#include <string>

namespace brinell::simulation
{

/// Where the middle of the contact is on the surface of each body [m].
struct Centre
{
  double lower = 0.0, upper = 0.0;
};

/// What is to be solved: where the bodies touch and what presses them together.
struct Target
{
  Centre centre;
  contact::Drive drive;
  bool slides = true;               ///< the surfaces on each other; else there is no friction
  contact::TangentialDrive along{}; ///< see CoupledContact::advance
  double time = 0.0;                ///< since the start [s]; where it stands still, nothing happens to heat
  double slid = 0.0;                ///< by which the undeformed surfaces have slid on each other since the start [m]
  bool is_put_down = false;         ///< the contact has not moved over the bodies to where it is
};

/// The contact grid at one moment of the motion.
struct Frame
{
  double x0 = 0.0;                    ///< of contact column 0 from the contact's centre [m]
  elastoplastic::Placement placement; ///< on the material grids
};

/// Where the cells of both bodies lie. The contact grid takes those of the lower body along and follows the contact's centre
/// to within half a cell; columns of the upper body's grid fall on them, or between them.
class Lattice
{
public:
  /// @param start  a moment when the columns of both bodies coincide.
  Lattice(const Plan& plan, const Centre& start);

  [[nodiscard]] Frame frame(const Centre& centre) const;
  /// Surface coordinate of column 0 of a body's grid [m].
  [[nodiscard]] double lower_origin() const { return -lower_columns_ * dx_; }
  [[nodiscard]] double upper_origin() const { return upper_start_ - upper_columns_ * dx_; }
  /// The grids have grown by so many columns at each end (shrunk, if negative); every cell stays where it is.
  void grow(int contact, int lower, int upper);

private:
  [[nodiscard]] long centre_column(double arc_lower) const;

  double dx_;
  int half_;           ///< columns of the contact grid on either side of its middle one
  double upper_start_; ///< of the contact's column 0 at the start, on the upper body [m]
  int lower_columns_;  ///< before the one at 0
  int upper_columns_;  ///< before the one at `upper_start_`
};

/// The state of both bodies and the way from one moment to the next, the same for all scenarios. Its grids grow where pressure
/// or plastic strain reaches their edges.
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
    Watch watch{};
    elastoplastic::Sliding sliding{};
    Centre beside{}; ///< the same across the motion, where it stays: textures are read from there
  };
  Stepper(const Plan& plan, Setup setup);

  /// Goes to `path(1)` from `path(0)`, which is the present state. What does not converge whole is halved, as long as a piece
  /// is longer than `finest`; a piece that still does not is solved by the plain fixed point of the convex problem, watched
  /// by its energy. Where a solution outgrows a grid, that grid is enlarged and the piece solved again.
  /// @param where  for messages.
  /// @returns the evaluations it took.
  /// @throws ConvergenceError; GridError if larger grids do not fit into the memory
  int advance(const std::function<Target(double)>& path, double finest, const std::string& where);

  /// Of the surfaces under the contact grid, with texture and residual displacement, at no approach [m].
  struct Distances
  {
    double smallest = 0.0, mean = 0.0;
  };
  [[nodiscard]] Distances distances(const Centre& centre);
  [[nodiscard]] double clearance(const Centre& centre) { return distances(centre).smallest; }
  /// Of contact column 0 from the contact's centre [m].
  [[nodiscard]] double left_of(const Centre& centre) const { return lattice_.frame(centre).x0; }
  /// What all scenarios record.
  void fill(StepRecord& record) const;
  void fill(FrictionRecord& record) const;
  void fill(HeatedRecord& record) const;
  /// Depth of each surface under the contact grid [m].
  struct Depths
  {
    std::vector<double> lower, upper;
  };
  [[nodiscard]] const Depths& depths(const Centre& centre);
  /// The same with the elastic depth that the shear of the last step gives to each surface: what the pressure pushes against.
  /// Of surfaces that may stick the lower one has all of it: they move along the contact alike.
  [[nodiscard]] const Depths& loaded_depths(const Centre& centre);
  /// Pressure and shear of the last step [Pa].
  [[nodiscard]] halfspace::SurfaceLoad load() const;
  /// Work of the shear on the deformation of both surfaces in the last step [J].
  [[nodiscard]] double shear_work() const { return shear_work_; }
  /// Smallest and largest residual displacement of the lower body under the contact grid, at most and at least 0 [m].
  [[nodiscard]] std::pair<double, double> residual_range(const Centre& centre) const;
  [[nodiscard]] bool touching() const;
  [[nodiscard]] const elastoplastic::CoupledContact& pair() const { return *pair_; }
  [[nodiscard]] int split_increments() const { return split_increments_; }
  /// Not to be used after the next step.
  [[nodiscard]] StepFields fields(const Centre& centre) const;
  /// What a summary tells of the solution.
  void fill(RunTotals& totals) const;

  void exchange(Archive& archive);

private:
  void bisect(const std::function<Target(double)>& path, double begin, double end, double finest);
  bool attempt(const Target& target);
  [[nodiscard]] elastoplastic::IncrementReport solved(const Target& target, const elastoplastic::Strategy& strategy);
  void descend(const Target& target);
  void place(const Frame& frame);
  [[nodiscard]] std::unique_ptr<elastoplastic::CoupledContact> make_pair() const;
  void grow(const elastoplastic::Outgrown& outgrown);
  [[nodiscard]] double memory_of(const Plan& plan) const;
  void announce(const Plan& larger);
  void move_to(const Plan& larger);

  Setup setup_;
  Plan plan_; ///< with the grids of today
  Lattice lattice_;
  std::unique_ptr<elastoplastic::CoupledContact> pair_;
  std::vector<double> distance_;
  double distance_x0_ = 0.0; ///< for which `distance_` holds
  Depths depths_;
  std::string where_;
  int evaluations_ = 0;
  int steps_ = 0; ///< finished
  int split_increments_ = 0;
  double shear_work_ = 0.0;
  Centre centre_{};                ///< of the present state, see Target
  double time_ = 0.0, slid_ = 0.0; ///< likewise
  std::vector<GridChange> grid_changes_;
  Coverage coverage_;
};

/// Of two bodies that have shapes and textures; `start` as in the setup.
[[nodiscard]] Stepper::Setup shaped_setup(const ShapedBody& lower, const ShapedBody& upper,
                                          const elastoplastic::Settings& solver, const Centre& start);

/// Depths of a texture on a grid of a body; empty if it is smooth.
/// @param x0  surface coordinate of its column 0; y  of the middle between its rows [m]
[[nodiscard]] std::vector<double> textured(const Texture& texture, const SurfaceGrid& grid, double x0, double y = 0.0);

} // namespace brinell::simulation
