// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <variant>
#include <vector>

/// Thermal softening: the factor on the yield stress as a function of the temperature [deg C]. The yield stress of the hardening
/// law corresponds to the factor 1. A law is an equality-comparable struct with
///   factor(temperature)  >= 0, before the lower limit of `softening_factor` is applied;
///   melting()            the melting temperature [deg C], if the law has one.
namespace brinell::constitutive
{

/// Linear decrease from 1 at the reference temperature to 0 at the melting point; 1 below, 0 above.
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

/// Linear interpolation between measured points, and therefore monotone where they are; constant outside their range.
class TabulatedSoftening
{
public:
  /// @param temperature  ascending [deg C], one or more.
  /// @param factor       > 0, one per temperature.
  /// @throws InputError
  TabulatedSoftening(std::vector<double> temperature, std::vector<double> factor);

  [[nodiscard]] double factor(double temperature) const;
  [[nodiscard]] std::optional<double> melting() const { return std::nullopt; }
  [[nodiscard]] double first() const { return temperature_.front(); } ///< temperature of the first point [deg C]
  [[nodiscard]] double last() const { return temperature_.back(); }   ///< temperature of the last point [deg C]
  bool operator==(const TabulatedSoftening&) const = default;

private:
  std::vector<double> temperature_, factor_;
};

using SofteningLaw = std::variant<LinearSoftening, JohnsonCookSoftening, TabulatedSoftening>;

/// Lower limit of the factor on the yield stress: the plastic flow of a solid with zero yield stress cannot be computed, and the
/// melt itself is not modelled. The code that computes temperatures warns where they exceed `melting_temperature`.
inline constexpr double least_softening_factor = 0.01;

/// Factor on the yield stress, not below `least_softening_factor`.
/// @param temperature  [deg C]
[[nodiscard]] double softening_factor(const SofteningLaw& law, double temperature);

/// Temperature at which a law has no yield stress left [deg C], if it has such a temperature.
[[nodiscard]] std::optional<double> melting_temperature(const SofteningLaw& law);

/// Whether a law is defined at this temperature; false where it extrapolates with the value at the end of its range.
[[nodiscard]] bool covers(const SofteningLaw& law, double temperature);

} // namespace brinell::constitutive
