// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/archive.hpp"
#include "brinell/green/elastic_stack.hpp"
#include "brinell/green/thermal_stack.hpp"
#include "brinell/halfspace/surface_load.hpp"
#include "brinell/halfspace/surface_temperature.hpp"

#include <vector>

namespace brinell::halfspace
{

/// Output spans for the fields at one depth: in each part one value per cell of the surface grid, at the centre of the cell; an
/// empty part is not computed.
struct ThermalLayer
{
  std::span<double> temperature{}; ///< rise [K]
  std::span<double> deviator{};    ///< of the stress [Pa], five components one after the other (order of Deviator)
  std::span<double> trace{};       ///< of the stress [Pa]
};

/// Accuracy to which the images of open axes are removed: fine, to about 1e-4 of the largest value or better; coarse, to about
/// 3e-4, with half of the memory and of the work.
enum class HeatImages
{
  fine,
  coarse
};

/// Layers from the surface down in which heat may be generated.
struct HeatedLayers
{
  int count = 0;          ///< 0: heat enters through the surface only
  double thickness = 0.0; ///< of each [m]
};

struct WantedOfHeat;

/// Fields in an elastic half space due to the heat that has entered its surface, step by step: displacement of the surface, and
/// temperature and stress in the body: docs/theory/heat.md (thermal-displacement, thermal-stress).
///
/// The memory of the heat is that of `SurfaceTemperature`. The surface is free of traction, and insulated outside the flux.
/// Displacement and stress follow the temperature quasi-statically, without inertia. Along open axes they are those of a half
/// space without images, to about 1e-3 of the largest value; if both axes are periodic, the mean strain along the surface is
/// zero, and the displacement is relative to a point deep in the body.
class ThermalField
{
public:
  /// @param grid    if it is mirrored, fluxes must move along x only; it halves memory and work
  /// @param depths  of the layers [m], >= 0, in any order
  /// @param heated  layers in which heat may be generated
  /// @throws InputError if a constant or a time is not above 0, a depth is below 0, or depths are given for a rigid body
  ThermalField(const SurfaceGrid& grid, const Thermal& thermal, const Elastic& elastic, const HeatTimes& times,
               std::vector<double> depths = {}, HeatImages images = HeatImages::fine, const HeatedLayers& heated = {});

  /// Of a coated body; no heat is generated in it. A homogeneous stack is a half space.
  /// @param elastic  with the layers of `thermal`
  /// @throws InputError also if the layers differ in number or thickness, or the substrate is rigid
  ThermalField(const SurfaceGrid& grid, const ThermalStack& thermal, const ElasticStack& elastic,
               const HeatTimes& times, std::vector<double> depths = {}, HeatImages images = HeatImages::fine);

  [[nodiscard]] const SurfaceGrid& grid() const;
  [[nodiscard]] const std::vector<double>& depths() const;
  [[nodiscard]] double time() const; ///< total duration of all steps so far [s]

  /// Adds a step: `SurfaceTemperature::add_step`.
  void add_step(std::span<const double> flux, const HeatMotion& motion);

  /// Adds more flux to the last step, with the same motion: the state becomes the one after a step with the sum of both fluxes.
  void add_to_last_step(std::span<const double> flux, const HeatMotion& motion);

  /// Adds heat that is generated in the body at a constant rate during the step that begins; heat generated earlier spreads
  /// during that step. To be called before `add_step` of the same step. `layers` and `displacement` include this heat at once as
  /// it is at the end of the step, for any duration passed to them; `remaining_temperature` does not include it.
  /// docs/theory/heat.md (buried)
  /// @param heat  [J/m^3] per cell, [layer][cell]; layers beyond the heated ones are stored in the thicker layers beneath
  void add_heat_in_body(std::span<const double> heat, double duration);
  /// Restores the state before the last `add_heat_in_body`.
  void restore_heat_in_body();
  /// Adds the temperature rise of the surface [K] due to the heat generated in the body, in its present state.
  void add_temperature_of_body(std::span<double> temperature) const;

  /// Memory of the flux, to be restored by `restore`.
  struct Heat;
  [[nodiscard]] Hidden<Heat> heat() const;
  /// Adds a step and moves the memory before the step into `before`, without a copy; buffers that `before` holds are reused.
  void add_step(std::span<const double> flux, const HeatMotion& motion, Hidden<Heat>& before);
  void restore(const Hidden<Heat>& heat);
  /// Everything that later steps depend on.
  void exchange(Archive& archive);

  /// Displacement at the end of the last step (duration 0), or the displacement that remains of all steps at the time `duration`
  /// later, without the heat that enters in between.
  /// @param duration  [s], 0 or >= HeatTimes::shortest_step
  void displacement(const SurfaceDisplacement& displacement, double duration = 0.0) const;
  /// Fields at one depth.
  /// @param layer     index into `depths`
  /// @param duration  as for `displacement`
  void layer(std::size_t layer, const ThermalLayer& out, double duration = 0.0) const;
  /// Fields in the layers `first`, `first + 1`, ..., at less cost than one by one. All elements of `out` must have the same
  /// parts.
  void layers(std::size_t first, std::span<const ThermalLayer> out, double duration = 0.0) const;
  /// Fields of a body at the end of the last step; its layers are those of `depths` from `first` on. Each component has
  /// all layers one after the other.
  /// @param body  its surface must be cells in the middle of the grid: `holds`
  void in_body(const VolumeGrid& body, const ThermalLayer& out, std::size_t first = 0) const;
  /// Whether the cells of another surface are cells of this grid, centred on its middle.
  [[nodiscard]] bool holds(const SurfaceGrid& cells) const;
  /// Temperature rise of the surface, at least one step later: `SurfaceTemperature::remaining`.
  void remaining_temperature(double duration, std::span<double> temperature) const;

private:
  void begin(const SurfaceGrid& grid, const ThermalStack& thermal, const ElasticStack& elastic, const HeatTimes& times,
             std::vector<double> depths, const WantedOfHeat& wanted);
  struct State;
  Hidden<State> state_;
};

} // namespace brinell::halfspace
