// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/user_hardening.hpp"
#include "brinell/foundation/host_device.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>
#include <vector>

/// Hardening laws: the yield stress as a function of the accumulated equivalent plastic strain e >= 0.
/// A law is an equality-comparable struct with three member functions,
///   yield_stress_at(e)  sigma_y(e) [Pa], > 0, non-decreasing;
///   modulus_at(e)       d sigma_y / d e [Pa], >= 0; may be infinite at e = 0;
///   work(e)             integral of sigma_y from 0 to e [J/m^3]: the potential of the increment's convex problem,
/// and one line in the variant below. The return mapping is the same for all. A user-defined law needs no such line: it is
/// passed as a `UserHardening`. How to add a law to the case file: docs/developer/hardening-laws.md.
namespace brinell::constitutive
{

/// sigma_y(e) = yield_stress.
struct PerfectPlasticity
{
  double yield_stress = 0.0; ///< [Pa], > 0

  [[nodiscard]] BRINELL_HOST_DEVICE double yield_stress_at(double /*e*/) const { return yield_stress; }
  [[nodiscard]] BRINELL_HOST_DEVICE double modulus_at(double /*e*/) const { return 0.0; }
  [[nodiscard]] BRINELL_HOST_DEVICE double work(double e) const { return yield_stress * e; }
  bool operator==(const PerfectPlasticity&) const = default;
};

/// sigma_y(e) = yield_stress + modulus * e.
struct LinearHardening
{
  double yield_stress = 0.0; ///< initial yield stress [Pa], > 0
  double modulus = 0.0;      ///< plastic modulus [Pa], >= 0

  [[nodiscard]] BRINELL_HOST_DEVICE double yield_stress_at(double e) const { return yield_stress + modulus * e; }
  [[nodiscard]] BRINELL_HOST_DEVICE double modulus_at(double /*e*/) const { return modulus; }
  [[nodiscard]] BRINELL_HOST_DEVICE double work(double e) const { return (yield_stress + 0.5 * modulus * e) * e; }
  bool operator==(const LinearHardening&) const = default;
};

/// sigma_y(e) = coefficient (offset + e)^exponent (Swift 1952).
struct SwiftHardening
{
  double coefficient = 0.0; ///< K [Pa], > 0
  double offset = 0.0;      ///< e_0 [-], > 0
  double exponent = 0.0;    ///< n, in [0, 1]

  [[nodiscard]] BRINELL_HOST_DEVICE double yield_stress_at(double e) const
  {
    return coefficient * std::pow(offset + e, exponent);
  }
  [[nodiscard]] BRINELL_HOST_DEVICE double modulus_at(double e) const
  {
    return coefficient * exponent * std::pow(offset + e, exponent - 1.0);
  }
  [[nodiscard]] BRINELL_HOST_DEVICE double work(double e) const
  {
    return coefficient / (exponent + 1.0) * (std::pow(offset + e, exponent + 1.0) - std::pow(offset, exponent + 1.0));
  }
  bool operator==(const SwiftHardening&) const = default;
};

/// Swift's law written as B (C + 1e6 e)^n, with the plastic strain in millionths (Jacq, Nelias, Lormand, Girodin 2002).
[[nodiscard]] inline SwiftHardening swift_of_microstrain(double B, double C, double n)
{
  return {B * std::pow(1e6, n), 1e-6 * C, n};
}

/// A power law K (e_0 + e)^n with a given initial yield stress S_y, e_0 = (S_y / K)^(1/n): the law K e^n of Hollomon (1945),
/// with the strain measured from the point where the curve reaches S_y.
[[nodiscard]] inline SwiftHardening hollomon(double yield_stress, double coefficient, double exponent)
{
  return {coefficient, std::pow(yield_stress / coefficient, 1.0 / exponent), exponent};
}

/// sigma_y(e) = yield_stress + coefficient * e^exponent (Ludwik 1909).
struct LudwikHardening
{
  double yield_stress = 0.0; ///< [Pa], > 0
  double coefficient = 0.0;  ///< [Pa], >= 0
  double exponent = 1.0;     ///< in (0, 1]

