// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"
#include "summary_parts.hpp"

#include <string>

namespace brinell::io
{

/// Adds the key numbers of the fatigue of both bodies, if it was computed.
void put_fatigue(Json& json, const Case& c, const simulation::RunTotals& s);

/// Lines about fatigue for a terminal; empty without.
[[nodiscard]] std::string fatigue_text(const simulation::RunTotals& s);

} // namespace brinell::io
