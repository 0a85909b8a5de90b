// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace brinell::elastoplastic
{

/// A linear operator on a field: out is overwritten.
using FieldOperator = std::function<void(std::span<const double> in, std::span<double> out)>;

/// Solves A x = b in the cells where `pressed`; elsewhere x = 0 and the equation is not imposed. A need not be symmetric: a
/// moving flux heats the material behind it. Method: stabilised biconjugate gradients (van der Vorst 1992), started from the
/// given x.
/// @param tolerance  largest |b - A x| in the pressed cells
/// @returns whether it was reached
[[nodiscard]] bool solve_in_cells(const FieldOperator& A, std::span<const double> b, const std::vector<bool>& pressed,
                                  double tolerance, std::vector<double>& x);

} // namespace brinell::elastoplastic
