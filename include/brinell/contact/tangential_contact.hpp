// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/halfspace/surface_compliance.hpp"

#include <array>
#include <functional>
#include <memory>
#include <span>

/// Stick and slip of two surfaces in contact: shears from the rigid-body displacement or the force along the surface.
namespace brinell::contact
{

/// Quantities imposed along the surface in one step. The shift is the displacement of distant points of body 2 relative to those
/// of body 1; the force is that on body 1, and the force on body 2 is opposite.
struct TangentialDrive
{
  enum class Kind
  {
    shift, ///< increment of the shift in this step, `value` in [m]
    force  ///< the sum of the shear after the step, `value` in [N]
  };
  struct Axis
  {
    Kind kind = Kind::shift;
    double value = 0.0;
    bool operator==(const Axis&) const = default;
  };
  Axis x, y;
  /// Rotation of body 2 in this step about z through the middle of the grid, from x to y [rad]. In rolling it turns each point
  /// about that place from halfway between the cells in which the point lies before and after the step.
  double spin = 0.0;
  bool operator==(const TangentialDrive&) const = default;
};

/// Fields along x and y, one value per cell each.
using AlongSurface = std::array<std::span<double>, 2>;
using ConstAlongSurface = std::array<std::span<const double>, 2>;

/// One step of a history of stick and slip.
struct TangentialStep
{
  std::span<const double>
      bound;                ///< largest magnitude of the shear, such as friction coefficient times pressure, >= 0 [Pa]
  ConstAlongSurface before; ///< shears after the previous step [Pa]; empty: none
  ConstAlongSurface
      change; ///< displacement of body 1 minus that of body 2 added by pressure or plastic strain in the step [m]; empty: none
  TangentialDrive drive;
  /// Rolling: number of cells by which both surfaces, together with the shears `before`, have moved through the contact along x
  /// and y in this step. The shift is then creepage times rolling distance, and slip and change refer to material points of the
  /// surfaces.
  std::array<int, 2> carried{};
  /// Rolling: compliance of each cell to its own shear, in addition to that of the bodies, because its point has moved freely
  /// before it came into the contact; a symmetric matrix: xx, yy, xy [m/Pa]. Empty: none.
  std::array<std::span<const double>, 3> entry{};
};

/// Outcome of a step.
struct TangentialReport
{
  bool converged = false;
  int iterations = 0;
  int products =
      0; ///< with the compliance, without those on larger cells for a guess; the preconditioner is applied twice per iteration
  int retreats = 0;              ///< steps that had to be replaced by one that certainly decreases the energy
  std::array<double, 2> shift{}; ///< in the step along x and y, imposed or found [m]
  std::array<double, 2> force{}; ///< sum of the shear [N]
  /// Largest slip where the surfaces stick; elsewhere largest slip across or against the shear [m].
  double slip_error = 0.0;
  double dissipated = 0.0; ///< sum of shear times slip of the step [J]
};

/// Fraction of its bound below which a cell sticks: because of rounding, no shear lies exactly at its bound.
inline constexpr double slip_threshold = 1.0 - 1e-12;

class CoarserTangential;

/// Stick and slip under a given bound g of the shear, by conjugate gradients on the discs |q| <= g of all cells.
///
/// Finds q with |q| <= g, the slip s = shift - change - A (q - q_before) - entry q of body 2 over body 1 in the step,
/// s = 0 where |q| < g, and s along q where |q| = g, with A the displacement of body 1 minus that of body 2 by shears:
/// docs/theory/contact.md (stick-slip). This is the minimum of a convex function, so the solution of every step is
/// unique, up to shears that cause no displacement.
class TangentialContact
{
public:
  /// @param compliance  must outlive this object.
  explicit TangentialContact(const halfspace::SurfaceCompliance& compliance);
  ~TangentialContact();
  TangentialContact(const TangentialContact&) = delete;
  TangentialContact& operator=(const TangentialContact&) = delete;

  /// @param tolerance  allowed largest slip error [m].
  /// @param max_iterations  after this number the solution stops and the report says that it has not converged.
  /// @param shear  in: an initial guess, such as the shears of the previous step; out: [Pa].
  /// @param slip   out: slip in the step, zero where the bound is zero [m].
  /// @param wants_stop  called every few iterations.
  /// @throws Interrupted if `wants_stop` returns true; InputError if the force reaches the largest one that the bound allows, or
  ///         the bound is negative or not finite; InternalError if a field does not have one value per cell.
  [[nodiscard]] TangentialReport solve(const TangentialStep& step, double tolerance, int max_iterations,
                                       const AlongSurface& shear, const AlongSurface& slip,
                                       const std::function<bool()>& wants_stop = {});

private:
  class Iteration;
  void improve_guess(const TangentialStep& step, double tolerance, TangentialReport& report, const AlongSurface& shear,
                     const std::function<bool()>& wants_stop);

  const halfspace::SurfaceCompliance& compliance_;
  std::unique_ptr<Iteration> iteration_;       ///< kept, because fields are reused from step to step
  std::unique_ptr<CoarserTangential> coarser_; ///< created when it is first needed
};

} // namespace brinell::contact
