// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/halfspace/traction_compliance.hpp"

#include <array>
#include <functional>
#include <memory>
#include <span>

/// Stick and slip of two surfaces in contact: shears from the rigid displacement or the force along the surface.
namespace brinell::contact
{

/// What is imposed along the surface in one step. The shift is that of distant points of body 2 past those of body 1; the
/// force acts on body 1, on body 2 the other way.
struct TangentialDrive
{
  enum class Kind
  {
    shift, ///< how much farther, `value` in [m]
    force  ///< the sum of the shear after the step, `value` in [N]
  };
  struct Axis
  {
    Kind kind = Kind::shift;
    double value = 0.0;
    bool operator==(const Axis&) const = default;
  };
  Axis x, y;
  double spin = 0.0; ///< how much farther body 2 turns about z through the middle of the grid, from x to y [rad]
  bool operator==(const TangentialDrive&) const = default;
};

/// Fields along x and y, one value per cell each.
using AlongSurface = std::array<std::span<double>, 2>;
using ConstAlongSurface = std::array<std::span<const double>, 2>;

/// One step of a history of stick and slip.
struct TangentialStep
{
  std::span<const double> bound; ///< largest size of the shear, friction coefficient times pressure say, >= 0 [Pa]
  ConstAlongSurface before;      ///< shears of the step before [Pa]; empty: none
  ConstAlongSurface
      change; ///< displacement of body 1 less that of body 2 that pressure or plastic strain has added [m]; empty: none
  TangentialDrive drive;
  /// Rolling: by how many cells both surfaces have moved through the contact along x and y in this step, with the shears
  /// before. The shift is creepage times distance then, and slip and change are those of points of the surfaces.
  std::array<int, 2> carried{};
};

/// How a step ended.
struct TangentialReport
{
  bool converged = false;
  int iterations = 0;
  int products =
      0; ///< with the compliance, beside those on larger cells for a guess; about its inverse is applied twice per iteration
  int retreats = 0;              ///< steps that had to be replaced by one that is certain to descend
  std::array<double, 2> shift{}; ///< of the step along x and y, imposed or found [m]
  std::array<double, 2> force{}; ///< sum of the shear [N]
  double slip_error = 0.0; ///< largest slip where the surfaces stick, and across or against the shear elsewhere [m]
  double dissipated = 0.0; ///< sum of shear times slip of the step [J]
};

/// Share of its bound up to which a cell sticks; rounding keeps no shear just at its bound.
inline constexpr double slip_threshold = 1.0 - 1e-12;

class CoarserTangential;

/// Stick and slip under a given bound of the shear, by conjugate gradients on the discs |q| <= g of all cells.
///
/// Finds q with |q| <= g, the slip s = shift - change - A (q - q_before) of body 2 over body 1 in the step, s = 0 where |q| < g, and s along q
/// where |q| = g, with A the displacement of body 1 less that of body 2 by shears: docs/theory/contact.md (stick-slip). This
/// is the minimum of a convex function, so that every step has one solution, but for shears that displace nothing.
class TangentialContact
{
public:
  /// @param compliance  must outlive this object.
  explicit TangentialContact(const halfspace::TractionCompliance& compliance);
  ~TangentialContact();
  TangentialContact(const TangentialContact&) = delete;
  TangentialContact& operator=(const TangentialContact&) = delete;

  /// @param tolerance  largest slip error [m].
  /// @param max_iterations  after so many, the report says that the step has not converged.
  /// @param shear  in: a guess (the shears of the step before are one); out: [Pa].
  /// @param slip   out: of the step, zero where the bound is [m].
  /// @param wants_stop  asked every few iterations.
  /// @throws Interrupted if `wants_stop` says so; InputError for a force that reaches what the bound can carry, or a bound that is
  ///         negative or not finite; InternalError if a field does not have one value per cell.
  [[nodiscard]] TangentialReport solve(const TangentialStep& step, double tolerance, int max_iterations,
                                       const AlongSurface& shear, const AlongSurface& slip,
                                       const std::function<bool()>& wants_stop = {});

private:
  class Iteration;
  void improve_guess(const TangentialStep& step, double tolerance, TangentialReport& report, const AlongSurface& shear,
                     const std::function<bool()>& wants_stop);

  const halfspace::TractionCompliance& compliance_;
  std::unique_ptr<Iteration> iteration_;       ///< its fields are kept from step to step
  std::unique_ptr<CoarserTangential> coarser_; ///< made when it is first wanted
};

} // namespace brinell::contact
