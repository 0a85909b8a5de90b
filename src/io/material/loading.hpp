// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/measured_curve.hpp"

#include <string>
#include <vector>

namespace brinell::io
{

/// Points of a measured curve that load the specimen, as magnitudes, in ascending order of strain.
struct Loading
{
  Curve curve;
  bool is_compression = false;
};

/// Leaves out what is not part of the first loading: unloading, steps back, repeated strains, and, except with
/// CurveRules::keeps_points, the fall to fracture.
/// @throws InputError as hardening_curve()
[[nodiscard]] Loading loading_of(const Curve& measured, const CurveRules& rules, HardeningCurve& report);

/// Replaces engineering by true values.
/// @throws InputError as hardening_curve()
void make_true(Loading& loading);

/// Stresses that do not fall and have the least squares of deviations from the given ones (pool adjacent violators).
[[nodiscard]] std::vector<double> levelled(const std::vector<double>& stress);

} // namespace brinell::io
