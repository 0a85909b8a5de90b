// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"

#include <functional>
#include <string>

namespace brinell::simulation
{

/// The contact grid at one moment of the motion.
struct Frame
{
  double x0 = 0.0;                    ///< of contact column 0 from the contact's centre [m]
  elastoplastic::Placement placement; ///< on the material grids
};

/// What is to be solved: where the bodies are and what presses them together.
struct Target
{
  Frame frame;
  contact::Drive drive;
};

/// Where the cells of both bodies lie. The contact grid takes those of the lower body along and follows the contact's centre
/// to within half a cell; columns of the upper body's grid fall on them, or between them.
class Lattice
{
public:
  /// @param arc_lower, arc_upper  contact centre on each body [m] at a moment when the columns of both bodies coincide.
  Lattice(const Plan& plan, double arc_lower, double arc_upper);

  [[nodiscard]] Frame frame(double arc_lower, double arc_upper) const;
  /// Surface coordinate of column 0 of a body's grid [m].
  [[nodiscard]] double lower_origin() const { return lower_origin_; }
  [[nodiscard]] double upper_origin() const { return upper_origin_; }

private:
  [[nodiscard]] long centre_column(double arc_lower) const;

  double dx_;
  int half_;
  double lower_origin_, upper_origin_;
};

/// The state of both bodies and the way from one moment to the next, the same for all scenarios.
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
    elastoplastic::Textures textures{};
    std::function<bool()> wants_stop{}; ///< see Observer
  };
  Stepper(const Plan& plan, Setup setup);

  /// Goes to `path(1)` from `path(0)`, which is the present state. What does not converge whole is halved, as long as a piece
  /// is longer than `finest`; a piece that still does not is solved by the plain fixed point of the convex problem, watched
  /// by its energy.
  /// @param where  for messages.
  /// @returns the evaluations it took.
  /// @throws ConvergenceError, GridError if the plastic zone reaches an edge of its grid.
  int advance(const std::function<Target(double)>& path, double finest, const std::string& where);

  /// Smallest distance of the surfaces, with texture and residual displacement, at no approach [m].
  [[nodiscard]] double clearance(const Frame& frame);
  /// What all scenarios record.
  void fill(StepRecord& record) const;
  /// Depth of each surface under the contact grid [m].
  struct Depths
  {
    std::vector<double> lower, upper;
  };
  [[nodiscard]] const Depths& depths(const Frame& frame);
  /// Smallest and largest residual displacement of the lower body under the contact grid, at most and at least 0 [m].
  [[nodiscard]] std::pair<double, double> residual_range(const Frame& frame) const;
  [[nodiscard]] bool touching() const;
  [[nodiscard]] const elastoplastic::CoupledContact& pair() const { return pair_; }
  [[nodiscard]] int split_increments() const { return split_increments_; }
  [[nodiscard]] Snapshot snapshot(const Lattice& lattice, const Frame& frame, double arc_lower, double arc_upper) const;

  void exchange(Archive& archive);

private:
  void bisect(const std::function<Target(double)>& path, double begin, double end, double finest);
  bool attempt(const Target& target);
  [[nodiscard]] elastoplastic::IncrementReport solved(const Target& target, const elastoplastic::Strategy& strategy);
  void guard(const Target& target);
  void place(const Frame& frame);

  Setup setup_;
  elastoplastic::CoupledContact pair_;
  std::vector<double> distance_;
  double distance_x0_ = 0.0; ///< for which `distance_` holds
  Depths depths_;
  std::string where_;
  int evaluations_ = 0;
  int split_increments_ = 0;
  Coverage coverage_;
};

/// Depths of a texture on a grid of a body; empty if it is smooth.
[[nodiscard]] std::vector<double> textured(const Texture& texture, const SurfaceGrid& grid, double x0);

} // namespace brinell::simulation
