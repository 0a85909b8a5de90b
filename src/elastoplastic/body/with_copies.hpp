// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/body.hpp"

namespace brinell::elastoplastic
{

/// Calls use(cell, seen) for an active cell and, with symmetry, for its mirror image; the function `seen` converts a deviator of
/// the active cell to its value in that cell.
template <typename Use>
void Body::with_copies(std::size_t a, const Use& use) const
{
  use(active_.cell(a), [](const Deviator& d) { return d; });
  if (copies(a) == 2)
    use(mirrored_cell(grid().surface, active_.cell(a)), mirrored_in_y);
}

} // namespace brinell::elastoplastic
