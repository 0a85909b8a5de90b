// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/indentation.hpp"
#include "brinell/simulation/sliding.hpp"

namespace brinell::simulation
{

/// The bodies of a sliding, only pressed together.
[[nodiscard]] IndentationCase pressing(const SlidingCase& sliding);

} // namespace brinell::simulation
