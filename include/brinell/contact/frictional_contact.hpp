// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/elastic_contact.hpp"
#include "brinell/contact/tangential_contact.hpp"

#include <memory>
#include <vector>

namespace brinell::contact
{

/// State of a frictional contact between steps.
struct FrictionState
{
  std::vector<double> pressure;         ///< [Pa]
  std::vector<double> shear_x, shear_y; ///< on body 1 [Pa]
  std::array<double, 2> shift{};        ///< accumulated displacement of body 2 relative to body 1 along x and y [m]
  double spin = 0.0;                    ///< accumulated rotation of body 2 about z [rad]
  double dissipated = 0.0;              ///< accumulated work of friction [J]

  FrictionState() = default;
  /// State of bodies that are not yet in contact: zero pressure and shears.
  explicit FrictionState(std::size_t cells) : pressure(cells), shear_x(cells), shear_y(cells) {}
};

/// Outcome of a step.
struct FrictionReport
{
  bool converged = false;
  int alternations = 0;        ///< between the normal and the tangential problem
  Report normal;               ///< of the last alternation
  TangentialReport tangential; ///< of the last alternation
  double gap_change = 0.0;     ///< change of the gap by the change of the shears in the last alternation [m]
};

class EntryCompliance;

/// Tolerances of a step.
struct FrictionTolerances
{
  double gap = 0.0;          ///< tolerance of `ElasticContact::solve`, and of `FrictionReport::gap_change` [m]
  double slip = 0.0;         ///< tolerance of `TangentialContact::solve` [m]
  int max_iterations = 2000; ///< of each solution
  int max_alternations = 50;
};

/// Contact of two elastic bodies with Coulomb's friction: |q| <= friction * p.
///
/// If the bodies are elastically dissimilar, shears change the gap and pressure causes displacements along the surface (Dundurs).
/// The normal and the tangential problem are then solved alternately until the gap no longer changes (Panagiotopoulos 1975):
/// docs/theory/contact.md (coupling).
class FrictionalContact
{
public:
  /// @param pair  must outlive this object.
  explicit FrictionalContact(const halfspace::SurfaceCompliance& pair);
  ~FrictionalContact();
  FrictionalContact(const FrictionalContact&) = delete;
  FrictionalContact& operator=(const FrictionalContact&) = delete;

  /// @param distance    as for `ElasticContact::solve` [m]
  /// @param normal      imposed quantity normal to the surface
  /// @param tangential  imposed quantities along the surface in this step
  /// @param friction    coefficient, >= 0
  /// @param state       in: after the previous step; out: after this step, also if it has not converged
  /// @param gap         out: [m]
  /// @param slip        out: slip in this step [m]
  /// @param carried     as for `TangentialStep`
  /// @throws as `ElasticContact::solve` and `TangentialContact::solve`; InputError if the coefficient is negative or not finite
  [[nodiscard]] FrictionReport step(std::span<const double> distance, const Drive& normal,
                                    const TangentialDrive& tangential, double friction,
                                    const FrictionTolerances& tolerances, FrictionState& state, std::span<double> gap,
                                    const AlongSurface& slip, const std::function<bool()>& wants_stop = {},
                                    const std::array<int, 2>& carried = {});

private:
  void couple(const FrictionState& state);
  [[nodiscard]] double gap_change();

  const halfspace::SurfaceCompliance& pair_;
  halfspace::SurfaceCompliance::Scratch scratch_;
  ElasticContact normal_;
  TangentialContact tangential_;
  std::unique_ptr<EntryCompliance> entry_; ///< of points that roll into the contact
  std::vector<double> pressure_before_, shear_x_before_, shear_y_before_;
  std::vector<double> bound_, distance_;
  std::vector<double> lowered_, lowered_before_; ///< displacement along z by the shears [m]
  std::vector<double> pressure_added_, pulled_x_,
      pulled_y_; ///< pressure added in the step, and its displacement along x and y
};

} // namespace brinell::contact
