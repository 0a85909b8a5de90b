// SPDX-License-Identifier: BSD-3-Clause
#include "memory.hpp"

#include "brinell/foundation/share.hpp"
#include "brinell/halfspace/heat_response.hpp"
#include "brinell/halfspace/inclusions.hpp"
#include "brinell/simulation/forecast.hpp"
#include "elastoplastic/body/window.hpp"
#include "foundation/fft.hpp"
#include "foundation/lanes.hpp"
#include "halfspace/heat/images_of_heat.hpp"
#include "halfspace/strain/half_space_memory.hpp"
#include "halfspace/strain/stack_parts.hpp"
#include "heat.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::simulation
{

namespace
{

double field_bytes(const VolumeGrid& grid, double fields)
{
  return fields * sizeof(double) * static_cast<double>(grid.size());
}

/// The layers of the first of ranks that share a body: no other one has more.
VolumeGrid own_layers(VolumeGrid grid, int ranks)
{
  grid.nz = Share(0, ranks).count(grid.nz);
  return grid;
}

/// Values per cell in a checkpoint: plastic strain, its equivalent, stress, the guess of the next step, and back stresses.
double fields_of_state(const constitutive::Material& material)
{
  return 5.0 + 1.0 + 5.0 + 5.0 + 5.0 * static_cast<double>(material.kinematic.size());
}

/// Materials of the layers of cells of a body.
int materials_of(const VolumeGrid& grid, const constitutive::Material& material)
{
  return static_cast<int>(halfspace::stack_parts(grid, material.stack().merged()).size());
}

/// Kernels and transforms of a body, which bodies of the same cells and elastic constants share.
double operator_bytes(const VolumeGrid& grid, const constitutive::Material& material, int shears, int ranks)
{
  return material.elastic.is_rigid()
             ? 0.0
             : halfspace::memory_of_half_space(grid, shears, ranks, materials_of(grid, material)).operators;
}

/// A body that is solved, between increments.
double body_bytes(const VolumeGrid& grid, const constitutive::Material& material, int shears, int ranks)
{
  constexpr double fields_of_elastic_body = 6.0; // plastic strain and its equivalent, which are zero
  if (material.elastic.is_rigid())
    return 0.0;
  if (!material.is_plastic())
    return field_bytes(own_layers(grid, ranks), fields_of_elastic_body);
  constexpr double flags = 0.125;
  return halfspace::memory_of_half_space(grid, shears, ranks).work +
         field_bytes(own_layers(grid, ranks), fields_of_state(material) + flags);
}

/// How far the elastic pressure of smooth bodies is above that at first yield; of textured ones it is not known.
double over_yield(const Plan& plan)
{
  constexpr double unknown = 3.0;
  return plan.is_textured || plan.peak_over_yield == 0.0 ? unknown : plan.peak_over_yield;
}

/// The longest window of a body: its operators, the stress in it, and the changes of strain and stress. Its length follows from an
/// estimate: contact and flow of a step reach over about two thirds of the grid of the contact (measured).
double window_bytes(const Plan& plan, const VolumeGrid& grid, const constitutive::Material& material,
                    const elastoplastic::Settings& solver, int shears, int ranks)
{
  constexpr double of_contact = 0.65, begins_to_yield = 0.9;
  constexpr int elastic_steps = 2; // the steps before the first flow request no window
  const bool is_used = solver.shortcuts && solver.windows && material.is_plastic() && !grid.surface.is_periodic_x() &&
                       over_yield(plan) > begins_to_yield &&
                       plan.steps > elastic_steps + static_cast<int>(elastoplastic::requests_without_window);
  const auto window =
      elastoplastic::window_for(static_cast<int>(std::ceil(of_contact * plan.contact.nx)), grid.surface.nx);
  if (!is_used || !window)
    return 0.0;
  VolumeGrid part = grid;
  part.surface.nx = elastoplastic::length_of_window(*window, grid.surface.nx);
  constexpr double fields = 15.0;
  return halfspace::memory_of_half_space(part, shears, ranks, materials_of(part, material)).operators +
         field_bytes(own_layers(part, ranks), fields);
}

/// Share of the cells near yield, an estimate from measured runs: a plastic zone fills a smaller share of a volume than of a plane
/// section, and in a period little more than the material under peaks.
double share_near_yield(const VolumeGrid& grid, const Plan& plan)
{
  if (grid.surface.is_periodic())
    return std::min(0.15, 0.75 * plan.contact_share);
  const double over = over_yield(plan);
  if (is_plane(grid.surface))
    return 0.5 * std::clamp((over - 0.85) / 0.6, 0.0, 1.0) + 0.3 * std::clamp((over - 1.9) / 0.4, 0.0, 1.0);
  const double begun = std::clamp((over - 0.8) / 0.3, 0.0, 1.0);
  return begun * std::min(0.2, 0.05 + 0.06 * std::max(0.0, over - 1.0)); // most under a tip, where `over` is infinite
}

/// Memory of inclusions beside that of their body: work of its strain and of a dilatation, fields of both on the whole grid, and the unknowns
/// with their matrix, or with the vectors of their iteration and fields of the box in which it is done.
double embedding_bytes(const VolumeGrid& grid, const EmbeddedCells& inclusions, int shears, int ranks)
{
  constexpr double per_cell = 6.0, vectors = 24.0, fields = 14.0, of_dilatation = 1.3, most_of_box = 0.5;
  if (inclusions.cells == 0)
    return 0.0;
  const double own = inclusions.has_own_strain ? 6.0 : 0.0, strength = inclusions.has_own_strength ? 2.0 : 0.0;
  const halfspace::MemoryOfHalfSpace half_space = halfspace::memory_of_half_space(grid, shears, ranks);
  const double bodies = (1.0 + of_dilatation) * half_space.work + half_space.trace + field_bytes(grid, fields);
  const double unknowns = per_cell * static_cast<double>(inclusions.cells);
  const bool has_matrix = unknowns <= static_cast<double>(halfspace::Inclusions::most_of_matrix);
  return bodies + field_bytes(grid, own + strength) +
         (has_matrix ? unknowns * unknowns * sizeof(double)
                     : unknowns * vectors * sizeof(double) + most_of_box * inclusions.layers / grid.nz * bodies);
}

} // namespace

double active_cells(const VolumeGrid& grid, const elastoplastic::Settings& solver, const Plan& plan)
{
  const double computed = plan.contact.is_mirrored_y ? 0.5 : 1.0;
  return (solver.shortcuts ? share_near_yield(grid, plan) : computed) * static_cast<double>(grid.size());
}

bool has_deep_indents(const Plan& plan)
{
  constexpr double limit = 0.0101;
  return plan.scales.displacement <= limit * plan.scales.gap;
}

namespace
{

/// Active cells in an increment, with the history of the acceleration. Without short cuts all cells are active.
double trial_bytes(const VolumeGrid& grid, const constitutive::Material& material,
                   const elastoplastic::Settings& solver, const Plan& plan, int ranks)
{
  // Deep indents keep a longer history (docs/theory/elastoplastic.md, deep). Of them the scale is limited from below.
  const double more_history = has_deep_indents(plan) ? 4.0 : 1.0;
  const double values_per_cell = 5.0 * (3.0 * more_history * solver.anderson_depth + 11.0);
  return material.is_plastic() ? values_per_cell * sizeof(double) * active_cells(own_layers(grid, ranks), solver, plan)
                               : 0.0;
}

/// Output of a body. Its fields are computed and written one after the other; the stress needs the most memory. Ranks pass a row of
/// chunks at a time. A checkpoint is written and read field by field, or layer by layer.
double output_bytes(const VolumeGrid& grid, const constitutive::Material& material, int shears, int ranks)
{
  if (material.elastic.is_rigid())
    return 0.0;
  constexpr double chunk = 64.0, copies = 2.0; // cells along y and z
  const halfspace::MemoryOfHalfSpace half_space = halfspace::memory_of_half_space(grid, shears, ranks);
  const double work = material.is_plastic() ? 0.0 : half_space.work; // allocated only for the output
  const double row = std::min(chunk, 1.0 * grid.nz) * std::min(chunk, 1.0 * grid.surface.ny) * grid.surface.nx;
  const double passed = ranks > 1 ? copies * row * sizeof(double) : 0.0;
  const VolumeGrid own = own_layers(grid, ranks);
  return passed + std::max(field_bytes(own, 6.0) + work + half_space.trace, field_bytes(own, 12.0));
}

/// Heat in the steady regime: temperature and stress in each layer, as spectra, as the tables from which they are made, and
/// (measured) as much again in lattices that are summed; the spectra of mirror images, and what is kept beside them, are those of
/// one side. With two threads the peak varies by a quarter from run to run.
double steady_heat_bytes(const VolumeGrid& grid)
{
  constexpr double parts = 7.0;
  const double copies = grid.surface.is_mirrored_y ? 2.0 : 3.0;
  const PaddedLengths padded = padded_lengths(grid.surface);
  return parts * copies * grid.nz * padded.x * padded.y * sizeof(double);
}

/// The thermal grid: a third longer and wider than the material grid, except along periods.
SurfaceGrid grid_of_heat(const SurfaceGrid& body)
{
  const auto wider = [](int cells, bool is_periodic)
  { return is_periodic ? cells : cells + 2 * static_cast<int>(std::ceil(cells / 6.0)); };
  SurfaceGrid grid = body;
  grid.nx = wider(body.nx, body.is_periodic_x());
  grid.ny = wider(body.ny, body.is_periodic_y());
  return grid;
}

/// Heat in the transient regime: waves in depth on all lattices, and for a body that may yield the waves of fields while they are
/// evaluated, and the heat of plastic work that is expected and lacking.
double transient_heat_bytes(const VolumeGrid& volume, const constitutive::Material& material, bool of_plastic_work,
                            const elastoplastic::Settings& solver, const Plan& plan)
{
  constexpr double fields = 7.0, most_bytes_read = 5.0 * 1024 * 1024, expected_and_lacking = 3.0;
  const VolumeGrid grid{grid_of_heat(volume.surface), volume.nz, volume.dz};
  const bool is_rigid = material.elastic.is_rigid();
  const int layers = std::max(volume.nz, plan.layers);
  const double deepest = is_rigid ? -1.0 : (2.0 * layers - 0.5) * volume.dz;
  halfspace::WantedOfHeat wanted{
      deepest, solver.shortcuts ? halfspace::HeatImages::coarse : halfspace::HeatImages::fine,
      of_plastic_work ? halfspace::HeatedLayers{volume.nz, volume.dz} : halfspace::HeatedLayers{}};
  const ThermalStack stack = material.thermal_stack();
  if (!stack.is_homogeneous())
    wanted.coat = halfspace::CoatOfBody{stack};
  const double kept =
      halfspace::memory_of_heat(grid.surface, stack.slowest(), plan.heat_times, wanted, material.is_plastic());
  const PaddedLengths padded = padded_lengths(grid.surface);
  const double field = static_cast<double>(sizeof(double)) * padded.x * padded.y;
  const double read = material.is_plastic() ? std::min(most_bytes_read, fields * grid.nz * field) : 0.0;
  const double response = halfspace::memory_of_response(plan.contact, stack, plan.heat_times.shortest_step);
  return kept + read + response + field_bytes(grid, of_plastic_work ? expected_and_lacking : 0.0);
}

/// Heat of a body and, if it may yield, thermal stress now and before the increment, and softening.
double heat_bytes(const VolumeGrid& grid, const constitutive::Material& material, const elastoplastic::Settings& solver,
                  const Plan& plan, const elastoplastic::HeatSettings& heat)
{
  if (!material.thermal)
    return 0.0;
  const double fields = material.is_plastic() ? field_bytes(grid, material.softening ? 16.0 : 15.0) : 0.0;
  if (heat.regime == elastoplastic::HeatRegime::steady)
    return steady_heat_bytes(grid) + fields;
  const bool of_plastic_work = material.is_plastic() && heat.of_plastic_work > 0.0;
  return transient_heat_bytes(grid, material, of_plastic_work, solver, plan) + fields;
}

/// Fields and transforms of the contact solver, and fields of its results.
double contact_bytes(const SurfaceGrid& grid, int shears)
{
  constexpr double fields = 30.0, spectra = 4.0;
  const PaddedLengths padded = padded_lengths(grid);
  const double cells = fields * static_cast<double>(grid.size()) + spectra * padded.x * padded.y;
  return (1.0 + shears) * cells * sizeof(double);
}

} // namespace

double growth_of_line(double over_yield)
{
  return 1.0 + 0.35 * std::clamp((over_yield - 1.9) / 0.4, 0.0, 1.0);
}

double MemoryParts::total() const
{
  constexpr double program = 17e6; // with its libraries and the writers of files
  return program + growth * (contact + operators + bodies + windows + heat + std::max(trials, output));
}

MemoryParts memory_parts(const Plan& plan, const constitutive::Material& lower, const constitutive::Material& upper,
                         const elastoplastic::Settings& solver, int shears, const elastoplastic::HeatSettings* heat,
                         int ranks)
{
  const bool has_twin = plan.twin != elastoplastic::Twin::none; // then the upper body is a view of the lower one
  const bool shares_operators = has_twin || (plan.lower == plan.upper && lower.stack() == upper.stack());
  const bool is_line = is_plane(plan.contact) && (lower.is_plastic() || upper.is_plastic());
  MemoryParts parts{.growth = is_line && !plan.is_textured ? growth_of_line(plan.peak_over_yield) : 1.0,
                    .contact = contact_bytes(plan.contact, shears)};
  for (const auto& [grid, material] : {std::pair{&plan.lower, &lower}, {&plan.upper, &upper}})
  {
    if (!plan.surfaces_only)
      parts.output = std::max(parts.output, output_bytes(*grid, *material, shears, ranks));
    if (!plan.surfaces_only && (grid == &plan.lower || !shares_operators))
      parts.operators += operator_bytes(*grid, *material, shears, ranks);
    if (has_twin && grid == &plan.upper)
      continue;
    parts.bodies += body_bytes(*grid, *material, shears, ranks);
    parts.heat += heat ? heat_bytes(*grid, *material, solver, plan, *heat) : 0.0;
    parts.trials += trial_bytes(*grid, *material, solver, plan, ranks);
    const EmbeddedCells& inclusions = plan.inclusions[grid == &plan.lower ? 0 : 1];
    parts.bodies += embedding_bytes(*grid, inclusions, shears, ranks);
    if (inclusions.cells == 0)
      parts.windows += window_bytes(plan, *grid, *material, solver, shears, ranks);
  }
  return parts;
}

double memory_bytes(const Plan& plan, const constitutive::Material& lower, const constitutive::Material& upper,
                    const elastoplastic::Settings& solver, int shears, const elastoplastic::HeatSettings* heat,
                    int ranks)
{
  return memory_parts(plan, lower, upper, solver, shears, heat, ranks).total();
}

double bytes_sent_by_rank(const Plan& plan, int ranks)
{
  double bytes = 0.0;
  for (const VolumeGrid* grid : {&plan.lower, &plan.upper})
  {
    if (plan.surfaces_only || (plan.twin != elastoplastic::Twin::none && grid == &plan.upper))
      continue;
    // Five components of strain of the own layers, and of stress in the own blocks; a complex number per wavenumber and row.
    constexpr double components = 5.0, bytes_of_number = 16.0;
    const int wavenumbers = padded_lengths(grid->surface).x / 2 + 1;
    const int blocks = (wavenumbers + lane_count - 1) / lane_count;
    const int own_blocks = Share(0, ranks).blocks(blocks).count(), own_layers = Share(0, ranks).count(grid->nz);
    const double passed = 1.0 * own_layers * (blocks - own_blocks) + 1.0 * own_blocks * (grid->nz - own_layers);
    bytes += components * bytes_of_number * grid->surface.independent_rows() * lane_count * passed;
  }
  return bytes;
}

double unshared_memory(const Plan& plan, const PairCase& c)
{
  const MemoryParts parts =
      memory_parts(plan, c.lower.material, c.upper.material, c.solver, plan.shears, is_heated(c) ? &c.heat : nullptr);
  return parts.growth * (parts.contact + parts.heat);
}

double memory_of_rank(const Plan& plan, const PairCase& c, int ranks)
{
  return memory_bytes(plan, c.lower.material, c.upper.material, c.solver, plan.shears, is_heated(c) ? &c.heat : nullptr,
                      ranks);
}

} // namespace brinell::simulation
