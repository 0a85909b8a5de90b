// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/tugging.hpp"

namespace brinell::simulation
{

/// Work of the motion from one row to the next [J] (trapezoidal rule); none on the way back from pass to pass.
[[nodiscard]] double work_between(const TuggingRecord& before, const TuggingRecord& now);

/// The share of the shear in it [J].
[[nodiscard]] double friction_work_between(const TuggingRecord& before, const TuggingRecord& now);

/// Gathers the key numbers while the rows come in. The work of `now` is known.
void add(const TuggingRecord& before, const TuggingRecord& now, TuggingPeaks& peaks);

} // namespace brinell::simulation
