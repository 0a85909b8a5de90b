// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/tangential_contact.hpp"
#include "brinell/foundation/archive.hpp"

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
      shear_limit{}; ///< that a surface can carry [Pa], > 0; none: the shear strength of the softer one
  /// Whether the shear moves the gap where the materials differ.
  bool coupling = true;

  bool operator==(const Friction&) const = default;
};

/// The shear between two surfaces: how it follows, within an increment, from the pressure and from what the bodies do.
///
/// The shear is that on the lower body; on the upper body it acts the other way. All fields are on the contact grid, x and y are
/// the same axes for both bodies.
class Interface
{
public:
  explicit Interface(const Friction& friction) : friction_(friction) {}
  virtual ~Interface() = default;
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;

  [[nodiscard]] const Friction& friction() const { return friction_; }

  /// What is known of both bodies at a moment.
  struct Bodies
  {
    std::span<const double> pressure;         ///< [Pa]
    std::span<const double> lower_x, upper_x; ///< residual displacement along x [m]
    std::span<const double> lower_y{}, upper_y{};
    double lower_columns = 0.0, upper_columns = 0.0; ///< by which the contact has moved on the bodies in the increment
  };
  /// How an increment begins.
  struct Start
  {
    bool slides = true;             ///< without it there is no shear between surfaces that slide everywhere
    contact::TangentialDrive along; ///< see CoupledContact::advance
    std::vector<double> limit;      ///< that the surfaces can carry in each cell [Pa]
    Bodies bodies;                  ///< before the increment
    bool holds_law = false;         ///< see `renew`
    double tolerance = 0.0;         ///< of displacements [m]
    double approach = 0.0;          ///< of the bodies, the largest of the run [m]
    std::function<bool()> wants_stop{};
  };
  /// By how much a quantity changed at most.
  struct Change
  {
    double shear = 0.0; ///< [Pa]
    double gap = 0.0;   ///< [m]
    bool is_solved = true;
    bool is_overloaded = false; ///< friction cannot carry the force that is imposed
  };

  /// Unit vector along which an increment drives the surface of the lower body; zero: no direction.
  [[nodiscard]] virtual std::array<double, 2> direction(const contact::TangentialDrive& along) const = 0;
  virtual void begin(Start start) = 0;
  /// Whether `follow` needs the residual displacements.
  [[nodiscard]] virtual bool follows_displacement() const = 0;
  /// Sets the shear that belongs to a pressure and to residual displacements, and what it adds to the gap.
  virtual Change follow(const Bodies& bodies) = 0;
  /// Coulomb's law has no energy. Where `Start::holds_law`, what of it follows the pressure is held, so that the rest has one;
  /// this brings it up to date.
  /// @returns by how much that changed what the surfaces may carry, and the gap
  virtual Change renew(const Bodies& bodies) = 0;
  /// What the energy of the increment has of the shear besides its work on residual displacements, the law being held [J].
  [[nodiscard]] virtual double held_energy() const = 0;
  /// Whether shear moves the gap.
  [[nodiscard]] virtual bool moves_gap() const = 0;
  /// What the shear asks of the gap, if it is so small that errors of the gap matter to it [m].
  /// @param usual  largest error of the gap, that of `Start`
  [[nodiscard]] virtual double tolerance_of_gap(double usual) const { return usual; }
  /// Adds what the shear adds to the gap [m].
  virtual void add_to_gap(std::span<double> gap) const = 0;
  /// Ends an increment.
  virtual void settle(const Bodies& bodies) = 0;
  /// The increment has failed: as it was before it began.
  virtual void restore() = 0;

  /// Along x and y; a part that never acts is empty [Pa].
  [[nodiscard]] virtual contact::ConstAlongSurface shears() const = 0;
  /// Sum of the shears [N].
  [[nodiscard]] virtual std::array<double, 2> forces() const = 0;
  /// Elastic energy that the shear adds to that of the pressure, as of the last increment [J].
  [[nodiscard]] virtual double elastic_energy(std::span<const double> pressure) const = 0;
  /// Share of the cells under pressure whose shear is at the limit of the surface.
  [[nodiscard]] virtual double limited_share() const = 0;

  /// Everything that the next increment depends on.
  virtual void exchange(Archive& archive) = 0;
  /// Takes over the history of an interface of the same kind on a smaller contact grid with the same middle.
  virtual void embed(const Interface& smaller) = 0;
  /// The bodies have been moved to larger grids after `embed`.
  virtual void recall(const Bodies& bodies) = 0;

private:
  Friction friction_;
};

} // namespace brinell::elastoplastic
