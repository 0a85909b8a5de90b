// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/body.hpp"
#include "with_copies.hpp"

/// Symmetry of a body: docs/theory/elastoplastic.md, section Symmetry.
namespace brinell::elastoplastic
{

std::size_t Body::independent_cells() const
{
  return grid().surface.index(0, independent_rows(grid().surface, symmetry_));
}

void Body::complete_trial()
{
  find_displacement_x();
  if (!is_plastic() || symmetry_ == Symmetry::none)
    return;
  for (std::size_t a = 0; a < active_.size(); ++a)
  {
    const Deviator strain = deviator_at(state_.plastic_strain, grid().size(), active_.cell(a));
    with_copies(a, [&](std::size_t cell, const auto& seen)
                { store(seen(strain), state_.plastic_strain, grid().size(), cell); });
  }
  const std::size_t layer = grid().surface.size();
#pragma omp parallel for schedule(static)
  for (std::size_t plane = 0; plane < stress_.size() / layer; ++plane)
    complete_in_y(grid().surface, is_odd_in_y(static_cast<int>(plane) / grid().nz) ? -1.0 : 1.0,
                  stress_.data() + plane * layer, layer);
}

} // namespace brinell::elastoplastic
