// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <variant>
#include <vector>

/// Thermal softening: the factor on the yield stress by the temperature [deg C]. The yield stress of the hardening law is the
/// one to which the factor 1 belongs. A law is a struct that can be compared, with
///   factor(temperature)  >= 0, before the floor of `softening_factor`;
///   melting()            where it ends, if it knows.
namespace brinell::constitutive
{

/// On a straight line from 1 at the reference temperature to 0 at melting; 1 below, 0 above.
struct LinearSoftening
{
  double reference = 20.0;    ///< [deg C]
  double melting_point = 0.0; ///< [deg C], > reference

  [[nodiscard]] double factor(double temperature) const;
  [[nodiscard]] std::optional<double> melting() const { return melting_point; }
  bool operator==(const LinearSoftening&) const = default;
};

/// 1 - ((T - T_ref)/(T_melt - T_ref))^m between T_ref and T_melt; 1 below, 0 above (Johnson and Cook 1983).
struct JohnsonCookSoftening
{
  double reference = 20.0;    ///< T_ref [deg C]
  double melting_point = 0.0; ///< T_melt [deg C], > T_ref
  double exponent = 1.0;      ///< m, > 0

  [[nodiscard]] double factor(double temperature) const;
  [[nodiscard]] std::optional<double> melting() const { return melting_point; }
  bool operator==(const JohnsonCookSoftening&) const = default;
};

/// Linear between measured points, and therefore monotone where they are; constant outside them.
class TabulatedSoftening
{
public:
  /// @param temperature  ascending [deg C], one or more.
  /// @param factor       > 0, as many.
  /// @throws InputError
  TabulatedSoftening(std::vector<double> temperature, std::vector<double> factor);

  [[nodiscard]] double factor(double temperature) const;
  [[nodiscard]] std::optional<double> melting() const { return std::nullopt; }
  [[nodiscard]] double first() const { return temperature_.front(); } ///< temperature of the first point [deg C]
  [[nodiscard]] double last() const { return temperature_.back(); }   ///< and of the last one
  bool operator==(const TabulatedSoftening&) const = default;

private:
  std::vector<double> temperature_, factor_;
};

using SofteningLaw = std::variant<LinearSoftening, JohnsonCookSoftening, TabulatedSoftening>;

/// What is left of the yield stress however hot it gets: a solid without any has no plastic flow that could be computed, and the
/// melt itself is not modelled. Who computes temperatures tells where they pass `melting_temperature`.
inline constexpr double least_softening_factor = 0.01;

/// Factor on the yield stress, not below `least_softening_factor`.
/// @param temperature  [deg C]
[[nodiscard]] double softening_factor(const SofteningLaw& law, double temperature);

/// Where a law says that the yield stress is gone [deg C].
[[nodiscard]] std::optional<double> melting_temperature(const SofteningLaw& law);

/// Whether a law knows this temperature, or holds the value of the nearest one that it knows.
[[nodiscard]] bool covers(const SofteningLaw& law, double temperature);

} // namespace brinell::constitutive
