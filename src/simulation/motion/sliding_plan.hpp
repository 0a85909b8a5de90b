// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/indentation.hpp"
#include "brinell/simulation/sliding.hpp"

namespace brinell::simulation
{

inline constexpr double finest_press = 1.0 / 64; ///< shortest piece of a step that does not slide

/// A sliding case reduced to an indentation that only presses the bodies together.
[[nodiscard]] IndentationCase pressing(const SlidingCase& sliding);

} // namespace brinell::simulation
