// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/tangential_contact.hpp"
#include "brinell/foundation/field_table.hpp"

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// Coulomb friction between two surfaces: docs/theory/elastoplastic.md (coulomb).
struct Friction
{
  double coefficient = 0.0; ///< shear over pressure, >= 0; 0: none
  std::optional<double>
      shear_limit{}; ///< largest shear of the interface [Pa], > 0; never more than the shear strength of the softer surface
  /// Whether the shear changes the gap where the elastic constants differ.
  bool coupling = true;

  bool operator==(const Friction&) const = default;
};

/// The shear between two surfaces: how it follows, within an increment, from the pressure and from the motion and deformation of
/// the bodies.
///
/// The shear is that on the lower body; on the upper body it acts in the opposite direction. All fields are on the contact grid;
/// x and y are the same axes for both bodies.
class Interface
{
public:
  explicit Interface(const Friction& friction) : friction_(friction) {}
  virtual ~Interface() = default;
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;

  [[nodiscard]] const Friction& friction() const { return friction_; }

  /// Pressure and displacements of both bodies at one moment.
  struct Bodies
  {
    std::span<const double> pressure;         ///< [Pa]
    std::span<const double> lower_x, upper_x; ///< residual and thermal displacement along x [m]
    std::span<const double> lower_y{}, upper_y{};
    double lower_columns = 0.0,
           upper_columns = 0.0;    ///< columns that the contact has moved on the bodies in the increment
    std::span<const double> gap{}; ///< [m]
  };
  /// Data of an increment at its beginning.
  struct Start
  {
    bool slides = true;             ///< if false, surfaces that slide everywhere bear no shear
    contact::TangentialDrive along; ///< see CoupledContact::advance
    std::vector<double> limit; ///< largest shear that the surfaces can carry in each cell before the increment [Pa]
    Bodies bodies;             ///< before the increment
    bool holds_law = false;    ///< see `renew`
    double tolerance = 0.0;    ///< of displacements [m]
    double approach = 0.0;     ///< largest approach of the bodies in the run [m]
    std::function<bool()> wants_stop{};
    std::optional<double> share_at_rest{}; ///< see Motion::share_at_rest
  };
  /// Largest changes made by an update.
  struct Change
  {
    double shear = 0.0; ///< [Pa]
    double gap = 0.0;   ///< [m]
    bool is_solved = true;
    bool is_overloaded = false; ///< friction cannot carry the imposed force
  };
  /// Pressure and shear under which slip begins in an increment [Pa]; empty where it begins under those at its end.
  struct Onset
  {
    std::vector<double> pressure, shear;
  };

  /// Unit vector along which an increment drives the surface of the lower body; zero: no direction.
  [[nodiscard]] virtual std::array<double, 2> direction(const contact::TangentialDrive& along) const = 0;
  virtual void begin(Start start) = 0;
  /// Replaces the largest shear that the surfaces can carry in each cell [Pa]: within an increment it follows their hardening.
  virtual void set_limit(std::vector<double> limit) = 0;
  /// Computes the shear for a pressure and, unless the slip is known, residual displacements, and the displacement that it adds to
  /// the gap.
  virtual Change follow(const Bodies& bodies) = 0;
  /// Coulomb's law does not derive from an energy. With `Start::holds_law` the bound of the shear, which follows the pressure, is
  /// held fixed, so that the remaining problem has an energy; this function updates the bound to the present pressure.
  /// @returns the changes of the shear that the surfaces may carry, and of the gap
  virtual Change renew(const Bodies& bodies) = 0;
  /// Contribution of the shear to the energy of the increment, apart from its work on residual displacements, with the law held
  /// [J].
  [[nodiscard]] virtual double held_energy() const = 0;
  /// Error of the gap that the shear tolerates [m]; smaller than usual where errors of the gap become errors of the slip.
  /// @param usual  tolerance of the gap without regard to shear [m]
  [[nodiscard]] virtual double tolerance_of_gap(double usual) const { return usual; }
  /// Adds to the gap the normal displacement due to the shear, if there is one [m].
  virtual void add_to_gap(std::span<double> gap) const = 0;
  /// Ends an increment.
  virtual void settle(const Bodies& bodies) = 0;
  /// After a failed increment: returns to the state before its beginning.
  virtual void restore() = 0;

  /// Along x and y; a part that never acts is empty [Pa].
  [[nodiscard]] virtual contact::ConstAlongSurface shears() const = 0;
  /// Whether the slip of an increment is known at its beginning: the surfaces slide everywhere.
  [[nodiscard]] virtual bool knows_slip() const = 0;
  /// Slip length in the current increment, where the surfaces slip on each other or part; 0 elsewhere [m].
  /// @param slid  sliding distance of the undeformed surfaces in the increment [m]
  [[nodiscard]] virtual std::vector<double> slip_length(double slid) const = 0;
  /// Pressure before the current increment, on the points that lie in each cell at its end [Pa].
  /// @param last  pressure on the points that lay there then [Pa]
  [[nodiscard]] virtual std::span<const double> pressure_before(std::span<const double> last) const { return last; }
  /// Of the slip in the current increment.
  [[nodiscard]] virtual Onset onset(std::span<const double> /*pressure*/) const { return {}; }
  /// Friction work per area in the current increment, by the trial, for the heat that acts back on it [J/m^2].
  [[nodiscard]] virtual std::vector<double> heat_of_trial(double slid) const = 0;
  /// Heat of friction per area in the increment, after `settle`, with that of points that left the contact [J/m^2].
  [[nodiscard]] virtual std::vector<double> heat_of_increment(double slid) const = 0;
  /// Mean of the shears before and after the last increment, of the points that lie in each cell, where they work on the thermal
  /// displacement along the surface [Pa]; empty elsewhere.
  [[nodiscard]] virtual std::array<std::vector<double>, 2> mean_shears() const { return {}; }

  /// Sum of the shears [N].
  [[nodiscard]] virtual std::array<double, 2> forces() const = 0;
  /// Elastic energy that the shear adds to that of the pressure, as of the last increment [J].
  [[nodiscard]] virtual double elastic_energy(std::span<const double> pressure) const = 0;
  /// Share of the cells under pressure whose shear is at the limit of the surface.
  [[nodiscard]] virtual double limited_share() const = 0;

  /// Everything that the next increment depends on.
  virtual void exchange(Archive& archive) = 0;
  /// Takes over the history of an interface of the same kind on a smaller contact grid with the same centre.
  virtual void embed(const Interface& smaller) = 0;
  /// Recomputes displacements after `embed`, once the bodies have been moved to larger grids.
  virtual void recall(const Bodies& bodies) = 0;

private:
  Friction friction_;
};

} // namespace brinell::elastoplastic
