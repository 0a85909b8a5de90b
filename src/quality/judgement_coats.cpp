// SPDX-License-Identifier: BSD-3-Clause
#include "judgement_parts.hpp"

#include <fmt/format.h>

/// Warnings about layers on the bodies.
namespace brinell::quality
{

bool warn_of_coats(const Facts& facts, std::vector<Warning>& warnings)
{
  constexpr double least_cells = 4.0;
  bool found = false;
  for (std::size_t side = 0; side < 2; ++side)
  {
    const constitutive::Material& material = *facts.materials[side];
    for (std::size_t coat = 0; coat < material.layers.size() && material.is_plastic(); ++coat)
      if (const double cells = material.layers[coat].thickness / facts.cell[2]; cells < 0.999 * least_cells)
      {
        found = true;
        warnings.push_back(
            {"coarse_coat",
             fmt::format(
                 "layer {} of the {} body is {} thick, {:.2g} layers of cells; its plastic strain is coarse with "
                 "less than {:g}, and no expected errors are stated: use thinner cells (grid.resolution)",
                 coat + 1, side == 0 ? "lower" : "upper", length_text(material.layers[coat].thickness), cells,
                 least_cells)});
      }
  }
  return found;
}

} // namespace brinell::quality
