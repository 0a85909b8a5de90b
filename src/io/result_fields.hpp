// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/history_csv.hpp"
#include "hdf5.hpp"

namespace brinell::io
{

/// Writes the fields of one step into a group, and its row of the history as attributes, as
/// docs/reference/results-format.md says.
/// @throws IoError; InternalError if a field does not fit its grid
void write_snapshot(const h5::Handle& group, const std::vector<NamedNumber>& columns,
                    const simulation::Snapshot& snapshot);

} // namespace brinell::io
