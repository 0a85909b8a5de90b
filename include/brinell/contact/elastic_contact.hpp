// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/halfspace/surface_compliance.hpp"

#include <functional>
#include <memory>
#include <span>
#include <vector>

/// Frictionless, non-adhesive contact of two surfaces: pressure and gap from the shape between them.
namespace brinell::contact
{

/// Approach, load or mean gap: one of them is imposed on two bodies, the others are found.
struct Drive
{
  enum class Kind
  {
    approach, ///< how far the bodies have come together since their undeformed surfaces touched, `value` in [m]
    load,     ///< the sum of the pressure, `value` in [N], not negative
    mean_gap  ///< of bodies that are periodic along both axes, over the period, `value` in [m], not negative
  };
  Kind kind = Kind::approach;
  double value = 0.0;
  bool operator==(const Drive&) const = default;
};

/// How a contact solution ended.
struct Report
{
  bool converged = false;
  int iterations = 0;
  int products = 0;         ///< with the compliance; about its inverse is applied once per iteration
  double approach = 0.0;    ///< imposed or found [m]; without load that at which the surfaces touch
  double gap_error = 0.0;   ///< largest |gap| where pressure acts [m]
  double penetration = 0.0; ///< largest negative gap where none acts [m]
};

class CoarserContact;

/// Contact by the constrained conjugate gradient method (after Polonsky, Keer 1999) with a preconditioner.
///
/// Finds p >= 0, gap = distance - approach + A p >= 0, p * gap = 0 with A the surface compliance; the approach is given, or
/// the sum of p dx dy is: docs/theory/contact.md (complementarity).
///
/// Each iteration turns the gap into pressure by about the inverse of A, on the cells that are pressed or overlap. While
/// no pressure is cut off at zero, the displacement follows by the image of the direction that the iteration has
/// anyway, and an iteration costs one product with A beside the inverse. The gap that is reported always comes of a product
/// with the pressure itself. The iteration, step by step: docs/theory/contact.md.
///
/// Where nothing presses yet, a large grid begins with the pressure of the contact on larger cells; what the iteration
/// converges to is the same.
class ElasticContact
{
public:
  /// @param compliance  must outlive this object.
  explicit ElasticContact(const halfspace::SurfaceCompliance& compliance);
  ~ElasticContact();
  ElasticContact(const ElasticContact&) = delete;
  ElasticContact& operator=(const ElasticContact&) = delete;

  /// @param distance   of the undeformed surfaces at no approach [m].
  /// @param tolerance  largest |gap| under pressure and largest penetration elsewhere [m].
  /// @param max_iterations  after so many, the report says that the contact has not converged.
  /// @param pressure   in: a guess (zeros are one); out: the pressure [Pa].
  /// @param gap        out: [m].
  /// @param wants_stop asked every few iterations.
  /// @param layer      depth by which a layer between the surfaces gives way in proportion to the local pressure [m/Pa], one per
  ///                   cell; empty: none.
  /// @throws Interrupted if `wants_stop` says so; InputError for an approach beyond full contact of bodies that are periodic
  ///         along both axes, the mean of the distance, where the mean gap is zero whatever the pressure, and for a mean gap
  ///         that is negative or of other bodies; InternalError if a field does not have one value per cell.
  [[nodiscard]] Report solve(std::span<const double> distance, const Drive& given, double tolerance, int max_iterations,
                             std::span<double> pressure, std::span<double> gap,
                             const std::function<bool()>& wants_stop = {}, std::span<const double> layer = {});

private:
  /// What is to be solved, once all that is imposed is a load or an approach.
  struct Problem
  {
    std::span<const double> distance;
    Drive drive;
    double tolerance;
    int max_iterations;
    const std::function<bool()>& wants_stop;
  };
  [[nodiscard]] Report iterate(const Problem& problem, std::span<double> pressure, std::span<double> gap);
  [[nodiscard]] Report keep_gap(const Problem& problem, std::span<double> pressure, std::span<double> gap);
  /// What a step has done to the pressure.
  struct Step
  {
    bool cut = false; ///< whether it went past zero somewhere
    double sum = 0.0; ///< of the pressure
  };
  void displace(std::span<const double> pressure, std::span<double> out);
  void guess(std::span<const double> distance, const Drive& drive, double tolerance, std::span<double> pressure,
             const std::function<bool()>& wants_stop);
  void start(std::span<const double> distance, const Drive& drive, std::span<double> pressure);
  void scale_to_load(double load, double sum, std::span<double> pressure);
  [[nodiscard]] Report settle(std::span<const double> distance, const Drive& drive, std::span<const double> pressure,
                              std::span<double> gap) const;
  [[nodiscard]] double descend(double& slope, bool load_given, std::span<const double> pressure,
                               std::span<const double> gap);
  [[nodiscard]] Step advance(double step, std::span<const double> gap, std::span<double> pressure);

  const halfspace::SurfaceCompliance& compliance_;
  halfspace::SurfaceCompliance::Scratch scratch_;
  std::vector<double> direction_, image_; ///< of the pressure, and its displacement; before that, what the gap asks for
  std::vector<double> displacement_;      ///< of the pressure [m]
  std::span<const double> layer_;         ///< of the solution at hand
  std::unique_ptr<CoarserContact> coarser_; ///< once it has been needed
};

} // namespace brinell::contact
