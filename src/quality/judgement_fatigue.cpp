// SPDX-License-Identifier: BSD-3-Clause
#include "judgement_fatigue.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace brinell::quality
{

namespace
{

constexpr std::array judged_bodies{"lower", "upper"};

/// Discretization error of the largest orthogonal shear with 8 cells per contact radius, and of the second order.
constexpr double shear_error = 0.012, table_cells = 8.0;

void warn_of_body(const simulation::FatigueSummary& body, const char* name, std::vector<Warning>& warnings)
{
  constexpr double much_in_first_layer = 0.3, large_path_error = 0.05, long_life = 1.05;
  if (body.cycle == 1 && body.plastic_strain > 0.0)
    warnings.push_back({"fatigue_first_cycle",
                        fmt::format("fatigue of the {} body is judged in its first cycle, in which it still adapts by "
                                    "yielding; several cycles show whether it shakes down",
                                    name)});
  if (body.share_of_first_layer > much_in_first_layer)
    warnings.push_back({"fatigue_life_of_surface",
                        fmt::format("{:.0f} % of the stress-volume of the {} body lies in the first layer, where the "
                                    "division by a power of the depth makes it depend on the layers; the life is not "
                                    "one under the surface",
                                    100.0 * body.share_of_first_layer, name)});
  if (body.is_own_reference && body.life > long_life)
    warnings.push_back({"fatigue_reference",
                        fmt::format("the median of the columns of the {} body, to which its life refers, has a larger "
                                    "stress-volume than their mean, so that the life is {:.3g}: half of the track is "
                                    "not as it is elsewhere; give a reference or a longer way",
                                    name, body.life)});
  if (body.path_error > large_path_error)
    warnings.push_back({"fatigue_path", fmt::format("so many steps of the stress history of the {} body were left out "
                                                    "that its shear amplitudes may be wrong by up to {:.2g} of the "
                                                    "orthogonal shear",
                                                    name, body.path_error)});
  const simulation::FatiguePlace& worst = body.utilisation ? *body.utilisation : body.orthogonal_shear;
  if (worst.is_at_edge)
    warnings.push_back(
        {"fatigue_edge", fmt::format("the worst point of the {} body lies at the edge of its grid, at x = "
                                     "{:.4g} m, y = {:.4g} m, depth {:.4g} m; worse ones may lie beyond",
                                     name, worst.x, worst.y, worst.depth)});
  if (body.is_short)
    warnings.push_back(
        {"fatigue_short_pass", fmt::format("the contact has passed no point of the {} body as a whole in "
                                           "the cycle that is judged; fatigue is that of all points, and "
                                           "there is no life; a longer way gives both",
                                           name)});
}

} // namespace

void judge_fatigue(const simulation::RunTotals& totals, Quality& quality)
{
  bool is_there = false;
  for (std::size_t side = 0; side < 2; ++side)
    if (const std::optional<simulation::FatigueSummary>& body = totals.fatigue[side])
    {
      warn_of_body(*body, judged_bodies[side], quality.warnings);
      is_there = true;
    }
  const double cells = quality.resolution.cells;
  if (!is_there || quality.resolution.expected_errors.empty() || !(cells > 0.0))
    return;
  quality.resolution.expected_errors.push_back(
      {.quantity = "orthogonal shear",
       .name = "fatigue.*.orthogonal_shear.value_Pa",
       .relative = std::min(1.0, shear_error * std::pow(table_cells / cells, 2.0))});
}

} // namespace brinell::quality