  [[nodiscard]] BRINELL_HOST_DEVICE double yield_stress_at(double e) const
  {
    return yield_stress + coefficient * std::pow(e, exponent);
  }
  [[nodiscard]] BRINELL_HOST_DEVICE double modulus_at(double e) const
  {
    return coefficient * exponent * std::pow(e, exponent - 1.0);
  }
  [[nodiscard]] BRINELL_HOST_DEVICE double work(double e) const
  {
    return yield_stress * e + coefficient / (exponent + 1.0) * std::pow(e, exponent + 1.0);
  }
  bool operator==(const LudwikHardening&) const = default;
};

/// sigma_y(e) = yield_stress + saturation (1 - exp(-rate * e)) (Voce 1948).
struct VoceHardening
{
  double yield_stress = 0.0; ///< [Pa], > 0
  double saturation = 0.0;   ///< largest rise of the yield stress [Pa], >= 0
  double rate = 0.0;         ///< [-], > 0

  [[nodiscard]] BRINELL_HOST_DEVICE double yield_stress_at(double e) const
  {
    return yield_stress - saturation * std::expm1(-rate * e);
  }
  [[nodiscard]] BRINELL_HOST_DEVICE double modulus_at(double e) const
  {
    return saturation * rate * std::exp(-rate * e);
  }
  [[nodiscard]] BRINELL_HOST_DEVICE double work(double e) const
  {
    return (yield_stress + saturation) * e + saturation / rate * std::expm1(-rate * e);
  }
  bool operator==(const VoceHardening&) const = default;
};

/// A law between measured points, without memory of its own: see TabulatedHardening.
struct HardeningTable
{
  const double *strain = nullptr, *stress = nullptr; ///< of `count` points
  const double* modulus = nullptr;                   ///< from this point to the next; 0 at the last
  const double* works = nullptr;                     ///< up to this point
  std::size_t count = 0;

  [[nodiscard]] BRINELL_HOST_DEVICE double yield_stress_at(double e) const
  {
    const std::size_t i = interval(e);
    return stress[i] + modulus[i] * (e - strain[i]);
  }
  [[nodiscard]] BRINELL_HOST_DEVICE double modulus_at(double e) const { return modulus[interval(e)]; }
  [[nodiscard]] BRINELL_HOST_DEVICE double work(double e) const
  {
    const std::size_t i = interval(e);
    const double beyond = e - strain[i];
    return works[i] + (stress[i] + 0.5 * modulus[i] * beyond) * beyond;
  }

private:
  /// The point at or before e.
  [[nodiscard]] BRINELL_HOST_DEVICE std::size_t interval(double e) const
  {
    return static_cast<std::size_t>(std::upper_bound(strain + 1, strain + count, e) - strain) - 1;
  }
};

/// Piecewise linear between measured points; constant beyond the last one.
class TabulatedHardening
{
public:
  /// @param plastic_strain  ascending from 0.
  /// @param stress          [Pa], > 0, non-decreasing, one per strain.
  /// @throws InputError
  TabulatedHardening(std::vector<double> plastic_strain, std::vector<double> stress);

  [[nodiscard]] double yield_stress_at(double e) const { return table().yield_stress_at(e); }
  [[nodiscard]] double modulus_at(double e) const { return table().modulus_at(e); }
  [[nodiscard]] double work(double e) const { return table().work(e); }
  /// View of the points, valid while this object is.
  [[nodiscard]] HardeningTable table() const
  {
    return {strain_.data(), stress_.data(), modulus_.data(), work_.data(), strain_.size()};
  }
  bool operator==(const TabulatedHardening&) const = default;

private:
  std::vector<double> strain_, stress_;
  std::vector<double> modulus_; ///< from this point to the next; 0 at the last
  std::vector<double> work_;    ///< up to this point
};

using HardeningLaw = std::variant<PerfectPlasticity, LinearHardening, SwiftHardening, LudwikHardening, VoceHardening,
                                  TabulatedHardening, UserHardening>;

/// A law multiplied by a constant factor: the same material, harder or softer.
template <typename Law>
struct ScaledLaw
{
  const Law& law;
  double factor = 1.0; ///< > 0

  [[nodiscard]] BRINELL_HOST_DEVICE double yield_stress_at(double e) const { return factor * law.yield_stress_at(e); }
  [[nodiscard]] BRINELL_HOST_DEVICE double modulus_at(double e) const { return factor * law.modulus_at(e); }
  [[nodiscard]] BRINELL_HOST_DEVICE double work(double e) const { return factor * law.work(e); }
};

/// Yield stress of the virgin material [Pa].
[[nodiscard]] inline double initial_yield_stress(const HardeningLaw& law)
{
  return std::visit([](const auto& l) { return l.yield_stress_at(0.0); }, law);
}

} // namespace brinell::constitutive
