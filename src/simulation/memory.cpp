// SPDX-License-Identifier: BSD-3-Clause
#include "memory.hpp"

#include "foundation/fft.hpp"
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

/// One body that is computed, while nothing happens to it.
double body_bytes(const VolumeGrid& grid, const constitutive::Material& material, int shears)
{
  constexpr double of_elastic = 6.0; // plastic strain, which is zero
  if (material.elastic.is_rigid())
    return field_bytes(grid, of_elastic);
  const halfspace::MemoryOfHalfSpace half_space = halfspace::memory_of_half_space(grid, shears);
  if (!material.is_plastic())
    return half_space.operators + field_bytes(grid, of_elastic);
  constexpr double flags = 0.125;
  return half_space.operators + half_space.work + field_bytes(grid, fields_of_state(material) + flags);
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
double trial_bytes(const VolumeGrid& grid, const constitutive::Material& material, int anderson_depth,
                   double contact_share)
{
  const double active_share = is_plane(grid.surface) ? 0.5 : std::min(0.15, 0.75 * contact_share);
  const double of_unknowns = 5.0 * (3.0 * anderson_depth + 11.0);
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
/// made, and as much as one and a half of them, by measurement, in lattices of which those are summed.
double steady_heat_bytes(const VolumeGrid& grid)
{
  constexpr double parts = 7.0, copies = 3.5;
  const PaddedLengths padded = padded_lengths(grid.surface);
  return parts * copies * grid.nz * padded.x * padded.y * sizeof(double);
}

/// All heat since the start, on a grid a third longer and wider than that of the body: some sixty waves in depth, on lattices that
/// take together three and a half times the first one; all of it three times: as it is, for when an increment fails, and while
/// fields are read. With symmetry half of the waves are kept, and all of some fields. The heat of plastic work adds the layers of
/// the body and some fifteen beneath, likewise three times; on lattices that take off images at least two layers are one.
double transient_heat_bytes(const VolumeGrid& grid, bool of_plastic_work, Symmetry symmetry)
{
  const double layers = of_plastic_work ? grid.nz + 15.0 : 0.0;
  constexpr double waves = 60.0, lattices = 3.5, of_layers = 1.0 + 0.5 * (lattices - 1.0), copies = 3.0,
                   wider = 4.0 / 3.0;
  SurfaceGrid surface = grid.surface;
  surface.nx = static_cast<int>(surface.is_periodic_x() ? surface.nx : wider * surface.nx);
  surface.ny = static_cast<int>(surface.is_periodic_y() ? surface.ny : wider * surface.ny);
  const PaddedLengths padded = padded_lengths(surface);
  const double share = symmetry == Symmetry::none ? 1.0 : 0.6;
  const double spectra = waves * lattices + layers * of_layers;
  return share * spectra * copies * padded.x * padded.y * sizeof(double);
}

/// The heat of a body; and its stress, now and before, and softening.
double heat_bytes(const VolumeGrid& grid, const constitutive::Material& material, Symmetry symmetry,
                  const elastoplastic::HeatSettings& heat)
{
  if (!material.thermal)
    return 0.0;
  const double fields = field_bytes(grid, material.softening ? 16.0 : 15.0);
  if (heat.regime == elastoplastic::HeatRegime::steady)
    return steady_heat_bytes(grid) + fields;
  return transient_heat_bytes(grid, material.is_plastic() && heat.of_plastic_work > 0.0, symmetry) + fields;
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
                    int anderson_depth, int shears, const elastoplastic::HeatSettings* heat)
{
  constexpr double program = 17e6;                              // with its libraries
  const bool has_twin = plan.twin != elastoplastic::Twin::none; // then the upper body is a view of the lower one
  double bodies = 0.0, trials = 0.0, checkpoint = 0.0, output = 0.0;
  for (const auto& [grid, material] : {std::pair{&plan.lower, &lower}, {&plan.upper, &upper}})
  {
    output = std::max(output, output_bytes(*grid, *material, shears));
    if (has_twin && grid == &plan.upper)
      continue;
    bodies += body_bytes(*grid, *material, shears) + (heat ? heat_bytes(*grid, *material, plan.symmetry, *heat) : 0.0);
    trials += trial_bytes(*grid, *material, anderson_depth, plan.contact_share);
    bodies += window_bytes(plan, *grid, *material, shears);
    checkpoint += checkpoint_bytes(*grid, *material, shears);
  }
  constexpr double holes = 1.05; // between the fields
  return program + holes * (contact_bytes(plan.contact, shears) + bodies + std::max({trials, output, checkpoint}));
}

} // namespace brinell::simulation
