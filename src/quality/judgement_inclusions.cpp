// SPDX-License-Identifier: BSD-3-Clause
#include "judgement_parts.hpp"

#include <fmt/format.h>

/// Warnings about inclusions of the bodies.
namespace brinell::quality
{

namespace
{

constexpr double fewest_cells_of_inclusion = 3.0; ///< along the smallest semi-axis

/// Error of the equivalent strain of an inclusion, of first order in the cells: docs/theory/inclusions.md (six cells).
double error_of_inclusion(const simulation::EmbeddedCells& found)
{
  constexpr double of_void = 0.04, of_rigid = 0.03, usual = 0.02, extreme = 0.99, cells = 6.0;
  const double error = found.contrast > extreme ? of_void : found.contrast < -extreme ? of_rigid : usual;
  return error * cells / found.least;
}

} // namespace

bool has_inclusions(const Facts& facts)
{
  return facts.inclusions[0].cells + facts.inclusions[1].cells > 0;
}

void warn_of_inclusions(const Facts& facts, std::vector<Warning>& warnings)
{
  for (std::size_t side = 0; side < 2; ++side)
  {
    const simulation::EmbeddedCells& found = facts.inclusions[side];
    const char* body = side == 0 ? "lower" : "upper";
    if (found.cells > 0 && found.least < 0.999 * fewest_cells_of_inclusion)
      warnings.push_back(
          {"coarse_inclusion",
           fmt::format(
               "inclusion {} of the {} body has {:.2g} cells along its smallest semi-axis, so that what it adds to "
               "the body is wrong by about {}, and the stress in it by more; at least {:g} are needed: use a finer "
               "grid.resolution or grid.spacing",
               found.coarsest + 1, body, found.least, percent_text(error_of_inclusion(found)),
               fewest_cells_of_inclusion)});
    if (found.at_rest > 1.0)
      warnings.push_back(
          {"yields_at_rest",
           fmt::format(
               "the {} body yields before any load, by the misfit of its inclusions: their stress at rest is {:.2g} "
               "times its yield stress or theirs, and would just reach it with {:.2g} times these misfits; the "
               "first increment has this flow, too, and what it dissipates",
               body, found.at_rest, 1.0 / found.at_rest)});
    if (found.voxel < 0.999)
      warnings.push_back(
          {"fine_voxels",
           fmt::format(
               "voxels of an inclusion of the {} body are {:.2g} times as large as the cells, each of which takes "
               "the voxel at its centre, so that most of them do not count: use a finer grid.resolution or "
               "grid.spacing, or coarser voxels",
               body, found.voxel)});
    if (found.cut > 0)
      warnings.push_back(
          {"cut_inclusion", fmt::format("{} of the {} body {} over the edge of the grid and {} computed up to there",
                                        found.cut == 1 ? "an inclusion" : fmt::format("{} inclusions", found.cut), body,
                                        found.cut == 1 ? "reaches" : "reach", found.cut == 1 ? "is" : "are")});
    if (found.beside > 0)
      warnings.push_back({"inclusion_beside_grid",
                          fmt::format("{} of a cluster of inclusions in the {} body {} beside the grid and {} left out",
                                      found.beside == 1 ? "a ball" : fmt::format("{} balls", found.beside), body,
                                      found.beside == 1 ? "lies" : "lie", found.beside == 1 ? "is" : "are")});
  }
}

} // namespace brinell::quality
