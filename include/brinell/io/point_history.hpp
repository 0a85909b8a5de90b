// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/history_csv.hpp"
#include "brinell/io/output_choice.hpp"
#include "brinell/simulation/scenario.hpp"

/// Histories at points within the bodies: points.csv and the group /points of a result.
namespace brinell::io
{

/// The columns of a point at a step, with the values of no point.
[[nodiscard]] std::vector<NamedNumber> point_columns();

/// The rows of the points at a step, in the order of the points: the values of the cells in which they lie, NaN beyond the grids.
[[nodiscard]] std::vector<std::vector<NamedNumber>> point_rows(const std::vector<HistoryPoint>& points, int step,
                                                               const simulation::StepFields& fields);

} // namespace brinell::io
