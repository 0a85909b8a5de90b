// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/contact_area.hpp"
#include "brinell/contact/contact_voltage.hpp"
#include "brinell/contact/punch.hpp"

#include <array>
#include <span>
#include <vector>

/// Current or heat that passes between two half spaces through their contact: docs/theory/electrical.md.
namespace brinell::contact
{

/// Flow of current through a contact under a voltage of 1 V between points far from it in the two bodies. With flux of heat,
/// temperature and 1/conductivity in place of density, potential and resistivity it is the conduction of heat.
struct Flow
{
  double conductance = 0.0; ///< [1/ohm]; 0 without contact, infinite where bodies touch everywhere, NaN if not found
  /// Solution on the cells [A/(V m^2)], which lacks some of the current at the edge; empty where bodies touch everywhere.
  std::vector<double> density;
  Patches patches;
  std::vector<double> of_patch; ///< current of each patch [A/V]; their sum is the conductance

  /// Mean density over each cell, whose sum is the current of each patch [A/(V m^2)].
  [[nodiscard]] std::vector<double> whole_density(double cell_area) const;
};

/// Spreading of a flow in two half spaces from their contact, B j = 1/(2 pi) integral of j/r, which is E'/2 times the surface
/// compliance (Barber 2003).
class Constriction
{
public:
  /// @param compliance  must outlive this object
  /// @param modulus     with which it was made [Pa]
  Constriction(const halfspace::SurfaceCompliance& compliance, double modulus)
      : Constriction(compliance, modulus, modulus)
  {
  }
  /// Of layered bodies, whose potential is not that of a displacement.
  /// @param conductors  SurfaceCompliance::of_conductors; must outlive this object
  /// @param tops        sum of the resistivities at both surfaces, which `flow` has to be given as the spreading [ohm m]
  /// @param modulus     of the contact [Pa]
  static Constriction of_layers(const halfspace::SurfaceCompliance& conductors, double tops, double modulus)
  {
    return {conductors, 2.0 / tops, modulus};
  }

  /// The contact, one value per cell.
  struct Contact
  {
    std::span<const double> pressure; ///< [Pa]
    std::span<const double> gap;      ///< [m]
  };
  /// Solves (S B + film) j = 1 V on the area. The current is corrected to first order for what the cells of the contact miss at
  /// its edge, where the density is singular: docs/theory/electrical.md (edge).
  /// @param spreading  sum S of the resistivities of the bodies [ohm m]
  /// @param film       area resistance between the surfaces [ohm m^2], >= 0, one per cell; empty: none
  /// @param density    in: a guess of `Flow::density`, or empty
  [[nodiscard]] Flow flow(const Contact& contact, double spreading, std::span<const double> film,
                          std::vector<double> density = {});

  /// Heat of a current through a contact with a film.
  struct Heat
  {
    std::vector<double> temperature; ///< of the contact area, the same in both surfaces [deg C]; 0 elsewhere
    /// Flux into each body of which temperature plus phi^2/(2 resistivity conductivity) is the steady one: the heat that enters
    /// plus the potential times the density [W/m^2].
    std::array<std::vector<double>, 2> flux;
  };
  /// The steady state.
  /// @param density  solution on the cells times the voltage [A/m^2]
  /// @param source   heat that arises between the surfaces [W/m^2], one per cell
  [[nodiscard]] Heat heat(std::span<const double> pressure, std::span<const double> density,
                          std::span<const double> source, const std::array<Conductor, 2>& bodies);

private:
  Constriction(const halfspace::SurfaceCompliance& compliance, double modulus, double modulus_of_contact);
  [[nodiscard]] std::vector<double> spread(std::span<const double> flux);
  void correct(Flow& flow, std::span<const double> pressure, double spreading, std::span<const double> film) const;

  const halfspace::SurfaceCompliance& compliance_;
  halfspace::SurfaceCompliance::Scratch scratch_;
  double modulus_, modulus_of_contact_;
  Punch punch_;
  std::vector<double> heat_into_lower_; ///< guess of the next solution [W/m^2]
};

} // namespace brinell::contact
