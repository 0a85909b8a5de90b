// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/tugging.hpp"

namespace brinell::simulation
{

/// Work of the motion from one row to the next [J] (trapezoidal rule); none on the way back from pass to pass.
[[nodiscard]] double work_between(const TuggingRecord& before, const TuggingRecord& now);

/// Part of this work that is due to the shear [J].
[[nodiscard]] double friction_work_between(const TuggingRecord& before, const TuggingRecord& now);

/// Updates the key numbers with a row. The work of `now` must be set already.
void add(const TuggingRecord& before, const TuggingRecord& now, TuggingPeaks& peaks);

} // namespace brinell::simulation
