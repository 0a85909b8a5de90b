// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/green/elastic_stack.hpp"

#include <functional>
#include <optional>
#include <vector>

/// Frictionless contact of round bodies with bonded elastic layers, from dual integral equations: docs/theory/stacks.md
/// (coated-contact).
namespace brinell::reference
{

/// Contact of two smooth bodies, each a half space with or without layers, that are a sphere and a flat, or two spheres.
///
/// On the circle r < a the waves of the pressure are (E'/2) A(k) with A(k) = integral_0^a phi(t) cos(k t) dt, which leaves r > a free
/// of pressure (Sneddon 1951); the displacement on the circle gives a Fredholm equation of the second kind for phi, whose kernel is
/// the compliance of the layers without that of their uppermost ones (Lebedev, Ufliand 1958; Yu, Sanday, Rath 1990). phi is a sum
/// of even Legendre polynomials, whose cosine transforms are spherical Bessel functions.
class CoatedContact
{
public:
  /// @param radius          equivalent radius R, 1/R = 1/R1 + 1/R2 [m], > 0
  /// @param contact_radius  a [m], > 0
  /// @param lower, upper    one of them may be rigid
  /// @throws InputError for other values, and if a first layer is thinner than `thinnest` contact radii
  CoatedContact(double radius, double contact_radius, const ElasticStack& lower, const ElasticStack& upper);
  static constexpr double thinnest = 0.02; ///< of thinner layers the pressure at the edge is not resolved
  /// The contact under a load [N], or at an approach [m], > 0.
  /// @throws InputError as above, also if a first layer is too thin for that contact
  [[nodiscard]] static CoatedContact at_load(double radius, double load, const ElasticStack& lower,
                                             const ElasticStack& upper);
  [[nodiscard]] static CoatedContact at_approach(double radius, double approach, const ElasticStack& lower,
                                                 const ElasticStack& upper);

  [[nodiscard]] double contact_radius() const { return contact_radius_; } ///< [m]
  [[nodiscard]] double approach() const { return approach_; }             ///< of distant points [m]
  [[nodiscard]] double load() const;                                      ///< [N]
  /// dP / d(approach) [N/m]: the load on a flat punch of the contact radius per unit of its displacement.
  [[nodiscard]] double stiffness() const;
  [[nodiscard]] double pressure(double r) const; ///< [Pa]; zero for r >= a
  /// Wave of the pressure, integral_0^a p(r) J0(k r) r dr [N].
  [[nodiscard]] double wave_of_pressure(double k) const;

private:
  double contact_radius_;
  double modulus_; ///< E' of the surfaces
  double approach_ = 0.0;
  std::vector<double> phi_, punch_; ///< coefficients of P_0, P_2, ... of t/a; punch: of a flat punch per displacement
};

/// A stress of a coated contact, where it is largest compared with a strength.
struct CoatedPeak
{
  double ratio = 0.0;          ///< von Mises stress over the strength
  double r = 0.0, depth = 0.0; ///< [m]
  std::size_t layer = 0;       ///< the number of layers: the substrate
};

/// Where the von Mises stress in one body is largest compared with its strength, within 1.2 contact radii of the axis and 2.5 in
/// depth, and at the top of each deeper layer; at an interface both sides count. Its error is about 0.5 %: points are 0.05 contact
/// radii apart in depth and 0.1 along r, and the uppermost are a quarter of the first layer, at most 0.02 contact radii, beneath the
/// surface.
/// @param strength  yield stress [Pa] of a layer at a depth [m]; infinite where a layer stays elastic
[[nodiscard]] CoatedPeak peak_stress(const CoatedContact& contact, const ElasticStack& body,
                                     const std::function<double(std::size_t layer, double depth)>& strength);

/// First yield of a coated contact.
struct CoatedYield
{
  double load = 0.0;           ///< [N]
  double approach = 0.0;       ///< [m]
  double contact_radius = 0.0; ///< [m]
  double peak_pressure = 0.0;  ///< on the axis [Pa]
  bool in_upper = false;       ///< the body that yields
  CoatedPeak place;            ///< where the ratio is 1
};

/// The contact at which the first of two bodies yields somewhere; empty if none does up to a contact that is 1/`thinnest` times as
/// wide as the thinnest first layer, or wider than the radius.
/// @param lower_strength, upper_strength  as for `peak_stress`; empty: the body stays elastic
[[nodiscard]] std::optional<CoatedYield>
coated_first_yield(double radius, const ElasticStack& lower, const ElasticStack& upper,
                   const std::function<double(std::size_t, double)>& lower_strength,
                   const std::function<double(std::size_t, double)>& upper_strength);

} // namespace brinell::reference
