// SPDX-License-Identifier: BSD-3-Clause
#include "judgement_parts.hpp"

#include "brinell/green/stack.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

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

void warn_of_worn_coats(const Facts& facts, const simulation::RunTotals& totals, std::vector<Warning>& warnings)
{
  constexpr double noticed = 0.01; // change of the compliance, which changes the pressure by less
  constexpr double long_waves = 0.1;
  const std::array worn{totals.max_worn_depth_lower, totals.max_worn_depth_upper};
  const double half = std::max(facts.half_x, facts.is_plane ? 0.0 : facts.half_y),
               cell = facts.is_plane ? facts.cell[0] : std::min(facts.cell[0], facts.cell[1]);
  for (std::size_t side = 0; side < 2; ++side)
  {
    const constitutive::Material& material = *facts.materials[side];
    if (material.layers.empty() || worn[side] == 0.0)
      continue;
    const std::string name = side == 0 ? "lower" : "upper", depth = length_text(worn[side]);
    if (worn[side] >= material.layers.front().thickness)
    {
      warnings.push_back(
          {"worn_through", fmt::format("the {} surface has lost up to {}, and its first layer is {} thick: it is worn "
                                       "through, and nothing that is computed since then holds",
                                       name, depth, length_text(material.layers.front().thickness))});
      continue;
    }
    const ElasticStack stack = material.stack();
    const double change =
        green::change_of_compliance(stack, stack.without_top(worn[side]), long_waves / half, std::numbers::pi / cell);
    if (std::abs(change) > noticed)
      warnings.push_back(
          {"worn_coat",
           fmt::format("the {} surface has lost up to {}, {} of its first layer, but the layers keep their thickness: "
                       "the worn body gives way by up to {} {} than it is computed",
                       name, depth, percent_text(worn[side] / material.layers.front().thickness),
                       percent_text(std::abs(change)), change > 0.0 ? "more" : "less")});
  }
}

} // namespace brinell::quality
