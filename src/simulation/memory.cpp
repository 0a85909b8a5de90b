// SPDX-License-Identifier: BSD-3-Clause
#include "memory.hpp"

#include "foundation/fft.hpp"
#include "halfspace/coarser_surface.hpp"
#include "halfspace/half_space_memory.hpp"

#include <algorithm>

namespace brinell::simulation
{

namespace
{

double field_bytes(const VolumeGrid& grid, double fields)
{
  return fields * sizeof(double) * static_cast<double>(grid.size());
}

/// The fields that a checkpoint holds: plastic strain, its equivalent, stress and the guess of the next step; back stresses.
double fields_of_state(const constitutive::Material& material)
{
  return 5.0 + 1.0 + 5.0 + 5.0 + 5.0 * static_cast<double>(material.kinematic.size());
}

/// Kernels and transforms of a body, which bodies of the same cells and elastic constants share.
double operator_bytes(const VolumeGrid& grid, const constitutive::Material& material, int shears)
{
  return material.elastic.is_rigid() ? 0.0 : halfspace::memory_of_half_space(grid, shears).operators;
}

/// One body that is computed, while nothing happens to it.
double body_bytes(const VolumeGrid& grid, const constitutive::Material& material, int shears)
{
  constexpr double of_elastic = 6.0; // plastic strain, which is zero
  if (!material.is_plastic())
    return field_bytes(grid, of_elastic);
  constexpr double flags = 0.125;
  return halfspace::memory_of_half_space(grid, shears).work + field_bytes(grid, fields_of_state(material) + flags);
}

/// Of a body much longer than the contact, the columns of it that are computed within an increment: operators of two lengths, strain
/// and stress of the longer one, now and before.
double window_bytes(const Plan& plan, const VolumeGrid& grid, const constitutive::Material& material, int shears)
{
  constexpr int few_steps = 100; // before a window pays it must have been asked for many times
  if (!material.is_plastic() || grid.surface.is_periodic_x() || 2 * plan.contact.nx > grid.surface.nx ||
      plan.steps < few_steps)
    return 0.0;
  double bytes = 0.0;
  VolumeGrid part = grid;
  for (const double share : {0.25, 0.375})
  {
    part.surface.nx = static_cast<int>(share * grid.surface.nx);
    bytes += halfspace::memory_of_half_space(part, shears).operators;
  }
  return bytes + field_bytes(part, 20.0);
}

/// What the cells in the fixed point take in an increment, with the history of the accelerator. Their number is not known
/// before: a plastic zone fills less of a box than of its section, and of a period little more than what lies under peaks.
/// Without short cuts they are all that is computed.
double trial_bytes(const VolumeGrid& grid, const constitutive::Material& material,
                   const elastoplastic::Settings& solver, const Plan& plan)
{
  const double computed = plan.symmetry == Symmetry::none ? 1.0 : 0.5;
  const double near_yield = is_plane(grid.surface) ? 0.5 : std::min(0.15, 0.75 * plan.contact_share);
  const double active_share = solver.shortcuts ? near_yield : computed;
  const double of_unknowns = 5.0 * (3.0 * solver.anderson_depth + 11.0);
  return material.is_plastic() ? field_bytes(grid, active_share * of_unknowns) : 0.0;
}

/// The fields within a body are computed and written one after the other: the stress takes most.
double output_bytes(const VolumeGrid& grid, const constitutive::Material& material, int shears)
{
  if (material.elastic.is_rigid())
    return 0.0;
  const halfspace::MemoryOfHalfSpace half_space = halfspace::memory_of_half_space(grid, shears);
  const double work = material.is_plastic() ? 0.0 : half_space.work; // for the time being
  return std::max(field_bytes(grid, 6.0) + work + half_space.trace, field_bytes(grid, 12.0));
}

/// The checkpoint from which a run is taken up, before there is any work. It is written without a copy in memory.
double checkpoint_bytes(const VolumeGrid& grid, const constitutive::Material& material, int shears)
{
  if (!material.is_plastic())
    return 0.0;
  const double state = field_bytes(grid, fields_of_state(material));
  return std::max(0.0, state - halfspace::memory_of_half_space(grid, shears).work);
}

/// Waves of a flux that has always moved: temperature and stress in each layer, as spectra and as the tables of which they are
/// made, and as much again, by measurement, in lattices of which those are summed. With two threads the most that is held at a time
/// differs by a quarter from run to run.
double steady_heat_bytes(const VolumeGrid& grid)
{
  constexpr double parts = 7.0, copies = 3.0;
  const PaddedLengths padded = padded_lengths(grid.surface);
  return parts * copies * grid.nz * padded.x * padded.y * sizeof(double);
}

/// A third longer and wider than the body, but along periods.
SurfaceGrid grid_of_heat(const SurfaceGrid& body)
{
  constexpr double wider = 4.0 / 3.0;
  SurfaceGrid grid = body;
  grid.nx = static_cast<int>(body.is_periodic_x() ? body.nx : wider * body.nx);
  grid.ny = static_cast<int>(body.is_periodic_y() ? body.ny : wider * body.ny);
  return grid;
}

/// All spectra of heat over those of its first lattice. Images are taken off on some three pairs of lattices of the slower waves, one
/// of a pair as large as the first one and one a quarter; with short cuts, half as long along an open axis of many cells.
double lattices_of_heat(const SurfaceGrid& grid, bool shortcuts)
{
  constexpr double pairs = 2.0; // of as many waves as the first lattice has
  double share = grid.is_periodic() ? 0.0 : 1.0;
  for (const auto& [cells, is_periodic] : {std::pair{grid.nx, grid.is_periodic_x()}, {grid.ny, grid.is_periodic_y()}})
    share *= shortcuts && !is_periodic && halfspace::is_long(cells) ? 0.5 : 1.0;
  return 1.0 + 1.25 * pairs * share;
}

/// All heat since the start, some sixty waves in depth, as it is and as it was for when an increment fails; and the waves of fields
/// while they are read, of a body that may yield. With symmetry half of the waves are kept. The heat of plastic work adds the layers of the body
/// and some fifteen beneath: how warm they are, and what makes them so, now and before; on lattices that take off images at least
/// two layers are one, with short cuts.
double transient_heat_bytes(const VolumeGrid& volume, const constitutive::Material& material, bool of_plastic_work,
                            bool shortcuts, Symmetry symmetry)
{
  constexpr double waves = 60.0, copies = 2.0, copies_of_layers = 3.0, fields = 7.0,
                   most_bytes_read = 5.0 * 1024 * 1024, expected_and_lacking = 3.0;
  const VolumeGrid grid{grid_of_heat(volume.surface), volume.nz, volume.dz};
  const double lattices = lattices_of_heat(grid.surface, shortcuts),
               of_layers = 1.0 + (shortcuts ? 0.5 : 1.0) * (lattices - 1.0);
  const double layers = of_plastic_work ? grid.nz + 15.0 : 0.0;
  const PaddedLengths padded = padded_lengths(grid.surface);
  const double field = (symmetry == Symmetry::none ? 1.0 : 0.5) * sizeof(double) * padded.x * padded.y;
  const double kept = waves * lattices * copies + layers * of_layers * copies_of_layers;
  const double read = material.is_plastic() ? std::min(most_bytes_read, fields * grid.nz * field) : 0.0;
  return kept * field + read + field_bytes(grid, of_plastic_work ? expected_and_lacking : 0.0);
}

/// The heat of a body; and, if it may yield, its stress, now and before, and softening.
double heat_bytes(const VolumeGrid& grid, const constitutive::Material& material, const elastoplastic::Settings& solver,
                  Symmetry symmetry, const elastoplastic::HeatSettings& heat)
{
  if (!material.thermal)
    return 0.0;
  const double fields = material.is_plastic() ? field_bytes(grid, material.softening ? 16.0 : 15.0) : 0.0;
  if (heat.regime == elastoplastic::HeatRegime::steady)
    return steady_heat_bytes(grid) + fields;
  const bool of_plastic_work = material.is_plastic() && heat.of_plastic_work > 0.0;
  return transient_heat_bytes(grid, material, of_plastic_work, solver.shortcuts, symmetry) + fields;
}

/// Fields of the contact's solver and of what is read from it, and its transforms.
double contact_bytes(const SurfaceGrid& grid, int shears)
{
  constexpr double fields = 30.0, spectra = 4.0;
  const PaddedLengths padded = padded_lengths(grid);
  const double cells = fields * static_cast<double>(grid.size()) + spectra * padded.x * padded.y;
  return (1.0 + shears) * cells * sizeof(double);
}

} // namespace

double memory_bytes(const Plan& plan, const constitutive::Material& lower, const constitutive::Material& upper,
                    const elastoplastic::Settings& solver, int shears, const elastoplastic::HeatSettings* heat)
{
  constexpr double program = 22e6;                              // with its libraries, and what writes the files
  const bool has_twin = plan.twin != elastoplastic::Twin::none; // then the upper body is a view of the lower one
  const bool shares_operators = has_twin || (plan.lower == plan.upper && lower.elastic == upper.elastic);
  double bodies = 0.0, trials = 0.0, checkpoint = 0.0, output = 0.0;
  for (const auto& [grid, material] : {std::pair{&plan.lower, &lower}, {&plan.upper, &upper}})
  {
    output = std::max(output, output_bytes(*grid, *material, shears));
    if (grid == &plan.lower || !shares_operators)
      bodies += operator_bytes(*grid, *material, shears);
    if (has_twin && grid == &plan.upper)
      continue;
    bodies += body_bytes(*grid, *material, shears) +
              (heat ? heat_bytes(*grid, *material, solver, plan.symmetry, *heat) : 0.0);
    trials += trial_bytes(*grid, *material, solver, plan);
    bodies += window_bytes(plan, *grid, *material, shears);
    checkpoint += checkpoint_bytes(*grid, *material, shears);
  }
  constexpr double holes = 1.05; // between the fields
  return program + holes * (contact_bytes(plan.contact, shears) + bodies + std::max({trials, output, checkpoint}));
}

} // namespace brinell::simulation
