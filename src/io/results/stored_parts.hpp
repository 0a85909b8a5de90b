// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/output_choice.hpp"
#include "brinell/simulation/scenario.hpp"

/// The part of the fields of a state that a result stores.
namespace brinell::io
{

/// The fields that are chosen, on the cells that are chosen; fields within the bodies are still computed on demand.
/// @param words  out of `field_words`
[[nodiscard]] simulation::StepFields chosen_fields(const simulation::StepFields& fields,
                                                   const std::vector<std::string>& words, const StoredParts& parts);

/// Number of cells of a grid that are stored, for an estimate: a region may lie beside the grid.
/// @param x0, y0  centre of cell (0, 0) [m]
[[nodiscard]] VolumeGrid stored_grid(const VolumeGrid& grid, double x0, double y0, const StoredCells& cells);

} // namespace brinell::io
