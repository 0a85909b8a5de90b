// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>

/// Steady temperature of a contact through which current flows: docs/theory/electrical.md (contact-voltage). Without a film it
/// does not depend on the shape of the contact (Kohlrausch 1900); with one that holds for spots that are equally hot everywhere.
namespace brinell::contact
{

/// Lorenz number of Wiedemann and Franz [V^2/K^2].
inline constexpr double lorenz_number = 2.44e-8;

/// Resistivity and thermal conductivity of a body at each temperature.
struct HotConductor
{
  double resistivity = 0.0;             ///< at 20 deg C [ohm m]
  double temperature_coefficient = 0.0; ///< of the resistivity, of that at 20 deg C [1/K]
  std::optional<double> conductivity{}; ///< [W/(m K)]; none: that of Wiedemann and Franz at each temperature
  double temperature = 20.0;            ///< far away [deg C]

  /// @param t  [deg C]
  [[nodiscard]] double resistivity_at(double t) const;  ///< [ohm m]
  [[nodiscard]] double conductivity_at(double t) const; ///< [W/(m K)]
  /// The temperature up to which the integral of conductivity times resistivity, from the temperature far away, has a value
  /// [deg C]; NaN if there is none.
  /// @param kirchhoff  the value [V^2]
  [[nodiscard]] double temperature_at(double kirchhoff) const;
};

/// A contact that is heated by its current.
struct HotContact
{
  double voltage = 0.0;   ///< between points far from the contact [V]
  double flow = 0.0;      ///< current over the factor of shape; without a film that is 2 K/E' of the contact area [A/m]
  double interface = 0.0; ///< temperature of the contact area [deg C]
  double temperature = 0.0; ///< largest temperature; of unlike bodies, inside the worse conductor [deg C]
  /// Potential of the contact area in the lower and the upper body, which differ by the film; far away in the upper one it is 0 [V].
  std::array<double, 2> contact{};
  double hottest = 0.0; ///< potential at the largest temperature [V]
};

/// @param voltage  >= 0 [V]
/// @param film     resistance of the film times the factor of shape [ohm m]
[[nodiscard]] HotContact hot_contact(const std::array<HotConductor, 2>& bodies, double voltage, double film = 0.0);

/// The contact through which a current flows; none if there is no steady state below 1e5 K.
/// @param flow  current over the factor of shape, >= 0 [A/m]
[[nodiscard]] std::optional<HotContact> hot_contact_of_current(const std::array<HotConductor, 2>& bodies, double flow,
                                                               double film = 0.0);

/// Constants of a body with which the current, the voltage and the heat of the hot contact are those of its resistivity and
/// conductivity at each temperature.
struct Conductor
{
  double resistivity = 0.0;  ///< [ohm m]
  double conductivity = 0.0; ///< [W/(m K)]
  double temperature = 0.0;  ///< far away [deg C]
};
/// @param body  0: lower, 1: upper
[[nodiscard]] Conductor as_constant(const std::array<HotConductor, 2>& bodies, const HotContact& contact,
                                    std::size_t body);

/// Temperature where the potential of a body has gone a share of the way from its value far away to that of the contact area
/// [deg C].
/// @param body   0: lower, 1: upper
/// @param share  0 to 1
[[nodiscard]] double temperature_in(const std::array<HotConductor, 2>& bodies, const HotContact& contact,
                                    std::size_t body, double share);

} // namespace brinell::contact
