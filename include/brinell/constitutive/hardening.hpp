// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>

/// Hardening laws: the yield stress as a function of the accumulated equivalent plastic strain e >= 0.
/// A law is a struct that can be compared, with three members,
///   yield_stress_at(e)  sigma_y(e) [Pa], > 0, non-decreasing;
///   modulus_at(e)       d sigma_y / d e [Pa], >= 0;
///   work(e)             integral of sigma_y from 0 to e [J/m^3]: the potential of the increment's convex problem,
/// and one line in the variant below. The return mapping is the same for all.
namespace brinell::constitutive
{

/// sigma_y(e) = yield_stress.
struct PerfectPlasticity
{
  double yield_stress = 0.0; ///< [Pa], > 0

  [[nodiscard]] double yield_stress_at(double /*e*/) const { return yield_stress; }
  [[nodiscard]] double modulus_at(double /*e*/) const { return 0.0; }
  [[nodiscard]] double work(double e) const { return yield_stress * e; }
  bool operator==(const PerfectPlasticity&) const = default;
};

/// sigma_y(e) = yield_stress + modulus * e.
struct LinearHardening
{
  double yield_stress = 0.0; ///< initial yield stress [Pa], > 0
  double modulus = 0.0;      ///< plastic modulus [Pa], >= 0

  [[nodiscard]] double yield_stress_at(double e) const { return yield_stress + modulus * e; }
  [[nodiscard]] double modulus_at(double /*e*/) const { return modulus; }
  [[nodiscard]] double work(double e) const { return (yield_stress + 0.5 * modulus * e) * e; }
  bool operator==(const LinearHardening&) const = default;
};

using HardeningLaw = std::variant<PerfectPlasticity, LinearHardening>;

/// Yield stress of the virgin material [Pa].
[[nodiscard]] inline double initial_yield_stress(const HardeningLaw& law)
{
  return std::visit([](const auto& l) { return l.yield_stress_at(0.0); }, law);
}

} // namespace brinell::constitutive
