// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/indentation.hpp"
#include "brinell/simulation/sliding.hpp"

namespace brinell::simulation
{

/// A sliding case reduced to an indentation that only presses the bodies together.
[[nodiscard]] IndentationCase pressing(const SlidingCase& sliding);

} // namespace brinell::simulation
