// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/halfspace/surface_compliance.hpp"

#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

/// Frictionless, non-adhesive contact of two surfaces: pressure and gap from the distance of the undeformed surfaces.
namespace brinell::contact
{

/// The quantity that is imposed on two bodies: approach, load or mean gap. The others are results.
struct Drive
{
  enum class Kind
  {
    approach, ///< distance by which the bodies have approached since their undeformed surfaces touched, `value` in [m]
    load,     ///< the sum of the pressure, `value` in [N], not negative
    mean_gap ///< mean of the gap over the period, only for bodies periodic along both axes, `value` in [m], not negative
  };
  Kind kind = Kind::approach;
  double value = 0.0;
  bool operator==(const Drive&) const = default;
};

/// Outcome of a contact solution.
struct Report
{
  bool converged = false;
  int iterations = 0;
  int products = 0;         ///< with the compliance; the preconditioner is also applied once per iteration
  double approach = 0.0;    ///< imposed or found [m]; without load, the approach at which the surfaces touch
  double gap_error = 0.0;   ///< largest |gap| where pressure acts [m]
  double penetration = 0.0; ///< largest overlap (negative gap) where no pressure acts [m]
};

class CoarserContact;

/// The iteration of a contact elsewhere than on this processor, for a load above 0 or an approach.
class ContactOnDevice
{
public:
  virtual ~ContactOnDevice() = default;

  /// Arguments and result as those of ElasticContact::solve.
  [[nodiscard]] virtual Report solve(std::span<const double> distance, const Drive& drive, double tolerance,
                                     int max_iterations, std::span<double> pressure, std::span<double> gap,
                                     const std::function<bool()>& wants_stop) = 0;
};

/// Contact by the constrained conjugate gradient method (after Polonsky, Keer 1999) with a preconditioner.
///
/// Finds p >= 0, gap = distance - approach + A p >= 0, p * gap = 0 with A the surface compliance; either the approach or the
/// load, the sum of p dx dy, is imposed: docs/theory/contact.md (complementarity).
///
/// Each iteration converts the gap into pressure by an approximate inverse of A (the preconditioner), on the cells that are under
/// pressure or overlap. As long as no pressure is cut off at zero, the displacement is updated by the image of the search
/// direction, which the iteration needs anyway, and an iteration costs one product with A besides the preconditioner. The
/// reported gap always results from a product with the pressure itself. The iteration, step by step: docs/theory/contact.md.
///
/// If the initial pressure is zero everywhere, the guess on a large grid is the pressure of the same contact solved on larger
/// cells; the iteration converges to the same solution. On a mirrored grid half of the cells are solved.
class ElasticContact
{
public:
  /// @param compliance  must outlive this object.
  explicit ElasticContact(const halfspace::SurfaceCompliance& compliance);
  ~ElasticContact();
  ElasticContact(const ElasticContact&) = delete;
  ElasticContact& operator=(const ElasticContact&) = delete;

  /// @param distance   of the undeformed surfaces at zero approach [m].
  /// @param given      the imposed quantity.
  /// @param tolerance  allowed largest |gap| under pressure and largest penetration elsewhere [m].
  /// @param max_iterations  after this number the solution stops and the report says that it has not converged.
  /// @param pressure   in: an initial guess, which may be zero; out: the pressure [Pa].
  /// @param gap        out: [m].
  /// @param wants_stop called every few iterations.
  /// @param layer      local compliance of a layer between the surfaces, whose compression is proportional to the local pressure
  ///                   [m/Pa], one per cell; empty: no layer.
  /// @throws Interrupted if `wants_stop` returns true; InputError for an approach beyond full contact of bodies that are periodic
  ///         along both axes (the mean of the distance, where the mean gap is zero for any pressure), and for a mean gap that is
  ///         negative or imposed on other bodies; InternalError if a field does not have one value per cell.
  [[nodiscard]] Report solve(std::span<const double> distance, const Drive& given, double tolerance, int max_iterations,
                             std::span<double> pressure, std::span<double> gap,
                             const std::function<bool()>& wants_stop = {}, std::span<const double> layer = {});

  /// Has a device iterate from now on, but for contacts with a layer and for the guess on larger cells.
  void iterate_on(std::unique_ptr<ContactOnDevice> device) { device_ = std::move(device); }

private:
  /// The problem after a mean gap has been replaced: its drive is a load or an approach.
  struct Problem
  {
    std::span<const double> distance;
    Drive drive;
    double tolerance;
    int max_iterations;
    const std::function<bool()>& wants_stop;
  };
  [[nodiscard]] Report iterate(const Problem& problem, std::span<double> pressure, std::span<double> gap);
  [[nodiscard]] Report solve_mean_gap(const Problem& problem, std::span<double> pressure, std::span<double> gap);
  /// Result of a step of the pressure.
  struct Step
  {
    bool cut = false; ///< whether a pressure below zero was cut off somewhere
    double sum = 0.0; ///< of the pressure
  };
  [[nodiscard]] std::size_t cells() const { return compliance_.grid().independent_cells(); } ///< solved ones
  void displace(std::span<const double> pressure, std::span<double> out);
  void guess(std::span<const double> distance, const Drive& drive, double tolerance, std::span<double> pressure,
             const std::function<bool()>& wants_stop);
  void start(std::span<const double> distance, const Drive& drive, std::span<double> pressure);
  void scale_to_load(double load, double sum, std::span<double> pressure);
  [[nodiscard]] Report evaluate(std::span<const double> distance, const Drive& drive, std::span<const double> pressure,
                                std::span<double> gap) const;
  [[nodiscard]] double descend(double& slope, bool load_given, std::span<const double> pressure,
                               std::span<const double> gap);
  [[nodiscard]] Step advance(double step, std::span<const double> gap, std::span<double> pressure);

  const halfspace::SurfaceCompliance& compliance_;
  halfspace::SurfaceCompliance::Scratch scratch_;
  /// Search direction of the pressure and its displacement; `image_` first holds the preconditioned gap.
  std::vector<double> direction_, image_;
  std::vector<double> displacement_;        ///< of the pressure [m]
  std::span<const double> layer_;           ///< of the current solution
  std::unique_ptr<CoarserContact> coarser_; ///< created when it is first needed
  std::unique_ptr<ContactOnDevice> device_; ///< nullptr: this processor
};

} // namespace brinell::contact
