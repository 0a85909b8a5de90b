// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/fretting.hpp"
#include "brinell/simulation/indentation.hpp"
#include "brinell/simulation/rolling.hpp"
#include "brinell/simulation/sliding.hpp"
#include "brinell/simulation/tugging.hpp"

#include <functional>
#include <variant>

namespace brinell::simulation
{

/// The cases of all scenarios, as arguments of a template. This is the only list of scenarios: all code that treats every
/// scenario, for files, messages and Python, is generated from it.
template <template <typename...> typename Of>
using Scenarios = Of<TuggingCase, IndentationCase, RollingCase, FrettingCase, SlidingCase>;

template <typename... Case>
using PlansOf = std::variant<typename Case::Plan...>;
template <typename... Case>
using RecordsOf = std::variant<std::reference_wrapper<const typename Case::Record>...>;
template <typename... Case>
using SummariesOf = std::variant<std::reference_wrapper<const typename Case::Summary>...>;

/// A case, a plan, a row or a summary of any scenario; rows and summaries by reference.
using AnyCase = Scenarios<std::variant>;
using AnyPlan = Scenarios<PlansOf>;
using AnyRecord = Scenarios<RecordsOf>;
using AnySummary = Scenarios<SummariesOf>;

} // namespace brinell::simulation
