// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/case_file.hpp"

#include <string>

namespace brinell::io
{

using ScenarioPlan = simulation::AnyPlan;

/// Memory available to this program [bytes]: that of the machine, or the limit of its control group if that is smaller.
[[nodiscard]] double machine_memory();

/// The plan of a case.
/// @param available_memory [bytes]
/// @throws InputError with place and value of the grid if it has an absurd number of cells or does not fit
[[nodiscard]] ScenarioPlan plan_case(const Case& c, double available_memory = machine_memory());

/// Parts that a run of the case stores: those of the case and, where it names none, as many as stay below 200 MB.
[[nodiscard]] StoredParts stored_parts(const Case& c, const ScenarioPlan& plan);

/// Size of the stored fields before compression, an estimate [bytes].
[[nodiscard]] double result_bytes(const Case& c, const ScenarioPlan& plan);

/// Warnings about the size of a result: that it is large, or that fields are left out to keep it small.
[[nodiscard]] std::vector<Warning> result_warnings(const Case& c, const ScenarioPlan& plan);

/// Which fields a run neither computes nor stores although the case does not say so, and how to get them; empty if none.
[[nodiscard]] std::string left_out_text(const Case& c, const ScenarioPlan& plan);

/// Warnings and expected errors of a case before it runs: its own warnings, and those about the resolution of its cells.
[[nodiscard]] std::vector<Warning> expected_warnings(const Case& c, const ScenarioPlan& plan);

/// Output of `brinell check`: the resolved case, and as comments its critical values, grids, steps, memory, rough cost and size
/// of the result. The whole output is again a case file.
[[nodiscard]] std::string check_report(const Case& c, const ScenarioPlan& plan);

/// Needs of several ranks that share a case, as comments of the resolved case: layers, memory, traffic and least time of a rank.
/// @param machines          over which the ranks are spread evenly
/// @param available_memory  of a machine [bytes]
/// @throws InputError if they need more than there is
[[nodiscard]] std::string ranks_report(const Case& c, const ScenarioPlan& plan, int ranks, int machines,
                                       double available_memory = machine_memory());

} // namespace brinell::io
