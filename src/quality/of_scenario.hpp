// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenarios.hpp"
#include "judgement.hpp"

/// Quality of the results of a scenario, whose file supplies the facts.
namespace brinell::quality
{

using namespace simulation; // the results that this floor judges

/// The known results of a run: none before it.
template <typename Case>
struct Seen
{
  const RunTotals* totals = nullptr;
  const typename Case::Summary* summary = nullptr; ///< not of a run of which only the totals are known
};

/// Facts about a run, before it or after it. Specialised for each scenario.
template <typename Case>
[[nodiscard]] Facts facts(const Case& c, const typename Case::Plan& plan, const Seen<Case>& seen);

template <typename Case>
Quality expected(const Case& c, const typename Case::Plan& plan)
{
  return quality_before(facts<Case>(c, plan, {}));
}

template <typename Case>
Quality judged(const Case& c, const typename Case::Plan& plan, const RunTotals& totals)
{
  return quality_after(facts<Case>(c, plan, {&totals}), totals);
}

template <typename Case>
Quality judged(const Case& c, const typename Case::Plan& plan, const typename Case::Summary& summary)
{
  return quality_after(facts<Case>(c, plan, {&summary, &summary}), summary);
}

} // namespace brinell::quality
