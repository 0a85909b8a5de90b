// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

/// Least squares for measured curves.
namespace brinell::io
{

/// y = intercept + slope x.
struct FittedLine
{
  double intercept = 0.0, slope = 0.0;
  double squares = 0.0; ///< sum of the squared deviations in y
};

/// The line with the least squares; none if all x are equal.
[[nodiscard]] std::optional<FittedLine> fitted_line(std::span<const double> x, std::span<const double> y);

/// A hardening law fitted to points.
struct FittedLaw
{
  std::string formula;                  ///< with its numbers
  double deviation = 0.0;               ///< root mean square deviation of the stresses [Pa]
  std::function<double(double)> stress; ///< [Pa] at a plastic strain
};

/// The law that fits best of those of Swift, Ludwik and Voce.
/// @param strain  plastic strains, > 0, at least 5
/// @param stress  [Pa], > 0
[[nodiscard]] FittedLaw best_law(std::span<const double> strain, std::span<const double> stress);

} // namespace brinell::io
