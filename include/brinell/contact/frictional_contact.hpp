// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/elastic_contact.hpp"
#include "brinell/contact/tangential_contact.hpp"

#include <vector>

namespace brinell::contact
{

/// What a contact with friction carries from one step to the next.
struct FrictionState
{
  std::vector<double> pressure;         ///< [Pa]
  std::vector<double> shear_x, shear_y; ///< on body 1 [Pa]
  std::array<double, 2> shift{};        ///< of body 2 past body 1 along x and y so far [m]
  double spin = 0.0;                    ///< of body 2 so far [rad]
  double dissipated = 0.0;              ///< work of friction so far [J]

  FrictionState() = default;
  /// Bodies that do not touch yet.
  explicit FrictionState(std::size_t cells) : pressure(cells), shear_x(cells), shear_y(cells) {}
};

/// How a step ended.
struct FrictionReport
{
  bool converged = false;
  int alternations = 0;        ///< of the normal and the tangential problem
  Report normal;               ///< of the last alternation
  TangentialReport tangential; ///< of the last alternation
  double gap_change = 0.0;     ///< by which the last shears have moved the gap [m]
};

/// Largest errors of a step.
struct FrictionTolerances
{
  double gap = 0.0;          ///< as of `ElasticContact::solve`, and of `FrictionReport::gap_change` [m]
  double slip = 0.0;         ///< as of `TangentialContact::solve` [m]
  int max_iterations = 2000; ///< of each solution
  int max_alternations = 50;
};

/// Contact of two elastic bodies with Coulomb's friction: |q| <= friction * p.
///
/// Where the bodies differ, the shears open or close the gap and the pressure pulls along the surface (Dundurs). Then the normal and
/// the tangential problem are solved by turns, until the gap stays (Panagiotopoulos 1975): docs/theory/contact.md (coupling).
class FrictionalContact
{
public:
  /// @param normal, tractions  of the same pair on the same grid; they must outlive this object.
  FrictionalContact(const halfspace::SurfaceCompliance& normal, const halfspace::TractionCompliance& tractions);

  /// @param distance    as of `ElasticContact::solve` [m]
  /// @param normal      what presses the bodies together
  /// @param tangential  what moves them along each other in this step
  /// @param friction    coefficient, >= 0
  /// @param state       in: after the step before; out: after this one, also if it has not converged
  /// @param gap         out: [m]
  /// @param slip        out: of the step [m]
  /// @param carried     as of `TangentialStep`
  /// @throws as `ElasticContact::solve` and `TangentialContact::solve`; InputError for a coefficient that is negative or not finite
  [[nodiscard]] FrictionReport step(std::span<const double> distance, const Drive& normal,
                                    const TangentialDrive& tangential, double friction,
                                    const FrictionTolerances& tolerances, FrictionState& state, std::span<double> gap,
                                    const AlongSurface& slip, const std::function<bool()>& wants_stop = {},
                                    const std::array<int, 2>& carried = {});

private:
  void couple(const FrictionState& state);
  [[nodiscard]] double gap_change();

  const halfspace::TractionCompliance& tractions_;
  halfspace::TractionCompliance::Scratch scratch_;
  ElasticContact normal_;
  TangentialContact tangential_;
  std::vector<double> pressure_before_, shear_x_before_, shear_y_before_;
  std::vector<double> bound_, distance_;
  std::vector<double> lowered_, lowered_before_;             ///< displacement of the shears along z [m]
  std::vector<double> pressure_added_, pulled_x_, pulled_y_; ///< in the step, and its displacement along the surface
};

} // namespace brinell::contact
