// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "quality_cases.hpp"

#include <cmath>
#include <optional>
#include <string_view>

/// What a result states of the error of a quantity.
namespace brinell::quality
{

inline std::optional<ExpectedError> find_stated(const Quality& quality, std::string_view quantity)
{
  for (const ExpectedError& e : quality.resolution.expected_errors)
    if (e.quantity == quantity)
      return e;
  return std::nullopt;
}

/// The expected error of a quantity, NaN if none is stated.
inline double stated_error(const Quality& quality, std::string_view quantity)
{
  return find_stated(quality, quantity).value_or(ExpectedError{"", "", std::nan("")}).relative;
}

/// Of a run with so many cells and layers.
inline RunTotals totals(int cells_per_radius, int layers)
{
  RunTotals t;
  t.coverage = {2 * cells_per_radius, 2 * cells_per_radius, layers};
  t.max_equivalent_plastic_strain = 0.01;
  t.max_residual_lower = 1e-7;
  t.energy_balance_error = 1e-3;
  return t;
}

} // namespace brinell::quality
